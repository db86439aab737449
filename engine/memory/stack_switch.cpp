#include "memory/stack_switch.hpp"

// For each processor three macros of the assembler. save: what its procedure call standard has a callee keep goes on
// the stack, the stack pointer to *from, and `to` or `top` becomes the stack. restore: the reverse, and return. enter:
// calls entry with argument, on a stack that begins with zero for a return address and a frame, where walks along
// frames end.
#if !defined(__ELF__)
#define NETMESH_NO_STACK_SWITCH
#elif defined(__x86_64__) && !defined(__ILP32__)
__asm__(R"(
.macro netmesh_save
    pushq %rbp
    pushq %rbx
    pushq %r12
    pushq %r13
    pushq %r14
    pushq %r15
    movq %rsp, (%rdi)
    movq %rsi, %rsp
.endm
.macro netmesh_restore
    popq %r15
    popq %r14
    popq %r13
    popq %r12
    popq %rbx
    popq %rbp
    ret
.endm
.macro netmesh_enter
    xorl %ebp, %ebp
    movq %rcx, %rdi
    pushq $0
    jmp *%rdx
.endm
)");
#elif defined(__i386__)
__asm__(R"(
.macro netmesh_save
    movl 4(%esp), %eax
    movl 8(%esp), %ecx
    movl 12(%esp), %edx
    pushl %ebp
    pushl %ebx
    pushl %esi
    pushl %edi
    movl 32(%esp), %esi
    movl %esp, (%eax)
    movl %ecx, %esp
.endm
.macro netmesh_restore
    popl %edi
    popl %esi
    popl %ebx
    popl %ebp
    ret
.endm
.macro netmesh_enter
    xorl %ebp, %ebp
    subl $12, %esp
    pushl %esi
    pushl $0
    jmp *%edx
.endm
)");
#elif defined(__aarch64__)
__asm__(R"(
.macro netmesh_each operation
    \operation d8, d9, [sp]
    \operation d10, d11, [sp, 16]
    \operation d12, d13, [sp, 32]
    \operation d14, d15, [sp, 48]
    \operation x19, x20, [sp, 64]
    \operation x21, x22, [sp, 80]
    \operation x23, x24, [sp, 96]
    \operation x25, x26, [sp, 112]
    \operation x27, x28, [sp, 128]
    \operation x29, x30, [sp, 144]
.endm
.macro netmesh_save
    sub sp, sp, 160
    netmesh_each stp
    mov x9, sp
    str x9, [x0]
    mov sp, x1
.endm
.macro netmesh_restore
    netmesh_each ldp
    add sp, sp, 160
    ret
.endm
.macro netmesh_enter
    mov x29, 0
    mov x30, 0
    mov x16, x2
    mov x0, x3
    br x16
.endm
)");
#elif defined(__arm__) && (!defined(__thumb__) || defined(__thumb2__))
#if defined(__ARM_FP)
__asm__(R"(
.macro netmesh_floats operation
    \operation {d8-d15}
.endm
)");
#else
__asm__(R"(
.macro netmesh_floats operation
.endm
)");
#endif
// ARMv8-M faults where the stack pointer in use goes below its limit, which a system sets for each of its stacks. The
// limit is kept with the rest; a stack that begins has none. Without privilege it reads as 0 and keeps its value.
#if defined(__ARM_ARCH_8M_MAIN__) || defined(__ARM_ARCH_8_1M_MAIN__)
__asm__(R"(
.macro netmesh_set_limit
    mrs r5, control
    tst r5, 2
    ite eq
    msreq msplim, r4
    msrne psplim, r4
.endm
.macro netmesh_save_limit
    mrs r5, control
    tst r5, 2
    ite eq
    mrseq r4, msplim
    mrsne r4, psplim
    push {r4, r5}
    movs r4, 0
    netmesh_set_limit
.endm
.macro netmesh_restore_limit
    pop {r4, r5}
    netmesh_set_limit
.endm
)");
#else
__asm__(R"(
.macro netmesh_save_limit
.endm
.macro netmesh_restore_limit
.endm
)");
#endif
__asm__(R"(
.syntax unified
.macro netmesh_save
    push {r3-r11, lr}
    netmesh_floats vpush
    netmesh_save_limit
    str sp, [r0]
    mov sp, r1
.endm
.macro netmesh_restore
    netmesh_restore_limit
    netmesh_floats vpop
    pop {r3-r11, pc}
.endm
.macro netmesh_enter
    mov r11, 0
    mov lr, 0
    mov r0, r3
    bx r2
.endm
)");
#elif defined(__riscv)
#if __riscv_xlen == 64
__asm__(R"(
.macro netmesh_word operation, name, slot
    \operation\()d \name, 8*\slot(sp)
.endm
)");
#else
__asm__(R"(
.macro netmesh_word operation, name, slot
    \operation\()w \name, 4*\slot(sp)
.endm
)");
#endif
#if defined(__riscv_float_abi_double)
__asm__(R"(
.macro netmesh_float operation, name, slot
    f\operation\()d \name, 112+8*\slot(sp)
.endm
)");
#elif defined(__riscv_float_abi_single)
__asm__(R"(
.macro netmesh_float operation, name, slot
    f\operation\()w \name, 112+8*\slot(sp)
.endm
)");
#else
__asm__(R"(
.macro netmesh_float operation, name, slot
.endm
)");
#endif
__asm__(R"(
.macro netmesh_each operation
    netmesh_word \operation, ra, 12
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11
    netmesh_word \operation, s\n, \n
    netmesh_float \operation, fs\n, \n
    .endr
.endm
.macro netmesh_save
    addi sp, sp, -208
    netmesh_each s
    netmesh_keep
    mv sp, a1
.endm
.macro netmesh_restore
    netmesh_each l
    addi sp, sp, 208
    ret
.endm
.macro netmesh_enter
    li s0, 0
    li ra, 0
    mv a0, a3
    jr a2
.endm
)");
#if __riscv_xlen == 64
__asm__(R"(
.macro netmesh_keep
    sd sp, 0(a0)
.endm
)");
#else
__asm__(R"(
.macro netmesh_keep
    sw sp, 0(a0)
.endm
)");
#endif
#elif defined(__powerpc64__) && defined(_CALL_ELF) && _CALL_ELF == 2
#if defined(__ALTIVEC__)
__asm__(R"(
.macro netmesh_vectors operation
    .irp n, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
    li 0, 16*(\n-20)+320
    \operation \n, 1, 0
    .endr
.endm
)");
#else
__asm__(R"(
.macro netmesh_vectors operation
.endm
)");
#endif
__asm__(R"(
.macro netmesh_each word, float
    .irp n, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
    \word \n, 8*(\n-14)+32(1)
    \float \n, 8*(\n-14)+176(1)
    .endr
.endm
.macro netmesh_save
    mflr 0
    std 0, 16(1)
    mfcr 0
    stw 0, 8(1)
    stdu 1, -512(1)
    netmesh_each std, stfd
    netmesh_vectors stvx
    std 1, 0(3)
    mr 1, 4
.endm
.macro netmesh_restore
    netmesh_each ld, lfd
    netmesh_vectors lvx
    addi 1, 1, 512
    lwz 0, 8(1)
    mtcr 0
    ld 0, 16(1)
    mtlr 0
    blr
.endm
.macro netmesh_enter
    addi 1, 1, -112
    li 0, 0
    std 0, 0(1)
    mtlr 0
    mr 12, 5
    mr 3, 6
    mtctr 12
    bctr
.endm
)");
#elif defined(__s390x__)
__asm__(R"(
.macro netmesh_save
    stmg %r6, %r15, 48(%r15)
    aghi %r15, -64
    .irp n, 8, 9, 10, 11, 12, 13, 14, 15
    std %f\n, 8*(\n-8)(%r15)
    .endr
    stg %r15, 0(%r2)
    lgr %r15, %r3
.endm
.macro netmesh_restore
    .irp n, 8, 9, 10, 11, 12, 13, 14, 15
    ld %f\n, 8*(\n-8)(%r15)
    .endr
    aghi %r15, 64
    lmg %r6, %r14, 48(%r15)
    br %r14
.endm
.macro netmesh_enter
    aghi %r15, -160
    xc 0(8,%r15), 0(%r15)
    lghi %r14, 0
    lgr %r2, %r5
    br %r4
.endm
)");
#else
#define NETMESH_NO_STACK_SWITCH
#endif

