/* Triangulations and meshes of points: made, taken over from elsewhere, read vertex by vertex. */
#ifndef NETMESH_MESH_H
#define NETMESH_MESH_H

#include <stddef.h>
#include <stdint.h>

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a triangulation or mesh is for. It decides what is meshed and what is planned for. */
typedef enum netmesh_purpose {
    NETMESH_PURPOSE_MESH = 0,    /* itself */
    NETMESH_PURPOSE_PERSIST = 1, /* persistence: of a mesh with the filters of the distance to the points or of
                                    functions, of a Delaunay triangulation with the alpha filter */
    NETMESH_PURPOSE_TIGHT = 2    /* persistence with the tight filter; of a mesh only */
} NETMESH_AN_INT netmesh_purpose;

typedef struct netmesh_delaunay_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points;      /* [point_count][D], any finite numbers; -0.0 counts as 0. Not read by the plan */
    size_t point_count;      /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;           /* of every random choice; init: 1. Cells do not depend on it; their order and time do */
    netmesh_purpose purpose; /* MESH or PERSIST; read by the plan alone */
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_delaunay_request;

/* Defaults for dimension dim. Writes request_bytes = sizeof *request. Every number is kept as the dimension; of one
 * that is not NETMESH_DIM_MIN..NETMESH_DIM_MAX the job says INVALID_ARGUMENT and names the field dim before it reads
 * anything else, and the plan is 0. So do all requests that have a dimension. */
void netmesh_delaunay_request_init(netmesh_delaunay_request* request, size_t request_bytes, uint32_t dim);

/* Bytes of block to plan for: enough for uniform points, an estimate for others; at most 1.2 times what the call takes
 * of 100 uniform points, 1.1 of 1,000 and more; checks take more. SIZE_MAX when it does not fit, 0 on an invalid
 * request. */
size_t netmesh_plan_delaunay(const netmesh_delaunay_request* request);

/* Delaunay triangulation of points. Exact duplicates are merged into the first occurrence and counted. Ties of
 * cospherical points are broken by index, so the result depends on nothing but the sequence of points. Replaces what
 * the context held, also on failure.
 * Expected cost: 6 / 28 / 158 / 898 / 4264 cells made per point for uniform points in D = 2..6.
 * INVALID_ARGUMENT, NOT_FINITE, FLAT, OUT_OF_MEMORY, CANCELLED. On the last two the context holds the Delaunay
 * triangulation of the points inserted so far (report.complete is 0) if there is one; the other points are vertices
 * without a cell. */
netmesh_status netmesh_delaunay(netmesh_context* context, const netmesh_delaunay_request* request);

typedef enum netmesh_method {
    NETMESH_METHOD_SVR = 0,       /* Sparse Voronoi Refinement (4.4) */
    NETMESH_METHOD_HIERARCHY = 1, /* NetMesh (4.5, 4.7): a hierarchical mesh, of linear size whatever the spread */
    NETMESH_METHOD_REFINE = 2     /* VoronoiRefine (3.2), in the bounding domain and with the boundary net of 3.5 */
} NETMESH_AN_INT netmesh_method;

/* Of METHOD_HIERARCHY. */
typedef enum netmesh_cage_kind {
    NETMESH_CAGES_COMPACT = 0, /* shells of 2 D vertices; cells are clipped to the balls of their domains */
    NETMESH_CAGES_THESIS = 1   /* those of 4.5 with the operations of 4.7.3, D = 2, 3, 4: shells of 16, 42, 120 vertices
                                  (or inputs that they yield to), grown and released as inputs enter; whole cells are of
                                  quality tau. An outermost cage is there too, also in a finished mesh. With e = .3 and
                                  r a cage's radius: inputs within e r of its centre, a shell vertex within .04 r of
                                  each place on the sphere of .64 r (a regular polygon; the corners of an icosahedron
                                  and of its edges' middles; a 600-cell; of the outermost cage the middles of 6, 36, 125
                                  squares on each side of a cube), nothing else from e r to 2 r / e */
} NETMESH_AN_INT netmesh_cage_kind;

/* A sizing function: the out-radius wanted of the Voronoi cell of a mesh vertex at x[D]. Must depend on x alone
 * (results are reproducible as far as it is), be defined at least up to 2.2 enclosing radii from the domain's centre,
 * positive, and nowhere below 64 units in the last place of the coordinates (more with a tau near 2, see
 * netmesh_mesh): other values end the job with INVALID_ARGUMENT. Termination needs no more; the size bounds of 3.7.1
 * need it to be Lipschitz with a moderate constant. +infinity asks for nothing. Called a few times a vertex. Must not
 * call into the context. */
