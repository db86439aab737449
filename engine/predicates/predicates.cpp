#include "predicates/predicates.hpp"

#include "predicates/cascade.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D> Sign orient(const double* const* p, PredicateCounts& counts) {
    if constexpr (D == 1) {
        ++counts.calls[stage_float];
        return static_cast<Sign>((p[1][0] > p[0][0]) - (p[1][0] < p[0][0]));
    } else {
        const Decision d = decide_orient<D>(p);
        ++counts.calls[d.stage];
        return d.sign;
    }
}

namespace {

// orient_projected for k >= K.
template <int K> Sign orient_from(int k, const double* const* p, const int* axes, PredicateCounts& counts) {
    if constexpr (K < dimension_most())
        if (k > K) return orient_from<K + 1>(k, p, axes, counts);
    double x[K + 1][K];
    const double* rows[K + 1];
    for (int i = 0; i <= K; ++i) {
        for (int j = 0; j < K; ++j) x[i][j] = p[i][axes[j]];
        rows[i] = x[i];
    }
    return orient<K>(rows, counts);
}

}  // namespace

Sign orient_projected(int k, const double* const* p, const int* axes, PredicateCounts& counts) {
    return orient_from<1>(k, p, axes, counts);
}

// A question about one cell and one point, and what the float stage found out on the way.
template <int D> struct InBall {
    const double* points[D + 2];
    double minors[D + 1];
    bool minors_exact;
    Decision decision;

    InBall(const double* const* cell, const double* q) {
        for (int i = 0; i <= D; ++i) points[i] = cell[i];
        points[D + 1] = q;
        decision = decide_in_ball<D>(points, minors, &minors_exact);
    }
    // Orientation of the cell with q in the place of point k. Moving q to the end as the base takes D - k
    // transpositions, and the base at the end D more.
    int orient_with(int k) {
        if (minors_exact) return (k & 1) != 0 ? -sign_of(minors[D - k]) : sign_of(minors[D - k]);
        const double* const kept = points[k];
        points[k] = points[D + 1];
        const Sign sign = decide_orient<D>(points).sign;
        points[k] = kept;
        return static_cast<int>(sign);
    }
};

template <int D> Sign in_ball(const double* const* cell, const double* q, PredicateCounts& counts) {
    const Decision d = InBall<D>(cell, q).decision;
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
template <int D> Sign break_tie(InBall<D>& question, const VertexId* ids, VertexId q_id) {
    std::uint32_t bound = 0;
    bool bounded = false;
    for (;;) {
        int next = -1;  // the highest index below bound; -1: that of q
        VertexId highest = q_id;
        for (int i = 0; i <= D; ++i)
            if (ids[i] > highest && (!bounded || ids[i] < bound)) {
                highest = ids[i];
                next = i;
            }
        if (next < 0) return Sign::negative;
        const int lambda = question.orient_with(next);
        if (lambda != 0) return static_cast<Sign>(lambda);
        bound = highest;
        bounded = true;
    }
}

template <int D>
Sign in_ball_perturbed(const double* const* cell, const VertexId* ids, const double* q, VertexId q_id,
                       PredicateCounts& counts) {
    InBall<D> question(cell, q);
    const Decision d = question.decision;
    if (d.sign != Sign::zero) {
        ++counts.calls[d.stage];
        return d.sign;
    }
    ++counts.calls[stage_tie];
    return break_tie<D>(question, ids, q_id);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Sign orient<D>(const double* const*, PredicateCounts&);                                                   \
    template Sign in_ball<D>(const double* const*, const double*, PredicateCounts&);                                   \
    template Sign in_ball_perturbed<D>(const double* const*, const VertexId*, const double*, VertexId,                 \
                                       PredicateCounts&);

template Sign orient<1>(const double* const*, PredicateCounts&);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
