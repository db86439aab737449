/* netmesh: quality Delaunay/Voronoi meshes of point clouds in R^2..R^6 and their certified persistent homology,
 * inside one block of memory that the caller hands over.
 *
 * The library never allocates, has no mutable global state, and gives the same results on every compiler and
 * processor. A context lives at the start of the caller's block; nothing outside the block is written, and the block
 * may be copied byte by byte to another 16-byte aligned address and used there. Two contexts are independent.
 *
 * Life of a context:   init -> delaunay | mesh | load -> persist -> get_*        (each step may be repeated)
 *                      init -> homology | persist_points -> get_*
 *
 * "Thesis" is D. Sheehy, Mesh Generation and Geometric Persistent Homology, CMU 2011; numbers are its sections.
 * Unless said otherwise a call that does not return NETMESH_OK leaves the previous result untouched. */
#ifndef NETMESH_H
#define NETMESH_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETMESH_VERSION_MAJOR 0
#define NETMESH_VERSION_MINOR 1
#define NETMESH_VERSION_PATCH 0
#define NETMESH_DIM_MIN 2
#define NETMESH_DIM_MAX 6
#define NETMESH_DEGREE_MAX 31   /* of homology, for filtrations that are not meshes */
#define NETMESH_NONE UINT32_MAX /* no neighbour, no index */

typedef enum netmesh_status {
    NETMESH_OK = 0,
    NETMESH_INVALID_ARGUMENT = 1, /* detail.index_a: the argument's position, counted from 1 */
    NETMESH_OUT_OF_MEMORY = 2,    /* the block is too small; detail.bytes_wanted: at least this many are needed */
    NETMESH_CANCELLED = 3,        /* the poll function asked to stop */
    NETMESH_NOT_FINITE = 4,       /* point index_a has a NaN or an infinity */
    NETMESH_OUT_OF_RANGE = 5,     /* point index_a: a magnitude that meshing does not admit (see netmesh_mesh) */
    NETMESH_FLAT = 6,             /* fewer than D+1 affinely independent points: no triangulation */
    NETMESH_TOO_CLOSE = 7,        /* points index_a < index_b are distinct but closer than 64 units in the last place */
    NETMESH_NO_RESULT = 8,        /* the call needs an earlier step that has not been done */
    NETMESH_CHECK_FAILED = 9,     /* a checker found a violation; detail.message says which. Any job on a mesh taken over by
                                     netmesh_load whose cells turn out not to be a triangulated ball */
    NETMESH_FLOATING_POINT = 10,  /* the floating-point mode is not IEEE double, round to nearest, no flush to zero */
    NETMESH_INTERNAL = 11,        /* an invariant of the library does not hold: a defect, please report it */
    NETMESH_NOT_A_COMPLEX = 12 /* simplex index_a has no place in a filtered complex, detail.message says why; index_b:
                                     the earlier equal one, the face that enters later, or the vertex (counted from 0 in
                                     ascending order) that a missing face lacks */
} netmesh_status;

/* A short English phrase for a status; never null. */
const char* netmesh_status_text(netmesh_status status);

/* What the last call that failed has to say. Unused fields are 0. */
typedef struct netmesh_detail {
    netmesh_status status;
    uint64_t index_a, index_b;
    uint64_t bytes_wanted;
    const char* message; /* static text, never null */
} netmesh_detail;

typedef enum netmesh_stage {
    NETMESH_STAGE_NONE = 0,
    NETMESH_STAGE_SORT = 1,     /* spatial order, duplicates, nearest neighbours; unit: points */
    NETMESH_STAGE_DELAUNAY = 2, /* insertion; unit: points */
    NETMESH_STAGE_REFINE = 3,   /* refinement; unit: input points inserted (Steiner points come between them) */
    NETMESH_STAGE_CERTIFY = 4,  /* aspect ratios, filter values and certificate; unit: cells */
    NETMESH_STAGE_FILTER = 5,   /* filtration of an explicit complex; unit: simplices */
    NETMESH_STAGE_GRADIENT = 6, /* lower stars; unit: vertices */
    NETMESH_STAGE_REDUCE = 7,   /* columns */
    NETMESH_STAGE_CHECK = 8,    /* independent checkers; unit: cells */
    NETMESH_STAGE_ANALYSE = 9,  /* pace, integral, fatness, structure; unit: points, boxes, vertices or cells */
    NETMESH_STAGE_COUNT = 10
} netmesh_stage;

typedef struct netmesh_progress {
    netmesh_stage stage;
    uint64_t done, total;     /* in units of the stage; total may be an estimate, 0 when unknown */
    uint64_t vertices, cells; /* of the mesh so far */
} netmesh_progress;

/* Called about every 1,000 to 10,000 units of work. A non-zero return cancels: the call that polls returns
 * NETMESH_CANCELLED. Must not call into the context. */
typedef int (*netmesh_poll)(void* user, const netmesh_progress* progress);

typedef enum netmesh_method {
    NETMESH_METHOD_SVR = 0, /* Sparse Voronoi Refinement (4.4) */
    NETMESH_METHOD_NETMESH =
        1, /* NetMesh (4.5, 4.7): a hierarchical mesh, of linear size whatever the points' spread */
    NETMESH_METHOD_REFINE =
        2 /* VoronoiRefine (3.2) in the bounding domain and with the boundary net of 3.5: the reference */
} netmesh_method;

/* LOCATION: point location as in 4.7.2. Every input that is not inserted yet is stored in all D-balls (circumscribed balls) that
 * contain it, and inputs are inserted in rounds of range nets (4.7.5), each of which is drawn from again until the largest load has
 * halved. QUALITY: quality and the invariants of 4.8 and 4.9 are measured after each insertion. */
