/* What a context holds, in arrays: for languages that a call for each item is too dear for. Nothing but calls of
 * netmesh.h; every array may be null. The first call that is refused ends the reading, and its status is returned. */
#ifndef NETMESH_ARRAYS_H
#define NETMESH_ARRAYS_H

#include "netmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The first `count` vertices: coordinates[count][dim], markers[count], values[count]. */
netmesh_status netmesh_array_vertices(const netmesh_context* context, uint32_t dim, uint64_t count, double* coordinates,
                                      uint8_t* markers, double* values);

/* The first `count` cells: vertices[count][dim + 1], neighbours[count][dim + 1]. */
netmesh_status netmesh_array_cells(const netmesh_context* context, uint32_t dim, uint64_t count, uint32_t* vertices,
                                   uint32_t* neighbours);

/* The first `count` cages: centres[count], parents[count], radii[count]. */
netmesh_status netmesh_array_cages(const netmesh_context* context, uint64_t count, uint32_t* centres, uint32_t* parents,
                                   double* radii);

/* The first `count` pairs: intervals[count][2], birth and death; degrees[count]. */
netmesh_status netmesh_array_pairs(const netmesh_context* context, uint64_t count, double* intervals,
                                   uint32_t* degrees);

/* Bounds of the first `count` bars: intervals[count][5], birth_low, birth_high, death_low, death_high, certain_after;
 * certain[count]. */
netmesh_status netmesh_array_bounds(const netmesh_context* context, uint64_t count, double* intervals,
                                    uint8_t* certain);

/* The first `count` steps of the certified ratio: steps[count][6], from, low, high, reach, ratio, error. */
netmesh_status netmesh_array_steps(const netmesh_context* context, uint64_t count, double* steps);

/* Where the simplices of each pair's cycle begin, starts[count + 1]. */
netmesh_status netmesh_array_cycle_starts(const netmesh_context* context, uint64_t count, uint64_t* starts);

/* The cycle of pair `pair`, of that degree: vertices[count][degree + 1], values[count]. */
netmesh_status netmesh_array_cycle(const netmesh_context* context, uint64_t pair, uint32_t degree, uint64_t count,
                                   uint32_t* vertices, double* values);

/* With periods, how many of each vector of the lattice take its vertices' points there: translations[count][degree + 1]
 * [axes], all those of a simplex's first vertex 0. */
netmesh_status netmesh_array_cycle_translations(const netmesh_context* context, uint64_t pair, uint32_t degree,
                                                uint64_t count, uint32_t axes, int32_t* translations);

/* The first `count` points of vines: vines, degrees and ks [count], intervals[count][2]. */
netmesh_status netmesh_array_vines(const netmesh_context* context, uint64_t count, uint32_t* vines, uint32_t* degrees,
                                   uint32_t* ks, double* intervals);

/* Points in the order of the tree, their rows and the boxes of nodes, as netmesh_split has made them. */
typedef struct netmesh_point_arrays {
    const double* points;
    const uint32_t* rows;
    const double* boxes;
    uint32_t dim;
} netmesh_point_arrays;
/* The functions of a source that reads these, which must outlive it. */
netmesh_status netmesh_array_source(netmesh_point_arrays* arrays, netmesh_source* source);

#ifdef __cplusplus
}
#endif
#endif
