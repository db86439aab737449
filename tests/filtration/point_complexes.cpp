// Cech, Rips and barycentric filtrations against brute force: smallest enclosing balls by trying every support,
// textbook reduction, and the k-nerve by its definition.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "common/block.hpp"
#include "common/bottleneck.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/session.hpp"
#include "filtration/point_complexes.hpp"
#include "filtration/rips_graph.hpp"
#include "geometry/half_distance.hpp"
#include "homology/oracle.hpp"

using oracle::Simplex;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Diagram = std::vector<netmesh_pair>;
using Vector = std::vector<long double>;

Diagram persist(int dim, const inputs::Points& points, const netmesh_filter* filter, std::uint32_t k,
                std::uint32_t degree, netmesh_values values = NETMESH_VALUES_CERTIFIED) {
    Session session(dim);
    netmesh::Request request = session.points_request(points, filter, k, degree);
    request.values = values;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    return session.pairs();
}

// e^distance in log scale, the largest difference in plain scale.
double distance(const Diagram& a, const Diagram& b, netmesh_scale scale) {
    const Distance d = bottleneck(a, b, scale);
    REQUIRE(d.status == NETMESH_OK);
    return std::ldexp(d.value, d.exponent);
}

long double square_distance(const inputs::Points& points, int dim, std::uint32_t i, const Vector& c) {
    long double s = 0;
    for (int d = 0; d < dim; ++d) {
        const long double x =
            points[i * static_cast<std::size_t>(dim) + static_cast<std::size_t>(d)] - c[static_cast<std::size_t>(d)];
        s += x * x;
    }
    return s;
}

// The centre equally far from the points of `support`, in their affine hull; false when they are dependent.
bool circumcentre(const inputs::Points& points, int dim, const Simplex& support, Vector* centre) {
    const std::size_t m = support.size() - 1, d = static_cast<std::size_t>(dim);
    std::vector<Vector> rows(m, Vector(m + 1)), edges(m, Vector(d));
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t x = 0; x < d; ++x)
            edges[i][x] = (long double)points[support[i + 1] * d + x] - points[support[0] * d + x];
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < m; ++j)
            for (std::size_t x = 0; x < d; ++x) rows[i][j] += 2 * edges[i][x] * edges[j][x];
        rows[i][m] = rows[i][i] / 2;
    }
    for (std::size_t i = 0; i < m; ++i) {
        std::size_t pivot = i;
        for (std::size_t r = i + 1; r < m; ++r)
            if (fabsl(rows[r][i]) > fabsl(rows[pivot][i])) pivot = r;
        std::swap(rows[i], rows[pivot]);
        if (fabsl(rows[i][i]) < 1e-15L) return false;
        for (std::size_t r = 0; r < m; ++r) {
            if (r == i) continue;
            const long double f = rows[r][i] / rows[i][i];
            for (std::size_t c = i; c <= m; ++c) rows[r][c] -= f * rows[i][c];
        }
    }
    centre->assign(points.begin() + static_cast<std::ptrdiff_t>(support[0] * d),
                   points.begin() + static_cast<std::ptrdiff_t>((support[0] + 1) * d));
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t x = 0; x < d; ++x) (*centre)[x] += rows[i][m] / rows[i][i] * edges[i][x];
    return true;
}

// The smallest ball around all, by every support that could hold it.
double enclosing_radius(const inputs::Points& points, int dim, const Simplex& s) {
    long double best = infinity;
    for (std::uint32_t mask = 1; mask < 1u << s.size(); ++mask) {
        Simplex support;
        for (std::size_t i = 0; i < s.size(); ++i)
            if (mask >> i & 1) support.push_back(s[i]);
        Vector c;
        if (support.size() > static_cast<std::size_t>(dim) + 1 || !circumcentre(points, dim, support, &c)) continue;
        const long double r = square_distance(points, dim, support[0], c);
        bool holds = r < best;
        for (const std::uint32_t i : s)
            holds = holds && square_distance(points, dim, i, c) <= r * (1 + 1e-12L) + 1e-300L;
        if (holds) best = r;
    }
    return static_cast<double>(sqrtl(best));
}

