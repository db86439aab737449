// Filtered complexes that files hold whole, and the cycles that --representatives writes.
#pragma once
#include "../mesh_file.hpp"
#include "../verdict.hpp"
#include "complex.hpp"
#include "diagram_file.hpp"

namespace referee {

struct ValuedComplex {
    Complex complex;            // reduced; ranks are places in `radii`
    std::vector<double> radii;  // ascending, all different
    int top = 0;                // degrees of homology
};

// The mesh that was filtered: a simplex enters with the largest value of its vertices, but with `inputs_first` each
// input's own vertex at 0. Of a clipped mesh only the simplices whose dual faces meet the ball enter (nerve.hpp).
// False: more than `most` simplices.
bool lower_star(const Mesh& mesh, bool inputs_first, int top, std::size_t most, ValuedComplex* out);

// Rips and Cech complexes of points, radii rounded, and those within 2^-40 of one another taken for equal.
ValuedComplex rips_complex(const std::vector<Point>& points, int dim, int top);
ValuedComplex cech_complex(const std::vector<Point>& points, int dim, int top);

// Every bar of the diagram is a pair of the complex and the other way round; radii bit for bit.
void judge_pairs(const DiagramFile& diagram, const ValuedComplex& due, Verdict* verdict);

// A cycle for each bar, in their order: simplices of the complex, boundary zero; the last one enters with the birth,
// and it becomes a boundary at the death (`slack`: to this part of the radius). In degree 0 a vertex and an older one.
void judge_cycles(const DiagramFile& diagram, const std::vector<Cycle>& cycles, const ValuedComplex& within,
                  double slack, Verdict* verdict);

// Of a diagram that is joined of scales, a cycle of the Cech complex for each bar (b, d) of some length: boundary zero,
// born at c b at the latest, no boundary before d / c and one from c d on, c the certified ratio. None is needed where
// d <= c^2 b. In degree 0 a point, and another one for a bar that dies.
void judge_point_cycles(const DiagramFile& diagram, const std::vector<Cycle>& cycles, const ValuedComplex& within,
                        Verdict* verdict);

}  // namespace referee
