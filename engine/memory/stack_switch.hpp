// From one stack to another and back: what lets a job stop in the middle of a call and go on there later.
//
// The language has no word for it, so it is assembly, for ELF targets alone: x86-64, i386, aarch64, arm (but ARMv6-M),
// riscv32 and riscv64, ppc64le, s390x. Elsewhere, as on WebAssembly, can_switch_stacks() is false and nothing is built.
#pragma once
#include <cstddef>

// Callee-saved registers stay with the stack on which they are saved; nothing else does, such as rounding modes.
extern "C" {
// Goes on where `to` was left by one of these two; what was running is left as *from.
void netmesh_switch_stack(void** from, void* to);
// Begins entry(argument) on a stack that ends at `top`, 16-byte aligned. entry never returns.
void netmesh_enter_stack(void** from, void* top, void (*entry)(void*), void* argument);
}

namespace netmesh {

// False also where a shadow stack is in use, which would have to be switched too.
bool can_switch_stacks();

// AddressSanitizer is told which stack is in use; without it these do nothing. `leave`: before a switch to the stack
// [low, low + bytes), with a place for what it keeps of this one, null when this one ends. `arrive`: after it, with
// what was kept of the stack that goes on, null when it begins; tells the stack that was left where that is not null.
void leave_stack(void** kept, const void* low, std::size_t bytes);
void arrive_on_stack(void* kept, const void** left_low, std::size_t* left_bytes);

}  // namespace netmesh
