// Builds with NETMESH_VALIDATE: reductions are checked after every column, and a fault stops the program.
#ifdef NETMESH_VALIDATE
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "common/block.hpp"
#include "common/last_words.hpp"
#include "complexes.hpp"
#include "grid.hpp"
#include "homology/lower_star/front.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "homology/matrix/listed_columns.hpp"
#include "homology/matrix/reduction.hpp"
#include "homology/pair_writer.hpp"
#include "homology/rips/pivot_table.hpp"
#include "homology/vineyard/vineyard.hpp"

using namespace netmesh;

namespace {

bool has(const std::string& words, const char* text) { return words.find(text) != std::string::npos; }
oracle::Filtered by_dimension_of(const std::vector<Simplex>& maximal) {
    return oracle::filter(oracle::all_faces(maximal), [](const Simplex& s) { return double(s.size()); });
}

// Reduces the triangles of a torus. What plant(owner, j) does to the owners of pivots after column j is the fault.
template <class Matrix, class Kept, class Plant>
std::string words_of_reduction(const Matrix& matrix, std::uint32_t columns, std::uint32_t rows, Plant&& plant) {
    return last_words([&] {
        Block block(1 << 20);
        Monitor monitor;
        Progress progress = {monitor};
        std::vector<std::uint32_t> owner(rows);
        std::vector<std::uint64_t> words(BitTree::words_needed(rows)), more(BitTree::words_needed(columns));
        ColumnStore store;
        store.open(block.arena);
        Kept kept = {&store};
        if constexpr (std::is_same_v<Kept, KeptSources>) kept.sources.adopt(more.data(), columns);
        using Columns = ListedColumns<Matrix, Kept>;
        Columns work(matrix, kept, rows, owner.data(), words.data(), progress);
        struct Recorder {
            Columns& columns;
            std::vector<std::uint32_t>& owner;
            Plant& plant;
            std::uint32_t count, at;
            bool next(std::uint32_t* j) { return (*j = at++) < count; }
            Status pair(std::uint32_t j) {
                const std::uint32_t pivot = columns.pivot();
                if (!columns.own_pivot(j)) return Status::out_of_memory;
                plant(owner, pivot, j);
                return Status::ok;
            }
            Status zero(std::uint32_t) {
                columns.forget();
                return Status::ok;
            }
        } recorder = {work, owner, plant, columns, 0};
        if (reduce_columns(work, recorder) != Status::ok) std::abort();
    });
}

template <class Matrix, class Kept> void check_listed(const Matrix& matrix, std::uint32_t columns, std::uint32_t rows) {
    const auto words_with = [&](auto plant) { return words_of_reduction<Matrix, Kept>(matrix, columns, rows, plant); };
    using Owners = std::vector<std::uint32_t>;
    CHECK(words_with([](Owners&, std::uint32_t, std::uint32_t) {}) == "lived");
    const auto free_row = [](const Owners& owner) {
        std::uint32_t row = 0;
        while (owner[row] != none) ++row;
        return row;
    };
    std::string words = words_with([&](Owners& owner, std::uint32_t pivot, std::uint32_t j) {
        if (j == columns / 2) owner[free_row(owner)] = owner[pivot];
    });
    CHECK(has(words, "a column owns "));
    CHECK(has(words, "matrix/reduction.hpp:"));
    words = words_with([&](Owners& owner, std::uint32_t pivot, std::uint32_t j) {
        if (j < columns / 2) return;
        owner[free_row(owner)] = owner[pivot];
        owner[pivot] = none;
    });
    CHECK(has(words, "a column owns a pivot that is not its own"));
    CHECK(has(words, "matrix/reduction.hpp:"));
}

}  // namespace

