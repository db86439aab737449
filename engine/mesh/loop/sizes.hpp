// Over-refinement (thesis 3.7) while a mesh grows: what sizes are asked for is noted with each vertex.
#pragma once
#include <cstdint>

#include "mesh/loop/separation.hpp"
#include "mesh/sizing.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

// Sizes are asked for from start() on, when all inputs are in. A vertex has its size rounded down to 16 bits at hand;
// only when a corner is beyond that the rule itself is evaluated again.
template <int D> class Sizes {
public:
    // Refinement stops a hair before the size asked for, more than the error of the corners that it sees.
    Sizes(Store<D>& store, const InputTree<D>& tree, const SizeRule& rule, double margin)
        : store_(store), tree_(tree), rule_(rule), margin_(margin) {}

    bool are_asked() const { return built::sizes && rule_.asks(); }
    void start() { started_ = true; }
    bool have_started() const { return built::sizes && started_; }

    // Evaluates the rule at v for the first time. invalid_argument: the size is not positive or below `finest` times
    // the magnitude of v's coordinates.
    Status note(VertexId v, double finest) {
        const double size = wanted_size(store_, tree_, rule_, v);
        double magnitude = 0;
        for (int k = 0; k < store_.dim; ++k)
            if (absolute(store_.point(v)[k]) > magnitude) magnitude = absolute(store_.point(v)[k]);
        if (!(size >= separation_min && size >= finest * magnitude)) return Status::invalid_argument;
        const double size2 = size < coordinate_max ? size * size : infinity;
        store_.vertex(v).size_hint = size_hint_of((1 - 2 * margin_) * size2);
        return Status::ok;
    }

    // No corner within this squared distance is too far for v, whose size has been noted; the others may be.
    double bound2(const Vertex<D>& v) const { return have_started() ? value_of_size_hint(v.size_hint) : infinity; }

    // What bound2 is a lower bound of. Evaluates the rule, once sizes are asked for.
    double limit2(VertexId v) const {
        if (!have_started()) return infinity;
        const double size = wanted_size(store_, tree_, rule_, v) * (1 - margin_);
        return size * size;
    }
    // Is a corner at this squared distance too far for v?
    bool are_exceeded(VertexId v, double corner2) const {
        return corner2 > bound2(store_.vertex(v)) && corner2 > limit2(v);
    }

private:
    Store<D>& store_;
    const InputTree<D>& tree_;
    const SizeRule rule_;
    const double margin_;
    bool started_ = false;
};

}  // namespace netmesh