typedef double (*netmesh_size)(void* user, const double* x);

/* Over-refinement (3.7): afterwards the out-radius R_v of every clipped cell is at most
 * f(v) = min(eps * f_P(v), size(user, v)), f_P the distance to the second nearest input, the point itself counted, and
 * at most what size_at_inputs and size_growth of netmesh_mesh_request say. */
typedef struct netmesh_sizes {
    double eps;        /* > 0; 0: not asked for. The mesh has about eps^-D times as many vertices */
    netmesh_size size; /* null: not asked for */
    void* user;        /* handed to size */
} netmesh_sizes;

/* Refinement by the certificate of the complete filter with certified values: the coarsest mesh whose certified ratio
 * is at most `ratio`, in place of one of aspect ratio tau. focus_ratio asks for more at scales between focus_from and
 * focus_to (radii): hi / lo <= focus_ratio^2 for the bounds (see netmesh_bound_bars) of every cell of a Steiner vertex
 * with hi > focus_from and lo < focus_to. */
typedef struct netmesh_certificate_goal {
    double ratio;                /* > sqrt 2; below about 1.6 meshes grow fast. 0: a mesh of aspect ratio tau */
    double focus_ratio;          /* in (1, ratio); 0: no scales of interest */
    double focus_from, focus_to; /* 0 < focus_from < focus_to */
} netmesh_certificate_goal;

/* LOCATION: point location as in 4.7.2. Every input that is not inserted yet is stored in all D-balls (circumscribed
 * balls) that contain it, and inputs are inserted in rounds of range nets (4.7.5), each of which is drawn from again
 * until the largest load has halved. QUALITY: aspect ratios, degrees and the invariants of 4.8 and 4.9 are measured
 * after each vertex, or cage with its whole shell, until FinishMesh begins (with cages of the thesis to the end, of
 * whole cells); K and K' until over-refinement begins. */
typedef enum netmesh_audit_what {
    NETMESH_AUDIT_LOCATION = 1,
    NETMESH_AUDIT_QUALITY = 2
} NETMESH_AN_INT netmesh_audit_what;

/* Also says, wherever a request points to it, what a mesh promises: check, analyse and load read tau, sizes,
 * certificate, size_at_inputs, size_growth, net_spacing, cage_kind and whole_cells of it. */
typedef struct netmesh_mesh_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const void* points; /* [point_count][D]. Not read by the plan */
    size_t point_count; /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;      /* of every random choice; init: 1 */
    netmesh_purpose purpose;
    netmesh_method method;
    double tau;           /* bound on the aspect ratio R/r of Voronoi cells, finite, > 2; 0: netmesh_tau says */
    double domain_factor; /* radius of the ball in which quality is promised over the radius of the smallest enclosing
                             ball, in [1, 8]; 0: 1 */
    double tight_eps;     /* of PURPOSE_TIGHT: what the tight filter promises is a certified ratio of at most
                             1 + tight_eps; in (0, 1/2]; 0: 1/2 */
    netmesh_sizes sizes;
    netmesh_certificate_goal certificate; /* for PURPOSE_PERSIST with METHOD_SVR, without sizes */
    uint32_t finish; /* 1: METHOD_HIERARCHY goes on to a mesh of quality tau without cages (4.7.6) */
    uint32_t audit;  /* a union of netmesh_audit_what, not with METHOD_REFINE; LOCATION for PURPOSE_MESH without sizes.
                        The mesh is as good as without, with QUALITY alone the same; it takes several times as long.
                        INTERNAL when an audit finds a point out of its balls or an encroached cage */
    /* Over-refinement by the distance to the nearest input, d_P: no clipped cell reaches farther than
     * size_at_inputs + size_growth * d_P(v). Finite, >= 0; size_at_inputs 0: not asked for, nor growth then. */
    double size_at_inputs, size_growth;
    /* Of METHOD_REFINE: how far apart the vertices of its boundary net are (3.5), over twice the radius rho of the
     * smallest enclosing ball, in [1/64, 8]; 0: 1. The domain's radius follows as the larger of 3 rho and
     * 2 rho ((K sqrt 2 + 1) net_spacing + 1), K = 2 tau / (tau - 2), with which all corners stay in it: smaller nets
     * have a smaller domain and more vertices on its sphere. Coordinates there must resolve the net: INVALID_ARGUMENT
     * (NET_SPACING, or TAU where that is 0) when its square is below 2^-51 times the domain's radius times their
     * magnitude, or the radius above 2^511. */
    double net_spacing;
    netmesh_cage_kind
        cage_kind; /* THESIS: D at most 4, tau given and at least 3.4, PURPOSE_MESH, no audit of location */
    /* Of a mesh refined by the certificate. 0: for cells clipped to a ball, the domain, a hair larger than the smallest
     * one around the points; nothing is refined outside, and filters with clips_cells are filtered on the nerve of the
     * clipped cells. 1: for whole cells; what other filters, which take cells whole, certify is better then. */
    uint32_t whole_cells;
    netmesh_point_format point_format; /* of points; see there */
    size_t point_stride_bytes;         /* from one of them to the next; 0: packed */
} netmesh_mesh_request;

