#include "mesh/sizing.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The flat of points equidistant from v and some others, by orthonormal normals; relative to v.
template <int D> struct Flat {
    double normal[D][D];
    double offset[D];
    int codimension = 0;

    // False when the bisector with w is parallel to what there is.
    bool cut(const double* v, const double* w) {
        double* const n = normal[codimension];
        double length2 = 0, rest2 = 0, level = 0;
        for (int k = 0; k < D; ++k) {
            n[k] = w[k] - v[k];
            length2 += n[k] * n[k];
        }
        level = 0.5 * length2;
        for (int i = 0; i < codimension; ++i) {
            double dot = 0;
            for (int k = 0; k < D; ++k) dot += n[k] * normal[i][k];
            for (int k = 0; k < D; ++k) n[k] -= dot * normal[i][k];
            level -= dot * offset[i];
        }
        for (int k = 0; k < D; ++k) rest2 += n[k] * n[k];
        const double rest = square_root(rest2);
        if (!(rest2 > 0x1p-60 * length2)) return false;
        for (int k = 0; k < D; ++k) n[k] /= rest;
        offset[codimension++] = level / rest;
        return true;
    }
    // The point of the flat nearest to p.
    void foot(const double* p, double* at) const {
        for (int k = 0; k < D; ++k) at[k] = p[k];
        for (int i = 0; i < codimension; ++i) {
            double along = -offset[i];
            for (int k = 0; k < D; ++k) along += p[k] * normal[i][k];
            for (int k = 0; k < D; ++k) at[k] -= along * normal[i][k];
        }
    }
    // A unit vector along the flat, the longest that an axis leaves.
    void direction(double* u) const {
        double best = 0;
        for (int axis = 0; axis < D; ++axis) {
            double p[D] = {}, length2 = 0;
            p[axis] = 1;
            for (int i = 0; i < codimension; ++i)
                for (int k = 0; k < D; ++k) p[k] -= normal[i][axis] * normal[i][k];
            for (int k = 0; k < D; ++k) length2 += p[k] * p[k];
            if (!(length2 > best)) continue;
            best = length2;
            for (int k = 0; k < D; ++k) u[k] = p[k] / square_root(length2);
        }
    }
};

// The point of the domain's sphere on the flat that is farthest from v, relative to v; false when they do not meet.
template <int D> bool pole(const Domain<D>& domain, const double* v, const Flat<D>& flat, double* x) {
    const double zero[D] = {};
    double centre[D], middle[D], foot[D], away[D], apart2 = 0, away2 = 0;
    for (int k = 0; k < D; ++k) centre[k] = domain.centre[k] - v[k];
    flat.foot(centre, middle);
    flat.foot(zero, foot);
    for (int k = 0; k < D; ++k) {
        apart2 += (middle[k] - centre[k]) * (middle[k] - centre[k]);
        away[k] = middle[k] - foot[k];
        away2 += away[k] * away[k];
    }
    const double radius2 = domain.radius * domain.radius - apart2;
    if (!(radius2 > 0)) return false;
    if (away2 > 0x1p-60 * domain.radius * domain.radius)
        for (int k = 0; k < D; ++k) away[k] /= square_root(away2);
    else
        flat.direction(away);
    for (int k = 0; k < D; ++k) x[k] = middle[k] + square_root(radius2) * away[k];
    return true;
}

// Is v + x as near to v as to all other vertices of its star?
template <int D>
bool is_in_cell(const Store<D>& store, std::uint32_t v, const double* x, const CellId* star, std::uint32_t count) {
    const double* const p = store.point(v);
    double own2 = 0;
    for (int k = 0; k < D; ++k) own2 += x[k] * x[k];
    for (std::uint32_t s = 0; s < count; ++s)
        for (const std::uint32_t w : store.cell(star[-1 - static_cast<std::ptrdiff_t>(s)]).vertex) {
            if (w == v) continue;
            double d2 = 0;
            for (int k = 0; k < D; ++k) {
                const double d = p[k] + x[k] - store.point(w)[k];
                d2 += d * d;
            }
            if (d2 < own2 * (1 - 0x1p-30)) return false;
        }
    return true;
}

}  // namespace

template <int D>
double farthest_pole(const Store<D>& store, const Domain<D>& domain, std::uint32_t v, const CellId* star,
                     std::uint32_t count, double* x, CellId* cell) {
    const double* const p = store.point(v);
    double best2 = -1;
    for (std::uint32_t s = 0; s < count; ++s) {
        const CellId c = star[-1 - static_cast<std::ptrdiff_t>(s)];
        for (unsigned set = 0; set < (2u << D) - 1; ++set) {
            Flat<D> flat;
            bool proper = true;
            for (int i = 0; i <= D && proper; ++i) {
                const std::uint32_t w = store.cell(c).vertex[i];
                if (set >> i & 1u) proper = w != v && flat.codimension < D - 1 && flat.cut(p, store.point(w));
            }
            double at[D], d2 = 0;
            if (!proper || !pole<D>(domain, p, flat, at)) continue;
            for (int k = 0; k < D; ++k) d2 += at[k] * at[k];
            if (!(d2 > best2) || !is_in_cell<D>(store, v, at, star, count)) continue;
            best2 = d2;
            *cell = c;
            for (int k = 0; k < D; ++k) x[k] = p[k] + at[k];
        }
    }
    return best2;
}

template <int D>
Status worst_size_ratio(const Store<D>& store, const SizeRatioRequest<D>& request, Arena& arena, SizeRatio* ratio) {
    *ratio = {0, none};
    if (!request.rule.asks()) return Status::ok;
    ArenaScope scope(arena);
    double* const out2 = arena.take_low<double>(store.state.vertex_count);
    InputTree<D> tree;
    if (out2 == nullptr || tree.build(store, arena, request.inputs) != Status::ok) return Status::out_of_memory;
    clipped_out_radii<D>(store, request.domain, request.corners, out2);
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        if (store.vertex(v).cell == none || store.vertex(v).marker == Marker::exempt) continue;
        const double size = wanted_size<D>(store, tree, request.rule, v);
        const double here = size > 0 ? square_root(out2[v]) / size : infinity;
        if (here > ratio->worst) *ratio = {here, v};
    }
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status worst_size_ratio<D>(const Store<D>&, const SizeRatioRequest<D>&, Arena&, SizeRatio*);              \
    template double farthest_pole<D>(const Store<D>&, const Domain<D>&, std::uint32_t, const CellId*, std::uint32_t,   \
                                     double*, CellId*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
