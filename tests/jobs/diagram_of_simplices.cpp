// Complexes that a caller lists: the highest degree, vertices in any order, what is wrong with a list, and where.
#include "jobs/diagram_of_simplices.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "common/block.hpp"
#include "numerics/real.hpp"

using namespace netmesh;

namespace {

struct List {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> values;

    void add(const std::vector<std::uint32_t>& simplex, double value) {
        vertices.insert(vertices.end(), simplex.begin(), simplex.end());
        starts.push_back(vertices.size());
        values.push_back(value);
    }
};

// Simplices of 0..size-1 with up to `most` vertices, each at its number of vertices; in any order, and so their
// vertices.
List skeleton(std::uint32_t size, std::uint32_t most, std::mt19937& random) {
    std::vector<std::vector<std::uint32_t>> simplices;
    for (std::uint32_t mask = 1; mask < 1u << size; ++mask) {
        std::vector<std::uint32_t> s;
        for (std::uint32_t v = 0; v < size; ++v)
            if (mask >> v & 1) s.push_back(v);
        if (s.size() > most) continue;
        std::shuffle(s.begin(), s.end(), random);
        simplices.push_back(s);
    }
    std::shuffle(simplices.begin(), simplices.end(), random);
    List list;
    for (const auto& s : simplices) list.add(s, double(s.size()));
    return list;
}

Status persist(const List& list, std::uint32_t degree, std::uint32_t counted, std::vector<Pair>* pairs,
               SimplicesDiagram* out) {
    Block block(std::size_t{1} << 20);
    Monitor monitor;
    const Status status =
        diagram_of_simplices({list.vertices.data(), list.starts.data(), list.values.data(), list.values.size()},
                             {{degree, false}, false, counted}, {block.arena, monitor}, out);
    if (status == Status::ok)
        pairs->assign(out->diagram.pairs.pairs, out->diagram.pairs.pairs + out->diagram.pairs.count);
    return status;
}

double binomial(std::uint32_t n, std::uint32_t k) {
    double b = 1;
    for (std::uint32_t i = 0; i < k; ++i) b = b * (n - i) / (i + 1);
    return b;
}

}  // namespace

// The (m-1)-skeleton of a simplex of n vertices is a wedge of C(n - 1, m) spheres, and each lower skeleton before it.
TEST_CASE("skeletons of simplices: spheres up to the highest dimension, whatever the order of their vertices") {
    std::mt19937 random(12);
    for (std::uint32_t n = 2; n <= 7; ++n) {
        for (std::uint32_t m = 1; m < n; ++m) {
            CAPTURE(n);
            CAPTURE(m);
            const List list = skeleton(n, m, random);
            std::vector<Pair> pairs;
            SimplicesDiagram out;
            REQUIRE(persist(list, 9, 9, &pairs, &out) == Status::ok);
            CHECK(out.max_degree == m - 1);
            std::vector<double> born(m, 0), essential(m, 0);
            for (const Pair& p : pairs) {
                ++born[p.degree];
                essential[p.degree] += p.death == infinity;
                CHECK(p.birth == p.degree + 1);
                CHECK((p.death == infinity || p.death == p.degree + 2));
            }
            for (std::uint32_t k = 0; k < m; ++k) {
                CHECK(born[k] == binomial(n - 1, k + 1) + (k == 0 ? 1 : 0));
                CHECK(essential[k] == (k == m - 1 ? binomial(n - 1, m) : 0) + (k == 0 ? 1 : 0));
            }
        }
    }
}

TEST_CASE("simplices are counted up to the dimension that is asked for") {
    std::mt19937 random(13);
    const List list = skeleton(5, 4, random);
    const std::uint64_t expected[] = {5, 15, 25, 30, 30};
    for (std::uint32_t counted = 0; counted < 5; ++counted) {
        std::vector<Pair> pairs;
        SimplicesDiagram out;
        REQUIRE(persist(list, 1, counted, &pairs, &out) == Status::ok);
        CHECK(out.diagram.simplices == expected[counted]);
    }
}

// One simplex enters too early, in any place: the place of a face that enters after it is told, or one that it enters
// before is.
TEST_CASE("a simplex that enters before its face is told with that face, by their places in the list") {
    std::mt19937 random(14);
    for (int round = 0; round < 200; ++round) {
        List list = skeleton(4, 4, random);
        const std::size_t moved = random() % list.values.size();
        const double before = list.values[moved];
        if (before < 2) continue;
        list.values[moved] = before - 1.5;
        std::vector<Pair> pairs;
        SimplicesDiagram out;
        REQUIRE(persist(list, 2, 9, &pairs, &out) == Status::not_a_complex);
        CHECK(out.listed.fault.kind == NETMESH_FAULT_FACE_LATER);
        CHECK(out.listed.fault.simplex == moved);
        REQUIRE(out.listed.fault.other < list.values.size());
        CHECK(list.values[out.listed.fault.other] > list.values[moved]);
        const auto simplex = [&](std::uint64_t i) {
            std::vector<std::uint32_t> s(list.vertices.begin() + static_cast<std::ptrdiff_t>(list.starts[i]),
                                         list.vertices.begin() + static_cast<std::ptrdiff_t>(list.starts[i + 1]));
            std::sort(s.begin(), s.end());
            return s;
        };
        const auto whole = simplex(moved), face = simplex(out.listed.fault.other);
        CHECK(face.size() + 1 == whole.size());
        CHECK(std::includes(whole.begin(), whole.end(), face.begin(), face.end()));
    }
}
