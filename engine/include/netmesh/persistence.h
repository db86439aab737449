/* Persistent homology of what a context holds: filters, diagrams, bounds of bars, cycles, the best that fits a block,
 * vineyards in k. */
#ifndef NETMESH_PERSISTENCE_H
#define NETMESH_PERSISTENCE_H

#include <stddef.h>
#include <stdint.h>

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum netmesh_filter {
    NETMESH_FILTER_NONE = 0,
    /* on a triangulation or mesh, by netmesh_persist */
    NETMESH_FILTER_COMPLETE = 1,  /* 7.4.2, on a mesh */
    NETMESH_FILTER_BASIC = 2,     /* 7.4.1, on a mesh */
    NETMESH_FILTER_ALPHA = 3,     /* exact alpha complex, on a Delaunay triangulation of the points */
    NETMESH_FILTER_KNN = 4,       /* d_k, the distance to the k-th nearest point (8.6), on a mesh; k = 1: complete */
    NETMESH_FILTER_KDISTANCE = 5, /* root mean square of the distances to the k nearest points (8.6), on a mesh */
    NETMESH_FILTER_FUNCTION = 6,  /* any Lipschitz function (8.6), on a mesh */
    NETMESH_FILTER_TIGHT = 7,     /* 7.5, on a mesh made for PURPOSE_TIGHT (or any other, with a weaker ratio) */
    /* from points, by netmesh_persist_scales */
    NETMESH_FILTER_SCALES = 8, /* 7.6 */
    /* on the points themselves, by netmesh_persist_points */
    NETMESH_FILTER_RIPS = 9,              /* Vietoris-Rips complex: edges enter at half their length */
    NETMESH_FILTER_CECH = 10,             /* Cech complex: the offsets' exact diagram */
    NETMESH_FILTER_BARYCENTRIC_CECH = 11, /* 8.5: sublevel sets of the distance to the k-th nearest point, exact */
    NETMESH_FILTER_BARYCENTRIC_RIPS = 12  /* 8.5: the same within 2^(1/4), from distances alone */
} NETMESH_AN_INT netmesh_filter;

/* Why a diagram is of its filter. */
typedef enum netmesh_why {
    NETMESH_WHY_ASKED = 0, /* it was asked for; the others are what netmesh_persist_auto has found */
    /* ALPHA */
    NETMESH_WHY_AFFORDABLE = 1, /* it takes no more than twice the work of a mesh, as far as known */
    NETMESH_WHY_NO_MESH = 2,    /* it is not, but these points have no mesh */
    /* COMPLETE */
    NETMESH_WHY_CELLS = 3,    /* alpha would take more work: many cells, or many ties between their radii */
    NETMESH_WHY_MEMORY = 4,   /* the alpha complex does not fit in the block */
    NETMESH_WHY_FLAT = 5,     /* the points have no Delaunay triangulation, as they lie in a hyperplane */
    NETMESH_WHY_RANGE = 6,    /* coordinates are too far apart in size for an exact alpha complex */
    NETMESH_WHY_NOT_BUILT = 7 /* ALPHA is left out of this build */
} NETMESH_AN_INT netmesh_why;

/* "the exact alpha complex is affordable": a static string. */
const char* netmesh_why_text(netmesh_why why);

typedef enum netmesh_values {
    NETMESH_VALUES_CERTIFIED = 0, /* the filter's values, clamped so that the certified ratio is the best possible */
    NETMESH_VALUES_THESIS = 1     /* the filter's own values */
} NETMESH_AN_INT netmesh_values;

/* Which call a filter goes to. */
typedef enum netmesh_source {
    NETMESH_SOURCE_MESH = 1,     /* netmesh_mesh, then netmesh_persist */
    NETMESH_SOURCE_DELAUNAY = 2, /* netmesh_delaunay, then netmesh_persist */
    NETMESH_SOURCE_SCALES = 3,   /* netmesh_persist_scales */
    NETMESH_SOURCE_POINTS = 4    /* netmesh_persist_points */
} NETMESH_AN_INT netmesh_source;

