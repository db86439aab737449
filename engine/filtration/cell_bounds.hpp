// What the complete and the basic filter know of each cell: mesh_filter.hpp.
#pragma once
#include "certificate/cells.hpp"
#include "filtration/any_mesh.hpp"

namespace netmesh {

struct CellBounds {
    const AnyMesh& mesh;
    const AnyStore& store;
    double rho;
    double* out_radius;     // R_v, or more
    double* steiner_reach;  // without inputs: largest distance from a point of v's cell to v's nearest input, or more

    double& reach(VertexId v) const { return steiner_reach[v - mesh.inputs]; }

    // lo_v and hi_v, both cut at rho; of an absent vertex what holds of any cell.
    [[gnu::noinline]] Interval interval(VertexId v) const {
        const AnyVertex vertex = store.vertex(v);
        const bool bounded = vertex.marker != Marker::exempt && mesh.has(v);
        if (vertex.marker == Marker::input)
            return cut_at(rho, input_interval(square_root(vertex.nearest2), out_radius[v]));
        const double d = distance_to_inputs(store, v);
        return cut_at(rho, bounded ? steiner_interval(d, out_radius[v], reach(v)) : unbounded_interval(d));
    }
    // The thesis's own value: s of 7.4.2.
    [[gnu::noinline]] double own_value(VertexId v) const {
        const AnyVertex vertex = store.vertex(v);
        const double s =
            vertex.marker == Marker::input ? 0.5 * square_root(vertex.nearest2) : distance_to_inputs(store, v);
        return s < rho ? s : rho;
    }
};

}  // namespace netmesh