double half_diameter(const inputs::Points& points, int dim, const Simplex& s) {
    double most = 0;
    for (const std::uint32_t i : s)
        for (const std::uint32_t j : s) most = std::max(most, enclosing_radius(points, dim, {i, j}));
    return most;
}

// All subsets of 0..n-1 with at most `most` members, by size.
std::vector<Simplex> subsets(std::uint32_t n, std::size_t least, std::size_t most) {
    std::vector<Simplex> all;
    for (std::uint32_t mask = 1; mask < 1u << n; ++mask) {
        Simplex s;
        for (std::uint32_t i = 0; i < n; ++i)
            if (mask >> i & 1) s.push_back(i);
        if (s.size() >= least && s.size() <= most) all.push_back(s);
    }
    return all;
}

Diagram textbook(const oracle::Filtered& f, std::uint32_t degree) {
    Diagram bars;
    for (const netmesh::Pair& p : oracle::diagram(f, degree, false)) bars.push_back(bar(p.degree, p.birth, p.death));
    return bars;
}

// The nerve of the k-wise intersections of balls, by its definition: vertices are sets of k points, a simplex enters
// when all balls about all of their points meet.
Diagram k_nerve(const inputs::Points& points, int dim, std::uint32_t k, std::uint32_t degree) {
    const std::uint32_t n = static_cast<std::uint32_t>(points.size() / static_cast<std::size_t>(dim));
    const std::vector<Simplex> sets = subsets(n, k, k);
    std::map<Simplex, double> radius;
    const auto value = [&](const Simplex& simplex) {
        std::set<std::uint32_t> all;
        for (const std::uint32_t v : simplex) all.insert(sets[v].begin(), sets[v].end());
        const Simplex u(all.begin(), all.end());
        const auto found = radius.find(u);
        return found != radius.end() ? found->second : radius[u] = enclosing_radius(points, dim, u);
    };
    std::vector<Simplex> simplices, last = {{}};
    for (std::uint32_t size = 1; size <= degree + 2; ++size) {
        std::vector<Simplex> next;
        for (const Simplex& s : last) {
            for (std::uint32_t v = s.empty() ? 0 : s.back() + 1; v < sets.size(); ++v) {
                next.push_back(s);
                next.back().push_back(v);
            }
        }
        simplices.insert(simplices.end(), next.begin(), next.end());
        last.swap(next);
    }
    // Values of faces and cofaces that are equal in theory differ in the last bits: made monotone by size.
    std::map<Simplex, double> values;
    for (const Simplex& s : simplices) {
        double v = value(s);
        for (std::size_t i = 0; i < s.size() && s.size() > 1; ++i) {
            Simplex face = s;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
            v = std::max(v, values.at(face));
        }
        values[s] = v;
    }
    return textbook(oracle::filter(simplices, [&](const Simplex& s) { return values.at(s); }), degree);
}

template <int D> void check_cech_values(const inputs::Points& points, std::uint32_t dimension) {
    Block block(std::size_t(1) << 24);
    netmesh::Monitor monitor;
    netmesh::ListedComplex c;
    const std::uint32_t n = static_cast<std::uint32_t>(points.size() / D);
    REQUIRE(netmesh::cech_complex(D, points.data(), n, dimension, {block.arena, monitor}, &c) == netmesh::Status::ok);
    const netmesh::FilteredComplex f = c.filtered();
    double total = 0;
    for (std::uint32_t k = 0; k <= dimension; ++k) {
        total += c.count[k];
        for (std::uint32_t i = 0; i < c.count[k]; ++i) {
            Simplex s(k + 1);
            netmesh::vertices_of(f, c.rows[0], k, i, s.data());
            CHECK(std::is_sorted(s.begin(), s.end()));
            const double exact = enclosing_radius(points, D, s);
            CHECK(std::fabs(c.value[k][i] - exact) <= 1e-14 * exact);
            for (std::uint32_t v = 0; v <= k && k > 0; ++v) {
                CHECK(c.value[k - 1][c.rows[k][std::size_t{i} * (k + 1) + v]] <= c.value[k][i]);
            }
        }
    }
    CHECK(total == netmesh::skeleton_count(n, dimension));
}

