#include "numerics/residue_minors.hpp"

namespace netmesh {
namespace {

inline std::uint64_t residue_minor(int k, const ResidueMatrix& a, const MinorTerm* term, const std::uint64_t* below,
                                   const ResiduePrime& prime) {
    UnsignedSum sum;
    for (int j = 0; j < k; ++j) sum.add_product(a.entry[k - 1][(k - 1 - j) & 1][term[j].row], below[term[j].below]);
    return reduce(sum, prime);
}

#ifndef __OPTIMIZE_SIZE__
// From those of order K-1. K is known when compiling, for the loop over members is as short as it.
template <int K>
const std::uint64_t* residue_minors_from(int n, int order, const ResidueMatrix& a, const std::uint64_t* below,
                                         ResidueLevels& level, const ResiduePrime& prime) {
    if (K > order) return below;
    if constexpr (K <= minor_rows_max) {
        const MinorTerm* term = minor_table.term + minor_terms_at(K);
        std::uint64_t* const out = level[K & 1];
        const int count = binomial(n, K);
        for (int s = 0; s < count; ++s, term += K) out[s] = residue_minor(K, a, term, below, prime);
        below = residue_minors_from<K + 1>(n, order, a, out, level, prime);
    }
    return below;
}
#endif

}  // namespace

const std::uint64_t* residue_minors(int n, int order, const ResidueMatrix& a, ResidueLevels& level,
                                    const ResiduePrime& prime) {
    const std::uint64_t* below = a.entry[0][0];
#ifdef __OPTIMIZE_SIZE__
    const MinorTerm* first = minor_table.term;
    for (int k = 2; k <= order; ++k) {
        const MinorTerm* term = first;
        std::uint64_t* const out = level[k & 1];
        for (int s = 0; s < binomial(n, k); ++s, term += k) out[s] = residue_minor(k, a, term, below, prime);
        first += binomial(minor_rows_max, k) * k;
        below = out;
    }
#else
    below = residue_minors_from<2>(n, order, a, below, level, prime);
#endif
    return below;
}

}  // namespace netmesh
