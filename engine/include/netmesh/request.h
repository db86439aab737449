/* One request for a diagram: of what, by which filter, how exact, and what is wanted besides. */
#ifndef NETMESH_REQUEST_H
#define NETMESH_REQUEST_H

#include <stddef.h>
#include <stdint.h>

#include "context.h"
#include "points.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the filters ---- */

/* A filter is a constant object. A program holds the code of the filters that it names, and of no other ones.
 * netmesh_get_filter_info says what each of them needs. */
typedef struct netmesh_filter netmesh_filter;

/* Of points, whichever costs less: alpha, or complete with certified values. It names both, so a program holds both.
 *   result    what the filter taken leaves, with the same fingerprint; of alpha the triangulation is kept. The report's
 *             diagram.filter and diagram.why tell which one was taken. Without OK the context is empty
 *   choice    depends on points, seed and the block's size, on nothing else
 *   plan      of alpha; the filter complete may take several times as much
 *   errors    those of both; OUT_OF_MEMORY: the mesh does not fit either
 *
 * The triangulation is begun and given up as soon as it has made more than 40 / 150 / 250 / 1500 / 8000 cells (D =
 * 2..6) for each point inserted: uniform points take 6 / 28 / 158 / 898 / 4264, curves in space as many as there are
 * points. A conflict that takes more than a first sight (NETMESH_PREDICATE_CACHED) counts for 5 of them, a tie for 2:
 * where points are nearly cospherical, as on curves, a cell of an alpha complex takes longer. The triangulation is
 * given up as well when the alpha complex would not fit in the block. What is given up is below a quarter of the whole,
 * and the filter taken costs at most twice as much as the other one, on the 32 sets of tests/common/kinds.hpp
 * (tests/bench/auto.cpp). */
extern const netmesh_filter netmesh_filter_auto;

/* The exact alpha complex, of points or of a Delaunay triangulation that the context holds.
 *   values    each birth and death is the exact one, rounded to the nearest double, ties to even; infinite beyond the
 *             largest double. A bar is there where its two ends are different doubles, and no other bar
 *   memory    25 bytes a simplex, 33 on grids. Of points alone the triangulation is not kept, which takes less: see
 *             keep_mesh. In the plane 82 bytes a point, above 8,192 points 106, where they are spread evenly
 *   errors    FLAT. OUT_OF_RANGE: coordinates, as multiples of a common unit, differ by more than 2^2766 units in the
 *             plane, 2^2075 in space, 2^1185 in R^6. CHECK_FAILED: what netmesh_load took over is no triangulation of
 *             the convex hull of its vertices; whether it is Delaunay is left to netmesh_check */
extern const netmesh_filter netmesh_filter_alpha;
/* The same of points alone, for small parts: in the plane of at most 8,192 points, two thirds of the code. It keeps no
 * triangulation and takes no cycles, weights or periods. */
extern const netmesh_filter netmesh_filter_alpha_small;

/* ---- points with weights ---- */

/* What points.weights are. A weighting is a constant object; a program that names none holds no code of it.
 *
 * A point p with the weight w has the power |x - p|^2 - w at x. What grows is the set of places where some power is at
 * most a: the union of balls of radius sqrt(a + w), which are not there while a + w < 0. Such are balls around atoms,
 * and points that enter at different times.
 *   filter    alpha; auto takes it without a choice. netmesh_mesh with alpha, or with the method delaunay. All else
 *             refuses weights: other filters and methods, pieces, bounds, cycles (but with periods)
 *   cells     the regular triangulation: some centre has equal powers of a cell's vertices, and less power of no other
 *             point. Ties are broken by index. It does not depend on the order of insertion
 *   hidden    a point can be in no cell: where it is nearest, others have less power. It is no vertex and has no bar;
 *             see netmesh_get_hidden. The others are vertices, in the order of their rows. Points equal to a heavier
 *             one, or to an earlier one as heavy, are duplicates, not hidden
 *   values    sign(a) sqrt(|a|) for the least power a at which a simplex is there, rounded to nearest, ties to even;
 *             with request.squares a itself, so rounded. Negative where the balls as given meet. Vertices enter at
 *             minus their weight, or later, where another ball covers the point by then. So components are born
 *             one after the other. All weights 0: the diagram without weights, to the bit
 *   memory    at most 16 bytes a point above the same without weights. netmesh_plan counts them. Stack:
 *             NETMESH_STACK_BYTES(dim) of job.h
 *   errors    INVALID_ARGUMENT (WEIGHTS): the radius of point index_a is negative; with squares, its square is beyond
 *             the largest double. NOT_FINITE: point or weight index_a. OUT_OF_RANGE: as of alpha, and as far for radii
 *             and for roots of weights as for coordinates */