TEST_CASE("pivots of listed columns that are not theirs") {
    const oracle::Explicit torus(by_dimension_of(glued_square(5, false)));
    const FilteredComplex& c = torus.complex;
    check_listed<BoundaryMatrix, KeptSums>({c.of[2], 2, nullptr}, c.of[2].count, c.of[1].count);
    // The boundaries again as a matrix that is listed column by column, pivots first.
    std::vector<std::uint32_t> start, row;
    for (std::uint32_t j = 0; j < c.of[2].count; ++j) {
        start.push_back(static_cast<std::uint32_t>(row.size()));
        row.insert(row.end(), c.of[2].faces + 3 * j, c.of[2].faces + 3 * j + 3);
        std::sort(row.end() - 3, row.end(), std::greater<std::uint32_t>());
    }
    start.push_back(static_cast<std::uint32_t>(row.size()));
    check_listed<CoboundaryMatrix, KeptSources>({start.data(), row.data()}, c.of[2].count, c.of[1].count);
}

// One triangle of a square, of which a vertex of the other one is said to be whole, or its own one to be absent.
TEST_CASE("parts whose vertices contradict their cells") {
    const auto square = grid::link<2>({{0, 1, 2}, {1, 2, 3}}, 4);
    const auto words_with = [&](std::vector<std::uint8_t> vertex) {
        return last_words([&] {
            Block block(1 << 16);
            Monitor monitor;
            const std::uint8_t cell[] = {1, 0};
            const double value[] = {0, 1, 2, 3};
            const Subcomplex<2> part = {cell, {}, vertex.data()};
            CountedPairs out;
            const auto status =
                persist_lower_star<2>({square.view(), value, 0, &part}, {1}, {block.arena, monitor}, &out);
            if (status != Status::ok || out.simplices != 7) std::abort();
        });
    };
    constexpr std::uint8_t absent = VertexPart::absent, cut = VertexPart::cut, whole = VertexPart::whole;
    CHECK(words_with({whole, cut, cut, absent}) == "lived");
    CHECK(has(words_with({whole, cut, whole, absent}), "not all cells of a whole vertex"));
    CHECK(has(words_with({absent, cut, cut, absent}), "a part has a cell without one of its vertices"));
    CHECK(has(words_with({whole, cut, cut, 3}), "neither absent, cut nor whole"));
}

TEST_CASE("pivots and killers against the textbook") {
    const oracle::Explicit sphere_2(by_dimension_of(sphere(2)));
    const FilteredComplex& c = sphere_2.complex;
    std::uint64_t words[2][2];
    BitSet pivots, killers;
    pivots.adopt(words[0], c.of[1].count);
    killers.adopt(words[1], c.of[2].count);
    const TextbookPairs expected(c.of[2], 2, c.of[1].count);
    REQUIRE(expected.fits);
    for (std::uint32_t f = 0; f < c.of[1].count; ++f)
        if (expected.is_pivot[f]) pivots.insert(f);
    for (std::uint32_t j = 0; j + 1 < c.of[2].count; ++j) killers.insert(j);  // all but the last, which closes it
    CHECK(pivots_violation(c.of[2], 2, c.of[1].count, pivots) == nullptr);
    CHECK(killers_violation(c.of[2], 2, c.of[1].count, killers) == nullptr);
    for (std::uint32_t f = 0; f < c.of[1].count; ++f) {
        BitSet& set = pivots;
        set.has(f) ? set.erase(f) : set.insert(f);
        CHECK(pivots_violation(c.of[2], 2, c.of[1].count, pivots) != nullptr);
        set.has(f) ? set.erase(f) : set.insert(f);
    }
    killers.insert(c.of[2].count - 1);
    CHECK(killers_violation(c.of[2], 2, c.of[1].count, killers) != nullptr);
}

TEST_CASE("a pair that dies before it is born") {
    const std::string words = last_words([] {
        Block block(1024);
        PairWriter writer(block.arena, {1});
        writer.add(1, 2, 0);
        writer.add(2, 1, 0);
    });
    CHECK(has(words, "pair_writer.hpp:"));
    CHECK(has(words, "birth <= death"));
}

