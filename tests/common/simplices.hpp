// Simplices of a triangulation and of a part of it, as sets of ascending lists of vertices.
#pragma once
#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "complex/subcomplex.hpp"
#include "delaunay/store.hpp"

using Simplex = std::vector<std::uint32_t>;
using Simplices = std::set<Simplex>;

inline void add_faces(Simplex simplex, Simplices* to) {
    std::sort(simplex.begin(), simplex.end());
    for (std::uint32_t set = 1; set < 1u << simplex.size(); ++set) {
        Simplex face;
        for (std::size_t i = 0; i < simplex.size(); ++i)
            if ((set >> i & 1u) != 0) face.push_back(simplex[i]);
        to->insert(face);
    }
}

template <int D> Simplex cell_of(const netmesh::Store<D>& store, std::uint32_t c) {
    const netmesh::VertexId* const vertex = store.cell(c).vertex;
    return Simplex(vertex, vertex + D + 1);
}

template <int D> Simplices simplices_of(const netmesh::Store<D>& store) {
    Simplices all;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) add_faces(cell_of<D>(store, c), &all);
    return all;
}

// What is in by the definition of Subcomplex. all: simplices_of(store).
template <int D>
Simplices simplices_of(const netmesh::Store<D>& store, const netmesh::Subcomplex<D>& part, const Simplices& all) {
    Simplices in;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c)
        if (part.cell[c] == 1) add_faces(cell_of<D>(store, c), &in);
    for (const Simplex& s : all)
        if (s.size() <= D && part.faces.contains(s.data(), static_cast<std::uint32_t>(s.size()))) in.insert(s);
    return in;
}
