/* The board of example.c and windows.c, in whose place you have your own: a Cortex-M in qemu. On any other machine
 * there is an ordinary program, without a clock. Who includes this has program(), and defines before it
 *
 *   STACK_BYTES          of the stack that program() and interrupts run on, a multiple of 8
 *   TICK_INSTRUCTIONS    where on_tick() is to be called, how often: a multiple of 40, at most 671 millions. On another
 *                        machine time passes while the program waits for a tick, and then alone */
#ifndef NETMESH_EXAMPLE_H
#define NETMESH_EXAMPLE_H

#include <stdint.h>

/* 0: all is well. Not a part of reset, which must not save floating-point registers before it has switched their unit
 * on. */
__attribute__((noinline)) static int program(void);
#if defined TICK_INSTRUCTIONS
static void on_tick(void);
#endif

#if defined __arm__

extern uint32_t stack_bottom[], stack_top[], data_begin[], data_end[], data_image[], bss_begin[], bss_end[];
void reset(void);
void fault(void);

enum { PAINT = 0x5AC35A3C };

__attribute__((section(".bss.stack"), used)) static uint64_t stack[(STACK_BYTES) / 8];

/* Semihosting: a debugger or qemu answers. */
static void semihost(uint32_t operation, const void* argument) {
    register uint32_t r0 __asm__("r0") = operation;
    register const void* r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

static inline void say(const char* text) { semihost(0x04, text); }

static void stop(uint32_t code) {
    const uint32_t reason[2] = {0x20026, code};
    semihost(0x20, reason);
}

/* SysTick, at most 24 bits, and a count of its wraps. On a board it counts cycles, here instructions: qemu -icount
 * shift=0 lets every instruction that the processor executes, in the compiler's routines for doubles too, take 1 ns of
 * a clock of 25 MHz. So a count is 40 instructions, and what is counted is right but for two of them. */
enum { INSTRUCTIONS_PER_COUNT = 40 };
#if defined TICK_INSTRUCTIONS
enum { COUNTS_PER_WRAP = TICK_INSTRUCTIONS / INSTRUCTIONS_PER_COUNT };
#else
enum { COUNTS_PER_WRAP = 1 << 24 };
#endif
static volatile uint32_t* const systick = (volatile uint32_t*)0xE000E010u; /* control, reload, current */
static volatile uint32_t wraps;
void tick(void);
void tick(void) {
    ++wraps;
#if defined TICK_INSTRUCTIONS
    on_tick();
#endif
}

static void clock_start(void) {
    systick[1] = COUNTS_PER_WRAP - 1;
    systick[2] = 0;
    systick[0] = 7;
    while (systick[2] == 0) {
    }
}
static inline uint64_t clock_now(void) {
    uint32_t before, count;
    do {
        before = wraps;
        count = systick[2];
        __asm__ volatile("isb" ::: "memory"); /* an interrupt that is due comes now */
    } while (before != wraps);
    return (uint64_t)before * COUNTS_PER_WRAP + (COUNTS_PER_WRAP - count) % COUNTS_PER_WRAP; /* a wrap begins at 0 */
}
static inline uint32_t instructions_between(uint64_t earlier, uint64_t later) {
    return (uint32_t)((later - earlier) * INSTRUCTIONS_PER_COUNT);
}
#if defined TICK_INSTRUCTIONS
static inline void wait_for_tick(void) { __asm__ volatile("wfi" ::: "memory"); }
#endif

/* The stack is filled with a pattern before anything runs; what is left of it was never touched. */
static void paint_stack(void) {
    uint32_t* end;
    volatile uint32_t* p;
    __asm__ volatile("mov %0, sp" : "=r"(end));
    for (p = stack_bottom; p < end - 16; ++p) *p = PAINT;
}
static inline uint32_t stack_used(void) { /* bytes from its top, the deepest so far */
    const volatile uint32_t* p = stack_bottom;
    while (p < stack_top && *p == PAINT) ++p;
    return (uint32_t)((uintptr_t)stack_top - (uintptr_t)p);
}
static inline uint32_t stack_size(void) { return sizeof stack; }

void fault(void) {
    say("FAULT\n"); /* the stack lies at the bottom of the RAM: where it overflows, this is where it ends */
    stop(3);
    for (;;) {
    }
}

void reset(void) {
    uint32_t *to, *from;
    for (to = data_begin, from = data_image; to < data_end;) *to++ = *from++;
    for (to = bss_begin; to < bss_end;) *to++ = 0;
#ifdef __ARM_FP
    *(volatile uint32_t*)0xE000ED88u |= 0xFu << 20; /* the floating-point unit */
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    paint_stack();
    clock_start();
    stop((uint32_t)program());
    for (;;) {
    }
}

typedef void (*handler)(void);
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t* stack;
    handler handlers[15];
} vectors = {stack_top, {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, tick}};

#else /* any other machine */

#include <stdio.h>
static inline void say(const char* text) { fputs(text, stdout); }
static inline uint64_t clock_now(void) { return 0; }
static inline uint32_t instructions_between(uint64_t earlier, uint64_t later) { return (uint32_t)(later - earlier); }
static inline uint32_t stack_used(void) { return 0; }
static inline uint32_t stack_size(void) { return 0; }
#if defined TICK_INSTRUCTIONS
static inline void wait_for_tick(void) { on_tick(); }
#endif
int main(void) { return program(); }

#endif

static inline void say_number(const char* before, uint32_t n, const char* after) {
    char digits[11];
    int at = 10;
    digits[at] = 0;
    do digits[--at] = (char)('0' + n % 10);
    while ((n /= 10) != 0);
    say(before);
    say(digits + at);
    say(after);
}

#endif
