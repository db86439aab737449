// Requests for distances of diagrams that are refused: which field each refusal names.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "common/read.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Each kind of distance by its own names.
struct BottleneckCalls {
    using Request = netmesh::Bottleneck;
    using Result = netmesh_distance;
    static netmesh_status call(const netmesh_bottleneck_request* r, netmesh_distance* d, netmesh_detail* detail) {
        return netmesh_bottleneck(r, d, detail);
    }
    static std::size_t bytes(const netmesh_bottleneck_request* r) { return netmesh_bottleneck_bytes(r); }
};
struct WassersteinCalls {
    using Request = netmesh::Wasserstein;
    using Result = netmesh_wasserstein_distance;
    static netmesh_status call(const netmesh_wasserstein_request* r, netmesh_wasserstein_distance* d,
                               netmesh_detail* detail) {
        return netmesh_wasserstein(r, d, detail);
    }
    static std::size_t bytes(const netmesh_wasserstein_request* r) { return netmesh_wasserstein_bytes(r); }
};

// A request that is good, and changes of it that are not.
template <class Calls> struct Refusals {
    Refusals() {
        good.pairs_a = good.pairs_b = &a;
        good.count_a = good.count_b = 1;
        good.scratch = scratch;
        good.scratch_bytes = sizeof scratch;
    }
    template <class Change> void refused(Change change, netmesh_field field) {
        auto bad = good;
        change(bad);
        CHECK(Calls::call(&bad, &d, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.status == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.field == field);
        CHECK(detail.message[0] != 0);
        CHECK(Calls::call(&bad, &d, nullptr) == NETMESH_INVALID_ARGUMENT);
    }
    // What both kinds take and refuse.
    void check_common() {
        CHECK(Calls::call(&good, &d, &detail) == NETMESH_OK);
        CHECK(detail.status == NETMESH_OK);
        CHECK(d.value == 0);
        refused([](auto& r) { r.struct_bytes = 0; }, NETMESH_FIELD_STRUCT_BYTES);
        refused([](auto& r) { r.pairs_a = nullptr; }, NETMESH_FIELD_PAIRS_A);
        refused([](auto& r) { r.pairs_b = nullptr; }, NETMESH_FIELD_PAIRS_B);
        refused([](auto& r) { r.pair_bytes = 8; }, NETMESH_FIELD_PAIR_BYTES);
        refused([](auto& r) { r.scratch = nullptr; }, NETMESH_FIELD_SCRATCH);
        refused([this](auto& r) { r.scratch = scratch + 8; }, NETMESH_FIELD_SCRATCH);
        refused([this](auto& r) { r.monitor.user = scratch; }, NETMESH_FIELD_MONITOR);
        const netmesh_pair late = bar(0, 2, 1), nowhere = bar(0, not_a_number, 1);
        refused([&](auto& r) { r.pairs_a = &late; }, NETMESH_FIELD_PAIRS_A);
        refused([&](auto& r) { r.pairs_b = &nowhere; }, NETMESH_FIELD_PAIRS_B);
        CHECK(Calls::call(nullptr, &d, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.field == NETMESH_FIELD_REQUEST);
        CHECK(Calls::call(&good, nullptr, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.field == NETMESH_FIELD_RESULT);
        auto without = good;
        without.scratch = nullptr;
        without.scratch_bytes = 0;
        CHECK(Calls::call(&without, &d, &detail) == NETMESH_OUT_OF_MEMORY);
        CHECK(detail.bytes_wanted == Calls::bytes(&without));
        CHECK(Calls::bytes(&without) > 0);
        CHECK(Calls::bytes(nullptr) == 0);
    }

    const netmesh_pair a = bar(0, 0, 1);
    alignas(16) unsigned char scratch[4096];
    typename Calls::Request good;
    typename Calls::Result d = netmesh::sized<typename Calls::Result>();
    netmesh_detail detail = netmesh::sized<netmesh_detail>();
};

}  // namespace

TEST_CASE("bottleneck distances") {
    Refusals<BottleneckCalls> of;
    of.check_common();
    of.refused([](auto& r) { r.scale = static_cast<netmesh_scale>(2); }, NETMESH_FIELD_SCALE);
    CHECK(netmesh::bottleneck_bytes(of.good) > 0);
}

TEST_CASE("Wasserstein distances") {
    Refusals<WassersteinCalls> of;
    CHECK(of.good.order == 1);
    CHECK(of.good.relative_error == 0.001);
    of.check_common();
    std::uint32_t mate = 7;
    double potential = 7;
    of.refused([](auto& r) { r.order = 0; }, NETMESH_FIELD_ORDER);
    of.refused([](auto& r) { r.order = NETMESH_ORDER_MAX + 1; }, NETMESH_FIELD_ORDER);
    for (const double error : {0.0, -1.0, not_a_number, HUGE_VAL})
        of.refused([error](auto& r) { r.relative_error = error; }, NETMESH_FIELD_RELATIVE_ERROR);
    of.refused([&](auto& r) { r.mates_a = &mate; }, NETMESH_FIELD_MATES);
    of.refused([&](auto& r) { r.potentials_a = &potential; }, NETMESH_FIELD_POTENTIALS);
    of.refused([&](auto& r) { r.potentials_b = &potential; }, NETMESH_FIELD_POTENTIALS);
    CHECK((mate == 7 && potential == 7));
    CHECK(netmesh::wasserstein_bytes(of.good) > 0);
}