// Steps along each axis and back: many of the smallest balls have more points on their spheres than they need.
inputs::Points cross(int dim) {
    const std::size_t d = static_cast<std::size_t>(dim);
    inputs::Points p(2 * d * d, 0.0);
    for (std::size_t k = 0; k < d; ++k) p[2 * k * d + k] = -(p[(2 * k + 1) * d + k] = 1);
    return p;
}

}  // namespace

TEST_CASE("Cech values are smallest enclosing balls") {
    check_cech_values<2>(inputs::uniform(2, 12), 3);
    check_cech_values<2>(inputs::grid(2, 4), 3);
    check_cech_values<2>(inputs::circle(12), 4);
    check_cech_values<3>(inputs::uniform(3, 11), 4);
    check_cech_values<3>(inputs::grid(3, 2), 5);
    check_cech_values<3>(cross(3), 3);
    for_each_dimension<4, 4>([](auto dim) { check_cech_values<dim>(inputs::clifford(10), 5); });
    for_each_dimension<5, 6>([](auto dim) {
        check_cech_values<dim>(inputs::uniform(dim, 9), dim == 5 ? 6 : 8);
        check_cech_values<dim>(cross(dim), 3);
    });
}

TEST_CASE("Rips and Cech diagrams equal the textbook's on all simplices") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        for (const int dim : dimensions({2, 3})) {
            const inputs::Points points =
                seed == 6 ? inputs::grid(dim, dim == 2 ? 3 : 2) : inputs::uniform(dim, 9, seed);
            const std::uint32_t n = static_cast<std::uint32_t>(points.size() / static_cast<std::size_t>(dim));
            for (std::uint32_t degree = 0; degree <= 3; ++degree) {
                const auto all = subsets(n, 1, degree + 2);
                const auto rips = oracle::filter(all, [&](const Simplex& s) { return half_diameter(points, dim, s); });
                CHECK(distance(persist(dim, points, &netmesh_filter_rips, 0, degree), textbook(rips, degree),
                               NETMESH_SCALE_PLAIN) <= 1e-12);
                if (degree > 2) continue;
                const auto cech = oracle::filter(
                    all, [&](const Simplex& s) { return enclosing_radius(points, dim, s) + 1e-13 * double(s.size()); });
                CHECK(distance(persist(dim, points, &netmesh_filter_cech, 0, degree), textbook(cech, degree),
                               NETMESH_SCALE_PLAIN) <= 1e-11);
            }
        }
    }
}

TEST_CASE("degrees beyond what the points can have") {
    CHECK(persist(2, {1, 2}, &netmesh_filter_rips, 0, 30).size() == 1);
    CHECK(persist(2, {1, 2, 1, 2}, &netmesh_filter_cech, 0, 5).size() == 1);
    const Diagram two = persist(2, {0, 0, 3, 4}, &netmesh_filter_cech, 0, 1);
    REQUIRE(two.size() == 2);
    CHECK(two[0].death == 2.5);
    // Four corners of a square: a circle, and in the Rips complex of the octahedron's corners a sphere.
    const Diagram square = persist(2, {0, 0, 1, 0, 1, 1, 0, 1}, &netmesh_filter_rips, 0, 2);
    CHECK(square.back().degree == 1);
    CHECK(square.back().birth == 0.5);
    CHECK(square.back().death == std::sqrt(2.0) / 2);
    const Diagram octahedron =
        persist(3, {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1}, &netmesh_filter_rips, 0, 2);
    CHECK(octahedron.back().degree == 2);
    CHECK(octahedron.back().birth == std::sqrt(2.0) / 2);
    CHECK(octahedron.back().death == 1);
}

TEST_CASE("far and near points") {
    const double huge = 1.5e308, tiny = 4.9e-324;
    const Diagram far = persist(2, {-huge, 0, huge, 0}, &netmesh_filter_rips, 0, 1);
    CHECK(far[0].death == huge);
    const Diagram near = persist(2, {0, 0, 4 * tiny, 0, 0, 1}, &netmesh_filter_rips, 0, 1);
    CHECK(near[0].death == 2 * tiny);
}

