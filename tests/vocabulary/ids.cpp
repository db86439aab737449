// Identifiers, and values of the caller's function.
#include "vocabulary/ids.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

#include "numerics/bits.hpp"
#include "vocabulary/callback.hpp"

using namespace netmesh;

TEST_CASE("a facet is its cell and its position, in every dimension") {
    for (const std::uint32_t cell : {0u, 1u, 77u, FacetId::cells_max - 1, FacetId::cells_max})
        for (std::uint32_t position = 0; position <= NETMESH_DIM_MAX; ++position) {
            const FacetId facet(CellId(cell), position);
            CHECK(facet.cell() == CellId(cell));
            CHECK(facet.position() == position);
            CHECK(facet != FacetId(none));
            CHECK(FacetId::from_word(facet.word()) == facet);
            CHECK(facet != FacetId(CellId(cell), (position + 1) % 7));
        }
}

TEST_CASE("a function's -0.0 is 0.0") {
    netmesh_function function = {};
    function.evaluate = [](void*, const double* x) { return *x; };
    for (const double x : {-0.0, 0.0, 1.5, -2.0}) CHECK(bits_of(value_at(function, &x)) == bits_of(x == 0 ? 0.0 : x));
}
