// On points in general position the Delaunay triangulation is unique: ours must equal CGAL's cell by cell.
#pragma once
#include <doctest/doctest.h>

#include "common/session.hpp"

template <int D> using Cells = std::vector<std::array<std::uint32_t, D + 1>>;

// `cgal` makes the list of cells that Session::cells makes, out of CGAL.
template <int D, class Cgal> void compare_with_cgal(std::size_t n, Cgal cgal) {
    const std::pair<const char*, inputs::Points> cases[] = {{"uniform", inputs::uniform(D, n, 11)},
                                                            {"gaussian", inputs::gaussian(D, n, 12)},
                                                            {"clusters", inputs::clusters(D, n, 13)}};
    for (const auto& [name, points] : cases) {
        INFO("D = " << D << ", " << name << ", " << n << " points");
        Session session(D);
        REQUIRE(session.delaunay(points) == NETMESH_OK);
        const Cells<D> ours = session.cells<D + 1>(), theirs = cgal(points);
        REQUIRE(theirs.size() > n);
        CHECK(ours.size() == theirs.size());
        CHECK((ours == theirs));
        CHECK(session.check() == NETMESH_OK);
    }
}
