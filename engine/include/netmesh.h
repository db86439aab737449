/* netmesh: quality Delaunay/Voronoi meshes of point clouds in R^2..R^6 and their certified persistent homology,
 * inside one block of memory that the caller hands over.
 *
 * The library never allocates, has no mutable global state, and gives the same results on every compiler and
 * processor. A context lives at the start of the caller's block; nothing outside the block is written, and the block
 * may be copied byte by byte to another 16-byte aligned address and used there. Two contexts are independent.
 *
 * Chapters: 1 context, 2 mesh, 3 persistence, 4 other complexes, 5 distances, 6 reports.
 *
 * Life of a context:   init -> delaunay | mesh | load -> persist | vineyard -> bound_bars, represent -> get_*
 *                      init -> fit | persist_scales | persist_points | homology | value_vineyard -> get_*
 *
 * Requests. A job takes the context and one request, a struct that its init call fills with defaults:
 *
 *     netmesh_mesh_request request;
 *     netmesh_mesh_request_init(&request, sizeof request, 3);
 *     request.points = points;
 *     request.point_count = n;
 *     status = netmesh_mesh(context, &request);
 *
 * Sizes of structs. Every struct that crosses this interface begins with its size in bytes as the caller's compiler
 * saw it: an init call writes it, and in structs for results the caller does (pair.struct_bytes = sizeof pair). It is
 * the promise that programs and libraries of different versions go together: structs only ever grow at their end.
 * A struct smaller than the library's is taken as it is and what is missing counts as 0, which is the default of every
 * field that a later version adds; a larger one is taken when all that this library does not know is 0. Of structs for
 * results nothing past struct_bytes is written. The members of a struct that are structs without a size of their own
 * keep their layout; a part of a report has `reserved` room for what is added to it.
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

/* ------------------------------------------------------------------------------------------------- 1 context ---- */

#define NETMESH_VERSION_MAJOR 0
#define NETMESH_VERSION_MINOR 2
#define NETMESH_VERSION_PATCH 0
/* Versions as numbers that compare as the versions do. */
#define NETMESH_VERSION_NUMBER(major, minor, patch) (((uint32_t)(major) << 16) | ((uint32_t)(minor) << 8) | (patch))
#define NETMESH_VERSION NETMESH_VERSION_NUMBER(NETMESH_VERSION_MAJOR, NETMESH_VERSION_MINOR, NETMESH_VERSION_PATCH)

#define NETMESH_DIM_MIN 2
#define NETMESH_DIM_MAX 6
#define NETMESH_DEGREE_MAX 31          /* of homology, for filtrations that are not meshes */
#define NETMESH_NONE UINT32_MAX        /* no neighbour, no index */
#define NETMESH_POINTS_MAX (1ul << 28) /* points or vertices of one job */

/* The version of the library, which may differ from that of this header: a NETMESH_VERSION_NUMBER, "0.2.0". */
uint32_t netmesh_version(void);
const char* netmesh_version_text(void);

typedef enum netmesh_status {
    NETMESH_OK = 0,
    NETMESH_INVALID_ARGUMENT = 1, /* detail.field says which field; index_a: the row concerned, where there is one */
    NETMESH_OUT_OF_MEMORY = 2,    /* the block is too small; detail.bytes_wanted: at least this many are needed */
    NETMESH_CANCELLED = 3,        /* the poll function asked to stop */
    NETMESH_NOT_FINITE = 4,       /* point (simplex, vertex) index_a has a NaN or an infinity */
    NETMESH_OUT_OF_RANGE = 5,     /* point index_a: a magnitude that meshing does not admit (see netmesh_mesh) */
    NETMESH_FLAT = 6,             /* fewer than D+1 affinely independent points: no triangulation */
    NETMESH_TOO_CLOSE = 7,        /* points index_a < index_b are distinct but closer than 64 units in the last place */
    NETMESH_NO_RESULT = 8,        /* the call needs an earlier step that has not been done */
    NETMESH_CHECK_FAILED = 9,     /* a checker found a violation; detail.message says which. Also from any job on a mesh
                                     taken over by netmesh_load whose cells are not a triangulated ball */
    NETMESH_FLOATING_POINT = 10,  /* the floating-point mode is not IEEE double, round to nearest, no flush to zero */
    NETMESH_INTERNAL = 11,        /* an invariant of the library does not hold: a defect, please report it */
    NETMESH_NOT_A_COMPLEX = 12    /* simplex index_a has no place in a filtered complex; detail.fault says why */
} netmesh_status;

/* C lets a compiler make enumerations shorter than an int (-fshort-enums, the habit of some ARM toolchains). The
 * library is built with ints, and a program whose structs differ from its own must not compile. */
typedef char netmesh_enumerations_are_ints[sizeof(netmesh_status) == sizeof(int) && sizeof(int) == 4 ? 1 : -1];

/* A short English phrase for a status; never null. */
const char* netmesh_status_text(netmesh_status status);

