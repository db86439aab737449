// Any block size, any content of the block before, any moment to cancel: a status, and what is held is whole.
#include <doctest/doctest.h>

#include <cstring>

#include "common/inputs.hpp"
#include "netmesh.h"

namespace {

constexpr std::size_t guard_bytes = 256;

// A block between guards, filled with a pattern.
class GuardedBlock {
public:
    GuardedBlock(std::size_t bytes, unsigned char fill) : bytes_(bytes), memory_(bytes + 2 * guard_bytes + 16, 0xC3) {
        std::memset(block(), fill, bytes);
    }
    unsigned char* block() {
        unsigned char* p = memory_.data() + guard_bytes;
        return p + (16 - reinterpret_cast<std::uintptr_t>(p) % 16) % 16;
    }
    bool guards_intact() {
        for (unsigned char* p = memory_.data(); p < block(); ++p)
            if (*p != 0xC3) return false;
        for (unsigned char* p = block() + bytes_; p < memory_.data() + memory_.size(); ++p)
            if (*p != 0xC3) return false;
        return true;
    }

private:
    std::size_t bytes_;
    std::vector<unsigned char> memory_;
};

std::uint64_t fingerprint(netmesh_context* context) {
    netmesh_report report;
    report.struct_bytes = sizeof report;
    REQUIRE(netmesh_get_report(context, &report) == NETMESH_OK);
    return report.fingerprint;
}

struct Sweep {
    int refused = 0, partial = 0, whole = 0, failures = 0;
    std::uint64_t result = 0;
};

void run_at(int dim, const inputs::Points& points, bool alpha, std::size_t bytes, unsigned char fill, Sweep* sweep) {
    netmesh_options options;
    netmesh_options_init(&options, static_cast<std::uint32_t>(dim));
    GuardedBlock memory(bytes, fill);
    netmesh_context* context;
    netmesh_status status = netmesh_init(memory.block(), bytes, &context);
    if (status == NETMESH_OUT_OF_MEMORY) {
        ++sweep->refused;
        return;
    }
    REQUIRE(status == NETMESH_OK);
    const std::size_t n = points.size() / static_cast<std::size_t>(dim);
    status = alpha ? netmesh_delaunay(context, points.data(), n, &options)
                   : netmesh_mesh(context, points.data(), n, NETMESH_JOB_PERSIST, &options);
    if (status == NETMESH_OK)
        status = netmesh_persist(context, alpha ? NETMESH_FILTER_ALPHA : NETMESH_FILTER_COMPLETE,
                                 NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 0, &options);
    REQUIRE(memory.guards_intact());
    if (status == NETMESH_OK) {
        if (sweep->whole++ == 0) sweep->result = fingerprint(context);
        CHECK(fingerprint(context) == sweep->result);
        return;
    }
    REQUIRE(status == NETMESH_OUT_OF_MEMORY);
    ++sweep->failures;
    CHECK(netmesh_get_detail(context).bytes_wanted > bytes);
    const netmesh_status checked = netmesh_check(
        context, NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY, &options);
    CHECK((checked == NETMESH_OK || checked == NETMESH_NO_RESULT));
    sweep->partial += checked == NETMESH_OK;
}

void run_sweep(int dim, std::size_t n, bool alpha, std::size_t step, std::size_t last) {
    CAPTURE(dim);
    CAPTURE(alpha);
    const inputs::Points points = inputs::uniform(dim, n);
    Sweep sweep;
    for (std::size_t bytes = 0; bytes <= last; bytes += step)
        run_at(dim, points, alpha, bytes, bytes / step % 2 == 0 ? 0xAA : 0x55, &sweep);
    CHECK(sweep.refused > 0);
    CHECK(sweep.partial > 0);
    CHECK(sweep.whole > 0);
}

}  // namespace

TEST_CASE("every block size ends in a status and a whole result so far") {
    run_sweep(2, 12, false, 48, 60000);
    run_sweep(3, 6, false, 400, 300000);
    run_sweep(4, 3, false, 4000, 1600000);
    run_sweep(2, 40, true, 64, 60000);
    run_sweep(3, 20, true, 160, 120000);
}

