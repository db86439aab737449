/* What holds of a triangulation or mesh beyond its promises: cells and balls measured, size, structure and fatness
 * analysed, inputs ordered. Nothing of it is needed for a diagram. */
#ifndef NETMESH_LABORATORY_H
#define NETMESH_LABORATORY_H

#include <stddef.h>
#include <stdint.h>

#include "mesh.h"
#include "report.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Measures each vertex's cell: ratios[vertices] gets its clipped aspect ratio, 0 for exempt vertices and for those of
 * the shell of a released cage that are out of the domain with their cells; domains[vertices] the innermost cage that
 * it is in, NETMESH_NONE for none. Of a Delaunay triangulation: the aspect ratio of the whole cell, +infinity on the
 * hull or where doubles do not know a corner; 0 for points that are not inserted. Scratch in the block.
 * INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY. */
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

/* Measures all cells, and all D-balls: cells[vertices] in the order of netmesh_get_vertex, balls[cells] in that of
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
    double cage_in_radius;  /* of the cage's cell, which stands for the one above: half of the distance from c to the
                               nearest vertex outside, measured from the shell */
    double cage_out_radius; /* of the cage's cell: its farthest point in the domain's ball */
} netmesh_weighted_cell;

/* cells[cages], in the order of netmesh_get_cage; none of a mesh without cages. cells[0].struct_bytes is set by the
 * caller, as for netmesh_measure_voronoi. Scratch in the block. O(cages * vertices). INVALID_ARGUMENT, NO_RESULT,
 * OUT_OF_MEMORY. */
netmesh_status netmesh_weighted_cells(netmesh_context* context, netmesh_weighted_cell* cells);

typedef enum netmesh_analyse_what {
    NETMESH_ANALYSE_SIZE = 1, /* a mesh only */
    NETMESH_ANALYSE_STRUCTURE = 2,
    NETMESH_ANALYSE_FATNESS = 4,
    NETMESH_ANALYSE_ALL = 7
} NETMESH_AN_INT netmesh_analyse_what;

typedef struct netmesh_analyse_request {
    uint32_t struct_bytes;
    uint32_t what; /* a union of netmesh_analyse_what; 0: ALL */
    netmesh_monitor monitor;
    double tolerance; /* wanted upper / lower - 1 of the integrals, >= 0; 0: 0.1, 0.25, 1, 4, 16 for D = 2..6; large
                         inputs, and the boundary in high D, get less */
    const netmesh_request* promised; /* as of netmesh_load_request */
} netmesh_analyse_request;

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

/* Analyses what the context holds. analysis->struct_bytes must be set. Scratch: 8 to 60 bytes a vertex, with cages 8 a
 * cell.
 * INVALID_ARGUMENT, NO_RESULT (no triangulation; SIZE without a mesh), OUT_OF_MEMORY, CANCELLED. */
netmesh_status netmesh_analyse(netmesh_context* context, const netmesh_analyse_request* request,
                               netmesh_analysis* analysis);

/* An ordering order[inputs] of the input vertices, from one far from input 0, always one of those farthest from all
 * before, and its theta[inputs] (may be null; 1 for the first two). It is theta-well-paced (3.8) for its least theta_i,
 * and no ordering that begins with a diameter is so for more than 2 theta / (1 - 3 theta), theta < 1/5. O(n log n) on
 * inputs of moderate spread. Distances must have squares that a double holds, as those of meshes do.
 * INVALID_ARGUMENT, NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_well_paced_order(netmesh_context* context, uint32_t* order, double* theta);

/* theta[inputs] of a given permutation order[inputs] of the input vertices. INVALID_ARGUMENT (ORDER: no permutation),
 * NO_RESULT, OUT_OF_MEMORY. */
netmesh_status netmesh_pace(netmesh_context* context, const uint32_t* order, double* theta);

/* Figure `index` of an analysis, from 0 on, as netmesh_get_report_figure. */
netmesh_status netmesh_get_analysis_figure(const netmesh_analysis* analysis, uint32_t index, netmesh_figure* figure);

#ifdef __cplusplus
}
#endif
#endif
