#include "filtration/filters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/objects.hpp"
#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"

using namespace netmesh;

namespace {

// Samples the inclusions that the certificate claims: at a point x of v's cell the cover enters at
// t(v), or at |x - v| in an input's ball before, and that must be within a factor c of F(x) = min(d_P(x), rho).
template <int D> void sample_inclusions(const inputs::Points& points, double tau, int samples) {
    Meshed<D> mesh(points, by_quality(tau, 1, true), std::size_t{1} << 27);
    REQUIRE(mesh.status == Status::ok);
    Store<D>& store = mesh.store;
    const Domain<D>& domain = mesh.result.domain;
    const std::uint32_t inputs = mesh.inputs();
    std::vector<double> value(store.state.vertex_count);
    for (const FilterValues kind : {FilterValues::certified, FilterValues::thesis}) {
        Evaluation complete = {value.data()};
        REQUIRE(evaluate(FilteredMesh<D>{store, domain, inputs}, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, kind},
                         {mesh.block.arena, mesh.monitor}, &complete) == Status::ok);
        CHECK(complete.zero_born == inputs);
        const Certificate certificate = complete.certificate;
        const double c = certificate.ratio, rho = domain.enclosing_radius;
        if (kind == FilterValues::certified) {
            CHECK(c <= std::sqrt(2 + tau));
            CHECK(c == doctest::Approx(certificate.ratio_best));
        } else {
            CHECK(c <= tau);
        }
        CHECK(c >= certificate.ratio_best * (1 - 1e-9));
        inputs::Random random(8);
        for (int s = 0; s < samples; ++s) {
            // Everywhere at first, then near vertices where cells are small.
            double x[D];
            const std::uint32_t near = static_cast<std::uint32_t>(random.below(store.state.vertex_count));
            const double scale = s % 2 == 0 ? 2.5 * rho : std::sqrt(store.vertex(near).nearest2);
            for (int k = 0; k < D; ++k)
                x[k] = (s % 2 == 0 ? domain.centre[k] : store.point(near)[k]) + scale * (2 * random.uniform() - 1);
            std::uint32_t v = 0;
            double best = infinity, offset = infinity;
            for (std::uint32_t w = 0; w < store.state.vertex_count; ++w) {
                const double d = distance<D>(x, store.point(w));
                if (d < best) {
                    best = d;
                    v = w;
                }
                if (w < inputs) offset = std::min(offset, d);
            }
            const double f = std::min(offset, rho);
            const double enters = v < inputs ? std::min(best, value[v]) : value[v];
            CHECK(enters <= f * c * (1 + 1e-12));
            if (!(v < inputs && best < value[v])) CHECK(f <= value[v] * c * (1 + 1e-12));
        }
    }
}

}  // namespace

TEST_CASE("the cover and the offsets are interleaved by the certified ratio") {
    sample_inclusions<2>(inputs::uniform(2, 60), 2.5, 20000);
    sample_inclusions<2>(inputs::clusters(2, 40), 3.08, 20000);
    sample_inclusions<3>(inputs::uniform(3, 40), 3.08, 10000);
    for_each_dimension<4, 4>([&](auto dim) { sample_inclusions<dim>(inputs::uniform(4, 10), 4, 4000); });
    for_each_dimension<5, 5>([&](auto dim) { sample_inclusions<dim>(inputs::clusters(5, 8), 3, 1000); });
    for_each_dimension<6, 6>([&](auto dim) { sample_inclusions<dim>(inputs::clusters(6, 8), 3, 1000); });
}

