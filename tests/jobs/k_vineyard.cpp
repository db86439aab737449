// A vineyard in k: the diagram at each k is the filter's own, and vines are numbered as they are said to be.
#include "jobs/k_vineyard.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "api/objects.hpp"
#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"
#include "homology/lower_star/lower_star.hpp"

using namespace netmesh;

namespace {

using Bar = std::tuple<std::uint32_t, double, double>;  // degree, birth, death

// The filter at one k, by the sweep over lower stars.
template <int D>
std::vector<Bar> bars_of(Meshed<D>& mesh, const FilterRequest& request, std::uint32_t degree, double* ratio) {
    std::vector<double> value(mesh.store.state.vertex_count);
    Evaluation evaluation = {value.data()};
    REQUIRE(evaluate(FilteredMesh<D>{mesh.store, mesh.result.domain, mesh.inputs()}, request,
                     {mesh.block.arena, mesh.monitor}, &evaluation) == Status::ok);
    *ratio = evaluation.certificate.ratio;
    Block block(std::size_t{1} << 22);
    CountedPairs found;
    REQUIRE(persist_lower_star<D>({mesh.store.view(), value.data(), evaluation.zero_born}, {degree},
                                  {block.arena, mesh.monitor}, &found) == Status::ok);
    std::vector<Bar> bars;
    for (std::uint64_t i = 0; i < found.pairs.count; ++i)
        bars.emplace_back(found.pairs.pairs[i].degree, found.pairs.pairs[i].birth, found.pairs.pairs[i].death);
    return bars;
}

// How many vines begin after the first k.
template <int D> int check_vines(const inputs::Points& points, std::uint32_t k_first, std::uint32_t k_last) {
    CAPTURE(D);
    CAPTURE(k_first);
    Meshed<D> mesh(points, by_quality(3, 1, true));
    REQUIRE(mesh.status == Status::ok);
    int later = 0;
    for (const auto& [filter, on_mesh] : {std::pair(NETMESH_FILTER_KNN, netmesh_filter_knn.on_mesh),
                                          std::pair(NETMESH_FILTER_KDISTANCE, netmesh_filter_kdistance.on_mesh)}) {
        const std::uint32_t degree = D - 1;
        VineList out;
        const std::size_t low = mesh.block.arena.low_mark();
        REQUIRE(k_vineyard(FilteredMesh<D>{mesh.store, mesh.result.domain, mesh.inputs()},
                           {filter, on_mesh, k_first, k_last, FilterValues::certified, degree},
                           {mesh.block.arena, mesh.monitor}, &out) == Status::ok);
        const std::vector<VinePoint> all(out.points, out.points + out.count);
        const std::vector<double> ratio(out.ratio, out.ratio + (k_last - k_first + 1));
        mesh.block.arena.release_low(low);
        std::vector<Bar> last;
        for (std::uint32_t k = k_first; k <= k_last; ++k) {
            double expected;
            const std::vector<Bar> bars =
                bars_of<D>(mesh, {filter, on_mesh, FilterValues::certified, k}, degree, &expected);
            CHECK(ratio[k - k_first] == expected);
            std::vector<Bar> seen;
            for (const VinePoint& p : all)
                if (p.k == k) seen.emplace_back(p.degree, p.birth, p.death);
            std::sort(seen.begin(), seen.end());
            CHECK(seen == bars);
            CHECK(seen != last);
            last = seen;
        }
        // By vine, then k; vines by degree and by where they begin; each of one degree, all numbers taken.
        std::vector<VinePoint> begin;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i > 0 && all[i].vine == all[i - 1].vine) {
                CHECK(all[i].k > all[i - 1].k);
                CHECK(all[i].degree == all[i - 1].degree);
                continue;
            }
            CHECK(all[i].vine == begin.size());
            begin.push_back(all[i]);
        }
        CHECK(begin.size() == out.vine_count);
        const auto key = [](const VinePoint& p) { return std::make_tuple(p.degree, p.k, p.birth, p.death); };
        for (std::size_t v = 1; v < begin.size(); ++v) {
            CHECK(key(begin[v - 1]) <= key(begin[v]));
            later += begin[v].k > k_first;
        }
    }
    return later;
}

}  // namespace

TEST_CASE("a vineyard in k: diagrams, ratios and the numbers of vines") {
    CHECK(check_vines<2>(inputs::uniform(2, 40), 1, 8) > 0);
    CHECK(check_vines<2>(inputs::clusters(2, 14), 2, 4) > 0);
    CHECK(check_vines<3>(inputs::uniform(3, 9), 1, 3) >= 0);
    for_each_dimension<4, 4>([](auto dim) { CHECK(check_vines<dim>(inputs::uniform(4, 6), 1, 2) >= 0); });
}