TEST_CASE("a job cancelled at any poll leaves a Delaunay mesh, and the next run is not affected") {
    const inputs::Points points = inputs::uniform(3, 1500);
    netmesh_options options;
    netmesh_options_init(&options, 3);
    const std::size_t bytes = std::size_t{1} << 26;
    GuardedBlock memory(bytes, 0x55);
    netmesh_context* context;
    REQUIRE(netmesh_init(memory.block(), bytes, &context) == NETMESH_OK);
    const auto run = [&] {
        const netmesh_status status = netmesh_mesh(context, points.data(), 1500, NETMESH_JOB_PERSIST, &options);
        if (status != NETMESH_OK) return status;
        return netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, 3, 0, &options);
    };
    REQUIRE(run() == NETMESH_OK);
    const std::uint64_t whole = fingerprint(context);
    int left = 0;
    options.poll = [](void* user, const netmesh_progress* progress) {
        CHECK(progress->stage != NETMESH_STAGE_NONE);
        return --*static_cast<int*>(user) < 0 ? 1 : 0;
    };
    options.user = &left;
    int cancelled = 0;
    for (int polls = 0;; ++polls) {
        left = polls;
        const netmesh_status status = run();
        if (status == NETMESH_OK) break;
        REQUIRE(status == NETMESH_CANCELLED);
        ++cancelled;
        CHECK(netmesh_check(context, NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_DELAUNAY, &options) == NETMESH_OK);
    }
    CHECK(cancelled > 5);
    CHECK(fingerprint(context) == whole);
    CHECK(memory.guards_intact());
}

TEST_CASE("arguments that cannot be meant are refused by position, and nothing is lost") {
    const inputs::Points points = inputs::uniform(2, 20);
    netmesh_options options;
    netmesh_options_init(&options, 2);
    const std::size_t bytes = 1 << 20;
    GuardedBlock memory(bytes, 0);
    netmesh_context* context;
    CHECK(netmesh_init(nullptr, bytes, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(memory.block() + 8, bytes - 8, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(memory.block(), 100, &context) == NETMESH_OUT_OF_MEMORY);
    REQUIRE(netmesh_init(memory.block(), bytes, &context) == NETMESH_OK);
    REQUIRE(netmesh_mesh(context, points.data(), 20, NETMESH_JOB_PERSIST, &options) == NETMESH_OK);
    const std::uint64_t before = fingerprint(context);
    const auto refused = [&](netmesh_status status, std::uint64_t position) {
        CHECK(status == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_detail(context).index_a == position);
        CHECK(netmesh_get_detail(context).message[0] != '\0');
        CHECK(fingerprint(context) == before);
    };
    refused(netmesh_mesh(context, nullptr, 20, NETMESH_JOB_MESH, &options), 2);
    refused(netmesh_mesh(context, points.data(), 0, NETMESH_JOB_MESH, &options), 3);
    refused(netmesh_mesh(context, points.data(), 20, NETMESH_JOB_DELAUNAY, &options), 4);
    for (const double tau : {2.0, 1.0, -3.0, 1.0 / 0.0}) {
        options.tau = tau;
        refused(netmesh_mesh(context, points.data(), 20, NETMESH_JOB_MESH, &options), 5);
    }
    options.tau = 0;
    options.dim = 7;
    refused(netmesh_mesh(context, points.data(), 20, NETMESH_JOB_MESH, &options), 5);
    options.dim = 2;
    refused(netmesh_persist(context, static_cast<netmesh_filter>(9), NETMESH_VALUES_CERTIFIED, 1, 0, &options), 2);
    CHECK(netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, 1, 0, &options) ==
          NETMESH_NO_RESULT);
    CHECK(fingerprint(context) == before);
    netmesh_pair pair;
    CHECK(netmesh_get_pair(context, 0, &pair) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_delaunay(nullptr, points.data(), 20, &options) == NETMESH_INVALID_ARGUMENT);
}
