/* The distance of two diagrams. */
#ifndef NETMESH_BOTTLENECK_H
#define NETMESH_BOTTLENECK_H

#include <stddef.h>
#include <stdint.h>

#include "persistence.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum netmesh_scale {
    NETMESH_SCALE_PLAIN = 0, /* differences of radii */
    NETMESH_SCALE_LOG = 1    /* differences of their logarithms */
} NETMESH_AN_INT netmesh_scale;

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
 * value is +infinity. The exact distance (ratio), rounded once to the nearest, the even one of two: in PLAIN scale to a
 * double, so that half of 2^-1074 is 0 and what rounds to 2^1024 infinite; in LOG scale to 53 bits with any exponent.
 * Costs are compared as rounded. Rounding is monotone, so the least over all matchings is the rounded least. A function
 * of the two sets of pairs and the scale, to the last bit; the same for (a, b) and (b, a). */
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

#ifdef __cplusplus
}
#endif
#endif
