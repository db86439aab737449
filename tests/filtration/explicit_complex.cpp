// Filtrations of a triangulation that are stored: each simplex has the value of its definition, and enters in order.
#include "filtration/explicit_complex.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "complex/triangulations.hpp"

using namespace netmesh;
using namespace netmesh_test;

TEST_CASE_TEMPLATE_DEFINE("a simplex enters with the last of its vertices, an early vertex at zero", T, listed) {
    constexpr int D = T::value;
    const Cells<D> cells = freudenthal<D>(D == 2 ? 4 : D == 3 ? 2 : 1);
    std::set<std::vector<std::uint32_t>> simplices;
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
                Block block(std::size_t{1} << 22);
                Monitor monitor;
                ListedComplex complex;
                REQUIRE(lower_star_complex<D>(cells.view(), value.data(), zero_born, dimension, {block.arena, monitor},
                                              &complex) == Status::ok);
                const FilteredComplex filtered = complex.filtered();
                std::set<std::vector<std::uint32_t>> seen;
                for (std::uint32_t k = 0; k <= dimension; ++k)
                    for (std::uint32_t i = 0; i < filtered.of[k].count; ++i) {
                        std::vector<std::uint32_t> s(k + 1);
                        vertices_of(filtered, complex.rows[0], k, i, s.data());
                        double most = 0;
                        for (const std::uint32_t v : s) most = std::max(most, value[v]);
                        if (k == 0 && s[0] < zero_born) most = 0;
                        CHECK(filtered.of[k].value[i] == most);
                        if (i > 0) CHECK(filtered.of[k].value[i - 1] <= most);
                        std::sort(s.begin(), s.end());
                        CHECK(seen.insert(s).second);
                    }
                std::set<std::vector<std::uint32_t>> expected;
                for (const auto& s : simplices)
                    if (s.size() <= dimension + 1) expected.insert(s);
                CHECK(seen == expected);
            }
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(listed, Dimensions<>);
