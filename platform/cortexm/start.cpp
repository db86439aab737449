// From reset to run(): vector table, floating-point unit, memory, stack paint, semihosting. No library.
#include "board.hpp"

extern "C" {
extern std::uint32_t stack_bottom[], stack_top[], data_begin[], data_end[], data_image[], bss_begin[], bss_end[];
void reset();
}

namespace {

constexpr std::uint32_t paint = 0xA5C35A3Cu;

std::uint32_t semihost(std::uint32_t operation, const void* argument) {
    register std::uint32_t r0 asm("r0") = operation;
    register const void* r1 asm("r1") = argument;
    asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

// `frame`: what the processor pushed, R0-R3, R12, LR, PC, PSR.
extern "C" __attribute__((used)) void report_fault(const std::uint32_t* frame) {
    char text[] = "FAULT: processor exception at 00000000\n";
    for (int i = 0; i < 8; ++i)
        text[sizeof text - 3 - static_cast<unsigned>(i)] = "0123456789abcdef"[frame[6] >> 4 * i & 15];
    board::write(text);
    board::stop(3);
}

__attribute__((naked)) void fault() { asm volatile("mov r0, sp\n b report_fault"); }

using Handler = void (*)();
struct Vectors {
    std::uint32_t* stack;
    Handler handlers[15];
};

__attribute__((section(".vectors"), used)) const Vectors vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};

std::uint32_t* stack_pointer() {
    std::uint32_t* p;
    asm volatile("mov %0, sp" : "=r"(p));
    return p;
}

}  // namespace

namespace board {

void write(const char* text) { semihost(0x04, text); }

void stop(int exit_code) {
    const std::uint32_t reason[2] = {0x20026, static_cast<std::uint32_t>(exit_code)};
    semihost(0x20, reason);
    for (;;) {
    }
}

std::uint32_t centiseconds() { return semihost(0x10, nullptr); }

void paint_stack() {
    for (volatile std::uint32_t *p = stack_bottom, *end = stack_pointer() - 16; p < end; ++p) *p = paint;
}

std::size_t stack_used() {
    const volatile std::uint32_t* p = stack_bottom;
    while (p < stack_top && *p == paint) ++p;
    return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(stack_top) - reinterpret_cast<std::uintptr_t>(p));
}

std::size_t stack_bytes() {
    return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(stack_top) -
                                    reinterpret_cast<std::uintptr_t>(stack_bottom));
}

}  // namespace board

extern "C" __attribute__((noreturn)) void reset() {
#ifdef __ARM_FP
    volatile std::uint32_t* const coprocessor_access = reinterpret_cast<volatile std::uint32_t*>(0xE000ED88u);
    *coprocessor_access |= 0xFu << 20;
    asm volatile("dsb\n isb" ::: "memory");
#endif
    for (std::uint32_t *to = data_begin, *from = data_image; to < data_end;) *to++ = *from++;
    for (volatile std::uint32_t* p = bss_begin; p < bss_end; ++p) *p = 0;
    board::paint_stack();
    board::stop(run());
}
