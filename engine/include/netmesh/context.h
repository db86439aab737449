/* A context in the caller's block: version, limits, statuses and what an error is about, progress. */
#ifndef NETMESH_CONTEXT_H
#define NETMESH_CONTEXT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number is said here alone: others take it from here, or are compared with it (tests/tidy). */
#define NETMESH_VERSION_MAJOR 0
#define NETMESH_VERSION_MINOR 3
#define NETMESH_VERSION_PATCH 0
/* Versions as numbers that compare as the versions do. */
#define NETMESH_VERSION_NUMBER(major, minor, patch) (((uint32_t)(major) << 16) | ((uint32_t)(minor) << 8) | (patch))
#define NETMESH_VERSION NETMESH_VERSION_NUMBER(NETMESH_VERSION_MAJOR, NETMESH_VERSION_MINOR, NETMESH_VERSION_PATCH)

#define NETMESH_DIM_MIN 2
#define NETMESH_DIM_MAX 6
#define NETMESH_DEGREE_MAX 31          /* of homology, for filtrations that are not meshes */
#define NETMESH_NONE UINT32_MAX        /* no neighbour, no index */
#define NETMESH_POINTS_MAX (1ul << 28) /* points or vertices of one job */

/* The version of the library, which may differ from that of this header: a NETMESH_VERSION_NUMBER, and the same as
 * text: three numbers with dots between them. */
uint32_t netmesh_version(void);
const char* netmesh_version_text(void);

/* C lets a compiler make enumerations shorter than an int, the habit of ARM's toolchains (-fshort-enums). Those of this
 * interface are ints everywhere. */
#if defined(__ARM_SIZEOF_MINIMAL_ENUM) && __ARM_SIZEOF_MINIMAL_ENUM < 4
#define NETMESH_AN_INT __attribute__((mode(SI)))
#else
#define NETMESH_AN_INT
#endif

typedef enum netmesh_status {
    NETMESH_OK = 0,
    NETMESH_INVALID_ARGUMENT = 1, /* detail.field says which field; index_a: the row at fault, where there is one */
    NETMESH_OUT_OF_MEMORY = 2,    /* the block is too small; detail.bytes_wanted: at least this many are needed */
    NETMESH_CANCELLED = 3,        /* the poll function asked to stop */
    NETMESH_NOT_FINITE = 4,       /* point (simplex, vertex) index_a has a NaN or an infinity */
    NETMESH_OUT_OF_RANGE = 5,     /* point index_a: a magnitude that the method or the filter does not admit */
    NETMESH_FLAT = 6,             /* fewer than D+1 affinely independent points: no triangulation */
    NETMESH_TOO_CLOSE = 7,        /* points index_a < index_b are different but closer than the method admits: 64 units
                                     in the last place, more with a tau near 2 or a ratio below 2 */
    NETMESH_NO_RESULT = 8,        /* the call needs an earlier step that has not been done */
    NETMESH_CHECK_FAILED = 9,     /* a checker found a violation; detail.message says which. Also of what netmesh_load
                                     took over: the filter alpha always finds that it is no triangulation of a convex
                                     hull, other jobs may find that it is no triangulated ball */
    NETMESH_FLOATING_POINT = 10,  /* the floating-point mode is not IEEE double, round to nearest, no flush to zero */
    NETMESH_INTERNAL = 11,        /* an invariant of the library does not hold: a defect, please report it */
    NETMESH_NOT_A_COMPLEX = 12,   /* simplex index_a has no place in a filtered complex; detail.fault says why */
    NETMESH_NOT_BUILT = 13,       /* detail.field asks for what this build of the library leaves out (its
                                     netmesh_config.h); detail.message names the switch */
    NETMESH_PAUSED = 14,          /* the job waits for netmesh_resume (job.h) */
    NETMESH_STACK_OVERFLOW = 15   /* the job's stack was too small (job.h) */
} NETMESH_AN_INT netmesh_status;

/* With other options (-fshort-enums where it is no habit) structs differ from the library's: such a program does not
 * compile. */
typedef char netmesh_enumerations_are_ints[sizeof(netmesh_status) == sizeof(int) && sizeof(int) == 4 ? 1 : -1];

/* A short English phrase for a status; never null. */
const char* netmesh_status_text(netmesh_status status);