/* What an error is about: a field of a request, or another argument. A later version only adds to the end. */
typedef enum netmesh_field {
    NETMESH_FIELD_NONE = 0,
    NETMESH_FIELD_REQUEST,      /* the request is null */
    NETMESH_FIELD_STRUCT_BYTES, /* of the request, or of a struct that it points to: not set, or too new */
    NETMESH_FIELD_RESULT,       /* the struct or array for the result is null, or its struct_bytes are not set */
    /* what the data is */
    NETMESH_FIELD_DIM,
    NETMESH_FIELD_POINTS,
    NETMESH_FIELD_POINT_COUNT,
    NETMESH_FIELD_VERTICES,
    NETMESH_FIELD_VERTEX_COUNT,
    NETMESH_FIELD_MARKERS,
    NETMESH_FIELD_CELLS,
    NETMESH_FIELD_CELL_COUNT,
    NETMESH_FIELD_DOMAIN,
    NETMESH_FIELD_CAGES,
    NETMESH_FIELD_CAGE_COUNT,
    NETMESH_FIELD_CAGE_BYTES,
    NETMESH_FIELD_STARTS,
    NETMESH_FIELD_ENTRIES,
    NETMESH_FIELD_SIMPLEX_COUNT,
    NETMESH_FIELD_ORDER,
    NETMESH_FIELD_THETAS,
    NETMESH_FIELD_PAIRS_A,
    NETMESH_FIELD_PAIRS_B,
    NETMESH_FIELD_PAIR_BYTES,
    /* meshes */
    NETMESH_FIELD_MESH, /* the mesh request that another request points to */
    NETMESH_FIELD_PURPOSE,
    NETMESH_FIELD_METHOD,
    NETMESH_FIELD_TAU,
    NETMESH_FIELD_DOMAIN_FACTOR,
    NETMESH_FIELD_TIGHT_EPS,
    NETMESH_FIELD_SIZES, /* sizes that were asked for, near point index_a where they cannot be met */
    NETMESH_FIELD_RATIO,
    NETMESH_FIELD_FOCUS_RATIO,
    NETMESH_FIELD_FOCUS_FROM,
    NETMESH_FIELD_FOCUS_TO,
    NETMESH_FIELD_AUDIT,
    /* persistence */
    NETMESH_FIELD_FILTER,
    NETMESH_FIELD_VALUES,
    NETMESH_FIELD_K,
    NETMESH_FIELD_K_FIRST,
    NETMESH_FIELD_K_LAST,
    NETMESH_FIELD_MAX_DEGREE,
    NETMESH_FIELD_REPRESENTATIVES,
    NETMESH_FIELD_FUNCTION,
    NETMESH_FIELD_LIPSCHITZ,
    NETMESH_FIELD_DISTANCE_FACTOR,
    NETMESH_FIELD_CUT,
    NETMESH_FIELD_EPS,
    NETMESH_FIELD_THETA,
    /* checks, analyses, distances */
    NETMESH_FIELD_WHAT,
    NETMESH_FIELD_TOLERANCE,
    NETMESH_FIELD_SCALE,
    NETMESH_FIELD_SCRATCH,
    NETMESH_FIELD_SIZE_AT_INPUTS,
    NETMESH_FIELD_SIZE_GROWTH,
    NETMESH_FIELD_NET_SPACING,
    NETMESH_FIELD_CAGE_KIND,
    NETMESH_FIELD_STEP_COUNT,
    NETMESH_FIELD_COUNT
} netmesh_field;

/* The field's name as it stands in the requests, "tau"; never null. */
const char* netmesh_field_text(netmesh_field field);

/* Why simplex index_a has no place in a filtered complex. */
typedef enum netmesh_fault {
    NETMESH_FAULT_NONE = 0,
    NETMESH_FAULT_SIZE,         /* it has no vertices or more than 32 */
    NETMESH_FAULT_TOO_MANY,     /* it is one of more than 2^31 - 1 of its dimension */
    NETMESH_FAULT_VERTEX_TWICE, /* it has a vertex twice */
    NETMESH_FAULT_LISTED_TWICE, /* index_b: the earlier simplex that it is equal to */
    NETMESH_FAULT_FACE_MISSING, /* index_b: the vertex, from 0 in ascending order, that the missing face lacks */
    NETMESH_FAULT_FACE_LATER    /* index_b: the face that enters later */
} netmesh_fault;

/* What the last call that failed has to say. Unused fields are 0. */
typedef struct netmesh_detail {
    uint32_t struct_bytes;
    netmesh_status status;
    netmesh_field field; /* of INVALID_ARGUMENT */
    netmesh_fault fault; /* of NOT_A_COMPLEX */
    uint64_t index_a, index_b;
    uint64_t bytes_wanted;
    const char* message; /* static text, never null once the struct has been filled */
    uint64_t step; /* of netmesh_value_vineyard, of NOT_A_COMPLEX and NOT_FINITE: the step at fault, from 1 on; 0: the
                      complex itself */
} netmesh_detail;

typedef struct netmesh_context netmesh_context;

/* Makes a context at the start of block[0, block_bytes). block must be 16-byte aligned. Costs O(1).
 * INVALID_ARGUMENT (block or context null, block misaligned), OUT_OF_MEMORY, FLOATING_POINT. */
netmesh_status netmesh_init(void* block, size_t block_bytes, netmesh_context** context);

/* After a byte copy of the block: the context in the copy. Contexts hold no addresses, so this is a cast and a check.
 * */
netmesh_status netmesh_adopt(void* block, netmesh_context** context);

/* What the context's last call said. INVALID_ARGUMENT: the context is none, or detail null or without a size. */
netmesh_status netmesh_get_detail(const netmesh_context* context, netmesh_detail* detail);

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
    uint32_t struct_bytes; /* of the library's struct */
    netmesh_stage stage;
    uint64_t done, total;     /* in units of the stage; total may be an estimate, 0 when unknown */
    uint64_t vertices, cells; /* of the mesh so far */
} netmesh_progress;

/* Called about every 1,000 to 10,000 units of work. A non-zero return cancels: the call that polls returns
 * NETMESH_CANCELLED. Must not call into the context. */
typedef int (*netmesh_poll)(void* user, const netmesh_progress* progress);

/* Who watches a job; part of every request. */
typedef struct netmesh_monitor {
    netmesh_poll poll; /* may be null */
    void* user;        /* handed to poll */
} netmesh_monitor;

/* ---------------------------------------------------------------------------------------------------- 2 mesh ---- */

/* What a triangulation or mesh is for. It decides what is meshed and what is planned for. */
typedef enum netmesh_purpose {
    NETMESH_PURPOSE_MESH = 0,    /* itself */
    NETMESH_PURPOSE_PERSIST = 1, /* persistence: of a mesh with the filters of the distance to the points or of
                                    functions, of a Delaunay triangulation with the alpha filter */
    NETMESH_PURPOSE_TIGHT = 2    /* persistence with the tight filter; of a mesh only */
} netmesh_purpose;

typedef struct netmesh_delaunay_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const double* points;    /* [point_count][D], any finite doubles; -0.0 counts as 0. Not read by the plan */
    size_t point_count;      /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;           /* of every random choice; init: 1. The result does not depend on it, time does */
    netmesh_purpose purpose; /* MESH or PERSIST; read by the plan alone */
} netmesh_delaunay_request;

/* Defaults for dimension dim. Writes request_bytes = sizeof *request. */
void netmesh_delaunay_request_init(netmesh_delaunay_request* request, size_t request_bytes, uint32_t dim);

/* Bytes of block to plan for: enough for uniform points, an estimate for others. SIZE_MAX when it does not fit a
 * size_t, 0 on an invalid request. */
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
} netmesh_method;

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
} netmesh_cage_kind;

/* A sizing function: the out-radius wanted of the Voronoi cell of a mesh vertex at x[D]. Must depend on x alone
 * (results are reproducible as far as it is), be defined at least up to 2.2 enclosing radii from the domain's centre,
 * positive, and nowhere below 64 units in the last place of the coordinates: other values end the job with
 * INVALID_ARGUMENT. Termination needs no more; the size bounds of 3.7.1 need it to be Lipschitz with a moderate
 * constant. +infinity asks for nothing. Called a few times a vertex. Must not call into the context. */
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
 * after each insertion, until FinishMesh begins; K and K' until over-refinement begins. */
