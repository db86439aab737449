// Points in D = 2..6 through the exact predicates against determinants in GMP integers. Bytes become coordinates of few
// values, neighbours in the last place and many scales; points are often mirror images of one vector (cospherical),
// combinations of others (on a hyperplane), or another point moved by one unit in the last place.
#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "fuzz/decoder.hpp"
#include "predicates/predicates.hpp"
#include "tests/predicates/oracle.hpp"

namespace {

using fuzz::require;
using Points = std::vector<oracle::Point>;

Points decode_points(fuzz::Tape& tape, std::uint32_t dim) {
    Points points;
    for (std::uint32_t i = 0; i < dim + 2; ++i) {
        const std::uint8_t how = tape.byte();
        oracle::Point p(dim);
        if (i == 0 || how % 4 == 0) {
            for (double& x : p) x = fuzz::coordinate(tape.byte());
        } else if (how % 4 == 1) {  // a mirror image, rotated
            for (std::uint32_t c = 0; c < dim; ++c) {
                const double x = points[0][(c + (how >> 3)) % dim];
                p[c] = tape.byte() & 1 ? x : -x;
            }
        } else if (how % 4 == 2) {  // on a line through two points, as far as doubles go
            const oracle::Point &a = points[tape.byte() % i], &b = points[tape.byte() % i];
            for (std::uint32_t c = 0; c < dim; ++c) p[c] = a[c] + (how >> 3) * (b[c] - a[c]) / 8;
        } else {  // another point, or its mirror image
            p = points[tape.byte() % i];
            p[(how >> 3) % dim] *= -1;
        }
        if (how & 4) {
            double& x = p[tape.byte() % dim];
            x = std::nextafter(x, tape.byte() & 1 ? 1e308 : -1e308);
        }
        for (double& x : p)
            if (!std::isfinite(x)) x = std::numeric_limits<double>::max();
        points.push_back(p);
    }
    return points;
}

template <int D> void compare(const Points& points) {
    const double* p[D + 2];
    for (int i = 0; i < D + 2; ++i) p[i] = points[static_cast<std::size_t>(i)].data();
    netmesh::PredicateCounts counts = {};
    const int orient = static_cast<int>(netmesh::orient<D>(p, counts));
    require(orient == oracle::orient(Points(points.begin(), points.end() - 1)));
    require(static_cast<int>(netmesh::in_ball<D>(p, p[D + 1], counts)) == oracle::in_ball(points));

    // Two points of the cell change places: the sign of its volume turns.
    std::swap(p[0], p[D]);
    require(static_cast<int>(netmesh::orient<D>(p, counts)) == -orient);
    if (orient == 0) return;
    if (orient > 0) std::swap(p[0], p[D]);

    // In a positively oriented cell, ties broken: an answer, the exact one where there was no tie, in any even order.
    netmesh::VertexId ids[D + 2];
    for (std::uint32_t i = 0; i < D + 2; ++i) ids[i] = netmesh::VertexId(i);
    const int exact = static_cast<int>(netmesh::in_ball<D>(p, p[D + 1], counts));
    const int broken = static_cast<int>(netmesh::in_ball_perturbed<D>(p, ids, p[D + 1], ids[D + 1], counts));
    require(broken != 0 && (exact == 0 || broken == exact));
    std::swap(p[0], p[1]);
    std::swap(p[1], p[2]);
    std::swap(ids[0], ids[1]);
    std::swap(ids[1], ids[2]);
    require(static_cast<int>(netmesh::in_ball_perturbed<D>(p, ids, p[D + 1], ids[D + 1], counts)) == broken);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    const std::uint32_t dim = 2 + tape.below(5);
    const Points points = decode_points(tape, dim);
    for_each_dimension([&](auto served) {
        if (served == static_cast<int>(dim)) compare<served>(points);
    });
    return 0;
}