TEST_CASE("in every dimension: points far apart and close, right triangles, two points") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim), n = d + 3;
        const std::uint32_t degree = static_cast<std::uint32_t>(dim) - 1;
        const inputs::Points points = inputs::uniform(dim, n);
        const Diagram base = persist(dim, points, &netmesh_filter_cech, 0, degree);
        for (const double scale : {0x1p600, 0x1p-600}) {
            inputs::Points scaled = points;
            for (double& x : scaled) x *= scale;
            const Diagram other = persist(dim, scaled, &netmesh_filter_cech, 0, degree);
            REQUIRE(other.size() == base.size());
            for (std::size_t i = 0; i < base.size(); ++i) {
                CHECK(other[i].birth / scale == doctest::Approx(base[i].birth));
                if (base[i].death < infinity) CHECK(other[i].death / scale == doctest::Approx(base[i].death));
            }
        }
        // Legs of 6 and 8: the hypotenuse and the triangle enter together.
        inputs::Points right(3 * d, 0.0);
        right[d] = 6;
        right[2 * d + 1] = 8;
        const Diagram triangle = persist(dim, right, &netmesh_filter_cech, 0, 1);
        REQUIRE(triangle.size() == 3);
        CHECK(triangle[0].death == 3);
        CHECK(triangle[1].death == 4);
        CHECK(triangle[2].death == infinity);
        // Two points have no simplices of the dimension that was asked for.
        right.resize(2 * d);
        const Diagram two = persist(dim, right, &netmesh_filter_cech, 0, 4);
        REQUIRE(two.size() == 2);
        CHECK(two[0].death == 3);
    }
}

template <int D> void check_graph() {
    CAPTURE(D);
    {  // two points and no triangle
        const inputs::Points two = inputs::uniform(D, 2);
        Block block(std::size_t{1} << 12);
        netmesh::Monitor monitor;
        netmesh::ListedComplex complex;
        REQUIRE(netmesh::full_rips_complex(D, two.data(), 2, 3, {block.arena, monitor}, &complex) ==
                netmesh::Status::ok);
        CHECK(complex.dimension == 1);
        CHECK(complex.count[1] == 1);
    }
    const inputs::Points points = inputs::uniform(D, 2000);
    const auto graph = [&](std::uint32_t n, std::size_t bytes, netmesh::Monitor monitor, netmesh::RipsGraph* out) {
        Block block(bytes);
        const netmesh::Status status =
            netmesh::rips_graph<D>(D, points.data(), n, infinity, {block.arena, monitor}, out);
        for (std::uint32_t e = 0; status == netmesh::Status::ok && e < out->edge_count; ++e) CHECK(out->value[e] > 0);
        return status;
    };
    netmesh::RipsGraph out;
    REQUIRE(graph(20, std::size_t{1} << 16, {}, &out) == netmesh::Status::ok);
    CHECK(out.edge_count <= 190);
    CHECK(out.edge_count > 80);
    const std::size_t half = std::size_t{out.edge_count} * 8 + 64;  // room for the values alone
    for (const std::size_t bytes : {std::size_t{16}, half})
        CHECK(graph(20, bytes, {}, &out) == netmesh::Status::out_of_memory);
    CHECK(graph(netmesh::RipsGraph::vertices_max + 1, 64, {}, &out) == netmesh::Status::invalid_argument);
    // Stopped while edges are counted, and while they are written.
    for (const int turn : {0, 1}) {
        int left = turn;
        const netmesh_poll poll = [](void* user, const netmesh_progress*) {
            return static_cast<int>((*static_cast<int*>(user))-- == 0);
        };
        CHECK(graph(2000, std::size_t{1} << 26, {poll, &left}, &out) == netmesh::Status::cancelled);
    }
}

TEST_CASE("graphs: what does not fit and what is stopped") {
    for_each_dimension([](auto dim) { check_graph<dim>(); });
}

