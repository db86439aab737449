/* Distances of two diagrams: bottleneck, and the cost of transport from one to the other. */
#ifndef NETMESH_DISTANCE_H
#define NETMESH_DISTANCE_H

#include <stddef.h>
#include <stdint.h>

#include "diagram.h"

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
    uint32_t degree; /* default: NETMESH_ALL_DEGREES, the largest distance of all degrees */
    netmesh_scale scale;
    void* scratch; /* 16-byte aligned, scratch_bytes >= netmesh_bottleneck_bytes */
    size_t scratch_bytes;
} netmesh_bottleneck_request;
/* A request with its defaults, of the sizes that the caller's compiler knows. */
static inline netmesh_bottleneck_request netmesh_default_bottleneck(void) {
    netmesh_bottleneck_request request = NETMESH_ZERO;
    request.struct_bytes = sizeof request;
    request.pair_bytes = sizeof(netmesh_pair);
    request.degree = NETMESH_ALL_DEGREES;
    return request;
}

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

#define NETMESH_ORDER_MAX 16

typedef struct netmesh_wasserstein_request {
    uint32_t struct_bytes;
    uint32_t pair_bytes;         /* sizeof(netmesh_pair), from one pair to the next; not below that of version 0.2 */
    netmesh_monitor monitor;     /* can only cancel, its progress is empty */
    const netmesh_pair* pairs_a; /* [count_a], in any order; their struct_bytes are not read */
    const netmesh_pair* pairs_b; /* [count_b] */
    uint64_t count_a, count_b;
    uint32_t degree;       /* default: NETMESH_ALL_DEGREES, the p-norm of the distances of all degrees */
    uint32_t order;        /* p, 1 to NETMESH_ORDER_MAX; default: 1 */
    double relative_error; /* at least 2^-30, finite; default: 0.001 */
    void* scratch;         /* 16-byte aligned, scratch_bytes >= netmesh_wasserstein_bytes */
    size_t scratch_bytes;
    /* Outputs that may be null; only with one degree. Index into pairs_b of the pair that each of a is matched to,
     * NETMESH_NONE for those on their way to the diagonal and those of other degrees. */
    uint32_t* mates_a; /* [count_a] */
    /* Potentials f that prove `lower`, in units of the result's exponent: with e = 2^exponent, f(a) <= (e l / 2)^p for
     * a bar of length l, and likewise f(b); f(a) + f(b) <= (e d(a, b))^p, without rounding. (e lower)^p is at most the
     * sum of all f and of what essential pairs cost; of more than 2^16 pairs and with a relative_error below 2^-20 the
     * rounding of potentials to doubles may keep up to 2^-49 of the sum of their sizes from that. 0 for essential
     * pairs, those of length 0 and those of other degrees. */
    double* potentials_a; /* [count_a] */
    double* potentials_b; /* [count_b] */
} netmesh_wasserstein_request;
/* A request with its defaults, of the sizes that the caller's compiler knows. */
static inline netmesh_wasserstein_request netmesh_default_wasserstein(void) {
    netmesh_wasserstein_request request = NETMESH_ZERO;
    request.struct_bytes = sizeof request;
    request.pair_bytes = sizeof(netmesh_pair);
    request.degree = NETMESH_ALL_DEGREES;
    request.order = 1;
    request.relative_error = 0.001;
    return request;
}

/* Bytes of scratch for count_a and count_b pairs, about 92 a pair; SIZE_MAX when they do not fit or there are more than
 * 2^25 pairs; 0 on an invalid request. */
size_t netmesh_wasserstein_bytes(const netmesh_wasserstein_request* request);

typedef struct netmesh_wasserstein_distance {
    uint32_t struct_bytes;
    int32_t exponent; /* of the unit of potentials */
    double value;     /* what the best matching found costs, rounded up: no less than the distance */
    double lower;     /* no more than the distance */
} netmesh_wasserstein_distance;

/* Wasserstein distance of order p between two diagrams: the least (sum of d^p)^(1/p) over all ways to match pairs one
 * to one, or to the diagonal. d is the larger of the moves of birth and death, as in the bottleneck distance, which is
 * the limit for large p; half of the length for a way to the diagonal. Essential pairs are matched to essential pairs
 * by birth; where their numbers differ both bounds are infinite. Births are finite, death >= birth.
 *
 * With OK the distance is from `lower` to `value`, all roundings included, and value <= (1 + relative_error) lower,
 * with two exceptions of the doubles. A bound below 2^-1022 is the next multiple of 2^-1074. A distance is finite where
 * the numbers of essential pairs agree: beyond the largest double `lower` is that double and `value` infinite. Both are
 * 0 only for a distance of 0. Every admitted diagram and relative_error has an OK, but for memory and cancelling.
 * INTERNAL: the bounds stayed farther apart than relative_error, a defect; *distance is left. The result is a function
 * of the pairs, their order and the request, to the last bit.
 *
 * No context is needed; detail, which may be null, gets what a context would keep. Expected cost about O(n^1.5 log n),
 * more the smaller the error. INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED, INTERNAL. */
netmesh_status netmesh_wasserstein(const netmesh_wasserstein_request* request, netmesh_wasserstein_distance* distance,
                                   netmesh_detail* detail);

#ifdef __cplusplus
}
#endif
#endif
