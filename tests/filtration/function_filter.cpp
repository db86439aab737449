#include "filtration/function_filter.hpp"
#include "filtration/filters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"

using namespace netmesh;

namespace {

double squared(const double* a, const double* b, int dim) {
    double d2 = 0;
    for (int k = 0; k < dim; ++k) d2 += (a[k] - b[k]) * (a[k] - b[k]);
    return d2;
}

// d_k or D_k by looking at all points.
double brute(const inputs::Points& points, int dim, const double* x, std::uint32_t k, InputDistance kind) {
    std::vector<double> d2;
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim))
        d2.push_back(squared(x, &points[i], dim));
    std::sort(d2.begin(), d2.end());
    if (kind == InputDistance::kth) return std::sqrt(d2[k - 1]);
    double sum = 0;
    for (std::uint32_t i = 0; i < k; ++i) sum += d2[i];
    return std::sqrt(sum / k);
}

netmesh_filter filter_of(InputDistance kind) {
    return kind == InputDistance::kth ? NETMESH_FILTER_KNN : NETMESH_FILTER_KDISTANCE;
}

template <int D> struct Mesh {
    Mesh(const inputs::Points& points, double tau, double factor = 1, double eps = 0)
        : block(std::size_t{1} << 27), store(block.arena, state) {
        Monitor monitor;
        MeshRequest request = by_quality(tau, factor, true);
        request.size.eps = eps;
        MeshResult<D> mesh;
        REQUIRE(mesh_points<D>(store, points.data(), points.size() / D, request, {block.arena, monitor}, &mesh) ==
                Status::ok);
        domain = mesh.domain;
        inputs = static_cast<std::uint32_t>(mesh.input.rows - mesh.input.duplicates);
    }
    FilteredMesh<D> filtered() { return {store, domain, inputs}; }
    // The vertex whose cell contains x.
    std::uint32_t cell_of(const double* x) const {
        std::uint32_t best = 0;
        for (std::uint32_t v = 1; v < state.vertex_count; ++v)
            if (squared(x, store.point(v), D) < squared(x, store.point(best), D)) best = v;
        return best;
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Domain<D> domain = {};
    std::uint32_t inputs = 0;
};

// Samples what the certificate claims: F(x) / c <= t(v) <= c F(x) at points x of v's cell, F cut at rho.
template <int D> void sample_distances(const inputs::Points& points, double tau, int samples) {
    Mesh<D> mesh(points, tau);
    std::vector<double> value(mesh.state.vertex_count);
    const double rho = mesh.domain.enclosing_radius;
    for (const InputDistance kind : {InputDistance::kth, InputDistance::root_mean_square})
        for (const std::uint32_t k : {2u, 3u, 7u, mesh.inputs})
            for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
                Monitor monitor;
                Evaluation evaluation = {value.data()};
                const std::size_t used = mesh.block.arena.bytes_used();
                REQUIRE(evaluate<D>(mesh.filtered(), {filter_of(kind), values, k}, {mesh.block.arena, monitor},
                                    &evaluation) == Status::ok);
                CHECK(evaluation.zero_born == 0);
                const Certificate certificate = evaluation.certificate;
                CHECK(mesh.block.arena.bytes_used() == used);
                const double c = certificate.ratio;
                CAPTURE(k);
                CHECK(c >= certificate.ratio_best * (1 - 1e-9));
                if (values == FilterValues::certified) CHECK(c == doctest::Approx(certificate.ratio_best));
                CHECK(certificate.ratio_best <= std::sqrt(4 + 2 * tau));
                inputs::Random random(9);
                for (int s = 0; s < samples; ++s) {
                    double x[D];
                    for (int a = 0; a < D; ++a) x[a] = mesh.domain.centre[a] + 2.5 * rho * (2 * random.uniform() - 1);
                    const double f = std::min(brute(points, D, x, k, kind), rho * (1 + 1e-12));
                    const double t = value[mesh.cell_of(x)];
                    CHECK(t <= c * f * (1 + 1e-12));
                    CHECK(f <= c * t * (1 + 1e-12));
                }
            }
}

}  // namespace

