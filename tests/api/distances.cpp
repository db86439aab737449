// Requests for distances of diagrams that are refused: which field each refusal names.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "common/read.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("distances") {
    const netmesh_pair a = bar(0, 0, 1);
    alignas(16) static unsigned char scratch[4096];
    netmesh::requests::Bottleneck good;
    good.pairs_a = good.pairs_b = &a;
    good.count_a = good.count_b = 1;
    good.scratch = scratch;
    good.scratch_bytes = sizeof scratch;
    auto d = netmesh::sized<netmesh_distance>();
    auto detail = netmesh::sized<netmesh_detail>();
    const auto refused = [&](auto change, netmesh_field field) {
        netmesh_bottleneck_request bad = good;
        change(bad);
        CHECK(netmesh_bottleneck(&bad, &d, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.status == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.field == field);
        CHECK(detail.message[0] != 0);
        CHECK(netmesh_bottleneck(&bad, &d, nullptr) == NETMESH_INVALID_ARGUMENT);
    };
    CHECK(netmesh_bottleneck(&good, &d, &detail) == NETMESH_OK);
    CHECK(detail.status == NETMESH_OK);
    CHECK(d.value == 0);
    refused([](auto& r) { r.struct_bytes = 0; }, NETMESH_FIELD_STRUCT_BYTES);
    refused([](auto& r) { r.pairs_a = nullptr; }, NETMESH_FIELD_PAIRS_A);
    refused([](auto& r) { r.pairs_b = nullptr; }, NETMESH_FIELD_PAIRS_B);
    refused([](auto& r) { r.pair_bytes = 8; }, NETMESH_FIELD_PAIR_BYTES);
    refused([](auto& r) { r.scale = static_cast<netmesh_scale>(2); }, NETMESH_FIELD_SCALE);
    refused([](auto& r) { r.scratch = nullptr; }, NETMESH_FIELD_SCRATCH);
    refused([](auto& r) { r.scratch = scratch + 8; }, NETMESH_FIELD_SCRATCH);
    const netmesh_pair late = bar(0, 2, 1), nowhere = bar(0, not_a_number, 1);
    refused([&](auto& r) { r.pairs_a = &late; }, NETMESH_FIELD_PAIRS_A);
    refused([&](auto& r) { r.pairs_b = &nowhere; }, NETMESH_FIELD_PAIRS_B);
    CHECK(netmesh_bottleneck(nullptr, &d, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_REQUEST);
    CHECK(netmesh_bottleneck(&good, nullptr, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_RESULT);
    good.scratch = nullptr;
    good.scratch_bytes = 0;
    CHECK(netmesh_bottleneck(&good, &d, &detail) == NETMESH_OUT_OF_MEMORY);
    CHECK(detail.bytes_wanted == netmesh_bottleneck_bytes(&good));
    CHECK(netmesh_bottleneck_bytes(nullptr) == 0);
}

TEST_CASE("Wasserstein distances") {
    const netmesh_pair a = bar(0, 0, 1);
    alignas(16) static unsigned char scratch[4096];
    netmesh::requests::Wasserstein good;
    good.pairs_a = good.pairs_b = &a;
    good.count_a = good.count_b = 1;
    good.scratch = scratch;
    good.scratch_bytes = sizeof scratch;
    auto d = netmesh::sized<netmesh_wasserstein_distance>();
    auto detail = netmesh::sized<netmesh_detail>();
    std::uint32_t mate = 7;
    double potential = 7;
    const auto refused = [&](auto change, netmesh_field field) {
        netmesh_wasserstein_request bad = good;
        change(bad);
        CHECK(netmesh_wasserstein(&bad, &d, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.status == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.field == field);
        CHECK(detail.message[0] != 0);
        CHECK(netmesh_wasserstein(&bad, &d, nullptr) == NETMESH_INVALID_ARGUMENT);
    };
    CHECK(good.order == 1);
    CHECK(good.relative_error == 0.001);
    CHECK(netmesh_wasserstein(&good, &d, &detail) == NETMESH_OK);
    CHECK(detail.status == NETMESH_OK);
    CHECK(d.value == 0);
    refused([](auto& r) { r.struct_bytes = 0; }, NETMESH_FIELD_STRUCT_BYTES);
    refused([](auto& r) { r.pairs_a = nullptr; }, NETMESH_FIELD_PAIRS_A);
    refused([](auto& r) { r.pairs_b = nullptr; }, NETMESH_FIELD_PAIRS_B);
    refused([](auto& r) { r.pair_bytes = 8; }, NETMESH_FIELD_PAIR_BYTES);
    refused([](auto& r) { r.order = 0; }, NETMESH_FIELD_ORDER);
    refused([](auto& r) { r.order = NETMESH_ORDER_MAX + 1; }, NETMESH_FIELD_ORDER);
    refused([](auto& r) { r.relative_error = 0; }, NETMESH_FIELD_RELATIVE_ERROR);
    refused([](auto& r) { r.relative_error = not_a_number; }, NETMESH_FIELD_RELATIVE_ERROR);
    refused([](auto& r) { r.relative_error = HUGE_VAL; }, NETMESH_FIELD_RELATIVE_ERROR);
    refused([&](auto& r) { r.mates_a = &mate; }, NETMESH_FIELD_MATES);
    refused([&](auto& r) { r.potentials_a = &potential; }, NETMESH_FIELD_POTENTIALS);
    refused([&](auto& r) { r.potentials_b = &potential; }, NETMESH_FIELD_POTENTIALS);
    refused([](auto& r) { r.scratch = nullptr; }, NETMESH_FIELD_SCRATCH);
    refused([](auto& r) { r.scratch = scratch + 8; }, NETMESH_FIELD_SCRATCH);
    const netmesh_pair late = bar(0, 2, 1), nowhere = bar(0, not_a_number, 1);
    refused([&](auto& r) { r.pairs_a = &late; }, NETMESH_FIELD_PAIRS_A);
    refused([&](auto& r) { r.pairs_b = &nowhere; }, NETMESH_FIELD_PAIRS_B);
    CHECK((mate == 7 && potential == 7));
    CHECK(netmesh_wasserstein(nullptr, &d, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_REQUEST);
    CHECK(netmesh_wasserstein(&good, nullptr, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_RESULT);
    good.scratch = nullptr;
    good.scratch_bytes = 0;
    CHECK(netmesh_wasserstein(&good, &d, &detail) == NETMESH_OUT_OF_MEMORY);
    CHECK(detail.bytes_wanted == netmesh_wasserstein_bytes(&good));
    CHECK(netmesh_wasserstein_bytes(nullptr) == 0);
    CHECK(netmesh::wasserstein_bytes(good) > 0);
}
