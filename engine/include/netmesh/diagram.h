/* What a diagram is: filters, bars, bounds of bars, cycles, vines. */
#ifndef NETMESH_DIAGRAM_H
#define NETMESH_DIAGRAM_H

#include <stddef.h>
#include <stdint.h>

#include "request.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Filters by number, as reports have them. */
typedef enum netmesh_filter_id {
    NETMESH_FILTER_NONE = 0,      /* of a complex given by its simplices */
    NETMESH_FILTER_COMPLETE = 1,  /* 7.4.2, on a mesh */
    NETMESH_FILTER_BASIC = 2,     /* 7.4.1, on a mesh */
    NETMESH_FILTER_ALPHA = 3,     /* exact alpha complex, on a Delaunay triangulation of the points */
    NETMESH_FILTER_KNN = 4,       /* d_k, the distance to the k-th nearest point (8.6), on a mesh; k = 1: complete */
    NETMESH_FILTER_KDISTANCE = 5, /* root mean square of the distances to the k nearest points (8.6), on a mesh */
    NETMESH_FILTER_FUNCTION = 6,  /* any Lipschitz function (8.6), on a mesh */
    NETMESH_FILTER_TIGHT = 7,     /* 7.5, on an over-refined mesh (or any other, with a weaker ratio) */
    NETMESH_FILTER_SCALES = 8,    /* 7.6 */
    NETMESH_FILTER_RIPS = 9,      /* Vietoris-Rips complex: edges enter at half their length */
    NETMESH_FILTER_CECH = 10,     /* Cech complex: the offsets' exact diagram */
    NETMESH_FILTER_BARYCENTRIC_CECH = 11, /* 8.5: sublevel sets of the distance to the k-th nearest point, exact */
    NETMESH_FILTER_BARYCENTRIC_RIPS = 12, /* 8.5: the same within 2^(1/4), from distances alone */
    NETMESH_FILTER_AUTO = 255             /* of a request alone: a diagram has the filter that was taken */
} NETMESH_AN_INT netmesh_filter_id;

/* Why a diagram is of its filter. */
typedef enum netmesh_why {
    NETMESH_WHY_ASKED = 0, /* it was asked for; the others are what the filter auto has found */
    /* ALPHA */
    NETMESH_WHY_AFFORDABLE = 1, /* it takes no more than twice the work of a mesh, as far as known */
    NETMESH_WHY_NO_MESH = 2,    /* it is not, but these points have no mesh */
    /* COMPLETE */
    NETMESH_WHY_CELLS = 3,  /* alpha would take more work: many cells, or many ties between their radii */
    NETMESH_WHY_MEMORY = 4, /* the alpha complex does not fit in the block */
    NETMESH_WHY_FLAT = 5,   /* the points have no Delaunay triangulation, as they lie in a hyperplane */
    NETMESH_WHY_RANGE = 6,  /* coordinates are too far apart in size for an exact alpha complex */
    /* ALPHA */
    NETMESH_WHY_ALONE = 7 /* no other filter takes weights or periods */
} NETMESH_AN_INT netmesh_why;

/* "the exact alpha complex is affordable": a static string. */
const char* netmesh_why_text(netmesh_why why);

/* What a filter is and what it needs: a row of the library's own table, so that programs need no list of filters. One
 * of the four is_ is 1. */
typedef struct netmesh_filter_info {
    uint32_t struct_bytes;
    netmesh_filter_id id;
    const netmesh_filter* filter;
    uint32_t is_on_mesh;          /* 1: of a mesh, or of points by way of one */
    uint32_t is_on_triangulation; /* 1: of a Delaunay triangulation, or of points: alpha */
    uint32_t is_on_points;        /* 1: of a complex on the points themselves: rips, cech, barycentric ones */
    uint32_t is_by_scales;        /* 1: of points, scale by scale */
    const char* name;             /* "barycentric-cech": lower case, words joined by a hyphen */
    const char* reference;        /* the function whose diagram is certified; {k} and {D} stand for the numbers:
                                   "sublevel sets of d_{k} in R^{D}" */
    uint32_t needs_k;             /* 1: k is read, from 1 to the number of different points */
    uint32_t needs_function;      /* 1: a netmesh_function is read */
    uint32_t has_eps;             /* 1: promises an accuracy, goal.eps */
    uint32_t has_theta;           /* 1: goal.theta is read */
    uint32_t has_values;          /* 1: NETMESH_VALUES_THESIS and NETMESH_VALUES_CERTIFIED differ */
    uint32_t has_vineyard;        /* 1: vines over a range of k on one mesh; barycentric filters have vines, too */
    uint32_t has_goal;            /* 1: without eps and method, its meshes are made by the method certificate */
    uint32_t has_representatives; /* 1: netmesh_cycles can be wanted */
    uint32_t bounds_by_scale;     /* 1: netmesh_bounds goes by the bounds of cells; 0: by the certified ratio */
    uint32_t clips_cells;         /* 1: of a mesh refined for clipped cells it filters those; 0: all cells, whole */
} netmesh_filter_info;

