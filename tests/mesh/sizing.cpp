#include "mesh/sizing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/meshed.hpp"
#include "common/session.hpp"

using namespace netmesh;

namespace {

double distance(const double* a, const double* b, int dim) {
    double d2 = 0;
    for (int k = 0; k < dim; ++k) d2 += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(d2);
}

// Distances to the two nearest inputs by looking at all of them.
std::pair<double, double> distances_by_scan(const inputs::Points& points, int dim, const double* x) {
    double first = infinity, second = infinity;
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim)) {
        const double d = distance(&points[i], x, dim);
        second = std::min(second, std::max(first, d));
        first = std::min(first, d);
    }
    return {first, second};
}

double feature_size_by_scan(const inputs::Points& points, int dim, const double* x) {
    return distances_by_scan(points, dim, x).second;
}

// Largest R_v / f(v) over clipped cells, by the public interface alone: a cell's farthest point is a corner inside the
// domain or a crossing of its sphere; sampled here along the segments between the corners of neighbouring cells.
template <class Size> double worst_by_corners(const Session& session, Size&& size) {
    const netmesh_report r = session.report();
    const int dim = static_cast<int>(r.input.dim);
    const std::vector<netmesh_vertex> vertices = session.vertices();
    REQUIRE(vertices.size() == r.mesh.vertices);
    double worst = 0;
    for (const netmesh_cell& cell : read_all(session.context, netmesh_get_cell)) {
        // Circumcentre by Gaussian elimination on the bisectors with the first vertex.
        double a[6][7], x[6];
        const double* const p = vertices[cell.vertices[0]].coordinates;
        for (int i = 0; i < dim; ++i) {
            a[i][dim] = 0;
            for (int k = 0; k < dim; ++k) {
                a[i][k] = vertices[cell.vertices[i + 1]].coordinates[k] - p[k];
                a[i][dim] += a[i][k] * a[i][k] / 2;
            }
        }
        for (int k = 0; k < dim; ++k) {
            int pivot = k;
            for (int i = k; i < dim; ++i)
                if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
            std::swap(a[k], a[pivot]);
            for (int i = 0; i < dim; ++i)
                for (int j = dim; i != k && j >= k; --j) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
        }
        for (int k = 0; k < dim; ++k) x[k] = p[k] + a[k][dim] / a[k][k];
        if (distance(x, r.mesh.domain, dim) > r.mesh.domain[dim]) continue;
        for (int i = 0; i <= dim; ++i) {
            const netmesh_vertex& v = vertices[cell.vertices[i]];
            if (v.marker != 2) worst = std::max(worst, distance(x, v.coordinates, dim) / size(v.coordinates));
        }
    }
    return worst;
}

// Largest distance of a point of the domain from its nearest vertex over that vertex's size, every other point on the
// sphere; points nearest to exempt vertices do not count.
template <class Size> double worst_by_sampling(const Session& session, Size&& size) {
    const netmesh_report r = session.report();
    const int dim = static_cast<int>(r.input.dim);
    const std::vector<netmesh_vertex> vertices = session.vertices();
    inputs::Random random(3);
    double worst = 0;
    for (int sample = 0; sample < 4000; ++sample) {
        double x[6], d2;
        do {
            d2 = 0;
            for (int k = 0; k < dim; ++k) {
                x[k] = 2 * random.uniform() - 1;
                d2 += x[k] * x[k];
            }
        } while (d2 > 1);
        const double scale = sample % 2 == 0 ? 1 : 1 / std::sqrt(d2);
        for (int k = 0; k < dim; ++k) x[k] = r.mesh.domain[k] + r.mesh.domain[dim] * scale * x[k];
        const netmesh_vertex* nearest = &vertices[0];
        for (const netmesh_vertex& v : vertices)
            if (distance(x, v.coordinates, dim) < distance(x, nearest->coordinates, dim)) nearest = &v;
        if (nearest->marker == 2) continue;
        worst = std::max(worst, distance(x, nearest->coordinates, dim) / size(nearest->coordinates));
    }
    return worst;
}

