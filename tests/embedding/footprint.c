/* What a job takes: JOB on POINTS points in R^DIM of a KIND, uniform if that is not said, in a block of the harness's
 * (footprint_host.c, footprint_board.cpp). With REPORT it returns the peak bytes of the block; without, it holds no
 * more than a program needs that has the job and reads its result. */
#include "netmesh.h"

enum { NOTHING, DELAUNAY, ALPHA, CERTIFIED, BY_RATIO, RIPS };
/* In units of .01; a grid of tenths, each with the rounding of its own; a circle, or in space two skew lines, where
 * cells are as many as can be. */
enum { UNIFORM, ROUNDED, TENTHS, WORST };
#ifndef KIND
#define KIND 0
#endif

/* Makes the points; not a part of what is measured. */
void footprint_draw(void);
uint64_t footprint_job(void* block, size_t block_bytes);

static double points[POINTS * DIM];
#if REPORT
static netmesh_report report;
#endif

void footprint_draw(void) {
    uint64_t state = 17;
    size_t i, k, side = 1;
    while ((DIM == 2 ? side * side : side * side * side) < POINTS) ++side;
    for (i = 0; i < sizeof points / sizeof points[0]; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 33) / 2147483648.0;
        if (KIND == ROUNDED) points[i] = (double)(int)(points[i] * 100) / 100;
    }
    for (i = 0; KIND >= TENTHS && i < POINTS; ++i) {
        const double t = 2 * (double)i / POINTS - 1;
        size_t rest = i;
        for (k = 0; k < DIM; ++k) {
            points[i * DIM + k] = KIND == TENTHS ? (double)(rest % side) * .1 : 0;
            rest /= side;
        }
        if (KIND == TENTHS) continue;
        if (DIM == 2) {
            points[i * DIM] = (i % 2 == 0 ? 1 : -1) * (1 - t * t) / (1 + t * t);
            points[i * DIM + 1] = 2 * t / (1 + t * t);
        } else {
            points[i * DIM + i % 2] = t;
            points[i * DIM + 2] = (double)(i % 2);
        }
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