/* Row `index`, from 0 on, in the order of netmesh_filter_id without NONE and AUTO. A program that calls it holds the
 * code of all filters. INVALID_ARGUMENT: there are no more. O(1). */
netmesh_status netmesh_get_filter_info(uint32_t index, netmesh_filter_info* info);

/* A bar of the diagram; they are sorted by degree, birth, death. death is +infinity for an essential class, and for one
 * that ends beyond the largest double. O(1). */
typedef struct netmesh_pair {
    uint32_t struct_bytes;
    uint32_t degree;
    double birth, death;
} netmesh_pair;
netmesh_status netmesh_get_pair(const netmesh_context* context, uint64_t index, netmesh_pair* pair);

typedef struct netmesh_bar_bounds {
    uint32_t struct_bytes;
    uint32_t certain; /* 1: certified to exist, however short: all bars with 1 belong to different true bars within
                         their bounds. Always so when death > certain_after, often for other reasons */
    double birth_low, birth_high, death_low, death_high; /* contain the true birth and death of a bar that is matched;
                                                            what is beyond the largest double counts as infinite */
    double certain_after; /* a bar of this birth that dies later is certified to exist; not below birth_high */
} netmesh_bar_bounds;
/* Of the pair of that index, where bounds were wanted; else INVALID_ARGUMENT. O(1). */
netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds);

/* The certificate as a function of scale, where bounds were wanted: a step holds for scales alpha from `from` up to the
 * next step's `from`. Steps ascend in all but ratio and error. O(1).
 *   a birth or death at alpha   stands for a true one between min(low, alpha) and max(high, alpha), and within the
 *                               factor `ratio`
 *   c(alpha)                    the certified ratio at alpha: max(high / alpha, alpha / low, 1) or `ratio`, whichever
 *                               is less. Before the first step it is 1
 *   a bar born at alpha         is certified to exist when it dies after max(reach, alpha)
 *   a bar without a true bar    has death / c(death) <= birth c(birth)
 *   a true bar without a bar    has birth >= alpha / c(alpha) and death <= alpha c(alpha) for some alpha
 * Of FUNCTION, whose values may have any sign, the same by differences: e(alpha) is max(high - alpha, alpha - low, 0)
 * or `error`, whichever is less. A bar longer than 2 e(birth) is not certified to exist for that alone. */
typedef struct netmesh_scale_step {
    uint32_t struct_bytes;
    double from, low, high, reach; /* radii; those but `from` may be infinite */
    double ratio;                  /* at most certified_ratio where from >= certified_from */
    double error;                  /* of FUNCTION at most certified_error */
} netmesh_scale_step;
netmesh_status netmesh_get_scale_step(const netmesh_context* context, uint64_t index, netmesh_scale_step* step);

/* A representative of pair `pair`, where cycles were wanted; else NO_RESULT. It is a set of simplices of the pair's
 * degree whose boundary is zero. The last of them enters at the pair's birth, and the set is a boundary from the pair's
 * death on. In degree 0: a vertex and, when the pair dies (it may do so beyond the largest double), an older one that
 * it is then connected to. Of SCALES: see netmesh_cycles. Vertices are those of netmesh_get_vertex; of complexes on
 * points the points, numbered in input order after merging; of simplices their labels.
 * get_cycle tells the number of simplices, O(1); get_cycle_simplex one of them, in no particular order, O(degree^2).
 *
 * With periods simplices are sets of copies, up to translation, and so are their facets, modulo 2: an edge from a point
 * to its own copy has no boundary. Vertices are rows of the input, of equal points the first or the heaviest: vertex i
 * is at what row vertices[i] says, and translations[i][j] times vector j of the lattice farther. Those of the first
 * are 0. */
typedef struct netmesh_simplex {
    uint32_t struct_bytes;
    uint32_t degree;
    double value;                              /* at which it enters */
    uint32_t vertices[NETMESH_DEGREE_MAX + 1]; /* ascending; the first degree + 1. Periods: may repeat */
    int32_t translations[NETMESH_DIM_MAX + 1][NETMESH_DIM_MAX]; /* with periods; else 0 */
} netmesh_simplex;
netmesh_status netmesh_get_cycle(const netmesh_context* context, uint64_t pair, uint64_t* simplices);
netmesh_status netmesh_get_cycle_simplex(const netmesh_context* context, uint64_t pair, uint64_t index,
                                         netmesh_simplex* simplex);

/* Where a vine is at one k: a pair of that k's diagram. Sorted by vine, then k; vines are numbered from 0 by degree,
 * the first k at which they have a length, birth and death there. A vine that loses its length and gets it again
 * keeps its number. O(1). */
typedef struct netmesh_vine_point {
    uint32_t struct_bytes;
    uint32_t vine, degree, k;
    double birth, death; /* death is +infinity for an essential class */
} netmesh_vine_point;
netmesh_status netmesh_get_vine_point(const netmesh_context* context, uint64_t index, netmesh_vine_point* point);
/* The certified ratio of the diagram at one k of the vineyard, or at one step, from 1 on. O(1). */
netmesh_status netmesh_get_vine_ratio(const netmesh_context* context, uint32_t k, double* ratio);

#ifdef __cplusplus
}
#endif
#endif