void netmesh_mesh_request_init(netmesh_mesh_request* request, size_t request_bytes, uint32_t dim);

/* The tau that a request stands for: its own or, when that is 0, the dimension's: 2.5 (D = 2, 3), 3.08 (4), 4 (5, 6).
 * 0 when the request is not initialised. */
double netmesh_tau(const netmesh_mesh_request* request);

/* As netmesh_plan_delaunay, with the diagram of the purpose, but the fewer points there are, the more it has to leave
 * to chance: at most 1.4 times from 1,000 (D = 2) or 3,000 (3, 4) points on. Of fewer than a hundred points one set in
 * some hundreds takes more than this, and in D = 5 and 6 METHOD_REFINE takes far more. A sizing function is not
 * counted.
 */
size_t netmesh_plan_mesh(const netmesh_mesh_request* request);

/* Quality mesh of points: a Delaunay triangulation of the points and of Steiner points in which each vertex that is not
 * exempt has a Voronoi cell that, clipped to the domain ball, has aspect ratio at most tau. With METHOD_HIERARCHY,
 * unless finished, there are cages as well (see netmesh_cage), each vertex's cell is clipped to the ball of its own
 * domain, and a cage's cell has aspect ratio at most tau too. Admits coordinates of magnitude at most 2^500 and,
 * after merging duplicates, distances of at least 2^-500 and 64 units in the last place; with a tau below 2.34, 2.43,
 * 2.51, 2.59, 2.67 (D = 2..6) of 6.5 sqrt(D) (2 / (tau - 2) + 1) units, at most 2^26. Works on flat input and on a
 * single point. PURPOSE_PERSIST refines (SVR alone) a shell around the domain as well, as far as a certified ratio of
 * sqrt(2 + tau) needs it. PURPOSE_TIGHT over-refines to e = tight_eps / (3 (1 + tight_eps)) times f_P (7.5) in a
 * domain of at least 3.1 + 4 e enclosing radii: hundreds (D = 2) to tens of thousands (D = 3) of vertices a point.
 * Meshes with cages are neither for persistence nor over-refined; finished ones are.
 * Without cages a mesh grows with the logarithm of the spread, and the more the nearer tau is to 2: around each cluster
 * every factor of ten between distances takes some 40 / (tau - 2) vertices in the plane, 200 / (tau - 2)^2 in space,
 * 1000 / (tau - 2)^3 in R^4 (measured for tau from 2.05 to 4, in R^4 from 2.5, within a factor of 2.5). Two clusters of
 * a spread of 1e12 in space have 24,000 vertices at tau 2.5 and 612,000 at 2.1.
 * With certificate.ratio the mesh has a third of the vertices for the same certified ratio, half with whole_cells. No
 * aspect ratio is promised then; the report's tau is 0. For a ratio below 2 distances must be 64 / (ratio^2 / 2 - 1)
 * units, and with scales of interest focus_from must be 64 / k units, k = focus_ratio^2 / 2 - 1, or (focus_ratio^2 - 1)
 * / (focus_ratio^2 + 1) when focus_ratio is at most sqrt 2 (INVALID_ARGUMENT, FOCUS_FROM). Replaces what the context
 * held, also on failure. INVALID_ARGUMENT, NOT_FINITE, OUT_OF_RANGE, TOO_CLOSE, CHECK_FAILED (CAGES_THESIS: a cell at
 * the outermost shell is above tau whatever the radius of that; seven are tried, and never was it seen that all
 * failed), OUT_OF_MEMORY, CANCELLED; on the last two the context holds a valid Delaunay mesh of what was inserted so
 * far (report.complete is 0). */
netmesh_status netmesh_mesh(netmesh_context* context, const netmesh_mesh_request* request);

