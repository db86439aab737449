// A context with a mesh, and what it says to arguments that it cannot use: the mesh stays.
#pragma once
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>

#include "common/session.hpp"

// A function, an edge with its ends and one with two steps: nothing is wrong with them.
inline netmesh_function constant_one() {
    auto function = netmesh::sized<netmesh_function>();
    function.evaluate = [](void*, const double*) { return 1.0; };
    function.lipschitz = function.cut = 1;
    return function;
}
inline netmesh_simplices edge(std::uint64_t steps) {
    static constexpr double values[] = {0, 0, 1, 0, 0, 2};
    static constexpr std::uint32_t vertices[] = {0, 1, 0, 1};
    static constexpr std::uint64_t starts[] = {0, 1, 2, 4};
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = vertices;
    simplices.starts = starts;
    simplices.entries = values;
    simplices.simplex_count = 3;
    simplices.vertex_count = 4;
    simplices.step_count = steps;
    return simplices;
}
inline const netmesh_function a_function = constant_one();
inline const netmesh_simplices an_edge = edge(0), two_steps = edge(2);

struct Fixture {
    static constexpr std::size_t many = NETMESH_POINTS_MAX + 1;
    using Job = netmesh_status (*)(netmesh_context*, const netmesh_request*);

    explicit Fixture(int dim) : session(dim), points(inputs::uniform(dim, 3)), c(session.context) {
        session.reserve(std::size_t{1} << 22);
        REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
        c = session.context;  // the block may have grown
        fingerprint = session.report().fingerprint;
    }
    void refused(netmesh_status status, netmesh_field field) {
        CHECK(status == NETMESH_INVALID_ARGUMENT);
        const netmesh_detail detail = session.detail();
        CHECK(detail.field == field);
        CHECK(detail.message[0] != 0);
        CHECK(session.report().fingerprint == fingerprint);
    }
    void ended(netmesh_status status, netmesh_status expected) {
        CHECK(status == expected);
        CHECK(session.detail().status == expected);
        CHECK(session.detail().field == NETMESH_FIELD_NONE);
        CHECK(session.report().fingerprint == fingerprint);
    }
    // A job refuses a null request, one without a size, one that is larger and holds what nobody knows, and one who
    // would watch it without a poll.
    template <class Request> void needs_request(netmesh_status (*job)(netmesh_context*, const Request*), Request good) {
        refused(job(c, nullptr), NETMESH_FIELD_REQUEST);
        for (const std::uint32_t bytes : {0u, 3u, 1u << 20}) {
            Request bad = good;
            bad.struct_bytes = bytes;
            refused(job(c, &bad), NETMESH_FIELD_STRUCT_BYTES);
        }
        Request unpolled = good;
        unpolled.monitor = {nullptr, this};
        refused(job(c, &unpolled), NETMESH_FIELD_MONITOR);
        struct {
            Request request;
            std::uint64_t later;
        } newer = {good, 1};
        newer.request.struct_bytes = sizeof newer;
        refused(job(c, &newer.request), NETMESH_FIELD_STRUCT_BYTES);
    }
    // A job on points refuses these.
    void needs_points(Job job, const netmesh_request& good) {
        needs_request<netmesh_request>(job, good);
        netmesh_request bad = good;
        bad.points.coordinates = nullptr;
        refused(job(c, &bad), NETMESH_FIELD_POINTS);
        for (const std::size_t count : {std::size_t{0}, many}) {
            bad = good;
            bad.points.count = count;
            refused(job(c, &bad), NETMESH_FIELD_POINT_COUNT);
        }
        for (const std::uint32_t d : {0u, 1u, 7u}) {
            bad = good;
            bad.points.dim = d;
            refused(job(c, &bad), NETMESH_FIELD_DIM);
        }
        needs_rows(job, good);
    }
    // Formats, addresses and strides that no rows have.
    void needs_rows(Job job, const netmesh_request& good) {
        const std::size_t row = good.points.dim * sizeof(double);
        netmesh_request bad = good;
        netmesh_points& points = bad.points;
        for (const int format : {-1, 2}) {
            std::memcpy(&points.format, &format, sizeof format);
            refused(job(c, &bad), NETMESH_FIELD_POINT_FORMAT);
        }
        bad = good;
        for (const std::size_t stride : {std::size_t{1}, row - 8, row + 2, row + 3, SIZE_MAX / 2 / 8 * 8}) {
            points.stride_bytes = stride;
            refused(job(c, &bad), NETMESH_FIELD_POINT_STRIDE_BYTES);
        }
        points.format = NETMESH_POINTS_FLOAT32;
        for (const std::size_t stride : {std::size_t{4}, row / 2 - 4, row / 2 + 2, SIZE_MAX - 3}) {
            points.stride_bytes = stride;
            refused(job(c, &bad), NETMESH_FIELD_POINT_STRIDE_BYTES);
        }
        points.stride_bytes = 0;
        for (const int off : {1, 2, 3}) {
            points.coordinates = static_cast<const char*>(good.points.coordinates) + off;
            refused(job(c, &bad), NETMESH_FIELD_POINTS);
        }
        points.format = NETMESH_POINTS_FLOAT64;
        points.coordinates = static_cast<const char*>(good.points.coordinates) + 2;
        refused(job(c, &bad), NETMESH_FIELD_POINTS);
    }
    Session session;
    inputs::Points points;
    netmesh_context* c;
    std::uint64_t fingerprint;
};
