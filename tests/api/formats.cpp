// Points as floats, and rows apart: every job on points gives what it gives for the same numbers as packed doubles.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <string>

#include "common/calls.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

// The same points as `Number`s, `gap` bytes between rows that are none of a point's: 0xFF, not a number in any format.
// Ends with the last row.
template <class Number> class Rows {
public:
    Rows(const inputs::Points& points, int dim, std::size_t gap)
        : count_(points.size() / static_cast<std::size_t>(dim)), row_(static_cast<std::size_t>(dim) * sizeof(Number)),
          stride_(row_ + gap) {
        bytes_.assign((count_ * stride_ - gap) / sizeof(Number), Number());
        std::memset(bytes_.data(), 0xFF, bytes_.size() * sizeof(Number));
        for (std::size_t i = 0; i < count_; ++i)
            for (int k = 0; k < dim; ++k) {
                const Number x = static_cast<Number>(points[i * static_cast<std::size_t>(dim) + std::size_t(k)]);
                std::memcpy(reinterpret_cast<unsigned char*>(bytes_.data()) + i * stride_ + std::size_t(k) * sizeof x,
                            &x, sizeof x);
            }
    }
    netmesh::Request in(netmesh::Request request) const {
        const netmesh_point_format format = sizeof(Number) == 4 ? NETMESH_POINTS_FLOAT32 : NETMESH_POINTS_FLOAT64;
        request.points = {bytes_.data(), count_, request.points.dim, format, stride_ == row_ ? 0 : stride_};
        return request;
    }

private:
    std::size_t count_, row_, stride_;
    std::vector<Number> bytes_;
};

// What a job leaves: its report's fingerprint and input's, its peak and its bars.
struct Left {
    netmesh_status status;
    std::uint64_t result, input, points, peak;
    std::vector<double> bars;
    bool operator==(const Left& o) const {
        return status == o.status && result == o.result && input == o.input && points == o.points && peak == o.peak &&
               bars == o.bars;
    }
};

using Job = netmesh_status (*)(netmesh_context*, const netmesh_request*);

Left left_by(int dim, Job job, const netmesh::Request& request) {
    Session s(dim);
    s.reserve(std::size_t{1} << 24);
    Left left = {};
    left.status = job(s.context, &request);
    const netmesh_report report = s.report();
    left.result = report.fingerprint;
    left.input = report.input.fingerprint;
    left.points = report.input.points;
    left.peak = report.memory.peak_bytes;
    for (const netmesh_pair& pair : s.pairs()) left.bars.insert(left.bars.end(), {pair.birth, pair.death});
    return left;
}

// Request: without points.
void expect_same(const char* name, int dim, Job job, const inputs::Points& points, const netmesh::Request& request,
                 netmesh_status expected = NETMESH_OK) {
    INFO(name << ", D = " << dim);
    const Left left = left_by(dim, job, Rows<double>(points, dim, 0).in(request));
    CHECK(left.status == expected);
    CHECK(left_by(dim, job, Rows<double>(points, dim, 8).in(request)) == left);
    CHECK(left_by(dim, job, Rows<double>(points, dim, 40).in(request)) == left);
    CHECK(left_by(dim, job, Rows<float>(points, dim, 0).in(request)) == left);
    CHECK(left_by(dim, job, Rows<float>(points, dim, 4).in(request)) == left);
    CHECK(left_by(dim, job, Rows<float>(points, dim, 20).in(request)) == left);
}

// Numbers that floats hold, one of them below their normal range, one point twice.
inputs::Points of_floats(int dim, std::size_t n) {
    inputs::Points points = inputs::uniform(dim, n, 5);
    for (double& x : points) x = static_cast<double>(static_cast<float>(x));
    points[0] = static_cast<double>(std::numeric_limits<float>::denorm_min());
    points[1] = -0.0;
    points.insert(points.end(), points.begin(), points.begin() + dim);
    return points;
}

}  // namespace

TEST_CASE("points as floats and by stride give the bytes of packed doubles") {
    for (const int dim : dimensions()) {
        const inputs::Points points = of_floats(dim, by_dimension<std::size_t>(dim, {60, 40, 20, 10, 8}));
        const Calls calls(dim);
        const inputs::Points none;
        expect_same("delaunay", dim, netmesh_mesh, points, calls.delaunay_request(none));
        expect_same("alpha", dim, netmesh_persist, points, calls.alpha_request(none));
        expect_same("auto", dim, netmesh_persist, points, calls.auto_request(none));
        netmesh::Request mesh = calls.mesh_request(none, &netmesh_filter_complete);
        expect_same("mesh", dim, netmesh_mesh, points, mesh);
        mesh.mesh.method = nullptr;
        mesh.goal.ratio = 2.5;
        expect_same("mesh by ratio", dim, netmesh_mesh, points, mesh);
        expect_same("complete", dim, netmesh_persist, points, mesh);
        netmesh::Request scales = calls.scales_request(none);
        scales.goal.eps = 0;
        scales.goal.ratio = 3;
        expect_same("scales", dim, netmesh_persist, points, scales);
        expect_same("rips", dim, netmesh_persist, points, calls.points_request(none, &netmesh_filter_rips));
        expect_same("nested sets", dim, netmesh_persist, of_floats(dim, 7),
                    calls.nested_request(none, &netmesh_filter_barycentric_rips, 2));
        if (dim > 3) continue;
        netmesh::Request fit = calls.fit_request(none);
        fit.bounds = &netmesh_bounds;
        expect_same("fit", dim, netmesh_persist, of_floats(dim, 6), fit);
    }
}

TEST_CASE("a float that is not finite is reported by its row") {
    inputs::Points points = of_floats(2, 20);
    points[2 * 13 + 1] = std::numeric_limits<double>::infinity();
    for (const std::size_t gap : {0, 4}) {
        Session s(2);
        const Rows<float> rows(points, 2, gap);
        const netmesh::Request delaunay = rows.in(s.delaunay_request(points));
        CHECK(netmesh_mesh(s.context, &delaunay) == NETMESH_NOT_FINITE);
        CHECK(s.detail().index_a == 13);
        const netmesh::Request rips = rows.in(s.points_request(points, &netmesh_filter_rips));
        CHECK(netmesh_persist(s.context, &rips) == NETMESH_NOT_FINITE);
        CHECK(s.detail().index_a == 13);
    }
}
