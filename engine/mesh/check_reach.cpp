#include "mesh/check_reach.hpp"

#include "numerics/bits.hpp"
#include "numerics/double_double.hpp"

namespace netmesh {
namespace {

// Pivots below this part of the longest edge: the cell is flat.
constexpr double flat_pivot = 0x1p-80;
// Points this much nearer to another vertex (relative, squared) still count as the cell's own.
constexpr double cell_slack = 0x1p-36;

// The point at the same distance from all vertices of a cell, relative to the first of them.
struct Centre {
    bool known;
    double x[dimension_max];
};

[[gnu::cold]] Centre centre_of(const AnyStore& store, CellId c) {
    const double* const p = store.point(store.cell(c).vertex[0]);
    double longest = 0;
    const int dim = store.dim;
    store.arena.pass(6 * static_cast<std::uint32_t>(dim * dim));
    DoubleDouble a[dimension_max][dimension_max + 1];
    for (int i = 0; i < dim; ++i)
        for (int k = 0; k < dim; ++k) {
            a[i][k] = two_difference(store.point(store.cell(c).vertex[i + 1])[k], p[k]);
            if (absolute(a[i][k].high) > longest) longest = absolute(a[i][k].high);
        }
    Centre centre = {};
    if (!(longest > 0)) return centre;
    const double unit = power_of_two(exponent_of(longest));
    for (int i = 0; i < dim; ++i) {
        a[i][dim] = {0, 0};
        for (int k = 0; k < dim; ++k) {
            a[i][k] = scaled(a[i][k], 1 / unit);
            a[i][dim] = a[i][dim] + a[i][k] * a[i][k];
        }
        a[i][dim] = scaled(a[i][dim], 0.5);
    }
    for (int k = 0; k < dim; ++k) {
        int pivot = k;
        for (int i = k + 1; i < dim; ++i)
            if (absolute(a[i][k].high) > absolute(a[pivot][k].high)) pivot = i;
        if (!(absolute(a[pivot][k].high) > flat_pivot)) return centre;
        for (int j = 0; j <= dim; ++j) {
            const DoubleDouble kept = a[k][j];
            a[k][j] = a[pivot][j];
            a[pivot][j] = kept;
        }
        for (int i = k + 1; i < dim; ++i) {
            const DoubleDouble factor = a[i][k] / a[k][k];
            for (int j = k; j <= dim; ++j) a[i][j] = a[i][j] - factor * a[k][j];
        }
    }
    DoubleDouble x[dimension_max];
    for (int k = dim - 1; k >= 0; --k) {
        x[k] = a[k][dim];
        for (int j = k + 1; j < dim; ++j) x[k] = x[k] - a[k][j] * x[j];
        x[k] = x[k] / a[k][k];
        centre.x[k] = x[k].high * unit;
    }
    centre.known = true;
    return centre;
}

class Reach {
public:
    Reach(const AnyStore& store, const ReachRequest& request) : dim(store.dim), store_(store), request_(request) {}

    Status find_beyond(std::uint32_t* beyond);

private:
    // Of vertex v: what |x - c| <= r and |x - v| >= s leave is slope . (x - v) <= level.
    struct HalfSpace {
        int dim;
        double slope[dimension_max], level;
        double above(const double* y) const {
            double sum = -level;
            for (int k = 0; k < dim; ++k) sum += slope[k] * y[k];
            return sum;
        }
    };
    HalfSpace half_space_of(VertexId v) const;
    // A corner of cell c as seen from v, one of its vertices.
    void from_vertex(CellId c, const Centre& centre, VertexId v, double* y) const {
        const double *const p = store_.point(store_.cell(c).vertex[0]), *const q = store_.point(v);
        for (int k = 0; k < dim; ++k) y[k] = centre.x[k] - (q[k] - p[k]);
    }
    bool crosses_beyond(VertexId v, const HalfSpace& half, const double* y, CellId n) const;
    bool leads_beyond(VertexId v, const HalfSpace& half, const double* y, CellId c, int across) const;
    bool has_corner_beyond(CellId c, const Centre& centre, VertexId v, const HalfSpace& half) const;
    bool comes_within(VertexId v, const HalfSpace& half, bool* fits) const;
    bool is_own(VertexId v, const double* y, const AnyCellList& star) const;