/* What a filter is and what it needs. The library's own table: whoever reads it needs no list of filters. */
typedef struct netmesh_filter_info {
    uint32_t struct_bytes;
    netmesh_filter filter;
    netmesh_source source;
    netmesh_purpose purpose;      /* of the mesh or triangulation made for it */
    const char* name;             /* "barycentric-cech": lower case, words joined by a hyphen */
    const char* reference;        /* the function whose diagram is certified; {k} and {D} stand for the numbers:
                                   "sublevel sets of d_{k} in R^{D}" */
    uint32_t needs_k;             /* 1: k is read, from 1 to the number of different points */
    uint32_t needs_function;      /* 1: a netmesh_function is read */
    uint32_t has_eps;             /* 1: promises an accuracy, tight_eps or eps */
    uint32_t has_theta;           /* 1: reads theta */
    uint32_t has_values;          /* 1: NETMESH_VALUES_THESIS and NETMESH_VALUES_CERTIFIED differ */
    uint32_t has_vineyard;        /* 1: netmesh_vineyard takes it */
    uint32_t has_goal;            /* 1: its meshes may be refined by a netmesh_certificate_goal */
    uint32_t has_representatives; /* 1: cycles can be had, by netmesh_represent or the request */
    uint32_t bounds_by_scale;     /* 1: netmesh_bound_bars goes by the bounds of cells; 0: by the certified ratio */
    uint32_t clips_cells;         /* 1: of a mesh refined for clipped cells it filters those; 0: all cells, whole */
} netmesh_filter_info;

/* Row `index` of the table, from 0 on, in the order of netmesh_filter without NONE. */
netmesh_status netmesh_get_filter_info(uint32_t index, netmesh_filter_info* info);

/* A function f of the caller's, of any sign, with |f(x) - f(y)| <= lipschitz |x - y|. Homology beyond the mesh is what
 * the caller answers for: 7.4.4's clipping argument is proven for distances to points, for a general f it is an
 * assumption. What is certified is certified of f as evaluate computes it: its roundings are not counted. */
typedef struct netmesh_function {
    uint32_t struct_bytes;
    double (*evaluate)(void* user, const double* x); /* f at x[D], finite; called once for each vertex, in their order;
                                                        must not call into the context */
    void* user;                                      /* handed to evaluate */
    double lipschitz;                                /* finite, >= 0 */
    double distance_factor; /* a c with f >= d_2 / c, d_2 the distance to the second nearest point (8.6.3); 0: none */
    double cut;             /* finite: f >= cut outside the domain ball (report.mesh.domain), and sublevel sets from
                               cut on are contractible; values are cut there */
} netmesh_function;

void netmesh_function_init(netmesh_function* function, size_t function_bytes);

/* The size at x[D] of a mesh on which FUNCTION, with VALUES_THESIS, has a certified_error of at most `error` > 0: a
 * caller's netmesh_size hands it on, `error` being the caller's own (3.7). Close to error / lipschitz where f <= cut +
 * error, (f - cut) / lipschitz beyond; 0, which a mesh refuses, where the arguments are not as said, or error is below
 * some units in the last place of f and cut. Calls evaluate once. */
double netmesh_size_for_error(const netmesh_function* function, double error, const double* x);

typedef struct netmesh_persist_request {
    uint32_t struct_bytes;
    netmesh_filter filter; /* init: COMPLETE */
    netmesh_monitor monitor;
    netmesh_values values;
    uint32_t k;               /* neighbours, the point itself counted, of KNN and KDISTANCE; 0: 1 */
    uint32_t max_degree;      /* highest degree of homology, more than D-1 counts as D-1; init: NETMESH_DIM_MAX */
    uint32_t keep_zero_pairs; /* 1: pairs of zero length are kept */
    const netmesh_function* function; /* of the filter FUNCTION */
} netmesh_persist_request;

