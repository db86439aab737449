/* Persistent homology without one mesh: scale by scale, of complexes of points, of any filtered complex and of a
 * sequence of its filtrations. Diagrams and vines are read by the calls of persistence.h. */
#ifndef NETMESH_COMPLEXES_H
#define NETMESH_COMPLEXES_H

#include <stddef.h>
#include <stdint.h>

#include "persistence.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Persistent homology of points scale by scale (7.6): recursively well-paced subsets, one mesh for each in the same
 * memory, their diagrams joined. With eps, over-refined meshes and the tight filter; with ratio, meshes refined by the
 * certificate and the complete filter. An over-refined mesh has 10^4 vertices a point and more in R^4: give a ratio. */
typedef struct netmesh_scales_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points; /* [point_count][D]. Not read by the plan */
    size_t point_count; /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;      /* of every random choice; init: 1 */
    double tau;         /* as of netmesh_mesh_request */
    double eps;         /* accuracy of each scale's diagram, in (0, 1/2]; 0: 1/2, or none where ratio is given */
    double theta;       /* mediality that keeps points in one scale, in (0, 1/9]; 0: 1/9 */
    netmesh_values values;
    uint32_t max_degree;      /* as of netmesh_persist_request; init: NETMESH_DIM_MAX */
    uint32_t keep_zero_pairs; /* likewise */
    double ratio;             /* of the joined diagram, with certified values; above (1 + 3 theta) times the root of 2,
                                 and finite; 0: as eps says. Not both */
    uint32_t bounds;          /* 1: the bounds of netmesh_bound_bars too, by scale */
    uint32_t representatives; /* 1: keep a cycle for each pair of some length (netmesh_get_cycle), of points */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_scales_request;

void netmesh_scales_request_init(netmesh_scales_request* request, size_t request_bytes, uint32_t dim);

/* As netmesh_plan_delaunay, all points of one scale. */
size_t netmesh_plan_scales(const netmesh_scales_request* request);

/* The joined diagram. With eps, certified_ratio is at most (1 + 3 theta) (1 + eps), at log distance 3 theta + eps from
 * the offsets of all points; usually far less, as it is computed from how far the scales found are apart
 * (report.scales.separation). With ratio it is at most that: what the distances of the scales leave of it is asked of
 * each mesh. Peak memory is that of the largest scale and some 100 bytes a point, whatever the
 * spread; distances are resolved relative to each scale. Cost besides the meshes: points times points of their scale.
 * Replaces what the context held, also on failure; the context then holds a diagram and no mesh.
 * With bounds every bar is bounded by the cells of its own mesh and by how the join moves values at its scale: a
 * cluster of radius r at distances a by (a + r) / a at most, and not at all where it is too small to see. The numbers
 * are read as after netmesh_bound_bars, which would have the certified ratio alone to go by; the steps stand on a grid,
 * at most 1024 of them. About 130 bytes more a vertex of the largest mesh, 140 a bar and 100 KB in all.
 * With representatives a pair of some length has a set of simplices of points, by their number in input order after
 * merging. With c the certified_ratio it is a cycle of the Cech complex at c times the birth, no boundary before death
 * / c and one from c times the death on; it may be empty where death <= c^2 birth. In degree 0 one point, and another
 * one for a pair that dies. The value of its simplices is the pair's birth. About the time of the diagram once more.
 * INVALID_ARGUMENT (SIZES: coordinates near point index_a do not resolve the size that eps asks for), NOT_FINITE,
 * OUT_OF_RANGE, TOO_CLOSE, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_scales(netmesh_context* context, const netmesh_scales_request* request);

/* The alpha complex of points, in less memory than netmesh_delaunay and netmesh_persist take, where nothing is wanted
 * but its diagram. */
typedef struct netmesh_alpha_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points;       /* [point_count][D], any finite numbers. Not read by the plan */
    size_t point_count;       /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;            /* as of netmesh_delaunay_request */
    uint32_t max_degree;      /* highest degree of homology, more than D-1 counts as D-1; init: NETMESH_DIM_MAX */
    uint32_t keep_zero_pairs; /* 1: pairs of zero length are kept */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_alpha_request;

void netmesh_alpha_request_init(netmesh_alpha_request* request, size_t request_bytes, uint32_t dim);

/* As netmesh_plan_delaunay. */
size_t netmesh_plan_alpha(const netmesh_alpha_request* request);

/* The diagram of the filter ALPHA, pair for pair that of netmesh_persist on netmesh_delaunay. Exact duplicates are
 * merged and counted. The context then holds a diagram of a complex on points and no triangulation, so there are no
 * representatives. Replaces what the context held; without OK it is empty.
 * Memory: the larger of two peaks, while points are inserted and while the complex is filtered.
 * INVALID_ARGUMENT, NOT_FINITE, OUT_OF_RANGE, FLAT, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_alpha(netmesh_context* context, const netmesh_alpha_request* request);

/* Coordinates that points of a RIPS request have at most. */
#define NETMESH_RIPS_DIM_MAX 65536

