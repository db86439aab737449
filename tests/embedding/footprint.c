/* What a job takes: JOB on POINTS uniform points in R^DIM, in a block of the harness's (footprint_host.c,
 * footprint_board.cpp). With REPORT it returns the peak bytes of the block; without, it holds no more than a program
 * needs that has the job and reads its result. */
#include "netmesh.h"

enum { NOTHING, DELAUNAY, ALPHA, CERTIFIED, BY_RATIO, RIPS };

uint64_t footprint_job(void* block, size_t block_bytes);

static double points[POINTS * DIM];
#if REPORT
static netmesh_report report;
#endif

static void draw_points(void) {
    uint64_t state = 17;
    size_t i;
    for (i = 0; i < sizeof points / sizeof points[0]; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 33) / 2147483648.0;
    }
}

__attribute__((noinline)) static netmesh_status work(netmesh_context* context) {
#if JOB == 0
    return context == NULL ? NETMESH_OK : NETMESH_INTERNAL;
#else
    netmesh_request request = netmesh_default_request();
    request.points.coordinates = points;
    request.points.count = POINTS;
    request.points.dim = DIM;
#if JOB == 1
#if DIM == 2
    request.mesh.method = &netmesh_method_delaunay_small;
#else
    request.mesh.method = &netmesh_method_delaunay;
#endif
    return netmesh_mesh(context, &request);
#elif JOB == 2
    request.filter = &netmesh_filter_alpha_small;
#elif JOB == 3
    request.filter = &netmesh_filter_complete;
    request.mesh.method = &netmesh_method_svr;
#elif JOB == 4
    request.filter = &netmesh_filter_complete;
    request.goal.ratio = 2.25;
#else
    request.filter = &netmesh_filter_rips_small;
#endif
    return netmesh_persist(context, &request);
#endif
}

/* 0: it failed. */
uint64_t footprint_job(void* block, size_t block_bytes) {
    netmesh_context* context = NULL;
    uint64_t count = 0;
    draw_points();
#if JOB != 0
    if (netmesh_init(block, block_bytes, &context) != NETMESH_OK) return 0;
#endif
    if (work(context) != NETMESH_OK) return 0;
#if JOB == 1
    {
        netmesh_cell cell;
        cell.struct_bytes = sizeof cell;
        while (netmesh_get_cell(context, count, &cell) == NETMESH_OK) ++count;
    }
#elif JOB != 0
    {
        netmesh_pair pair;
        pair.struct_bytes = sizeof pair;
        while (netmesh_get_pair(context, count, &pair) == NETMESH_OK) ++count;
    }
#endif
#if REPORT
    report.struct_bytes = sizeof report;
    if (count == 0 || netmesh_get_report(context, &report) != NETMESH_OK) return 0;
    return report.memory.peak_bytes;
#else
    return count + block_bytes;
#endif
}