typedef struct netmesh_weighting netmesh_weighting;

/* Radii r >= 0: weights r^2, which are not rounded. */
extern const netmesh_weighting netmesh_radii;
/* Weights of any sign. */
extern const netmesh_weighting netmesh_weights;

/* They by number, as reports have them. */
typedef enum netmesh_weighting_id {
    NETMESH_WEIGHTING_NONE = 0,
    NETMESH_WEIGHTING_RADII = 1,
    NETMESH_WEIGHTING_WEIGHTS = 2
} NETMESH_AN_INT netmesh_weighting_id;

/* ---- points that repeat ---- */

/* What points.lattice is. A constant object; a program that does not name it holds no code of it.
 *
 * The points stand for all p + k.b, k whole numbers, b the vectors of the lattice: crystals, boxes with periods. The
 * diagram is that of the union of balls in R^D modulo the lattice, with weights or without: a loop can run from a point
 * to its own copy. It takes any number of points from one on.
 *   filter    alpha; auto takes it without a choice. All else refuses periods: other filters, netmesh_mesh, pieces,
 *             bounds, keep_mesh
 *   cycles    as of complexes on points: made with the diagram alone. With translations (netmesh_get_cycle_simplex)
 *   degrees   to D. With all D periods the classes that last are those of the torus, 1, D, .., 1 of them, in degree
 *             D one where the balls cover all. Fewer periods: those of a smaller torus
 *   points    may lie anywhere; which copy of a point is given does not matter. Points equal to a copy of an earlier
 *             one are duplicates
 *   numbers   a copy has to be a double, too. Where some are none, points and a short basis of the lattice are first
 *             moved to multiples of a power of two, 2^-53 of what copies reach. Where points stand at halves, quarters
 *             or eighths of vectors, to 2^-44, these are moved to 8 times that, with thirds or sixths to 24 times, and
 *             points with them: they stay where they are. report.input.moved says how far; 0: nothing was moved. Of
 *             the moved numbers the diagram is exact
 *   ties      broken by index and, among copies of the same points, by the entries of x x^T, in this order: the
 *             triangulation repeats, too. The diagram does not depend on it
 *   memory    that of alpha with weights for the points of one period and of a margin around it about as wide as the
 *             largest empty ball, and what tells whose copy each of them is. netmesh_plan counts points spread evenly
 *   cost      that of as many points
 *   errors    INVALID_ARGUMENT (LATTICE): vector index_a is not finite, or depends on those before it as far as 2^-45
 *             of what their lattice is long. OUT_OF_RANGE: point index_a is 2^50 periods away, or so far beside the
 *             lattice that numbers would be moved by 2^-20 of its distances; a vector is not between 2^-300 and 2^300;
 *             alpha's. FLAT: with all copies */
typedef struct netmesh_periods netmesh_periods;
extern const netmesh_periods netmesh_periodic;

/* ---- filters on meshes ---- */

/* Of points, by way of a mesh that is made for them and kept; or of the mesh without cages that the context holds. One
 * mesh serves every filter and every k.
 *   memory    above the mesh 8 bytes a vertex, and the bars
 *   errors    NO_RESULT: no mesh, or one with cages. INVALID_ARGUMENT: k is more than the number of different points.
 *             CHECK_FAILED: what netmesh_load took over is no triangulated ball, as far as the job depends on it
 *
 * complete: 7.4.2, the distance to the points. Certified ratio: goal.ratio; with the method svr sqrt(2 + tau), and tau
 * of the filter's own values. */
extern const netmesh_filter netmesh_filter_complete;
/* 7.4.1: by the values of vertices alone. The ratio holds from certified_from on. */
extern const netmesh_filter netmesh_filter_basic;
/* 8.6: d_k, the distance to the k-th nearest point, the point itself counted. Where complete certifies c with whole
 * cells the ratio is at most sqrt(2 + c^2). k = 1: complete. */
extern const netmesh_filter netmesh_filter_knn;
/* 8.6: the root mean square of the k least distances. As knn, at most sqrt(2 + c^2 sqrt(k / (k - 1))). */
extern const netmesh_filter netmesh_filter_kdistance;
/* 8.6: a Lipschitz function of the caller's. Its certified_error is finite, at most lipschitz times the domain's
 * radius, but infinite where a value contradicts lipschitz and cut. Its certified_ratio is infinite where the function
 * is small beside its change across a cell; a distance_factor keeps it finite. NOT_FINITE: at vertex index_a. */