typedef enum netmesh_audit_what { NETMESH_AUDIT_LOCATION = 1, NETMESH_AUDIT_QUALITY = 2 } netmesh_audit_what;

/* A sizing function: the out-radius wanted of the Voronoi cell of a mesh vertex at x[D]. Must depend on x alone (results
 * are reproducible as far as it is), be defined at least up to 2.2 enclosing radii from the domain's centre, positive,
 * and nowhere below 64 units in the last place of the coordinates: other values end the job with INVALID_ARGUMENT.
 * Termination needs no more; the size bounds of 3.7.1 need it to be Lipschitz with a moderate constant. +infinity asks
 * for nothing. Called a few times a vertex. Must not call into the context. */
typedef double (*netmesh_size)(void* user, const double* x);

typedef struct netmesh_options {
    uint32_t struct_bytes; /* sizeof(netmesh_options); set by netmesh_options_init */
    uint32_t dim;          /* D, 2..6 */
    double tau;           /* bound on the aspect ratio R/r of Voronoi cells, finite, > 2; 0: default of the dimension */
    double domain_factor; /* radius of the ball in which quality is promised over the radius of the smallest enclosing
                               ball, in [1, 8]; 0: 1 */
    uint64_t seed;        /* of every random choice */
    double eps;        /* what the tight filter promises: a certified ratio of at most 1 + eps; in (0, 1/2]; 0: 1/2 */
    double theta;      /* mediality that keeps points in one scale (7.6), in (0, 1/9]; 0: 1/9 */
    uint32_t k;        /* neighbours, the point itself counted, of the filters KNN and KDISTANCE; 0: 1 */
    netmesh_poll poll; /* may be null */
    void* user;        /* handed to poll */
    netmesh_method method; /* of netmesh_mesh */
    uint32_t finish;       /* 1: NETMESH_METHOD_NETMESH goes on to a mesh of quality tau without cages (4.7.6) */
    /* Over-refinement (3.7): afterwards the out-radius R_v of every clipped cell is at most
     * f(v) = min(over_refine_eps * f_P(v), size(size_user, v)), f_P the distance to the second nearest input, the point
     * itself counted. R_v is taken, as everywhere, over corners inside the domain and points where Voronoi edges cross
     * its sphere; a cell with none is refined too while it reaches farther, but the report has R_v = 0 for it. */
    double over_refine_eps; /* > 0; 0: not asked for. The mesh has about over_refine_eps^-D times as many vertices */
    netmesh_size size;      /* null: not asked for */
    void* size_user;        /* handed to size */
    /* Refinement by the certificate, for NETMESH_JOB_PERSIST and the complete filter with certified values: the coarsest mesh whose
     * certified ratio is at most `ratio`, in place of one of aspect ratio tau. focus_ratio asks for more at scales
     * between focus_from and focus_to (radii): hi / lo <= focus_ratio^2 for the bounds (see netmesh_bound_bars) of every cell of a
     * Steiner vertex with hi > focus_from and lo < focus_to. */
    double ratio;                /* > sqrt 2; below about 1.6 meshes grow fast. 0: a mesh of aspect ratio tau */
    double focus_ratio;          /* in (1, ratio); 0: no scales of interest */
    double focus_from, focus_to; /* 0 < focus_from < focus_to */
    /* A union of netmesh_audit_what, for NETMESH_JOB_MESH with SVR or NETMESH without sizes. The mesh is as good as without; it
     * takes several times as long, with QUALITY about the number of cells for each vertex: for small runs. INTERNAL when an audit
     * finds a point out of its balls or an encroached cage. */
    uint32_t audit;
} netmesh_options;

/* Defaults for dimension dim (clamped to 2..6): tau 2.5 (D = 2, 3), 3.08 (4), 4 (5, 6); seed 1; no poll. */
void netmesh_options_init(netmesh_options* options, uint32_t dim);
/* The tau that options stand for: the one given or the dimension's. 0 when options are not initialised. */
double netmesh_tau(const netmesh_options* options);

typedef struct netmesh_context netmesh_context;

/* Makes a context at the start of block[0, block_bytes). block must be 16-byte aligned. Costs O(1).
 * INVALID_ARGUMENT (1: block null or misaligned, 3: context null), OUT_OF_MEMORY, FLOATING_POINT. */
netmesh_status netmesh_init(void* block, size_t block_bytes, netmesh_context** context);

/* After a byte copy of the block: the context in the copy. Contexts hold no addresses, so this is a cast and a check. */
netmesh_status netmesh_adopt(void* block, netmesh_context** context);

typedef enum netmesh_filter {
    NETMESH_FILTER_NONE = 0,
    NETMESH_FILTER_COMPLETE = 1,  /* 7.4.2, on a mesh */
    NETMESH_FILTER_BASIC = 2,     /* 7.4.1, on a mesh */
    NETMESH_FILTER_ALPHA = 3,     /* exact alpha complex, on a Delaunay triangulation of the points */
    NETMESH_FILTER_KNN = 4,       /* d_k, the distance to the k-th nearest point (8.6), on a mesh; k = 1: complete */
    NETMESH_FILTER_KDISTANCE = 5, /* root mean square of the distances to the k nearest points (8.6), on a mesh */
    NETMESH_FILTER_FUNCTION = 6,  /* any Lipschitz function (8.6), on a mesh; by netmesh_persist_function only */
    NETMESH_FILTER_TIGHT =
        7, /* 7.5, on a mesh made for NETMESH_JOB_PERSIST_TIGHT (or any other, with a weaker ratio) */
    NETMESH_FILTER_SCALES = 8, /* 7.6, from points; by netmesh_persist_scales only */
    /* on the points themselves; by netmesh_persist_points only */
    NETMESH_FILTER_RIPS = 9,              /* Vietoris-Rips complex: edges enter at half their length */
    NETMESH_FILTER_CECH = 10,             /* Cech complex: the offsets' exact diagram */
    NETMESH_FILTER_BARYCENTRIC_CECH = 11, /* 8.5: sublevel sets of the distance to the k-th nearest point, exact */
    NETMESH_FILTER_BARYCENTRIC_RIPS = 12  /* 8.5: the same within 2^(1/4), from distances alone */
} netmesh_filter;

