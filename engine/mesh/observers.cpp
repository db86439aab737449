#include "mesh/observers.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D> Status Observers<D>::open(Store<D>& store, std::uint32_t inputs) {
    return locates_ ? lists_.open(store, store.arena, inputs) : Status::ok;
}

template <int D> Status Observers<D>::start(const Store<D>& store, Kernel<D>& kernel) {
    first_new_ = VertexId(store.state.vertex_count);
    return locates_ && !lists_.start(kernel) ? Status::out_of_memory : Status::ok;
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

template <int D>
Status Observers<D>::measure(Store<D>& store, const Cage* cages, std::uint32_t cages_made, const Domain<D>& domain,
                             VertexId v, bool cleaning) {
    const Status status =
        audit_quality<D>(store, cages, cages_made, domain, store.arena, {first_new_, v, cleaning}, &quality_);
    first_new_ = VertexId(store.state.vertex_count);
    if (status != Status::ok) return status;
    return quality_.encroached > 0 || quality_.cage > cage_insertion_bound<D>() ? Status::internal : status;
}

template <int D> void Observers<D>::report(MeshAudit* audit) const {
    if (lists_.is_open()) lists_.report(&audit->location);
    audit->quality = quality_;
}

#define NETMESH_INSTANTIATE(D) template class Observers<D>;
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
