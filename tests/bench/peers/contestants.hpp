// Who takes part. A peer that is not installed is not compiled; main.cpp asks the macros.
#pragma once
#include "trial.hpp"

namespace bench {

// Delaunay triangulation; figure: cells (finite).
void ours_delaunay(Trial& trial, int dim, const inputs::Points& points);
void cgal_delaunay_2(Trial& trial, const inputs::Points& points);
void cgal_delaunay_3(Trial& trial, const inputs::Points& points);
void cgal_delaunay_d(Trial& trial, int dim, const inputs::Points& points);  // 4..6
void hxt_delaunay_3(Trial& trial, const inputs::Points& points);
void qhull_delaunay(Trial& trial, int dim, const inputs::Points& points);
const char* cgal_version();

// Quality mesh of 3D points; figures: vertices, cells, aspect_worst, aspect_mean.
void ours_mesh(Trial& trial, const inputs::Points& points, double tau);
void tetgen_mesh(Trial& trial, const inputs::Points& points, double ratio);  // radius-edge ratio

// Persistence of the complete filter on the mesh of `points`; the mesh itself is not timed. Figures: simplices, and for
// PHAT build_seconds, the time from the mesh to its boundary matrix. Both give the diagram without zero-length pairs.
void ours_persist(Trial& trial, int dim, const inputs::Points& points, double tau);
void phat_persist(Trial& trial, int dim, const inputs::Points& points, double tau, bool chunk);

// From points to the diagram of the alpha complex.
void ours_alpha(Trial& trial, int dim, const inputs::Points& points);
void gudhi_alpha(Trial& trial, int dim, const inputs::Points& points);  // 2..4

// With weights: regular triangulation; figures: cells (finite), hidden. Diagram of powers; figure: simplices.
void ours_regular(Trial& trial, int dim, const inputs::Points& points, const inputs::Points& weights);
void cgal_regular_2(Trial& trial, const inputs::Points& points, const inputs::Points& weights);
void cgal_regular_3(Trial& trial, const inputs::Points& points, const inputs::Points& weights);
void ours_weighted_alpha(Trial& trial, int dim, const inputs::Points& points, const inputs::Points& weights);
void gudhi_weighted_alpha(Trial& trial, int dim, const inputs::Points& points, const inputs::Points& weights);  // 2, 3

// Points in the unit cube with all periods. Ours and GUDHI's are diagrams; figure: simplices. CGAL's are Delaunay
// triangulations alone; figure: cells.
void ours_periodic_alpha(Trial& trial, int dim, const inputs::Points& points);
void gudhi_periodic_alpha_3(Trial& trial, const inputs::Points& points);
void cgal_periodic_2(Trial& trial, const inputs::Points& points);
void cgal_periodic_3(Trial& trial, const inputs::Points& points);

}  // namespace bench
