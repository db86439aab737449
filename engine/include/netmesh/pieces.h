/* Alpha diagrams in pieces: any number of points, cores and machines, and the diagram of the whole.
 *
 * Points are cut into pieces by a tree. A leaf makes what a piece decides by itself and passes on what it cannot; a
 * join takes in what two neighbours passed on. What is collected from all of them is the diagram of netmesh_persist
 * with netmesh_filter_alpha, the same bars to the last digit. Leaves and joins are pure functions of what they are
 * given, so any scheduler may run them, anywhere, in any order that has children before parents, and again.
 *
 *     netmesh_split(context, &split)                     the order of the points, and boxes about them
 *     netmesh_leaf(context, &leaf)                       for the nodes pieces .. 2 pieces - 1
 *     netmesh_join(context, &join)                       for the nodes pieces - 1 down to 1, of 2 node and 2 node + 1
 *     netmesh_get_piece(context, &bytes, &count)         after each of these: to be kept, whole
 *     netmesh_collect(context, &collect)                 of all of them: the context holds the diagram
 *
 * Memory of a leaf is that of its points and of those about it (netmesh_plan_leaf), of a join what its two pieces hold
 * (join_bytes of netmesh_piece_info). */
#ifndef NETMESH_PIECES_H
#define NETMESH_PIECES_H

#include <stddef.h>
#include <stdint.h>

#include "context.h"
#include "points.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Points in the order of the tree, and boxes about the points of its nodes, from where the caller keeps them: memory,
 * a mapped file, a network. Neither function may throw; both give the same whenever they are asked the same. What they
 * return other than NETMESH_OK ends the call.
 *
 *   read   points[count][dim] and rows[count] of the positions first, first + 1, ..; at most 16 of them. rows: the
 *          number of the point in the input, by which ties are broken; all different
 *   box    box[2][dim] of node 1 .. 2^(levels + 1) - 1: the least coordinates of its points, then the greatest
 *
 * The points of node 1 are all; those of node i are, in order, first those of 2 i, half of them rounded down, and then
 * those of 2 i + 1. No two points are equal. */
typedef netmesh_status (*netmesh_read_points)(void* user, uint64_t first, uint32_t count, double* points,
                                              uint32_t* rows);
typedef netmesh_status (*netmesh_read_box)(void* user, uint32_t node, double* box);
typedef struct netmesh_source {
    uint32_t struct_bytes;
    uint32_t dim;    /* 2..6 */
    uint32_t levels; /* of nodes with boxes below node 1: count / 2^levels is at most 16, rounded up, and at least 1 */
    uint32_t reserved;    /* 0 */
    uint64_t count;       /* different points, 1 .. NETMESH_PIECES_POINTS_MAX */
    uint64_t rows;        /* of the input, duplicates among them */
    uint64_t fingerprint; /* of the input, as reports have it */
    netmesh_read_points read;
    netmesh_read_box box;
    void* user; /* handed to both */
} netmesh_source;

#define NETMESH_PIECES_POINTS_MAX 0x7FFFFFFF

/* Puts points in the order of the tree. They are halved at the median of their longest side, and so on. The context
 * holds nothing else then.
 *   memory   8 dim + 24 bytes a point, of which 5 + dim stay
 *   errors   NOT_FINITE (row index_a), INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED */
typedef struct netmesh_split_request {
    uint32_t struct_bytes;
    uint32_t pieces; /* a power of 2: so many at most will be made. 0: as 1 */
    netmesh_points points;
    netmesh_monitor monitor;
} netmesh_split_request;
netmesh_status netmesh_split(netmesh_context* context, const netmesh_split_request* request);

/* What netmesh_split has made, in the block. */
typedef struct netmesh_split_result {
    uint32_t struct_bytes;
    uint32_t dim;
    uint64_t count;        /* different points */
    uint64_t rows;         /* points */
    uint64_t fingerprint;  /* of the points */
    const uint32_t* order; /* [count] rows in the order of the tree; of equal points the first */
    const double* boxes;   /* [box_count][2][dim], of nodes 1, 2, .. */
    uint64_t box_count;
    uint32_t levels, reserved;
} netmesh_split_result;
/* NO_RESULT: there is none. */
netmesh_status netmesh_get_split(const netmesh_context* context, netmesh_split_result* result);

