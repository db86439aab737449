// Complexes too large for the textbook reduction, against PHAT where it is installed.
#if __has_include(<phat/representations/default_representations.h>)
#include <doctest/doctest.h>

#include <phat/algorithms/twist_reduction.h>
#include <phat/compute_persistence_pairs.h>
#include <phat/representations/default_representations.h>

#include <cmath>

#include "common/block.hpp"
#include "grid.hpp"
#include "served.hpp"

using namespace netmesh;

namespace {

std::vector<Pair> phat_diagram(const oracle::Filtered& f, std::uint32_t max_degree) {
    std::map<oracle::Simplex, phat::index> index;
    phat::boundary_matrix<phat::vector_vector> matrix;
    matrix.set_num_cols(phat::index(f.simplices.size()));
    for (std::size_t j = 0; j < f.simplices.size(); ++j) {
        const oracle::Simplex& s = f.simplices[j];
        index[s] = phat::index(j);
        std::vector<phat::index> column;
        for (std::size_t i = 0; i < s.size() && s.size() > 1; ++i) {
            oracle::Simplex face = s;
            face.erase(face.begin() + std::ptrdiff_t(i));
            column.push_back(index.at(face));
        }
        std::sort(column.begin(), column.end());
        matrix.set_dim(phat::index(j), phat::dimension(s.size() - 1));
        matrix.set_col(phat::index(j), column);
    }
    phat::persistence_pairs found;
    phat::compute_persistence_pairs<phat::twist_reduction>(found, matrix);
    std::vector<bool> paired(f.simplices.size());
    std::vector<Pair> pairs;
    for (phat::index n = 0; n < found.get_num_pairs(); ++n) {
        const auto [i, j] = found.get_pair(n);
        paired[std::size_t(i)] = paired[std::size_t(j)] = true;
        const Pair p = {f.values[std::size_t(i)], f.values[std::size_t(j)],
                        std::uint32_t(f.simplices[std::size_t(i)].size() - 1), 0};
        if (p.birth != p.death && p.degree <= max_degree) pairs.push_back(p);
    }
    for (std::size_t i = 0; i < paired.size(); ++i) {
        const auto degree = std::uint32_t(f.simplices[i].size() - 1);
        if (!paired[i] && degree <= max_degree) {
            pairs.push_back({f.values[i], std::numeric_limits<double>::infinity(), degree, 0});
        }
    }
    std::sort(pairs.begin(), pairs.end(), CanonicalOrder{});
    return pairs;
}

template <int D> void check(const std::array<std::uint32_t, D>& cubes, std::uint32_t seed) {
    if (!serves_dimension(D)) return;
    std::mt19937 random(seed);
    const auto ball = grid::freudenthal<D>(cubes, random);
    const auto simplices = oracle::all_faces(ball.cells());
    std::vector<double> value(ball.vertex_count);
    Block block(std::size_t{128} << 20);
    for (const std::uint32_t levels : {1000000000u, 7u}) {
        for (double& t : value) t = double(random() % levels);
        const std::uint32_t zero_born_count = levels == 7 ? ball.vertex_count / 4 : 0;
        const auto f = oracle::lower_star(simplices, value, zero_born_count);
        const auto expected = phat_diagram(f, D - 1);
        Monitor monitor;
        CountedPairs diagram;
        const std::size_t low = block.arena.low_mark();
        REQUIRE(served::persist_lower_star<D>({ball.view(), value.data(), zero_born_count}, {D - 1},
                                              {block.arena, monitor}, &diagram) == Status::ok);
        CHECK(diagram.pairs.count > 10);
        CHECK(oracle::same(expected, diagram.pairs));
        block.arena.release_low(low);
        const oracle::Explicit e(f);
        PairList out;
        REQUIRE(persist_homology(e.complex, {D - 1}, {block.arena, monitor}, &out) == Status::ok);
        CHECK(oracle::same(expected, out));
        block.arena.release_low(low);
    }
}

}  // namespace

TEST_CASE("noise on larger grids equals PHAT's diagram") {
    check<2>({40, 50}, 21);
    check<3>({9, 10, 11}, 22);
    check<4>({4, 3, 4, 3}, 23);
    check<5>({2, 2, 2, 2, 2}, 24);
    check<6>({2, 1, 2, 1, 1, 1}, 25);
}
#endif
