// Homology of complexes given by their simplices, and representatives that are checked against the textbook reduction.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "boundaries.hpp"
#include "common/read.hpp"
#include "complexes.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A context in its own block, and the lists that netmesh_homology takes, in a shuffled order.
class Homology {
public:
    explicit Homology(std::size_t bytes = std::size_t{1} << 20) : block_(bytes / 16), bytes_(bytes) {
        if (bytes > 0) init = netmesh_init(block_.data(), bytes_, &context);
    }
    netmesh_status run(const std::vector<Simplex>& simplices, const std::vector<double>& values, std::uint32_t degree,
                       bool keep_zero, bool cycles) {
        std::vector<std::uint32_t> vertices;
        std::vector<std::uint64_t> starts = {0};
        for (const Simplex& s : simplices) {
            vertices.insert(vertices.end(), s.begin(), s.end());
            starts.push_back(vertices.size());
        }
        auto list = netmesh::sized<netmesh_simplices>();
        list.vertices = vertices.data();
        list.starts = starts.data();
        list.entries = values.data();
        list.simplex_count = values.size();
        netmesh::Request request(&netmesh_filter_simplices);
        request.simplices = &list;
        request.max_degree = degree;
        request.keep_zero_pairs = keep_zero ? 1 : 0;
        request.cycles = cycles ? &netmesh_cycles : nullptr;
        return netmesh_persist(context, &request);
    }
    std::vector<netmesh::Pair> pairs() const {
        std::vector<netmesh::Pair> all;
        for (const netmesh_pair& p : read_all(context, netmesh_get_pair))
            all.push_back({p.birth, p.death, p.degree, 0});
        return all;
    }
    std::vector<Simplex> cycle(std::uint64_t pair, std::vector<double>* values) const {
        std::uint64_t count = 0;
        REQUIRE(netmesh_get_cycle(context, pair, &count) == NETMESH_OK);
        auto p = netmesh::sized<netmesh_pair>();
        REQUIRE(netmesh_get_pair(context, pair, &p) == NETMESH_OK);
        const std::vector<netmesh_simplex> cycle = cycle_of(context, pair);
        REQUIRE(cycle.size() == count);
        std::vector<Simplex> all;
        for (const netmesh_simplex& s : cycle) {
            CHECK(s.degree == p.degree);
            all.emplace_back(s.vertices, s.vertices + p.degree + 1);
            values->push_back(s.value);
        }
        auto s = netmesh::sized<netmesh_simplex>();
        CHECK(netmesh_get_cycle_simplex(context, pair, count, &s) == NETMESH_INVALID_ARGUMENT);
        return all;
    }
    netmesh_report report() const {
        auto r = netmesh::sized<netmesh_report>();
        REQUIRE(netmesh_get_report(context, &r) == NETMESH_OK);
        return r;
    }
    netmesh_detail detail() const { return detail_of(context); }

    netmesh_context* context = nullptr;
    netmesh_status init = NETMESH_OUT_OF_MEMORY;

private:
    struct alignas(16) Piece {
        unsigned char bytes[16];
    };
    std::vector<Piece> block_;
    std::size_t bytes_;
};

// The same filtration in another order of simplices, with labels that are far apart.
struct Shuffled {
    std::vector<Simplex> simplices;
    std::vector<double> values;
    Shuffled(const oracle::Filtered& f, std::mt19937& random) {
        std::vector<std::size_t> order(f.simplices.size());
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), random);
        for (const std::size_t i : order) {
            Simplex s = f.simplices[i];
            for (std::uint32_t& v : s) v = label(v);
            std::shuffle(s.begin(), s.end(), random);
            simplices.push_back(s);
            values.push_back(f.values[i]);
        }
    }
    static std::uint32_t label(std::uint32_t v) { return v * 40503u + 7; }
    static std::uint32_t vertex(std::uint32_t label) { return (label - 7) / 40503u; }
};

