// Any block size, any content of the block before, any moment to cancel: a status, and what is held is whole.
#include <doctest/doctest.h>

#include <cstring>
#include <string>

#include "common/calls.hpp"
#include "common/dimensions.hpp"

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

std::uint64_t fingerprint(const Calls& calls) {
    auto report = netmesh::sized<netmesh_report>();
    REQUIRE(netmesh_get_report(calls.context, &report) == NETMESH_OK);
    return report.fingerprint;
}

struct Sweep {
    int refused = 0, partial = 0, whole = 0, failures = 0;
    std::uint64_t result = 0;
};

void run_at(int dim, const inputs::Points& points, bool alpha, std::size_t bytes, unsigned char fill, Sweep* sweep) {
    GuardedBlock memory(bytes, fill);
    Calls calls(dim);
    netmesh_status status = netmesh_init(memory.block(), bytes, &calls.context);
    if (status == NETMESH_OUT_OF_MEMORY) {
        ++sweep->refused;
        return;
    }
    REQUIRE(status == NETMESH_OK);
    status = alpha ? calls.delaunay_in_block(points) : calls.mesh_in_block(points, &netmesh_filter_complete);
    if (status == NETMESH_OK) status = calls.persist(alpha ? &netmesh_filter_alpha : &netmesh_filter_complete);
    REQUIRE(memory.guards_intact());
    if (status == NETMESH_OK) {
        if (sweep->whole++ == 0) sweep->result = fingerprint(calls);
        CHECK(fingerprint(calls) == sweep->result);
        return;
    }
    REQUIRE(status == NETMESH_OUT_OF_MEMORY);
    ++sweep->failures;
    CHECK(calls.detail().bytes_wanted > bytes);
    const netmesh_status checked =
        calls.check(NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY);
    CHECK((checked == NETMESH_OK || checked == NETMESH_NO_RESULT));
    sweep->partial += checked == NETMESH_OK;
}

void run_sweep(int dim, std::size_t n, bool alpha, std::size_t step, std::size_t last) {
    if (dimensions({dim}).empty()) return;
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
    const std::size_t bytes = std::size_t{1} << 26;
    GuardedBlock memory(bytes, 0x55);
    Calls calls(3);
    REQUIRE(netmesh_init(memory.block(), bytes, &calls.context) == NETMESH_OK);
    bool is_made = false;
    const auto run = [&] {
        const netmesh_status status = calls.mesh_in_block(points, &netmesh_filter_complete);
        is_made = status == NETMESH_OK;
        return is_made ? calls.persist() : status;
    };
    REQUIRE(run() == NETMESH_OK);
    const std::uint64_t whole = fingerprint(calls);
    const double tau = calls.report().mesh.tau;
    int left = 0;
    const netmesh_poll stop = [](void* user, const netmesh_progress* progress) {
        CHECK(progress->stage != NETMESH_STAGE_NONE);
        return --*static_cast<int*>(user) < 0 ? 1 : 0;
    };
    calls.request.monitor = {stop, &left};
    int cancelled = 0;
    // Each of the first ones, when there are no cells yet, then fewer.
    for (int polls = 0;; polls += 1 + polls / 20) {
        left = polls;
        const netmesh_status status = run();
        if (status == NETMESH_OK) break;
        REQUIRE(status == NETMESH_CANCELLED);
        ++cancelled;
        calls.request.monitor = {};
        const bool is_mesh = calls.report().mesh.present != 0;
        CHECK((is_mesh || polls < 20));
        // What was cut off is not measured, what was made before stays so.
        if (is_mesh) CHECK((calls.report().mesh.aspect_ratio_max <= tau) == is_made);
        CHECK(calls.check(NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_DELAUNAY) ==
              (is_mesh ? NETMESH_OK : NETMESH_NO_RESULT));
        calls.request.monitor = {stop, &left};
    }
    CHECK(cancelled > 5);
    CHECK(fingerprint(calls) == whole);
    CHECK(memory.guards_intact());
}