typedef enum netmesh_audit_what { NETMESH_AUDIT_LOCATION = 1, NETMESH_AUDIT_QUALITY = 2 } netmesh_audit_what;

/* Also says, wherever a request points to it, what a mesh promises: check, analyse and load read tau, sizes,
 * certificate, size_at_inputs, size_growth, net_spacing and cage_kind of it. */
typedef struct netmesh_mesh_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const double* points; /* [point_count][D]. Not read by the plan */
    size_t point_count;   /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;        /* of every random choice; init: 1 */
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
    netmesh_cage_kind cage_kind; /* THESIS: D at most 4, tau given and at least 3.4, PURPOSE_MESH without audits */
} netmesh_mesh_request;

void netmesh_mesh_request_init(netmesh_mesh_request* request, size_t request_bytes, uint32_t dim);

/* The tau that a request stands for: its own or, when that is 0, the dimension's: 2.5 (D = 2, 3), 3.08 (4), 4 (5, 6).
 * 0 when the request is not initialised. */
double netmesh_tau(const netmesh_mesh_request* request);

/* As netmesh_plan_delaunay, with the diagram of the purpose. A sizing function is not counted. */
size_t netmesh_plan_mesh(const netmesh_mesh_request* request);

/* Quality mesh of points: a Delaunay triangulation of the points and of Steiner points in which each vertex that is not
 * exempt has a Voronoi cell that, clipped to the domain ball, has aspect ratio at most tau. With METHOD_HIERARCHY,
 * unless finished, there are cages as well (see netmesh_cage), each vertex's cell is clipped to the ball of its own
 * domain, and a cage's cell has aspect ratio at most tau too. Admits coordinates of magnitude at most 2^500 and,
 * after merging duplicates, distances of at least 2^-500 and 64 units in the last place. Works on flat input and on a
 * single point. PURPOSE_PERSIST refines (SVR alone) a shell around the domain as well, as far as a certified ratio of
 * sqrt(2 + tau) needs it. PURPOSE_TIGHT over-refines to e = tight_eps / (3 (1 + tight_eps)) times f_P (7.5) in a
 * domain of at least 3.1 + 4 e enclosing radii: hundreds (D = 2) to tens of thousands (D = 3) of vertices a point.
 * Meshes with cages are neither for persistence nor over-refined; finished ones are.
 * With certificate.ratio the mesh has about half of the vertices for the same certified ratio. No aspect ratio is
 * promised then; the report's tau is 0. For a ratio below 2 distances must be 64 / (ratio^2 / 2 - 1) units, and with
 * scales of interest focus_from must be 64 / k units, k = focus_ratio^2 / 2 - 1, or
 * (focus_ratio^2 - 1) / (focus_ratio^2 + 1) when focus_ratio is at most sqrt 2 (INVALID_ARGUMENT, FOCUS_FROM).
 * Replaces what the context held, also on failure.
 * INVALID_ARGUMENT, NOT_FINITE, OUT_OF_RANGE, TOO_CLOSE, OUT_OF_MEMORY, CANCELLED; on the last two the context holds a
 * valid Delaunay mesh of what was inserted so far (report.complete is 0). */
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
 * INVALID_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY, CHECK_FAILED when the cells are not a triangulated ball (a facet of
 * three cells, a bad index...). */
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
 * diagram. INVALID_ARGUMENT, NO_RESULT (no mesh with a domain), OUT_OF_MEMORY, CHECK_FAILED (not a hierarchy of balls
 * about inputs); after the last two the mesh has no cages. */
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

/* Measures each vertex's cell: ratios[vertices] gets its clipped aspect ratio, 0 for exempt vertices; domains[vertices]
 * the innermost cage that it is in, NETMESH_NONE for none. Of a Delaunay triangulation: the aspect ratio of the whole
 * cell, +infinity on the hull or where doubles do not know a corner; 0 for points that are not inserted. Scratch in the
 * block. INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_measure_cells(netmesh_context* context, double* ratios, uint32_t* domains);

/* The Voronoi cell of a vertex (5.1). Its corners are the centres of the D-balls of the vertex's cells, the Delaunay
 * neighbours the other vertices of these. Of a cell that is not inside the domain (of a triangulation: not bounded) two
 * pieces are looked at, what is in the domain and what is in a ball that holds all vertices and corners; what is said
 * here is said of the fatter one. All is 0 where doubles do not know a corner. */
typedef struct netmesh_voronoi {
    uint32_t struct_bytes;
    uint32_t bounded;                     /* 1: the vertex is not on the hull */
    uint32_t piece;                       /* 0: the whole cell; 1: what is in the domain; 2: in the ball around all */
    uint32_t corners, degree;             /* of the whole cell; neighbours */
    double nearest;                       /* distance to the nearest neighbour: twice the in-radius about the vertex */
    double reach;                         /* no point of the piece is farther from the vertex */
    double in_ball[NETMESH_DIM_MAX + 1];  /* centre, radius at index D: the largest ball inside, up to rounding */
    double out_ball[NETMESH_DIM_MAX + 1]; /* one around it; the smallest when piece is 0 */
    double beta;                          /* fatness: radius of the one over that of the other, rounded up; 0: no ball
                                             inside was found */
} netmesh_voronoi;

/* A D-ball, circumscribed to a cell. */
typedef struct netmesh_ball {
    uint32_t struct_bytes;
    uint32_t ply;                     /* open D-balls that contain the barycentre of the cell */
    uint32_t meets;                   /* other open D-balls that meet this one */
    double ball[NETMESH_DIM_MAX + 1]; /* centre, a corner of the Voronoi cells of the vertices; radius at index D, which
                                         is infinite for a cell too flat for doubles */
    double error;                     /* of the centre, at most */
} netmesh_ball;

/* Measure all cells, and all D-balls: cells[vertices] in the order of netmesh_get_vertex, balls[cells] in that of
 * netmesh_get_cell. cells[0].struct_bytes (balls[0].struct_bytes) is set by the caller and says how many bytes there
 * are from one to the next. Nothing is left out or sampled: each ball costs as many looks as it has neighbours that
 * meet it. Scratch in the block. INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_measure_voronoi(netmesh_context* context, netmesh_voronoi* cells);
netmesh_status netmesh_measure_balls(netmesh_context* context, netmesh_ball* balls);

/* A cage as an additively weighted point of the domain around it (4.6), whose other points u are the vertices of that
 * domain, of weight 0, and the centres of the cages directly inside it. */