#if !defined(NETMESH_NO_STACK_SWITCH)
#if defined(__thumb__)
__asm__(R"(
.macro netmesh_begin name
    .thumb_func
.endm
)");
#else
__asm__(R"(
.macro netmesh_begin name
.endm
)");
#endif
// Global for builds that optimise when linking, hidden for all others.
__asm__(R"(
.pushsection .text.netmesh_switch_stack, "ax", %progbits
.irp name, netmesh_switch_stack, netmesh_enter_stack
    .globl \name
    .hidden \name
    .type \name, %function
.endr
.balign 16
netmesh_begin netmesh_switch_stack
netmesh_switch_stack:
    netmesh_save
    netmesh_restore
.size netmesh_switch_stack, .-netmesh_switch_stack
.balign 16
netmesh_begin netmesh_enter_stack
netmesh_enter_stack:
    netmesh_save
    netmesh_enter
.size netmesh_enter_stack, .-netmesh_enter_stack
.popsection
.purgem netmesh_save
.purgem netmesh_restore
.purgem netmesh_enter
.purgem netmesh_begin
)");
#else
extern "C" {
void netmesh_switch_stack(void**, void*) {}
void netmesh_enter_stack(void**, void*, void (*)(void*), void*) {}
}
#endif

#if defined(__SANITIZE_ADDRESS__)
#define NETMESH_TELL_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define NETMESH_TELL_SANITIZER
#endif
#endif
#if defined(NETMESH_TELL_SANITIZER)
extern "C" {
void __sanitizer_start_switch_fiber(void** kept, const void* low, std::size_t bytes);
void __sanitizer_finish_switch_fiber(void* kept, const void** left_low, std::size_t* left_bytes);
}
#endif

namespace netmesh {

bool can_switch_stacks() {
#if defined(NETMESH_NO_STACK_SWITCH)
    return false;
#elif defined(__x86_64__) && defined(__CET__)
    // A processor without shadow stacks leaves the register as it is.
    unsigned long long shadow = 0;
    __asm__ volatile("rdsspq %0" : "+r"(shadow));
    return shadow == 0;
#else
    return true;
#endif
}

void leave_stack(void** kept, const void* low, std::size_t bytes) {
#if defined(NETMESH_TELL_SANITIZER)
    __sanitizer_start_switch_fiber(kept, low, bytes);
#else
    static_cast<void>(kept), static_cast<void>(low), static_cast<void>(bytes);
#endif
}

void arrive_on_stack(void* kept, const void** left_low, std::size_t* left_bytes) {
#if defined(NETMESH_TELL_SANITIZER)
    __sanitizer_finish_switch_fiber(kept, left_low, left_bytes);
#else
    static_cast<void>(kept), static_cast<void>(left_low), static_cast<void>(left_bytes);
#endif
}

}  // namespace netmesh

#undef NETMESH_NO_STACK_SWITCH
#undef NETMESH_TELL_SANITIZER