// Every cycle: boundary zero, born and dead at the right values; all of them together independent.
void check_cycles(const oracle::Filtered& f, const Homology& h) {
    const oracle::Boundaries boundaries(f);
    const auto pairs = h.pairs();
    for (std::uint64_t i = 0; i < pairs.size(); ++i) {
        CAPTURE(i);
        std::vector<double> values;
        oracle::Column chain;
        const std::vector<Simplex> cycle = h.cycle(i, &values);
        for (std::size_t n = 0; n < cycle.size(); ++n) {
            Simplex s = cycle[n];
            CHECK(std::is_sorted(s.begin(), s.end()));
            for (std::uint32_t& v : s) v = Shuffled::vertex(v);
            chain.push_back(boundaries.index(s));
            CHECK(f.values[chain.back()] == values[n]);
        }
        std::sort(chain.begin(), chain.end());
        REQUIRE(!chain.empty());
        CHECK(std::adjacent_find(chain.begin(), chain.end()) == chain.end());
        if (pairs[i].degree > 0) CHECK(boundaries.boundary(chain).empty());
        CHECK(*std::max_element(values.begin(), values.end()) == pairs[i].birth);
        CHECK(boundaries.death(chain) == pairs[i].death);
        if (pairs[i].degree == 0) CHECK(chain.size() == (pairs[i].death == infinity ? 1 : 2));
    }
}

std::vector<std::uint64_t> betti(const std::vector<Simplex>& maximal) {
    const auto f = oracle::filter(oracle::all_faces(maximal), [](const Simplex& s) { return double(s.size()); });
    std::mt19937 random(1);
    const Shuffled list(f, random);
    Homology h;
    REQUIRE(h.run(list.simplices, list.values, NETMESH_DEGREE_MAX, false, true) == NETMESH_OK);
    check_cycles(f, h);
    const netmesh_report r = h.report();
    CHECK(r.diagram.simplices == f.simplices.size());
    CHECK(r.complete == 1);
    return {r.diagram.essential, r.diagram.essential + r.diagram.max_degree + 1};
}

}  // namespace