extern const netmesh_filter netmesh_filter_function;
/* 7.5: the distance to the points within 1 + goal.eps. Its mesh is over-refined to e = eps / (3 (1 + eps)) times f_P
 * (see netmesh_sizes) in a domain of 3.1 + 4 e enclosing radii: hundreds (D = 2) to tens of thousands (D = 3) of
 * vertices a point. With goal.ratio, the default from D = 4 on, its mesh is that of complete. On any other mesh the
 * ratio is what was found. */
extern const netmesh_filter netmesh_filter_tight;

/* Of points: the distance to them scale by scale (7.6). Well-paced subsets of points have a mesh each, one after the
 * other in the same memory, and their diagrams are joined. The context then holds a diagram and no mesh.
 *   ratio     with goal.eps at most (1 + 3 theta) (1 + eps), by over-refined meshes and the filter tight; with
 *             goal.ratio at most that, by the method certificate and the filter complete. Usually less: it is computed
 *             from how far the scales found are apart (report.scales.separation)
 *   memory    that of the largest scale, and some 100 bytes a point, whatever the spread. With bounds 130 bytes more a
 *             vertex of the largest mesh, 140 a bar and 100 KB
 *   cost      besides the meshes, points times points of their scale; with cycles about twice the time
 *   errors    INVALID_ARGUMENT (SIZES): coordinates near point index_a do not resolve the size that eps asks for */
extern const netmesh_filter netmesh_filter_scales;

/* Of points: complexes on the points themselves. Values are radii. Those of all filters but barycentric_rips are the
 * exact ones, each rounded to the nearest double, ties to even; an edge beyond the largest double is not there.
 *   size      some n^(max_degree + 2) simplices, of barycentric filters n^(k + max_degree + 1): ask netmesh_plan first
 *   errors    OUT_OF_RANGE: as of alpha; not of rips. INVALID_ARGUMENT (K): above the number of different points
 *
 * rips: Vietoris-Rips (6.4): edges enter at half their length; of points in any dimension, and of distances. Nothing
 * but edges is stored, unless cycles are wanted or there are more simplices than 62 bits can number. In degrees 0 and 1
 * of 200 points or more in the plane or in space, without pairs of length zero, edges longer than the diameter from
 * which on balls have no hole are left out, and not counted as simplices: the last death of degree 1 of alpha.
 * rips_small is the same filter without that, so that a small part links no triangulation. */
extern const netmesh_filter netmesh_filter_rips;
extern const netmesh_filter netmesh_filter_rips_small;
/* 6.4: Cech, the offsets' exact diagram. */
extern const netmesh_filter netmesh_filter_cech;
/* 8.5: d_k, exact, by nested sets of k .. k + max_degree + 1 points. k + max_degree is at most 30. */
extern const netmesh_filter netmesh_filter_barycentric_cech;
/* 8.5: the same by Rips complexes. Certified values are within 2^(1/4), the filter's own within sqrt 2. */
extern const netmesh_filter netmesh_filter_barycentric_rips;

/* Of simplices: the values that they come with. */
extern const netmesh_filter netmesh_filter_simplices;

typedef enum netmesh_values {
    NETMESH_VALUES_CERTIFIED = 0, /* the filter's values, clamped so that the certified ratio is the best possible */
    NETMESH_VALUES_THESIS = 1,    /* the filter's own values */
    NETMESH_VALUES_OPEN = 2       /* as the request needs: THESIS where an error is asked for or fitted */
} NETMESH_AN_INT netmesh_values;

/* A function f of the caller's, of any sign, with |f(x) - f(y)| <= lipschitz |x - y|. What f is beyond the mesh is for
 * the caller to answer: 7.4.4's clipping argument is proven for distances to points, for another f it is an assumption.
 * What is certified is certified of f as evaluate computes it: its roundings are not counted. */
typedef struct netmesh_function {
    uint32_t struct_bytes;
    double (*evaluate)(void* user, const double* x); /* f at x[D], finite. Called once for each vertex, in their order;
                                                        with bounds once more; with an error or fit also for sizes,
                                                        and for each mesh that is tried. Must not call into the
                                                        context */
    void* user;                                      /* handed to evaluate */
    double lipschitz;                                /* finite, >= 0 */
    double distance_factor; /* a number c with f >= d_2 / c, d_2 the distance to the second nearest point (8.6.3). 0:
                               none is known */
    double cut;             /* finite: f >= cut outside the domain ball (report.mesh.domain), and sublevel sets from
                               cut on are contractible; values are cut there */
} netmesh_function;

/* ---- what is asked of the diagram ---- */