typedef enum netmesh_values {
    NETMESH_VALUES_CERTIFIED = 0, /* the filter's values, clamped so that the certified ratio is the best possible */
    NETMESH_VALUES_THESIS = 1     /* the filter's own values */
} netmesh_values;

typedef enum netmesh_job {
    NETMESH_JOB_DELAUNAY = 1,      /* netmesh_delaunay */
    NETMESH_JOB_MESH = 2,          /* netmesh_mesh alone */
    NETMESH_JOB_PERSIST = 3,       /* netmesh_mesh for persistence, then netmesh_persist */
    NETMESH_JOB_PERSIST_ALPHA = 4, /* netmesh_delaunay, then netmesh_persist with the alpha filter */
    NETMESH_JOB_PERSIST_TIGHT = 5, /* netmesh_mesh for the tight filter and options.eps, then netmesh_persist with it */
    NETMESH_JOB_PERSIST_SCALES = 6 /* netmesh_persist_scales, all points of one scale */
} netmesh_job;

/* Bytes of block to plan for: enough for `points` uniform points, an estimate for others; a sizing function is not counted.
 * SIZE_MAX when it does not fit a size_t, 0 on an invalid argument. */
size_t netmesh_plan_bytes(netmesh_job job, const netmesh_options* options, uint64_t points);

/* Delaunay triangulation of points[n][D] (row-major, any finite doubles; -0.0 counts as 0). Exact duplicates are
 * merged into the first occurrence and counted. Ties of cospherical points are broken by index, so the result does not
 * depend on anything but the sequence of points. Replaces what the context held, also on failure.
 * Expected cost: 6 / 28 / 158 / 898 / 4264 cells made per point for uniform points in D = 2..6.
 * INVALID_ARGUMENT, NOT_FINITE, FLAT, OUT_OF_MEMORY, CANCELLED. On the last two the context holds the Delaunay
 * triangulation of the points inserted so far (report.complete is 0) if there is one. */
netmesh_status netmesh_delaunay(netmesh_context* context, const double* points, size_t n,
                                const netmesh_options* options);

/* Quality mesh of points[n][D] by options->method: a Delaunay triangulation of the points and of
 * Steiner points in which each vertex that is not exempt has a Voronoi cell that, clipped to the domain ball, has
 * aspect ratio at most tau. With NETMESH_METHOD_NETMESH, unless finished, there are cages as well (see netmesh_cage), each
 * vertex's cell is clipped to the ball of its own domain, and a cage's cell has aspect ratio at most tau too. Admits coordinates of
 * magnitude at most 2^500 and, after merging duplicates, distances of at least 2^-500 and 64 units in the last place. Works on flat input
 * and on a single point.
 * `for_job`: NETMESH_JOB_MESH; NETMESH_JOB_PERSIST to refine (SVR alone) a shell around the domain as well, as far as a
 * certified ratio of sqrt(2 + tau) needs it; NETMESH_JOB_PERSIST_TIGHT to over-refine to eps/(3 (1 + eps)) f_P (7.5) in a domain of
 * at least 3.1 + 4 eps/(3 (1 + eps)) enclosing radii. The latter has hundreds (D = 2) to tens of thousands (D = 3) of vertices a
 * point. Meshes with cages are not for persistence, and NETMESH_METHOD_NETMESH does not over-refine.
 * With options->ratio the mesh, by SVR and for NETMESH_JOB_PERSIST only, is refined by the certificate of the complete filter instead, to
 * about half of the vertices for the same ratio. No aspect ratio is promised then; report.tau is 0. For a ratio below 2 distances
 * must be 64 / (ratio^2 / 2 - 1) units, and with scales of interest focus_from must be 64 / k units, k = focus_ratio^2 / 2 - 1, or
 * (focus_ratio^2 - 1) / (focus_ratio^2 + 1) when focus_ratio is at most sqrt 2 (INVALID_ARGUMENT 5).
 * INVALID_ARGUMENT (6: the sizes asked for; index_b: a row near by), NOT_FINITE, OUT_OF_RANGE, TOO_CLOSE, OUT_OF_MEMORY,
 * CANCELLED; on the last two the context holds a valid Delaunay mesh of what was inserted so far (report.complete is 0). */
netmesh_status netmesh_mesh(netmesh_context* context, const double* points, size_t n, netmesh_job for_job,
                            const netmesh_options* options);

/* Takes over a mesh made elsewhere (or read from a file) to be checked or filtered. vertices[v][D]; markers[v] 0 input,
 * 1 Steiner, 2 exempt (inputs come first); cells[c][D+1]; domain: D centre coordinates and a radius, or null for a
 * Delaunay triangulation. Cells are oriented and linked here; whether it is a Delaunay triangulation is what
 * netmesh_check tells. CHECK_FAILED when the cells are not a triangulated ball (a facet of three cells, a bad index...). */
netmesh_status netmesh_load(netmesh_context* context, const double* vertices, const uint8_t* markers,
                            size_t vertex_count, const uint32_t* cells, size_t cell_count, const double* domain,
                            const netmesh_options* options);

/* A cage (4.5, epsilon = 1/2): its centre, an input; inputs within half of its radius; between there and the radius its shell,
 * 2 D exempt vertices; nothing between one and four radii but shells and Steiner points of other cages beside it. Its domain is its ball
 * without the balls of the cages directly inside it; cells of a domain's vertices are clipped to the ball of half of the radius. The cell
 * of the cage is the union of its vertices' cells, its in-radius as in 4.6. */
