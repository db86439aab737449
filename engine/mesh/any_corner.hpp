// A corner of a clipped cell whose dimension is a number at run time, beside corner.hpp.
#pragma once
#include "mesh/any_domain.hpp"
#include "mesh/corner.hpp"

namespace netmesh {

struct AnyCorner {
    int dim;
    double x[dimension_max] = {};
    double distance2 = -1;
    CellId cell = none;

    explicit AnyCorner(int dim) : dim(dim) {}
    template <int D>
    explicit AnyCorner(const Corner<D>& corner) : dim(D), distance2(corner.distance2), cell(corner.cell) {
        copy(D, corner.x, x);
    }
    template <int D> Corner<D> of_dimension() const {
        Corner<D> corner;
        copy<D>(x, corner.x);
        corner.distance2 = distance2;
        corner.cell = cell;
        return corner;
    }
    void offer(const double* at, double d2, CellId from) {
        if (!(d2 > distance2)) return;
        distance2 = d2;
        cell = from;
        copy(dim, at, x);
    }
};

}  // namespace netmesh
