// One computation in blocks of all sizes, and stopped wherever it asks: a status, nothing left behind, the whole result
// as soon as it fits.
#pragma once
#include <doctest/doctest.h>

#include "common/block.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace disturbed {

struct Outcome {
    int refused, whole;
};

// run({arena, monitor}) looks at its result when it returns ok. Sizes from somewhat more than it needs down to
// nothing: in steps of 16 bytes until `dense` bytes are missing, then of a twentieth of what is.
template <class Run> Outcome by_size(std::size_t enough, std::size_t dense, Run run) {
    std::size_t peak = 0;
    {
        Block block(enough);
        netmesh::Monitor monitor;
        REQUIRE(run({block.arena, monitor}) == netmesh::Status::ok);
        peak = block.arena.bytes_peak();
    }
    Outcome outcome = {0, 0};
    const std::size_t most = ((peak + 15) & ~std::size_t{15}) + 32;
    for (std::size_t less = 0; less <= most; less += less < dense ? 16 : less / 20 / 16 * 16 + 16) {
        Block block(most - less);
        netmesh::Monitor monitor;
        const netmesh::Status status = run({block.arena, monitor});
        if (status == netmesh::Status::ok) {
            REQUIRE(outcome.refused == 0);
            ++outcome.whole;
        } else {
            REQUIRE(status == netmesh::Status::out_of_memory);
            REQUIRE(block.arena.bytes_used() == 0);
            REQUIRE(block.arena.bytes_wanted() > most - less);
            ++outcome.refused;
        }
    }
    CHECK(outcome.whole > 0);
    return outcome;
}

// Stopped at the first chance, at the second ..: how many there are.
template <class Run> int at_polls(std::size_t enough, Run run) {
    const auto poll = [](void* left, const netmesh_progress*) { return --*static_cast<int*>(left) < 0 ? 1 : 0; };
    Block block(enough);
    for (int polls = 0;; ++polls) {
        int left = polls;
        netmesh::Monitor monitor(poll, &left);
        const netmesh::Status status = run({block.arena, monitor});
        if (status == netmesh::Status::ok) return polls;
        REQUIRE(status == netmesh::Status::cancelled);
        REQUIRE(block.arena.bytes_used() == 0);
    }
}

}  // namespace disturbed
