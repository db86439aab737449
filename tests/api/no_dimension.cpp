// Dimensions that are none: jobs refuse them by the field `dim` before they read a point, plans are 0.
#include <doctest/doctest.h>

#include <cstdint>
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

using Plan = std::size_t (*)(const netmesh_request*);

// A request without points has dimension 0; netmesh_mesh alone refuses it.
void refuses(Fixture& f, netmesh::Request request, std::uint32_t dim, Fixture::Job job, Plan plan) {
    const OwnPoints points(dim);
    // As whoever computes the count with the dimension has it, whoever does not, and without points.
    for (const std::size_t count : {points.count, std::size_t{0}, Fixture::many}) {
        request.points = {points.place, count, dim, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
        f.refused(job(f.c, &request), NETMESH_FIELD_DIM);
        CHECK(plan(&request) == 0);
        request.points.coordinates = nullptr;
        if (dim != 0 || count != 0 || job == netmesh_mesh) f.refused(job(f.c, &request), NETMESH_FIELD_DIM);
        CHECK(plan(&request) == 0);
    }
}
void refuses(Fixture& f, const netmesh::Request& request, std::uint32_t dim) {
    refuses(f, request, dim, netmesh_persist, netmesh_plan);
}

}  // namespace

TEST_CASE("a dimension that is none is refused by every call and every plan") {
    Fixture f(3);
    for (const std::uint32_t dim : none_of_all) {
        CAPTURE(dim);
        netmesh::Request mesh;
        for (const netmesh_method* const method :
             {&netmesh_method_delaunay, &netmesh_method_svr, &netmesh_method_netmesh, &netmesh_method_thesis,
              &netmesh_method_refine, &netmesh_method_certificate}) {
            mesh.mesh.method = method;
            refuses(f, mesh, dim, netmesh_mesh, netmesh_plan_mesh);
        }
        netmesh::Request by_ratio(&netmesh_filter_complete);
        by_ratio.goal.ratio = 3;
        refuses(f, by_ratio, dim, netmesh_mesh, netmesh_plan_mesh);
        refuses(f, by_ratio, dim);
        netmesh::Request fit(&netmesh_filter_complete);
        fit.fit = &netmesh_fit;
        refuses(f, fit, dim);
        for (const netmesh_filter* const filter :
             {&netmesh_filter_auto, &netmesh_filter_alpha, &netmesh_filter_complete, &netmesh_filter_basic,
              &netmesh_filter_knn, &netmesh_filter_kdistance, &netmesh_filter_function, &netmesh_filter_tight,
              &netmesh_filter_scales, &netmesh_filter_rips, &netmesh_filter_cech, &netmesh_filter_barycentric_cech,
              &netmesh_filter_barycentric_rips}) {
            if (filter == &netmesh_filter_rips && dim > NETMESH_DIM_MAX && dim <= NETMESH_RIPS_DIM_MAX) continue;
            refuses(f, netmesh::Request(filter), dim);
        }
        for (const netmesh_filter* const filter :
             {&netmesh_filter_barycentric_cech, &netmesh_filter_barycentric_rips}) {
            netmesh::Request nested(filter);
            nested.vines = &netmesh_vines;
            refuses(f, nested, dim);
        }
        auto settled = netmesh::sized<netmesh_request>();
        auto detail = netmesh::sized<netmesh_detail>();
        by_ratio.points = {nullptr, 5, dim, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
        CHECK(netmesh_settle(&by_ratio, &settled, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.field == NETMESH_FIELD_DIM);
        CHECK(settled.mesh.tau == 0);

        auto load = netmesh::sized<netmesh_load_request>();
        load.dim = dim;
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

        // What is promised: of the dimension of the mesh, or of none and without points.
        const netmesh_field field = dim == 0 ? NETMESH_FIELD_DIM : NETMESH_FIELD_PROMISED;
        mesh.points = {vertices.place, vertices.count, dim, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
        auto check = netmesh::sized<netmesh_check_request>();
        check.promised = &mesh;
        f.refused(netmesh_check(f.c, &check), field);
        auto analyse = netmesh::sized<netmesh_analyse_request>();
        analyse.promised = &mesh;
        auto analysis = netmesh::sized<netmesh_analysis>();
        f.refused(netmesh_analyse(f.c, &analyse, &analysis), field);
    }
}

TEST_CASE("Rips complexes of many coordinates, to the last dimension and not beyond") {
    Fixture f(3);
    netmesh::Request rips(&netmesh_filter_rips);
    for (const std::uint32_t dim : {NETMESH_DIM_MAX + 1u, NETMESH_RIPS_DIM_MAX + 0u}) {
        rips.points.dim = dim;
        rips.points.count = 3;
        CHECK(netmesh_plan(&rips) > 0);
    }
    refuses(f, rips, NETMESH_RIPS_DIM_MAX + 1u);
}

TEST_CASE("a dimension that is none, in C++") {
    Fixture f(3);
    for (const std::uint32_t dim : none_of_all) {
        CAPTURE(dim);
        const inputs::Points points(21, 1.0);
        netmesh::Request mesh;
        mesh.mesh.method = &netmesh_method_svr;
        mesh.set_points(dim, points);
        CHECK(mesh.points.dim == dim);
        f.refused(netmesh_mesh(f.c, &mesh), NETMESH_FIELD_DIM);
    }
}