/* What the diagram has to promise. 0: not asked for. Goals that do not go together, or that the filter does not read,
 * are refused. */
typedef struct netmesh_goal {
    double ratio; /* certified ratio of complete, basic, tight and scales at most this, by the method certificate (of
                     basic, and of others, to be named; these certify what their contract says of it). From 1.4143 on,
                     of scales above 1.4143 (1 + 3 theta); below 1.6 meshes grow fast. 0: sqrt(2 + tau) of complete,
                     and of tight and scales from D = 4 on; with fit where its ladder begins */
    double eps;   /* of tight and scales: certified ratio at most 1 + eps, in (0, 1/2]; not with ratio. 0: 1/2, where
                     there is no ratio */
    double theta; /* of scales: mediality that keeps points in one scale (3.8), in (0, 1/9]. 0: 1/9 */
    double error; /* of function: certified error at most this, > 0, in the function's unit; by sizes of the mesh (3.7):
                     close to error / lipschitz where f <= cut + error, or mesh.sizes.size where that is less */
    /* Scales of interest, with ratio: hi / lo <= focus_ratio^2 for the bounds lo and hi of every cell of a Steiner
     * vertex with hi > focus_from and lo < focus_to. With fit focus_ratio is 0: the least that the block holds. */
    double focus_ratio;          /* in (1, ratio) */
    double focus_from, focus_to; /* radii, 0 < focus_from < focus_to */
    double longer_than;          /* with fit: L > 1, bars of more than L times their birth are decided */
} netmesh_goal;

/* ---- how meshes are made ---- */

/* A method is a constant object. A program holds the code of the methods that it names, and of those that its filters
 * and fit name: svr of filters on meshes, certificate of complete, tight and fit. */
typedef struct netmesh_method netmesh_method;

/* No Steiner points: the Delaunay triangulation of the points (2.2). Cospherical points are decided by their index, so
 * the result depends on nothing but the sequence of points.
 *   cost      6 / 28 / 158 / 898 / 4264 cells made for each of uniform points, D = 2..6
 *   errors    FLAT */
extern const netmesh_method netmesh_method_delaunay;
/* The same of at most 8,192 points in the plane, for small parts: 64 bytes a point where delaunay takes 158. The
 * context then holds cells, vertices and a report, fingerprint included, for no other call. Without OK it is empty.
 *   errors    FLAT */
extern const netmesh_method netmesh_method_delaunay_small;

/* The methods below make a quality mesh: a Delaunay triangulation of points and Steiner points. Of svr, refine and
 * certificate these are in the domain's ball but for 2^-20 of it and 16 units in the last place. A vertex that is not
 * exempt has a cell of aspect ratio at most tau when clipped to the ball. They take flat points and a single point.
 *   range     coordinates of magnitude at most 2^500 (OUT_OF_RANGE). Different points are at least 2^-500 and 64 units
 *             in the last place apart (TOO_CLOSE); with a tau below 2.34, 2.43, 2.51, 2.59, 2.67 (D = 2..6)
 *             6.5 sqrt(D) (2 / (tau - 2) + 1) units, at most 2^26
 *   size      without cages it grows with the logarithm of the spread, and the more the nearer tau is to 2: around each
 *             cluster every factor of ten between distances takes some 40 / (tau - 2) vertices in the plane,
 *             200 / (tau - 2)^2 in space, 1000 / (tau - 2)^3 in R^4. Measured for tau from 2.05 to 4, in R^4 from 2.5,
 *             within a factor of 2.5
 *
 * svr: Sparse Voronoi Refinement (4.4). For a filter it refines a shell around the domain as well, as far as a
 * certified ratio of sqrt(2 + tau) needs it. */
extern const netmesh_method netmesh_method_svr;

/* NetMesh (4.5, 4.7): hierarchical, of a size that is linear in the points whatever the spread. Its cages are compact:
 * shells of 2 D vertices; each vertex's cell is clipped to the ball of its own domain; a cage's cell has an aspect
 * ratio of at most tau, too. A mesh with cages has no filter and no sizes; with `finish` it has. */
extern const netmesh_method netmesh_method_netmesh;

/* NetMesh with the cages of 4.5 and the operations of 4.7.3, D = 2, 3, 4. Whole cells have an aspect ratio of at most
 * tau, but for those of shells: 16, 42, 120 vertices, or inputs in places of theirs. The outermost cage stays, with
 * finish too. With e = .3 and r a cage's radius: other inputs are within e r of its centre or farther than r, no vertex
 * is between r and 2 r / e, and one of the shell is within .04 r of each place on the sphere of .64 r (a regular
 * polygon; the corners of an icosahedron and of its edges' middles; a 600-cell; of the outermost cage the middles of 6,
 * 36, 125 squares on each side of a cube). No filter, no sizes.
 *   errors    CHECK_FAILED: a cell at the outermost shell is above tau for each of seven radii; never seen so far */
