// Sign conventions on inputs whose answers are plain to see, and which stage gives them.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "predicates/cascade.hpp"
#include "predicates/predicates.hpp"

using namespace netmesh;

namespace {

// The corner of the unit cube at the origin, times size: 0, e1, ..., eD.
template <int D> std::vector<std::vector<double>> corner(double size) {
    std::vector<std::vector<double>> p(D + 1, std::vector<double>(D));
    for (std::size_t i = 0; i < D; ++i) p[i + 1][i] = size;
    return p;
}

template <int D> std::vector<const double*> pointers(const std::vector<std::vector<double>>& p) {
    std::vector<const double*> result;
    for (const auto& x : p) result.push_back(x.data());
    return result;
}

template <int D> void check_corner(double size) {
    CAPTURE(D);
    CAPTURE(size);
    const auto p = corner<D>(size);
    auto cell = pointers<D>(p);
    PredicateCounts counts{};
    CHECK(orient<D>(cell.data(), counts) == Sign::positive);

    // The circumscribed ball is that of the cube.
    const std::vector<double> centre(D, size / 2), opposite(D, size), beyond(D, size * 1.0625);
    CHECK(in_ball<D>(cell.data(), centre.data(), counts) == Sign::positive);
    CHECK(in_ball<D>(cell.data(), opposite.data(), counts) == Sign::zero);
    CHECK(in_ball<D>(cell.data(), beyond.data(), counts) == Sign::negative);
    for (const double* vertex : cell) CHECK(in_ball<D>(cell.data(), vertex, counts) == Sign::zero);

    std::vector<double> near = opposite;
    near[0] = std::nextafter(size, 0.0);
    CHECK(in_ball<D>(cell.data(), near.data(), counts) == Sign::positive);
    near[0] = std::nextafter(size, INFINITY);
    CHECK(in_ball<D>(cell.data(), near.data(), counts) == Sign::negative);

    std::swap(cell[0], cell[1]);
    CHECK(orient<D>(cell.data(), counts) == Sign::negative);
    CHECK(in_ball<D>(cell.data(), centre.data(), counts) == Sign::negative);

    // A cell without volume.
    cell[0] = cell[1];
    CHECK(orient<D>(cell.data(), counts) == Sign::zero);
}

template <int D> void check_corners() {
    for (const double size : {1.0, 0.1, 3e-5, 0x1p-1070, 0x1p-600, 1e200, 0x1p1023}) check_corner<D>(size);
}

// v, v with one coordinate negated, and -v: cospherical.
template <int D> std::vector<std::vector<double>> flips(const std::vector<double>& v) {
    std::vector<std::vector<double>> p(D + 2, v);
    for (std::size_t i = 0; i < D; ++i) {
        p[i + 1][i] = -v[i];
        p[D + 1][i] = -v[i];
    }
    return p;
}

template <int D> void check_stages() {
    CAPTURE(D);
    PredicateCounts counts{};
    // At -Os there are fewer stages.
    const auto have_decided = [&](int stage, std::uint64_t times) {
        return takes_few_stages || counts.calls[stage] == times;
    };
    const auto unit_corner = corner<D>(1);
    const std::vector<double> centre(D, 0.5), opposite(D, 1.0);
    in_ball<D>(pointers<D>(unit_corner).data(), centre.data(), counts);
    CHECK(have_decided(1, 1));
    in_ball<D>(pointers<D>(unit_corner).data(), opposite.data(), counts);  // a grid: doubles are exact
    CHECK(have_decided(1, 2));

    std::vector<double> v(D);
    for (std::size_t i = 0; i < D; ++i) v[i] = 1 + static_cast<double>(2 * i + 1) * 0x1p-52;
    auto p = flips<D>(v);
    CHECK(in_ball<D>(pointers<D>(p).data(), p[D + 1].data(), counts) == Sign::zero);
    CHECK(have_decided(2, 1));

    v[0] *= 0x1p-200;
    p = flips<D>(v);
    CHECK(in_ball<D>(pointers<D>(p).data(), p[D + 1].data(), counts) == Sign::zero);
    CHECK(have_decided(3, 1));

    std::vector<VertexId> ids(D + 1);
    for (std::size_t i = 0; i <= D; ++i) ids[i] = VertexId(static_cast<std::uint32_t>(i));
    CHECK(in_ball_perturbed<D>(pointers<D>(unit_corner).data(), ids.data(), opposite.data(), VertexId(99), counts) ==
          Sign::negative);
    CHECK(counts.calls[4] == 1);
    CHECK(counts.calls[0] + counts.calls[1] + counts.calls[2] + counts.calls[3] == 4);
}

}  // namespace

TEST_CASE("orient and in_ball of a cube's corner") {
    for_each_dimension([](auto dim) { check_corners<dim>(); });
}

TEST_CASE("orient on a line compares") {
    const double a[] = {-0x1p-1074, 0.0, -0.0, 1e308};
    PredicateCounts counts{};
    const auto sign = [&](int i, int j) {
        const double* p[2] = {a + i, a + j};
        return orient<1>(p, counts);
    };
    CHECK(sign(0, 1) == Sign::positive);
    CHECK(sign(1, 2) == Sign::zero);
    CHECK(sign(3, 0) == Sign::negative);
    CHECK(counts.calls[1] == 3);
}

TEST_CASE("each stage decides what it is for") {
    for_each_dimension([](auto dim) { check_stages<dim>(); });
}

TEST_CASE("a coordinate far below the others' quantum is seen") {
    const double low[2] = {0, 0x1p-1074}, origin[2] = {0, 0}, far[2] = {0x1.2p452, 0x1.8p453};
    const double* const p[3] = {low, origin, far};
    PredicateCounts counts = {};
    CHECK(orient<2>(p, counts) == Sign::positive);
}
