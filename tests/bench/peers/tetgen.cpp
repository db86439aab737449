#include <algorithm>
#include <cstdio>

#define TETLIBRARY
#include <tetgen.h>

#include "contestants.hpp"

namespace bench {

// TetGen refines inside a boundary: a box of twice the extent of the unit cube in which the points lie. With the cube
// itself, or with the hull of the points, it puts in two to three times as many vertices.
void tetgen_mesh(Trial& trial, const inputs::Points& points, double ratio) {
    tetgenio in, out;
    const int corners = 8;
    in.numberofpoints = corners + static_cast<int>(points.size() / 3);
    in.pointlist = new REAL[points.size() + 3 * corners];
    for (int c = 0; c < corners; ++c)
        for (int a = 0; a < 3; ++a) in.pointlist[3 * c + a] = (c >> a & 1) ? 1.5 : -0.5;
    std::copy(points.begin(), points.end(), in.pointlist + 3 * corners);
    const int sides[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    in.numberoffacets = 6;
    in.facetlist = new tetgenio::facet[6];
    for (int f = 0; f < 6; ++f) {
        tetgenio::facet& facet = in.facetlist[f];
        tetgenio::init(&facet);
        facet.numberofpolygons = 1;
        facet.polygonlist = new tetgenio::polygon[1];
        tetgenio::init(facet.polygonlist);
        facet.polygonlist->numberofvertices = 4;
        facet.polygonlist->vertexlist = new int[4];
        std::copy(sides[f], sides[f] + 4, facet.polygonlist->vertexlist);
    }
    char switches[32];
    std::snprintf(switches, sizeof switches, "pq%gQ", ratio);
    trial.start();
    tetrahedralize(switches, &in, &out);
    trial.stop();
    trial.figure(vertices, out.numberofpoints);
    trial.figure(cells, out.numberoftetrahedra);
    const std::vector<double> coordinates(out.pointlist, out.pointlist + 3 * out.numberofpoints);
    std::vector<std::array<std::uint32_t, 4>> tets(static_cast<std::size_t>(out.numberoftetrahedra));
    for (std::size_t t = 0; t < tets.size(); ++t)
        for (std::size_t i = 0; i < 4; ++i)
            tets[t][i] = static_cast<std::uint32_t>(out.tetrahedronlist[4 * t + i] - out.firstnumber);
    measure_aspect(trial, coordinates, tets, nullptr);
}

}  // namespace bench
