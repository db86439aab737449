// Lists of simplices on their way to a filtered complex: what is wrong with them, and what linking and ordering make.
#include "complex/listed_complex.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"

using namespace netmesh;

namespace {

// Simplices of each dimension as ascending vertices, with values; and the complex that points to them.
struct Lists {
    std::vector<std::uint32_t> rows[4];
    std::vector<double> values[4];

    void add(std::vector<std::uint32_t> vertices, double value) {
        std::sort(vertices.begin(), vertices.end());
        auto& to = rows[vertices.size() - 1];
        to.insert(to.end(), vertices.begin(), vertices.end());
        values[vertices.size() - 1].push_back(value);
    }
    ListedComplex complex() {
        ListedComplex c = {};
        for (std::uint32_t k = 0; k < 4; ++k) {
            if (!values[k].empty()) c.dimension = k;
            c.count[k] = static_cast<std::uint32_t>(values[k].size());
            c.rows[k] = rows[k].data();
            c.value[k] = values[k].data();
        }
        return c;
    }
    Status link(ComplexFault* fault) {
        Block block(std::size_t{1} << 20);
        Monitor monitor;
        ListedComplex c = complex();
        return link_faces(c, true, {block.arena, monitor}, fault);
    }
};

Lists vertices(std::uint32_t count) {
    Lists lists;
    for (std::uint32_t v = 0; v < count; ++v) lists.add({v}, 0);
    return lists;
}

}  // namespace

TEST_CASE("a face that is missing is found missing, however many there are") {
    for (std::uint32_t count = 2; count <= 70; ++count) {
        CAPTURE(count);
        ComplexFault fault;
        Lists whole = vertices(count);
        whole.add({0, count - 1}, 1);
        CHECK(whole.link(&fault) == Status::ok);
        CHECK(fault.kind == ComplexFault::nothing);
        Lists lists = vertices(count);
        lists.add({0, 1}, 1);
        lists.add({1, 1000}, 1);
        CHECK(lists.link(&fault) == Status::check_failed);
        CHECK(fault.kind == ComplexFault::face_missing);
        CHECK(fault.dimension == 1);
        CHECK(fault.index == 1);
        CHECK(fault.other == 0);  // the facet without vertex 1 is 1000
    }
}

TEST_CASE("a simplex that is listed twice is a fault in every dimension") {
    for (std::uint32_t k = 0; k < 4; ++k) {
        CAPTURE(k);
        Lists lists;
        for (unsigned set = 1; set < 16; ++set) {
            std::vector<std::uint32_t> simplex;
            for (std::uint32_t v = 0; v < 4; ++v)
                if (set >> v & 1u) simplex.push_back(v);
            lists.add(simplex, static_cast<double>(simplex.size()));
        }
        std::vector<std::uint32_t> again;
        for (std::uint32_t v = 0; v <= k; ++v) again.push_back(v);
        lists.add(again, k + 1);
        ComplexFault fault;
        CHECK(lists.link(&fault) == Status::check_failed);
        CHECK(fault.kind == ComplexFault::repeated);
        CHECK(fault.dimension == k);
        CHECK(fault.index == lists.values[k].size() - 1);
        CHECK(fault.other == 0);
    }
}

TEST_CASE("a face may enter with its simplex and not later; of several faults the first is told") {
    Lists lists = vertices(5);
    lists.values[0] = {1, 2, 3, 3, 3};
    lists.add({0, 1}, 2);
    lists.add({1, 2}, 3);
    ComplexFault fault;
    CHECK(lists.link(&fault) == Status::ok);
    lists = vertices(5);
    lists.values[0] = {1, 2, 3, 3, 3};
    lists.add({0, 1}, 2);
    lists.add({1, 2}, 2.5);
    lists.add({2, 3}, 2.5);
    lists.add({3, 4}, 2.5);
    CHECK(lists.link(&fault) == Status::check_failed);
    CHECK(fault.kind == ComplexFault::face_later);
    CHECK(fault.dimension == 1);
    CHECK(fault.index == 1);
    CHECK(fault.other == 2);
}

TEST_CASE("linked and put in order, simplices still are what they were") {
    inputs::Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        // Some tetrahedra on 12 vertices with all of their faces, values growing with the dimension.
        std::vector<std::vector<std::uint32_t>> all[4];
        for (int t = 0; t < 8; ++t) {
            std::uint32_t v[12];
            for (std::uint32_t i = 0; i < 12; ++i) v[i] = i;
            for (std::uint32_t i = 0; i < 4; ++i) std::swap(v[i], v[i + random.below(12 - i)]);
            for (unsigned set = 1; set < 16; ++set) {
                std::vector<std::uint32_t> simplex;
                for (std::uint32_t i = 0; i < 4; ++i)
                    if (set >> i & 1u) simplex.push_back(v[i]);
                std::sort(simplex.begin(), simplex.end());
                auto& of = all[simplex.size() - 1];
                if (std::find(of.begin(), of.end(), simplex) == of.end()) of.push_back(simplex);
            }
        }
        Lists lists;
        std::vector<std::pair<double, std::vector<std::uint32_t>>> expected[4];
        for (std::size_t k = 0; k < 4; ++k)
            for (const auto& simplex : all[k]) {
                const double value = static_cast<double>(100 * k + random.below(7));
                lists.add(simplex, value);
                expected[k].emplace_back(value, simplex);
            }
        Block block(std::size_t{1} << 20);
        Monitor monitor;
        ListedComplex complex = lists.complex();
        ComplexFault fault;
        REQUIRE(link_faces(complex, true, {block.arena, monitor}, &fault) == Status::ok);
        REQUIRE(order_by_value(complex, block.arena) == Status::ok);
        const FilteredComplex filtered = complex.filtered();
        for (std::uint32_t k = 0; k < 4; ++k) {
            std::stable_sort(expected[k].begin(), expected[k].end(),
                             [](const auto& a, const auto& b) { return a.first < b.first; });
            for (std::uint32_t i = 0; i < filtered.of[k].count; ++i) {
                std::vector<std::uint32_t> labels(k + 1);
                vertices_of(filtered, complex.rows[0], k, i, labels.data());
                CHECK(labels == expected[k][i].second);
                CHECK(filtered.of[k].value[i] == expected[k][i].first);
            }
        }
    }
}