typedef struct netmesh_weighted_cell {
    uint32_t struct_bytes;
    double weight;       /* w: distance from the centre c to the farthest vertex of the shell */
    double in_radius;    /* r of the cell {x: |x - c| - w <= |x - u| - w_u for all u}: least (|c - u| - w_u + w) / 2 */
    double feature_size; /* f: distance to the nearest u */
    double epsilon;      /* least e with w <= e (|c - u| - w_u) and w_u <= e (|c - u| - w) for all u: by 4.6.1
                            2 r (1 - e) / (1 + e) <= f <= 2 r / (1 - e) when it is below 1. NETMESH_CHECK_QUALITY
                            holds meshes to 1/3, so to r <= f <= 3 r (4.6.2) */
    double cage_in_radius; /* of the cage's cell, which stands for that one: half of the distance from c to the */
    double
        cage_out_radius; /* nearest vertex outside, measured from the shell; its farthest point in the domain's ball */
} netmesh_weighted_cell;

/* cells[cages], in the order of netmesh_get_cage; none of a mesh without cages. cells[0].struct_bytes is set by the
 * caller, as for netmesh_measure_voronoi. Scratch in the block. O(cages * vertices). INVALID_ARGUMENT, NO_RESULT,
 * OUT_OF_MEMORY. */
netmesh_status netmesh_weighted_cells(netmesh_context* context, netmesh_weighted_cell* cells);

typedef enum netmesh_check_what {
    NETMESH_CHECK_COMBINATORIAL = 1, /* neighbours mutual, facets shared by two, the hull a sphere */
    NETMESH_CHECK_GEOMETRIC = 2,     /* every cell positively oriented, exactly */
    NETMESH_CHECK_DELAUNAY = 4,      /* every interior facet locally Delaunay, the hull convex, exactly */
    NETMESH_CHECK_QUALITY = 8,       /* of meshes: clipped aspect ratios recomputed, at most tau, and sizes; with a
                                        certificate.ratio what it asks for instead; with cages the ratios of the
                                        hierarchy, that no cage is encroached (4.5), and 4.6.1 and
                                        4.6.2 of neighbours */
    NETMESH_CHECK_BOUNDS = 16,       /* the bounds of netmesh_analyse: violated ones of chapters 3 (meshes) and 5 */
    NETMESH_CHECK_ALL = 31
} netmesh_check_what;

typedef struct netmesh_check_request {
    uint32_t struct_bytes;
    uint32_t what; /* a union of netmesh_check_what; init: ALL */
    netmesh_monitor monitor;
    const netmesh_mesh_request* mesh; /* what the mesh promises; null: the dimension's tau */
} netmesh_check_request;

void netmesh_check_request_init(netmesh_check_request* request, size_t request_bytes);

/* Independent checkers: nothing that they read was cached by the code that made the result. O(cells).
 * INVALID_ARGUMENT, NO_RESULT, CHECK_FAILED, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_check(netmesh_context* context, const netmesh_check_request* request);

/* --------------------------------------------------------------------------------------------- 3 persistence ---- */

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
} netmesh_filter;

typedef enum netmesh_values {
    NETMESH_VALUES_CERTIFIED = 0, /* the filter's values, clamped so that the certified ratio is the best possible */
    NETMESH_VALUES_THESIS = 1     /* the filter's own values */
} netmesh_values;

/* Which call a filter goes to. */
typedef enum netmesh_source {
    NETMESH_SOURCE_MESH = 1,     /* netmesh_mesh, then netmesh_persist */
    NETMESH_SOURCE_DELAUNAY = 2, /* netmesh_delaunay, then netmesh_persist */
    NETMESH_SOURCE_SCALES = 3,   /* netmesh_persist_scales */
    NETMESH_SOURCE_POINTS = 4    /* netmesh_persist_points */
} netmesh_source;

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
 * error, (f - cut) / lipschitz beyond; 0, which a mesh refuses, where the arguments are not as said. Calls evaluate
 * once. */
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
 * Memory above the mesh: below 8 bytes a simplex, for alpha about 25 bytes a simplex plus fill, 8 more on grids.
 * KNN and KDISTANCE, k >= 2: on a mesh on which COMPLETE certifies c the certified_ratio is at most sqrt(2 + s c^2), s
 * = 1 for KNN and sqrt(k / (k - 1)) for KDISTANCE. For FUNCTION: the sublevel sets of a function (8.6). certified_ratio
 * is infinite where f is too small for its change across a Voronoi cell; a distance_factor keeps it finite.
 * certified_error is finite, at most lipschitz times the domain's radius; infinite where what is said of
 * the function cannot be: at a vertex it is less than cut and lipschitz allow so far from the domain's sphere.
 * INVALID_ARGUMENT (K: more than the number of different points), NOT_FINITE (index_a: the vertex at which the function
 * is not finite), OUT_OF_RANGE (ALPHA: differences of coordinates above 2^1670 units in the plane, 2^1190
 * in space, 2^640 in R^6, of which all coordinates are multiples), NO_RESULT, OUT_OF_MEMORY, CANCELLED. The mesh stays
 * whole on failure. ALPHA: a bar of positive length for each that there is in exact arithmetic, and no other. Births
 * and deaths have exactly the order of the true ones: where many different ones share one double, each is the next
 * double to the one before, within value_error of the report. */
netmesh_status netmesh_persist(netmesh_context* context, const netmesh_persist_request* request);

/* Pairs sorted by degree, birth, death; death is +infinity for an essential class. O(1). */
typedef struct netmesh_pair {
    uint32_t struct_bytes;
    uint32_t degree;
    double birth, death;
} netmesh_pair;
netmesh_status netmesh_get_pair(const netmesh_context* context, uint64_t index, netmesh_pair* pair);

typedef struct netmesh_bounds_request {
    uint32_t struct_bytes;
    netmesh_monitor monitor;
} netmesh_bounds_request;

void netmesh_bounds_request_init(netmesh_bounds_request* request, size_t request_bytes);

/* For each bar where the true one surely is, from the bounds of every cell instead of one ratio; whether the bar surely
 * stands for a class of the true diagram; and the ratio as a function of scale. Where a filter's bounds_by_scale is
 * 1: by scale, and by covers within and around the sublevel sets, at the cost of up to eight more diagrams; else by the
 * certified ratio, certified_error and value_error. The numbers stay with the diagram: 48 bytes a bar. Scratch: about
 * 110 bytes a vertex, 120 a bar, and what a diagram takes; netmesh_plan_mesh does not count it. The diagram stays whole
 * on failure. NO_RESULT (no diagram), INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_bounds_request* request);

typedef struct netmesh_bar_bounds {
    uint32_t struct_bytes;
    uint32_t certain; /* 1: surely real: all bars with 1 belong to different true bars within their bounds. Surely so
                         when death > certain_after, often for other reasons */
    double birth_low, birth_high, death_low, death_high; /* contain the true birth and death of a bar that is matched */
    double certain_after; /* a bar of this birth that dies later is surely real; not below birth_high */
} netmesh_bar_bounds;
/* Of the pair of that index, after netmesh_bound_bars. O(1). */
netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds);

