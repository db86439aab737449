// Shells of cages of the thesis (4.5): their vertices, which yield to inputs.
#pragma once
#include "mesh/loop/thesis_cages.hpp"

namespace netmesh {

// YieldingInsert of the template. Room for its vertices is there.
template <int D, class Rule> Status ThesisCages<D, Rule>::insert_shell(std::uint32_t d) {
    Cage& cage = hierarchy_.cage(d);
    cage.shell = store_.state.vertex_count;
    making_ = d;
    VertexId first = none;
    const double reach = ThesisCage::yields * ThesisCage::shell_factor * cage.radius;
    const std::uint32_t size = template_size(store_.dim, d == root);
    for (std::uint32_t k = 0; k < size; ++k) {
        double unit[DimensionOf<D>::most], x[DimensionOf<D>::most], d2;
        template_point(store_.dim, d == root, k, unit);
        place(cage, unit, k, x);
        const std::uint32_t input = inserted_ < inputs_ ? tree_.nearest_within(x, reach * reach, &d2) : none;
        const bool yields = input != none && store_.vertex(input).cell == none;
        const VertexId v = yields ? VertexId(input) : make_vertex<D>(store_, x, cage.centre, Marker::exempt);
        if (yields) {
            hierarchy_.set(v, d);
            has_yielded_ = true;
            observers_.note({input, none});
        }
        const Status status = this->insert(v, store_.vertex(cage.centre).cell);
        // A cage without its whole shell is given up; the shell vertices that are in the mesh stay there, exempt.
        if (status != Status::ok) {
            if (!yields) store_.truncate_vertices(status == Status::cancelled ? v + 1 : v.index);
            return status;
        }
        if (first == none || (first < inputs_ && !yields)) first = v;
    }
    cage.shell = first;
    making_ = none;
    queue_cage(d);
    return Status::ok;
}

template <int D, class Rule>
void ThesisCages<D, Rule>::place(const Cage& cage, const double* unit, std::uint32_t k, double* x) const {
    std::uint64_t random = mix64(std::uint64_t{cage.centre} << 32 | k);
    for (int i = 0; i < store_.dim; ++i) {
        random = mix64(random);
        const double moved = unit[i] + ThesisCage::jitter * (static_cast<double>(random >> 11) * 0x1p-52 - 1);
        x[i] = store_.point(cage.centre)[i] + ThesisCage::shell_factor * cage.radius * moved;
    }
}

// Vertices of the shell's own come in the order of the template; what is missing among them has yielded.
template <int D, class Rule>
template <class Visit>
void ThesisCages<D, Rule>::visit_shell(const Cage& cage, Visit&& visit) const {
    const double reach = ThesisCage::yields * ThesisCage::shell_factor * cage.radius;
    VertexId own(cage.shell);
    for (std::uint32_t k = 0; k < template_size(store_.dim, false); ++k) {
        double unit[DimensionOf<D>::most], x[DimensionOf<D>::most], d2;
        template_point(store_.dim, false, k, unit);
        place(cage, unit, k, x);
        const bool is_own =
            own >= inputs_ && own < store_.state.vertex_count && distance2<D>(store_.dim, x, store_.point(own)) == 0;
        visit(is_own ? own : VertexId(tree_.nearest_within(x, reach * reach, &d2)));
        if (is_own) ++own;
    }
}

template <int D, class Rule> bool ThesisCages<D, Rule>::is_of_shell(VertexId v) {
    const Vertex<D>& vertex = store_.vertex(v);
    if (vertex.marker != Marker::input) return vertex.marker == Marker::exempt;
    const std::uint32_t d = hierarchy_.of(v);
    return d != none && is_beyond(d, ThesisCage::epsilon * (1 + tau_margin), vertex.x);
}

}  // namespace netmesh
