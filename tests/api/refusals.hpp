// A context with a mesh, and what it says to arguments that it cannot use: the mesh stays.
#pragma once
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>

#include "common/session.hpp"

struct Fixture {
    static constexpr std::size_t many = NETMESH_POINTS_MAX + 1;

    explicit Fixture(int dim) : session(dim), points(inputs::uniform(dim, 3)), c(session.context) {
        session.reserve(std::size_t{1} << 22);
        REQUIRE(session.mesh(points, NETMESH_PURPOSE_PERSIST) == NETMESH_OK);
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
    // A job refuses a null request, one without a size, and one that is larger and holds what nobody knows.
    template <class Request> void needs_request(netmesh_status (*job)(netmesh_context*, const Request*), Request good) {
        refused(job(c, nullptr), NETMESH_FIELD_REQUEST);
        for (const std::uint32_t bytes : {0u, 3u, 1u << 20}) {
            Request bad = good;
            bad.struct_bytes = bytes;
            refused(job(c, &bad), NETMESH_FIELD_STRUCT_BYTES);
        }
        struct {
            Request request;
            std::uint64_t later;
        } newer = {good, 1};
        newer.request.struct_bytes = sizeof newer;
        refused(job(c, &newer.request), NETMESH_FIELD_STRUCT_BYTES);
    }
    // A job on points refuses these.
    template <class Request> void needs_points(netmesh_status (*job)(netmesh_context*, const Request*), Request good) {
        needs_request(job, good);
        Request bad = good;
        bad.points = nullptr;
        refused(job(c, &bad), NETMESH_FIELD_POINTS);
        for (const std::size_t count : {std::size_t{0}, many}) {
            bad = good;
            bad.point_count = count;
            refused(job(c, &bad), NETMESH_FIELD_POINT_COUNT);
        }
        for (const std::uint32_t d : {1u, 7u}) {
            bad = good;
            bad.dim = d;
            refused(job(c, &bad), NETMESH_FIELD_DIM);
        }
        needs_rows(job, good);
    }
    // Formats, addresses and strides that no rows have.
    template <class Request> void needs_rows(netmesh_status (*job)(netmesh_context*, const Request*), Request good) {
        const std::size_t row = good.dim * sizeof(double);
        Request bad = good;
        for (const int format : {-1, 2}) {
            std::memcpy(&bad.point_format, &format, sizeof format);
            refused(job(c, &bad), NETMESH_FIELD_POINT_FORMAT);
        }
        bad = good;
        for (const std::size_t stride : {std::size_t{1}, row - 8, row + 2, row + 3, SIZE_MAX / 2 / 8 * 8}) {
            bad.point_stride_bytes = stride;
            refused(job(c, &bad), NETMESH_FIELD_POINT_STRIDE_BYTES);
        }
        bad.point_format = NETMESH_POINTS_FLOAT32;
        for (const std::size_t stride : {std::size_t{4}, row / 2 - 4, row / 2 + 2, SIZE_MAX - 3}) {
            bad.point_stride_bytes = stride;
            refused(job(c, &bad), NETMESH_FIELD_POINT_STRIDE_BYTES);
        }
        bad.point_stride_bytes = 0;
        for (const int off : {1, 2, 3}) {
            bad.points = static_cast<const char*>(good.points) + off;
            refused(job(c, &bad), NETMESH_FIELD_POINTS);
        }
        bad.point_format = NETMESH_POINTS_FLOAT64;
        bad.points = static_cast<const char*>(good.points) + 2;
        refused(job(c, &bad), NETMESH_FIELD_POINTS);
    }
    Session session;
    inputs::Points points;
    netmesh_context* c;
    std::uint64_t fingerprint;
};
