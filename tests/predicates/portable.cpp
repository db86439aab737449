// The engine's sources once more, in a namespace of their own and without 128-bit integers.
#define NETMESH_PORTABLE_WIDE
#define netmesh netmesh_portable
#include "numerics/residues.cpp"
#include "predicates/predicates.cpp"
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
    switch (dim) {
    case 2: return orient_of<2>(points);
    case 3: return orient_of<3>(points);
    case 4: return orient_of<4>(points);
    case 5: return orient_of<5>(points);
    default: return orient_of<6>(points);
    }
}

int portable_in_ball(int dim, const double* const* points) {
    switch (dim) {
    case 2: return in_ball_of<2>(points);
    case 3: return in_ball_of<3>(points);
    case 4: return in_ball_of<4>(points);
    case 5: return in_ball_of<5>(points);
    default: return in_ball_of<6>(points);
    }
}
