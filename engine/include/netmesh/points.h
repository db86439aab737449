/* What a diagram is of: points, distances, or simplices. */
#ifndef NETMESH_POINTS_H
#define NETMESH_POINTS_H

#include <stddef.h>
#include <stdint.h>

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Points where the caller has them. They are read once and turned into doubles exactly: results are those of the same
 * numbers in doubles, byte for byte. Equal points are merged into the first of them and counted.
 *
 *   coordinates   row i begins i * stride_bytes behind it and has dim numbers of `format`. Any finite number; -0.0
 *                 counts as 0. Aligned to its numbers. What lies between rows is not read. A plan reads no coordinate
 *   count         1 .. NETMESH_POINTS_MAX
 *   dim           D: 2..6; with the filter rips to NETMESH_RIPS_DIM_MAX. 0: there are no points
 *   stride_bytes  from one row to the next. 0: rows are packed. Else at least a row and a multiple of what a number is
 *                 aligned to: 4 for floats, 8 for doubles (4 on 32-bit x86). All rows fill at most half of the address
 *                 space
 *   weights       null: none. Else a number of `format` for each row, with request.weighting, which says what they are.
 *                 Any finite numbers, radii >= 0. Of equal points the first of those with the largest weight stays
 *   weight_stride_bytes
 *                 from one weight to the next. 0: they are packed. Else as the stride of rows of one number
 *   lattice       null: none. Else lattice_count vectors of dim doubles each, packed, with request.periods: the points
 *                 repeat by all sums of whole multiples of them. Finite, linearly independent, of either orientation,
 *                 aligned to a double
 *   lattice_count 1 .. D; fewer than D: the other directions have no period */
typedef struct netmesh_points {
    const void* coordinates;
    size_t count;
    uint32_t dim;
    netmesh_point_format format;
    size_t stride_bytes;
    const void* weights;
    size_t weight_stride_bytes;
    const double* lattice;
    uint32_t lattice_count;
} netmesh_points;

#define NETMESH_RIPS_DIM_MAX 65536 /* coordinates of a point that rips takes */

/* How distances of n points are handed over. */
typedef enum netmesh_distance_layout {
    NETMESH_DISTANCES_FULL = 0,     /* numbers[n][n], symmetric, 0 on the diagonal */
    NETMESH_DISTANCES_LOWER = 1,    /* numbers[n (n - 1) / 2], rows of the lower triangle: (1,0), (2,0), (2,1), .. */
    NETMESH_DISTANCES_SPARSE = 2,   /* entries[]; points of which no entry tells are never joined */
    NETMESH_DISTANCES_FUNCTION = 3, /* evaluate(user, i, j) for j < i */
    NETMESH_DISTANCES_COUNT
} NETMESH_AN_INT netmesh_distance_layout;

/* The distance of points i and j, in either order. Both orders may be listed when their numbers are equal. */
typedef struct netmesh_distance_entry {
    uint32_t i, j;
    double distance;
} netmesh_distance_entry;

/* The distance of points i and j < i. It must not throw, and must give the same number whenever it is called. With
 * max_degree 1 or more each is asked for once, row by row: (1,0), (2,0), (2,1), .. */
typedef double (*netmesh_distance_function)(void* user, uint32_t i, uint32_t j);

/* Data that is known by its distances, for the filter rips. A distance is >= 0 or infinity, which is never joined. They
 * need not be a metric. Values of the diagram are radii: half of distances. The report's dim is 0.
 *   complex   ends at the threshold, where what lives on is essential; or where one point is joined to all others, as
 *             nothing is born after that. Points at distance 0 stay two points
 *   cost      with max_degree 0 and no cycles only a tree is built
 *   errors    INVALID_ARGUMENT: a distance is negative or NaN, is not the one in the other order, or is not 0 from a
 *             point to itself (NUMBERS: row index_a, column index_b; ENTRIES: entry index_a); more simplices than 62
 *             bits can number (MAX_DEGREE) */
typedef struct netmesh_distances {
    uint32_t struct_bytes;
    netmesh_distance_layout layout;
    const double* numbers;                 /* of FULL and LOWER; not read by a plan */
    const netmesh_distance_entry* entries; /* of SPARSE; not read by a plan */
    uint64_t entry_count;                  /* of SPARSE, below 2^31 */
    netmesh_distance_function evaluate;    /* of FUNCTION */
    void* user;                            /* handed to it; null without it */
    uint64_t count;                        /* points, 1 .. 65,536; of SPARSE 1 .. 2^26; of the others with max_degree 0
                                              and without cycles to NETMESH_POINTS_MAX */
} netmesh_distances;

/* A filtered simplicial complex (6.2). Simplex i has the vertices vertices[starts[i] .. starts[i + 1]), at most 32
 * distinct labels in any order, and enters at entries[i], a finite number. Simplices come in any order. Every face is
 * listed and enters no later than the simplex.
 *
 * For vines (6.3) `entries` holds step_count vectors, one after the other. A vector has a value for every simplex, in
 * their order. With by_vertex it has a value for every simplex of one vertex, in their order, and the other simplices
 * enter with the last of their vertices (lower stars), which is always a filtration.
 *   errors    NOT_FINITE (simplex index_a, detail.step), NOT_A_COMPLEX (detail.fault; FACE_LATER at detail.step) */
typedef struct netmesh_simplices {
    uint32_t struct_bytes;
    uint32_t by_vertex;       /* 1: values of vertices; with step_count */
    const uint32_t* vertices; /* [starts[simplex_count]] */
    const uint64_t* starts;   /* [simplex_count + 1] */
    const double* entries;    /* [simplex_count]; with step_count [step_count][values] */
    uint64_t simplex_count;   /* >= 1 */
    uint64_t vertex_count;    /* length of vertices[]; no vertex beyond it is read. 0: starts[simplex_count], and no
                                 plan, which reads this number alone */
    uint64_t step_count;      /* 0: one filtration. Else 1 .. 2^32 - 2, with request.vines */
} netmesh_simplices;

#ifdef __cplusplus
}
#endif
#endif
