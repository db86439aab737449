// The engine's sources once more, in a namespace of their own and without 128-bit integers.
#define NETMESH_PORTABLE_WIDE
#define netmesh netmesh_portable
#include "numerics/residue_minors.cpp"
#include "numerics/residues.cpp"
#include "predicates/predicates.cpp"
#include "predicates/undecided.cpp"
#undef netmesh

#include "portable.hpp"

namespace {

template <int D> int orient_of(const double* const* points) {
    netmesh_portable::PredicateCounts counts{};
    return static_cast<int>(netmesh_portable::orient<D>(points, counts));
}
template <int D> int in_ball_of(const double* const* points) {
    netmesh_portable::PredicateCounts counts{};
    return static_cast<int>(netmesh_portable::in_ball<D>(points, points[D + 1], counts));
}

}  // namespace

int portable_orient(int dim, const double* const* points) {
    return netmesh_portable::with_dimension(static_cast<std::uint32_t>(dim),
                                            [&](auto d) { return orient_of<d>(points); });
}

int portable_in_ball(int dim, const double* const* points) {
    return netmesh_portable::with_dimension(static_cast<std::uint32_t>(dim),
                                            [&](auto d) { return in_ball_of<d>(points); });
}