/* The certificate as a function of scale, after netmesh_bound_bars. For alpha from `from` up to the next step's `from`
 * a birth or death at alpha stands for a true one between min(low, alpha) and max(high, alpha), and within the factor
 * `ratio`; c(alpha), the certified ratio at alpha, is max(high / alpha, alpha / low, 1) or `ratio`, whichever is less.
 * A bar born at alpha that dies after max(reach, alpha) is surely real. Bars without a true bar have death / c(death)
 * <= birth * c(birth); true bars without a bar have birth >= alpha / c(alpha), death <= alpha * c(alpha) for some
 * alpha. Before the first step c is 1. Steps ascend in all but ratio. O(1). */
typedef struct netmesh_scale_step {
    uint32_t struct_bytes;
    double from, low, high, reach; /* radii; those but `from` may be infinite */
    double ratio;                  /* at most certified_ratio where from >= certified_from */
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
 * pair dies, an older one that it is then connected to. get_cycle tells the number of simplices, get_cycle_simplex
 * one of them, in no particular order; O(1) and O(degree^2). NO_RESULT when no representatives were asked for. */
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
    const double* points;        /* [point_count][D] */
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
} netmesh_fit_request;

void netmesh_fit_request_init(netmesh_fit_request* request, size_t request_bytes, uint32_t dim);

/* Refines by the certificate (see netmesh_certificate_goal) to ratios of a fixed ladder, 1 + (R - 1) 2^(-j/8), one
 * after the other until one does not fit, and keeps what certifies most: the least certified_ratio, with focus_from and
 * focus_to the least certified_focus. Then the ratios of the ladder are asked of those scales alone, and R of
 * everything else. A larger block never certifies less. What comes out depends on the points, the request and the
 * block's size alone. Meshes are refined for the distance to the points; other filters are evaluated on them. Where all
 * ratios are infinite the finest mesh is kept. Leaves mesh and diagram as netmesh_mesh and netmesh_persist with the
 * report's certificate goal do; without OK the context is empty. Costs, beside the last run, about 5.3 such runs in the
 * plane, 3.4 in space, 2.4 in R^4, the one that does not fit, and another one where the last is not the best.
 * INVALID_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY (not even R fits), and what those calls say. */
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

/* ----------------------------------------------------------------------------------------- 4 other complexes ---- */

/* Persistent homology of points scale by scale (7.6): recursively well-paced subsets, one mesh for each in the same
 * memory, their diagrams joined. With eps, over-refined meshes and the tight filter; with ratio, meshes refined by the
 * certificate and the complete filter. An over-refined mesh has 10^4 vertices a point and more in R^4: give a ratio. */
typedef struct netmesh_scales_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const double* points; /* [point_count][D]. Not read by the plan */
    size_t point_count;   /* 1 .. NETMESH_POINTS_MAX */
    uint64_t seed;        /* of every random choice; init: 1 */
    double tau;           /* as of netmesh_mesh_request */
    double eps;           /* accuracy of each scale's diagram, in (0, 1/2]; 0: 1/2, or none where ratio is given */
    double theta;         /* mediality that keeps points in one scale, in (0, 1/9]; 0: 1/9 */
    netmesh_values values;
    uint32_t max_degree;      /* as of netmesh_persist_request; init: NETMESH_DIM_MAX */
    uint32_t keep_zero_pairs; /* likewise */
    double ratio;             /* of the joined diagram, with certified values; above (1 + 3 theta) times the root of 2,
                                 and finite; 0: as eps says. Not both */
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
 * INVALID_ARGUMENT (SIZES: coordinates near point index_a do not resolve the size that eps asks for), NOT_FINITE,
 * OUT_OF_RANGE, TOO_CLOSE, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_scales(netmesh_context* context, const netmesh_scales_request* request);

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
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const double* points; /* [point_count][D]. Not read by the plan */
    size_t point_count;   /* 1 .. NETMESH_POINTS_MAX */
    netmesh_filter filter;
    netmesh_values values;
    uint32_t k;               /* of the barycentric filters, >= 1 and k + max_degree <= 30; init: 1 */
    uint32_t max_degree;      /* at most 30; init: 1 */
    uint32_t keep_zero_pairs; /* 1: pairs of zero length are kept */
    uint32_t representatives; /* 1: keep a cycle for each pair (netmesh_get_cycle); RIPS and CECH. Vertices are numbered
                                 in input order after merging */
} netmesh_points_request;

void netmesh_points_request_init(netmesh_points_request* request, size_t request_bytes, uint32_t dim,
                                 netmesh_filter filter);

/* Bytes of block to plan for: more than the points take in any position, but for the fill of the reduction. SIZE_MAX
 * when it does not fit a size_t, 0 on an invalid request. RIPS with representatives takes as much as CECH. */
size_t netmesh_plan_points(const netmesh_points_request* request);

/* Persistent homology over Z/2 in degrees 0..max_degree. Values are radii. Exact duplicates are merged, counted and not
 * counted as neighbours. Replaces what the context held, also on failure. The number of simplices grows as
 * n^(max_degree + 2), of nested sets as n^(k + max_degree + 1): ask netmesh_plan_points first.
 * INVALID_ARGUMENT (K: 0, or above the number of different points), NOT_FINITE, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_persist_points(netmesh_context* context, const netmesh_points_request* request);

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

/* ----------------------------------------------------------------------------------------------- 5 distances ---- */

typedef enum netmesh_scale {
    NETMESH_SCALE_PLAIN = 0, /* differences of radii */
    NETMESH_SCALE_LOG = 1    /* differences of their logarithms */
} netmesh_scale;

#define NETMESH_ALL_DEGREES UINT32_MAX

typedef struct netmesh_bottleneck_request {
    uint32_t struct_bytes;
    uint32_t pair_bytes;         /* sizeof(netmesh_pair), from one pair to the next; not below that of version 0.2 */
    netmesh_monitor monitor;     /* can only cancel, its progress is empty */
    const netmesh_pair* pairs_a; /* [count_a], in any order; their struct_bytes are not read */
    const netmesh_pair* pairs_b; /* [count_b] */
    uint64_t count_a, count_b;
    uint32_t degree; /* init: NETMESH_ALL_DEGREES, the largest distance of all degrees */
    netmesh_scale scale;
    void* scratch; /* 16-byte aligned, scratch_bytes >= netmesh_bottleneck_bytes */
    size_t scratch_bytes;
} netmesh_bottleneck_request;