void netmesh_persist_request_init(netmesh_persist_request* request, size_t request_bytes);

/* Persistent homology over Z/2 of the filtration on what the context holds. Values are radii, not squared radii. ALPHA
 * needs a Delaunay triangulation, the others a mesh without cages; one mesh serves every k. Replaces the diagram, also
 * when it fails.
 * Memory above the mesh: as a rule 8 bytes a vertex and the pairs; alpha 25 bytes a simplex and fill, on grids 33.
 * KNN and KDISTANCE, k >= 2: on a mesh on which COMPLETE certifies c with whole cells the certified_ratio is at most
 * sqrt(2 + s c^2), s = 1 for KNN and sqrt(k / (k - 1)) for KDISTANCE. For FUNCTION: the sublevel sets of a function
 * (8.6). certified_ratio is infinite where f is too small for its change across a Voronoi cell; a distance_factor keeps
 * it finite. certified_error is finite, at most lipschitz times the domain's radius; infinite where what is said of the
 * function cannot be: at a vertex it is less than cut and lipschitz allow so far from the domain's sphere.
 * INVALID_ARGUMENT (K: more than the number of different points), NOT_FINITE (index_a: the vertex at which the function
 * is not finite), OUT_OF_RANGE (ALPHA: differences of coordinates above 2^2766 units in the plane, 2^2075 in space,
 * 2^1185 in R^6, of which all coordinates are multiples), CHECK_FAILED (ALPHA: what was loaded is
 * no triangulation of the convex hull of its vertices, exactly: a cell is flat, cells overlap, are apart or meet at a
 * vertex only, the hull has a dent; whether it is Delaunay is left to netmesh_check. Others: no triangulated ball was
 * loaded, as far as the job depends on it),
 * NO_RESULT, OUT_OF_MEMORY, CANCELLED. The mesh stays whole on failure.
 * ALPHA: every birth and death is the exact one, rounded to the nearest double, ties to even; beyond the largest double
 * it is infinite. A bar is there where the exact bar's ends are different doubles, and no other. */
netmesh_status netmesh_persist(netmesh_context* context, const netmesh_persist_request* request);

/* The diagram of the offsets of points by whichever filter costs less. */
typedef struct netmesh_auto_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points;                /* [point_count][D]. Not read by the plan */
    size_t point_count;                /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;                     /* of every random choice; init: 1 */
    uint32_t max_degree;               /* as of netmesh_persist_request; init: NETMESH_DIM_MAX */
    uint32_t keep_zero_pairs;          /* likewise */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_auto_request;

void netmesh_auto_request_init(netmesh_auto_request* request, size_t request_bytes, uint32_t dim);

/* Bytes of block to plan for: enough for uniform points, of which ALPHA is taken (if it was built), an estimate for
 * others. A mesh may take several times as much; netmesh_plan_mesh for a purpose of PERSIST and a certificate.ratio of
 * sqrt(2 + tau) says it. SIZE_MAX when it does not fit, 0 on an invalid request. */
size_t netmesh_plan_auto(const netmesh_auto_request* request);

