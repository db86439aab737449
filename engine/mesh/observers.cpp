#include "mesh/observers.hpp"

#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

// Long cells of Steiner vertices are no fault of a mesh made for a certificate.
template <int D> Status Observers<D>::open(Store<D>& store, std::uint32_t inputs) {
    if (built::audits && measures_ && kind_ == CageKind::thesis) {
        notes_ = store.arena.template take_low<AuditNote>(std::size_t{notes_per_input} * inputs);
        if (notes_ == nullptr) return Status::out_of_memory;
        notes_max_ = notes_per_input * inputs;
    }
    return built::audits && locates_ ? lists_.open(store, store.arena, inputs) : Status::ok;
}

template <int D> Status Observers<D>::start(const Store<D>& store, Kernel<D>& kernel) {
    first_new_ = VertexId(store.state.vertex_count);
    return built::audits && locates_ && !lists_.start(kernel) ? Status::out_of_memory : Status::ok;
}

template <int D>
bool Observers<D>::before_fill(const Store<D>& store, const Kernel<D>& kernel, const Cavity& cavity, VertexId v) {
    if (store.vertex(v).marker == Marker::input && !lists_.agrees(kernel, cavity, v)) return false;
    lists_.detach(kernel, cavity, v);
    return true;
}

template <int D> bool Observers<D>::after_fill(Kernel<D>& kernel, const Cavity& cavity, VertexId v) {
    full_ = !lists_.attach(kernel, cavity, v);
    return !full_;
}

template <int D> void Observers<D>::note_released(Hierarchy<D>& hierarchy, std::uint32_t d) {
    if (!measures_) return;
    hierarchy.cage(d).next = released_ == none ? d : released_;
    released_ = d;
}

template <int D> void Observers<D>::note(const AuditNote& note) {
    if (!measures_) return;
    NETMESH_ASSERT(note_count_ < notes_max_);
    notes_[note_count_++] = note;
}

template <int D>
Status Observers<D>::measure(Store<D>& store, const InputTree<D>& tree, Hierarchy<D>* hierarchy,
                             const Domain<D>& domain, VertexId v, bool cleaning) {
    const AuditStep step = {first_new_, v, cleaning, released_, notes_, note_count_};
    const Status status = audit_quality<D>({store, tree, domain, hierarchy, terms_, kind_}, step, &quality_);
    note_count_ = 0;
    first_new_ = VertexId(store.state.vertex_count);
    while (released_ != none) {
        Cage& cage = hierarchy->cage(released_);
        released_ = cage.next == released_ ? none : cage.next;
        cage.next = none;
    }
    if (status != Status::ok) return status;
    return quality_.encroached > 0 || quality_.cage > cage_insertion_bound<D>(kind_) ? Status::internal : status;
}

template <int D> void Observers<D>::report(MeshAudit* audit) const {
    if (locates()) lists_.report(&audit->location);
    if (built::audits) audit->quality = quality_;
}

#define NETMESH_INSTANTIATE(D) template class Observers<D>;
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
