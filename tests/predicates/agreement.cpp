// The predicates against GMP. By default some thousand inputs a dimension and kind; NETMESH_PREDICATE_CASES sets
// another number, and the full run is
//     NETMESH_PREDICATE_CASES=100000 test_predicates -tc="*agree*"
#include <doctest/doctest.h>

#include <cstdlib>

#include "common/dimensions.hpp"
#include "inputs.hpp"
#include "oracle.hpp"
#include "portable.hpp"
#include "predicates/predicates.hpp"

using namespace netmesh;
using inputs::Kind;

namespace {

int cases_wanted(Kind kind) {
    if (const char* s = std::getenv("NETMESH_PREDICATE_CASES")) return std::atoi(s);
    return inputs::is_slow(kind) ? 200 : 2000;
}

std::uint64_t total(const PredicateCounts& counts) {
    std::uint64_t sum = 0;
    for (std::uint64_t c : counts.calls) sum += c;
    return sum;
}

template <int D> void agree(Kind kind) {
    inputs::Source source(1000 * D + static_cast<std::uint64_t>(kind));
    PredicateCounts counts{};
    int wrong_orient = 0, wrong_in_ball = 0, wrong_portable = 0, wrong_small = 0;
    const int cases = cases_wanted(kind);
    for (int t = 0; t < cases; ++t) {
        const std::vector<inputs::Point> points = source.points(kind, D);
        const double* p[D + 2];
        for (int i = 0; i < D + 2; ++i) p[i] = points[static_cast<std::size_t>(i)].data();
        const int o = static_cast<int>(orient<D>(p, counts));
        const int b = static_cast<int>(in_ball<D>(p, p[D + 1], counts));
        wrong_orient += o != oracle::orient({points.begin(), points.end() - 1});
        wrong_in_ball += b != oracle::in_ball(points);
        wrong_portable += o != portable_orient(D, p) || b != portable_in_ball(D, p);
        wrong_small += o != small_orient(D, p) || b != small_in_ball(D, p);
    }
    CAPTURE(D);
    CAPTURE(inputs::name(kind));
    CHECK(wrong_orient == 0);
    CHECK(wrong_in_ball == 0);
    CHECK(wrong_portable == 0);
    CHECK(wrong_small == 0);
    CHECK(total(counts) == 2 * static_cast<std::uint64_t>(cases));
}

template <int D> void agree_all() {
    for (int k = 0; k < static_cast<int>(Kind::count); ++k) agree<D>(static_cast<Kind>(k));
}

}  // namespace

TEST_CASE("orient and in_ball agree with GMP in 2D") { agree_all<2>(); }
TEST_CASE("orient and in_ball agree with GMP in 3D") { agree_all<3>(); }
TEST_CASE("orient and in_ball agree with GMP in 4D") {
    for_each_dimension<4, 4>([](auto dim) { agree_all<dim>(); });
}
TEST_CASE("orient and in_ball agree with GMP in 5D") {
    for_each_dimension<5, 5>([](auto dim) { agree_all<dim>(); });
}
TEST_CASE("orient and in_ball agree with GMP in 6D") {
    for_each_dimension<6, 6>([](auto dim) { agree_all<dim>(); });
}
