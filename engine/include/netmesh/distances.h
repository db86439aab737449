/* Persistent homology of data that is known by its distances: Vietoris-Rips complexes. The diagram is read by the calls
 * of persistence.h. */
#ifndef NETMESH_DISTANCES_H
#define NETMESH_DISTANCES_H

#include <stddef.h>
#include <stdint.h>

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How distances of n points are handed over. */
typedef enum netmesh_distance_layout {
    NETMESH_DISTANCES_FULL = 0,     /* numbers[n][n], symmetric, 0 on the diagonal */
    NETMESH_DISTANCES_LOWER = 1,    /* numbers[n (n - 1) / 2], rows of the lower triangle: (1,0), (2,0), (2,1), .. */
    NETMESH_DISTANCES_SPARSE = 2,   /* entries[]; points of which no entry tells are never joined */
    NETMESH_DISTANCES_FUNCTION = 3, /* evaluate(user, i, j) for j < i */
    NETMESH_DISTANCES_COUNT
} NETMESH_AN_INT netmesh_distance_layout;

/* The distance of i and j, which may stand in either order, and in both if the numbers are equal. */
typedef struct netmesh_distance_entry {
    uint32_t i, j;
    double distance;
} netmesh_distance_entry;

/* The distance of points i and j < i; must not throw, and must give the same number whenever it is called. With
 * max_degree 1 or more each is asked for once, row by row: (1,0), (2,0), (2,1), .. */
typedef double (*netmesh_distance_function)(void* user, uint32_t i, uint32_t j);

/* Distances are >= 0 and need not be a metric; infinity: never joined. */
typedef struct netmesh_distances_request {
    uint32_t struct_bytes;
    netmesh_distance_layout layout;
    netmesh_monitor monitor;
    const double* numbers;                 /* of FULL and LOWER. Neither these nor entries are read by the plan */
    const netmesh_distance_entry* entries; /* of SPARSE */
    uint64_t entry_count;                  /* of SPARSE, below 2^31 */
    netmesh_distance_function evaluate;    /* of FUNCTION */
    void* user;                            /* handed to it */
    uint64_t point_count;                  /* 1 .. 65,536; with max_degree 0, but of SPARSE, to NETMESH_POINTS_MAX */
    double threshold;         /* a radius as all values are: points farther apart than twice that are not joined. >= 0;
                                 init: infinity */
    uint32_t max_degree;      /* at most 30; init: 1 */
    uint32_t keep_zero_pairs; /* 1: pairs of zero length are kept */
    uint32_t representatives; /* 1: keep a cycle for each pair (netmesh_get_cycle) */
} netmesh_distances_request;

void netmesh_distances_request_init(netmesh_distances_request* request, size_t request_bytes);

/* As netmesh_plan_points, as if all points were joined; of SPARSE no more edges than entries. */
size_t netmesh_plan_distances(const netmesh_distances_request* request);

/* Persistent homology over Z/2 in degrees 0..max_degree of the flag complexes in which points are joined within a
 * distance. Values are radii, half of distances (rounded to nearest, which makes a difference below 2^-1022 alone), as
 * netmesh_persist_points has them with RIPS. The complex ends at the threshold, where what lives on is essential, or
 * where one point is joined to all others: it is a cone from there on, and nothing is born any more. With max_degree 0
 * nothing is built but a tree. Points at distance 0 stay two points. The report's filter is RIPS, and its dimension 0.
 * Replaces what the context held, also on failure.
 * INVALID_ARGUMENT, of field NUMBERS at row index_a and column index_b, of field ENTRIES at entry index_a: a distance
 * is negative or NaN, differs from the one the other way round, or is not 0 for a point and itself; MAX_DEGREE: more
 * simplices than 62 bits can number. OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_distances(netmesh_context* context, const netmesh_distances_request* request);

#ifdef __cplusplus
}
#endif
#endif
