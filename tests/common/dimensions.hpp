// The dimensions that tests run in: those that the build serves, as vocabulary/dimension.hpp lists them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <vector>

#include "include/netmesh.h"
#include "vocabulary/dimension.hpp"

// Types for doctest, with the dimension in ::value:
//     TEST_CASE_TEMPLATE_DEFINE("...", T, name) { constexpr int D = T::value; ... }
//     TEST_CASE_TEMPLATE_APPLY(name, Dimensions<>);          // all of them
//     TEST_CASE_TEMPLATE_APPLY(name, Dimensions<3, 4>);      // those of 3 and 4 that are served
template <int D, int lowest, int highest>
using OneDimension = std::conditional_t<(D >= lowest && D <= highest), std::tuple<netmesh::Dimension<D>>, std::tuple<>>;
#define NETMESH_ONE(D) OneDimension<D, lowest, highest>{},
template <int lowest = 0, int highest = NETMESH_DIM_MAX>
using Dimensions = decltype(std::tuple_cat(NETMESH_EACH_DIMENSION(NETMESH_ONE) std::tuple<>{}));
#undef NETMESH_ONE

// Calls f(Dimension<D>{}) for each dimension served from lowest to highest.
template <int lowest = 0, int highest = NETMESH_DIM_MAX, class F> void for_each_dimension(F&& f) {
    std::apply([&](auto... dimension) { (f(dimension), ...); }, Dimensions<lowest, highest>{});
}

// For loops over numbers: those served from lowest to highest.
inline std::vector<int> dimensions(int lowest = 0, int highest = NETMESH_DIM_MAX) {
    std::vector<int> served;
    for (int dim = lowest; dim <= highest; ++dim)
        if (netmesh::serves_dimension(static_cast<std::uint32_t>(dim))) served.push_back(dim);
    return served;
}
// Those of `wanted` that are served.
inline std::vector<int> dimensions(std::initializer_list<int> wanted) {
    std::vector<int> served;
    for (const int dim : wanted)
        if (netmesh::serves_dimension(static_cast<std::uint32_t>(dim))) served.push_back(dim);
    return served;
}

// The figure of dimension dim in a list that begins with that of the plane.
template <class T> constexpr T by_dimension(int dim, std::initializer_list<T> from_plane) {
    if (dim < 2 || static_cast<std::size_t>(dim - 2) >= from_plane.size())
        throw std::out_of_range("no figure for this dimension");
    return from_plane.begin()[dim - 2];
}
