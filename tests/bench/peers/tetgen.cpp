#include <algorithm>
#include <cstdio>

#define TETLIBRARY
#include <tetgen.h>

#include "contestants.hpp"

namespace bench {

void tetgen_mesh(Trial& trial, const inputs::Points& points, double ratio) {
    tetgenio in, out;
    in.numberofpoints = static_cast<int>(points.size() / 3);
    in.pointlist = new REAL[points.size()];
    std::copy(points.begin(), points.end(), in.pointlist);
    char switches[32];
    std::snprintf(switches, sizeof switches, "q%gQ", ratio);
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
    measure_aspect(trial, coordinates, tets, {});
}

}  // namespace bench
