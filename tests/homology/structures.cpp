// The small structures that reductions are made of, against what their headers say of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "common/block.hpp"
#include "homology/bit_tree.hpp"
#include "homology/cycles/spanning_forest.hpp"
#include "homology/rank.hpp"
#include "homology/rips/pivot_table.hpp"

using namespace netmesh;

// Members far apart, so that words of all levels become empty and filled: 64^3 is 262,144.
TEST_CASE("a tree of bits is a set whose largest member is known, with one to four levels") {
    std::mt19937 random(81);
    for (const std::uint32_t size : {1u, 64u, 65u, 4096u, 4097u, 262144u, 262145u, 600000u}) {
        CAPTURE(size);
        std::vector<std::uint64_t> words(BitTree::words_needed(size), 0x5555555555555555u);
        BitTree tree;
        tree.adopt(words.data(), size);
        std::set<std::uint32_t> members;
        for (int step = 0; step < 4000; ++step) {
            // The largest one is taken out as often as another is put in; now and then all are.
            const bool out = !members.empty() && (random() % 2 == 0 || step % 1000 > 900);
            const std::uint32_t i = out ? *members.rbegin() : std::uint32_t(random() % size);
            tree.toggle(i);
            if (!members.insert(i).second) members.erase(i);
            CHECK(tree.has(i) == (members.count(i) == 1));
            CHECK(tree.empty() == members.empty());
            CHECK(tree.top() == (members.empty() ? none : *members.rbegin()));
            const auto at = members.lower_bound(i);
            const std::uint32_t below = at == members.begin() ? none : *std::prev(at);
            CHECK(tree.near_below(i) == (below != none && i / 64 - below / 64 <= 1 ? below : none));
        }
    }
}

TEST_CASE("vertices are ranked by value, then number, zeros of both signs being equal") {
    std::mt19937 random(82);
    const double levels[] = {0.0, -0.0, 1, -1, 4.9e-324, -4.9e-324, 1e300, -1e300, 0.5, -2};
    for (const std::uint32_t n : {1u, 2u, 7u, 500u, 5000u}) {
        std::vector<double> value(n);
        for (double& x : value) x = levels[random() % 10];
        std::vector<std::uint32_t> expected(n), order(n), rank(n);
        std::iota(expected.begin(), expected.end(), 0u);
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return value[a] < value[b]; });
        Block block(16 * std::size_t{n} + 64);
        REQUIRE(rank_vertices(value.data(), n, block.arena, order.data(), rank.data()));
        CHECK(order == expected);
        for (std::uint32_t i = 0; i < n; ++i) CHECK(rank[order[i]] == i);
        CHECK(block.arena.bytes_used() == 0);
    }
}

// Trees from deep to flat. In a tree the edges between two vertices are those that only one of them has on its way to
// the root.
TEST_CASE("ways in a forest have each of their edges once") {
    std::mt19937 random(83);
    for (const std::uint32_t back : {1u, 2u, 5u, 1000u}) {
        const std::uint32_t n = 120;
        std::vector<std::uint32_t> name(n), parent(n), to_parent(n, none), ends;
        std::iota(name.begin(), name.end(), 0u);
        std::shuffle(name.begin(), name.end(), random);
        for (std::uint32_t v = 0; v < n; ++v) parent[v] = v;
        for (std::uint32_t v = 1; v < n; ++v) {
            if (random() % 40 == 0) continue;  // another tree
            const std::uint32_t most = std::min(v, back), up = v - 1 - std::uint32_t(random() % most);
            parent[v] = up;
            to_parent[v] = std::uint32_t(ends.size() / 2);
            ends.insert(ends.end(), {name[v], name[up]});
            if (random() % 4 == 0) ends.insert(ends.end(), {name[v], name[up]});  // no edge of the forest
        }
        const std::uint32_t edges = std::uint32_t(ends.size() / 2);
        std::vector<char> is_tree(edges, 0);
        for (const std::uint32_t e : to_parent)
            if (e != none) is_tree[e] = 1;
        Block block(28 * std::size_t{n} + 256);
        SpanningForest forest;
        REQUIRE(forest.reserve(n, block.arena));
        forest.grow(ends.data(), edges, [&](std::uint32_t e) { return is_tree[e] != 0; });
        const auto way_up = [&](std::uint32_t v, std::uint32_t* root) {
            std::set<std::uint32_t> way;
            for (; parent[v] != v; v = parent[v]) way.insert(to_parent[v]);
            *root = v;
            return way;
        };
        for (std::uint32_t a = 0; a < n; ++a)
            for (std::uint32_t b = 0; b < n; ++b) {
                std::uint32_t root_a, root_b;
                const std::set<std::uint32_t> from_a = way_up(a, &root_a), from_b = way_up(b, &root_b);
                if (root_a != root_b) continue;
                std::vector<std::uint32_t> expected, seen;
                std::set_symmetric_difference(from_a.begin(), from_a.end(), from_b.begin(), from_b.end(),
                                              std::back_inserter(expected));
                forest.path(name[a], name[b], [&](std::uint32_t e) { seen.push_back(e); });
                std::sort(seen.begin(), seen.end());
                REQUIRE(seen == expected);
            }
    }
}

TEST_CASE("a table of pivots has room for as many as it was opened for, and tells who is none") {
    std::mt19937_64 random(84);
    for (std::uint32_t pivots = 1; pivots <= 300; ++pivots) {
        Block block(std::size_t{1} << 14);
        PivotTable table;
        REQUIRE(table.open(pivots, block.arena));
        std::vector<std::uint64_t> keys;
        for (std::uint32_t i = 0; i < pivots; ++i) {
            keys.push_back(random() >> (i % 40));
            if (table.has(keys.back())) {
                keys.pop_back();
                --i;
                continue;
            }
            table.insert(keys.back(), i);
        }
        for (std::uint32_t i = 0; i < pivots; ++i) CHECK(table.find(keys[i]) == i);
        for (int i = 0; i < 20; ++i) {
            const std::uint64_t other = random();
            if (std::find(keys.begin(), keys.end(), other) == keys.end()) CHECK(table.find(other) == none);
        }
    }
}