/* Which pieces. Those of one diagram are of one source and agree in all members but `node`. */
typedef struct netmesh_leaf_request {
    uint32_t struct_bytes;
    uint32_t pieces; /* a power of 2, at most 2^source->levels */
    const netmesh_source* source;
    uint32_t node;            /* pieces .. 2 pieces - 1 */
    uint32_t max_degree;      /* of the diagram; larger than dim - 1 counts as that */
    uint32_t keep_zero_pairs; /* 1: pairs with birth == death, too */
    uint32_t reserved;        /* 0 */
    netmesh_monitor monitor;
} netmesh_leaf_request;
/* The piece of one node, which the context then holds and nothing else.
 *   errors   NOT_FINITE, FLAT (all points are in one hyperplane), OUT_OF_RANGE, OUT_OF_MEMORY, CANCELLED, and what the
 *            source's functions return */
netmesh_status netmesh_leaf(netmesh_context* context, const netmesh_leaf_request* request);

/* Bytes of block to plan for a leaf of so many points in so many pieces, as measured on uniform points; those on a
 * sphere or a curve, or of few pieces that are all near each other, may take what netmesh_plan says of all and more.
 * 0: dim or pieces are none, or there are fewer points than pieces. SIZE_MAX: more than a size_t holds. O(1). */
size_t netmesh_plan_leaf(uint32_t dim, uint64_t points, uint32_t pieces);

/* Bytes of a piece, 8-byte aligned. They are read where they stand, before the call ends. */
typedef struct netmesh_piece {
    const void* bytes;
    size_t count;
} netmesh_piece;

typedef struct netmesh_join_request {
    uint32_t struct_bytes;
    netmesh_piece one, other; /* of nodes 2 n and 2 n + 1, in either order */
    netmesh_monitor monitor;
} netmesh_join_request;
/* The piece of node n, which the context then holds and nothing else.
 *   errors   INVALID_ARGUMENT (ONE or OTHER: damaged or not a piece; OTHER: of another job than the one, or no
 *            neighbour of it; the message says what), OUT_OF_MEMORY, CANCELLED */
netmesh_status netmesh_join(netmesh_context* context, const netmesh_join_request* request);

/* The piece that the context holds: one block of bytes, 8-byte aligned, whole or of no use. NO_RESULT: there is none.
 */
netmesh_status netmesh_get_piece(const netmesh_context* context, netmesh_piece* piece);

/* What bytes are a piece of. */
typedef struct netmesh_piece_info {
    uint32_t struct_bytes;
    uint32_t look_at_all; /* in: 0 for the head alone, 1 for all bytes, as a join does */
    uint32_t node, pieces, dim, max_degree, keep_zero_pairs, reserved;
    uint64_t points, rows, fingerprint; /* of the source */
    uint64_t simplices, bars;           /* of what is below the node; of the node alone */
    uint64_t bytes, head_bytes;         /* of the whole; as many from the first on are enough to collect */
    uint64_t join_bytes;                /* bytes of block to plan for a join: the sum of those of its two pieces */
    const char* fault;                  /* a static text: why the bytes are no piece; null: they are */
} netmesh_piece_info;
/* OK, CHECK_FAILED (info->fault), INVALID_ARGUMENT. */
netmesh_status netmesh_read_piece(const netmesh_piece* piece, netmesh_piece_info* info);

/* Gives piece i, for one that is kept in a file or far away: all in ascending order, to count bars, and then all once
 * more. What was given before is looked at no more. Does not throw. What it returns other than NETMESH_OK ends the
 * call. */
typedef netmesh_status (*netmesh_open_piece)(void* user, size_t i, netmesh_piece* piece);
typedef struct netmesh_collect_request {
    uint32_t struct_bytes;
    const netmesh_piece* pieces; /* [count] of all nodes, 1 .. 2 pieces - 1, in any order, or their heads; null: */
    netmesh_open_piece open;     /* gives them */
    void* user;                  /* handed to open */
    size_t count;
    netmesh_monitor monitor;
} netmesh_collect_request;
/* The diagram of all pieces: what the context holds is what netmesh_persist leaves of points and netmesh_filter_alpha.
 *   memory   16 bytes a bar
 *   errors   INVALID_ARGUMENT (PIECES; piece index_a), OUT_OF_MEMORY, CANCELLED, and what open says */
netmesh_status netmesh_collect(netmesh_context* context, const netmesh_collect_request* request);

#ifdef __cplusplus
}
#endif

#endif
