// Cycles for diagrams of meshes and triangulations: each checked against the complex that the interface shows.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "homology/boundaries.hpp"

namespace {

// The cycle of a pair, every simplex ascending and entering no later than the pair.
std::vector<oracle::Simplex> checked_cycle(const Session& session, std::uint64_t index, const netmesh_pair& pair) {
    std::uint64_t count = 0;
    REQUIRE(netmesh_get_cycle(session.context, index, &count) == NETMESH_OK);
    std::vector<oracle::Simplex> cycle;
    double latest = -HUGE_VAL;
    const std::vector<netmesh_simplex> simplices = cycle_of(session.context, index);
    REQUIRE(simplices.size() == count);
    for (const netmesh_simplex& s : simplices) {
        CHECK(s.degree == pair.degree);
        latest = std::max(latest, s.value);
        cycle.emplace_back(s.vertices, s.vertices + pair.degree + 1);
        CHECK(std::is_sorted(cycle.back().begin(), cycle.back().end()));
    }
    CHECK(latest == pair.birth);
    return cycle;
}

// Boundary zero; whether every simplex is one of the triangulation.
void check_chains(const Session& session, const std::set<oracle::Simplex>& simplices) {
    const std::vector<netmesh_pair> pairs = session.pairs();
    CHECK(pairs.size() > 0);
    for (std::uint64_t i = 0; i < pairs.size(); ++i) {
        CAPTURE(i);
        std::set<oracle::Simplex> boundary;
        for (const oracle::Simplex& s : checked_cycle(session, i, pairs[i])) {
            CHECK(simplices.count(s) == 1);
            for (std::size_t v = 0; v < s.size() && s.size() > 1; ++v) {
                oracle::Simplex face = s;
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(v));
                if (!boundary.insert(face).second) boundary.erase(face);
            }
        }
        CHECK(boundary.empty());
    }
}

std::set<oracle::Simplex> simplices_of(const Session& session) {
    std::vector<oracle::Simplex> cells;
    for (const netmesh_cell& cell : read_all(session.context, netmesh_get_cell))
        cells.emplace_back(cell.vertices, cell.vertices + session.dim() + 1);
    const auto all = oracle::all_faces(cells);
    return {all.begin(), all.end()};
}

// Births and deaths of all cycles in the lower-star filtration that the vertex values give.
void check_deaths(const Session& session, const std::set<oracle::Simplex>& simplices, std::uint32_t zero_born) {
    std::vector<double> values;
    for (const netmesh_vertex& vertex : session.vertices()) values.push_back(vertex.value);
    const auto f = oracle::lower_star({simplices.begin(), simplices.end()}, values, zero_born);
    const oracle::Boundaries boundaries(f);
    const std::vector<netmesh_pair> pairs = session.pairs();
    for (std::uint64_t i = 0; i < pairs.size(); ++i) {
        CAPTURE(i);
        oracle::Column chain;
        for (const oracle::Simplex& s : checked_cycle(session, i, pairs[i])) chain.push_back(boundaries.index(s));
        std::sort(chain.begin(), chain.end());
        CHECK(f.values[chain.back()] == pairs[i].birth);
        CHECK(boundaries.death(chain) == pairs[i].death);
    }
}

}  // namespace