/* Filtrations on points themselves (6.4, 8.5):
 *   RIPS, CECH          all simplices of up to max_degree + 2 points; of RIPS nothing but the edges is stored unless
 *                       representatives are asked for or there are more than 65,536 points, or more simplices than
 *                       62 bits can number
 *   BARYCENTRIC_CECH    nested sets of k .. k + max_degree + 1 points: the diagram of the places within a radius of k
 *                       points, each point its own first neighbour
 *   BARYCENTRIC_RIPS    the same with Rips for Cech: certified values are the filter's own times 2^(1/4), which makes
 *                       the diagram a 2^(1/4)-approximation; with the filter's own values it is a
 * sqrt(2)-approximation */
typedef struct netmesh_points_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6; of RIPS to NETMESH_RIPS_DIM_MAX */
    netmesh_monitor monitor;
    const void* points; /* [point_count][D]. Not read by the plan */
    size_t point_count; /* 1 .. NETMESH_POINTS_MAX */
    netmesh_filter filter;
    netmesh_values values;
    uint32_t k;               /* of the barycentric filters, >= 1 and k + max_degree <= 30; init: 1 */
    uint32_t max_degree;      /* at most 30; init: 1 */
    uint32_t keep_zero_pairs; /* 1: pairs of zero length are kept */
    uint32_t representatives; /* 1: keep a cycle for each pair (netmesh_get_cycle); RIPS and CECH. Vertices are numbered
                                 in input order after merging */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
    double threshold; /* of RIPS, a radius as all values are: an edge of a larger value is not there. 0: no such limit,
                         which the least double comes next to */
} netmesh_points_request;

void netmesh_points_request_init(netmesh_points_request* request, size_t request_bytes, uint32_t dim,
                                 netmesh_filter filter);

/* Bytes of block to plan for: more than the points take in any position, but for the fill of the reduction. SIZE_MAX
 * when it does not fit a size_t, 0 on an invalid request. RIPS with representatives takes as much as CECH. */
size_t netmesh_plan_points(const netmesh_points_request* request);

/* Persistent homology over Z/2 in degrees 0..max_degree. Values are radii; of all but BARYCENTRIC_RIPS each is the
 * exact one, rounded to the nearest double, ties to even, beyond the largest infinite: no edge. Exact duplicates are
 * merged, counted and not counted as neighbours. Replaces what the context held, also on failure. Simplices are some
 * n^(max_degree + 2), nested sets n^(k + max_degree + 1): ask netmesh_plan_points first. INVALID_ARGUMENT (K: 0, or
 * above the number of different points), NOT_FINITE, OUT_OF_RANGE (of balls, as of ALPHA), OUT_OF_MEMORY,
 * CANCELLED. */
netmesh_status netmesh_persist_points(netmesh_context* context, const netmesh_points_request* request);

/* A barycentric filter for a range of k, with the maps between consecutive k (8.5). */
typedef struct netmesh_points_vineyard_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points;    /* [point_count][D]. Not read by the plan */
    size_t point_count;    /* 1 .. NETMESH_POINTS_MAX */
    netmesh_filter filter; /* BARYCENTRIC_CECH or BARYCENTRIC_RIPS */
    netmesh_values values;
    uint32_t k_first, k_last;          /* 1 <= k_first <= k_last and k_last + max_degree <= 30; init: 1 and 1 */
    uint32_t max_degree;               /* init: 1 */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_points_vineyard_request;

void netmesh_points_vineyard_request_init(netmesh_points_vineyard_request* request, size_t request_bytes, uint32_t dim,
                                          netmesh_filter filter);

/* As netmesh_plan_points. */
size_t netmesh_plan_points_vineyard(const netmesh_points_vineyard_request* request);

/* The diagrams of all k in one run, each that of netmesh_persist_points without pairs of zero length, and vines through
 * them, read by netmesh_get_vine_point. The places within a radius of k + 1 points are within that radius of k points:
 * at every scale inclusion maps the homology of the former to that of the latter. Vines join the bars that these maps
 * match (Bauer and Lesnick's induced matching): where a vine is at (b, d) for k and at (b', d') for k + 1, classes born
 * at b' for k + 1 live on for k until d, and the image of the map has the bar (b', d). The bars of the image are these
 * and no others, so its rank between two scales a <= c is the number of vines with b' <= a and c < d. A bar that its
 * vine does not lead from k + 1 to k is mapped to what is older there. Each map is matched by itself: a vine through
 * three k says nothing of the map from the third to the first.
 * Of BARYCENTRIC_CECH the maps are those of the places themselves (the equivalence of theorem 8.5.5 holds for all k
 * together), of BARYCENTRIC_RIPS they are as close to them as the diagrams are, by the same ratio.
 * One complex for all k: nested sets of k_first to k_last + max_degree + 1 points that differ by at most max_degree
 * + 1. Replaces what the context held, also on failure. The vineyard's report has no transpositions. INVALID_ARGUMENT
 * (K_LAST: above the number of different points), NOT_FINITE, OUT_OF_RANGE (as of ALPHA), OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_points_vineyard(netmesh_context* context, const netmesh_points_vineyard_request* request);

/* Any filtered simplicial complex (6.2, 6.3). Simplex i has the vertices vertices[starts[i] .. starts[i + 1]), at
 * most 32 distinct labels in any order, and enters at entries[i], a finite number. Simplices come in any order; every
 * face must be there and enter no later. */