extern const netmesh_method netmesh_method_thesis;

/* VoronoiRefine (3.2), in the bounding domain and with the boundary net of 3.5. */
extern const netmesh_method netmesh_method_refine;

/* The coarsest mesh on which the filter complete certifies goal.ratio. It has a third of the vertices of a quality mesh
 * that certifies as much, half with whole_cells. No aspect ratio is promised; the report's mesh.tau is 0. Its domain is
 * a ball a little larger than the smallest one around the points; nothing is refined outside.
 *   range     with a ratio below 2 different points are at least 64 / (ratio^2 / 2 - 1) units apart, or TOO_CLOSE.
 *             focus_from is at least 64 / k units, k = focus_ratio^2 / 2 - 1; with a focus_ratio of at most sqrt 2
 *             k = (focus_ratio^2 - 1) / (focus_ratio^2 + 1) (INVALID_ARGUMENT, FOCUS_FROM) */
extern const netmesh_method netmesh_method_certificate;

/* A sizing function: the out-radius wanted of the Voronoi cell of a mesh vertex at x[D].
 *   depends on   x alone: results are reproducible as far as it is
 *   defined      at least up to 2.2 enclosing radii from the domain's centre
 *   values       positive, at least 64 units in the last place of the coordinates (more with a tau near 2); +infinity
 *                asks for nothing. Others end the job with INVALID_ARGUMENT
 * Termination needs no more; the size bounds of 3.7.1 need it to be Lipschitz with a moderate constant. It is called a
 * few times a vertex, and must not call into the context. */
typedef double (*netmesh_size)(void* user, const double* x);

/* Over-refinement (3.7), not by the method certificate: afterwards the out-radius R_v of every clipped cell is at most
 *
 *     f(v) = min(eps f_P(v), size(user, v), at_inputs + growth d_P(v))
 *
 * f_P is the distance to the second nearest input, the point itself counted, d_P that to the nearest. 0 or null: not
 * asked for. INVALID_ARGUMENT (SIZES, SIZE_AT_INPUTS): coordinates near point index_a do not resolve the size. */
typedef struct netmesh_sizes {
    double eps;               /* finite, >= 0; the mesh has about eps^-D times as many vertices */
    double at_inputs, growth; /* finite, >= 0; growth only with at_inputs */
    netmesh_size size;
    void* user; /* handed to size; null without it */
} netmesh_sizes;

/* What is measured while a mesh is made. The mesh is as good as without; it takes several times as long. Of the methods
 * svr, netmesh, thesis and certificate. INTERNAL: an audit found a point out of its balls, or an encroached cage.
 *
 * LOCATION (4.7.2): every input that is not inserted yet is stored in all D-balls that contain it. Inputs are inserted
 * in rounds of range nets (4.7.5), each drawn anew until the largest load has halved. Of the methods svr and netmesh,
 * without a filter and without sizes.
 * QUALITY: aspect ratios, degrees and the invariants of 4.8 and 4.9 after each vertex, or cage with its whole shell,
 * until the mesh is finished (of thesis to the end, of whole cells). The mesh is the same as without. */
typedef enum netmesh_audit_what {
    NETMESH_AUDIT_LOCATION = 1,
    NETMESH_AUDIT_QUALITY = 2
} NETMESH_AN_INT netmesh_audit_what;

/* How a mesh is made. 0 and null: as the goal, the filter or the dimension has it. */
typedef struct netmesh_mesh_rules {
    const netmesh_method* method; /* null: certificate where a goal.ratio is promised, else svr */
    double tau;           /* bound on the aspect ratio R/r of Voronoi cells, finite, > 2. 0: 2.5 (D = 2, 3), 3.08 (4), 4
                             (5, 6); 7 of the method thesis, which needs 3.4 */
    double domain_factor; /* radius of the ball in which quality is promised over that of the smallest enclosing ball,
                             in [1, 8]. 0: 1 */
    double net_spacing;   /* of the method refine: how far apart the vertices of its boundary net are (3.5), over twice
                             the radius rho of the smallest enclosing ball, in [1/64, 8]. 0: 1. The domain's radius is
                             the larger of 3 rho and 2 rho ((K sqrt 2 + 1) net_spacing + 1), K = 2 tau / (tau - 2): a
                             smaller spacing has a smaller domain and more vertices on its sphere. INVALID_ARGUMENT
                             (NET_SPACING, or TAU where it is 0): its square is below 2^-51 times the domain's radius
                             times the magnitude of coordinates there, or that radius is above 2^511 */
    netmesh_sizes sizes;
    uint32_t finish;      /* 1: the methods netmesh and thesis go on to a mesh of quality tau without cages (4.7.6) */
    uint32_t whole_cells; /* 1: the method certificate refines for whole cells, also where the filter takes clipped ones
                             (clips_cells). More vertices for the same ratio; other filters certify more on it */
    uint32_t audit;       /* a union of netmesh_audit_what */
    uint32_t reserved;
} netmesh_mesh_rules;

