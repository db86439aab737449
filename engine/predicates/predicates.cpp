#include "predicates/predicates.hpp"

#include "predicates/cascade.hpp"

namespace netmesh {

template <int D> Sign orient(const double* const* p, PredicateCounts& counts) {
    if constexpr (D == 1) {
        ++counts.calls[stage_float];
        return static_cast<Sign>((p[1][0] > p[0][0]) - (p[1][0] < p[0][0]));
    } else {
        const Decision d = decide<D, false>(p);
        ++counts.calls[d.stage];
        return d.sign;
    }
}

template <int D> Decision decide_in_ball(const double* const* cell, const double* q) {
    const double* points[D + 2];
    for (int i = 0; i <= D; ++i) points[i] = cell[i];
    points[D + 1] = q;
    return decide<D, true>(points);
}

template <int D> Sign in_ball(const double* const* cell, const double* q, PredicateCounts& counts) {
    const Decision d = decide_in_ball<D>(cell, q);
    ++counts.calls[d.stage];
    return d.sign;
}

// Perturbation: the lift of point i is |x|^2 + w_i with w_i positive, infinitely small, and infinitely larger than
// every w_j with j < i. On the sphere, with q = sum of lambda_k p_k, sum of lambda_k = 1, the lifted hyperplane of the
// cell rises above q by sum of lambda_k w_k while q itself rises by w_q: q is inside exactly if the difference
//     sum of lambda_k w_k - w_q
// is positive. Its sign is that of the first coefficient that is not zero in descending order of the indices. q has the
// coefficient -1, so at the latest q decides. lambda_k has the sign of orient of the cell with q in the place of p_k.
// As a weight depends on nothing but the index, all answers belong to one lifted point set; as the paraboloid is
// strictly convex, weights this small hide no point.
template <int D>
[[gnu::noinline]] Sign break_tie(const double* const* cell, const std::uint32_t* ids, const double* q,
                                 std::uint32_t q_id) {
    const double* moved[D + 1];
    for (int i = 0; i <= D; ++i) moved[i] = cell[i];
    std::uint32_t bound = 0;
    bool bounded = false;
    for (;;) {
        int next = -1;  // the highest index below bound; -1: that of q
        std::uint32_t highest = q_id;
        for (int i = 0; i <= D; ++i)
            if (ids[i] > highest && (!bounded || ids[i] < bound)) {
                highest = ids[i];
                next = i;
            }
        if (next < 0) return Sign::negative;
        moved[next] = q;
        const Sign lambda = decide<D, false>(moved).sign;
        moved[next] = cell[next];
        if (lambda != Sign::zero) return lambda;
        bound = highest;
        bounded = true;
    }
}

template <int D>
Sign in_ball_perturbed(const double* const* cell, const std::uint32_t* ids, const double* q, std::uint32_t q_id,
                       PredicateCounts& counts) {
    const Decision d = decide_in_ball<D>(cell, q);
    if (d.sign != Sign::zero) {
        ++counts.calls[d.stage];
        return d.sign;
    }
    ++counts.calls[stage_tie];
    return break_tie<D>(cell, ids, q, q_id);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Sign orient<D>(const double* const*, PredicateCounts&);                                                   \
    template Sign in_ball<D>(const double* const*, const double*, PredicateCounts&);                                   \
    template Sign in_ball_perturbed<D>(const double* const*, const std::uint32_t*, const double*, std::uint32_t,       \
                                       PredicateCounts&);

template Sign orient<1>(const double* const*, PredicateCounts&);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)

}  // namespace netmesh
