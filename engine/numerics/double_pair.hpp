// Two doubles that take the same steps at the same time, to the same bits as one after the other.
#pragma once
#include <cstdint>

namespace netmesh {

using DoublePair = double __attribute__((vector_size(16)));
using PairMask = std::int64_t __attribute__((vector_size(16)));  // of each of the two all bits or none

inline DoublePair select(PairMask where, DoublePair a, DoublePair b) {
    return reinterpret_cast<DoublePair>((reinterpret_cast<PairMask>(a) & where) |
                                        (reinterpret_cast<PairMask>(b) & ~where));
}
inline void swap_where(PairMask where, PairMask& a, PairMask& b) {
    const PairMask differ = (a ^ b) & where;
    a ^= differ;
    b ^= differ;
}
inline void swap_where(PairMask where, DoublePair& a, DoublePair& b) {
    const PairMask differ = (reinterpret_cast<PairMask>(a) ^ reinterpret_cast<PairMask>(b)) & where;
    a = reinterpret_cast<DoublePair>(reinterpret_cast<PairMask>(a) ^ differ);
    b = reinterpret_cast<DoublePair>(reinterpret_cast<PairMask>(b) ^ differ);
}

}  // namespace netmesh
