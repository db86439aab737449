/* What a context holds and how it came about, part by part; and the figures of reports and analyses, one by one. */
#ifndef NETMESH_REPORT_H
#define NETMESH_REPORT_H

#include <stddef.h>
#include <stdint.h>

#include "diagram.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A report has a part for each result that a context can hold. A part that does not apply has present = 0, and all else
 * in it is 0. */

typedef struct netmesh_input_report {
    uint32_t present;            /* 1 after every job */
    uint32_t dim;                /* D; 0 for a complex given by its simplices */
    uint64_t points, duplicates; /* rows; rows merged into an earlier one */
    uint64_t distinct;           /* points - duplicates - hidden; inputs of a mesh, vertices of a complex */
    uint64_t fingerprint;        /* of the values only */
    uint64_t hidden;             /* with weights: points in no cell */
    netmesh_weighting_id weighting;
    uint32_t squares; /* 1: values are powers, not their signed roots */
    uint32_t periods; /* vectors of the lattice; 0: the points do not repeat */
    uint64_t copies;  /* with periods: points beside those given that were triangulated */
    double moved;     /* with periods: the farthest that a coordinate of a point or a lattice vector was moved */
} netmesh_input_report;

/* Of over-refinement. */
typedef struct netmesh_sizes_report {
    double eps;       /* asked for */
    double ratio_max; /* worst R_v / f(v), at most 1; 0 when none was asked for */
} netmesh_sizes_report;

/* Of methods with cages. */
typedef struct netmesh_hierarchy_report {
    uint32_t present;
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
    /* QUALITY: worst of all intermediate meshes; not of what a run with cages leaves that was cut off while a cage was
     * about to be released, as that one is taken away then. P: with cages the inserted points of the domain;
     * otherwise all points, as Steiner points are graded towards those that are still to be inserted. f_P: distance to
     * the second nearest of them. f_M: to the nearest Delaunay neighbour, for which the centre of a cage stands where
     * it is in one that is directly inside of the domain. */
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
    uint32_t is_mesh; /* 1: a mesh, made or loaded with a domain; 0: a triangulation, of which nothing that follows
                         `cells_created` is said */
    uint64_t vertices, inputs, steiner, exempt; /* vertices = inputs + steiner + exempt */
    uint64_t cells, cells_created;
    netmesh_method_id method;           /* what it was made by; SVR after load */
    double domain[NETMESH_DIM_MAX + 1]; /* centre, radius at index D */
    /* Worst clipped aspect ratio over vertices that are not exempt, of corners as computed; 0 if none. Where vertices
     * are so near to one another that coordinates blur the corners, 2^-28 of their size, one in truth may be a
     * thousandth larger, but not above tau. Infinite when the call that made the mesh was cancelled: then nobody waits
     * for it to be measured. */
    double aspect_ratio_max;
    double tau;        /* bound asked for; 0 for a mesh refined by the certificate */
    netmesh_goal goal; /* asked for: ratio and scales of interest */
    netmesh_sizes_report sizes;
    netmesh_hierarchy_report hierarchy;
    netmesh_audit_report audit;
    uint64_t touches; /* by point location, whatever made it look: distances to inputs, inputs compared with D-balls
                         (audit LOCATION), cells, domains and vertices passed; 0 after load */
    uint32_t clipped; /* 1: refined for cells clipped to the domain's ball; netmesh_persist with a filter that
                         clips_cells makes its radius a little smaller, to that of the ball that it clips to */
    uint32_t reserved_word;
    uint64_t reserved[2];
} netmesh_mesh_report;

typedef struct netmesh_diagram_report {
    uint32_t present;
    netmesh_filter_id filter; /* NONE: a complex given by its simplices */
    netmesh_values values;
    uint32_t max_degree;
    uint32_t k;                                 /* of filters with needs_k, else 0 */
    uint32_t representatives;                   /* 1: there is a cycle for each pair */
    uint64_t pairs[NETMESH_DEGREE_MAX + 1];     /* per degree, essential ones included */
    uint64_t essential[NETMESH_DEGREE_MAX + 1]; /* per degree: the Betti numbers of the complex up to the largest
                                                   double, which as a rule is all of it */
    uint64_t simplices; /* of the filtered complex; RIPS: of dimension up to max(1, max_degree) */
    /* c >= 1: log-bottleneck distance to the diagram of the offsets (of the sublevel sets of the function of KNN,
     * KDISTANCE and FUNCTION) is at most ln c. 1: each birth and death is the exact one, rounded to nearest. */
    double certified_ratio;
    double certified_ratio_best; /* the best ratio that any filter values on this mesh can certify (certified values) */
    double certified_from;       /* scale from which the ratio holds: 0, or r_P for the basic filter */
    double certified_focus;      /* of a fit with scales of interest: the largest sqrt(hi / lo), lo and hi the
                                    bounds of a Steiner vertex's cell that matters to them; else 0 */
    double certified_error;      /* FUNCTION: each pair moves by at most this, finite whatever the function: the
                                    bottleneck distance to the diagram of its sublevel sets; other filters: 0, none */
    double fitted_error;         /* of a fit of FUNCTION: the error that sizes of the mesh were asked for; 0:
                                    none were, or no such fit */
    netmesh_why why;             /* why this filter */
    uint32_t reserved_word;
    uint64_t tried_points, tried_cells; /* of the filter auto: points that its Delaunay triangulation had, and
                                           cells that were made for it, when it was whole or given up */
} netmesh_diagram_report;

