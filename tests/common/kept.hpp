// A context in memory of its own, and what it holds after a diagram was made: bars to the bit, rows of hidden points.
#pragma once
#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "common/polls.hpp"
#include "netmesh.hpp"

namespace kept {

struct Context {
    explicit Context(std::size_t bytes) : storage(std::calloc(bytes, 1)), engine(storage.get(), bytes) {
        REQUIRE(engine.status() == NETMESH_OK);
    }
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<void, Free> storage;  // zeros, of which the system gives what is used
    netmesh::Engine engine;
};

struct Bar {
    std::uint32_t degree;
    double birth, death;
    bool operator==(const Bar& b) const { return std::memcmp(this, &b, sizeof b) == 0; }
};
inline std::vector<Bar> bars_of(const netmesh::Engine& engine) {
    std::vector<Bar> bars;
    for (const netmesh_pair& pair : engine.pairs()) {
        Bar bar;
        std::memset(&bar, 0, sizeof bar);
        bar.degree = pair.degree;
        bar.birth = pair.birth;
        bar.death = pair.death;
        bars.push_back(bar);
    }
    return bars;
}
inline std::vector<std::uint64_t> hidden_of(const netmesh::Engine& engine) {
    std::vector<std::uint64_t> rows;
    engine.for_each_hidden([&](std::uint64_t, std::uint64_t row) { rows.push_back(row); });
    return rows;
}
inline netmesh_report report_of(const netmesh::Engine& engine) {
    auto report = netmesh::sized<netmesh_report>();
    netmesh_get_report(engine.context(), &report);
    return report;
}

// Made whole, stopped at each of its polls, and made whole again: the same bars.
inline void stop_at_every_poll(Context* c, netmesh::Request request) {
    Polls polls;
    request.monitor = polls.monitor();
    REQUIRE(c->engine.persist(request) == NETMESH_OK);
    const std::vector<Bar> bars = bars_of(c->engine);
    const long all = polls.made;
    REQUIRE(all > 5);
    for (long stop = 0; stop < all; ++stop) {
        polls.made = 0;
        polls.stop_at = stop;
        REQUIRE(c->engine.persist(request) == NETMESH_CANCELLED);
    }
    polls.stop_at = -1;
    REQUIRE(c->engine.persist(request) == NETMESH_OK);
    CHECK(bars_of(c->engine) == bars);
}

}  // namespace kept
