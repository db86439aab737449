// Many small hierarchical meshes with gaps about as wide as a cage needs, where cages are made, kept and released, in
// every dimension and with every option.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/hierarchical.hpp"
#include "mesh/check/quality.hpp"

using namespace netmesh;

namespace {

template <int D> inputs::Points small_set(std::uint64_t seed) {
    const std::size_t pairs = 2 + seed / 4 % 3;
    switch (seed % 4) {
    case 0: return inputs::close_pairs(D, pairs, std::ldexp(1.0 + 0.2 * static_cast<double>(seed % 5), -4), seed);
    case 1: return inputs::close_pairs(D, pairs, std::ldexp(1.0 + 0.2 * static_cast<double>(seed % 5), -5), seed);
    case 2: return inputs::geometric(D, static_cast<double>(6 + seed % 20), 3, seed);
    default: return inputs::nested(D, 2, pairs, static_cast<double>(8 + seed % 24), seed);
    }
}

template <int D> void check_mesh(Hierarchical<D>& m, const MeshRequest& request) {
    CHECK(delaunay_violation<D>(m.store) == "");
    CHECK(m.result.hierarchy.cages == m.result.hierarchy.cages_made - m.result.hierarchy.cages_released);
    HierarchyQuality q;
    REQUIRE(measure_hierarchy(m.store, {m.result.cages, m.result.hierarchy.cages, m.result.domain}, m.block.arena,
                              &q) == Status::ok);
    CHECK(found(q.encroached) == "");
    CHECK(q.worst <= request.tau);
    if (request.finish) {
        CHECK(m.result.hierarchy.cages == 0);
        double worst;
        std::uint32_t v;
        REQUIRE(worst_aspect_ratio(m.store, m.result.domain, m.block.arena, &worst, &v) == Status::ok);
        CHECK(worst <= request.tau);
    }
    if (request.audit_location) {
        REQUIRE(m.result.audit.location.rounds > 0);
        for (std::uint32_t k = 0; k + 1 < m.result.audit.location.rounds; ++k)
            CHECK(m.result.audit.location.load[k + 1] <= m.result.audit.location.load[k] / 2);
    }
    if (request.audit_quality) {
        CHECK(m.result.audit.quality.meshes >= m.result.input.rows - m.result.input.duplicates);
        CHECK(m.result.audit.quality.encroached == 0);
        CHECK(m.result.audit.quality.cage <= cage_insertion_bound(D));
    }
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("small meshes with gaps keep what they promise, cages kept or released", T, small) {
    constexpr int D = T::value;
    constexpr double taus[3] = {D < 4   ? 2.3
                                : D < 5 ? 4
                                : D < 6 ? 6
                                        : 8,
                                D < 4   ? 3
                                : D < 5 ? 5
                                : D < 6 ? 8
                                        : 10,
                                D < 5 ? 6 : 12};
    std::uint32_t made = 0, released = 0, kept = 0;
    for (std::uint64_t seed = 0; seed < (D < 5 ? 160 : D == 5 ? 80 : 24); ++seed) {
        CAPTURE(seed);
        MeshRequest request = by_hierarchy(taus[seed % 3], seed % (D < 6 ? 5 : 20) == 0, seed);
        request.domain_factor = seed % 4 < 2 ? 1 : 1.25;
        request.audit_location = seed % 3 == 1;
        request.audit_quality = D < 6 ? seed % 7 == 2 : seed == 22;
        if (seed % 11 == 7) request.method = MeshMethod::quality;
        Hierarchical<D> m(small_set<D>(seed), request, std::size_t{1} << (D < 5 ? 22 : 25));
        REQUIRE(m.status == Status::ok);
        check_mesh<D>(m, request);
        made += m.result.hierarchy.cages_made;
        kept += m.result.hierarchy.cages;
        if (!request.finish) released += m.result.hierarchy.cages_released;
    }
    MESSAGE(D, ": ", made, " made, ", kept, " kept, ", released, " released");
    CHECK(made > 20);
    CHECK(kept > 10);
    CHECK(released >= 2);
}
TEST_CASE_TEMPLATE_APPLY(small, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("any arena size leaves a Delaunay mesh of what was inserted, lists and audits or none", T,
                          arenas) {
    constexpr int D = T::value;
    const inputs::Points points = small_set<D>(D < 5 ? 4 : 0);
    std::uint32_t partial = 0, whole = 0;
    for (double bytes = 256; bytes < (D < 5 ? 2e6 : 6e6); bytes *= D < 5 ? 1.05 : D == 5 ? 1.2 : 1.3)
        for (const int kind : {0, 1, 2}) {
            MeshRequest request = by_hierarchy(D < 5 ? 5.0 : 12.0, kind == 2);
            request.audit_location = kind == 1;
            request.audit_quality = kind == 1 && D < 6;
            Hierarchical<D> m(points, request, static_cast<std::size_t>(bytes));
            REQUIRE((m.status == Status::ok || m.status == Status::out_of_memory));
            if (m.state.cell_slots == 0) continue;
            CHECK(delaunay_violation<D>(m.store) == "");
            if (m.status == Status::ok && bytes > 1e5) check_mesh<D>(m, request);
            ++(m.status == Status::ok ? whole : partial);
        }
    CHECK(partial > 10);
    CHECK(whole > 10);
}
TEST_CASE_TEMPLATE_APPLY(arenas, Dimensions<>);
