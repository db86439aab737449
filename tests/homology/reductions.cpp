// The three reductions of listed complexes against each other: without memory, stopped, and where dimensions are empty.
#include <doctest/doctest.h>

#include "complexes.hpp"
#include "disturbed.hpp"
#include "homology/cycles/cycles.hpp"

using namespace netmesh;

namespace {

using Cycles = std::vector<std::vector<std::uint32_t>>;

// With cycles: those of the first run, which later ones must have too.
struct Reductions {
    const FilteredComplex& complex;
    std::uint32_t degree;
    bool keep_zero;
    std::vector<Pair> expected;
    Cycles seen = {};

    Reductions(const FilteredComplex& listed, std::uint32_t most, bool keep, const std::vector<Pair>& pairs)
        : complex(listed), degree(most), keep_zero(keep), expected(pairs) {}

    Status filtration(const Work& work) const {
        PairList out;
        const Status status = persist_homology(complex, {degree, keep_zero}, work, &out);
        if (status == Status::ok) REQUIRE(oracle::same(expected, out));
        return status;
    }
    Status skeleton(const Work& work) const {
        PairList out;
        const Status status = persist_cohomology(complex, {degree, keep_zero}, work, &out);
        if (status == Status::ok) REQUIRE(oracle::same(expected, out));
        return status;
    }
    Status with_cycles(const Work& work) {
        Representatives found;
        const Status status = persist_with_cycles(complex, {degree, keep_zero}, work, &found);
        if (status != Status::ok) return status;
        const PairList& out = found.pairs;
        REQUIRE(oracle::same(expected, out));
        Cycles cycles;
        for (std::uint64_t i = 0; i < out.count; ++i) {
            const Cycle cycle = cycle_of(complex, found.store, work.arena, out.pairs[i]);
            cycles.emplace_back(cycle.simplices, cycle.simplices + cycle.count);
        }
        if (seen.empty()) seen = cycles;
        REQUIRE(cycles == seen);
        return status;
    }
};

void check_sizes(const oracle::Filtered& f, std::uint32_t degree, bool keep_zero) {
    const oracle::Explicit listed(f);
    Reductions r(listed.complex, degree, keep_zero, oracle::diagram(f, degree, keep_zero));
    const std::size_t enough = std::size_t{1} << 20, dense = 1500;
    disturbed::by_size(enough, dense, [&](const Work& work) { return r.filtration(work); });
    disturbed::by_size(enough, dense, [&](const Work& work) { return r.skeleton(work); });
    disturbed::by_size(enough, dense, [&](const Work& work) { return r.with_cycles(work); });
}

std::vector<Simplex> copies(const std::vector<Simplex>& maximal, std::uint32_t count, std::uint32_t vertices) {
    std::vector<Simplex> all;
    for (std::uint32_t i = 0; i < count; ++i)
        for (Simplex s : maximal) {
            for (std::uint32_t& v : s) v += i * vertices;
            all.push_back(s);
        }
    return all;
}

double by_size(const Simplex& s) { return double(s.size()); }

// All edges between n vertices, then as many triangles as wanted, each the next by its vertices. In order of value.
struct Dense {
    std::vector<std::uint32_t> edges, triangles;
    std::vector<double> vertex_value, edge_value, triangle_value;
    FilteredComplex complex = {};

    Dense(std::uint32_t n, std::size_t most, std::mt19937& random) : vertex_value(n) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < i; ++j) ends.push_back({j, i});
        std::shuffle(ends.begin(), ends.end(), random);
        std::vector<std::uint32_t> number(std::size_t{n} * n);
        for (std::uint32_t e = 0; e < ends.size(); ++e) {
            number[std::size_t{ends[e].first} * n + ends[e].second] = e;
            edges.insert(edges.end(), {ends[e].first, ends[e].second});
            edge_value.push_back(1 + e);
        }
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < i; ++j)
                for (std::uint32_t k = 0; k < j && triangle_value.size() < most; ++k) {
                    triangles.insert(triangles.end(), {number[std::size_t{j} * n + i], number[std::size_t{k} * n + i],
                                                       number[std::size_t{k} * n + j]});
                    triangle_value.push_back(double(1 + edges.size() + triangle_value.size()));
                }
        complex.dimension = 2;
        complex.of[0] = {n, nullptr, vertex_value.data()};
        complex.of[1] = {static_cast<std::uint32_t>(edge_value.size()), edges.data(), edge_value.data()};
        complex.of[2] = {static_cast<std::uint32_t>(triangle_value.size()), triangles.data(), triangle_value.data()};
    }
};

}  // namespace

