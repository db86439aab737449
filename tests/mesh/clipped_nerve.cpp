// The nerve of clipped cells on refined meshes: its shape, the same again from a slow way by plain elimination, and
// what happens when memory ends. Exact comparisons: tests/oracle/clipped_nerve.cpp.
#include "mesh/clip/clipped_nerve.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "certificate/rounding.hpp"
#include "common/dimensions.hpp"
#include "common/meshed.hpp"
#include "common/nerve.hpp"
#include "common/simplices.hpp"

using namespace netmesh;

namespace {

constexpr double clip = 1 + 0x1p-9;

template <int D> Domain<D> clipped_domain(const Meshed<D>& mesh) {
    Domain<D> domain = mesh.result.domain;
    domain.radius = clip * domain.enclosing_radius * up;
    return domain;
}

// The point nearest to o equidistant from the vertices of s: o + sum of factors times edges, by elimination.
template <int D> std::vector<double> foot(const Store<D>& store, const Simplex& s, const double* o) {
    using Real = long double;
    const std::size_t n = s.size() - 1;
    std::vector<std::vector<Real>> edge(n, std::vector<Real>(D)), a(n, std::vector<Real>(n + 1, 0));
    for (std::size_t i = 0; i < n; ++i)
        for (int k = 0; k < D; ++k)
            edge[i][static_cast<std::size_t>(k)] = Real{store.point(s[i + 1])[k]} - store.point(s[0])[k];
    for (std::size_t i = 0; i < n; ++i)
        for (int k = 0; k < D; ++k) {
            const auto at = static_cast<std::size_t>(k);
            for (std::size_t j = 0; j < n; ++j) a[i][j] += edge[i][at] * edge[j][at];
            a[i][n] += edge[i][at] * (edge[i][at] / 2 - (Real{o[k]} - store.point(s[0])[k]));
        }
    for (std::size_t p = 0; p < n; ++p)
        for (std::size_t i = 0; i < n; ++i) {
            const Real factor = i == p ? 0 : a[i][p] / a[p][p];
            for (std::size_t j = p; j <= n && i != p; ++j) a[i][j] -= factor * a[p][j];
        }
    std::vector<double> x(o, o + D);
    for (std::size_t k = 0; k < D; ++k) {
        Real sum = o[k];
        for (std::size_t i = 0; i < n; ++i) sum += a[i][n] / a[i][i] * edge[i][k];
        x[k] = static_cast<double>(sum);
    }
    return x;
}

// m for all simplices, from the cells down.
template <int D> std::map<Simplex, double> distances(const Store<D>& store, const Simplices& all, const double* o) {
    std::map<Simplex, Simplices> cofacets;
    for (const Simplex& s : all)
        for (std::size_t i = 0; i < s.size() && s.size() > 1; ++i) {
            Simplex facet = s;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            cofacets[facet].insert(s);
        }
    std::map<Simplex, double> m;
    for (std::size_t size = D + 1; size >= 1; --size)
        for (const Simplex& s : all) {
            if (s.size() != size) continue;
            const std::vector<double> x = foot<D>(store, s, o);
            bool inside = true;
            double least = HUGE_VAL;
            for (const Simplex& t : cofacets[s]) {
                std::uint32_t w = t.back();
                for (std::size_t i = 0; i < s.size(); ++i)
                    if (t[i] != s[i]) {
                        w = t[i];
                        break;
                    }
                inside &= distance2<D>(x.data(), store.point(w)) >= distance2<D>(x.data(), store.point(s[0]));
                least = std::min(least, m.at(t));
            }
            m[s] = inside ? distance<D>(x.data(), o) : least;
        }
    return m;
}

template <int D> void check_nerve(const std::string& name, const inputs::Points& points, double ratio) {
    CAPTURE(name);
    CAPTURE(ratio);
    Meshed<D> mesh(points, by_certificate({ratio, 0, 0, 0}));
    REQUIRE(mesh.status == Status::ok);
    Domain<D> domain = clipped_domain<D>(mesh);
    Subcomplex<D> part;
    bool found = false;
    const std::size_t high = mesh.block.arena.high_mark();
    REQUIRE(choose_nerve<D>(mesh.store, &domain, {mesh.block.arena, mesh.monitor}, &part, &found) == Status::ok);
    REQUIRE(found);
    CHECK(mesh.block.arena.high_mark() == high);
    CHECK(domain.radius <= clip * domain.enclosing_radius * up);
    CHECK(domain.radius > domain.enclosing_radius);

    const Simplices all = simplices_of<D>(mesh.store), in = simplices_of<D>(mesh.store, part, all);
    int euler = 0, wrong = 0, close = 0;
    for (const Simplex& s : in) {
        euler += s.size() % 2 == 1 ? 1 : -1;
        for (std::size_t i = 0; i < s.size() && s.size() > 1; ++i) {
            Simplex facet = s;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            wrong += in.count(facet) == 0;
        }
    }
    CHECK(wrong == 0);
    CHECK(euler == 1);
    CHECK(in.size() < all.size());
    for (std::uint32_t v = 0; v < mesh.inputs(); ++v) CHECK(in.count({v}) == 1);
    for (const auto& [s, m] : distances<D>(mesh.store, all, domain.centre)) {
        if (std::fabs(m - domain.radius) < 1e-9 * domain.radius)
            ++close;
        else
            wrong += (m < domain.radius) != (in.count(s) == 1);
    }
    CHECK(wrong == 0);
    CHECK(close == 0);
    std::vector<int> seen(mesh.state.vertex_count, 0);
    for (const Simplex& s : all)
        for (const std::uint32_t v : s) seen[v] |= in.count(s) == 1 ? 1 : 2;
    for (std::uint32_t v = 0; v < mesh.state.vertex_count; ++v)
        CHECK(int(part.vertex[v]) == (seen[v] == 1   ? VertexPart::whole
                                      : seen[v] == 3 ? VertexPart::cut
                                                     : VertexPart::absent));

    // The radius that was chosen is the first to be tried next time.
    Domain<D> again = domain;
    Subcomplex<D> same;
    REQUIRE(choose_nerve<D>(mesh.store, &again, {mesh.block.arena, mesh.monitor}, &same, &found) == Status::ok);
    CHECK(found);
    CHECK(again.radius == domain.radius);
    CHECK(same.faces.count() == part.faces.count());
    CHECK(std::memcmp(same.cell, part.cell, mesh.state.cell_slots) == 0);
}

// Triangulated as they are: the corners of a square about the origin.
struct Square : Meshed<2> {
    Square() : Meshed<2>(std::size_t{1} << 20) {
        const double points[] = {-1, -1, 1, -1, -1, 1, 1, 1};
        InputReport report;
        REQUIRE(triangulate<2>(store, points, 4, 1, monitor, &report) == Status::ok);
        recompute_balls<2>(store);
    }
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("the nerve is closed, has the Euler characteristic of a point, and is the slow one", T,
                          nerves) {
    constexpr int D = T::value;
    check_nerve<D>("uniform", inputs::uniform(D, D == 2 ? 40 : D == 3 ? 12 : 6), 2.25);
    check_nerve<D>("shell", inputs::shell(D, D == 2 ? 20 : 6, 1, 1, 5), 2.5);
    check_nerve<D>("cube", inputs::grid(D, 2), 3);
    check_nerve<D>("close pairs", inputs::close_pairs(D, 3, 1e-3, 5), 3);
    for (std::size_t n = 1; n <= 3; ++n) check_nerve<D>("few", inputs::uniform(D, n, n), 2.25);
}
TEST_CASE_TEMPLATE_APPLY(nerves, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("nasty inputs have a nerve, at the first radius", T, nasty) {
    constexpr int D = T::value;
    const auto moved = [](inputs::Points points, double scale, double shift) {
        for (double& x : points) x = scale * x + shift;
        return points;
    };
    inputs::Points line, plane, pairs;
    inputs::Random random(4);
    for (int i = 0; i < 6; ++i) {
        const double s = random.uniform(), t = random.uniform();
        for (int k = 0; k < D; ++k) {
            line.push_back(s * (k + 1));
            plane.push_back(s * (k + 1) + t * (k * k - 1));
        }
    }
    for (int cluster = 0; cluster < 2; ++cluster)
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < D; ++k) pairs.push_back(cluster + 0.3 * k + 1e-12 * random.uniform());
    for (const inputs::Points& points :
         {inputs::grid(D, 2), moved(inputs::grid(D, 2), 0.1, 0.3), inputs::jittered(D, 2, 0x1p-51, 2),
          inputs::jittered(D, 2, 0x1p-48, 5), inputs::jittered(D, 2, 1e-30, 1),
          moved(inputs::jittered(D, 2, 0x1p-50, 1), 0.5, 0.7), moved(inputs::grid(D, 2), 0x1p450, 0),
          moved(inputs::grid(D, 2), 0x1p-450, 0), moved(inputs::uniform(D, 5), 1, 1e6), line, plane, pairs}) {
        Meshed<D> mesh(points, by_certificate({2.5, 0, 0, 0}));
        REQUIRE(mesh.status == Status::ok);
        Domain<D> domain = clipped_domain<D>(mesh);
        const double radius = domain.radius;
        Subcomplex<D> part;
        bool found = false;
        REQUIRE(choose_nerve<D>(mesh.store, &domain, {mesh.block.arena, mesh.monitor}, &part, &found) == Status::ok);
        CHECK(found);
        CHECK(domain.radius == radius);
    }
}
TEST_CASE_TEMPLATE_APPLY(nasty, Dimensions<2, 4>);

TEST_CASE("a radius at which the nerve changes is left out") {
    Square square;
    const Work work = {square.block.arena, square.monitor};
    Domain<2> domain = {{3, 0}, 3, 1};  // both cells have their centre at the origin
    Subcomplex<2> part;
    bool certain = true;
    const std::size_t low = square.block.arena.low_mark();
    REQUIRE(find_nerve<2>(square.store, domain, work, &part, &certain) == Status::ok);
    CHECK(!certain);
    CHECK(square.block.arena.low_mark() == low);
    REQUIRE(choose_nerve<2>(square.store, &domain, work, &part, &certain) == Status::ok);
    CHECK(certain);
    CHECK(domain.radius == 3 * (1 - 0x1p-16));
    // Only the corners on the right, and the edge between them.
    const Simplices all = simplices_of<2>(square.store);
    CHECK((simplices_of<2>(square.store, part, all) == Simplices{{1}, {3}, {1, 3}}));
    CHECK(part.vertex[0] == VertexPart::absent);
    CHECK(part.vertex[1] == VertexPart::cut);

    domain = {{3, 0}, 3, 3 * (1 - 0x1p-17)};
    REQUIRE(choose_nerve<2>(square.store, &domain, work, &part, &certain) == Status::ok);
    CHECK(!certain);
    CHECK(domain.radius == 3);

    domain = {{3, 0}, 3.0000000000000004, 1};
    REQUIRE(find_nerve<2>(square.store, domain, work, &part, &certain) == Status::ok);
    CHECK(certain);
    CHECK(simplices_of<2>(square.store, part, all) == all);
}

TEST_CASE_TEMPLATE_DEFINE("memory that ends anywhere leaves the mesh as it is", T, memory) {
    constexpr int D = T::value;
    Meshed<D> mesh(std::size_t{1} << 22);
    // Nearly in a plane, so that Voronoi edges through the ball have their ends far outside.
    inputs::Points points = inputs::uniform(D, by_dimension<std::size_t>(D, {60, 30, 20}));
    for (std::size_t i = 0; i < points.size(); i += D) points[i] *= 0x1p-20;
    InputReport report;
    REQUIRE(triangulate<D>(mesh.store, points.data(), points.size() / D, 1, mesh.monitor, &report) == Status::ok);
    recompute_balls<D>(mesh.store);
    Arena& arena = mesh.block.arena;
    std::vector<Cell<D>> cells;
    for (CellId c(0); c < mesh.state.cell_slots; ++c) cells.push_back(mesh.store.cell(c));
    Domain<D> ball = {};
    for (double& x : ball.centre) x = 0.5;
    ball.radius = 1;
    const std::size_t low = arena.low_mark(), high = arena.high_mark(), free = arena.bytes_free();
    int refused = 0;
    for (std::size_t left = 0;; left += 16) {
        REQUIRE(arena.template take_high<unsigned char>(free - left - 64) != nullptr);
        const std::size_t top = arena.high_mark();
        Subcomplex<D> part;
        bool certain = false;
        const Status status = find_nerve<D>(mesh.store, ball, {arena, mesh.monitor}, &part, &certain);
        CHECK(arena.high_mark() == top);
        if (status == Status::ok) {
            CHECK(certain);
            CHECK(part.faces.count() > 96);  // more than a first table holds, and a second
            CHECK(arena.low_mark() > low);
            break;
        }
        ++refused;
        REQUIRE(status == Status::out_of_memory);
        REQUIRE(arena.low_mark() == low);
        REQUIRE(arena.bytes_wanted() > 0);
        arena.release_high(high);
        for (CellId c(0); c < mesh.state.cell_slots; ++c) {
            Cell<D> cell = mesh.store.cell(c);
            cell.mark = cells[c].mark;
            REQUIRE(std::memcmp(&cell, &cells[c], sizeof cell) == 0);
        }
    }
    CHECK(refused > 10);
}
TEST_CASE_TEMPLATE_APPLY(memory, Dimensions<2, 4>);
