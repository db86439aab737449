// The engine's sources once more, in a namespace of their own and as where size counts.
#ifndef __OPTIMIZE_SIZE__
#define __OPTIMIZE_SIZE__ 1
#endif
#define netmesh netmesh_small
#include "numerics/residue_minors.cpp"
#include "numerics/residues.cpp"
#include "predicates/predicates.cpp"
#include "predicates/undecided.cpp"
#undef netmesh

#include "portable.hpp"

namespace {

template <int D> int orient_of(const double* const* points) {
    netmesh_small::PredicateCounts counts{};
    return static_cast<int>(netmesh_small::orient<D>(points, counts));
}
template <int D> int in_ball_of(const double* const* points) {
    netmesh_small::PredicateCounts counts{};
    return static_cast<int>(netmesh_small::in_ball<D>(points, points[D + 1], counts));
}

}  // namespace

int small_orient(int dim, const double* const* points) {
    return netmesh_small::with_dimension(static_cast<std::uint32_t>(dim), [&](auto d) { return orient_of<d>(points); });
}

int small_in_ball(int dim, const double* const* points) {
    return netmesh_small::with_dimension(static_cast<std::uint32_t>(dim),
                                         [&](auto d) { return in_ball_of<d>(points); });
}