/* pair_bytes: sizeof(netmesh_pair). */
void netmesh_bottleneck_request_init(netmesh_bottleneck_request* request, size_t request_bytes, size_t pair_bytes);

/* Bytes of scratch for count_a and count_b pairs, about 310 a pair; SIZE_MAX when they do not fit or there are more
 * than 2^25 pairs; 0 on an invalid request. */
size_t netmesh_bottleneck_bytes(const netmesh_bottleneck_request* request);

/* PLAIN: value is the distance, exponent 0. LOG: value * 2^exponent is the ratio e^distance, value in [1, 2). Infinite:
 * value is +infinity. The exact distance (ratio), rounded once. */
typedef struct netmesh_distance {
    uint32_t struct_bytes;
    int32_t exponent;
    double value;
} netmesh_distance;

/* Bottleneck distance (6.5) between two diagrams: the least d for which pairs can be matched one to one, each moved
 * by at most d in birth and in death, and unmatched pairs are at most 2 d long. Essential pairs are matched to
 * essential pairs by birth; in LOG scale pairs born at 0 are matched only to pairs born at 0. Where their numbers
 * differ the distance is infinite. Births are finite (and not negative in LOG scale), death >= birth.
 * No context is needed; detail, which may be null, gets what a context would keep. Expected cost about O(n^1.5 log n).
 * INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_bottleneck(const netmesh_bottleneck_request* request, netmesh_distance* distance,
                                  netmesh_detail* detail);

/* ------------------------------------------------------------------------------------------------- 6 reports ---- */

/* A report has a part for each result that a context can hold. A part that does not apply has present = 0, and all else
 * in it is 0. */

typedef struct netmesh_input_report {
    uint32_t present;            /* 1 after every job */
    uint32_t dim;                /* D; 0 for a complex given by its simplices */
    uint64_t points, duplicates; /* rows; rows merged into an earlier one */
    uint64_t distinct;           /* points - duplicates; inputs of a mesh, vertices of a complex */
    uint64_t fingerprint;        /* of the values only */
    uint64_t reserved[2];
} netmesh_input_report;

/* Of over-refinement. */
typedef struct netmesh_sizes_report {
    double eps;       /* asked for */
    double ratio_max; /* worst R_v / f(v), at most 1; 0 when none was asked for */
} netmesh_sizes_report;

typedef struct netmesh_hierarchy_report {
    uint64_t cages, cages_made; /* made: those released again are counted too */
    uint64_t reserved[3];
} netmesh_hierarchy_report;

#define NETMESH_ROUNDS_MAX 32

/* What audits found; 0 where not asked for. */
typedef struct netmesh_audit_report {
    uint32_t what; /* a union of netmesh_audit_what */
    /* LOCATION. Load: points in a D-ball. */
    uint32_t rounds, nets, nets_max;   /* samples drawn, in all and in one round */
    uint32_t load[NETMESH_ROUNDS_MAX]; /* largest when each round begins; 0 after the last */
    uint32_t ply_max;                  /* most D-balls that a point was in */
    uint32_t touches_max;              /* most insertions that moved a point or looked whether to move it (4.13) */
    double ply_mean;                   /* D-balls that a point was in when its turn came */
    double touches_mean, tests_mean;   /* tests: the same for each new D-ball */
    /* QUALITY: worst of all intermediate meshes. P: with HIERARCHY the inserted points of the domain; otherwise all
     * points, as Steiner points are graded towards those that are still to be inserted. f_P: distance to the second
     * nearest of them. f_M: to the nearest Delaunay neighbour, for which the centre of a cage stands where it is in one
     * that is directly inside of the domain. */
    uint64_t meshes;
    double aspect_ratio_max;                       /* of vertices and cages, definition 4.5, clipped to their domain;
                                                      of a mesh refined by the certificate, whose Steiner vertices may
                                                      have long cells: of points */
    double feature_ratio;                          /* K of the feature size invariant: f_P(v) / f_M(v) */
    double cage_ratio, steiner_ratio, input_ratio; /* K' of the insertion radius invariant */
    uint64_t degree_max; /* most Delaunay neighbours of a vertex; the 2 D around everything do not count */
    uint64_t reserved[1];
} netmesh_audit_report;

typedef struct netmesh_mesh_report {
    uint32_t present; /* 1: there is a triangulation or mesh */
    uint32_t is_mesh; /* 1 after mesh, or load with a domain: what follows `cells_created` is said of meshes alone */
    uint64_t vertices, inputs, steiner, exempt; /* vertices = inputs + steiner + exempt */
    uint64_t cells, cells_created;
    netmesh_method method;              /* SVR after load */
    double domain[NETMESH_DIM_MAX + 1]; /* centre, radius at index D */
    double aspect_ratio_max; /* actual worst clipped aspect ratio over vertices that are not exempt; 0 if none */
    double tau;              /* bound asked for; 0 for a mesh refined by the certificate */
    netmesh_certificate_goal certificate; /* asked for */
    netmesh_sizes_report sizes;
    netmesh_hierarchy_report hierarchy;
    netmesh_audit_report audit;
    uint64_t touches; /* by point location, whatever made it look: distances to inputs, inputs compared with D-balls
                         (audit LOCATION), cells, domains and vertices passed; 0 after load */
    uint64_t reserved[3];
} netmesh_mesh_report;

typedef struct netmesh_diagram_report {
    uint32_t present;
    netmesh_filter filter; /* NONE: a complex given by its simplices */
    netmesh_values values;
    uint32_t max_degree;
    uint32_t k;                                 /* of filters with needs_k, else 0 */
    uint32_t representatives;                   /* 1: there is a cycle for each pair */
    uint64_t pairs[NETMESH_DEGREE_MAX + 1];     /* per degree, essential ones included */
    uint64_t essential[NETMESH_DEGREE_MAX + 1]; /* per degree: the Betti numbers of the whole complex */
    uint64_t simplices; /* of the filtered complex; RIPS: of dimension up to max(1, max_degree) */
    /* c >= 1: log-bottleneck distance to the diagram of the offsets (of the sublevel sets of the function of KNN,
     * KDISTANCE and FUNCTION) is at most ln c. ALPHA: 1, but for value_error. */
    double certified_ratio;
    double certified_ratio_best; /* the best ratio that any filter values on this mesh can certify (certified values) */
    double certified_from;       /* scale from which the ratio holds: 0, or r_P for the basic filter */
    double value_error;          /* ALPHA: births and deaths differ from the true ones by at most this times the true
                                    ones, and are in the same order and equal where those are; 0: no such bound */
    double certified_focus;      /* of netmesh_fit with scales of interest: the largest sqrt(hi / lo), lo and hi the
                                    bounds of a Steiner vertex's cell that matters to them; else 0 */
    double certified_error;      /* FUNCTION: each pair moves by at most this, finite whatever the function: the
                                    bottleneck distance to the diagram of its sublevel sets; other filters: 0, none */
    uint64_t reserved[1];
} netmesh_diagram_report;