/* ---- what is wanted besides ---- */

/* A want is a constant object. A program holds the code of the wants that it names. */
typedef struct netmesh_want netmesh_want;

/* For each bar where the true one surely is, and whether the bar is certified to exist; and the certified ratio by
 * scale. Read by netmesh_get_bar_bounds and netmesh_get_scale_step.
 *   by        filters with bounds_by_scale: the bounds of every cell, and covers within and around sublevel sets. Of
 *             scales, where points are given: each bar by the cells of its own mesh, and by what the join moves at its
 *             scale; at most 1024 steps. Others: certified_ratio, certified_error and half a unit in the last place
 *   memory    48 bytes a bar stay. Scratch: about 110 bytes a vertex, 120 a bar, and what a diagram takes. netmesh_plan
 *             counts it for the filter scales alone
 *   cost      up to eight more diagrams. Bounds that are there are not made again
 *   errors    INVALID_ARGUMENT (FUNCTION): not the function that the diagram is of */
extern const netmesh_want netmesh_bounds;

/* A representative of each bar. Read by netmesh_get_cycle. Not of barycentric filters. Of alpha the triangulation is
 * kept. Complexes on points, of distances, of simplices and of scales have cycles only when they are made with them:
 * later NO_RESULT.
 *   memory    about that of the diagram. Of alpha, and with keep_zero_pairs, the complex is listed: about 40 bytes a
 *             simplex. Cycles come on top. Of rips as much as of cech. netmesh_plan counts it for alpha and scales
 *   scales    simplices are sets of points, numbered in input order after merging. With c the certified_ratio, the set
 *             is a cycle of the Cech complex at c times the birth, no boundary before death / c, and one from c times
 *             the death on. It may be empty where death <= c^2 birth. The value of its simplices is the bar's birth */
extern const netmesh_want netmesh_cycles;

/* Diagrams for k .. k_last, or for each step of simplices, and the vines through them (6.3), in place of one diagram.
 * Read by netmesh_get_vine_point and netmesh_get_vine_ratio. The diagram at each k is that of netmesh_persist without
 * bars of zero length. Without bounds, cycles and fit.
 *
 * Filters knn and kdistance (8.6): one mesh for all k. Simplices: one complex for all steps; k is the step, from 1 on;
 * all ratios are 1. From one k to the next every value moves on a straight line, (1 - t) a + t b. Simplices of one
 * dimension are transposed in the order in which their values meet, which is decided exactly. Values that are equal at
 * a step are in the order of the list there. Where several meet at one t they are transposed by dimension, then from
 * the first to enter on; another order could exchange vines that meet in one point, and no others.
 *   memory    about 130 bytes a simplex of dimension up to max_degree + 1 (of simplices 160, and 32 bytes for each bar
 *             of each step), and the columns
 *   cost      O(log n) for each two simplices of a dimension that change their order: millions for small meshes
 *
 * Barycentric filters (8.5): one complex for all k, nested sets of k to k_last + max_degree + 1 points. Inclusion maps
 * homology for k + 1 to that for k at every scale, and vines join the bars that these maps match (Bauer and Lesnick's
 * induced matching). Where a vine is at (b, d) for k and at (b', d') for k + 1, the image of the map has the bar
 * (b', d), and it has no others: its rank from scale a to scale c is the number of vines with b' <= a and c < d. Each
 * map is matched by itself: a vine through three k says nothing of the map from the third to the first. Of
 * barycentric_rips the maps are as near to those of the places themselves as the diagrams are.
 *   errors    INVALID_ARGUMENT (K_LAST): above the number of different points, or k_last + max_degree above 30 */
extern const netmesh_want netmesh_vines;