TEST_CASE("nearest neighbours: the same as by looking at all points") {
    for (const inputs::Points& points : {inputs::uniform(3, 200), inputs::grid(3, 6), inputs::clusters(3, 150)}) {
        Block block(std::size_t{1} << 22);
        StoreState state = {};
        Store<3> store(block.arena, state);
        Monitor monitor;
        InputReport input;
        std::uint32_t* order;
        REQUIRE(take_input<3>(store, points.data(), points.size() / 3, 1, monitor, &input, &order) == Status::ok);
        InputTree<3> tree;
        REQUIRE(tree.build(store, block.arena, state.vertex_count) == Status::ok);
        inputs::Random random(4);
        for (int s = 0; s < 60; ++s) {
            // Points of the set too, where ties are.
            double x[3];
            for (int a = 0; a < 3; ++a)
                x[a] = s % 2 == 0 ? points[3 * random.below(100) + static_cast<std::size_t>(a)] : 3 * random.uniform();
            std::vector<std::pair<double, std::uint32_t>> all;
            for (std::uint32_t v = 0; v < state.vertex_count; ++v) all.push_back({squared(x, store.point(v), 3), v});
            std::sort(all.begin(), all.end());
            for (const std::uint32_t k : {1u, 2u, 9u, 50u, state.vertex_count}) {
                std::vector<Neighbour> found(k);
                tree.nearest_k(x, k, found.data());
                for (std::uint32_t i = 0; i < k; ++i) {
                    CHECK(found[i].input == all[i].second);
                    CHECK(found[i].distance2 == all[i].first);
                }
            }
        }
    }
}

TEST_CASE("d_k and the k-distance stay within their certificate") {
    sample_distances<2>(inputs::uniform(2, 60), 2.5, 150);
    sample_distances<2>(inputs::grid(2, 6), 3, 150);
    sample_distances<2>(inputs::clusters(2, 40), 2.5, 150);
    sample_distances<3>(inputs::uniform(3, 40), 3, 80);
    for_each_dimension<4, 4>([&](auto dim) { sample_distances<dim>(inputs::uniform(4, 12), 3.08, 30); });
    for_each_dimension<5, 5>([&](auto dim) { sample_distances<dim>(inputs::uniform(5, 8), 2.2, 20); });
    for_each_dimension<6, 6>([&](auto dim) { sample_distances<dim>(inputs::clusters(6, 8), 3, 20); });
}

// Corollary 8.6.4, corrected: on an eps-refined mesh the functions' own values are within 1 / (1 - eps), 1 / (1 -
// sqrt(2) eps). The domain is so large that cells which reach out of it are beyond the cut.
TEST_CASE("eps-refined meshes keep the bound of 8.6.4") {
    for (const double eps : {0.25, 0.125}) {
        Mesh<2> mesh(inputs::uniform(2, 30), 2.5, 3.0625 + 4 * eps, eps);
        std::vector<double> value(mesh.state.vertex_count);
        for (const std::uint32_t k : {2u, 5u}) {
            Monitor monitor;
            Evaluation evaluation = {value.data()};
            REQUIRE(evaluate<2>(mesh.filtered(), {NETMESH_FILTER_KNN, FilterValues::thesis, k},
                                {mesh.block.arena, monitor}, &evaluation) == Status::ok);
            CHECK(evaluation.certificate.ratio <= 1 / (1 - eps) * (1 + 1e-9));
            REQUIRE(evaluate<2>(mesh.filtered(), {NETMESH_FILTER_KDISTANCE, FilterValues::thesis, k},
                                {mesh.block.arena, monitor}, &evaluation) == Status::ok);
            CHECK(evaluation.certificate.ratio <= 1 / (1 - std::sqrt(2.0) * eps) * (1 + 1e-9));
        }
    }
}