typedef struct netmesh_cage {
    uint32_t centre; /* vertex */
    uint32_t parent; /* index of the cage around it, NETMESH_NONE for none */
    double radius;
} netmesh_cage;
netmesh_status netmesh_get_cage(const netmesh_context* context, uint64_t index, netmesh_cage* cage);

/* Measures each vertex's cell in a mesh: ratios[vertices] gets its clipped aspect ratio, 0 for exempt vertices; domains[vertices]
 * the innermost cage that it is in, NETMESH_NONE for none. Scratch in the block. NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_measure_cells(netmesh_context* context, double* ratios, uint32_t* domains);

/* Adds the cages of a mesh taken over by netmesh_load, in place of those that it has; parents are found anew. Drops the
 * diagram. INVALID_ARGUMENT, NO_RESULT (no mesh with a domain), OUT_OF_MEMORY, CHECK_FAILED (not a hierarchy of balls about
 * inputs); the mesh then has no cages. */
netmesh_status netmesh_load_cages(netmesh_context* context, const netmesh_cage* cages, size_t count,
                                  const netmesh_options* options);

/* Persistent homology over Z/2 of the filtration `filter` on what the context holds, in degrees 0..max_degree
 * (at most D-1; larger is clamped). Values are radii, not squared radii. ALPHA needs a Delaunay triangulation, the others a
 * mesh without cages; one mesh serves every k. KNN and KDISTANCE take options.k. Zero-length pairs are dropped unless
 * keep_zero_pairs is not 0. Memory above the mesh: below 8 bytes a simplex, for alpha about 24 bytes a simplex plus fill.
 * INVALID_ARGUMENT (7: options.k is more than the number of different points), NO_RESULT, OUT_OF_MEMORY, CANCELLED. The mesh stays whole
 * on failure. */
netmesh_status netmesh_persist(netmesh_context* context, netmesh_filter filter, netmesh_values values,
                               uint32_t max_degree, int keep_zero_pairs, const netmesh_options* options);

/* A representative for each pair of the diagram that netmesh_persist left (netmesh_get_cycle), in about the
 * time and memory of the diagram. Of an alpha complex, and with pairs of zero length, the complex is listed simplex by
 * simplex and reduced anew: about 40 bytes a simplex above mesh and diagram. The cycles come on top.
 * INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY, CANCELLED; mesh and diagram stay. */
netmesh_status netmesh_represent(netmesh_context* context, const netmesh_options* options);

/* Persistent homology over Z/2 of any filtered simplicial complex (6.2, 6.3). Simplex i has the vertices
 * vertices[starts[i] .. starts[i + 1]), at most 32 distinct labels in any order, and enters at values[i], a finite number.
 * starts: [count + 1]. Simplices come in any order; every face must be there and enter no later. Classes of degree
 * 0..max_degree; more than the dimension counts as the dimension, whose cycles never die. Essential pairs are the Betti
 * numbers. representatives: keep a cycle for each pair (netmesh_get_cycle). Replaces what the context held, also on
 * failure. Of options only poll and user are read.
 * Memory: netmesh_homology_bytes plus fill of the reduction.
 * INVALID_ARGUMENT, NOT_FINITE (simplex index_a), NOT_A_COMPLEX, OUT_OF_MEMORY, CANCELLED; then the context is empty. */
netmesh_status netmesh_homology(netmesh_context* context, const uint32_t* vertices, const uint64_t* starts,
                                const double* values, uint64_t count, uint32_t max_degree, int keep_zero_pairs,
                                int representatives, const netmesh_options* options);

/* Bytes of block to plan for: netmesh_homology of `count` simplices with `vertices` vertices in all. */
size_t netmesh_homology_bytes(uint64_t count, uint64_t vertices);

/* Persistent homology of a filtration on points[n][D] themselves (6.4, 8.5), in degrees 0..max_degree <= 30. Filters:
 *   RIPS, CECH          all simplices of up to max_degree + 2 points (k is not read); of RIPS nothing but the edges is
 *                       stored unless representatives are asked for or there are more than 65,536 points, or
 *                       more simplices than 62 bits can number
 *   BARYCENTRIC_CECH    nested sets of k .. k + max_degree + 1 points, k >= 1, k + max_degree <= 30: the diagram of the
 *                       places within a radius of k points, each point its own first neighbour
 *   BARYCENTRIC_RIPS    the same with Rips for Cech: certified values are the filter's own times 2^(1/4), which makes the
 *                       diagram a 2^(1/4)-approximation; with the filter's own values it is a sqrt(2)-approximation
 * Values are radii. Exact duplicates are merged, counted and not counted as neighbours. representatives: keep a cycle for
 * each pair (RIPS and CECH; vertices are numbered in input order after merging). Replaces what the context held, also on
 * failure. The number of simplices grows as n^(max_degree + 2), of nested sets as n^(k + max_degree + 1): ask
 * netmesh_points_bytes first.
 * INVALID_ARGUMENT (6: k is 0 or above the number of points), NOT_FINITE, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_points(netmesh_context* context, const double* points, size_t n, netmesh_filter filter,
                                      netmesh_values values, uint32_t k, uint32_t max_degree, int keep_zero_pairs,
                                      int representatives, const netmesh_options* options);

/* Bytes of block to plan for: more than n points in any position take, but for the fill of the reduction. SIZE_MAX when
 * it does not fit a size_t, 0 on an invalid argument. RIPS with representatives takes as much as CECH. */
size_t netmesh_points_bytes(netmesh_filter filter, const netmesh_options* options, uint64_t points, uint32_t k,
                            uint32_t max_degree);