/* ALPHA, which is exact, where it is affordable: netmesh_delaunay and netmesh_persist. Else COMPLETE with certified
 * values and its certificate: netmesh_mesh for a certificate.ratio of sqrt(2 + tau) with the dimension's tau (of that
 * tau itself in a build without NETMESH_WITH_CERTIFICATE) and netmesh_persist. Leaves what those calls leave, with the
 * same fingerprint. The report's diagram.filter says which, diagram.why the reason. Without OK the context is empty.
 *
 * The triangulation is begun and given up as soon as it has made more than 40 / 150 / 250 / 1500 / 8000 cells (D =
 * 2..6) for each point inserted: uniform points take 6 / 28 / 158 / 898 / 4264, curves in space as many as there are
 * points. A conflict that takes more than a first sight (NETMESH_PREDICATE_CACHED) counts for 5 of them, a tie for 2:
 * where points are nearly cospherical, as on curves, a cell of an alpha complex takes longer. The triangulation is
 * given up as well when the alpha complex would not fit in the block. The choice depends on points, seed and the
 * block's size, on nothing else. What is given up is below a quarter of the whole, and the filter taken at most twice
 * as dear as the other one, on the 32 sets of tests/common/kinds.hpp (tests/bench/auto.cpp); DESIGN.md says on which
 * others not. INVALID_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY (the mesh does not fit either), CANCELLED. */
netmesh_status netmesh_persist_auto(netmesh_context* context, const netmesh_auto_request* request);

/* Pairs sorted by degree, birth, death; death is +infinity for an essential class, and for one that ends beyond the
 * largest double, as classes of points may that have no mesh. O(1). */
typedef struct netmesh_pair {
    uint32_t struct_bytes;
    uint32_t degree;
    double birth, death;
} netmesh_pair;
netmesh_status netmesh_get_pair(const netmesh_context* context, uint64_t index, netmesh_pair* pair);

typedef struct netmesh_bounds_request {
    uint32_t struct_bytes;
    netmesh_monitor monitor;
    const netmesh_function* function; /* of a diagram of FUNCTION, as that was made: its evaluate is called again, once
                                         for each vertex. Null: every bar has the certified_error of all */
} netmesh_bounds_request;

void netmesh_bounds_request_init(netmesh_bounds_request* request, size_t request_bytes);

/* For each bar where the true one surely is, from the bounds of every cell instead of one ratio; whether the bar surely
 * stands for a class of the true diagram; and the ratio as a function of scale. Where a filter's bounds_by_scale is
 * 1: by scale, and by covers within and around the sublevel sets, at the cost of up to eight more diagrams; of FUNCTION
 * with the request's function alone. Else by the certified ratio and certified_error, and half a unit in the last
 * place; of SCALES by scale where its request asked for that. The numbers stay with the diagram, and are not made
 * again: 48 bytes a bar. Scratch: about 110 bytes a vertex, 120 a bar, and what a diagram takes; netmesh_plan_mesh does
 * not count it. The diagram stays whole on failure. NO_RESULT (no diagram), INVALID_ARGUMENT (FUNCTION: not the one of
 * the diagram), OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_bounds_request* request);

typedef struct netmesh_bar_bounds {
    uint32_t struct_bytes;
    uint32_t certain; /* 1: surely real: all bars with 1 belong to different true bars within their bounds. Surely so
                         when death > certain_after, often for other reasons */
    double birth_low, birth_high, death_low, death_high; /* contain the true birth and death of a bar that is matched;
                                                            what is beyond the largest double counts as infinite */
    double certain_after; /* a bar of this birth that dies later is surely real; not below birth_high */
} netmesh_bar_bounds;
/* Of the pair of that index, after netmesh_bound_bars. O(1). */
netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds);

/* The certificate as a function of scale, after netmesh_bound_bars. For alpha from `from` up to the next step's `from`
 * a birth or death at alpha stands for a true one between min(low, alpha) and max(high, alpha), and within the factor
 * `ratio`; c(alpha), the certified ratio at alpha, is max(high / alpha, alpha / low, 1) or `ratio`, whichever is less.
 * A bar born at alpha that dies after max(reach, alpha) is surely real. Bars without a true bar have death / c(death)
 * <= birth * c(birth); true bars without a bar have birth >= alpha / c(alpha), death <= alpha * c(alpha) for some
 * alpha. Before the first step c is 1. Steps ascend in all but ratio and error. Of FUNCTION, whose values may have any
 * sign, the same by differences: e(alpha) is max(high - alpha, alpha - low, 0) or `error`, whichever is less; a bar
 * longer than 2 e(birth) is not surely real for that alone, one that dies after max(reach, birth) is. O(1). */
