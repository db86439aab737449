/* Jobs in slices: calls that stop in the middle and go on later, without threads or an operating system.
 *
 * A job is a function of yours that makes any calls of this library. It runs on a stack of its own, so it can be left
 * at any poll and taken up again there; between two slices the program does what it wants, as long as the processor
 * rounds to nearest again when the next one begins. Results are those of an undivided run, byte for byte.
 *
 *     static netmesh_status work(void* user) {
 *         struct work* const w = user;
 *         ...
 *         request.monitor.poll = netmesh_poll_pause;
 *         request.monitor.user = w->job;
 *         status = netmesh_mesh(w->context, &request);
 *         ...
 *         return status;
 *     }
 *
 *     netmesh_job_init(stack, sizeof stack, work, &w, &w.job);
 *     while ((status = netmesh_resume(w.job)) == NETMESH_PAUSED) other_work();
 */
#ifndef NETMESH_JOB_H
#define NETMESH_JOB_H

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a stack needs for the calls of this library in dimension dim, and for complexes that have none with 2: the
 * deepest chain of any of them takes less in a program that g++ optimises (archive.stack). Add what your own functions
 * on it take, the job's and those that requests name, printf among them; and what signals or interrupts take that run
 * on the stack in use. There is room for NETMESH_STACK_BYTES_JOB in it. */
#define NETMESH_STACK_BYTES(dim) ((size_t)((dim) <= 4 ? 16384 : 32768) + 1024)

/* Of single jobs: the deepest chain of calls that the compiler can see, exact arithmetic for the hardest input
 * included, whatever the points are. The same has to be added; and NETMESH_STACK_BYTES_JOB for the stack of
 * netmesh_job_init.
 *
 *   DELAUNAY    netmesh_mesh by the methods delaunay and delaunay_small, without weights
 *   ALPHA       netmesh_persist by the filters alpha and alpha_small, without weights and periods
 *   CERTIFIED   netmesh_mesh and netmesh_persist by filters on meshes but scales, without wants
 *   RIPS        netmesh_persist by the filters rips and cech, of points and of distances
 *   RIPS_SMALL  netmesh_persist by the filter rips_small, of points and of distances
 *
 * each with netmesh_init, plans and calls that read results. They hold with 32-bit pointers for a Cortex-M0, M3, M4, M7
 * or M33, g++ -Os, a library of the dimension dim alone; those of 3 for all of a library of 2 and 3. And with 64-bit
 * pointers for x86-64, g++ -O3, a library of all dimensions. tests/stack and archive.jobs see to both. Of what else you
 * build or ask for, measure (netmesh_stack_used) or take NETMESH_STACK_BYTES. */