/* A mesh made elsewhere, or read from a file. */
typedef struct netmesh_load_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const double* vertices;           /* [vertex_count][D] */
    const uint8_t* markers;           /* [vertex_count]: 0 input, 1 Steiner, 2 exempt; inputs come first */
    size_t vertex_count;              /* 1 .. NETMESH_POINTS_MAX */
    const uint32_t* cells;            /* [cell_count][D+1], vertices in any order */
    size_t cell_count;                /* at most 2^29 - 2 */
    const double* domain;             /* [D+1], centre and radius; null: a Delaunay triangulation */
    const netmesh_mesh_request* mesh; /* what the mesh promises, of dimension D; null: the dimension's tau */
} netmesh_load_request;

void netmesh_load_request_init(netmesh_load_request* request, size_t request_bytes, uint32_t dim);

/* Takes a mesh over to be checked or filtered. Cells are oriented and linked here; whether it is a Delaunay
 * triangulation is what netmesh_check tells. Replaces what the context held, also on failure. O(cells).
 * INVALID_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY, CANCELLED, CHECK_FAILED when a facet has three cells or a cell has a
 * vertex twice or one that does not exist. Cells that are otherwise no triangulated ball are loaded: ALPHA and
 * netmesh_check (GEOMETRIC) refuse each of them, other jobs only those that their own work shows. */
netmesh_status netmesh_load(netmesh_context* context, const netmesh_load_request* request);

/* A cage (4.5, epsilon = 1/2): its centre, an input; inputs within half of its radius; between there and the radius its
 * shell, 2 D exempt vertices; nothing between one and four radii but shells and Steiner points of other cages beside
 * it. Its domain is its ball without the balls of the cages directly inside it; cells of a domain's vertices are
 * clipped to the ball of half of the radius. The cell of the cage is the union of its vertices' cells, its in-radius
 * as in 4.6. */
typedef struct netmesh_cage {
    uint32_t struct_bytes;
    uint32_t centre; /* vertex */
    uint32_t parent; /* index of the cage around it, NETMESH_NONE for none */
    double radius;
} netmesh_cage;

typedef struct netmesh_cages_request {
    uint32_t struct_bytes;
    uint32_t cage_bytes; /* sizeof(netmesh_cage), from one cage to the next; not below that of version 0.2 */
    netmesh_monitor monitor;
    const netmesh_cage* cages; /* [cage_count]; their struct_bytes and parents are not read. May be null for no cages */
    size_t cage_count;
} netmesh_cages_request;

/* cage_bytes: sizeof(netmesh_cage). */
void netmesh_cages_request_init(netmesh_cages_request* request, size_t request_bytes, size_t cage_bytes);

/* Adds the cages of a mesh taken over by netmesh_load, in place of those that it has; parents are found anew. Drops the
 * diagram. INVALID_ARGUMENT, NO_RESULT (no mesh with a domain), OUT_OF_MEMORY, CANCELLED, CHECK_FAILED (not a hierarchy
 * of balls about inputs); after the last three the mesh has no cages. */
netmesh_status netmesh_load_cages(netmesh_context* context, const netmesh_cages_request* request);

/* Vertices 0..inputs-1 are the input points in input order after merging, bit for bit; Steiner and exempt vertices
 * follow. O(1). INVALID_ARGUMENT: the index is past the last one, here as in all calls by index. */
typedef struct netmesh_vertex {
    uint32_t struct_bytes;
    uint32_t marker;                     /* 0 input, 1 Steiner, 2 exempt from quality */
    double coordinates[NETMESH_DIM_MAX]; /* the first D */
    uint32_t has_value;                  /* 1 after persist with a filter on meshes */
    double value;                        /* the filter value t(v) that its simplices use */
} netmesh_vertex;
netmesh_status netmesh_get_vertex(const netmesh_context* context, uint64_t index, netmesh_vertex* vertex);

/* Positively oriented: the determinant of the edge vectors from the first vertex is positive. neighbours[i] is the
 * cell opposite vertices[i], NETMESH_NONE outside. O(1). */
typedef struct netmesh_cell {
    uint32_t struct_bytes;
    uint32_t vertices[NETMESH_DIM_MAX + 1];   /* the first D + 1 */
    uint32_t neighbours[NETMESH_DIM_MAX + 1]; /* the first D + 1 */
} netmesh_cell;
netmesh_status netmesh_get_cell(const netmesh_context* context, uint64_t index, netmesh_cell* cell);

/* O(1). Cages come before those inside them. */
netmesh_status netmesh_get_cage(const netmesh_context* context, uint64_t index, netmesh_cage* cage);

#ifdef __cplusplus
}
#endif
#endif