TEST_CASE("a Lipschitz function stays within its certificate where its assumption holds") {
    const inputs::Points points = inputs::uniform(2, 80);
    Mesh<2> mesh(points, 2.5);
    // Twice the distance to the second nearest point, and more towards the domain's sphere: at least the cut outside.
    const double radius = mesh.domain.radius, cut = 1 + 1.5 * radius;
    const auto f = [&](const double* x) {
        const double beyond = std::sqrt(mesh.domain.distance2(x)) - 0.5 * radius;
        return 2 * brute(points, 2, x, 2, InputDistance::kth) + 1 + 3 * std::max(0.0, beyond);
    };
    std::vector<double> value(mesh.state.vertex_count);
    for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
        for (std::uint32_t v = 0; v < mesh.state.vertex_count; ++v) value[v] = f(mesh.store.point(v));
        Evaluation evaluation = {value.data()};
        REQUIRE(clamp_function<2>(mesh.filtered(), {5, 0.5, cut}, values, mesh.block.arena, &evaluation) == Status::ok);
        const double c = evaluation.certificate.ratio;
        CHECK(c < 4);
        inputs::Random random(9);
        for (int s = 0; s < 500; ++s) {
            const double x[2] = {mesh.domain.centre[0] + 2 * mesh.domain.radius * (2 * random.uniform() - 1),
                                 mesh.domain.centre[1] + 2 * mesh.domain.radius * (2 * random.uniform() - 1)};
            const double F = std::min(f(x), cut);
            const double t = value[mesh.cell_of(x)];
            CHECK(t <= c * F * (1 + 1e-12));
            CHECK(F <= c * t * (1 + 1e-12));
        }
    }
    // A function that is 0 somewhere has no ratio.
    for (std::uint32_t v = 0; v < mesh.state.vertex_count; ++v) value[v] = 0;
    Evaluation zero = {value.data()};
    REQUIRE(clamp_function<2>(mesh.filtered(), {1, 0, 1}, FilterValues::certified, mesh.block.arena, &zero) ==
            Status::ok);
    CHECK(zero.certificate.ratio == infinity);
}

TEST_CASE_TEMPLATE_DEFINE("a function on cells that leave the domain, or of which nothing is known", T, clamped) {
    constexpr int D = T::value;
    constexpr std::size_t few[] = {0, 0, 20, 10, 7, 8, 8};
    const inputs::Points points = D < 6 ? inputs::uniform(D, few[D]) : inputs::clusters(D, few[D]);
    Mesh<D> mesh(points, D < 5 ? 2.5 : D == 5 ? 2.2 : 3);
    Domain<D> inner = mesh.domain;
    inner.radius *= 0.25;
    const double cut = 1 + 1.5 * inner.radius;
    const auto f = [&](const double* x) {
        const double beyond = std::sqrt(inner.distance2(x)) - 0.5 * inner.radius;
        return 2 * brute(points, D, x, 2, InputDistance::kth) + 1 + 3 * std::max(0.0, beyond);
    };
    std::vector<double> value(mesh.state.vertex_count);
    const auto filter = [&] {
        for (std::uint32_t v = 0; v < mesh.state.vertex_count; ++v) value[v] = f(mesh.store.point(v));
        Evaluation evaluation = {value.data()};
        REQUIRE(clamp_function<D>({mesh.store, inner, mesh.inputs}, {5, 0.5, cut}, FilterValues::certified,
                                  mesh.block.arena, &evaluation) == Status::ok);
        return evaluation.certificate.ratio;
    };
    const double c = filter();
    CHECK(c < 10);
    std::uint32_t at_cut = 0;
    for (const double v : value) at_cut += v == cut;
    CHECK(at_cut > mesh.state.vertex_count / 4);
    inputs::Random random(9);
    for (int s = 0; s < 200; ++s) {
        double x[D];
        for (int k = 0; k < D; ++k) x[k] = inner.centre[k] + 2 * inner.radius * (2 * random.uniform() - 1);
        const double F = std::min(f(x), cut), t = value[mesh.cell_of(x)];
        CHECK(t <= c * F * (1 + 1e-12));
        CHECK(F <= c * t * (1 + 1e-12));
    }
    // Of a cell that is exempt near by nothing is known but the cut.
    for (std::uint32_t v = mesh.inputs; v < mesh.state.vertex_count; ++v) mesh.store.vertex(v).marker = Marker::exempt;
    CHECK(filter() == infinity);
}
TEST_CASE_TEMPLATE_APPLY(clamped, Dimensions<>);

TEST_CASE("too little memory is said") {
    const inputs::Points points = inputs::uniform(2, 50);
    Mesh<2> mesh(points, 2.5);
    std::vector<double> value(mesh.state.vertex_count);
    Evaluation evaluation = {value.data()};
    Monitor monitor;
    const std::size_t high = mesh.block.arena.high_mark();
    REQUIRE(mesh.block.arena.take_low<unsigned char>(mesh.block.arena.bytes_free() - 512) != nullptr);
    CHECK(evaluate<2>(mesh.filtered(), {NETMESH_FILTER_KNN, FilterValues::thesis, 3}, {mesh.block.arena, monitor},
                      &evaluation) == Status::out_of_memory);
    CHECK(mesh.block.arena.high_mark() == high);
}