TEST_CASE("reductions in blocks of all sizes") {
    std::mt19937 random(71);
    check_sizes(random_filtration(random, 14, 3, 60, 1000), 3, false);
    check_sizes(random_filtration(random, 11, 5, 12, 1000), 3, true);
    check_sizes(random_filtration(random, 12, 2, 60, 1000), 2, true);
    check_sizes(random_filtration(random, 18, 1, 60, 1000), 1, false);
    for (const bool keep_zero : {false, true}) {
        check_sizes(oracle::filter(oracle::all_faces(copies({{0}}, 40, 1)), by_size), 0, keep_zero);
        check_sizes(oracle::filter(oracle::all_faces(copies({{0, 1}}, 30, 2)), by_size), 0, keep_zero);
        check_sizes(oracle::filter(oracle::all_faces(copies(sphere(1), 30, 3)), by_size), 1, keep_zero);
        check_sizes(oracle::filter(oracle::all_faces(copies(sphere(2), 30, 4)), by_size), 2, keep_zero);
        check_sizes(oracle::filter(oracle::all_faces(copies(projective_plane, 12, 6)), by_size), 2, keep_zero);
    }
}

TEST_CASE("reductions stopped at any poll") {
    std::mt19937 random(72);
    // Polls are 100,000 steps apart: with many edges they come early, with many triangles in the columns.
    for (const std::size_t triangles : {std::size_t{300}, std::size_t{20000}}) {
        const Dense dense(triangles == 300 ? 480 : 120, triangles, random);
        std::vector<Pair> expected;
        const auto first = [&](const Work& work) {
            PairList out;
            const Status status = persist_homology(dense.complex, {2, false}, work, &out);
            if (status == Status::ok) expected.assign(out.pairs, out.pairs + out.count);
            return status;
        };
        const std::size_t enough = std::size_t{96} << 20;
        CHECK(disturbed::at_polls(enough, first) > 0);
        Reductions r(dense.complex, 2, false, expected);
        CHECK(disturbed::at_polls(enough, [&](const Work& work) { return r.skeleton(work); }) > 0);
        CHECK(disturbed::at_polls(enough, [&](const Work& work) { return r.with_cycles(work); }) > 0);
    }
}

TEST_CASE("dimensions without simplices, and more degrees than there are") {
    std::mt19937 random(73);
    Block block(std::size_t{1} << 20);
    for (std::uint32_t listed = 0; listed <= 3; ++listed) {
        const auto f = random_filtration(random, 8, listed, 9, 20);
        for (std::uint32_t empty = 0; empty <= 3; ++empty) {
            oracle::Explicit e(f);
            for (std::uint32_t k = 1; k <= empty; ++k) e.complex.of[listed + k] = {0, nullptr, nullptr};
            e.complex.dimension += empty;
            for (const std::uint32_t degree : {0u, 1u, 2u, 3u, 4u, 9u}) {
                Reductions r(e.complex, degree, true, oracle::diagram(f, degree, true));
                Monitor monitor;
                CHECK(r.filtration({block.arena, monitor}) == Status::ok);
                block.arena.release_low(0);
                CHECK(r.skeleton({block.arena, monitor}) == Status::ok);
                block.arena.release_low(0);
                const std::size_t high = block.arena.high_mark();
                CHECK(r.with_cycles({block.arena, monitor}) == Status::ok);
                block.arena.release_low(0);
                block.arena.release_high(high);
            }
        }
    }
    FilteredComplex none_such = {};
    none_such.dimension = FilteredComplex::dimension_max + 1;
    Reductions r(none_such, 1, true, {});
    Monitor monitor;
    CHECK(r.filtration({block.arena, monitor}) == Status::invalid_argument);
    CHECK(r.skeleton({block.arena, monitor}) == Status::invalid_argument);
    CHECK(r.with_cycles({block.arena, monitor}) == Status::invalid_argument);
}