#define NETMESH_STACK_BYTES_JOB ((size_t)(UINTPTR_MAX > 0xFFFFFFFFu ? 1024 : 512))
/* figures: stack */
/* clang-format off */
#if UINTPTR_MAX > 0xFFFFFFFFu
#define NETMESH_STACK_BYTES_DELAUNAY(dim) \
    ((size_t)((dim) == 2 ? 6976 : (dim) == 3 ? 9472 : (dim) == 4 ? 9472 : \
              (dim) == 5 ? 9600 : (dim) == 6 ? 9728 : NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_ALPHA(dim) \
    ((size_t)((dim) == 2 ? 7488 : (dim) == 3 ? 9856 : (dim) == 4 ? 9856 : \
              (dim) == 5 ? 9984 : (dim) == 6 ? 10048 : NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_CERTIFIED(dim) \
    ((size_t)((dim) == 2 ? 12224 : (dim) == 3 ? 12736 : (dim) == 4 ? 12800 : \
              (dim) == 5 ? 12864 : (dim) == 6 ? 12928 : NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_RIPS(dim) \
    ((size_t)((dim) == 2 ? 8896 : (dim) == 3 ? 11264 : (dim) == 4 ? 6272 : \
              (dim) == 5 ? 6272 : (dim) == 6 ? 6272 : NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_RIPS_SMALL(dim) \
    ((size_t)((dim) == 2 ? 6272 : (dim) == 3 ? 6272 : (dim) == 4 ? 6272 : \
              (dim) == 5 ? 6272 : (dim) == 6 ? 6272 : NETMESH_STACK_BYTES(dim)))
#else
#define NETMESH_STACK_BYTES_DELAUNAY(dim) \
    ((size_t)((dim) == 2 ? 3200 : (dim) == 3 ? 3840 : (dim) == 4 ? 4608 : \
              NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_ALPHA(dim) \
    ((size_t)((dim) == 2 ? 3584 : (dim) == 3 ? 4224 : (dim) == 4 ? 4928 : \
              NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_CERTIFIED(dim) \
    ((size_t)((dim) == 2 ? 6208 : (dim) == 3 ? 7616 : (dim) == 4 ? 9088 : \
              NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_RIPS(dim) \
    ((size_t)((dim) == 2 ? 4416 : (dim) == 3 ? 5056 : (dim) == 4 ? 3904 : \
              NETMESH_STACK_BYTES(dim)))
#define NETMESH_STACK_BYTES_RIPS_SMALL(dim) \
    ((size_t)((dim) == 2 ? 3904 : (dim) == 3 ? 3904 : (dim) == 4 ? 3904 : \
              NETMESH_STACK_BYTES(dim)))
#endif
/* clang-format on */
/* end */

typedef struct netmesh_job netmesh_job;

/* The function that a job runs, and what netmesh_resume returns when it has ended; must not throw. */
typedef netmesh_status (*netmesh_task)(void* user);

/* Makes a job of task(user) on stack[0, stack_bytes), which is the job's alone until it ends and may not be moved.
 * Nothing runs yet. Costs O(stack_bytes). While it pauses its contexts are its alone, too. On ARMv8-M the limit of the
 * stack in use (MSPLIM, PSPLIM) is none while the job runs; a thread without privilege, or a system that sets limits
 * itself whenever it switches, needs the job's stack above that of its thread. Threads of a system need no job: one
 * with as much stack as the call takes is enough, and a poll can wait or cancel.
 * INVALID_ARGUMENT (a null pointer), OUT_OF_MEMORY (less than NETMESH_STACK_BYTES_MIN), NOT_BUILT: there is no way to
 * switch stacks on this processor (WebAssembly, ARMv6-M), or a shadow stack is in use. */
#define NETMESH_STACK_BYTES_MIN 2048
netmesh_status netmesh_job_init(void* stack, size_t stack_bytes, netmesh_task task, void* user, netmesh_job** job);

/* Begins the job, or goes on with it where it paused, until it pauses again, NETMESH_PAUSED, or ends: what its task
 * returned. Any thread may call it, one at a time. Costs some ten instructions, and what the job does.
 * INVALID_ARGUMENT: no job, or one that runs or has ended. STACK_OVERFLOW: the stack was too small, as its lowest bytes
 * have been written to; the job has ended, and memory below the stack may have been written to. Large frames can step
 * over these bytes, so not every overflow is seen: give NETMESH_STACK_BYTES, and what your own functions take. */
netmesh_status netmesh_resume(netmesh_job* job);

/* Ends a job that has paused: netmesh_pause returns 1 from now on, at which a poll cancels the call that is on its way.
 * Returns when the task has ended, with what it returned; of a job that never began NETMESH_CANCELLED. What contexts
 * hold then is what a call that is cancelled leaves. A job may be dropped without this, but its contexts have to be
 * made anew. Errors as of netmesh_resume. */
netmesh_status netmesh_cancel(netmesh_job* job);

/* To be called by the job, mostly in a poll: leaves it there; netmesh_resume returns NETMESH_PAUSED. Returns when the
 * job is resumed: 0, or 1 when it is to end. Outside of the job that is given it does nothing and returns 0. */
int netmesh_pause(netmesh_job* job);

/* A poll for requests, its user the job: pauses each time. */
int netmesh_poll_pause(void* job, const netmesh_progress* progress);

/* Has the job ended? */
int netmesh_job_ended(const netmesh_job* job);

/* The most bytes of the stack that were in use so far. Costs O(stack_bytes). */
size_t netmesh_stack_used(const netmesh_job* job);

#ifdef __cplusplus
}
#endif
#endif
