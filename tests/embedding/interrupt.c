/* A stop that a signal handler asks for. The handler may do next to nothing; it sets a flag of the one type that is
 * allowed, and the engine's poll looks at it. */
#include <netmesh.h>
#include <signal.h>
#include <stdio.h>

#define POINTS 20000
#define BLOCK_BYTES ((size_t)64 << 20)

static double points[2 * POINTS];
static uint64_t memory[BLOCK_BYTES / 8 + 2];
static volatile sig_atomic_t stop_wanted;

static void on_signal(int number) {
    (void)number;
    stop_wanted = 1;
}

static int poll(void* user, const netmesh_progress* progress) {
    int* polls = user;
    if (++*polls == 600) raise(SIGINT); /* so that this program needs no one at the keyboard */
    (void)progress;
    return stop_wanted;
}

int main(void) {
    const uintptr_t at = (uintptr_t)memory;
    uint64_t state = 1;
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_check_request check = {sizeof check, 0, {NULL, NULL}, NULL};
    int i, polls = 0;
    for (i = 0; i < 2 * POINTS; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 40);
    }
    signal(SIGINT, on_signal);
    if (netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, BLOCK_BYTES, &context) != NETMESH_OK) return 1;
    request.points.coordinates = points;
    request.points.count = POINTS;
    request.points.dim = 2;
    request.mesh.method = &netmesh_method_svr;
    request.monitor.poll = poll;
    request.monitor.user = &polls;
    if (netmesh_mesh(context, &request) != NETMESH_CANCELLED) return 2;
    if (polls != 600) return 3;
    stop_wanted = 0;
    check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_DELAUNAY;
    if (netmesh_check(context, &check) != NETMESH_OK) return 4;
    printf("%s, and what is held is a Delaunay triangulation\n", netmesh_status_text(NETMESH_CANCELLED));
    return 0;
}