TEST_CASE("what a call said is kept without an address") {
    GuardedBlock memory(std::size_t{1} << 16, 0xAA), copy(std::size_t{1} << 16, 0x55);
    Calls calls(2);
    REQUIRE(netmesh_init(memory.block(), std::size_t{1} << 16, &calls.context) == NETMESH_OK);
    CHECK(netmesh_mesh(calls.context, nullptr) == NETMESH_INVALID_ARGUMENT);
    const netmesh_detail said = calls.detail();
    CHECK(said.message == std::string("the request is null"));
    std::memcpy(copy.block(), memory.block(), std::size_t{1} << 16);
    for (std::size_t i = 0; i + sizeof said.message <= std::size_t{1} << 16; ++i)
        if (std::memcmp(copy.block() + i, &said.message, sizeof said.message) == 0) FAIL("an address at " << i);
    REQUIRE(netmesh_adopt(copy.block(), &calls.context) == NETMESH_OK);
    CHECK(calls.detail().message == said.message);
    CHECK(calls.detail().field == NETMESH_FIELD_REQUEST);
}

TEST_CASE("more bytes are wanted than there are") {
    for (const int dim : dimensions(2, 3)) {
        const inputs::Points points = inputs::uniform(dim, 200);
        Calls calls(dim);
        calls.request.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
        for (std::size_t bytes = 16384; bytes < 65536; bytes += 1616) {
            GuardedBlock memory(bytes, 0);
            if (netmesh_init(memory.block(), bytes, &calls.context) != NETMESH_OK) continue;
            REQUIRE(calls.mesh_in_block(points) == NETMESH_OUT_OF_MEMORY);
            CHECK(calls.detail().bytes_wanted > bytes);
        }
    }
}

TEST_CASE("arguments that cannot be meant are refused by their field, and nothing is lost") {
    const inputs::Points points = inputs::uniform(2, 20);
    const std::size_t bytes = 1 << 20;
    GuardedBlock memory(bytes, 0);
    Calls calls(2);
    netmesh_context*& context = calls.context;
    CHECK(netmesh_init(nullptr, bytes, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(memory.block() + 8, bytes - 8, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(memory.block(), 100, &context) == NETMESH_OUT_OF_MEMORY);
    REQUIRE(netmesh_init(memory.block(), bytes, &context) == NETMESH_OK);
    REQUIRE(calls.mesh_in_block(points, &netmesh_filter_complete) == NETMESH_OK);
    const std::uint64_t before = fingerprint(calls);
    const auto refused = [&](netmesh_status status, netmesh_field field) {
        CHECK(status == NETMESH_INVALID_ARGUMENT);
        CHECK(calls.detail().field == field);
        CHECK(calls.detail().message[0] != '\0');
        CHECK(fingerprint(calls) == before);
    };
    const auto mesh_refused = [&](auto change, netmesh_field field) {
        netmesh::Request request = calls.mesh_request(points);
        change(request);
        refused(netmesh_mesh(context, &request), field);
    };
    mesh_refused([](auto& r) { r.points.coordinates = nullptr; }, NETMESH_FIELD_POINTS);
    mesh_refused([](auto& r) { r.points.count = 0; }, NETMESH_FIELD_POINT_COUNT);
    mesh_refused([](auto& r) { r.mesh.method = nullptr; }, NETMESH_FIELD_METHOD);
    for (const double tau : {2.0, 1.0, -3.0, 1.0 / 0.0})
        mesh_refused([=](auto& r) { r.mesh.tau = tau; }, NETMESH_FIELD_TAU);
    mesh_refused([](auto& r) { r.points.dim = 7; }, NETMESH_FIELD_DIM);
    refused(calls.persist(nullptr), NETMESH_FIELD_FILTER);
    CHECK(calls.persist(&netmesh_filter_alpha) == NETMESH_NO_RESULT);
    CHECK(fingerprint(calls) == before);
    auto pair = netmesh::sized<netmesh_pair>();
    CHECK(netmesh_get_pair(context, 0, &pair) == NETMESH_INVALID_ARGUMENT);
    const netmesh::Request request = calls.delaunay_request(points);
    CHECK(netmesh_mesh(nullptr, &request) == NETMESH_INVALID_ARGUMENT);
}