/* Persistent homology of points[n][D] scale by scale (7.6): recursively well-paced subsets, one mesh for each in the same memory with
 * the tight filter of options.eps, their diagrams joined. certified_ratio is at most (1 + 3 theta) (1 + eps), at log distance
 * 3 theta + eps from the offsets of all points; usually far less, as it is computed from how far the scales found are apart
 * (report.separation). Peak memory is that of the largest scale and some 100 bytes a point, whatever the spread; distances are
 * resolved relative to each scale. Cost besides the meshes: points times points of their scale.
 * Replaces what the context held, also on failure; the context then holds a diagram and no mesh.
 * INVALID_ARGUMENT (7: options; 8: coordinates near point index_b do not resolve the size asked for), NOT_FINITE, OUT_OF_RANGE,
 * TOO_CLOSE, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_scales(netmesh_context* context, const double* points, size_t n, netmesh_values values,
                                      uint32_t max_degree, int keep_zero_pairs, const netmesh_options* options);

/* A function f >= 0 of the caller's with |f(x) - f(y)| <= lipschitz |x - y|. Homology beyond the mesh is what the caller answers for:
 * 7.4.4's clipping argument is proven for distances to points, for a general f it is an assumption. */
typedef struct netmesh_function {
    double (*evaluate)(void* user,
                       const double* x); /* f at x[D], finite; called once for each vertex, in their order; must
                                                        not call into the context */
    void* user;                          /* handed to evaluate */
    double lipschitz;                    /* finite, >= 0 */
    double
        distance_factor; /* a c with f >= d_2 / c, d_2 the distance to the second nearest point (8.6.3), or 0: unknown */
    double cut; /* finite, >= 0: f >= cut outside the domain ball (report.domain), and the sublevel sets from cut
                                on are contractible; values are cut there */
} netmesh_function;

/* The same for the sublevel sets of a function (8.6), on a mesh. certified_ratio is infinite where f is too small for its change
 * across a Voronoi cell; a distance_factor keeps it finite.
 * INVALID_ARGUMENT (2: null, or a number that is not what it has to be), NOT_FINITE (index_a: the vertex at which f is not finite
 * or negative), NO_RESULT, OUT_OF_MEMORY, CANCELLED. The mesh stays whole on failure. */
netmesh_status netmesh_persist_function(netmesh_context* context, const netmesh_function* function,
                                        netmesh_values values, uint32_t max_degree, int keep_zero_pairs,
                                        const netmesh_options* options);

/* Budget mode: the best certified diagram of the complete filter that the context's block holds, from points on. Refines by the
 * certificate (see options->ratio) to ratios of a fixed ladder, 1 + (R - 1) 2^(-j/8), R = options->ratio or 4 when that is 0: always the
 * cells whose bounds are worst. With focus_from and focus_to (focus_ratio 0) the ratios of the ladder are asked of those
 * scales alone, and R of everything else. What fits depends on the points, the options and the block's size alone, and a larger
 * block never gives a larger ratio. Leaves mesh and diagram as netmesh_mesh and netmesh_persist with report.ratio and
 * report.focus_ratio do, and with `bounds` as netmesh_bound_bars does. Costs about seven such runs.
 * INVALID_ARGUMENT (7: options), OUT_OF_MEMORY (not even R fits), and what those two calls say. */
netmesh_status netmesh_fit(netmesh_context* context, const double* points, size_t n, uint32_t max_degree,
                           int keep_zero_pairs, int bounds, const netmesh_options* options);

/* One mesh for all k: the diagrams of the filter (KNN or KDISTANCE) for k = k_first..k_last, and the vines that connect them (6.3,
 * 8.6), by transpositions on R = D V while every simplex's value moves on a straight line from one k to the next. The diagram at
 * each k is that of netmesh_persist. Replaces the diagram.
 * Memory above the mesh: about 130 bytes a simplex of dimension up to max_degree + 1, and the columns. Time: O(log n) for each two
 * simplices of a dimension that change their order between two k; that is millions for small meshes already.
 * INVALID_ARGUMENT (2: filter, 3, 4: not 1 <= k_first <= k_last, 5: values, 7: k_last is more than the number of
 * different points), NO_RESULT, OUT_OF_MEMORY,
 * CANCELLED. The mesh stays whole on failure. */
netmesh_status netmesh_vineyard(netmesh_context* context, netmesh_filter filter, uint32_t k_first, uint32_t k_last,
                                netmesh_values values, uint32_t max_degree, const netmesh_options* options);

typedef enum netmesh_check_what {
    NETMESH_CHECK_COMBINATORIAL = 1, /* neighbours mutual, facets shared by two, the hull a sphere */
    NETMESH_CHECK_GEOMETRIC = 2,     /* every cell positively oriented, exactly */
    NETMESH_CHECK_DELAUNAY = 4,      /* every interior facet locally Delaunay, the hull convex, exactly */
    NETMESH_CHECK_QUALITY =
        8, /* clipped aspect ratios recomputed, at most tau; sizes likewise (meshes only). With cages
                                        the ratios of the hierarchy, and that no cage is encroached (4.5) */
    NETMESH_CHECK_BOUNDS = 16, /* the bounds of netmesh_analyse: violated ones of chapters 3 (meshes only) and 5 */
    NETMESH_CHECK_ALL = 31
} netmesh_check_what;

/* Independent checkers: nothing that they read was cached by the code that made the result. O(cells).
 * `what`: a union of netmesh_check_what; tau and sizes are taken from options; with options->ratio QUALITY checks what refinement
 * by the certificate promises in their place. CHECK_FAILED, OUT_OF_MEMORY, NO_RESULT. */
netmesh_status netmesh_check(netmesh_context* context, uint32_t what, const netmesh_options* options);

