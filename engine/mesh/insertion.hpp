// What refinement of inputs that come one by one has in common, whatever makes a cell bad.
#pragma once
#include <cstdint>

#include "mesh/bucket_queue.hpp"
#include "mesh/opening.hpp"

namespace netmesh {

// Self says what follows an insertion: update_star(cavity, v), nearest-neighbour distances and the queue; and clean(), which
// restores what is asked of all cells.
template <int D, class Self> class Insertion {
public:
    // finest: see check_separation.
    Status check_input(double finest, InputReport* input) {
        inputs_ = store_.state.vertex_count;
        const Status status = tree_.build(store_, store_.arena, inputs_);
        return status == Status::ok ? check_separation<D>(store_, tree_, finest, input) : status;
    }

    // Inserts the inputs in this order, those that a Steiner point has not yielded to yet, and cleans after each.
    Status run(const std::uint32_t* order) {
        monitor_.begin(NETMESH_STAGE_REFINE, inputs_);
        for (std::uint32_t k = 0; k < inputs_; ++k) {
            if (store_.vertex(order[k]).cell != none) continue;
            Status status = insert(order[k], store_.state.last_cell);
            if (status == Status::ok) status = self().clean();
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }

protected:
    Insertion(Store<D>& store, Monitor& monitor, Domain<D>& domain)
        : store_(store), kernel_(store, corner_error_max, true), monitor_(monitor), domain_(domain) {}

    // Room for what opens the triangulation: the queue, for squared distances up to that of the frame, and the frame.
    Status open_at(double reach) {
        if (queue_.open(store_, store_.arena, 16 * reach * reach) != Status::ok || store_.open_cells() != Status::ok)
            return Status::out_of_memory;
        return open_frame<D>(store_, kernel_, tree_, domain_, reach);
    }

    // Inserts vertex v, whose record is complete, near cell `from`. Nothing has changed when memory runs out.
    Status insert(std::uint32_t index, std::uint32_t from) {
        const VertexId v(index);
        const double* const q = store_.point(v);
        const CellId hit = kernel_.locate(q, v, CellId(from));
        Cavity cavity;
        if (!kernel_.find_cavity(q, v, hit, &cavity) || !kernel_.can_fill(cavity, 0)) return Status::out_of_memory;
        kernel_.fill(cavity, v);
        self().update_star(cavity, v);
        if (store_.vertex(v).marker == Marker::input) ++inserted_;
        monitor_.mesh_size(store_.state.vertex_count - inputs_ + inserted_, store_.live_cells());
        return monitor_.advance(inserted_, 4 + 2 * cavity.facets) ? Status::cancelled : Status::ok;
    }

    std::uint32_t nearest_input(std::uint32_t v) const {
        return store_.vertex(v).marker == Marker::input ? v : store_.vertex(v).origin;
    }

    Store<D>& store_;
    Kernel<D> kernel_;
    Monitor& monitor_;
    Domain<D>& domain_;
    InputTree<D> tree_;
    BucketQueue<D> queue_;
    std::uint32_t inputs_ = 0, inserted_ = 0;

private:
    Self& self() { return static_cast<Self&>(*this); }
};

}  // namespace netmesh