    const int dim;
    const AnyStore& store_;
    const ReachRequest& request_;
};

[[gnu::cold]] Reach::HalfSpace Reach::half_space_of(VertexId v) const {
    const std::uint32_t d = request_.domains != nullptr ? request_.domains[v] : none;
    const double* centre = request_.outermost.centre;
    double radius = request_.outermost.radius;
    if (d != none) {
        centre = store_.point(request_.cages[d].centre);
        radius = cage_epsilon * request_.cages[d].radius;
    }
    HalfSpace half;
    half.dim = dim;
    half.level = radius * radius - request_.limit2[v];
    for (int k = 0; k < dim; ++k) {
        const double a = store_.point(v)[k] - centre[k];
        half.slope[k] = 2 * a;
        half.level -= a * a;
    }
    return half;
}

// Does the edge from the corner y, outside of the half-space, to that of cell n enter it beyond the limit?
[[gnu::cold]] bool Reach::crosses_beyond(VertexId v, const HalfSpace& half, const double* y, CellId n) const {
    const Centre centre = centre_of(store_, n);
    if (!centre.known) return false;
    double z[dimension_max], x[dimension_max], x2 = 0;
    from_vertex(n, centre, v, z);
    const double here = half.above(y), there = half.above(z);
    if (there > 0) return false;
    const double t = there / (there - here);  // from z, the nearer one or not much farther
    for (int k = 0; k < dim; ++k) {
        x[k] = z[k] + t * (y[k] - z[k]);
        x2 += x[k] * x[k];
    }
    return x2 > request_.limit2[v];
}

// The same for the edge behind a facet of c, and through the cell there when that is flat.
[[gnu::cold]] bool Reach::leads_beyond(VertexId v, const HalfSpace& half, const double* y, CellId c, int across) const {
    const CellId n = store_.cell(c).neighbour[across].cell();
    if (crosses_beyond(v, half, y, n)) return true;
    if (centre_of(store_, n).known) return false;
    for (int i = 0; i <= dim; ++i) {
        const FacetId next = store_.cell(n).neighbour[i];
        if (store_.cell(n).vertex[i] == v || next == none || next.cell() == c) continue;
        if (crosses_beyond(v, half, y, next.cell())) return true;
    }
    return false;
}

[[gnu::cold]] bool Reach::has_corner_beyond(CellId c, const Centre& centre, VertexId v, const HalfSpace& half) const {
    double y[dimension_max], y2 = 0;
    from_vertex(c, centre, v, y);
    for (int k = 0; k < dim; ++k) y2 += y[k] * y[k];
    // An edge is no longer than to its ends: only corners beyond the limit have edges that are.
    if (!(y2 > request_.limit2[v])) return false;
    if (!(half.above(y) > 0)) return true;
    for (int i = 0; i <= dim; ++i)
        if (store_.cell(c).vertex[i] != v && leads_beyond(v, half, y, c, i)) return true;
    return false;
}

[[gnu::cold]] bool Reach::is_own(VertexId v, const double* y, const AnyCellList& star) const {
    store_.arena.pass(1 + star.size() / 2);
    double y2 = 0;
    for (int k = 0; k < dim; ++k) y2 += y[k] * y[k];
    for (std::uint32_t s = 0; s < star.size(); ++s)
        for (const VertexId w : store_.cell(star[s]).vertex) {
            double excess = 0;
            for (int k = 0; k < dim; ++k) {
                const double e = store_.point(w)[k] - store_.point(v)[k];
                excess += e * (2 * y[k] - e);
            }
            if (excess > cell_slack * y2) return false;
        }
    return true;
}

// v is outside of the half-space: is the point of its cut cell nearest to v within the limit? That point is the foot of
// v on the plane cut with the flat of some face.
[[gnu::cold]] bool Reach::comes_within(VertexId v, const HalfSpace& half, bool* fits) const {
    AnyCellList star(store_);
    *fits = star.add(store_.vertex(v).cell);
    for (std::uint32_t s = 0; s < star.size() && *fits; ++s) {
        const AnyCell cell = store_.cell(star[s]);
        for (int i = 0; i <= dim && *fits; ++i) *fits = cell.vertex[i] == v || star.add(cell.neighbour[i].cell());
    }
    if (!*fits) return false;
    for (std::uint32_t s = 0; s < star.size(); ++s) {
        const AnyCell cell = store_.cell(star[s]);
        store_.arena.pass(2u << dim);
        for (unsigned set = 0; set < (2u << dim) - 1; ++set) {
            // Orthonormal normals and the foot's coordinates along them, the plane's first.
            double normal[dimension_max][dimension_max], along[dimension_max], foot[dimension_max] = {}, foot2 = 0;
            int size = 0;
            bool proper = true;
            for (int i = -1; i <= dim && proper; ++i) {
                if (i >= 0 && (set >> i & 1u) == 0) continue;
                if (i >= 0 && (cell.vertex[i] == v || size == dim)) {
                    proper = false;
                    break;
                }
                double* const n = normal[size];
                double level = half.level, length2 = 0, rest2 = 0;
                for (int k = 0; k < dim; ++k) {
                    n[k] = i < 0 ? half.slope[k] : store_.point(cell.vertex[i])[k] - store_.point(v)[k];
                    length2 += n[k] * n[k];
                }
                if (i >= 0) level = 0.5 * length2;
                for (int j = 0; j < size; ++j) {
                    double common = 0;
                    for (int k = 0; k < dim; ++k) common += n[k] * normal[j][k];
                    for (int k = 0; k < dim; ++k) n[k] -= common * normal[j][k];
                    level -= common * along[j];
                }
                for (int k = 0; k < dim; ++k) rest2 += n[k] * n[k];
                proper = rest2 > 0x1p-60 * length2;
                const double rest = square_root(rest2);
                for (int k = 0; k < dim; ++k) n[k] /= rest;
                along[size] = level / rest;
                foot2 += along[size] * along[size];
                ++size;
                proper = proper && foot2 <= request_.limit2[v];
            }
            if (!proper) continue;
            for (int j = 0; j < size; ++j)
                for (int k = 0; k < dim; ++k) foot[k] += along[j] * normal[j][k];
            if (is_own(v, foot, star)) return true;
        }
    }
    return false;
}

[[gnu::cold]] Status Reach::find_beyond(std::uint32_t* beyond) {
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 100 * dim); c < piece; ++c) {
            const Centre centre = centre_of(store_, c);
            if (!centre.known) continue;
            for (const VertexId v : store_.cell(c).vertex) {
                if (!(request_.limit2[v] < infinity)) continue;
                const HalfSpace half = half_space_of(v);
                if (!has_corner_beyond(c, centre, v, half)) continue;
                bool fits = true;
                if (half.level < 0 && !comes_within(v, half, &fits)) {
                    if (!fits) return Status::out_of_memory;
                    continue;
                }
                *beyond = v;
                return Status::ok;
            }
        }
    return Status::ok;
}

}  // namespace

Status check_reach(const AnyStore& store, const ReachRequest& request, std::uint32_t* beyond) {
    *beyond = none;
    return Reach(store, request).find_beyond(beyond);
}

}  // namespace netmesh