TEST_CASE("every bar of a mesh or an alpha complex has a cycle") {
    for (const int dim : dimensions({2, 3, 4})) {
        CAPTURE(dim);
        const inputs::Points points =
            dim == 4 ? inputs::uniform(4, 12) : inputs::shell(dim, dim == 2 ? 24 : 10, 0.7, 1, 3);
        for (const netmesh_filter* const filter :
             {&netmesh_filter_complete, &netmesh_filter_basic, &netmesh_filter_alpha}) {
            Session session(dim);
            session.reserve(std::size_t(1) << 26);
            netmesh::Request with_cycles = persist_by(filter);
            with_cycles.cycles = &netmesh_cycles;
            CHECK(session.persist(with_cycles) == NETMESH_NO_RESULT);
            REQUIRE((filter == &netmesh_filter_alpha ? session.alpha(points)
                                                     : session.mesh_and_persist(points, filter)) == NETMESH_OK);
            std::uint64_t count;
            CHECK(netmesh_get_cycle(session.context, 0, &count) == NETMESH_NO_RESULT);
            const netmesh_report before = session.report();
            REQUIRE(session.represent() == NETMESH_OK);
            CHECK(session.report().fingerprint == before.fingerprint);
            const auto simplices = simplices_of(session);
            check_chains(session, simplices);
            if (filter != &netmesh_filter_alpha && dim < 4) {
                check_deaths(session, simplices,
                             filter == &netmesh_filter_complete ? static_cast<std::uint32_t>(before.mesh.inputs) : 0);
            }
            CHECK(session.represent() == NETMESH_OK);
            CHECK(session.check() == NETMESH_OK);
            // A new diagram gives the memory of the cycles back.
            netmesh::Request all = persist_by(filter);
            all.max_degree = all.keep_zero_pairs = 1;
            REQUIRE(session.persist(all) == NETMESH_OK);
            CHECK(netmesh_get_cycle(session.context, 0, &count) == NETMESH_NO_RESULT);
            REQUIRE(session.represent() == NETMESH_OK);
            check_chains(session, simplices);
            REQUIRE(session.persist(filter) == NETMESH_OK);
            CHECK(session.report().memory.used_bytes == before.memory.used_bytes);
            CHECK(session.report().fingerprint == before.fingerprint);
        }
    }
}

TEST_CASE("a Rips diagram is the same with cycles, for which the complex is listed, and without") {
    for (const int dim : dimensions({2, 3, 6})) {
        for (const std::uint32_t degree : {0u, 1u, 2u}) {
            const inputs::Points points = inputs::uniform(dim, 24);
            Session session(dim);
            session.reserve(std::size_t(1) << 24);
            netmesh_report report[2];
            std::vector<netmesh_pair> pairs[2];
            for (const int cycles : {0, 1}) {
                netmesh::Request request = session.points_request(points, &netmesh_filter_rips, 1, degree);
                request.keep_zero_pairs = 1;
                request.cycles = cycles == 1 ? &netmesh_cycles : nullptr;
                REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
                report[cycles] = session.report();
                pairs[cycles] = session.pairs();
            }
            CHECK(report[0].fingerprint == report[1].fingerprint);
            CHECK(report[0].diagram.simplices == report[1].diagram.simplices);
            CHECK(pairs[0].size() == pairs[1].size());
        }
    }
}

TEST_CASE("without room for cycles the diagram stays") {
    const inputs::Points points = inputs::shell(3, 60, 0.7, 1, 3);
    Session whole(3);
    REQUIRE(whole.mesh_and_persist(points) == NETMESH_OK);
    // With pairs of zero length, for whose cycles the room that the mesh has left is not enough.
    netmesh::Request all = persist_by(&netmesh_filter_complete);
    all.keep_zero_pairs = 1;
    REQUIRE(whole.persist(all) == NETMESH_OK);
    const std::uint64_t enough = whole.report().memory.peak_bytes, print = whole.report().fingerprint;
    bool failed = false, fitted = false;
    for (std::uint64_t bytes = enough; !fitted; bytes += enough / 8) {
        Session session(3);
        session.reserve(static_cast<std::size_t>(bytes));
        if (session.mesh_in_block(points, &netmesh_filter_complete) != NETMESH_OK) continue;
        if (session.persist(all) != NETMESH_OK) continue;
        const std::uint64_t used = session.report().memory.used_bytes;
        const netmesh_status status = session.represent();
        fitted = status == NETMESH_OK;
        if (fitted) break;
        failed = true;
        REQUIRE(status == NETMESH_OUT_OF_MEMORY);
        CHECK(session.detail().bytes_wanted > bytes);
        CHECK(session.report().memory.used_bytes == used);
        CHECK(session.report().fingerprint == print);
    }
    CHECK(failed);
    CHECK(fitted);
}
