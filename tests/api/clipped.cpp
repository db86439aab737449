// Meshes refined for cells clipped to a ball: smaller, with the same promise, whatever is done with them.
#include <doctest/doctest.h>

#include <cmath>

#include "common/arrays.hpp"
#include "common/bottleneck.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

inputs::Points some_points(int dim) {
    if (dim == 3) return inputs::shell(3, 120, 0.9, 1, 5);
    return inputs::uniform(dim, by_dimension(dim, {150, 0, 30, 8, 0}), 23);
}

// So low that the few points of five dimensions need Steiner points too; six would take a minute.
double ratio_of(int dim) { return dim > 4 ? 1.7 : 2.3; }

// Refined by the certificate, with the diagram of the complete filter.
class Refined : public Session {
public:
    Refined(int dim, const inputs::Points& points, bool whole) : Session(dim) {
        request.goal.ratio = ratio_of(dim);
        request.mesh.whole_cells = whole ? 1 : 0;
        REQUIRE(mesh_and_persist(points) == NETMESH_OK);
        CHECK(report().mesh.clipped == (whole ? 0 : 1));
        CHECK(report().diagram.certified_ratio <= ratio_of(dim));
        CHECK(check() == NETMESH_OK);
    }
};

double far_from(const netmesh_mesh_report& mesh, int dim, const double* x) {
    double d2 = 0;
    for (int k = 0; k < dim; ++k) d2 += (x[k] - mesh.domain[k]) * (x[k] - mesh.domain[k]);
    return std::sqrt(d2);
}

}  // namespace

TEST_CASE("clipped cells need fewer vertices for the same ratio, and both diagrams agree as their ratios say") {
    for (const int dim : dimensions(2, 5)) {
        CAPTURE(dim);
        const inputs::Points points = some_points(dim);
        const Refined clipped(dim, points, false), whole(dim, points, true);
        const netmesh_report a = clipped.report(), b = whole.report();
        CHECK(a.mesh.vertices < b.mesh.vertices);
        const Distance apart = bottleneck(clipped.pairs(), whole.pairs(), NETMESH_SCALE_LOG);
        REQUIRE(apart.status == NETMESH_OK);
        CHECK(apart.value <= a.diagram.certified_ratio * b.diagram.certified_ratio);  // factors, not their logarithms
        CHECK(apart.value > 1);
        // The ball holds the points and all that was refined.
        double farthest = 0;
        for (const netmesh_vertex& v : clipped.vertices()) {
            const double d = far_from(a.mesh, dim, v.coordinates);
            if (v.marker == 0 && d > farthest) farthest = d;
            if (v.marker == 1) CHECK(d <= a.mesh.domain[dim] * (1 + 0x1p-8));
        }
        CHECK(farthest < a.mesh.domain[dim]);
        CHECK(a.mesh.domain[dim] < farthest * (1 + 0x1p-8));
    }
}

TEST_CASE(
    "the ball that cells are clipped to stays what it is: other diagrams, bounds, cycles, a mesh that is loaded") {
    for (const int dim : dimensions(2, 5)) {
        CAPTURE(dim);
        const inputs::Points points = some_points(dim);
        Refined made(dim, points, false);
        const std::uint64_t fingerprint = made.report().fingerprint;
        const double radius = made.report().mesh.domain[dim];
        REQUIRE(made.bound_bars() == NETMESH_OK);
        REQUIRE(made.represent() == NETMESH_OK);
        REQUIRE(made.persist(&netmesh_filter_basic) == NETMESH_OK);
        CHECK(made.report().diagram.certified_ratio < 3);
        CHECK(made.report().mesh.domain[dim] == radius);
        REQUIRE(made.persist(persist_by(&netmesh_filter_knn, 2)) == NETMESH_OK);
        REQUIRE(made.persist() == NETMESH_OK);
        CHECK(made.report().fingerprint == fingerprint);

        Session loaded(dim);
        loaded.reserve(std::size_t{1} << 26);
        loaded.request.goal.ratio = ratio_of(dim);
        const Arrays arrays(made);
        REQUIRE(arrays.load(loaded) == NETMESH_OK);
        CHECK(loaded.check() == NETMESH_OK);
        REQUIRE(loaded.persist() == NETMESH_OK);
        CHECK(loaded.report().mesh.clipped == 1);
        CHECK(loaded.report().mesh.domain[dim] == radius);
        CHECK(loaded.report().fingerprint == fingerprint);
        // For whole cells it was not made.
        loaded.request.mesh.whole_cells = 1;
        REQUIRE(arrays.load(loaded) == NETMESH_OK);
        CHECK(loaded.check() == NETMESH_CHECK_FAILED);
        REQUIRE(loaded.persist() == NETMESH_OK);
        CHECK(loaded.report().diagram.certified_ratio > ratio_of(dim));
    }
}

TEST_CASE("a ball that does not hold the points clips nothing") {
    Refined made(2, some_points(2), false);
    Arrays arrays(made);
    arrays.domain.back() *= 0.99;
    Session loaded(2);
    loaded.reserve(std::size_t{1} << 24);
    loaded.request.goal.ratio = 2.3;
    REQUIRE(arrays.load(loaded) == NETMESH_OK);
    REQUIRE(loaded.persist() == NETMESH_OK);
    CHECK(loaded.report().diagram.certified_ratio > 2.3);  // of whole cells
    CHECK(loaded.report().mesh.domain[2] == arrays.domain[2]);
}
