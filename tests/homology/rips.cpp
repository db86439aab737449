// Rips complexes of which only edges are stored, against the textbook reduction of all their simplices.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "disturbed.hpp"
#include "homology/rips/edge_sum.hpp"
#include "homology/rips/rips.hpp"
#include "oracle.hpp"

using namespace netmesh;

namespace {

struct Graph {
    std::uint32_t vertices;
    std::vector<double> value;
    std::vector<std::uint32_t> ends;
};

// Each pair of vertices is an edge with this probability in percent; few values make many ties, zero among them.
Graph random_graph(std::mt19937& random, std::uint32_t n, std::uint32_t percent, std::uint32_t values) {
    Graph g = {n, {}, {}};
    for (std::uint32_t i = 1; i < n; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            if (random() % 100 >= percent) continue;
            g.value.push_back(double(random() % values));
            g.ends.push_back(RipsGraph::edge(i, j));
        }
    }
    return g;
}

// All cliques of up to `most` vertices, in the order of a filtration.
oracle::Filtered flag_complex(const Graph& g, std::uint32_t most) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<std::vector<double>> joined(g.vertices, std::vector<double>(g.vertices, infinity));
    for (std::size_t e = 0; e < g.ends.size(); ++e) {
        const std::uint32_t i = g.ends[e] >> 16, j = g.ends[e] & 0xFFFF;
        joined[i][j] = joined[j][i] = g.value[e];
    }
    std::vector<oracle::Simplex> all;
    for (std::uint32_t v = 0; v < g.vertices; ++v) all.push_back({v});
    for (std::size_t at = 0; at < all.size(); ++at) {
        if (all[at].size() == most) continue;
        for (std::uint32_t w = all[at].back() + 1; w < g.vertices; ++w) {
            const oracle::Simplex s = all[at];
            if (!std::all_of(s.begin(), s.end(), [&](std::uint32_t v) { return joined[v][w] < infinity; })) continue;
            all.push_back(s);
            all.back().push_back(w);
        }
    }
    return oracle::filter(all, [&](const oracle::Simplex& s) {
        double latest = 0;
        for (const std::uint32_t v : s) {
            for (const std::uint32_t w : s) latest = v < w ? std::max(latest, joined[v][w]) : latest;
        }
        return latest;
    });
}

enum class Form { table, lists };

// The graph last at the arena's low end. False: out of memory.
bool place(const Graph& g, Form form, Arena& arena, RipsGraph* out) {
    std::uint32_t* begin = nullptr;
    if (form == Form::lists) {
        begin = arena.take_low<std::uint32_t>(g.vertices + 1);
        if (begin == nullptr) return false;
        for (std::uint32_t v = 0, e = 0; v <= g.vertices; ++v) {
            while (e < g.ends.size() && g.ends[e] >> 16 < v) ++e;
            begin[v] = e;
        }
    }
    double* const value = arena.take_low<double>(g.value.size());
    std::uint32_t* const ends = arena.take_low<std::uint32_t>(g.ends.size());
    if (value == nullptr || ends == nullptr) return false;
    std::copy(g.value.begin(), g.value.end(), value);
    std::copy(g.ends.begin(), g.ends.end(), ends);
    if (form == Form::lists) std::for_each(ends, ends + g.ends.size(), [](std::uint32_t& end) { end &= 0xFFFF; });
    *out = {g.vertices, static_cast<std::uint32_t>(g.value.size()), value, ends, begin};
    return true;
}

Status run(const Graph& g, Form form, DiagramRequest request, const Work& work, CountedPairs* out) {
    const std::size_t low = work.arena.low_mark();
    RipsGraph graph;
    Status status = Status::out_of_memory;
    if (place(g, form, work.arena, &graph)) {
        REQUIRE(rips_has_numbers(graph, request.max_degree));
        status = persist_rips(graph, request, work, out);
    }
    if (status != Status::ok) work.arena.release_low(low);
    return status;
}

void check(const Graph& g, std::uint32_t degree_most) {
    Block block(std::size_t{8} << 20);
    for (std::uint32_t degree = 0; degree <= degree_most; ++degree) {
        const auto f = flag_complex(g, degree + 2);
        const auto counted = std::count_if(f.simplices.begin(), f.simplices.end(), [&](const oracle::Simplex& s) {
            return s.size() <= std::max<std::uint32_t>(degree, 1) + 1;
        });
        auto expected = oracle::diagram(f, degree, true);
        for (const int at : {0, 1, 2, 3}) {
            const bool keep = at < 2;
            const Form form = at % 2 == 0 ? Form::table : Form::lists;
            CAPTURE(degree);
            CAPTURE(at);
            const auto zero = [keep](const Pair& p) { return !keep && p.birth == p.death; };
            expected.erase(std::remove_if(expected.begin(), expected.end(), zero), expected.end());
            const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
            Monitor monitor;
            CountedPairs out = {};
            REQUIRE(run(g, form, {degree, keep}, {block.arena, monitor}, &out) == Status::ok);
            REQUIRE(oracle::same(expected, out.pairs));
            CHECK(out.simplices == static_cast<std::uint64_t>(counted));
            CHECK(block.arena.high_mark() == high);
            block.arena.release_low(low);
        }
    }
}

}  // namespace