typedef struct netmesh_scale_step {
    uint32_t struct_bytes;
    double from, low, high, reach; /* radii; those but `from` may be infinite */
    double ratio;                  /* at most certified_ratio where from >= certified_from */
    double error;                  /* of FUNCTION at most certified_error */
} netmesh_scale_step;
netmesh_status netmesh_get_scale_step(const netmesh_context* context, uint64_t index, netmesh_scale_step* step);

typedef struct netmesh_represent_request {
    uint32_t struct_bytes;
    netmesh_monitor monitor;
} netmesh_represent_request;

void netmesh_represent_request_init(netmesh_represent_request* request, size_t request_bytes);

/* A representative for each pair of the diagram that netmesh_persist left, in about the time and memory of the diagram.
 * Of an alpha complex, and with pairs of zero length, the complex is listed simplex by simplex and reduced anew: about
 * 40 bytes a simplex above mesh and diagram. The cycles come on top.
 * INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY, CANCELLED; mesh and diagram stay. */
netmesh_status netmesh_represent(netmesh_context* context, const netmesh_represent_request* request);

/* A representative of pair `pair`: a set of simplices of the pair's degree whose boundary is zero, the last of which
 * enters at the pair's birth, and which is a boundary from the pair's death on. In degree 0: a vertex and, when the
 * pair dies (it may do so beyond the largest double), an older one that it is then connected to. get_cycle tells the
 * number of simplices, get_cycle_simplex one of them, in no particular order; O(1) and O(degree^2). Of SCALES simplices
 * are sets of points, and what holds is said at netmesh_scales_request. NO_RESULT when no representatives were asked
 * for. */
typedef struct netmesh_simplex {
    uint32_t struct_bytes;
    uint32_t degree;
    double value;                              /* at which it enters */
    uint32_t vertices[NETMESH_DEGREE_MAX + 1]; /* ascending; the first degree + 1 */
} netmesh_simplex;
netmesh_status netmesh_get_cycle(const netmesh_context* context, uint64_t pair, uint64_t* simplices);
netmesh_status netmesh_get_cycle_simplex(const netmesh_context* context, uint64_t pair, uint64_t index,
                                         netmesh_simplex* simplex);

/* Budget mode: the best certified diagram of a filter on meshes that the context's block holds, from points on. */
typedef struct netmesh_fit_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points;          /* [point_count][D] */
    size_t point_count;          /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;               /* of every random choice; init: 1 */
    double ratio;                /* R, the coarsest ratio, > sqrt 2; 0: 4 */
    double focus_from, focus_to; /* both 0, or scales of interest 0 < focus_from < focus_to */
    uint32_t max_degree;         /* as of netmesh_persist_request; init: NETMESH_DIM_MAX */
    uint32_t keep_zero_pairs;    /* likewise */
    uint32_t bounds;             /* 1: netmesh_bound_bars as well, in the same block */
    netmesh_filter filter;       /* any on a mesh; init: COMPLETE */
    netmesh_values values;       /* filter to function: as of netmesh_persist_request */
    uint32_t k;
    const netmesh_function* function; /* its evaluate is called for each vertex of each mesh that is tried, twice with
                                         scales of interest */
    uint32_t whole_cells;             /* as of netmesh_mesh_request; filters without clips_cells have whole cells */
    uint32_t by_error;                /* 1: of FUNCTION the least certified_error; ratio and focus are 0 then */
    double longer_than; /* L > 1: scales of interest are chosen so that bars of more than L times their birth are
                           decided; of COMPLETE with certified values, focus_from and focus_to 0. 0: see below */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_fit_request;

void netmesh_fit_request_init(netmesh_fit_request* request, size_t request_bytes, uint32_t dim);

