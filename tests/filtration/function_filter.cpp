#include "filtration/function_filter.hpp"
#include "filtration/filters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/objects.hpp"
#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"
#include "delaunay/sphere.hpp"
#include "delaunay/triangulate.hpp"

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

FilterRequest request_of(InputDistance kind, FilterValues values, std::uint32_t k) {
    return kind == InputDistance::kth
               ? FilterRequest{NETMESH_FILTER_KNN, netmesh_filter_knn.on_mesh, values, k}
               : FilterRequest{NETMESH_FILTER_KDISTANCE, netmesh_filter_kdistance.on_mesh, values, k};
}

template <int D> struct Mesh {
    Mesh(const inputs::Points& points, double tau, double factor = 1, double eps = 0)
        : block(std::size_t{1} << 27), store(block.arena, state) {
        Monitor monitor;
        MeshRequest request = by_quality(tau, factor, true);
        request.size.eps = eps;
        MeshResult<D> mesh = {};
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
                REQUIRE(evaluate(mesh.filtered(), request_of(kind, values, k), {mesh.block.arena, monitor},
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

// Calls visit(v, corner, distance) for each corner of each cell that is not exempt.
template <int D, class Visit> void for_each_corner(const Store<D>& store, Visit visit) {
    for (CellId c(0); c < store.state.cell_slots; ++c)
        for (const VertexId v : store.cell(c).vertex) {
            if (store.vertex(v).marker == Marker::exempt || !is_finite(store.cell(c).radius2)) continue;
            visit(v, store.cell(c).centre, std::sqrt(squared(store.point(v), store.cell(c).centre, D)));
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

// Two triples of points far apart: there are many cells between the two scales, on which distances grow outwards as
// fast as they can, and corners on all sides.
TEST_CASE("intervals of d_k and the k-distance hold at the corners of cells") {
    const inputs::Points points = {0, 0, 0x1p-10, 0, 0, 0x1p-10, 1, 0.25, 1, 0.25 + 0x1p-10, 1 + 0x1p-10, 0.25};
    Mesh<2> mesh(points, 2.5);
    const double cut = mesh.filtered().cut();
    for (const InputDistance kind : {InputDistance::kth, InputDistance::root_mean_square})
        for (const std::uint32_t k : {2u, 3u}) {
            Monitor monitor;
            std::vector<double> value(mesh.state.vertex_count);
            std::vector<Interval> interval(mesh.state.vertex_count);
            Evaluation out = {value.data(), interval.data()};
            REQUIRE(evaluate(mesh.filtered(), request_of(kind, FilterValues::certified, k), {mesh.block.arena, monitor},
                             &out) == Status::ok);
            int below_cut = 0;
            for_each_corner<2>(mesh.store, [&](VertexId v, const double* corner, double) {
                const double f = std::min(brute(points, 2, corner, k, kind), cut);
                below_cut += f < cut;
                CHECK(interval[v].lo <= f * (1 + 1e-11));
                CHECK(f <= interval[v].hi * (1 + 1e-11));
            });
            CHECK(below_cut > 100);
        }
}

// The cell of (1, 0) has its farthest corner at (2, 0), straight away from both inputs, where d_2 is larger than at
// (1, 0) by exactly the out-radius: 3 to the last bit.
TEST_CASE("the interval of d_2 holds what is as far as it can be") {
    const inputs::Points points = {-0.5, 0, -1, 0, 1, 0, 2, 1, 2, -1, 1, 1, 1, -1, 8, 8, 8, -8, -8, 8, -8, -8};
    Block block(std::size_t{1} << 16);
    StoreState state = {};
    Store<2> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    REQUIRE(triangulate<2>(store, points.data(), points.size() / 2, 1, monitor, &input) == Status::ok);
    recompute_balls<2>(store);
    for (VertexId v(2); v < state.vertex_count; ++v) {
        store.vertex(v).marker = v == 2 ? Marker::steiner : Marker::exempt;
        store.vertex(v).origin = 0;
    }
    Domain<2> domain = {};
    domain.radius = domain.enclosing_radius = 20;
    std::vector<double> value(state.vertex_count);
    std::vector<Interval> interval(state.vertex_count);
    Evaluation out = {value.data(), interval.data()};
    REQUIRE(evaluate(FilteredMesh<2>{store, domain, 2},
                     {NETMESH_FILTER_KNN, netmesh_filter_knn.on_mesh, FilterValues::thesis, 2}, {block.arena, monitor},
                     &out) == Status::ok);
    CHECK(value[2] == 2);
    CHECK(interval[2].hi >= 3);
    CHECK(interval[2].hi <= 3 * (1 + 1e-11));
    CHECK(interval[2].lo <= 1);
}

// A linear function that changes as fast as L says, up or down to the farthest corner of a cell. Where it falls to R /
// c there, R being the corner's distance, it is as small as the distance factor c admits.
TEST_CASE_TEMPLATE_DEFINE("intervals of a function hold at the farthest corner of a cell", T, farthest_corner) {
    constexpr int D = T::value;
    Mesh<D> mesh(D < 6 ? inputs::uniform(D, D + 3) : inputs::clusters(D, 7), 3);
    struct Corner {
        const double* at = nullptr;
        double distance = 0;
    };
    std::vector<Corner> farthest(mesh.state.vertex_count);
    for_each_corner<D>(mesh.store, [&](VertexId v, const double* corner, double distance) {
        if (distance > farthest[v].distance) farthest[v] = {corner, distance};
    });
    std::vector<double> value(mesh.state.vertex_count);
    std::vector<Interval> interval(mesh.state.vertex_count);
    const double lipschitz = 3, factor = 0.25, cut = 1e6;
    FilteredMesh<D> filtered = mesh.filtered();
    filtered.domain.radius *= 1e7;  // no function is below the cut by more than L times that
    int looked_at = 0;
    for (std::uint32_t v = 0; v < mesh.state.vertex_count && looked_at < 60; ++v) {
        // Cells that lie in the domain: those outside have the value of the cut.
        if (mesh.store.vertex(v).marker == Marker::exempt || !(farthest[v].distance > 0) ||
            !mesh.domain.contains(mesh.store.point(v)))
            continue;
        ++looked_at;
        for (const bool rising : {true, false}) {
            const double r = farthest[v].distance, at_corner = rising ? 10 + lipschitz * r : r / factor;
            for (std::uint32_t w = 0; w < mesh.state.vertex_count; ++w) {
                double along = 0;  // from the corner, on the way to it
                for (int k = 0; k < D; ++k)
                    along +=
                        (mesh.store.point(w)[k] - farthest[v].at[k]) * (farthest[v].at[k] - mesh.store.point(v)[k]) / r;
                value[w] = std::max(0.0, at_corner + (rising ? lipschitz : -lipschitz) * along);
            }
            Evaluation out = {value.data(), interval.data()};
            REQUIRE(clamp_function(filtered, {lipschitz, factor, cut}, FilterValues::thesis, mesh.block.arena, &out) ==
                    Status::ok);
            CHECK(interval[v].lo <= at_corner * (1 + 1e-9));
            CHECK(at_corner <= interval[v].hi * (1 + 1e-9));
        }
    }
    CHECK(looked_at > 5);
}
TEST_CASE_TEMPLATE_APPLY(farthest_corner, Dimensions<>);

// The distance to the centre and 1, up to the cut at the domain's sphere: cells that reach in from outside have less.
TEST_CASE_TEMPLATE_DEFINE("intervals hold where cells reach into the domain", T, reaches_in) {
    constexpr int D = T::value;
    Mesh<D> mesh(D < 6 ? inputs::uniform(D, D + 5) : inputs::clusters(D, 7), 3);
    FilteredMesh<D> filtered = mesh.filtered();
    filtered.domain.radius = 0.5 * mesh.domain.radius;
    const Domain<D>& domain = filtered.domain;
    const double cut = 1 + domain.radius;
    const auto f = [&](const double* x) { return std::min(cut, 1 + std::sqrt(domain.distance2(x))); };
    std::vector<double> value(mesh.state.vertex_count);
    std::vector<Interval> interval(mesh.state.vertex_count);
    for (VertexId v(0); v < mesh.state.vertex_count; ++v)
        value[v] = 1 + std::sqrt(domain.distance2(mesh.store.point(v)));
    Evaluation out = {value.data(), interval.data()};
    REQUIRE(clamp_function(filtered, {1, 0, cut}, FilterValues::certified, mesh.block.arena, &out) == Status::ok);
    int reach_in = 0;
    for_each_corner<D>(mesh.store, [&](VertexId v, const double* corner, double) {
        reach_in += domain.contains(corner) && !domain.contains(mesh.store.point(v));
        CHECK(interval[v].lo <= f(corner) * (1 + 1e-11));
        CHECK(f(corner) <= interval[v].hi * (1 + 1e-11));
    });
    CHECK(reach_in > 0);
}
TEST_CASE_TEMPLATE_APPLY(reaches_in, Dimensions<>);

// Corollary 8.6.4, corrected: on an eps-refined mesh the functions' own values are within 1 / (1 - eps), 1 / (1 -
// sqrt(2) eps). The domain is so large that cells which reach out of it are beyond the cut.
TEST_CASE("eps-refined meshes keep the bound of 8.6.4") {
    for (const double eps : {0.25, 0.125}) {
        Mesh<2> mesh(inputs::uniform(2, 30), 2.5, 3.0625 + 4 * eps, eps);
        std::vector<double> value(mesh.state.vertex_count);
        for (const std::uint32_t k : {2u, 5u}) {
            Monitor monitor;
            Evaluation evaluation = {value.data()};
            REQUIRE(evaluate(mesh.filtered(), {NETMESH_FILTER_KNN, netmesh_filter_knn.on_mesh, FilterValues::thesis, k},
                             {mesh.block.arena, monitor}, &evaluation) == Status::ok);
            CHECK(evaluation.certificate.ratio <= 1 / (1 - eps) * (1 + 1e-9));
            REQUIRE(evaluate(mesh.filtered(),
                             {NETMESH_FILTER_KDISTANCE, netmesh_filter_kdistance.on_mesh, FilterValues::thesis, k},
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
        REQUIRE(clamp_function(mesh.filtered(), {5, 0.5, cut}, values, mesh.block.arena, &evaluation) == Status::ok);
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
    REQUIRE(clamp_function(mesh.filtered(), {1, 0, 1}, FilterValues::certified, mesh.block.arena, &zero) == Status::ok);
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
    inputs::Random random(9);
    const auto check = [&](double most) {
        for (std::uint32_t v = 0; v < mesh.state.vertex_count; ++v) value[v] = f(mesh.store.point(v));
        Evaluation evaluation = {value.data()};
        REQUIRE(clamp_function(FilteredMesh<D>{mesh.store, inner, mesh.inputs}, {5, 0.5, cut}, FilterValues::certified,
                               mesh.block.arena, &evaluation) == Status::ok);
        const double c = evaluation.certificate.ratio, e = evaluation.certificate.error;
        CHECK(c < most);
        CHECK(e <= 5 * inner.radius * (1 + 1e-9));
        for (int s = 0; s < 200; ++s) {
            double x[D];
            for (int k = 0; k < D; ++k) x[k] = inner.centre[k] + 2 * inner.radius * (2 * random.uniform() - 1);
            const double F = std::min(f(x), cut), t = value[mesh.cell_of(x)];
            CHECK(t <= c * F * (1 + 1e-12));
            CHECK(F <= c * t * (1 + 1e-12));
            CHECK(std::abs(F - t) <= e);
        }
    };
    check(10);
    std::uint32_t at_cut = 0;
    for (const double v : value) at_cut += v == cut;
    CHECK(at_cut > mesh.state.vertex_count / 4);
    // Of a cell that is exempt near by nothing is known but the cut, and how far it is from the sphere.
    for (std::uint32_t v = mesh.inputs; v < mesh.state.vertex_count; ++v) mesh.store.vertex(v).marker = Marker::exempt;
    check(HUGE_VAL);
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
    CHECK(evaluate(mesh.filtered(), {NETMESH_FILTER_KNN, netmesh_filter_knn.on_mesh, FilterValues::thesis, 3},
                   {mesh.block.arena, monitor}, &evaluation) == Status::out_of_memory);
    CHECK(mesh.block.arena.high_mark() == high);
}
