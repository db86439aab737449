#include "mesh/loop/separation.hpp"

namespace netmesh {
namespace {

// The largest coordinate in absolute value.
double magnitude_of(int dim, const double* x) {
    double most = 0;
    for (int k = 0; k < dim; ++k)
        if (absolute(x[k]) > most) most = absolute(x[k]);
    return most;
}

}  // namespace

Status check_separation(const AnyStore& store, const AnyInputTree& tree, double finest, InputReport* input) {
    const std::uint32_t inputs = store.state.vertex_count;
    for (std::uint32_t v = 0; v < inputs;)
        for (const std::uint64_t piece = store.arena.piece(v, inputs, 10 * store.dim); v < piece; ++v) {
            if (magnitude_of(store.dim, store.point(v)) <= coordinate_max) continue;
            input->row_a = store.vertex(v).origin;
            return Status::out_of_range;
        }
    // In the order of the tree, where the last one's nearest is near; the first pair by index is what is reported.
    VertexId first = none, near_first = none, last = none;
    bool is_tiny = false;
    for (std::uint32_t i = 0; i < inputs && inputs > 1;)
        for (const std::uint64_t piece = store.arena.piece(i, inputs, 500 * store.dim); i < piece; ++i) {
            const VertexId v(tree.item(i));
            double d2;
            const VertexId near(tree.nearest(store.point(v), last, v, &d2));
            last = v;
            const bool tiny = d2 < separation_min * separation_min;
            const double least = finest * magnitude_of(store.dim, store.point(v));
            if ((!tiny && d2 >= least * least) || !(v < first)) continue;
            first = v;
            near_first = near;
            is_tiny = tiny && d2 > least * least;
        }
    if (first == none) return Status::ok;
    const std::uint64_t a = store.vertex(first).origin, b = store.vertex(near_first).origin;
    input->row_a = a < b ? a : b;
    input->row_b = a < b ? b : a;
    return is_tiny ? Status::out_of_range : Status::too_close;
}

}  // namespace netmesh