/* The best that the block holds, of points and a filter on meshes but tight. A larger block never certifies less. What
 * comes out depends on points, request and the block's size alone. Without OK the context is empty. It names the method
 * certificate; method, tau (but with longer_than), domain_factor, sizes, audit and finish are for fit to say.
 *   ratio     refines by the certificate to 1 + (R - 1) 2^(-j/8), j = 0, 1, .., R = goal.ratio (0: 4), until one does
 *             not fit, and keeps the least certified_ratio. With focus_from and focus_to: R everywhere, the ladder for
 *             those scales, and the least certified_focus. Meshes are refined for the distance to the points; other
 *             filters are evaluated on them
 *   error     of the filter function always: the first mesh is one of quality alone, its certified_error e begins the
 *             ladder e 2^(-j/8), down to 2^-32 e; keeps the least certified_error. No ratio, no focus
 *   decide    with goal.longer_than, of complete with certified values and bounds: R everywhere (0: sqrt(2 + tau)),
 *             then scales of interest from above, where bars are undecided (see netmesh_decision_report), until none is
 *             or one does not fit. Keeps a diagram without undecided bars, or else the least decided_from. A larger
 *             block never decides less
 *   cost      besides the last run about 5.3 such runs in the plane, 3.4 in space, 2.4 in R^4; the one that does not
 *             fit; and another one where the last is not the best. A plan is of the first run
 *   errors    OUT_OF_MEMORY: not even R fits */
extern const netmesh_want netmesh_fit;

#if defined(__GNUC__)
#define NETMESH_INFINITY __builtin_inf()
#else
#define NETMESH_INFINITY (1e300 * 1e300)
#endif
#define NETMESH_OPEN UINT32_MAX /* of a number: as the filter has it */

/* A request. netmesh_default_request makes one. 0 and null: as the filter has it. What is given and not read is
 * refused, with its field: a k of alpha, a ratio beside the method svr. */
typedef struct netmesh_request {
    uint32_t struct_bytes;
    uint32_t max_degree; /* highest degree of homology. Default: NETMESH_OPEN. On meshes and triangulations, scales and
                            auto: D - 1, and more counts as that; with periods D. Of rips, cech and barycentric filters:
                            1, and at most 30. Of simplices: their dimension, whose cycles never die, and more counts as
                            that */
    netmesh_monitor monitor;
    /* The source: one of the three. None: what the context holds. */
    netmesh_points points;
    const netmesh_distances* distances;
    const netmesh_simplices* simplices;

    const netmesh_filter* filter;     /* netmesh_mesh takes none, too */
    netmesh_values values;            /* default: NETMESH_VALUES_OPEN */
    uint32_t k;                       /* neighbours, the point itself counted, of filters with needs_k. 0: 1 */
    uint32_t k_last;                  /* with vines of filters with k: the last k. 0: k */
    uint32_t keep_zero_pairs;         /* 1: finite pairs of zero length are kept; not with vines */
    const netmesh_function* function; /* of the filter function */
    double threshold;                 /* of rips, a radius >= 0: points farther apart than twice that are not joined.
                                         0 is 0. Default: infinity */
    uint64_t seed;                    /* of every random choice, where triangulations or meshes are made. Default: 1.
                                         Cells of a triangulation and exact values do not depend on it */
    netmesh_goal goal;
    netmesh_mesh_rules mesh;
    const netmesh_want* bounds; /* &netmesh_bounds or null */
    const netmesh_want* cycles; /* &netmesh_cycles or null */
    const netmesh_want* vines;  /* &netmesh_vines or null */
    const netmesh_want* fit;    /* &netmesh_fit or null */
    uint32_t keep_mesh; /* 1: of alpha keep the triangulation, too: more memory, and cells to be read. Auto and filters
                           on meshes keep theirs anyway */
    uint32_t squares;   /* 1: with weights, values are powers a, not sign(a) sqrt(|a|) */
    const netmesh_weighting* weighting; /* &netmesh_radii or &netmesh_weights, with points.weights; or null */
    const netmesh_periods* periods;     /* &netmesh_periodic, with points.lattice; or null */
} netmesh_request;

#ifdef __cplusplus
#define NETMESH_ZERO                                                                                                   \
    {}
#else
#define NETMESH_ZERO                                                                                                   \
    { 0 }
#endif

/* A request with its defaults, of the size that the caller's compiler knows: struct_bytes is set. */
static inline netmesh_request netmesh_default_request(void) {
    netmesh_request request = NETMESH_ZERO;
    request.struct_bytes = sizeof request;
    request.max_degree = NETMESH_OPEN;
    request.values = NETMESH_VALUES_OPEN;
    request.threshold = NETMESH_INFINITY;
    request.seed = 1;
    return request;
}