/* Of netmesh_bound_bars. */
typedef struct netmesh_bounds_report {
    uint32_t present;
    uint32_t max_degree;
    uint64_t certain[NETMESH_DEGREE_MAX + 1]; /* per degree: bars that are surely real */
    uint64_t steps;                           /* of the ratio as a function of scale */
    uint64_t reserved[2];
} netmesh_bounds_report;

/* Of netmesh_persist_scales; the diagram's `simplices` counts those of all scales. */
typedef struct netmesh_scales_report {
    uint32_t present;
    uint32_t count;
    uint64_t points_max, vertices_max; /* of the largest scale */
    uint64_t vertices;                 /* of all */
    double separation; /* the least E = (distance from a scale's representative to the next point of the scale above) /
                          (twice the radius of the scale), at least (1 - theta) / (2 theta), infinity for one scale;
                          offsets are within E / (E - 1) */
    uint64_t reserved[2];
} netmesh_scales_report;

typedef struct netmesh_vineyard_report {
    uint32_t present;
    netmesh_filter filter; /* NONE: of netmesh_value_vineyard */
    netmesh_values values;
    uint32_t max_degree;
    uint32_t k_first, k_last; /* there 1 and step_count */
    uint64_t vines, points, transpositions;
    uint64_t simplices;     /* of the filtered complex */
    double certified_ratio; /* the largest of all k */
    uint64_t reserved[2];
} netmesh_vineyard_report;

/* Of netmesh_homology, netmesh_value_vineyard and netmesh_persist_points. */
typedef struct netmesh_complex_report {
    uint32_t present;
    uint64_t vertices;
    uint64_t reserved[2];
} netmesh_complex_report;

typedef struct netmesh_memory_report {
    uint64_t block_bytes, peak_bytes, used_bytes;
    uint64_t reserved[2];
} netmesh_memory_report;

typedef enum netmesh_predicate_stage {
    NETMESH_PREDICATE_CACHED = 0,  /* decided by a cached circumsphere and its error bound */
    NETMESH_PREDICATE_FLOAT = 1,   /* floating-point determinant with an error bound */
    NETMESH_PREDICATE_INTEGER = 2, /* exact arithmetic of limited width */
    NETMESH_PREDICATE_EXACT = 3,   /* exact arithmetic of full width */
    NETMESH_PREDICATE_TIE = 4,     /* exactly degenerate, decided by the symbolic perturbation */
    NETMESH_PREDICATE_STAGES = 5
} netmesh_predicate_stage;

/* Decisions of triangulation and mesh that ended in each stage. */
typedef struct netmesh_predicates_report {
    uint64_t in_ball[NETMESH_PREDICATE_STAGES];
    uint64_t orient[NETMESH_PREDICATE_STAGES];
    uint64_t reserved[2];
} netmesh_predicates_report;

typedef struct netmesh_report {
    uint32_t struct_bytes;
    uint32_t complete;    /* 1 when the job ran to its end, 0 after OUT_OF_MEMORY or CANCELLED */
    uint64_t fingerprint; /* of mesh and diagram; equal on every platform and for every block size */
    netmesh_input_report input;
    netmesh_mesh_report mesh;
    netmesh_diagram_report diagram;
    netmesh_bounds_report bounds;
    netmesh_scales_report scales;
    netmesh_vineyard_report vineyard;
    netmesh_complex_report simplicial_complex;
    netmesh_memory_report memory;
    netmesh_predicates_report predicates;
} netmesh_report;

/* report->struct_bytes must be set. O(vertices + cells + pairs), for the counts and the fingerprint.
 * INVALID_ARGUMENT. */
netmesh_status netmesh_get_report(const netmesh_context* context, netmesh_report* report);

typedef enum netmesh_analyse_what {
    NETMESH_ANALYSE_SIZE = 1, /* a mesh only */
    NETMESH_ANALYSE_STRUCTURE = 2,
    NETMESH_ANALYSE_FATNESS = 4,
    NETMESH_ANALYSE_ALL = 7
} netmesh_analyse_what;

typedef struct netmesh_analyse_request {
    uint32_t struct_bytes;
    uint32_t what; /* a union of netmesh_analyse_what; init: ALL */
    netmesh_monitor monitor;
    double tolerance; /* wanted upper / lower - 1 of the integrals, >= 0; 0: 0.1, 0.25, 1, 4, 16 for D = 2..6; large
                         inputs, and the boundary in high D, get less */
    const netmesh_mesh_request* mesh; /* what the mesh promises; null: the dimension's tau */
} netmesh_analyse_request;

void netmesh_analyse_request_init(netmesh_analyse_request* request, size_t request_bytes);

/* Size (3.4, 3.6, 3.8): theta_i is the distance of the i-th input to the nearest before it over that to the second
 * nearest, in the ordering of netmesh_well_paced_order. */
typedef struct netmesh_size_analysis {
    uint32_t present;
    uint64_t vertices; /* |M|: those that are not exempt; with cages also their shells */
    /* Refined by the certificate, which promises no quality, lower and upper say nothing (0, infinity), nor does
     * feature_ratio_bound (infinity). With cages lower and upper are sums over domains (4.9.4): lower of every mesh of
     * hierarchical quality tau with these cages, upper of every one with this feature_ratio in each domain. */
    double lower;               /* every mesh of aspect ratio tau on this domain has more vertices (3.4.2) */
    double upper;               /* every mesh of this feature_ratio has fewer (3.4.1) */
    double feature_ratio;       /* largest f_P(v) / f_M(v), distances to the second nearest input and vertex; with
                                   cages P are the inputs of v's domain and the centres of the cages in it */
    double feature_ratio_bound; /* by 3.3.2, where inputs are yielded to, and 3.7.1; infinite where they say nothing,
                                   as with cages */
    double theta;               /* the least theta_i */
    double theta_limit;         /* no ordering that begins with a diameter has a least theta_i above it */
    double theta_log_sum;       /* sum of ln(1 / theta_i), i >= 3: the mesh size up to constants and O(n) (3.8.1) */
    /* Bounds on the integral of f_P^-D over balls about the domain's centre: the domain; what also contains all
     * vertices' in-balls; what contains three diameters about each input. */
    double radii[3], integral_lower[3], integral_upper[3];
    double pace_lower, pace_upper; /* what 3.8.7 and 3.8.5 say about the last */
    uint64_t boxes;                /* where f_P was evaluated */
    double upper_over_lower;       /* infinite where one of them says nothing */
    uint64_t domains;              /* 1 more than there are cages */
} netmesh_size_analysis;

