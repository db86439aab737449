// What cage.hpp and cage_template.hpp say of a store, where the dimension is a number at run time.
#pragma once
#include "mesh/any_domain.hpp"
#include "mesh/cages/cage.hpp"
#include "mesh/cages/cage_template.hpp"
#include "mesh/cages/hierarchy.hpp"

namespace netmesh {

inline bool is_inside(const AnyStore& store, const Cage& cage, const double* x) {
    return distance2(store.dim, x, store.point(cage.centre)) < cage.radius * cage.radius;
}

AnyDomain domain_ball(const AnyStore& store, const Cage* cages, std::uint32_t domain, const AnyDomain& outermost);
// Of all vertices of cell c but the one at `except`; -1: of all.
bool is_mixed(const AnyStore& store, const Cage& cage, std::uint32_t c, int except);
inline bool is_on_boundary(const AnyStore& store, const Cage& cage, std::uint32_t c) {
    return is_mixed(store, cage, c, -1);
}
inline bool is_by_shell(const AnyStore& store, const Cage& cage, std::uint32_t v) {
    return is_by_shell(cage, distance2(store.dim, store.point(v), store.point(cage.centre)));
}
// Does input v, in the domain of cage d, stand in the place of a vertex of its shell, which has yielded to it?
inline bool has_yielded_to(const AnyStore& store, const Cage* cages, std::uint32_t d, std::uint32_t v) {
    return d != none && store.vertex(v).marker == Marker::input && is_by_shell(store, cages[d], v);
}

// Of CageTemplate<dim>, or RootTemplate<dim>; dim <= thesis_dim_max.
std::uint32_t template_size(int dim, bool outermost);
double template_packing(int dim);
void template_point(int dim, bool outermost, std::uint32_t k, double* x);

// Lists the cells on the cage's boundary, which are connected, at list_top()[-1 - k]; *count: how many. There is one at
// any shell vertex. They stand there until the next search. False when the gap is too small.
bool list_cage_boundary(const AnyStore& store, const Cage& cage, std::uint32_t* count);

// The same for all cells with a vertex inside of the cage. Any vertex in a ball about another one has a neighbour
// nearer to that, so these cells are connected.
bool list_cage_cells(const AnyStore& store, const Cage& cage, std::uint32_t* count);

}  // namespace netmesh
