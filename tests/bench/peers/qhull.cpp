#include <cstdio>
#include <cstdlib>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "contestants.hpp"

namespace bench {

// As the program `qdelaunay Qbb Qc Qz` does it: the lower hull of the points lifted to a paraboloid, scaled and with a
// point at infinity. Facets that Qhull merges, as it does where cells are nearly flat or cospherical, count once.
void qhull_delaunay(Trial& trial, int dim, const inputs::Points& points) {
    qhT state;
    qhT* const qh = &state;
    qh_zero(qh, stderr);
    std::vector<double> rows = points;  // qhull may write to what it is given
    char command[] = "qhull d Qbb Qc Qz";
    trial.start();
    const int failed =
        qh_new_qhull(qh, dim, static_cast<int>(points.size()) / dim, rows.data(), False, command, nullptr, stderr);
    trial.stop();
    if (failed != 0) std::exit(1);
    double count = 0;
    facetT* facet;
    FORALLfacets {
        if (!facet->upperdelaunay) ++count;
    }
    trial.figure(cells, count);
    qh_freeqhull(qh, qh_ALL);
}

}  // namespace bench