/* What the numbers of points are. */
typedef enum netmesh_point_format {
    NETMESH_POINTS_FLOAT64 = 0, /* double */
    NETMESH_POINTS_FLOAT32 = 1  /* float */
} NETMESH_AN_INT netmesh_point_format;

/* What an error is about: a field of a request, or another argument. A later version only adds to the end. */
typedef enum netmesh_field {
    NETMESH_FIELD_NONE = 0,
    NETMESH_FIELD_REQUEST,      /* the request is null */
    NETMESH_FIELD_STRUCT_BYTES, /* of the request, or of a struct that it points to: not set, or too new */
    NETMESH_FIELD_RESULT,       /* the struct or array for the result is null, or its struct_bytes are not set */
    /* what a diagram is of */
    NETMESH_FIELD_POINTS, /* coordinates; or there is more than one source, or none */
    NETMESH_FIELD_DIM,
    NETMESH_FIELD_POINT_COUNT,
    NETMESH_FIELD_POINT_FORMAT,
    NETMESH_FIELD_POINT_STRIDE_BYTES,
    NETMESH_FIELD_DISTANCES,
    NETMESH_FIELD_LAYOUT,
    NETMESH_FIELD_NUMBERS,
    NETMESH_FIELD_ENTRIES,
    NETMESH_FIELD_ENTRY_COUNT,
    NETMESH_FIELD_EVALUATE,
    NETMESH_FIELD_SIMPLICES,
    NETMESH_FIELD_VERTICES,
    NETMESH_FIELD_VERTEX_COUNT,
    NETMESH_FIELD_STARTS,
    NETMESH_FIELD_SIMPLEX_COUNT,
    NETMESH_FIELD_STEP_COUNT,
    /* filter */
    NETMESH_FIELD_FILTER,
    NETMESH_FIELD_VALUES,
    NETMESH_FIELD_K,
    NETMESH_FIELD_K_LAST,
    NETMESH_FIELD_MAX_DEGREE,
    NETMESH_FIELD_KEEP_ZERO_PAIRS,
    NETMESH_FIELD_THRESHOLD,
    NETMESH_FIELD_SEED,
    NETMESH_FIELD_FUNCTION,
    NETMESH_FIELD_LIPSCHITZ,
    NETMESH_FIELD_DISTANCE_FACTOR,
    NETMESH_FIELD_CUT,
    /* goal */
    NETMESH_FIELD_RATIO,
    NETMESH_FIELD_EPS,
    NETMESH_FIELD_THETA,
    NETMESH_FIELD_ERROR,
    NETMESH_FIELD_FOCUS_RATIO,
    NETMESH_FIELD_FOCUS_FROM,
    NETMESH_FIELD_FOCUS_TO,
    NETMESH_FIELD_LONGER_THAN,
    /* rules of meshes */
    NETMESH_FIELD_METHOD,
    NETMESH_FIELD_TAU,
    NETMESH_FIELD_DOMAIN_FACTOR,
    NETMESH_FIELD_NET_SPACING,
    NETMESH_FIELD_SIZES, /* sizes that were asked for, near point index_a where they cannot be met */
    NETMESH_FIELD_SIZE_EPS,
    NETMESH_FIELD_SIZE_AT_INPUTS,
    NETMESH_FIELD_SIZE_GROWTH,
    NETMESH_FIELD_FINISH,
    NETMESH_FIELD_WHOLE_CELLS,
    NETMESH_FIELD_AUDIT,
    /* wants */
    NETMESH_FIELD_BOUNDS,
    NETMESH_FIELD_CYCLES,
    NETMESH_FIELD_VINES,
    NETMESH_FIELD_FIT,
    NETMESH_FIELD_KEEP_MESH,
    /* meshes that are loaded, checks, analyses, distances of diagrams */
    NETMESH_FIELD_PROMISED, /* the request whose promises are checked */
    NETMESH_FIELD_MARKERS,
    NETMESH_FIELD_CELLS,
    NETMESH_FIELD_CELL_COUNT,
    NETMESH_FIELD_DOMAIN,
    NETMESH_FIELD_CAGES,
    NETMESH_FIELD_CAGE_COUNT,
    NETMESH_FIELD_CAGE_BYTES,
    NETMESH_FIELD_WHAT,
    NETMESH_FIELD_TOLERANCE,
    NETMESH_FIELD_ORDER,
    NETMESH_FIELD_THETAS,
    NETMESH_FIELD_SCALE,
    NETMESH_FIELD_SCRATCH,
    NETMESH_FIELD_PAIRS_A,
    NETMESH_FIELD_PAIRS_B,
    NETMESH_FIELD_PAIR_BYTES,
    NETMESH_FIELD_RELATIVE_ERROR,
    NETMESH_FIELD_MATES,
    NETMESH_FIELD_POTENTIALS,
    NETMESH_FIELD_SOURCE, /* of pieces: null, or without a function */
    NETMESH_FIELD_PIECES,
    NETMESH_FIELD_NODE,
    NETMESH_FIELD_ONE,
    NETMESH_FIELD_OTHER,
    NETMESH_FIELD_MONITOR, /* of any request: a user without a poll */
    /* points with weights */
    NETMESH_FIELD_WEIGHTS, /* points.weights; index_a: the row of a negative radius */
    NETMESH_FIELD_WEIGHT_STRIDE_BYTES,
    NETMESH_FIELD_WEIGHTING,
    NETMESH_FIELD_SQUARES,
    /* points that repeat */
    NETMESH_FIELD_LATTICE, /* points.lattice; index_a: the first vector at fault */
    NETMESH_FIELD_LATTICE_COUNT,
    NETMESH_FIELD_PERIODS,
    NETMESH_FIELD_COUNT
} NETMESH_AN_INT netmesh_field;

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
} NETMESH_AN_INT netmesh_fault;