TEST_CASE("pivots of implicit columns that are not distinct") {
    Block block(1 << 12);
    PivotTable pivots;
    REQUIRE(pivots.open(8, block.arena));
    for (std::uint32_t j = 0; j < 7; ++j) pivots.insert(1000 + 77 * std::uint64_t{j}, j);
    CHECK(pivots.violation() == nullptr);
    pivots.insert(5, 3);
    CHECK(std::string(pivots.violation()) == "a column owns two pivots");
}

// The complex is the caller's: when it changes behind the vineyard's back R is not D V any more.
TEST_CASE("a vineyard whose matrices do not agree") {
    const oracle::Explicit disc(by_dimension_of({{0, 1, 2}, {0, 2, 3}}));
    ComplexView view = {2, {}, {}};
    std::vector<std::vector<std::uint32_t>> facets(disc.faces);
    std::vector<double> from[3], to[3];
    const double *before[3], *after[3];
    for (std::uint32_t k = 0; k <= 2; ++k) {
        view.count[k] = disc.complex.of[k].count;
        view.facets[k] = facets[k].data();
        for (std::uint32_t s = 0; s < view.count[k]; ++s) {
            from[k].push_back(10 * k + s);
            to[k].push_back(10 * k + view.count[k] - s);
        }
        before[k] = from[k].data();
        after[k] = to[k].data();
    }
    for (const bool forged : {false, true}) {
        const std::string words = last_words([&] {
            Block block(1 << 16);
            Monitor monitor;
            Vineyard vineyard;
            if (vineyard.open(view, 1, before, {block.arena, monitor}) != Status::ok) std::abort();
            if (forged) facets[2][0] = facets[2][3] == facets[2][0] ? facets[2][4] : facets[2][3];
            if (vineyard.advance(before, after, monitor) != Status::ok) std::abort();
        });
        CHECK(forged != (words == "lived"));
        if (!forged) continue;
        CHECK(has(words, "R is not D V"));
        CHECK(has(words, "vineyard/vineyard.cpp:"));
    }
}

TEST_CASE("columns of the sweep that wait in a wrong place") {
    Block block(1 << 14);
    Front front;
    REQUIRE(front.reserve(16, block.arena));
    const std::uint32_t c = front.new_column(1, 12, 2);
    const auto violation = [&front](std::uint32_t r) {
        const char* const found = front.violation(16, r);
        return std::string(found == nullptr ? "" : found);
    };
    CHECK(violation(10) == "a column waits nowhere");
    const std::uint32_t entries[2][2] = {{7, 3}, {6, 5}};
    Run run = no_run;
    for (const auto& entry : entries) REQUIRE(front.append(&run, entry, 2));
    REQUIRE(front.add_run(c, run));
    front.wait(c);
    CHECK(violation(10) == "");
    CHECK(violation(7) == "a column waits where nobody comes");
    CHECK(violation(13) == "a column has no creator");
    SUBCASE("a star that is not visited") {
        front.waiting().toggle(7);
        CHECK(violation(10) == "a column waits where nobody comes");
    }
    SUBCASE("a run that is not sorted") {
        const std::uint32_t later[2] = {7, 4};
        Run more = no_run;
        REQUIRE(front.append(&more, later, 2));
        REQUIRE(front.append(&more, later, 2));
        const std::uint32_t d = front.new_column(2, 12, 2);
        REQUIRE(front.add_run(d, more));
        front.wait(d);
        CHECK(violation(10) == "a run is not sorted");
    }
    SUBCASE("a simplex with a vertex twice") {
        const std::uint32_t flat[2] = {7, 7};
        Run more = no_run;
        REQUIRE(front.append(&more, flat, 2));
        const std::uint32_t d = front.new_column(2, 12, 2);
        REQUIRE(front.add_run(d, more));
        front.wait(d);
        CHECK(violation(10) == "the ranks of a simplex do not descend");
    }
}
#endif
