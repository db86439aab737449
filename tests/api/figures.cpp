// The list of figures of reports and analyses, against the structs that it describes.
#include <doctest/doctest.h>

#include <cstring>
#include <map>
#include <string>

#include "common/session.hpp"

namespace {

struct Figures {
    template <class Struct> explicit Figures(const Struct& of) {
        const auto* const begin = reinterpret_cast<const unsigned char*>(&of);
        netmesh::for_each_figure(of, [&](const netmesh_figure& figure) {
            CAPTURE(figure.path);
            const auto* const values = static_cast<const unsigned char*>(figure.values);
            const std::size_t bytes = figure.type == NETMESH_FIGURE_FLAG || figure.type == NETMESH_FIGURE_UINT32 ||
                                              figure.type == NETMESH_FIGURE_NAME
                                          ? 4
                                          : 8;
            CHECK(values >= begin);
            CHECK(values + bytes * figure.count <= begin + sizeof of);
            CHECK((figure.is_array == 1 || figure.count == 1));
            CHECK((figure.text != nullptr) == (figure.type == NETMESH_FIGURE_NAME));
            CHECK(all.emplace(figure.path, figure).second);  // once
            const std::string path = figure.path, part = path.substr(0, path.find('.'));
            if (part != last) CHECK(parts.emplace(part, 0).second);  // parts are whole
            last = part;
        });
    }
    const netmesh_figure& operator[](const char* path) const {
        CAPTURE(path);
        REQUIRE(all.count(path) == 1);
        return all.at(path);
    }
    double real(const char* path) const { return *static_cast<const double*>((*this)[path].values); }
    std::uint64_t number(const char* path) const { return *static_cast<const std::uint64_t*>((*this)[path].values); }
    bool applies(const char* path) const { return (*this)[path].applies == 1; }

    std::map<std::string, netmesh_figure> all;
    std::map<std::string, int> parts;
    std::string last;
};

}  // namespace

TEST_CASE("figures of a report apply where their results are") {
    Session s(2);
    {
        const netmesh_report nothing = s.report();
        const Figures figures(nothing);
        CHECK(figures.applies("memory.block_bytes"));
        for (const char* path : {"input.points", "mesh.vertices", "diagram.pairs", "vineyard.vines", "fingerprint"})
            CHECK(!figures.applies(path));
    }
    s.bounds = true;
    REQUIRE(s.mesh_and_persist(inputs::uniform(2, 30)) == NETMESH_OK);
    const netmesh_report r = s.report();
    const Figures figures(r);
    CHECK(figures.number("mesh.vertices") == r.mesh.vertices);
    CHECK(figures.number("mesh.exempt") == r.mesh.exempt);
    CHECK(figures.real("diagram.certified_ratio") == r.diagram.certified_ratio);
    CHECK(figures["diagram.certified_ratio"].in_fingerprint == 1);
    CHECK(figures["mesh.domain"].count == 3);
    CHECK(figures["diagram.pairs"].count == r.diagram.max_degree + 1);
    CHECK(figures["diagram.certain"].count == r.diagram.max_degree + 1);
    CHECK(std::strcmp(figures["diagram.filter"].text, "complete") == 0);
    CHECK(std::strcmp(figures["diagram.values"].text, "certified") == 0);
    CHECK(std::strcmp(figures["mesh.method"].text, "svr") == 0);
    for (const char* path : {"input.points", "mesh.tau", "mesh.domain", "diagram.certain", "predicates.orient.float"})
        CHECK(figures.applies(path));
    for (const char* path :
         {"mesh.ratio", "mesh.cages", "mesh.audit.location.load", "diagram.scales.count", "diagram.k"})
        CHECK(!figures.applies(path));
    CHECK(figures["mesh.ratio"].on_request == 1);
    CHECK(figures["mesh.tau"].on_request == 0);
    std::uint64_t certain = 0;
    for (const netmesh_bar_bounds& b : read_all(s.context, netmesh_get_bar_bounds)) certain += b.certain;
    CHECK(r.bounds.certain[0] + r.bounds.certain[1] == certain);

    REQUIRE(s.delaunay(inputs::uniform(2, 30)) == NETMESH_OK);
    const netmesh_report d = s.report();
    const Figures of_triangulation(d);
    CHECK(of_triangulation.applies("mesh.cells"));
    CHECK(!of_triangulation.applies("mesh.tau"));
    CHECK(!of_triangulation.applies("mesh.method"));
}

TEST_CASE("figures of an analysis, and what its fingerprint is made of") {
    Session s(2);
    REQUIRE(s.mesh(inputs::uniform(2, 30)) == NETMESH_OK);
    netmesh_analysis a;
    REQUIRE(s.analyse(&a) == NETMESH_OK);
    const Figures figures(a);
    CHECK(figures.number("size.vertices") == a.size.vertices);
    CHECK(figures["size.radii"].count == 3);
    CHECK(figures.real("fatness.inside.beta_max") == a.fatness.inside.beta_max);
    for (const auto& [path, figure] : figures.all) {
        CAPTURE(path);
        CHECK(figure.applies == 1);
        // What follows from other figures is not in it.
        const bool derived = path == "size.upper_over_lower" || path == "size.domains";
        CHECK((figure.in_fingerprint == 1) == (path != "fingerprint" && !derived));
    }
    REQUIRE(s.analyse(&a, NETMESH_ANALYSE_STRUCTURE) == NETMESH_OK);
    const Figures structure(a);
    CHECK(structure.applies("structure.ply_max"));
    CHECK(!structure.applies("size.theta"));
    CHECK(!structure.applies("fatness.clipped_cells"));
}

TEST_CASE("the table of filters") {
    std::uint32_t index = 0;
    netmesh::for_each_filter([&](const netmesh_filter_info& info) {
        CAPTURE(info.name);
        CHECK(static_cast<std::uint32_t>(info.id) == ++index);
        CHECK(info.reference[0] != 0);
        CHECK((std::strstr(info.reference, "{k}") != nullptr) == (info.needs_k == 1));
        CHECK(info.is_on_mesh + info.is_on_triangulation + info.is_on_points + info.is_by_scales == 1);
        CHECK(filter_of(info.id) == info.filter);
        if (info.is_on_mesh == 0) CHECK(info.has_vineyard + info.has_goal + info.bounds_by_scale == 0);
        // Refused for what the table says, and for nothing else.
        if (info.is_on_points + info.is_by_scales + info.needs_function > 0) return;
        Session s(2);
        const inputs::Points points = inputs::uniform(2, 8);
        REQUIRE((info.is_on_mesh == 1 ? s.mesh(points, info.filter) : s.delaunay(points)) == NETMESH_OK);
        REQUIRE(s.persist(info.filter) == NETMESH_OK);
        CHECK((s.report().diagram.k > 0) == (info.needs_k == 1));
        CHECK((s.represent() == NETMESH_OK) == (info.has_representatives == 1));
        CHECK((s.vineyard(info.filter, 1, 2) == NETMESH_OK) == (info.has_vineyard == 1));
    });
    CHECK(index >= NETMESH_FILTER_BARYCENTRIC_RIPS);  // new filters come after it
}