// From the least distance on within which some point has all others, everything is a cone with that point on top. What
// enters then belongs to the complex, without it two points would never meet.
template <int D> void check_cone(const inputs::Points& points, std::uint32_t dimension) {
    CAPTURE(D);
    const std::uint32_t n = static_cast<std::uint32_t>(points.size() / D);
    double cone = infinity;
    for (std::uint32_t i = 0; i < n; ++i) {
        double most = 0;
        for (std::uint32_t j = 0; j < n; ++j)
            most = std::max(most, netmesh::half_distance<D>(&points[std::size_t{i} * D], &points[std::size_t{j} * D]));
        cone = std::min(cone, most);
    }
    CHECK(netmesh::cone_radius<D>(D, points.data(), n) == cone);
    Block block(std::size_t{1} << 22);
    netmesh::Monitor monitor;
    netmesh::ListedComplex complex, all;
    REQUIRE(netmesh::rips_complex(D, points.data(), n, dimension, infinity, {block.arena, monitor}, &complex) ==
            netmesh::Status::ok);
    REQUIRE(netmesh::full_rips_complex(D, points.data(), n, dimension, {block.arena, monitor}, &all) ==
            netmesh::Status::ok);
    for (std::uint32_t k = 0; k <= dimension && k < n; ++k) {
        std::vector<double> listed, expected;
        if (k <= complex.dimension) listed.assign(complex.value[k], complex.value[k] + complex.count[k]);
        for (std::uint32_t i = 0; i < all.count[k]; ++i)
            if (all.value[k][i] <= cone) expected.push_back(all.value[k][i]);
        std::sort(listed.begin(), listed.end());
        std::sort(expected.begin(), expected.end());
        CHECK(listed == expected);
    }
}

TEST_CASE("Rips complexes end where they become cones, with what enters there") {
    for_each_dimension([](auto dim) {
        check_cone<dim>(inputs::uniform(dim, 2), 1);
        check_cone<dim>(inputs::uniform(dim, 12), 3);
        inputs::Points centred = inputs::uniform(dim, 11);  // the point that has all others nearest comes last
        centred.insert(centred.end(), static_cast<std::size_t>(dim), 0.5);
        check_cone<dim>(centred, 2);
    });
}

TEST_CASE("barycentric complexes of more than there is") {
    Block block(std::size_t{1} << 16);
    netmesh::Monitor monitor;
    netmesh::ListedComplex complex, out;
    const double three[] = {0, 0, 1, 0, 0, 1};
    REQUIRE(netmesh::cech_complex(2, three, 3, 2, {block.arena, monitor}, &complex) == netmesh::Status::ok);
    CHECK(netmesh::barycentric_complex(complex, 4, 2, 1, {block.arena, monitor}, &out) ==
          netmesh::Status::invalid_argument);
    CHECK(netmesh::barycentric_complex(complex, 3, 2, 1, {block.arena, monitor}, &out) == netmesh::Status::ok);
    CHECK(out.count[0] == 1);
    CHECK(netmesh::barycentric_count(5, 2, 100, 1) == netmesh::barycentric_count(5, 2, 5, 1));
}

TEST_CASE("barycentric Cech equals the k-nerve on 50 random sets, Rips is within the fourth root of 2") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        CAPTURE(seed);
        const int dim = seed % 2 == 0 ? 2 : 3;
        const inputs::Points points = inputs::uniform(dim, 6, 100 + seed);
        for (std::uint32_t k = 1; k <= 4; ++k) {
            CAPTURE(k);
            const Diagram exact = k_nerve(points, dim, k, 1);
            const Diagram cech = persist(dim, points, &netmesh_filter_barycentric_cech, k, 1);
            CHECK(distance(cech, exact, NETMESH_SCALE_PLAIN) <= 1e-9);
            const Diagram rips = persist(dim, points, &netmesh_filter_barycentric_rips, k, 1);
            CHECK(distance(rips, cech, NETMESH_SCALE_LOG) <= std::pow(2, 0.25) * (1 + 1e-11));
            const Diagram own = persist(dim, points, &netmesh_filter_barycentric_rips, k, 1, NETMESH_VALUES_THESIS);
            CHECK(distance(own, cech, NETMESH_SCALE_LOG) <= std::sqrt(2.0) * (1 + 1e-11));
        }
    }
}

TEST_CASE("barycentric Cech in degree 2, and of one point each is the Cech complex") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const inputs::Points points = inputs::uniform(3, 6, 200 + seed);
        CHECK(distance(persist(3, points, &netmesh_filter_barycentric_cech, 2, 2), k_nerve(points, 3, 2, 2),
                       NETMESH_SCALE_PLAIN) <= 1e-9);
        const inputs::Points more = inputs::uniform(2, 14, 300 + seed);
        CHECK(distance(persist(2, more, &netmesh_filter_barycentric_cech, 1, 1),
                       persist(2, more, &netmesh_filter_cech, 0, 1), NETMESH_SCALE_PLAIN) <= 1e-15);
    }
}