typedef enum netmesh_analyse_what {
    NETMESH_ANALYSE_SIZE = 1, /* a mesh only */
    NETMESH_ANALYSE_STRUCTURE = 2,
    NETMESH_ANALYSE_FATNESS = 4,
    NETMESH_ANALYSE_ALL = 7
} netmesh_analyse_what;

/* Voronoi cells and what their fatness says about them (5); beta = out-radius / in-radius of a cell, its smallest enclosing
 * and largest inscribed ball. Everything counts vertices of the part only. */
typedef struct netmesh_fatness {
    uint64_t cells;
    double beta_max, beta_mean;
    double aspect_ratio_max; /* the same with both balls about the vertex, cells not clipped */
    uint64_t edges, degree_max;
    double edges_bound;        /* 5.3.1: (4 beta)^D cells */
    double faces, faces_bound; /* at least the simplices of dimension 1 to D; 5.3.2: (4 beta)^(D^2) cells */
    double degree_share;       /* 5.3.3: largest degree over (8 beta)^D (floor(log2 aspect ratio) + 1); at most 1 */
    double planar_share;       /* 5.4.5: largest degree over 6 pi / arcsin(1 / (4 beta)); at most 1; 0 for D > 2 */
    double corners_share;      /* 5.5.1: what corners of a cell are at least over what they are, largest; at most 1 */
} netmesh_fatness;

typedef struct netmesh_analysis {
    uint32_t struct_bytes; /* in: sizeof(netmesh_analysis) */
    uint32_t what;         /* what was analysed; figures of other kinds are 0 */
    uint64_t fingerprint;  /* of all figures; equal on every platform */
    /* Size (3.4, 3.6, 3.8): theta_i is the distance of the i-th input to the nearest before it over that to the second
     * nearest, in the ordering of netmesh_well_paced_order. */
    uint64_t size; /* |M|: vertices that are not exempt */
    /* With cages the next two say nothing (0, infinity), nor does feature_ratio_bound (infinity): quality is that of domains. */
    double size_lower;          /* every mesh of aspect ratio tau on this domain has more vertices (3.4.2) */
    double size_upper;          /* every mesh of this feature_ratio has fewer (3.4.1) */
    double feature_ratio;       /* largest f_P(v) / f_M(v), distances to the second nearest input and vertex */
    double feature_ratio_bound; /* by 3.3.2, where inputs are yielded to, and 3.7.1; infinite where they say nothing */
    double theta,
        theta_limit;      /* least theta_i; no ordering that begins with a diameter has a least one above the limit */
    double theta_log_sum; /* sum of ln(1 / theta_i), i >= 3: the mesh size up to constants and O(n) (3.8.1) */
    /* Bounds on the integral of f_P^-D over balls about the domain's centre: the domain; what also contains all vertices'
     * in-balls; what contains three diameters about each input. */
    double radius[3], integral_lower[3], integral_upper[3];
    double pace_lower, pace_upper; /* what 3.8.7 and 3.8.5 say about the last */
    uint64_t boxes;                /* where f_P was evaluated */
    /* Structure (4.8.1, 4.11) */
    uint64_t degree_max, star_max; /* neighbours and cells of a vertex that is not on the hull */
    double degree_mean, star_mean;
    uint64_t ply_points, ply_max; /* circumscribed balls that contain a point: barycentres, centres in the domain */
    double ply_mean;
    uint64_t balls, intersections_max; /* other circumscribed balls that meet one */
    double intersections_mean;
    /* Fatness (5): cells of vertices neither exempt nor on the hull, whole; those of them inside the domain; all clipped to
     * the domain (balls of corners; nothing is bounded by them) */
    netmesh_fatness bounded, inside;
    uint64_t clipped_cells;
    double clipped_beta_max, clipped_beta_mean;
} netmesh_analysis;

/* Analyses what the context holds. `what`: a union of netmesh_analyse_what. tolerance: wanted upper / lower - 1 of the
 * integrals; 0: 0.1, 0.25, 1, 4, 16 for D = 2..6; large inputs, and the boundary in high D, get less. tau and sizes are taken from
 * options, as are those of the poll. Scratch: 8 to 40 bytes a vertex.
 * INVALID_ARGUMENT, NO_RESULT (no triangulation; SIZE without a mesh), OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_analyse(netmesh_context* context, uint32_t what, double tolerance,
                               const netmesh_options* options, netmesh_analysis* analysis);

/* An ordering order[inputs] of the input vertices, from one far from input 0, always one of those farthest from all before,
 * and its theta[inputs] (may be null; 1 for the first two). It is theta-well-paced (3.8) for its least theta_i, and no
 * ordering that begins with a diameter is so for more than 2 theta / (1 - 3 theta), theta < 1/5. O(n log n) on inputs of
 * moderate spread. Distances must have squares that a double holds, as those of meshes do.
 * INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_well_paced_order(netmesh_context* context, uint32_t* order, double* theta);

/* theta[inputs] of a given permutation order[inputs] of the input vertices. INVALID_ARGUMENT (2: no permutation), NO_RESULT,
 * OUT_OF_MEMORY. */
netmesh_status netmesh_pace(netmesh_context* context, const uint32_t* order, double* theta);

typedef enum netmesh_predicate_stage {
    NETMESH_PREDICATE_CACHED = 0,  /* decided by a cached circumsphere and its error bound */
    NETMESH_PREDICATE_FLOAT = 1,   /* floating-point determinant with an error bound */
    NETMESH_PREDICATE_INTEGER = 2, /* exact arithmetic of limited width */
    NETMESH_PREDICATE_EXACT = 3,   /* exact arithmetic of full width */
    NETMESH_PREDICATE_TIE = 4,     /* exactly degenerate, decided by the symbolic perturbation */
    NETMESH_PREDICATE_STAGES = 5
} netmesh_predicate_stage;

#define NETMESH_ROUNDS_MAX 32

