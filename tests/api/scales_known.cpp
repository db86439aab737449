// What a diagram joined of scales knows of its bars: bounds by scale and cycles of points, through the interface.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "common/dimensions.hpp"
#include "common/read.hpp"
#include "common/session.hpp"

namespace {

using Simplex = std::vector<std::uint32_t>;

// Two scales: points, and copies of them around each.
inputs::Points two_scales(int dim, std::size_t each, double ratio) {
    const inputs::Points base = inputs::uniform(dim, each, 7);
    const auto d = static_cast<std::size_t>(dim);
    inputs::Points p;
    for (std::size_t i = 0; i < each; ++i)
        for (std::size_t j = 0; j < each; ++j)
            for (std::size_t a = 0; a < d; ++a) p.push_back(base[i * d + a] + ratio * base[j * d + a]);
    return p;
}

std::vector<Simplex> cycle_of(const Session& session, std::uint64_t pair) {
    std::uint64_t count = 0;
    REQUIRE(netmesh_get_cycle(session.context, pair, &count) == NETMESH_OK);
    std::vector<Simplex> cycle;
    netmesh_pair bar = netmesh::sized<netmesh_pair>();
    REQUIRE(netmesh_get_pair(session.context, pair, &bar) == NETMESH_OK);
    for (std::uint64_t i = 0; i < count; ++i) {
        netmesh_simplex simplex = netmesh::sized<netmesh_simplex>();
        REQUIRE(netmesh_get_cycle_simplex(session.context, pair, i, &simplex) == NETMESH_OK);
        CHECK(simplex.degree == bar.degree);
        CHECK(simplex.value == bar.birth);
        cycle.emplace_back(simplex.vertices, simplex.vertices + simplex.degree + 1);
    }
    netmesh_simplex past = netmesh::sized<netmesh_simplex>();
    CHECK(netmesh_get_cycle_simplex(session.context, pair, count, &past) == NETMESH_INVALID_ARGUMENT);
    return cycle;
}

bool is_closed(const std::vector<Simplex>& cycle) {
    std::map<Simplex, int> faces;
    for (const Simplex& simplex : cycle)
        for (std::size_t v = 0; v < simplex.size() && simplex.size() > 1; ++v) {
            Simplex face = simplex;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(v));
            ++faces[face];
        }
    return std::all_of(faces.begin(), faces.end(), [](const auto& face) { return face.second % 2 == 0; });
}

netmesh::Request request_of(const Session& session, const inputs::Points& points, bool bounds, bool cycles) {
    netmesh::Request request = session.scales_request(points);
    request.goal.eps = 0;
    request.goal.ratio = 2.4;
    request.bounds = bounds ? &netmesh_bounds : nullptr;
    request.cycles = cycles ? &netmesh_cycles : nullptr;
    return request;
}

}  // namespace

TEST_CASE("a diagram joined of scales is the same with bounds, with cycles and without") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const inputs::Points points = two_scales(dim, by_dimension<std::size_t>(dim, {8, 7, 6, 5, 5}), 0.01);
        std::vector<netmesh_pair> plain;
        std::uint64_t fingerprint = 0;
        for (const std::uint32_t known : {0u, 1u, 2u, 3u}) {
            CAPTURE(known);
            Session session(dim);
            REQUIRE(session.persist_until_it_fits(request_of(session, points, (known & 1) == 1, known > 1)) ==
                    NETMESH_OK);
            const netmesh_report r = session.report();
            CHECK(r.scales.count > 1);
            CHECK(r.bounds.present == (known & 1));
            CHECK(r.diagram.representatives == known >> 1);
            const std::vector<netmesh_pair> pairs = session.pairs();
            if (known == 0) plain = pairs, fingerprint = r.fingerprint;
            CHECK(r.fingerprint == fingerprint);
            REQUIRE(pairs.size() == plain.size());
            for (std::size_t i = 0; i < pairs.size(); ++i)
                CHECK((pairs[i].degree == plain[i].degree && pairs[i].birth == plain[i].birth &&
                       pairs[i].death == plain[i].death));
            std::uint64_t count;
            CHECK(netmesh_get_cycle(session.context, 0, &count) == (known > 1 ? NETMESH_OK : NETMESH_NO_RESULT));
        }
    }
}

