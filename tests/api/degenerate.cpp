// Inputs on which many Delaunay triangulations, or none, exist. Whatever ties are broken to, the result is a
// triangulation of the hull with empty balls, exactly.
#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

// Determinant of integer rows, exactly, by fraction-free elimination. Entries below 2^10 in magnitude.
long long determinant(std::vector<std::vector<long long>> m) {
    const std::size_t n = m.size();
    long long sign = 1, last = 1;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        std::size_t pivot = k;
        while (pivot < n && m[pivot][k] == 0) ++pivot;
        if (pivot == n) return 0;
        if (pivot != k) {
            std::swap(m[pivot], m[k]);
            sign = -sign;
        }
        for (std::size_t i = k + 1; i < n; ++i)
            for (std::size_t j = k + 1; j < n; ++j) m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) / last;
        last = m[k][k];
    }
    return sign * m[n - 1][n - 1];
}

// D! times the volume of all cells, for integer points; 0 when a cell is not positively oriented.
long long volume(const Session& session) {
    const std::size_t dim = session.dim();
    long long sum = 0;
    const std::vector<netmesh_vertex> vertices = session.vertices();
    const std::vector<netmesh_cell> cells = read_all(session.context, netmesh_get_cell);
    REQUIRE(vertices.size() == session.report().mesh.vertices);
    REQUIRE(cells.size() == session.report().mesh.cells);
    for (const netmesh_cell& cell : cells) {
        const netmesh_vertex& first = vertices.at(cell.vertices[0]);
        std::vector<std::vector<long long>> edges(dim, std::vector<long long>(dim));
        for (std::size_t i = 0; i < dim; ++i) {
            const netmesh_vertex& other = vertices.at(cell.vertices[i + 1]);
            for (std::size_t a = 0; a < dim; ++a)
                edges[i][a] = static_cast<long long>(other.coordinates[a] - first.coordinates[a]);
        }
        const long long d = determinant(edges);
        if (d <= 0) return 0;
        sum += d;
    }
    return sum;
}

long long power(long long base, int exponent) {
    long long p = 1;
    for (int i = 0; i < exponent; ++i) p *= base;
    return p;
}

// Points on the hyperplane x_0 + 2 x_1 + ... = 0, or its intersection with further ones, down to dimension `flat`.
inputs::Points flat_points(int dim, int flat, std::size_t n) {
    inputs::Random random(77);
    inputs::Points p;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> x(static_cast<std::size_t>(dim), 0.0);
        for (int a = 0; a < flat; ++a) {
            const double t = static_cast<double>(random.below(2000)) - 1000.0;
            for (int b = 0; b < dim; ++b)
                x[static_cast<std::size_t>(b)] += t * static_cast<double>((a * b + a + b) % 5 + (a == b));
        }
        p.insert(p.end(), x.begin(), x.end());
    }
    return p;
}

}  // namespace