/* Structure (4.8.1, 4.11). Maxima of ply and of intersections are taken over a sample: ply at barycentres of cells and
 * at centres in the domain, so other points may be in more balls whatever the stride is; intersections at balls, so
 * with balls_stride 1 their maximum is exact. D-balls at the boundary of a mesh, with an exempt vertex on the hull, are
 * as large as the mesh: netmesh_boundary_analysis counts them. */
typedef struct netmesh_structure_analysis {
    uint32_t present;
    uint64_t degree_max, star_max; /* neighbours and cells of a vertex that is not on the hull; exact */
    double degree_mean, star_mean;
    uint64_t ply_points, ply_max; /* circumscribed balls that contain a point: barycentres, centres in the domain */
    double ply_mean;
    uint64_t balls, intersections_max; /* other circumscribed balls that meet one, those of shells included */
    double intersections_mean;
    uint64_t ply_stride, balls_stride; /* every so many-th cell was looked at, 1: each */
} netmesh_structure_analysis;

/* What is left out of the structure: vertices of the hull, and circumscribed balls of cells with an exempt one. */
typedef struct netmesh_boundary_analysis {
    uint32_t present;
    uint64_t vertices, degree_max;
    uint64_t balls, intersections_max; /* sampled as the others, by balls_stride */
    uint64_t reserved[2];
} netmesh_boundary_analysis;

/* Voronoi cells and what their fatness says about them (5); beta = out-radius / in-radius of a cell, its smallest
 * enclosing and largest inscribed ball. Everything counts vertices of the part only. */
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

/* Fatness (5): cells of vertices neither exempt nor on the hull, whole; those of them inside the domain; all clipped to
 * the domain (balls of corners; nothing is bounded by them). Cells of all vertices: netmesh_all_cells_analysis. */
typedef struct netmesh_fatness_analysis {
    uint32_t present;
    netmesh_fatness bounded, inside;
    uint64_t clipped_cells;
    double clipped_beta_max, clipped_beta_mean;
    uint64_t reserved[2];
} netmesh_fatness_analysis;

/* Fatness of every cell, those of shells and of the boundary included, each as in netmesh_voronoi. 5.3.1 to 5.5.1 hold
 * of these pieces: of edges and degrees whose facet has a corner in the domain or an edge across its sphere (without a
 * domain: of all), 5.4.5 and 5.5.1 of vertices whose cell is whole. */
typedef struct netmesh_all_cells_analysis {
    uint32_t present;
    netmesh_fatness cells;
    uint64_t left_out; /* vertices with a corner that doubles do not know, or no ball inside */
    double radius;     /* of the ball around all vertices and corners */
    uint64_t reserved[4];
} netmesh_all_cells_analysis;

typedef struct netmesh_analysis {
    uint32_t struct_bytes;
    uint32_t what;        /* what was analysed */
    uint64_t fingerprint; /* of all figures; equal on every platform */
    netmesh_size_analysis size;
    netmesh_structure_analysis structure;
    netmesh_fatness_analysis fatness;
    netmesh_boundary_analysis boundary;   /* with STRUCTURE */
    netmesh_all_cells_analysis all_cells; /* with FATNESS */
} netmesh_analysis;

/* Analyses what the context holds. analysis->struct_bytes must be set. Scratch: 8 to 60 bytes a vertex,
 * with cages 8 a cell.
 * INVALID_ARGUMENT, NO_RESULT (no triangulation; SIZE without a mesh), OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_analyse(netmesh_context* context, const netmesh_analyse_request* request,
                               netmesh_analysis* analysis);

typedef enum netmesh_figure_type {
    NETMESH_FIGURE_FLAG = 1, /* uint32_t, 0 or 1 */
    NETMESH_FIGURE_UINT32 = 2,
    NETMESH_FIGURE_UINT64 = 3,
    NETMESH_FIGURE_DOUBLE = 4,
    NETMESH_FIGURE_FINGERPRINT = 5, /* uint64_t, written in hexadecimal */
    NETMESH_FIGURE_NAME = 6         /* an enumeration; `text` is the value's name */
} netmesh_figure_type;

/* One figure of a report or an analysis, for whoever writes all of them without a list of their own. */
typedef struct netmesh_figure {
    uint32_t struct_bytes;
    netmesh_figure_type type;
    const char* path;        /* parts and name, as in the tool's JSON: "mesh.audit.location.ply_max" */
    const void* values;      /* [count], in the struct that was handed over */
    uint32_t is_array;       /* 1: an array, which may be empty */
    uint32_t count;          /* how many values are used; 1 of what is no array */
    uint32_t applies;        /* 0: says nothing here, as its part is not present or the figure was not asked for */
    uint32_t on_request;     /* 1: of something that a job has to be asked for */
    uint32_t in_fingerprint; /* 1: enters the fingerprint as it stands here */
    const char* text;        /* of a NAME, else null */
} netmesh_figure;

/* Figure `index`, from 0 on, those of a part one after the other. INVALID_ARGUMENT: index is past the last one, a
 * pointer is null or a struct_bytes is not set. Figures past the caller's struct_bytes do not apply. O(1). */
netmesh_status netmesh_get_report_figure(const netmesh_report* report, uint32_t index, netmesh_figure* figure);
netmesh_status netmesh_get_analysis_figure(const netmesh_analysis* analysis, uint32_t index, netmesh_figure* figure);

/* An ordering order[inputs] of the input vertices, from one far from input 0, always one of those farthest from all
 * before, and its theta[inputs] (may be null; 1 for the first two). It is theta-well-paced (3.8) for its least theta_i,
 * and no ordering that begins with a diameter is so for more than 2 theta / (1 - 3 theta), theta < 1/5. O(n log n) on
 * inputs of moderate spread. Distances must have squares that a double holds, as those of meshes do.
 * INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_well_paced_order(netmesh_context* context, uint32_t* order, double* theta);

/* theta[inputs] of a given permutation order[inputs] of the input vertices. INVALID_ARGUMENT (ORDER: no permutation),
 * NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_pace(netmesh_context* context, const uint32_t* order, double* theta);

#ifdef __cplusplus
}
#endif
#endif
