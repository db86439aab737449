// A domain whose dimension is a number at run time, beside any_store.hpp.
#pragma once
#include "delaunay/any_store.hpp"
#include "mesh/domain.hpp"

namespace netmesh {

template <> struct Domain<any_dimension> {
    AnyDimension dim;
    double centre[dimension_max];
    double radius, enclosing_radius;

    Domain() = default;
    template <int D>
    Domain(const Domain<D>& domain) : dim(D), radius(domain.radius), enclosing_radius(domain.enclosing_radius) {
        copy(D, domain.centre, centre);
    }
    template <int D> Domain<D> of_dimension() const {
        if constexpr (D == any_dimension) {
            return *this;
        } else {
            Domain<D> domain;
            copy<D>(centre, domain.centre);
            domain.radius = radius;
            domain.enclosing_radius = enclosing_radius;
            return domain;
        }
    }
    double distance2(const double* x) const { return netmesh::distance2(dim, x, centre); }
    bool contains(const double* x) const { return distance2(x) <= radius * radius; }
};
using AnyDomain = Domain<any_dimension>;

template <>
inline void smallest_enclosing_ball<any_dimension>(const AnyStore& store, std::uint32_t count, AnyDomain& domain) {
    const PointRows points = {store.dim, store.first_point(), store.point_stride(), count};
    domain.dim = store.dim;
    domain.enclosing_radius = enclosing_radius_of_inputs(points, store.arena, domain.centre);
    domain.radius = 0;
}

inline int sphere_crossings(const AnyDomain& domain, const double* a, const double* b, double (&z)[2][dimension_max]) {
    return any_sphere_crossings(domain.dim, domain.centre, domain.radius, a, b, {z[0], z[1]});
}

}  // namespace netmesh