// 7.4.2: half the distance of an input to its nearest neighbour, a Steiner vertex's distance to the inputs; all cut.
TEST_CASE_TEMPLATE_DEFINE("the thesis's own values by looking at all vertices, and cells of which nothing is known", T,
                          own_values) {
    constexpr int D = T::value;
    Meshed<D> mesh(D < 6 ? inputs::uniform(D, D + 4) : inputs::clusters(D, 7), by_quality(3, 1, true));
    REQUIRE(mesh.status == Status::ok);
    const Store<D>& store = mesh.store;
    const std::uint32_t count = store.state.vertex_count, inputs = mesh.inputs();
    const FilteredMesh<D> filtered = {mesh.store, mesh.result.domain, inputs};
    const double cut = filtered.cut();
    std::vector<double> value(count), input_distance(count);
    std::vector<Interval> interval(count);
    Evaluation out = {value.data(), interval.data()};
    const auto run = [&](netmesh_filter_id filter, const MeshFilter* on_mesh) {
        REQUIRE(evaluate(filtered, {filter, on_mesh, FilterValues::thesis}, {mesh.block.arena, mesh.monitor}, &out) ==
                Status::ok);
    };
    run(NETMESH_FILTER_COMPLETE, &complete_on_mesh);
    for (std::uint32_t v = 0; v < count; ++v) {
        double to_input = infinity, to_vertex = infinity;
        for (std::uint32_t w = 0; w < count; ++w) {
            const double d = distance<D>(store.point(v), store.point(w));
            if (w != v) to_vertex = std::min(to_vertex, d);
            if (w < inputs) to_input = std::min(to_input, d);
        }
        input_distance[v] = to_input;
        CHECK(value[v] == doctest::Approx(std::min(v < inputs ? to_vertex / 2 : to_input, cut)).epsilon(1e-14));
    }
    // Were they on the hull, cells would reach as far as there is space, whatever corners they have.
    for (std::uint32_t v = inputs; v < count; ++v) mesh.store.vertex(v).marker = Marker::exempt;
    for (const bool basic : {false, true}) {
        run(basic ? NETMESH_FILTER_BASIC : NETMESH_FILTER_COMPLETE,
            basic ? netmesh_filter_basic.on_mesh : &complete_on_mesh);
        for (std::uint32_t v = inputs; v < count; ++v) {
            CHECK(interval[v].hi == cut);
            CHECK(interval[v].lo <= input_distance[v] / 2);
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(own_values, Dimensions<>);

TEST_CASE("cells that only the last bits of their vertices keep from being flat are certified like others") {
    const auto bent_grid = [](int dim, int side) {
        inputs::Points points = inputs::grid(dim, side);
        inputs::Random random(7);
        for (double& x : points) x *= 1 + 0x1p-52 * static_cast<double>(random.below(3));
        return points;
    };
    sample_inclusions<3>(bent_grid(3, 7), 3, 200);
    for_each_dimension<4, 4>([&](auto dim) { sample_inclusions<dim>(bent_grid(4, 3), 3.08, 200); });
    for_each_dimension<5, 5>([&](auto dim) { sample_inclusions<dim>(bent_grid(5, 2), 4, 200); });
}

TEST_CASE("the basic filter gives inputs zero and says from where its ratio holds") {
    Meshed<2> mesh(inputs::uniform(2, 100), by_quality(2.5, 1, true), std::size_t{1} << 25);
    REQUIRE(mesh.status == Status::ok);
    Store<2>& store = mesh.store;
    const Domain<2>& domain = mesh.result.domain;
    std::vector<double> value(store.state.vertex_count);
    Evaluation basic = {value.data()};
    REQUIRE(evaluate(FilteredMesh<2>{store, domain, 100},
                     {NETMESH_FILTER_BASIC, netmesh_filter_basic.on_mesh, FilterValues::thesis},
                     {mesh.block.arena, mesh.monitor}, &basic) == Status::ok);
    CHECK(basic.zero_born == 0);
    const Certificate certificate = basic.certificate;
    for (std::uint32_t v = 0; v < 100; ++v) CHECK(value[v] == 0);
    for (std::uint32_t v = 100; v < store.state.vertex_count; ++v) {
        double d = infinity;
        for (std::uint32_t p = 0; p < 100; ++p) d = std::min(d, distance<2>(store.point(v), store.point(p)));
        CHECK(value[v] == doctest::Approx(std::min(d, domain.enclosing_radius * (1 + 0x1p-40))));
    }
    CHECK(certificate.from > 0);
    CHECK(certificate.from < domain.enclosing_radius * (1 + 1e-9));
}