/* The request with nothing left open: what netmesh_persist would do; without a filter but with a method, what
 * netmesh_mesh would do. settled->struct_bytes must be set; settled may be the request itself, detail may be null. It
 * needs no context and reads no coordinate. What is settled stays as it is when it is settled again. Without a source
 * max_degree is that of six dimensions, and nothing of a mesh is filled in. mesh.tau stays 0 where goal.ratio is
 * another than sqrt(2 + tau). What function, distances and simplices point to is left to the job. O(1).
 * INVALID_ARGUMENT: detail.field contradicts the rest, or is not read; detail.message says what to do. NOT_BUILT. */
netmesh_status netmesh_settle(const netmesh_request* request, netmesh_request* settled, netmesh_detail* detail);

/* Bytes of block to plan for: enough for uniform points, an estimate for others. netmesh_plan: of netmesh_persist;
 * netmesh_plan_mesh: of netmesh_mesh. SIZE_MAX: it does not fit a size_t. 0: the request is refused, or has no source.
 *   triangulation, alpha   at most 1.2 times what 100 uniform points take, 1.1 of 1,000 and more
 *   meshes                 at most 1.4 times, of 1,000 points (D = 2) or 3,000 (3, 4) and more. Of fewer than a hundred
 *                          points one set in some hundreds takes more than the plan; in D = 5 and 6 the method refine
 *                          takes far more. A sizing function is not counted
 *   scales                 of all points in one scale; with bounds and cycles
 *   points, distances      an upper bound, as if all points were joined, but for the fill of the reduction; of rips
 *                          where it leaves edges out an estimate, as of uniform points
 *   simplices              the same; of vines with a bar for every other simplex at every step
 * Bounds, cycles and vines are counted where this is said here or at the want. Checks take more than a diagram. */
size_t netmesh_plan(const netmesh_request* request);
size_t netmesh_plan_mesh(const netmesh_request* request);

/* Polls to plan for, slices of a job, of the same requests, on the processor that calls this (a Cortex-M polls some 50
 * times as often as a desktop): on uniform points from a hundred on at most 2.5 times as many or as few, for others and
 * with weights or a kept triangulation an estimate. *most, if most is not null: no points in this number take more, as
 * derived for triangulations and alpha diagrams without periods, bounds and cycles; UINT64_MAX: no bound by the number
 * is known, or it is larger. Both are 0 where the plan is. O(1). */
uint64_t netmesh_plan_polls(const netmesh_request* request, uint64_t* most);
uint64_t netmesh_plan_mesh_polls(const netmesh_request* request, uint64_t* most);

/* The diagram, and what is wanted besides. Persistent homology over Z/2. Values of distances are radii, not squared.
 *   source       it replaces what the context held, also on failure
 *   no source    the mesh or triangulation that the context holds is filtered; it stays whole, also on failure. The
 *                diagram is replaced, also on failure. A goal, rules of meshes and a seed are refused
 *   more wanted  no source; bounds or cycles; filter, values, k, max_degree and keep_zero_pairs are those of the
 *                diagram that the context holds: they alone are made. Of a diagram by auto the filter is the one that
 *                was taken. Bounds and cycles that fail leave mesh and diagram whole
 * A request that contradicts itself changes nothing. After OUT_OF_MEMORY and CANCELLED, while a mesh or triangulation
 * that is kept is made, the context holds a Delaunay triangulation of what was inserted (report.complete is 0); later
 * what was finished. Where none is kept, and of auto and fit, the context is empty without OK.
 * INVALID_ARGUMENT, NOT_BUILT, NOT_FINITE, OUT_OF_RANGE, FLAT, TOO_CLOSE, NO_RESULT, CHECK_FAILED, NOT_A_COMPLEX,
 * OUT_OF_MEMORY, CANCELLED: when, is said at the sources, filters, methods and wants. */
netmesh_status netmesh_persist(netmesh_context* context, const netmesh_request* request);

/* The first half alone: the mesh or triangulation that the request's filter needs; without a filter a mesh for itself,
 * by mesh.method. What is of the diagram alone is not read: k, k_last, max_degree, keep_zero_pairs, keep_mesh, bounds,
 * cycles, vines, and a function without an error. With fit it is refused. It replaces what the context held, also on
 * failure; after OUT_OF_MEMORY and CANCELLED a Delaunay triangulation of what was inserted stays (report.complete is
 * 0), the other points are vertices without a cell.
 * INVALID_ARGUMENT, NOT_BUILT, NOT_FINITE, OUT_OF_RANGE, FLAT, TOO_CLOSE, CHECK_FAILED, OUT_OF_MEMORY, CANCELLED: see
 * the methods. */
netmesh_status netmesh_mesh(netmesh_context* context, const netmesh_request* request);

#ifdef __cplusplus
}
#endif
#endif