/* What the audits of options.audit found; 0 where not asked for. */
typedef struct netmesh_audit {
    uint32_t what; /* a union of netmesh_audit_what */
    /* LOCATION. Load: points in a D-ball. */
    uint32_t rounds, nets, nets_max;   /* samples drawn, in all and in one round */
    uint32_t load[NETMESH_ROUNDS_MAX]; /* largest when each round begins; 0 after the last */
    uint32_t ply_max;                  /* most D-balls that a point was in */
    double ply_mean;                   /* D-balls that a point was in when its turn came */
    uint32_t touches_max;              /* most insertions that moved a point or looked whether to move it (4.13) */
    double touches_mean, tests_mean;   /* tests: the same for each new D-ball */
    /* QUALITY: worst of all intermediate meshes. f_P: distance to the second nearest inserted input of the domain. */
    uint32_t meshes;
    double aspect_ratio_max;                       /* of vertices and cages, definition 4.5 */
    double feature_ratio;                          /* K of the feature size invariant: f_P(v) / f_M(v) */
    double cage_ratio, steiner_ratio, input_ratio; /* K' of the insertion radius invariant */
} netmesh_audit;

typedef struct netmesh_report {
    uint32_t struct_bytes; /* in: sizeof(netmesh_report) */
    uint32_t dim;
    uint32_t is_mesh;  /* 1 after mesh (or load with a domain), 0 after delaunay */
    uint32_t complete; /* 1 when the job ran to its end, 0 after OUT_OF_MEMORY or CANCELLED */
    /* input */
    uint64_t points, duplicates;
    uint64_t input_fingerprint; /* of the values only */
    /* mesh */
    uint64_t vertices, inputs, steiner, exempt; /* vertices = inputs + steiner + exempt */
    uint64_t cells, cells_created;
    double tau;              /* bound asked for; 0 for a Delaunay triangulation or a mesh refined by the certificate */
    double aspect_ratio_max; /* actual worst clipped aspect ratio over vertices that are not exempt; 0 if none */
    double domain[NETMESH_DIM_MAX + 1]; /* centre, radius at index D; radius 0 for a Delaunay triangulation */
    netmesh_method method;              /* of the mesh; SVR after load */
    uint64_t cages, cages_made;         /* of a hierarchical mesh; made: those released again are counted too */
    uint64_t touches; /* NETMESH_METHOD_NETMESH: inputs looked at, cells and domains passed by point location */
    /* diagram */
    uint32_t has_diagram;
    netmesh_filter filter;
    netmesh_values values;
    uint32_t max_degree;
    uint32_t k;                                 /* of the filters KNN, KDISTANCE and the barycentric ones, else 0 */
    uint64_t pairs[NETMESH_DEGREE_MAX + 1];     /* per degree, essential ones included */
    uint64_t essential[NETMESH_DEGREE_MAX + 1]; /* per degree: the Betti numbers of the whole complex */
    uint64_t simplices;     /* of the filtered complex; RIPS: of dimension up to max(1, max_degree) */
    double certified_ratio; /* c >= 1: log-bottleneck distance to the diagram of the offsets (of the sublevel sets of
                                   the function of KNN, KDISTANCE and FUNCTION) is at most ln c */
    double certified_ratio_best; /* the best ratio that any filter values on this mesh can certify (certified values) */
    double certified_from;       /* scale from which the ratio holds: 0, or r_P for the basic filter */
    /* scales: how many, the least E = (distance from a scale's representative to the next point of the scale above) / (twice the
     * radius of the scale), at least (1 - theta) / (2 theta), infinity for one scale; offsets are within E / (E - 1). Points and
     * vertices of the largest scale; `simplices` counts those of all. */
    uint64_t scales;
    double separation;
    uint64_t scale_points_max, scale_vertices_max, scale_vertices;
    /* vineyard; filter, values, max_degree and simplices are its, certified_ratio is the largest */
    uint32_t has_vineyard;
    uint32_t k_first, k_last;
    uint64_t vines, vine_points, transpositions;
    /* cost */
    uint64_t block_bytes, peak_bytes, used_bytes;
    uint64_t predicate_calls[NETMESH_PREDICATE_STAGES]; /* in-ball decisions ended in each stage */
    uint64_t orient_calls[NETMESH_PREDICATE_STAGES];
    uint64_t fingerprint;   /* of mesh and diagram; equal on every platform and for every block size */
    double over_refine_eps; /* asked for */
    double size_ratio_max;  /* worst R_v / f(v) of over-refinement, at most 1; 0 when none was asked for */
    double ratio;           /* asked for of a mesh refined by the certificate, else 0 */
    double focus_ratio, focus_from, focus_to; /* likewise */
    netmesh_audit audit;
} netmesh_report;

netmesh_status netmesh_get_report(const netmesh_context* context, netmesh_report* report);
netmesh_detail netmesh_get_detail(const netmesh_context* context);

/* Vertices 0..inputs-1 are the input points in input order after merging, bit for bit; Steiner and exempt vertices
 * follow. O(1) each; out-of-range indices give INVALID_ARGUMENT. */
typedef struct netmesh_vertex {
    double coordinates[NETMESH_DIM_MAX]; /* the first D */
    uint32_t marker;                     /* 0 input, 1 Steiner, 2 exempt from quality */
    uint32_t has_value;                  /* 1 after persist with complete or basic */
    double value;                        /* the filter value t(v) that its simplices use */
} netmesh_vertex;
netmesh_status netmesh_get_vertex(const netmesh_context* context, uint64_t index, netmesh_vertex* vertex);

/* Positively oriented: the determinant of the edge vectors from the first vertex is positive. neighbours[i] is the
 * cell opposite vertices[i], NETMESH_NONE outside. */