typedef struct netmesh_homology_request {
    uint32_t struct_bytes;
    uint32_t max_degree; /* more than the dimension counts as the dimension, whose cycles never die; init:
                            NETMESH_DEGREE_MAX */
    netmesh_monitor monitor;
    const uint32_t* vertices; /* [starts[simplex_count]] */
    const uint64_t* starts;   /* [simplex_count + 1] */
    const double* entries;    /* [simplex_count] */
    uint64_t simplex_count;   /* >= 1 */
    uint64_t vertex_count; /* the length of vertices[]; read by the plan, and the job reads no vertex beyond it. 0: the
                                 job takes starts[simplex_count] for it */
    uint32_t keep_zero_pairs; /* 1: pairs of zero length are kept */
    uint32_t representatives; /* 1: keep a cycle for each pair (netmesh_get_cycle) */
} netmesh_homology_request;

void netmesh_homology_request_init(netmesh_homology_request* request, size_t request_bytes);

/* Bytes of block to plan for, without the fill of the reduction; reads simplex_count and vertex_count. SIZE_MAX when it
 * does not fit a size_t, 0 on an invalid request. */
size_t netmesh_plan_homology(const netmesh_homology_request* request);

/* Persistent homology over Z/2 of the complex in degrees 0..max_degree. Essential pairs are the Betti numbers. Replaces
 * what the context held, also on failure.
 * INVALID_ARGUMENT, NOT_FINITE (simplex index_a), NOT_A_COMPLEX, OUT_OF_MEMORY, CANCELLED; then the context is empty.
 * */
netmesh_status netmesh_homology(netmesh_context* context, const netmesh_homology_request* request);

/* One complex and any sequence of filtrations of it. The complex is given as in netmesh_homology_request; each step is
 * a vector of values, one for each simplex in their order, or, by_vertex, one for each simplex of one vertex in their
 * order: the other simplices then enter with the last of their vertices (lower stars), which is always a filtration. */
typedef struct netmesh_value_vineyard_request {
    uint32_t struct_bytes;
    uint32_t max_degree; /* as of netmesh_homology_request; init: NETMESH_DEGREE_MAX */
    netmesh_monitor monitor;
    const uint32_t* vertices; /* [starts[simplex_count]] */
    const uint64_t* starts;   /* [simplex_count + 1] */
    const double* entries;    /* [step_count][simplex_count], by_vertex [step_count][simplices of one vertex] */
    uint64_t simplex_count;   /* >= 1 */
    uint64_t vertex_count;    /* as of netmesh_homology_request */
    uint64_t step_count;      /* 1 .. 2^32 - 2 */
    uint32_t by_vertex;       /* 1: values of vertices */
} netmesh_value_vineyard_request;

void netmesh_value_vineyard_request_init(netmesh_value_vineyard_request* request, size_t request_bytes);

/* Bytes of block to plan for, with a bar for every other simplex at every step and columns as long as boundaries; reads
 * simplex_count, vertex_count and step_count. SIZE_MAX when it does not fit a size_t, 0 on an invalid request. */
size_t netmesh_plan_value_vineyard(const netmesh_value_vineyard_request* request);

/* The diagrams of all steps, each that of netmesh_homology, and the vines that connect them (6.3), read by
 * netmesh_get_vine_point with k for the step, from 1 on; all ratios are 1, the report's filter is NONE. From step to
 * step every value moves on a straight line, (1 - t) a + t b, and vines are those of this homotopy: simplices of one
 * dimension are transposed in the order in which their values meet, which is decided exactly. Values that are equal at
 * a step are in the order of the list there, so simplices that begin equal change their places at t = 0 if at all, and
 * those that end equal at t = 1. Where several meet at one t, they are transposed by dimension, then from the first to
 * enter on; another order could exchange vines that meet in one point, and no others.
 * Replaces what the context held, also on failure. Memory: about 160 bytes a simplex, the columns, and 32 bytes for
 * each bar of each step. Time: as of netmesh_vineyard.
 * INVALID_ARGUMENT, NOT_FINITE (simplex index_a at detail.step), NOT_A_COMPLEX (detail.fault; FACE_LATER at
 * detail.step), OUT_OF_MEMORY, CANCELLED; then the context is empty. */
netmesh_status netmesh_value_vineyard(netmesh_context* context, const netmesh_value_vineyard_request* request);

#ifdef __cplusplus
}
#endif
#endif