/* Refines by the certificate (see netmesh_certificate_goal) to ratios of a fixed ladder, 1 + (R - 1) 2^(-j/8), one
 * after the other until one does not fit, and keeps what certifies most: the least certified_ratio, with focus_from and
 * focus_to the least certified_focus. Then the ratios of the ladder are asked of those scales alone, and R of
 * everything else. A larger block never certifies less. What comes out depends on the points, the request and the
 * block's size alone. Meshes are refined for the distance to the points; other filters are evaluated on them. Where all
 * ratios are infinite the finest mesh is kept. With by_error the first mesh is one of quality alone; its
 * certified_error e begins the ladder e 2^(-j/8), down to 2^-32 e, of errors that netmesh_size_for_error asks of the
 * meshes after it; what is kept has the least certified_error. Its evaluate is called for each size too then. Leaves
 * mesh and diagram as netmesh_mesh and netmesh_persist with the report's certificate goal do; without OK the context is
 * empty. Costs, beside the last run, about 5.3 such runs in the plane, 3.4 in space, 2.4 in R^4, the one that does not
 * fit, and another one where the last is not the best.
 * With longer_than the ladder is another one: R everywhere, then scales of interest from above, where bars are
 * undecided (see netmesh_decision_report), down to lower ones or by a better ratio, where that does not help with
 * a lower ratio everywhere, until no bar is undecided or one does not fit. What is kept has no undecided bar, or else
 * the least decided_from. Always with bounds; a larger block never decides less. The mesh is the one of the report's
 * certificate goal here, too. Costs about as much. INVALID_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY (not even R fits), and
 * what those calls say. */
netmesh_status netmesh_fit(netmesh_context* context, const netmesh_fit_request* request);

typedef struct netmesh_vineyard_request {
    uint32_t struct_bytes;
    netmesh_filter filter; /* KNN or KDISTANCE */
    netmesh_monitor monitor;
    uint32_t k_first, k_last; /* 1 <= k_first <= k_last; init: 1 and 1 */
    netmesh_values values;
    uint32_t max_degree; /* as of netmesh_persist_request; init: NETMESH_DIM_MAX */
} netmesh_vineyard_request;

void netmesh_vineyard_request_init(netmesh_vineyard_request* request, size_t request_bytes, netmesh_filter filter);

/* One mesh for all k: the diagrams of the filter for k = k_first..k_last, and the vines that connect them (6.3, 8.6),
 * by transpositions on R = D V while every simplex's value moves on a straight line from one k to the next. The
 * diagram at each k is that of netmesh_persist. Replaces the diagram, also when it fails.
 * Memory above the mesh: about 130 bytes a simplex of dimension up to max_degree + 1, and the columns. Time: O(log n)
 * for each two simplices of a dimension that change their order between two k; that is millions for small meshes
 * already. INVALID_ARGUMENT (K_LAST: more than the number of different points), NO_RESULT, OUT_OF_MEMORY, CANCELLED.
 * The mesh stays whole on failure. */
netmesh_status netmesh_vineyard(netmesh_context* context, const netmesh_vineyard_request* request);

/* Where a vine is at one k: a pair of that k's diagram. Sorted by vine, then k; vines are numbered from 0 by degree,
 * the first k at which they have a length, birth and death there. A vine that loses its length and gets it again
 * keeps its number. O(1). */
typedef struct netmesh_vine_point {
    uint32_t struct_bytes;
    uint32_t vine, degree, k;
    double birth, death; /* death is +infinity for an essential class */
} netmesh_vine_point;
netmesh_status netmesh_get_vine_point(const netmesh_context* context, uint64_t index, netmesh_vine_point* point);
/* The certified ratio of the diagram at one k of the vineyard. O(1). */
netmesh_status netmesh_get_vine_ratio(const netmesh_context* context, uint32_t k, double* ratio);

#ifdef __cplusplus
}
#endif
#endif