TEST_CASE("grids: empty balls, and the cells fill the cube exactly") {
    for (const int dim : dimensions()) {
        const int side = by_dimension<int>(dim, {30, 9, 5, 4, 3});
        INFO("D = " << dim);
        Session session(dim);
        REQUIRE(session.delaunay(inputs::grid(dim, side)) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        long long factorial = 1;
        for (int i = 2; i <= dim; ++i) factorial *= i;
        CHECK(volume(session) == factorial * power(side - 1, dim));
        CHECK(session.report().mesh.vertices == static_cast<std::uint64_t>(power(side, dim)));
    }
}

TEST_CASE("integer points of one norm: all of them cospherical") {
    for (const int dim : dimensions()) {
        const int norm_squared = by_dimension<int>(dim, {32045, 161, 14, 7, 3});
        INFO("D = " << dim);
        const inputs::Points points = inputs::cospherical(dim, norm_squared);
        REQUIRE(points.size() / static_cast<std::size_t>(dim) >= 64);
        Session session(dim);
        session.reserve(std::size_t{64} << 20);  // with room for the checks
        REQUIRE(session.delaunay(points) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        // With the centre added every cell has it as a vertex: same hull, same volume.
        const long long hull = volume(session);
        CHECK(hull > 0);
        inputs::Points with_centre = points;
        with_centre.resize(points.size() + static_cast<std::size_t>(dim), 0.0);
        REQUIRE(session.delaunay(with_centre) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        CHECK(volume(session) == hull);
        const std::uint32_t centre = static_cast<std::uint32_t>(points.size() / static_cast<std::size_t>(dim));
        std::uint64_t without = 0;
        for (const netmesh_cell& cell : read_all(session.context, netmesh_get_cell))
            without += std::find(cell.vertices, cell.vertices + dim + 1, centre) == cell.vertices + dim + 1;
        CHECK(without == 0);
    }
}

TEST_CASE("duplicates are merged into the first and counted") {
    for (const int dim : dimensions()) {
        INFO("D = " << dim);
        const std::size_t n = dim < 4 ? 300 : 60;
        const inputs::Points points = inputs::repeated(dim, inputs::uniform(dim, n), 3);
        Session session(dim);
        REQUIRE(session.delaunay(points) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        const netmesh_report report = session.report();
        CHECK(report.input.points == 3 * n);
        CHECK(report.input.duplicates == 2 * n);
        CHECK(report.mesh.vertices == n);
        // The vertices are the first occurrences in input order.
        std::vector<std::vector<double>> firsts;
        for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim)) {
            std::vector<double> row(points.begin() + static_cast<std::ptrdiff_t>(i),
                                    points.begin() + static_cast<std::ptrdiff_t>(i) + dim);
            if (std::find(firsts.begin(), firsts.end(), row) == firsts.end()) firsts.push_back(row);
        }
        std::size_t different = 0;
        for (std::size_t v = 0; v < firsts.size(); ++v) {
            auto vertex = netmesh::sized<netmesh_vertex>();
            REQUIRE(netmesh_get_vertex(session.context, v, &vertex) == NETMESH_OK);
            different += !std::equal(firsts[v].begin(), firsts[v].end(), vertex.coordinates);
        }
        CHECK(different == 0);
    }
}

TEST_CASE("points at every scale from 1 down to 2^-1000") {
    for (const int dim : dimensions()) {
        const int step = by_dimension<int>(dim, {1, 2, 5, 8, 16});
        INFO("D = " << dim);
        const inputs::Points points = inputs::zoom(dim, 1000, step);
        Session session(dim);
        REQUIRE(session.delaunay(points) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        CHECK(session.report().mesh.vertices == points.size() / static_cast<std::size_t>(dim));
    }
}

TEST_CASE("flat inputs are refused") {
    for (const int dim : dimensions()) {
        Session session(dim);
        session.reserve(std::size_t{64} << 20);  // with room for the checks
        for (int flat = 0; flat < dim; ++flat) {
            INFO("D = " << dim << ", points of a flat of dimension " << flat);
            CHECK(session.delaunay(flat_points(dim, flat, 50)) == NETMESH_FLAT);
            // One point off the flat makes the next dimension of it; off a hyperplane, a triangulation.
            inputs::Points points = flat_points(dim, flat, 50);
            for (int a = 0; a < dim; ++a) points.push_back(a == 0 ? 12345.678 : -4321.25 * a);
            CHECK(session.delaunay(points) == (flat == dim - 1 ? NETMESH_OK : NETMESH_FLAT));
            if (flat == dim - 1) CHECK(session.check() == NETMESH_OK);
        }
        const inputs::Points simplex = inputs::uniform(dim, static_cast<std::size_t>(dim) + 1);
        for (std::size_t n = 1; n <= static_cast<std::size_t>(dim) + 1; ++n) {
            INFO("D = " << dim << ", " << n << " points");
            const inputs::Points first(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(n) * dim);
            CHECK(session.delaunay_in_block(first) == (n <= static_cast<std::size_t>(dim) ? NETMESH_FLAT : NETMESH_OK));
        }
        CHECK(session.report().mesh.cells == 1);
    }
}
