#include "mesh/cages/any_cage.hpp"

namespace netmesh {

AnyDomain domain_ball(const AnyStore& store, const Cage* cages, std::uint32_t domain, const AnyDomain& outermost) {
    if (domain == none) return outermost;
    AnyDomain ball;
    ball.dim = store.dim;
    copy(store.dim, store.point(cages[domain].centre), ball.centre);
    ball.radius = ball.enclosing_radius = cages[domain].clip;
    return ball;
}

bool is_mixed(const AnyStore& store, const Cage& cage, std::uint32_t c, int except) {
    bool inside = false, outside = false;
    const AnyCell cell = store.cell(c);
    for (int k = 0; k <= store.dim; ++k) {
        const VertexId v = cell.vertex[k];
        if (k != except) (v != none && is_inside(store, cage, store.point(v)) ? inside : outside) = true;
    }
    return inside && outside;
}

std::uint32_t template_size(int dim, bool outermost) {
    constexpr std::uint32_t size[][2] = {{CageTemplate<2>::size, RootTemplate<2>::size},
                                         {CageTemplate<3>::size, RootTemplate<3>::size},
                                         {CageTemplate<4>::size, RootTemplate<4>::size}};
    return size[dim - 2][outermost];
}

double template_packing(int dim) {
    const auto packing = [](auto dimension) { return CageTemplate<decltype(dimension)::value>::packing; };
    return dim == 2 ? packing(Dimension<2>{}) : dim == 3 ? packing(Dimension<3>{}) : packing(Dimension<4>{});
}

void template_point(int dim, bool outermost, std::uint32_t k, double* x) {
    const auto point = [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        outermost ? RootTemplate<D>::point(k, x) : CageTemplate<D>::point(k, x);
    };
    dim == 2 ? point(Dimension<2>{}) : dim == 3 ? point(Dimension<3>{}) : point(Dimension<4>{});
}

bool list_cage_boundary(const AnyStore& store, const Cage& cage, std::uint32_t* count) {
    *count = 0;
    CellId first = none;
    const bool fits = visit_any_star(store, VertexId(cage.shell), [&](CellId c) {
        if (first == none && is_on_boundary(store, cage, c)) first = c;
    });
    if (!fits || first == none) return fits;
    AnyCellList boundary(store);
    if (!boundary.add(first)) return false;
    for (std::uint32_t k = 0; k < boundary.size(); ++k) {
        store.arena.pass(store.dim);  // thousands of cells where the domain around is far finer
        for (const FacetId facet : store.cell(boundary[k]).neighbour)
            if (facet != none && is_on_boundary(store, cage, facet.cell()) && !boundary.add(facet.cell())) return false;
    }
    *count = boundary.size();
    return true;
}

[[gnu::cold]] bool list_cage_cells(const AnyStore& store, const Cage& cage, std::uint32_t* count) {
    AnyCellList list(store);
    if (!list.add(store.vertex(cage.centre).cell)) return false;
    for (std::uint32_t k = 0; k < list.size(); ++k) {
        store.arena.pass(10 * store.dim);
        const AnyCell cell = store.cell(list[k]);
        unsigned inside = 0;
        for (int i = 0; i <= store.dim; ++i)
            if (cell.vertex[i] != none && is_inside(store, cage, store.point(cell.vertex[i]))) inside |= 1u << i;
        for (int i = 0; i <= store.dim; ++i)
            if ((inside & ~(1u << i)) != 0 && cell.neighbour[i] != none && !list.add(cell.neighbour[i].cell()))
                return false;
    }
    *count = list.size();
    return true;
}

}  // namespace netmesh
