// Triangulated balls whose faces come in any order, against the textbook reduction.
#include "homology/matrix/ball.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "grid.hpp"

using namespace netmesh;
using oracle::Simplex;

namespace {

// Vertices enter at 0, edges `apart` later or more, and all others with a facet or later: many ties, in chains too.
std::map<Simplex, double> tied_values(const std::vector<Simplex>& faces, std::mt19937& random, std::uint32_t steps,
                                      double apart = 1) {
    std::map<Simplex, double> value;
    for (std::size_t size = 1; size <= 7; ++size) {
        for (const Simplex& s : faces) {
            if (s.size() != size) continue;
            double& v = value[s];
            for (std::size_t i = 0; i < size && size > 1; ++i) {
                Simplex facet = s;
                facet.erase(facet.begin() + std::ptrdiff_t(i));
                v = std::max(v, value.at(facet));
            }
            if (size == 2) v += apart;
            if (size > 1 && random() % 2 == 0) v += random() % steps;
        }
    }
    return value;
}

// Values of which most are those of a cofacet, as in alpha filtrations: handed down from the cells.
std::map<Simplex, double> handed_down(const std::vector<Simplex>& faces, std::mt19937& random, std::uint32_t steps) {
    std::map<Simplex, double> value, from_above;
    for (std::size_t size = 7; size > 0; --size) {
        for (const Simplex& s : faces) {
            if (s.size() != size) continue;
            const auto above = from_above.find(s);
            const bool takes = above != from_above.end() && random() % 3 != 0;
            const double v = size == 1 ? 0 : takes ? above->second : 100 * double(size) + random() % steps;
            value[s] = v;
            for (std::size_t i = 0; i < size && size > 2; ++i) {
                Simplex facet = s;
                facet.erase(facet.begin() + std::ptrdiff_t(i));
                const auto known = from_above.insert({facet, v}).first;
                known->second = std::min(known->second, v);
            }
        }
    }
    return value;
}

struct Listed {
    FilteredBall ball = {};

    // Faces of dimensions 0..dimension at the low end of the arena, numbered at random.
    Listed(const oracle::Filtered& f, std::uint32_t dim, std::uint32_t dimension, bool stacked, std::mt19937& random,
           Arena& arena) {
        ball.dim = dim;
        ball.dimension = dimension;
        ball.stacked = stacked;
        std::map<Simplex, std::uint32_t> number[7];
        std::vector<std::size_t> at[7];
        for (std::size_t i = 0; i < f.simplices.size(); ++i) at[f.simplices[i].size() - 1].push_back(i);
        for (std::uint32_t k = 0; k <= dimension; ++k) {
            std::shuffle(at[k].begin(), at[k].end(), random);
            const std::size_t count = at[k].size();
            std::uint32_t* const faces = k == 0 ? nullptr : arena.take_low<std::uint32_t>(count * (k + 1));
            double* const value = arena.take_low<double>(count);
            if (value == nullptr || (k > 0 && faces == nullptr)) return;
            for (std::uint32_t i = 0; i < count; ++i) {
                const Simplex& s = f.simplices[at[k][i]];
                value[i] = f.values[at[k][i]];
                number[k][s] = i;
                for (std::size_t j = 0; j <= k && k > 0; ++j) {
                    Simplex facet = s;
                    facet.erase(facet.begin() + std::ptrdiff_t(j));
                    faces[i * (k + 1) + j] = number[k - 1].at(facet);
                }
            }
            ball.of[k] = {static_cast<std::uint32_t>(count), faces, value};
        }
        listed = true;
    }
    bool listed = false;
};

template <int D> void compare_all(const oracle::Filtered& f, std::mt19937& random) {
    for (std::uint32_t degree = 0; degree < D; ++degree) {
        for (const bool keep : {false, true}) {
            const auto expected = oracle::diagram(f, degree, keep);
            for (const bool stacked : {false, true}) {
                Block block(1 << 22);
                Monitor monitor;
                PairList out;
                const Listed list(f, D, degree + 1, stacked, random, block.arena);
                REQUIRE(list.listed);
                const std::size_t high = block.arena.high_mark();
                REQUIRE(persist_ball(list.ball, {degree, keep}, {block.arena, monitor}, &out) == Status::ok);
                CHECK(oracle::same(expected, out));
                CHECK(block.arena.high_mark() == high);
            }
            if (D != 2) continue;
            Block block(1 << 22);
            Monitor monitor;
            PairList out;
            const Listed list(f, D, degree + 1, false, random, block.arena);
            REQUIRE(persist_disk(list.ball, {degree, keep}, {block.arena, monitor}, &out) == Status::ok);
            CHECK(oracle::same(expected, out));
        }
    }
}

// Radii beyond the largest double.
std::map<Simplex, double> endless_from(std::map<Simplex, double> value, double most) {
    for (auto& entry : value)
        if (entry.second > most) entry.second = std::numeric_limits<double>::infinity();
    return value;
}

template <int D> oracle::Filtered filtered(const std::map<Simplex, double>& value) {
    std::vector<Simplex> simplices;
    for (const auto& entry : value) simplices.push_back(entry.first);
    return oracle::filter(simplices, [&](const Simplex& s) { return value.at(s); });
}

}  // namespace

TEST_CASE("balls with faces in any order and many ties equal the textbook reduction") {
    std::mt19937 random(5);
    for_each_dimension<2, 4>([&](auto dim) {
        constexpr int D = decltype(dim)::value;
        for (int round = 0; round < 12; ++round) {
            const auto faces = oracle::all_faces(grid::irregular<D>(D == 4 ? 6 : 14, random).cells());
            const std::uint32_t steps = 1 + random() % 9;
            compare_all<D>(filtered<D>(tied_values(faces, random, steps)), random);
            compare_all<D>(filtered<D>(handed_down(faces, random, steps)), random);
            // Too short for half of them to be a double, or as long as doubles go.
            const auto flat = tied_values(faces, random, steps, 0);
            compare_all<D>(filtered<D>(flat), random);
            compare_all<D>(filtered<D>(endless_from(flat, 1)), random);
            compare_all<D>(filtered<D>(endless_from(handed_down(faces, random, steps), 300)), random);
        }
    });
}

TEST_CASE("balls with faces in any order: every arena size gives the diagram or out_of_memory") {
    std::mt19937 random(6);
    const auto faces = oracle::all_faces(grid::irregular<3>(8, random).cells());
    const auto f = filtered<3>(tied_values(faces, random, 4));
    const auto expected = oracle::diagram(f, 2, true);
    bool fitted = false;
    for (std::size_t bytes = 0; bytes < 30000; bytes += 16) {
        Block block(bytes);
        Monitor monitor;
        std::mt19937 same(1);
        PairList out;
        const Listed list(f, 3, 3, false, same, block.arena);
        const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
        const Status status =
            list.listed ? persist_ball(list.ball, {2, true}, {block.arena, monitor}, &out) : Status::out_of_memory;
        if (status == Status::ok) {
            fitted = true;
            REQUIRE(oracle::same(expected, out));
        } else {
            REQUIRE(status == Status::out_of_memory);
            REQUIRE(!fitted);
            REQUIRE(block.arena.low_mark() == low);
            REQUIRE(block.arena.high_mark() == high);
        }
    }
    CHECK(fitted);
}
