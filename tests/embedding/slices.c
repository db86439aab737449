/* A job in slices between a program's other work, without threads or an operating system: a task that makes all its
 * calls one after the other runs on a stack of its own, and is left whenever its time is up. The result is that of an
 * undivided run. */
#include <netmesh.h>
#include <stdio.h>

#define POINTS 2000
#define BLOCK_BYTES ((size_t)16 << 20)

static double points[2 * POINTS];
static uint64_t memory[BLOCK_BYTES / 8 + 2];
/* 1 KiB more for the functions below. */
static uint64_t stack[(NETMESH_STACK_BYTES(2) + 1024) / 8];

struct work {
    netmesh_job* job;        /* null: undivided */
    unsigned polls_in_slice; /* how often it is asked whether its time is up; a device would read its clock */
    uint64_t fingerprint;
};

static int time_is_up(void* user, const netmesh_progress* progress) {
    struct work* const work = user;
    (void)progress;
    if (++work->polls_in_slice < 10) return 0;
    work->polls_in_slice = 0;
    return netmesh_pause(work->job);
}

static netmesh_status run(void* user) {
    struct work* const work = user;
    const uintptr_t at = (uintptr_t)memory;
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_report report;
    netmesh_status status = netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, BLOCK_BYTES, &context);
    request.points.coordinates = points;
    request.points.count = POINTS;
    request.points.dim = 2;
    request.filter = &netmesh_filter_complete;
    request.monitor.poll = time_is_up;
    request.monitor.user = work;
    if (status == NETMESH_OK) status = netmesh_persist(context, &request);
    report.struct_bytes = sizeof report;
    if (status == NETMESH_OK) status = netmesh_get_report(context, &report);
    if (status == NETMESH_OK) work->fingerprint = report.fingerprint;
    return status;
}

int main(void) {
    struct work undivided = {NULL, 0, 0}, sliced = {NULL, 0, 0}, given_up = {NULL, 0, 0};
    netmesh_status status;
    uint64_t state = 1;
    unsigned slices = 1;
    int i;
    for (i = 0; i < 2 * POINTS; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 40);
    }
    if (run(&undivided) != NETMESH_OK) return 1;

    if (netmesh_job_init(stack, sizeof stack, run, &sliced, &sliced.job) != NETMESH_OK) return 1;
    while ((status = netmesh_resume(sliced.job)) == NETMESH_PAUSED) ++slices; /* the program's other work stands here */
    printf("%u slices, %u bytes of stack\n", slices, (unsigned)netmesh_stack_used(sliced.job));
    if (status != NETMESH_OK || slices < 3 || sliced.fingerprint != undivided.fingerprint) return 1;

    /* What is no longer wanted is ended at a pause. */
    if (netmesh_job_init(stack, sizeof stack, run, &given_up, &given_up.job) != NETMESH_OK) return 1;
    if (netmesh_resume(given_up.job) != NETMESH_PAUSED) return 1;
    return netmesh_cancel(given_up.job) == NETMESH_CANCELLED && netmesh_job_ended(given_up.job) ? 0 : 1;
}