struct Funnel {
    int dim;
    double least, slope;
    static double size(void* user, const double* x) {
        const Funnel& f = *static_cast<const Funnel*>(user);
        double d2 = 0;
        for (int k = 0; k < f.dim; ++k) d2 += (x[k] - 0.4) * (x[k] - 0.4);
        return f.least + f.slope * std::sqrt(d2);
    }
};

}  // namespace

TEST_CASE("hints are below the value by less than a thirty-second") {
    inputs::Random random(7);
    for (int i = 0; i < 10000; ++i) {
        const double x = std::ldexp(1 + random.uniform(), static_cast<int>(random.below(2000)) - 1000);
        const double hint = value_of_size_hint(size_hint_of(x));
        CHECK(hint <= x);
        CHECK(hint > x * (1 - 1.0 / 32));
    }
    CHECK(value_of_size_hint(size_hint_of(infinity)) == infinity);
    CHECK(value_of_size_hint(0) == 0);
}

TEST_CASE("feature sizes are the distances to the second nearest input") {
    const inputs::Points points = inputs::clusters(3, 150);
    Meshed<3> m(points, by_quality(3));
    REQUIRE(m.status == Status::ok);
    InputTree<3> tree;
    REQUIRE(tree.build(m.store, m.block.arena, 150) == Status::ok);
    for (std::uint32_t v = 0; v < m.state.vertex_count; v += 3)
        CHECK(feature_size(m.store, tree, v) ==
              doctest::Approx(feature_size_by_scan(points, 3, m.store.point(v))).epsilon(1e-12));
}

