// A domain whose dimension is a number at run time, beside any_store.hpp.
#pragma once
#include "delaunay/any_store.hpp"
#include "mesh/domain.hpp"

namespace netmesh {

struct AnyDomain {
    int dim;
    double centre[dimension_max];
    double radius, enclosing_radius;

    AnyDomain() = default;
    template <int D>
    AnyDomain(const Domain<D>& domain) : dim(D), radius(domain.radius), enclosing_radius(domain.enclosing_radius) {
        copy(D, domain.centre, centre);
    }
    template <int D> Domain<D> of_dimension() const {
        Domain<D> domain;
        copy<D>(centre, domain.centre);
        domain.radius = radius;
        domain.enclosing_radius = enclosing_radius;
        return domain;
    }
    double distance2(const double* x) const { return netmesh::distance2(dim, x, centre); }
    bool contains(const double* x) const { return distance2(x) <= radius * radius; }
};

inline int sphere_crossings(const AnyDomain& domain, const double* a, const double* b, double (&z)[2][dimension_max]) {
    return any_sphere_crossings(domain.dim, domain.centre, domain.radius, a, b, {z[0], z[1]});
}

}  // namespace netmesh
