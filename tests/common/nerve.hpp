// The nerve of clipped cells (mesh/clip/clipped_nerve.hpp) as a part that knows its dimension.
#pragma once
#include "mesh/clip/clipped_nerve.hpp"

template <int D>
netmesh::Status find_nerve(const netmesh::Store<D>& store, const netmesh::Domain<D>& ball, const netmesh::Work& work,
                           netmesh::Subcomplex<D>* part, bool* certain) {
    netmesh::AnyPart found;
    const netmesh::Status status = netmesh::find_clipped_nerve(store, ball, work, &found, certain);
    if (status == netmesh::Status::ok && *certain) *part = found.of_dimension<D>({});
    return status;
}

template <int D>
netmesh::Status choose_nerve(const netmesh::Store<D>& store, netmesh::Domain<D>* domain, const netmesh::Work& work,
                             netmesh::Subcomplex<D>* part, bool* found) {
    netmesh::AnyPart chosen;
    netmesh::AnyDomain ball(*domain);
    const netmesh::Status status = netmesh::choose_clipped_nerve(store, &ball, work, &chosen, found);
    *domain = ball.of_dimension<D>();
    if (status == netmesh::Status::ok && *found) *part = chosen.of_dimension<D>({});
    return status;
}