TEST_CASE("small graphs") {
    check({1, {}, {}}, 3);
    check({2, {}, {}}, 2);
    check({2, {0}, {RipsGraph::edge(1, 0)}}, 2);
    check({3, {1, 2, 3}, {RipsGraph::edge(1, 0), RipsGraph::edge(2, 0), RipsGraph::edge(2, 1)}}, 3);
}

TEST_CASE("random graphs, whole and with holes") {
    std::mt19937 random(41);
    for (int round = 0; round < 40; ++round) {
        CAPTURE(round);
        const std::uint32_t values[] = {1, 3, 12, 1u << 30};
        for (const std::uint32_t percent : {30u, 60u, 85u, 100u})
            check(random_graph(random, 5 + random() % 7, percent, values[round % 4]), 4);
    }
}

// More than a block of vertices, whose rows are read in pieces.
TEST_CASE("many vertices") {
    std::mt19937 random(42);
    check(random_graph(random, 90, 100, 1u << 30), 1);
    check(random_graph(random, 140, 12, 40), 2);
}

TEST_CASE("a sum of cofaces kept as edges has the triangles with an odd number of them") {
    std::mt19937 random(47);
    for (const std::uint32_t i : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u}) {
        const std::uint32_t n = std::vector<std::uint32_t>{3, 64, 65, 130}[i / 2];
        const Form form = i % 2 == 0 ? Form::table : Form::lists;
        CAPTURE(i);
        const Graph g = random_graph(random, n, n == 3 ? 100 : 60, 50);
        Block block(std::size_t{8} << 20);
        RipsGraph graph;
        REQUIRE(place(g, form, block.arena, &graph));
        RipsSimplices simplices;
        REQUIRE(simplices.open(graph, 1, block.arena));
        CHECK(simplices.has_lists() == (form == Form::lists));
        EdgeSum sum(simplices);
        REQUIRE(sum.open(block.arena));
        std::vector<std::vector<std::uint32_t>> rank(n, std::vector<std::uint32_t>(n, none));
        for (std::uint32_t e = 0; e < graph.edge_count; ++e) {
            const std::uint32_t a = simplices.larger_end(e), b = simplices.smaller_end(e);
            rank[a][b] = rank[b][a] = e;
        }
        std::vector<bool> in_set(graph.edge_count);
        for (const std::uint32_t toggles : {1u, 2u, 10u, 100u, 3000u}) {
            CAPTURE(toggles);
            for (std::uint32_t i = 0; i < toggles; ++i) {
                const std::uint32_t e = random() % graph.edge_count;
                sum.toggle(e);
                in_set[e] = !in_set[e];
            }
            std::vector<std::uint64_t> triangles;  // of the sum
            for (std::uint32_t e = 0; e < graph.edge_count; ++e) {
                const std::uint32_t a = simplices.larger_end(e), b = simplices.smaller_end(e);
                for (std::uint32_t w = 0; w < n; ++w) {
                    if (rank[a][w] >= e || rank[b][w] >= e) continue;
                    if (in_set[e] != (in_set[rank[a][w]] != in_set[rank[b][w]]))
                        triangles.push_back(simplices.key_of(e, &w, 1));
                }
            }
            REQUIRE(std::is_sorted(triangles.begin(), triangles.end()));
            for (std::uint32_t begin = 0; begin < graph.edge_count; begin += 1 + begin / 3) {
                const std::uint32_t end = begin + random() % (graph.edge_count - begin + 1);
                const auto due = std::find_if(triangles.begin(), triangles.end(),
                                              [&](std::uint64_t key) { return simplices.edge_of(key) >= begin; });
                const bool found = due != triangles.end() && simplices.edge_of(*due) < end;
                REQUIRE(sum.first(begin, end) == (found ? *due : no_key));
            }
            std::vector<bool> listed(graph.edge_count);
            for (std::uint32_t v = 0; v < n; ++v)
                REQUIRE(sum.each_edge(v, [&](std::uint32_t e) {
                    const bool is_new = !listed[e];
                    listed[e] = true;
                    return is_new;
                }));
            REQUIRE(listed == in_set);
        }
    }
}

TEST_CASE("edges are put in order of value, equal ones by their ends, and each value is kept once") {
    std::mt19937 random(48);
    for (const std::uint32_t i : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u, 11u}) {
        const std::uint32_t values = std::vector<std::uint32_t>{1, 7, 1u << 30}[i / 4], others = i / 2 % 2;
        const Form form = i % 2 == 0 ? Form::table : Form::lists;
        CAPTURE(i);
        const Graph g = random_graph(random, 40, 80, values);
        std::vector<std::pair<double, std::uint32_t>> expected;
        for (std::size_t e = 0; e < g.ends.size(); ++e) expected.push_back({g.value[e], g.ends[e]});
        std::sort(expected.begin(), expected.end());
        std::vector<double> distinct = g.value;
        std::sort(distinct.begin(), distinct.end());
        distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
        Block block(std::size_t{1} << 20);
        RipsGraph graph;
        REQUIRE(place(g, form, block.arena, &graph));
        RipsSimplices simplices;
        REQUIRE(simplices.open(graph, others, block.arena));
        REQUIRE(simplices.edges() == expected.size());
        for (std::uint32_t e = 0; e < simplices.edges(); ++e) {
            REQUIRE(simplices.value(e) == expected[e].first);
            REQUIRE(RipsGraph::edge(simplices.larger_end(e), simplices.smaller_end(e)) == expected[e].second);
        }
        if (form == Form::table && others == 0)
            CHECK(block.arena.low_mark() <= 8 * distinct.size() + 4 * expected.size() + 16);
    }
}