/* What the last call has to say. Unused fields are 0. After OK the status is OK and the message is empty. */
typedef struct netmesh_detail {
    uint32_t struct_bytes;
    netmesh_status status;
    netmesh_field field; /* of INVALID_ARGUMENT */
    netmesh_fault fault; /* of NOT_A_COMPLEX */
    uint64_t index_a, index_b;
    uint64_t bytes_wanted;
    const char* message; /* static text, never null once the struct has been filled */
    uint64_t step;       /* of vines of simplices after NOT_A_COMPLEX and NOT_FINITE: the step at fault, from 1 on;
                            0: the complex itself */
} netmesh_detail;

typedef struct netmesh_context netmesh_context;

/* Makes a context at the start of block[0, block_bytes). block must be 16-byte aligned. Costs O(1).
 * INVALID_ARGUMENT (block or context null, block misaligned), OUT_OF_MEMORY, FLOATING_POINT. */
netmesh_status netmesh_init(void* block, size_t block_bytes, netmesh_context** context);

/* After a byte copy of the block: the context in the copy. Contexts hold no address but their block's, which is set
 * here, after a check. */
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
    NETMESH_STAGE_CHECK = 8,    /* independent checkers, and loading; unit: cells */
    NETMESH_STAGE_ANALYSE = 9,  /* pace, integral, fatness, structure; unit: points, boxes, vertices or cells */
    NETMESH_STAGE_COUNT = 10
} NETMESH_AN_INT netmesh_stage;

typedef struct netmesh_progress {
    uint32_t struct_bytes; /* of the library's struct */
    netmesh_stage stage;
    uint64_t done, total;     /* in units of the stage; total may be an estimate, 0 when unknown */
    uint64_t vertices, cells; /* of the mesh so far */
} netmesh_progress;

/* Called by every call that is given a netmesh_monitor, in all of its phases, in the mean about every 300,000
 * instructions, some hundred microseconds on a desktop processor. That is measured; there is no bound, as one star,
 * column or exact predicate is not divided, nor is what a function of the caller's takes. A non-zero return cancels:
 * the call that polls returns NETMESH_CANCELLED and polls no more. Where nothing can stop in the middle (sorting,
 * compaction of a finished mesh) it does so at the end of the phase. Must not call into the context, nor throw. */
typedef int (*netmesh_poll)(void* user, const netmesh_progress* progress);

/* Who watches a job. Every request has one. */
typedef struct netmesh_monitor {
    netmesh_poll poll; /* may be null, then user is null as well: INVALID_ARGUMENT (MONITOR) */
    void* user;        /* handed to poll */
} netmesh_monitor;

#ifdef __cplusplus
}
#endif
#endif
