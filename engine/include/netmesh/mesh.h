/* Triangulations and meshes: taken over from elsewhere, checked, read vertex by vertex. netmesh_mesh makes them. */
#ifndef NETMESH_MESH_H
#define NETMESH_MESH_H

#include <stddef.h>
#include <stdint.h>

#include "request.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Methods by number, as reports have them. */
typedef enum netmesh_method_id {
    NETMESH_METHOD_SVR = 0,         /* Sparse Voronoi Refinement (4.4); of a mesh that was loaded, too */
    NETMESH_METHOD_NETMESH = 1,     /* NetMesh (4.5, 4.7): a hierarchical mesh, of linear size whatever the spread */
    NETMESH_METHOD_REFINE = 2,      /* VoronoiRefine (3.2), in the bounding domain and with the boundary net of 3.5 */
    NETMESH_METHOD_CERTIFICATE = 3, /* the coarsest mesh that certifies a ratio */
    NETMESH_METHOD_THESIS = 4,      /* NetMesh with the cages of 4.5 */
    NETMESH_METHOD_DELAUNAY = 5     /* no Steiner points: of no mesh (report.mesh.is_mesh 0), so no report has it */
} NETMESH_AN_INT netmesh_method_id;

/* A mesh made elsewhere, or read from a file. */
typedef struct netmesh_load_request {
    uint32_t struct_bytes;
    uint32_t dim; /* D, 2..6 */
    netmesh_monitor monitor;
    const double* vertices;          /* [vertex_count][D] */
    const uint8_t* markers;          /* [vertex_count]: 0 input, 1 Steiner, 2 exempt; inputs come first */
    size_t vertex_count;             /* 1 .. NETMESH_POINTS_MAX */
    const uint32_t* cells;           /* [cell_count][D+1], vertices in any order */
    size_t cell_count;               /* at most 2^29 - 2 */
    const double* domain;            /* [D+1], centre and radius; null: a Delaunay triangulation */
    const netmesh_request* promised; /* its filter, goal and rules: what the mesh promises. Its points may be there, of
                                        dimension D, and are not read. null: the dimension's tau */
} netmesh_load_request;

/* Takes a mesh over to be checked or filtered. Cells are oriented and linked here; whether it is a Delaunay
 * triangulation is what netmesh_check tells. Replaces what the context held, also on failure. O(cells).
 * INVALID_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY, CANCELLED. CHECK_FAILED: a facet has three cells, or a cell has a vertex
 * twice or one that does not exist. Cells that are otherwise no triangulated ball are loaded: the filter alpha and
 * netmesh_check (GEOMETRIC) refuse each of them, other jobs only those that their own work shows. Where there is no
 * domain, what alpha will refuse is found here. */
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
    uint32_t cage_bytes; /* from one cage to the next; 0: what the first one's struct_bytes say */
    netmesh_monitor monitor;
    const netmesh_cage* cages; /* [cage_count]; their parents are not read. May be null for no cages */
    size_t cage_count;
} netmesh_cages_request;

/* Adds the cages of a mesh taken over by netmesh_load, in place of those that it has; parents are found anew. Their
 * kind is that of the method that was promised: thesis, or else compact. Drops the diagram. INVALID_ARGUMENT, NO_RESULT
 * (no mesh with a domain), OUT_OF_MEMORY, CANCELLED, CHECK_FAILED (not a hierarchy of balls about inputs); after the
 * last three the mesh has no cages. */
netmesh_status netmesh_load_cages(netmesh_context* context, const netmesh_cages_request* request);

/* A vertex. 0 .. inputs - 1 are the input points in input order after merging, bit for bit; Steiner and exempt vertices
 * follow. O(1). INVALID_ARGUMENT: the index is past the last one, here as in all calls by index. */
typedef struct netmesh_vertex {
    uint32_t struct_bytes;
    uint32_t marker;                     /* 0 input, 1 Steiner, 2 exempt from quality */
    double coordinates[NETMESH_DIM_MAX]; /* the first D */
    uint32_t has_value;                  /* 1 after persist with a filter on meshes */
    double value;                        /* the filter value t(v) that its simplices use */
} netmesh_vertex;
netmesh_status netmesh_get_vertex(const netmesh_context* context, uint64_t index, netmesh_vertex* vertex);

/* A cell, positively oriented: the determinant of the edge vectors from the first vertex is positive. neighbours[i] is
 * the cell opposite vertices[i], NETMESH_NONE outside. O(1). */
typedef struct netmesh_cell {
    uint32_t struct_bytes;
    uint32_t vertices[NETMESH_DIM_MAX + 1];   /* the first D + 1 */
    uint32_t neighbours[NETMESH_DIM_MAX + 1]; /* the first D + 1 */
} netmesh_cell;
netmesh_status netmesh_get_cell(const netmesh_context* context, uint64_t index, netmesh_cell* cell);

/* Cages come before those inside them. O(1). */
netmesh_status netmesh_get_cage(const netmesh_context* context, uint64_t index, netmesh_cage* cage);

/* With weights: the row of a point that is hidden, 0 .. report.input.hidden - 1, ascending. Of a diagram without a
 * triangulation, too. O(1). */
netmesh_status netmesh_get_hidden(const netmesh_context* context, uint64_t index, uint64_t* row);

typedef enum netmesh_check_what {
    NETMESH_CHECK_COMBINATORIAL = 1, /* neighbours mutual, facets shared by two */
    NETMESH_CHECK_GEOMETRIC = 2,     /* a triangulation of the convex hull of its vertices, exactly */
    NETMESH_CHECK_DELAUNAY = 4, /* GEOMETRIC, and every interior facet locally Delaunay, exactly. Not of points with
                                   weights, whose triangulation is not Delaunay: WHAT has to leave it out */
    NETMESH_CHECK_QUALITY = 8,  /* of meshes: clipped aspect ratios recomputed, at most tau, and sizes; with a
                                   goal.ratio what it asks for instead; with cages the ratios of the hierarchy,
                                   that no cage is encroached (4.5), and 4.6.1 and 4.6.2 of neighbours */
    NETMESH_CHECK_BOUNDS = 16,  /* the bounds of netmesh_analyse: violated ones of chapters 3 (meshes) and 5 */
    NETMESH_CHECK_ALL = 31
} NETMESH_AN_INT netmesh_check_what;

typedef struct netmesh_check_request {
    uint32_t struct_bytes;
    uint32_t what; /* a union of netmesh_check_what; 0: ALL */
    netmesh_monitor monitor;
    const netmesh_request* promised; /* as of netmesh_load_request */
} netmesh_check_request;

/* Checks a triangulation or mesh. Nothing that the checkers read was cached by the code that made it. O(cells). Scratch
 * in the block, more than a diagram takes.
 * INVALID_ARGUMENT, NO_RESULT, CHECK_FAILED, OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_check(netmesh_context* context, const netmesh_check_request* request);

#ifdef __cplusplus
}
#endif
#endif
