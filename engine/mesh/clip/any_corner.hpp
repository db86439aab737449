// A corner of a clipped cell whose dimension is a number at run time, beside corner.hpp.
#pragma once
#include "mesh/any_domain.hpp"
#include "mesh/clip/corner.hpp"

namespace netmesh {

template <> struct Corner<any_dimension> {
    AnyDimension dim;
    double x[dimension_max] = {};
    double distance2 = -1;
    CellId cell = none;

    explicit Corner(int dim) : dim(dim) {}
    template <int D> explicit Corner(const Corner<D>& corner) : dim(D), distance2(corner.distance2), cell(corner.cell) {
        copy(D, corner.x, x);
    }
    template <int D> Corner<D> of_dimension() const {
        Corner<D> corner(dim);
        copy<D>(dim, x, corner.x);
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
using AnyCorner = Corner<any_dimension>;

}  // namespace netmesh