/* Where bounds were wanted. */
typedef struct netmesh_bounds_report {
    uint32_t present;
    uint32_t max_degree;
    uint64_t certain[NETMESH_DEGREE_MAX + 1]; /* per degree: bars that are certified to exist */
    uint64_t steps;                           /* of the ratio as a function of scale */
    uint64_t reserved[2];
} netmesh_bounds_report;

/* Of a fit with longer_than, L. A bar is undecided when it is not certified to exist and its bounds do not exclude that
 * it stands for a true class that dies after L times its birth. */
typedef struct netmesh_decision_report {
    uint32_t present;
    uint32_t max_degree;
    double longer_than;                         /* L */
    uint64_t undecided[NETMESH_DEGREE_MAX + 1]; /* bars per degree */
    double undecided_to;                        /* the largest death_high of an undecided bar; 0: all are decided */
    double decided_from; /* true classes that die after L times their birth and after this each have a bar of their own
                            in the diagram, which is certified to exist; not below undecided_to, as classes that have no
                            bar at all are excluded, too */
    uint64_t reserved[2];
} netmesh_decision_report;

/* Of a diagram by the filter scales, whose `simplices` counts those of all scales. */
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
    netmesh_filter_id filter; /* NONE: of simplices */
    netmesh_values values;
    uint32_t max_degree;
    uint32_t k_first, k_last; /* of simplices 1 and step_count */
    uint64_t vines, points, transpositions;
    uint64_t simplices;     /* of the filtered complex */
    double certified_ratio; /* the largest of all k */
    uint64_t reserved[2];
} netmesh_vineyard_report;

/* Of simplices, distances, and filters on points. */
typedef struct netmesh_complex_report {
    uint32_t present;
    uint64_t vertices;
    uint64_t reserved[2];
} netmesh_complex_report;

/* peak_bytes: the least block, a multiple of 16, for what was called since the context last held nothing: in one of
 * that size the same calls end alike and leave the same results, byte for byte. It is the whole block where these
 * depend on its size: of a fit that went as far as memory allowed, of the filter auto that took a mesh for
 * want of memory, of audits of location. */
typedef struct netmesh_memory_report {
    uint64_t block_bytes, peak_bytes, used_bytes;
    uint64_t reserved[2];
} netmesh_memory_report;

typedef enum netmesh_predicate_stage {
    NETMESH_PREDICATE_CACHED = 0,  /* decided at first sight, with an error bound: by a cached circumsphere or, where
                                      points in the plane are triangulated, by a determinant */
    NETMESH_PREDICATE_FLOAT = 1,   /* floating-point determinant with an error bound */
    NETMESH_PREDICATE_INTEGER = 2, /* exact arithmetic of limited width */
    NETMESH_PREDICATE_EXACT = 3,   /* exact arithmetic of full width */
    NETMESH_PREDICATE_TIE = 4,     /* exactly degenerate, decided by the symbolic perturbation */
    NETMESH_PREDICATE_STAGES = 5
} NETMESH_AN_INT netmesh_predicate_stage;

/* Decisions of triangulation and mesh that ended in each stage. */
typedef struct netmesh_predicates_report {
    uint64_t in_ball[NETMESH_PREDICATE_STAGES];
    uint64_t orient[NETMESH_PREDICATE_STAGES];
    uint64_t reserved[2];
} netmesh_predicates_report;

typedef struct netmesh_report {
    uint32_t struct_bytes;
    uint32_t complete;    /* 1: mesh or triangulation, or where none is kept the diagram, is finished */
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
    netmesh_decision_report decision;
} netmesh_report;

/* report->struct_bytes must be set. O(vertices + cells + pairs), for the counts and the fingerprint.
 * INVALID_ARGUMENT. */
netmesh_status netmesh_get_report(const netmesh_context* context, netmesh_report* report);

typedef enum netmesh_figure_type {
    NETMESH_FIGURE_FLAG = 1, /* uint32_t, 0 or 1 */
    NETMESH_FIGURE_UINT32 = 2,
    NETMESH_FIGURE_UINT64 = 3,
    NETMESH_FIGURE_DOUBLE = 4,
    NETMESH_FIGURE_FINGERPRINT = 5, /* uint64_t, written in hexadecimal */
    NETMESH_FIGURE_NAME = 6         /* an enumeration; `text` is the value's name */
} NETMESH_AN_INT netmesh_figure_type;

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

#ifdef __cplusplus
}
#endif
#endif