typedef struct netmesh_cell {
    uint32_t vertices[NETMESH_DIM_MAX + 1];
    uint32_t neighbours[NETMESH_DIM_MAX + 1];
} netmesh_cell;
netmesh_status netmesh_get_cell(const netmesh_context* context, uint64_t index, netmesh_cell* cell);

/* Pairs sorted by degree, birth, death; death is +infinity for an essential class. */
typedef struct netmesh_pair {
    uint32_t degree;
    double birth, death;
} netmesh_pair;
netmesh_status netmesh_get_pair(const netmesh_context* context, uint64_t index, netmesh_pair* pair);

/* A representative of pair `pair`: a set of simplices of the pair's degree whose boundary is zero, the last of which
 * enters at the pair's birth, and which is a boundary from the pair's death on. In degree 0: a vertex and, when the pair
 * dies, an older one that it is then connected to. get_cycle tells the number of simplices, get_cycle_simplex one of them,
 * in no particular order; O(1) and O(degree^2). NO_RESULT when no representatives were asked for. */
typedef struct netmesh_simplex {
    uint32_t vertices[NETMESH_DEGREE_MAX + 1]; /* ascending; the first degree + 1 */
    double value;
} netmesh_simplex;
netmesh_status netmesh_get_cycle(const netmesh_context* context, uint64_t pair, uint64_t* simplices);
netmesh_status netmesh_get_cycle_simplex(const netmesh_context* context, uint64_t pair, uint64_t index,
                                         netmesh_simplex* simplex);

typedef enum netmesh_scale {
    NETMESH_SCALE_PLAIN = 0, /* differences of radii */
    NETMESH_SCALE_LOG = 1    /* differences of their logarithms */
} netmesh_scale;

#define NETMESH_ALL_DEGREES UINT32_MAX

/* PLAIN: value is the distance, exponent 0. LOG: value * 2^exponent is the ratio e^distance, value in [1, 2). Infinite:
 * value is +infinity. The exact distance (ratio), rounded once. */
typedef struct netmesh_distance {
    double value;
    int32_t exponent;
} netmesh_distance;

/* Bytes of scratch that netmesh_bottleneck needs for diagrams of so many pairs, about 310 a pair; SIZE_MAX when
 * they do not fit or there are more than 2^25 pairs. */
size_t netmesh_bottleneck_bytes(uint64_t count_a, uint64_t count_b);

/* Bottleneck distance (6.5) between two diagrams in one degree or, with NETMESH_ALL_DEGREES, the largest of all degrees:
 * the least d for which pairs can be matched one to one, each moved by at most d in birth and in death, and unmatched
 * pairs are at most 2 d long. Essential pairs are matched to essential pairs by birth; in LOG scale pairs born at 0 are
 * matched only to pairs born at 0. Where their numbers differ the distance is infinite. Pairs may come in any order;
 * birth is finite (and not negative in LOG scale), death >= birth.
 * scratch: 16-byte aligned, of at least netmesh_bottleneck_bytes. No context is needed. poll may be null; it can only
 * cancel, its progress is empty. Expected cost about O(n^1.5 log n). INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_bottleneck(const netmesh_pair* a, size_t count_a, const netmesh_pair* b, size_t count_b,
                                  uint32_t degree, netmesh_scale scale, void* scratch, size_t scratch_bytes,
                                  netmesh_poll poll, void* user, netmesh_distance* distance);
/* For each bar where the true one surely is, from the bounds of every cell instead of one ratio; whether the bar surely stands for
 * a class of the true diagram; and the ratio as a function of scale. Filters COMPLETE, BASIC, TIGHT, KNN and KDISTANCE: by scale,
 * and by covers within and around the sublevel sets, at the cost of up to eight more diagrams; ALPHA, SCALES, FUNCTION: by the
 * certified ratio. The numbers stay with the diagram: 48 bytes a bar. Scratch: about 110 bytes a vertex, 120 a bar, and what a diagram
 * takes; netmesh_plan_bytes does not count it. The diagram stays whole on failure.
 * NO_RESULT (no diagram), INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_options* options);
typedef struct netmesh_bar_bounds {
    double birth_low, birth_high, death_low, death_high; /* contain the true birth and death of a bar that is matched */
    double
        certain_after; /* psi(phi(birth)), certificates hold near the scale `birth` within sqrt(certain_after / birth) */
    uint32_t certain;  /* 1: surely real: all bars with 1 belong to different true bars within their bounds. Surely so when death >
                          certain_after, often for other reasons */
} netmesh_bar_bounds;
netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds);
/* The certified ratio as a function of scale, after netmesh_bound_bars: for alpha from `from` up to the next step's `from` it is
 * min(certified_ratio, sqrt(max(reach, alpha) / alpha)), before the first step 1. Steps ascend in `from` and in `reach`. */
typedef struct netmesh_scale_step {
    double from, reach; /* radii; reach may be infinite */
    double ratio;       /* at alpha = from, the largest of the step */
} netmesh_scale_step;
netmesh_status netmesh_get_scale_step(const netmesh_context* context, uint64_t index, netmesh_scale_step* step);

/* Where a vine is at one k: a pair of that k's diagram. Sorted by vine, then k; vines are numbered from 0 by degree, the first k at
 * which they have a length, birth and death there. A vine that loses its length and gets it again keeps its number. */
typedef struct netmesh_vine_point {
    uint32_t vine, degree, k;
    double birth, death; /* death is +infinity for an essential class */
} netmesh_vine_point;
netmesh_status netmesh_get_vine_point(const netmesh_context* context, uint64_t index, netmesh_vine_point* point);
/* The certified ratio of the diagram at one k of the vineyard. */
netmesh_status netmesh_get_vine_ratio(const netmesh_context* context, uint32_t k, double* ratio);

#ifdef __cplusplus
}
#endif
#endif