TEST_CASE("Betti numbers of known complexes through the library, with generators") {
    using B = std::vector<std::uint64_t>;
    CHECK(betti({{0}}) == B{1});
    CHECK(betti({{0}, {1}, {2}}) == B{3});
    CHECK(betti({{0, 1}, {1, 2}, {0, 2}, {2, 3}, {3, 4}, {2, 4}}) == B{1, 2});
    for (std::uint32_t d = 1; d <= 5; ++d) {
        B expected(d + 1);
        expected[0] = expected[d] = 1;
        CHECK(betti(sphere(d)) == expected);
    }
    CHECK(betti(glued_square(5, false)) == B{1, 2, 1});  // torus
    CHECK(betti(glued_square(5, true)) == B{1, 2, 1});   // Klein bottle
    CHECK(betti(projective_plane) == B{1, 1, 1});
    CHECK(betti({{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}) == B{1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("random filtrations: diagrams and cycles") {
    std::mt19937 random(21);
    for (int round = 0; round < 30; ++round) {
        CAPTURE(round);
        const std::uint32_t dimension = 1 + random() % 4;
        const auto f = random_filtration(random, 6 + random() % 8, dimension, 1 + random() % 25, 1 + random() % 40);
        const Shuffled list(f, random);
        for (std::uint32_t degree = 0; degree <= dimension + 1; ++degree) {
            for (const bool keep : {false, true}) {
                Homology with, without;
                REQUIRE(with.run(list.simplices, list.values, degree, keep, true) == NETMESH_OK);
                REQUIRE(without.run(list.simplices, list.values, degree, keep, false) == NETMESH_OK);
                const auto expected = oracle::diagram(f, degree, keep);
                const auto a = with.pairs(), b = without.pairs();
                const auto same = [](const netmesh::Pair& x, const netmesh::Pair& y) {
                    return x.birth == y.birth && x.death == y.death && x.degree == y.degree;
                };
                CHECK(std::equal(a.begin(), a.end(), expected.begin(), expected.end(), same));
                CHECK(std::equal(b.begin(), b.end(), expected.begin(), expected.end(), same));
                CHECK(with.report().fingerprint == without.report().fingerprint);
                check_cycles(f, with);
                std::uint64_t count;
                CHECK(netmesh_get_cycle(without.context, 0, &count) == NETMESH_NO_RESULT);
            }
        }
    }
}

TEST_CASE("what is not a filtered complex is named") {
    const std::vector<Simplex> triangle = {{5}, {9}, {7}, {5, 7}, {9, 5}, {7, 9}, {7, 5, 9}};
    const std::vector<double> values = {0, 0, 0, 1, 2, 3, 3};
    Homology h;
    const auto fails = [&](std::vector<Simplex> s, std::vector<double> v, netmesh_fault fault, std::uint64_t a,
                           std::uint64_t b) {
        CHECK(h.run(s, v, 2, false, false) == NETMESH_NOT_A_COMPLEX);
        CHECK(h.detail().fault == fault);
        CHECK(h.detail().index_a == a);
        CHECK(h.detail().index_b == b);
        CHECK(std::string(h.detail().message) != "");
        CHECK(h.report().diagram.present == 0);
    };
    CHECK(h.run(triangle, values, 2, false, false) == NETMESH_OK);
    std::vector<Simplex> s = triangle;
    std::vector<double> v = values;
    v[4] = 4;
    fails(triangle, v, NETMESH_FAULT_FACE_LATER, 6, 4);
    v = values;
    v[2] = 1.5;
    fails(triangle, v, NETMESH_FAULT_FACE_LATER, 3, 2);
    s.push_back({7, 9});
    v = values;
    v.push_back(3);
    fails(s, v, NETMESH_FAULT_LISTED_TWICE, 7, 5);
    s = triangle;
    s.push_back({9, 5, 7});
    fails(s, v, NETMESH_FAULT_LISTED_TWICE, 7, 6);
    s.back() = {5, 11};
    fails(s, v, NETMESH_FAULT_FACE_MISSING, 7, 0);  // without its vertex 0 in ascending order, the face is {11}
    s.back() = {5, 5};
    fails(s, v, NETMESH_FAULT_VERTEX_TWICE, 7, 0);
    s.back() = Simplex();
    fails(s, v, NETMESH_FAULT_SIZE, 7, 0);
    s.back() = Simplex(33, 0);
    fails(s, v, NETMESH_FAULT_SIZE, 7, 0);
    v = values;
    v[5] = std::nan("");
    CHECK(h.run(triangle, v, 2, false, false) == NETMESH_NOT_FINITE);
    CHECK(h.detail().index_a == 5);
    CHECK(h.detail().fault == NETMESH_FAULT_NONE);
    v[5] = infinity;
    CHECK(h.run(triangle, v, 2, false, false) == NETMESH_NOT_FINITE);
    CHECK(h.run(triangle, values, 2, false, false) == NETMESH_OK);
}

TEST_CASE("every block gives the diagram or says that it is too small") {
    std::mt19937 random(22);
    const auto f = random_filtration(random, 12, 3, 25, 30);
    const Shuffled list(f, random);
    const auto expected = oracle::diagram(f, 3, false);
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.simplex_count = f.simplices.size();
    for (const Simplex& s : f.simplices) simplices.vertex_count += s.size();
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    const std::size_t planned = netmesh_plan(&request);
    for (const bool cycles : {false, true}) {
        bool fitted = false;
        for (std::size_t bytes = 0; bytes < planned; bytes += 208) {
            Homology h(bytes);
            if (h.init != NETMESH_OK) continue;
            const netmesh_status status = h.run(list.simplices, list.values, 3, false, cycles);
            if (status == NETMESH_OK) {
                fitted = true;
                REQUIRE(h.pairs().size() == expected.size());
            } else {
                REQUIRE(status == NETMESH_OUT_OF_MEMORY);
                REQUIRE(!fitted);
                REQUIRE(h.detail().bytes_wanted > bytes);
                REQUIRE(h.pairs().empty());
            }
        }
        CHECK(fitted);
    }
}

TEST_CASE("a block with cycles can be copied elsewhere") {
    std::mt19937 random(23);
    const auto f = random_filtration(random, 10, 3, 20, 30);
    const Shuffled list(f, random);
    Homology h(std::size_t{1} << 18), copy(std::size_t{1} << 18);
    REQUIRE(h.run(list.simplices, list.values, 3, false, true) == NETMESH_OK);
    std::memcpy(static_cast<void*>(copy.context), static_cast<const void*>(h.context), std::size_t{1} << 18);
    REQUIRE(netmesh_adopt(copy.context, &copy.context) == NETMESH_OK);
    check_cycles(f, copy);
}
