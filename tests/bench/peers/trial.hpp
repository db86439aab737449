// One measured run in a forked child: CPU seconds between start() and stop(), and how far the resident set grew.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "common/inputs.hpp"
#include "common/read.hpp"

namespace bench {

enum Figure {
    cells,
    vertices,
    simplices,
    hidden,
    aspect_worst,
    aspect_mean,
    aspect_clipped,
    build_seconds,
    arena_bytes,
    figure_count
};

struct Outcome {
    bool finished = false;
    double seconds = 0.0;  // CPU, user and system, between start and stop
    double bytes = 0.0;    // largest resident set up to stop, less the resident set at start
    std::array<double, figure_count> figures = {};
    std::vector<netmesh_pair> diagram;
};

class Trial {
public:
    // What comes before start (inputs, conversions) and after stop (reading results) is not measured.
    void start();
    void stop();
    void figure(Figure which, double value) { outcome.figures[which] = value; }

    Outcome outcome;

private:
    double cpu_ = 0.0, resident_ = 0.0;
};

using Contestant = std::function<void(Trial&)>;

// Runs it in a child, so that nothing of one run is left for the next. `finished` is false when the child died.
Outcome run(const Contestant& contestant);

// Resident set of this process now, after freed memory went back to the system.
double resident_bytes();

// Aspect ratio R/r of the Voronoi cells of the vertices that are not on the hull: R to the farthest circumcentre of its
// tetrahedra, r half the distance to the nearest neighbour. With a ball (centre, radius), only of cells with all
// corners in it. Sets aspect_worst and aspect_mean.
void measure_aspect(Trial& trial, const std::vector<double>& points,
                    const std::vector<std::array<std::uint32_t, 4>>& tets, const double* ball);

}  // namespace bench