TEST_CASE("bounds by scale stay when they are asked for again, and are those of the bars in their order") {
    for (const int dim : dimensions(2, 4)) {
        CAPTURE(dim);
        const inputs::Points points = two_scales(dim, 7, 0.01);
        Session session(dim);
        REQUIRE(session.persist_until_it_fits(request_of(session, points, true, true)) == NETMESH_OK);
        const std::vector<netmesh_bar_bounds> first = read_all(session.context, netmesh_get_bar_bounds);
        const std::size_t steps = read_all(session.context, netmesh_get_scale_step).size();
        CHECK(steps > 0);
        REQUIRE(session.bound_bars() == NETMESH_OK);
        const std::vector<netmesh_bar_bounds> again = read_all(session.context, netmesh_get_bar_bounds);
        const std::vector<netmesh_pair> pairs = session.pairs();
        REQUIRE(again.size() == pairs.size());
        CHECK(read_all(session.context, netmesh_get_scale_step).size() == steps);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            CHECK(first[i].birth_low == again[i].birth_low);
            CHECK((first[i].birth_low <= pairs[i].birth && pairs[i].birth <= first[i].birth_high));
            CHECK((first[i].death_low <= pairs[i].death && pairs[i].death <= first[i].death_high));
            CHECK((pairs[i].degree > 0 || pairs[i].birth > 0 || first[i].birth_high == 0));
        }
    }
}

TEST_CASE("cycles of points are closed, of points there are, and as many as bars need") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        inputs::Points points = two_scales(dim, by_dimension<std::size_t>(dim, {9, 7, 6, 5, 5}), 0.01);
        const std::size_t different = points.size() / static_cast<std::size_t>(dim);
        points.insert(points.begin(), points.begin(), points.begin() + dim);  // the first one twice
        for (const std::uint32_t zero : {0u, 1u}) {
            Session session(dim);
            netmesh::Request request = request_of(session, points, false, true);
            request.keep_zero_pairs = zero;
            REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
            const double ratio = session.report().diagram.certified_ratio;
            const std::vector<netmesh_pair> pairs = session.pairs();
            std::set<std::uint32_t> seen;
            std::size_t empty = 0;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                const std::vector<Simplex> cycle = cycle_of(session, i);
                CHECK(std::set<Simplex>(cycle.begin(), cycle.end()).size() == cycle.size());
                CHECK(is_closed(cycle));
                for (const Simplex& simplex : cycle) {
                    CHECK(simplex.back() < different);
                    CHECK(std::is_sorted(simplex.begin(), simplex.end()));
                    CHECK(std::adjacent_find(simplex.begin(), simplex.end()) == simplex.end());
                    seen.insert(simplex.begin(), simplex.end());
                }
                if (pairs[i].degree == 0 && pairs[i].death > pairs[i].birth)
                    CHECK(cycle.size() == (pairs[i].death < HUGE_VAL ? 2 : 1));
                if (cycle.empty()) {
                    ++empty;
                    CHECK(pairs[i].death <= ratio * ratio * pairs[i].birth);
                }
                if (pairs[i].death == pairs[i].birth) CHECK(cycle.empty());
            }
            CHECK(seen.size() == different);  // each is born alone
        }
    }
}

// A ring of small rings: the large cycle goes through one point of each small ring, a small one stays in its own.
TEST_CASE("cycles of two rings are where these are") {
    const std::size_t around = 12, each = 12;
    inputs::Points points;
    for (std::size_t i = 0; i < around; ++i)
        for (std::size_t k = 0; k < each; ++k) {
            const auto [c, s] = inputs::turn(i, around);
            const auto [x, y] = inputs::turn(k, each);
            points.insert(points.end(), {c + 0.02 * x, s + 0.02 * y});
        }
    Session session(2);
    netmesh::Request request = request_of(session, points, true, true);
    request.goal.ratio = 1.9;
    request.goal.theta = 0.1;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    const std::vector<netmesh_pair> pairs = session.pairs();
    const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
    std::size_t small = 0, large = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].degree != 1 || bounds[i].certain == 0) continue;
        std::set<std::uint32_t> rings;
        for (const Simplex& edge : cycle_of(session, i))
            for (const std::uint32_t v : edge) rings.insert(v / static_cast<std::uint32_t>(each));
        CHECK((rings.size() == 1 || rings.size() == around));
        CHECK((rings.size() == around) == (pairs[i].birth > 0.1));
        ++(rings.size() == 1 ? small : large);
    }
    CHECK(small == around);
    CHECK(large == 1);
}

TEST_CASE("bounds and cycles of scales take no more room than the largest scale and the bars need") {
    // One scale of 40 points, and the same with four smaller scales within it.
    const inputs::Points large = inputs::uniform(2, 40, 41);
    inputs::Points all = large;
    for (const double scale : {1e-3, 1e-6, 1e-9, 1e-12})
        for (const double x : inputs::uniform(2, 10, 42)) all.push_back(large[0] + scale * x);
    Session one(2), many(2);
    netmesh::Request a = one.scales_request(large), b = many.scales_request(all);
    a.bounds = b.bounds = &netmesh_bounds;
    a.cycles = b.cycles = &netmesh_cycles;
    REQUIRE(one.persist_until_it_fits(a) == NETMESH_OK);
    REQUIRE(many.persist_until_it_fits(b) == NETMESH_OK);
    CHECK(many.report().scales.count > 1);
    CHECK(static_cast<double>(many.report().memory.peak_bytes) <=
          1.2 * static_cast<double>(one.report().memory.peak_bytes));
}
