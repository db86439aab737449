// Dimensions that are none. Init calls keep them, jobs refuse them by the field `dim` before they read a point, plans
// are 0.
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <memory>

#include "refusals.hpp"

namespace {

constexpr std::uint32_t none_of_all[] = {0, 1, NETMESH_DIM_MAX + 1, 8, 100, 1u << 31, UINT32_MAX};

// Points of `dim` coordinates each in memory that ends with the last of them, for the address sanitizer to see whoever
// reads on.
struct OwnPoints {
    explicit OwnPoints(std::uint32_t dim, std::size_t count = 5)
        : count(count), x(new double[count * (dim < 16 ? dim : 16) + 1]) {
        for (std::size_t i = 0; i < count * (dim < 16 ? dim : 16); ++i) x[i] = static_cast<double>(i * i % 11);
        place = x.get() + (dim == 0 ? 1 : 0);
    }
    std::size_t count;
    std::unique_ptr<double[]> x;
    const double* place;
};

template <class Request, class Job>
void refuses(Fixture& f, Request request, std::uint32_t dim, Job job, std::size_t (*plan)(const Request*)) {
    CHECK(request.dim == dim);
    const OwnPoints points(dim);
    // As whoever computes the count with the dimension has it, whoever does not, and without points.
    for (const std::size_t count : {points.count, std::size_t{0}, Fixture::many}) {
        request.points = points.place;
        request.point_count = count;
        f.refused(job(f.c, &request), NETMESH_FIELD_DIM);
        if (plan != nullptr) CHECK(plan(&request) == 0);
        request.points = nullptr;
        f.refused(job(f.c, &request), NETMESH_FIELD_DIM);
    }
}

}  // namespace

TEST_CASE("a dimension that is none is refused by every call and every plan") {
    Fixture f(3);
    for (const std::uint32_t dim : none_of_all) {
        CAPTURE(dim);
        netmesh_delaunay_request delaunay = {};
        netmesh_delaunay_request_init(&delaunay, sizeof delaunay, dim);
        refuses(f, delaunay, dim, netmesh_delaunay, netmesh_plan_delaunay);

        netmesh_mesh_request mesh = {};
        netmesh_mesh_request_init(&mesh, sizeof mesh, dim);
        for (const netmesh_method method : {NETMESH_METHOD_SVR, NETMESH_METHOD_HIERARCHY, NETMESH_METHOD_REFINE}) {
            mesh.method = method;
            refuses(f, mesh, dim, netmesh_mesh, netmesh_plan_mesh);
        }
        mesh.certificate.ratio = 3;
        refuses(f, mesh, dim, netmesh_mesh, netmesh_plan_mesh);
        CHECK(netmesh_tau(&mesh) == 0);

        netmesh_alpha_request alpha = {};
        netmesh_alpha_request_init(&alpha, sizeof alpha, dim);
        refuses(f, alpha, dim, netmesh_persist_alpha, netmesh_plan_alpha);

        netmesh_auto_request either = {};
        netmesh_auto_request_init(&either, sizeof either, dim);
        refuses(f, either, dim, netmesh_persist_auto, netmesh_plan_auto);

        netmesh_fit_request fit = {};
        netmesh_fit_request_init(&fit, sizeof fit, dim);
        refuses<netmesh_fit_request>(f, fit, dim, netmesh_fit, nullptr);

        netmesh_scales_request scales = {};
        netmesh_scales_request_init(&scales, sizeof scales, dim);
        refuses(f, scales, dim, netmesh_persist_scales, netmesh_plan_scales);

        for (const netmesh_filter filter : {NETMESH_FILTER_RIPS, NETMESH_FILTER_CECH, NETMESH_FILTER_BARYCENTRIC_CECH,
                                            NETMESH_FILTER_BARYCENTRIC_RIPS}) {
            netmesh_points_request points = {};
            netmesh_points_request_init(&points, sizeof points, dim, filter);
            CHECK(points.dim == dim);
            if (filter == NETMESH_FILTER_RIPS && dim > NETMESH_DIM_MAX && dim <= NETMESH_RIPS_DIM_MAX) continue;
            refuses(f, points, dim, netmesh_persist_points, netmesh_plan_points);
        }
        for (const netmesh_filter filter : {NETMESH_FILTER_BARYCENTRIC_CECH, NETMESH_FILTER_BARYCENTRIC_RIPS}) {
            netmesh_points_vineyard_request nested = {};
            netmesh_points_vineyard_request_init(&nested, sizeof nested, dim, filter);
            refuses(f, nested, dim, netmesh_points_vineyard, netmesh_plan_points_vineyard);
        }

        netmesh_load_request load = {};
        netmesh_load_request_init(&load, sizeof load, dim);
        CHECK(load.dim == dim);
        const OwnPoints vertices(dim);
        const std::uint8_t marker[5] = {};
        const std::uint32_t cell[1] = {0};
        const double domain[1] = {1};
        load.vertices = vertices.place;
        load.vertex_count = vertices.count;
        load.markers = marker;
        load.cells = cell;
        load.cell_count = 1;
        load.domain = domain;
        f.refused(netmesh_load(f.c, &load), NETMESH_FIELD_DIM);
        load.vertices = nullptr;
        load.vertex_count = load.cell_count = 0;
        f.refused(netmesh_load(f.c, &load), NETMESH_FIELD_DIM);

        // Requests that point to a mesh request.
        netmesh::requests::Check check;
        check.mesh = &mesh;
        f.refused(netmesh_check(f.c, &check), NETMESH_FIELD_DIM);
        netmesh::requests::Analyse analyse;
        analyse.mesh = &mesh;
        auto analysis = netmesh::sized<netmesh_analysis>();
        f.refused(netmesh_analyse(f.c, &analyse, &analysis), NETMESH_FIELD_DIM);
    }
}

TEST_CASE("Rips complexes of many coordinates, to the last dimension and not beyond") {
    Fixture f(3);
    for (const std::uint32_t dim : {NETMESH_DIM_MAX + 1u, NETMESH_RIPS_DIM_MAX + 0u}) {
        netmesh_points_request points = {};
        netmesh_points_request_init(&points, sizeof points, dim, NETMESH_FILTER_RIPS);
        CHECK(points.dim == dim);
        points.point_count = 3;
        CHECK(netmesh_plan_points(&points) > 0);
    }
    netmesh_points_request points = {};
    netmesh_points_request_init(&points, sizeof points, NETMESH_RIPS_DIM_MAX + 1u, NETMESH_FILTER_RIPS);
    refuses(f, points, NETMESH_RIPS_DIM_MAX + 1u, netmesh_persist_points, netmesh_plan_points);
}

TEST_CASE("a dimension that is none, in C++") {
    Fixture f(3);
    for (const std::uint32_t dim : none_of_all) {
        CAPTURE(dim);
        CHECK(netmesh::requests::Delaunay(dim).dim == dim);
        const inputs::Points points(21, 1.0);
        const netmesh::requests::Mesh mesh = [&] {
            netmesh::requests::Mesh r(dim);
            netmesh::set_points(&r, points);
            return r;
        }();
        f.refused(netmesh_mesh(f.c, &mesh), NETMESH_FIELD_DIM);
    }
}