TEST_CASE("every arena size gives the diagram or out_of_memory") {
    std::mt19937 random(43);
    const Graph g = random_graph(random, 24, 90, 1000);
    const auto expected = oracle::diagram(flag_complex(g, 4), 2, false);
    bool enough = false;
    std::size_t bytes = 0;
    for (; !enough; bytes += 256) {
        Block block(bytes);
        Monitor monitor;
        CountedPairs out;
        const Status status = run(g, Form::table, {2}, {block.arena, monitor}, &out);
        enough = status == Status::ok;
        if (enough) {
            CHECK(oracle::same(expected, out.pairs));
        } else {
            REQUIRE(status == Status::out_of_memory);
            CHECK(block.arena.bytes_used() == 0);
        }
    }
    CHECK(bytes > 4096);
}

TEST_CASE("simplices that have no numbers are refused") {
    Monitor monitor;
    Block block(1 << 16);
    RipsGraph graph = {64, 2016, nullptr, nullptr};
    CHECK(rips_has_numbers(graph, 10));
    CHECK(!rips_has_numbers(graph, 30));
    CHECK(!rips_has_numbers(graph, 31));
    CountedPairs out;
    CHECK(persist_rips(graph, {30}, {block.arena, monitor}, &out) == Status::invalid_argument);
    graph.vertices = RipsGraph::vertices_max + 1;
    CHECK(!rips_has_numbers(graph, 1));
}

TEST_CASE("graphs of several kinds in blocks of all sizes") {
    std::mt19937 random(44);
    const Graph inputs[] = {{30, {}, {}},
                            random_graph(random, 16, 100, 6),
                            random_graph(random, 26, 40, 1000),
                            random_graph(random, 22, 90, 1u << 30)};
    for (const Graph& g : inputs) {
        for (const std::uint32_t degree : {0u, 1u, 2u, 3u}) {
            const auto f = flag_complex(g, degree + 2);
            for (const int at : {0, 1, 2, 3}) {
                const bool keep = at < 2;
                const Form form = at % 2 == 0 ? Form::table : Form::lists;
                const auto expected = oracle::diagram(f, degree, keep);
                disturbed::by_size(std::size_t{4} << 20, 1000, [&](const Work& work) {
                    CountedPairs out;
                    const Status status = run(g, form, {degree, keep}, work, &out);
                    if (status == Status::ok) REQUIRE(oracle::same(expected, out.pairs));
                    return status;
                });
            }
        }
    }
}

// Polls are 100,000 steps apart: in a large graph the first ones come while edges are met, in a small one of high
// degree while cliques are walked or columns added.
TEST_CASE("stopped at any poll, then the diagram of an undisturbed run") {
    std::mt19937 random(45);
    const auto check = [](const Graph& g, Form form, std::uint32_t degree) {
        std::vector<Pair> expected;
        const auto once = [&](const Work& work) {
            CountedPairs diagram;
            const Status status = run(g, form, {degree}, work, &diagram);
            if (status != Status::ok) return status;
            const PairList& out = diagram.pairs;
            if (expected.empty()) expected.assign(out.pairs, out.pairs + out.count);
            REQUIRE(oracle::same(expected, out));
            return status;
        };
        const std::size_t enough = std::size_t{64} << 20;
        Block block(enough);
        Monitor monitor;
        REQUIRE(once({block.arena, monitor}) == Status::ok);
        CHECK(expected.size() > degree);
        CHECK(disturbed::at_polls(enough, once) > 0);
    };
    const auto plane = [&random](std::uint32_t n) {
        Graph g = random_graph(random, n, 100, 1);
        std::vector<double> x(2 * n);
        for (double& t : x) t = double(random() % 100000);
        for (std::size_t e = 0; e < g.ends.size(); ++e) {
            const std::uint32_t i = g.ends[e] >> 16, j = g.ends[e] & 0xFFFF;
            g.value[e] = std::hypot(x[2 * i] - x[2 * j], x[2 * i + 1] - x[2 * j + 1]);
        }
        return g;
    };
    for (const Form form : {Form::table, Form::lists}) {
        const bool is_table = form == Form::table;
        check(plane(is_table ? 460 : 230), form, 1);
        check(plane(is_table ? 110 : 70), form, 3);
        check(random_graph(random, is_table ? 60 : 40, 75, 1u << 30), form, 3);
    }
}
