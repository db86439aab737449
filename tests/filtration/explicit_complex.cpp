// Filtrations of a triangulation that are stored: each simplex has the value of its definition, and enters in order.
#include "filtration/explicit_complex.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "complex/triangulations.hpp"
#include "homology/disturbed.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "homology/parts.hpp"

using namespace netmesh;
using namespace netmesh_test;

namespace {

using Simplices = std::set<std::vector<std::uint32_t>>;

// Each simplex that is listed is one of these, and the other way round; values are as defined and ascend.
template <int D>
void check_listed(const LowerStarFiltration<D>& filtration, const Simplices& simplices, std::uint32_t dimension) {
    Block block(std::size_t{1} << 22);
    Monitor monitor;
    ListedComplex complex;
    const auto any = filtration.template of_dimension<any_dimension>(D);
    REQUIRE(lower_star_complex(any.get().complex, filtration.value, filtration.zero_born_count, dimension,
                               any.get().part, {block.arena, monitor}, &complex) == Status::ok);
    const FilteredComplex filtered = complex.filtered();
    Simplices seen;
    for (std::uint32_t k = 0; k <= dimension; ++k)
        for (std::uint32_t i = 0; i < filtered.of[k].count; ++i) {
            std::vector<std::uint32_t> s(k + 1);
            vertices_of(filtered, complex.rows[0], k, i, s.data());
            double most = filtration.value[s[0]];
            for (const std::uint32_t v : s) most = std::max(most, filtration.value[v]);
            if (k == 0 && s[0] < filtration.zero_born_count) most = 0;
            CHECK(filtered.of[k].value[i] == most);
            if (i > 0) CHECK(filtered.of[k].value[i - 1] <= most);
            std::sort(s.begin(), s.end());
            CHECK(seen.insert(s).second);
        }
    Simplices expected;
    for (const auto& s : simplices)
        if (s.size() <= dimension + 1) expected.insert(s);
    CHECK(seen == expected);
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("a simplex enters with the last of its vertices, an early vertex at zero", T, listed) {
    constexpr int D = T::value;
    const Cells<D> cells = freudenthal<D>(D == 2 ? 4 : D == 3 ? 2 : 1);
    Simplices simplices;
    for (const auto& cell : cells.list)
        for (std::uint32_t mask = 1; mask < 2u << D; ++mask) {
            std::vector<std::uint32_t> s;
            for (std::uint32_t i = 0; i <= D; ++i)
                if (mask >> i & 1) s.push_back(cell[i]);
            std::sort(s.begin(), s.end());
            simplices.insert(s);
        }
    Random random;
    for (const std::uint32_t levels : {3u, 1u << 20}) {
        for (const std::uint32_t zero_born : {0u, cells.vertex_count / 2}) {
            for (std::uint32_t dimension = 1; dimension <= D; ++dimension) {
                std::vector<double> value;
                for (std::uint32_t v = 0; v < cells.vertex_count; ++v) value.push_back(random.below(levels));
                check_listed<D>({cells.view(), value.data(), zero_born}, simplices, dimension);
            }
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(listed, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("of a part, what is in it is listed", T, listed_part) {
    constexpr int D = T::value;
    std::mt19937 random(81);
    std::size_t bare = 0, absent = 0;
    for (int round = 0; round < 4; ++round) {
        const auto ball = grid::irregular<D>(D == 2 ? 60 : D == 3 ? 30 : D == 4 ? 16 : 6, random);
        const auto all = oracle::all_faces(ball.cells());
        for (const std::size_t pairs : {std::size_t{0}, std::size_t{3}, all.size() / 8, all.size() / 3, all.size()}) {
            const parts::Part<D> part(ball, parts::collapse(all, pairs, round % 2 == 0, random), random);
            std::vector<double> value;
            for (std::uint32_t v = 0; v < ball.vertex_count; ++v) value.push_back(double(random() % 50));
            for (std::uint32_t dimension = 1; dimension <= D; ++dimension)
                check_listed<D>({ball.view(), value.data(), std::uint32_t(random() % 5), &part.view},
                                {part.simplices.begin(), part.simplices.end()}, dimension);
            bare += part.bare;
            absent += part.absent;
        }
    }
    CHECK(bare > 50);
    CHECK(absent > 10);
}
TEST_CASE_TEMPLATE_APPLY(listed_part, Dimensions<>);
TEST_CASE_TEMPLATE_DEFINE("what is in a part is listed whole or not at all", T, listed_in_any_block) {
    constexpr int D = T::value;
    std::mt19937 random(82);
    const auto ball = grid::irregular<D>(D == 2 ? 30 : D == 3 ? 20 : D == 4 ? 9 : 4, random);
    const auto all = oracle::all_faces(ball.cells());
    const parts::Part<D> part(ball, parts::collapse(all, all.size() / 8, false, random), random);
    const std::vector<double> value(ball.vertex_count, 1.0);
    disturbed::by_size(std::size_t{1} << 22, 4096, [&](const Work& work) {
        const ArenaScope scope(work.arena);
        ListedComplex complex;
        const AnyPart any = part.view.template of_dimension<any_dimension>(D);
        const Status status = lower_star_complex(ball.view().template of_dimension<any_dimension>(D), value.data(), 0,
                                                 D, &any, work, &complex);
        std::size_t count = 0;
        for (std::uint32_t k = 0; k <= D && status == Status::ok; ++k) count += complex.count[k];
        if (status == Status::ok) REQUIRE(count == part.simplices.size());
        return status;
    });
}
TEST_CASE_TEMPLATE_APPLY(listed_in_any_block, Dimensions<>);