TEST_CASE("meshes over-refined to eps f_P") {
    for (const int dim : dimensions(2, 5)) {
        const std::size_t n = by_dimension<std::size_t>(dim, {150, 60, 20, 8});
        const double eps = by_dimension<double>(dim, {0.25, 0.5, 0.8, 0.9});
        for (const inputs::Points& points : {inputs::uniform(dim, n), inputs::clusters(dim, n / 2)}) {
            INFO("D = " << dim);
            Session session(dim);
            REQUIRE(session.mesh(points) == NETMESH_OK);
            const std::uint64_t before = session.report().mesh.vertices;
            session.request.mesh.sizes.eps = eps;
            REQUIRE(session.mesh(points) == NETMESH_OK);
            const netmesh_report r = session.report();
            CHECK(r.mesh.vertices > before);
            CHECK(r.mesh.aspect_ratio_max <= r.mesh.tau);
            CHECK(r.mesh.sizes.ratio_max <= 1);
            CHECK(r.mesh.sizes.ratio_max > 0.5);
            CHECK(worst_by_corners(session, [&](const double* x) {
                      return eps * feature_size_by_scan(points, dim, x);
                  }) <= 1 + 1e-9);
            CHECK(session.check() == NETMESH_OK);
            // The same mesh does not keep a smaller promise.
            session.request.mesh.sizes.eps = eps / 2;
            CHECK(session.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
        }
    }
}

TEST_CASE("finished meshes that had cages are over-refined as those of SVR") {
    for (const int dim : dimensions(2, 4)) {
        const double eps = by_dimension<double>(dim, {0.3, 0.6, 1.2});
        const std::size_t n = by_dimension<std::size_t>(dim, {8, 4, 2});
        for (const inputs::Points& points : {inputs::geometric(dim, 40, n), inputs::close_pairs(dim, n, 1e-3)}) {
            INFO("D = " << dim);
            Session session(dim);
            session.reserve(std::size_t{1} << 27);  // the checks need room beside the mesh
            session.request.mesh.sizes.eps = eps;
            REQUIRE(session.mesh(points) == NETMESH_OK);
            const std::uint64_t direct = session.report().mesh.vertices;
            session.request.mesh.sizes.eps = 0;
            session.request.mesh.method = &netmesh_method_netmesh;
            session.request.mesh.finish = 1;
            REQUIRE(session.mesh(points) == NETMESH_OK);
            const std::uint64_t before = session.report().mesh.vertices;
            const auto promised = [&](const double* x) { return eps * feature_size_by_scan(points, dim, x); };
            CHECK(worst_by_corners(session, promised) > 1);
            session.request.mesh.sizes.eps = eps;
            REQUIRE(session.mesh(points) == NETMESH_OK);
            const netmesh_report r = session.report();
            CHECK(r.mesh.hierarchy.cages_made > 0);
            CHECK(r.mesh.hierarchy.cages == 0);
            CHECK(r.mesh.vertices > before);
            CHECK(r.mesh.aspect_ratio_max <= r.mesh.tau);
            CHECK(r.mesh.sizes.ratio_max <= 1);
            CHECK(r.mesh.sizes.ratio_max > 0.5);
            CHECK(worst_by_corners(session, promised) <= 1 + 1e-9);
            CHECK(static_cast<double>(r.mesh.vertices) < 1.5 * static_cast<double>(direct));
            CHECK(session.check() == NETMESH_OK);
            session.request.mesh.sizes.eps = eps / 2;
            CHECK(session.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
            session.request.mesh.finish = 0;
            CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
            CHECK(session.detail().field == NETMESH_FIELD_SIZES);
        }
    }
}

TEST_CASE_TEMPLATE_DEFINE("vertices of finished meshes know their nearest inputs, over-refined or not", T, origins) {
    constexpr int D = T::value;
    for (const double eps : {0.0, 0.5}) {
        MeshRequest request = by_hierarchy(3, true);
        request.size.eps = eps;
        Meshed<D> m(inputs::geometric(D, 40, 5), request);
        REQUIRE(m.status == Status::ok);
        CHECK(m.result.hierarchy.cages_made > 0);
        const std::uint32_t inputs = static_cast<std::uint32_t>(m.result.input.rows);
        std::uint32_t wrong = 0;
        for (VertexId v(inputs); v < m.state.vertex_count; ++v) {
            const double* const x = m.store.point(v);
            double least = infinity;
            for (VertexId p(0); p < inputs; ++p) least = std::min(least, distance(m.store.point(p), x, D));
            wrong += distance(m.store.point(VertexId(m.store.vertex(v).origin)), x, D) > least * (1 + 1e-12);
        }
        CHECK(wrong == 0);
    }
}
TEST_CASE_TEMPLATE_APPLY(origins, Dimensions<2, 3>);

TEST_CASE("meshes follow a sizing function, alone and together with eps") {
    for (const int dim : dimensions(2, 4)) {
        INFO("D = " << dim);
        Funnel funnel{dim, dim == 4 ? 0.2 : 0.03, dim == 4 ? 0.5 : 0.3};
        const inputs::Points points = inputs::uniform(dim, 20);
        Session session(dim);
        session.request.mesh.sizes.size = Funnel::size;
        session.request.mesh.sizes.user = &funnel;
        REQUIRE(session.mesh(points) == NETMESH_OK);
        const std::uint64_t alone = session.report().mesh.vertices;
        CHECK(session.report().mesh.sizes.ratio_max <= 1);
        CHECK(worst_by_corners(session, [&](const double* x) { return Funnel::size(&funnel, x); }) <= 1 + 1e-9);
        CHECK(session.check() == NETMESH_OK);
        session.request.mesh.sizes.eps = 0.7;
        REQUIRE(session.mesh(points) == NETMESH_OK);
        CHECK(session.report().mesh.vertices > alone);
        CHECK(worst_by_corners(session, [&](const double* x) {
                  return std::min(Funnel::size(&funnel, x), 0.7 * feature_size_by_scan(points, dim, x));
              }) <= 1 + 1e-9);
        CHECK(session.check() == NETMESH_OK);
    }
}

TEST_CASE("the number of vertices grows as eps^-D") {
    const inputs::Points points = inputs::uniform(2, 50);
    Session session(2);
    std::uint64_t count[3];
    for (int i = 0; i < 3; ++i) {
        session.request.mesh.sizes.eps = 0.2 / (1 << i);
        REQUIRE(session.mesh(points) == NETMESH_OK);
        count[i] = session.report().mesh.vertices;
    }
    CHECK(static_cast<double>(count[1]) / static_cast<double>(count[0]) == doctest::Approx(4).epsilon(0.25));
    CHECK(static_cast<double>(count[2]) / static_cast<double>(count[1]) == doctest::Approx(4).epsilon(0.25));
}

TEST_CASE("no point of the domain is farther from its vertex than asked for, by sampling") {
    for (const int dim : dimensions(2, 4))
        for (std::size_t n : {1, 2, 3, 12}) {
            INFO("D = " << dim << ", " << n << " points");
            Funnel funnel{dim, dim == 2 ? 0.05 : dim == 3 ? 0.15 : 0.4, 0.2};
            Session session(dim);
            session.request.mesh.method = n == 3 ? &netmesh_method_netmesh : &netmesh_method_svr;
            session.request.mesh.finish = n == 3;
            session.request.mesh.sizes.size = Funnel::size;
            session.request.mesh.sizes.user = &funnel;
            REQUIRE(session.mesh(n == 3 ? inputs::geometric(dim, 40, 3) : inputs::uniform(dim, n)) == NETMESH_OK);
            CHECK(session.check() == NETMESH_OK);
            CHECK(worst_by_sampling(session, [&](const double* x) { return Funnel::size(&funnel, x); }) <= 1 + 1e-9);
        }
}

TEST_CASE("no sampled cell reaches farther than a size that grows with the distance to the inputs") {
    for (const int dim : dimensions(2, 4)) {
        const std::size_t n = by_dimension<std::size_t>(dim, {30, 12, 5});
        const double size = by_dimension<double>(dim, {0.05, 0.15, 0.3}), growth = 0.25;
        const inputs::Points points = inputs::uniform(dim, n);
        Session session(dim);
        session.request.mesh.tau = dim < 4 ? 3 : 4;
        REQUIRE(session.mesh(points) == NETMESH_OK);
        const std::uint64_t unsized = session.report().mesh.vertices;
        session.request.mesh.sizes.at_inputs = size;
        session.request.mesh.sizes.growth = growth;
        REQUIRE(session.mesh(points) == NETMESH_OK);
        const netmesh_report r = session.report();
        CHECK(static_cast<double>(r.mesh.vertices) > (dim < 4 ? 2 : 1.5) * static_cast<double>(unsized));
        CHECK(r.mesh.sizes.ratio_max <= 1);
        CHECK(r.mesh.sizes.ratio_max > 0.5);
        CHECK(session.check() == NETMESH_OK);
        session.request.mesh.sizes.growth = growth / 4;
        CHECK(session.check() == NETMESH_CHECK_FAILED);
        const double worst = worst_by_sampling(
            session, [&](const double* x) { return size + growth * distances_by_scan(points, dim, x).first; });
        CHECK(worst <= 1 + 1e-9);
        CHECK(worst > 0.5);
    }
}

TEST_CASE("check finds the sizes of a mesh by itself") {
    // Meshed without a size: refused where a corner is beyond it, accepted where no sample is near it.
    for (const int dim : dimensions(2, 3)) {
        const inputs::Points points = inputs::uniform(dim, 25);
        Session session(dim);
        REQUIRE(session.mesh(points) == NETMESH_OK);
        double low = 0, high = 1;  // of the size at the inputs
        while (high - low > 1e-6) {
            const double at = (low + high) / 2;
            const auto size = [&](const double* x) { return at + distances_by_scan(points, dim, x).first / 2; };
            const bool kept = worst_by_corners(session, size) <= 1 && worst_by_sampling(session, size) <= 1;
            (kept ? high : low) = at;
        }
        session.request.mesh.sizes.growth = 0.5;
        session.request.mesh.sizes.at_inputs = 0.999 * low;
        CHECK(session.check() == NETMESH_CHECK_FAILED);
        session.request.mesh.sizes.at_inputs = 1.1 * high;
        CHECK(session.check() == NETMESH_OK);
    }
}

TEST_CASE("one point: eps asks for nothing") {
    Session session(2);
    session.request.mesh.sizes.eps = 0.1;
    REQUIRE(session.mesh({3, 4}) == NETMESH_OK);
    CHECK(session.report().mesh.vertices == 5);
    CHECK(session.report().mesh.sizes.ratio_max == 0);
    CHECK(session.check() == NETMESH_OK);
}

TEST_CASE("sizes that cannot be reached are refused") {
    for (const int dim : dimensions()) {
        const std::size_t n = dim < 4 ? 20 : 4;
        const inputs::Points points = inputs::uniform(dim, n);
        Session session(dim);
        session.request.mesh.tau = dim < 5 ? 3 : 6;
        double value = 0;
        session.request.mesh.sizes.size = [](void* user, const double*) { return *static_cast<double*>(user); };
        session.request.mesh.sizes.user = &value;
        for (double bad : {0.0, -1.0, 1e-17, 1e-310, std::nan("")}) {
            value = bad;
            CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
            CHECK(session.detail().field == NETMESH_FIELD_SIZES);
            CHECK(session.report().mesh.vertices == 0);
        }
        value = infinity;
        CHECK(session.mesh(points) == NETMESH_OK);
        session.request.mesh.sizes = {};
        for (double bad : {-1.0, infinity, std::nan("")}) {
            session.request.mesh.sizes.eps = bad;
            CHECK(session.mesh_in_block(points) == NETMESH_INVALID_ARGUMENT);
            CHECK(session.detail().field == NETMESH_FIELD_SIZE_EPS);
        }
    }
}

// Small at the inputs, impossible anywhere else.
struct OnlyAtInputs {
    int dim;
    const inputs::Points* points;
    double size, elsewhere;
    static double at(void* user, const double* x) {
        const OnlyAtInputs& only = *static_cast<const OnlyAtInputs*>(user);
        const std::size_t d = static_cast<std::size_t>(only.dim);
        for (std::size_t i = 0; i < only.points->size(); i += d)
            if (std::equal(x, x + d, &(*only.points)[i])) return only.size;
        return only.elsewhere;
    }
};

TEST_CASE("a size refused at a Steiner point names the input nearest to it, and infinite ones ask for nothing") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const inputs::Points points = inputs::uniform(dim, 3);
        OnlyAtInputs only = {dim, &points, dim < 5 ? 0.3 : 0.45, -1};
        Session session(dim);
        session.request.mesh.tau = 4;
        session.request.mesh.sizes.size = OnlyAtInputs::at;
        session.request.mesh.sizes.user = &only;
        CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.report().mesh.vertices == 0);
        only.elsewhere = infinity;
        REQUIRE(session.mesh(points) == NETMESH_OK);
        CHECK(session.report().mesh.sizes.ratio_max <= 1);
        CHECK(session.check() == NETMESH_OK);
        // What the function says later is what is compared.
        only.size = 0;
        CHECK(session.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
    }
}

TEST_CASE("any block size leaves a Delaunay mesh when over-refinement runs out of memory") {
    const inputs::Points points = inputs::uniform(2, 12);
    Session session(2);
    session.request.mesh.sizes.eps = 0.3;
    int partial = 0;
    for (std::size_t bytes = 8192; bytes < 400000; bytes += 9000) {
        session.reserve(bytes);
        const netmesh_status status = session.mesh_in_block(points);
        REQUIRE((status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY));
        const netmesh_report r = session.report();
        if (status == NETMESH_OK || r.mesh.cells == 0) continue;
        CHECK(r.complete == 0);
        CHECK(session.check(7) == NETMESH_OK);
        partial += r.mesh.inputs == 12;
    }
    CHECK(partial > 5);
}
