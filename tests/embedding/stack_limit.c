/* A job on a processor with limits of stacks (ARMv8-M): its stack below and above the one that resumes it, whose limit
 * is set; main stack and process stack. Each overflow of either is a fault. */
#include <netmesh.h>

#define STACK_BYTES 4096
static int program(void);
#include "example.h"

enum { WORDS = 512 };
static uint64_t stacks[3][WORDS]; /* of a job, of the process, of a job */
static netmesh_job* job;

static netmesh_status count(void* user) {
    int* const n = (int*)user;
    for (*n = 0; *n < 5; ++*n)
        if (netmesh_poll_pause(job, 0) != 0) return NETMESH_CANCELLED;
    return NETMESH_OK;
}

static uint32_t limit(void) {
    uint32_t control, main_stack, process;
    __asm__ volatile("mrs %0, control\n mrs %1, msplim\n mrs %2, psplim"
                     : "=r"(control), "=r"(main_stack), "=r"(process));
    return (control & 2) != 0 ? process : main_stack;
}

static void run_job(uint64_t* memory, const char* name) {
    int n = -1, pauses = 0;
    const uint32_t before = limit();
    netmesh_status status = netmesh_job_init(memory, sizeof stacks[0], count, &n, &job);
    while (status == NETMESH_OK && (status = netmesh_resume(job)) == NETMESH_PAUSED) {
        ++pauses;
        if (limit() != before) stop(4);
        status = NETMESH_OK;
    }
    say(name);
    say(status == NETMESH_OK && n == 5 && pauses == 5 && limit() == before ? ": right\n" : ": WRONG\n");
}

static void run_process(void) {
    run_job(stacks[0], "process stack, job below");
    run_job(stacks[2], "process stack, job above");
    stop(0);
}

static int program(void) {
    __asm__ volatile("msr msplim, %0" ::"r"(stack_bottom));
    run_job(stacks[2], "main stack, job above");
    __asm__ volatile(
        "msr psplim, %0\n msr psp, %1\n mrs r0, control\n orr r0, #2\n msr control, r0\n isb\n bx %2" ::"r"(stacks[1]),
        "r"(stacks[2]), "r"(run_process)
        : "r0");
    return 1;
}
