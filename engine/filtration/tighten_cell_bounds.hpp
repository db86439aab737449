// The least and the largest distance from the Voronoi cell of a Steiner vertex to the inputs, narrower than the bounds
// of certificate/interval.hpp, which know the cell by its out-radius and one corner alone.
//
// Let Y be the corners of v's cell, so Vor(v) = conv Y.
//
//   lo  dist(p, Vor(v)) >= w.p - max over y in Y of w.y for every unit vector w; the best w comes from the point of
//   conv Y
//       nearest to p (Wolfe's algorithm). The minimum over all inputs is searched in the tree of the inputs with the
//       directions found so far, which bound whole boxes of inputs at once.
//   hi  min over p of |x - p|^2 <= sum of lambda_p |x - p|^2 for any weights lambda >= 0 of sum 1, a convex function of
//   x,
//       so largest at a corner. Weights go step by step to the input nearest to the corner that is worst.
//
// Whatever directions and weights are found, the bounds hold; all are rounded outwards, by the corners' own errors too.
// A cell next to an input has lo = d_P / 2 and often no second input near its far end, so the worst ratio of a mesh
// does not change; larger scales gain. Inputs' bounds are exact as they are.
#pragma once
#include "filtration/any_mesh.hpp"
#include "geometry/nearest_in_hull.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

// One cell after the other.
class CellTightener {
public:
    // Over the inputs in the tree, for intervals of min(d_P, cut).
    CellTightener(const AnyStore& store, const AnyInputTree& tree, double cut, Arena& arena)
        : dim(store.dim), store_(store), tree_(tree), cut_(cut), arena_(arena) {}

    // Scratch at the arena's high end. out_of_memory.
    Status open();
    // Narrows the interval of a Steiner vertex, an end no more than to `enough`, {infinity, 0} for as far as it goes.
    // out_of_memory: no room to visit its star.
    Status tighten(VertexId v, const Interval& enough, Interval* interval);

private:
    // A range of the tree and a box that holds it.
    struct Part {
        TreeRange range;
        double low[dimension_max], high[dimension_max];
    };
    template <int D> Status tighten_in(VertexId v, const Interval& enough, Interval* interval);
    template <int D> bool gather(VertexId v, bool* known);
    template <int D> double input_distance_low(VertexId v, double least, double enough);
    template <int D> double input_distance_high(VertexId v, double enough);
    template <int D> void from_vertex(std::uint32_t input, double* q) const {
        const double* const p = store_.point(input);
        for (int k = 0; k < dimension<D>(); ++k) q[k] = p[k] - at_[k];
    }
    template <int D> void bound_input(std::uint32_t input);
    template <int D> double box_distance(const Part& part) const;
    template <int D> double farthest_corner(const double* mean, double square, std::uint32_t* corner) const;
    // A constant where the compiler knows it.
    template <int D> int dimension() const { return D == any_dimension ? dim : D; }

    const int dim;
    const AnyStore& store_;
    const AnyInputTree& tree_;
    double cut_;
    Arena& arena_;

    const double* at_ = nullptr;  // the vertex; lengths and points are relative to it
    double* corner_ = nullptr;    // [corners_][dim]
    std::uint32_t corners_ = 0;
    std::uint32_t* degree_ = nullptr;    // [vertex] corners of its cell, 0 on the hull
    double out_radius_ = 0, doubt_ = 0;  // largest distance and error of a corner

    static constexpr std::uint32_t kept = 8;
    HalfSpace half_space_[kept];
    std::uint32_t half_spaces_ = 0;
    double least_ = 0;      // least distance of an input from the cell so far
    bool decides_ = false;  // whether no distance is needed better than to see that it is not less
};

// Narrows interval[v] of every Steiner vertex whose cell's corners are known; intervals hold for min(d_P, mesh.cut()).
// By whole cells, also where they are clipped: what holds there holds of a part. Absent vertices keep theirs. Marks of
// cells are used. About 10-20 us a vertex in D = 4. Scratch: 4 bytes a vertex, 5 an input, 8 D a corner of the largest
// cell. out_of_memory, cancelled.
Status tighten_cell_bounds(const AnyMesh& mesh, const Work& work, Interval* interval);

}  // namespace netmesh