TEST_CASE("the report names filter, k and ratio; arguments are checked") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 8);
    const auto call = [&](const netmesh_filter* filter, std::uint32_t k, std::uint32_t degree) {
        const netmesh::Request request = session.points_request(points, filter, k, degree);
        return netmesh_persist(session.context, &request);
    };
    REQUIRE(call(&netmesh_filter_barycentric_rips, 3, 1) == NETMESH_OK);
    netmesh_report r = session.report();
    CHECK(r.diagram.filter == NETMESH_FILTER_BARYCENTRIC_RIPS);
    CHECK(r.diagram.k == 3);
    CHECK(r.diagram.certified_ratio == doctest::Approx(std::pow(2, 0.25)).epsilon(1e-15));
    CHECK(r.input.points == 8);
    CHECK(r.diagram.simplices == netmesh::barycentric_count(8, 3, 5, 2));
    CHECK(r.diagram.essential[0] == 1);
    CHECK(call(&netmesh_filter_barycentric_cech, 9, 1) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_K);
    CHECK(call(&netmesh_filter_barycentric_cech, 0, 1) == NETMESH_OK);
    CHECK(session.report().diagram.k == 1);
    CHECK(call(&netmesh_filter_barycentric_cech, 8, 1) == NETMESH_OK);
    CHECK(session.pairs().size() == 1);
    CHECK(call(&netmesh_filter_barycentric_cech, 30, 1) == NETMESH_INVALID_ARGUMENT);
    CHECK(call(&netmesh_filter_rips, 0, 31) == NETMESH_INVALID_ARGUMENT);
    for (const double threshold : {-1.0, std::nan(""), 1.0}) {
        netmesh::Request request = session.points_request(points, &netmesh_filter_cech);
        request.threshold = threshold;
        CHECK(session.persist_until_it_fits(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_THRESHOLD);
    }
    CHECK(call(&netmesh_filter_cech, 0, 1) == NETMESH_OK);
    CHECK(session.persist(&netmesh_filter_alpha) == NETMESH_NO_RESULT);
    CHECK(session.check() == NETMESH_NO_RESULT);
    auto v = netmesh::sized<netmesh_vertex>();
    CHECK(netmesh_get_vertex(session.context, 0, &v) == NETMESH_INVALID_ARGUMENT);
    inputs::Points bad = points;
    bad[7] = std::nan("");
    CHECK(session.persist_until_it_fits(session.points_request(bad, &netmesh_filter_rips)) == NETMESH_NOT_FINITE);
    CHECK(session.detail().index_a == 3);
}

TEST_CASE("what is planned is enough, what is too small says so") {
    for (const netmesh_filter* const filter : {&netmesh_filter_rips, &netmesh_filter_cech,
                                               &netmesh_filter_barycentric_cech, &netmesh_filter_barycentric_rips}) {
        const bool sets = filter == &netmesh_filter_barycentric_cech || filter == &netmesh_filter_barycentric_rips;
        for (const std::size_t n : {1, 5, 13, 40}) {
            if (sets && n > 13) continue;
            Session session(3);
            const inputs::Points points = inputs::uniform(3, n);
            const netmesh::Request request = session.points_request(points, filter);
            const std::size_t planned = netmesh_plan(&request);
            bool fitted = false;
            for (const double share : {0.001, 0.01, 0.1, 0.2, 0.4, 1.0}) {
                const std::size_t bytes = static_cast<std::size_t>(share * static_cast<double>(planned)) + 4096;
                session.reserve(bytes);
                const netmesh_status status = netmesh_persist(session.context, &request);
                CHECK((status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY));
                CHECK(!(fitted && status != NETMESH_OK));
                fitted = fitted || status == NETMESH_OK;
                if (status == NETMESH_OUT_OF_MEMORY) CHECK(session.detail().bytes_wanted > 4096);
            }
            CHECK(fitted);
        }
    }
    netmesh::Request request(&netmesh_filter_rips);
    request.points.dim = 3;
    request.points.count = 1u << 28;
    request.max_degree = 30;
    CHECK(netmesh_plan(&request) == SIZE_MAX);
    request.points.count = 5;
    request.k = 2;
    CHECK(netmesh_plan(&request) == 0);
}
