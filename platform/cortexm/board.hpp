// What a program on the board can ask of the machine, by semihosting, and of its own stack.
#pragma once
#include <cstddef>
#include <cstdint>

namespace board {

void write(const char* text);
[[noreturn]] void stop(int exit_code);
// Hundredths of a second of the host that emulates the board.
std::uint32_t centiseconds();

// Fills the free part of the stack with a pattern; stack_used tells how deep the stack has been since, in bytes from
// its top. stack_bytes is what the linker script sets aside.
void paint_stack();
std::size_t stack_used();
std::size_t stack_bytes();

}  // namespace board

// The program; its result is the exit code.
int run();
