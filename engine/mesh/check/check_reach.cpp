#include "mesh/check/check_reach.hpp"

#include "numerics/bits.hpp"
#include "numerics/double_double.hpp"
#include "numerics/wide_float.hpp"

namespace netmesh {
namespace {

// Points this much nearer to another vertex (relative, squared) still count as the cell's own.
constexpr double cell_slack = 0x1p-36;
// Sums of D products of doubles are off by less than this times the sum of what is added.
constexpr double sum_error = 0x1p-48;

// Arithmetic of 106 bits, and of 1,024 for what those leave open. Of a system whose rows have the size 1, eliminated
// with the largest entry left as pivot, the solution is known to 2^-50 of its size when all pivots are above
// least_pivot: entries grow by less than 2^D, and a quotient by the least pivot magnifies what was rounded.
template <class Number> struct Digits;
template <> struct Digits<DoubleDouble> {
    static constexpr double least_pivot = 0x1p-40;
    static DoubleDouble of(double a) { return {a, 0}; }
    static DoubleDouble difference(double a, double b) { return exact_difference(a, b); }
    static double rounded(DoubleDouble a) { return a.high; }
    static DoubleDouble times_power(DoubleDouble a, int exponent) { return scaled(a, power_of_two(exponent)); }
};
template <> struct Digits<WideFloat> {
    static constexpr double least_pivot = 0x1p-900;
    static WideFloat of(double a) { return WideFloat(a); }
    static WideFloat difference(double a, double b) { return WideFloat(a) - WideFloat(b); }
    static double rounded(const WideFloat& a) { return a.rounded(); }
    static WideFloat times_power(const WideFloat& a, int exponent) { return a.scaled(exponent); }
};

// x[k] := the point at the same distance from all vertices of a cell, relative to the first of them. False: digits do
// not tell. Each row, of one edge, is scaled to a size of 1 by a power of two, so edges of any two lengths do.
template <class Number> [[gnu::cold, gnu::noinline]] bool solve_centre(const AnyStore& store, CellId c, Number* x) {
    using To = Digits<Number>;
    const double* const p = store.point(store.cell(c).vertex[0]);
    const int dim = store.dim;
    store.arena.pass(6 * static_cast<std::uint32_t>(dim * dim));
    Number a[dimension_max][dimension_max + 1];
    for (int i = 0; i < dim; ++i) {
        const double* const q = store.point(store.cell(c).vertex[i + 1]);
        double longest = 0;
        for (int k = 0; k < dim; ++k) {
            a[i][k] = To::difference(q[k], p[k]);
            if (absolute(To::rounded(a[i][k])) > longest) longest = absolute(To::rounded(a[i][k]));
        }
        if (!(longest > 0x1p-900 && longest < 0x1p900)) return false;
        const int exponent = exponent_of(longest);
        a[i][dim] = To::of(0);
        for (int k = 0; k < dim; ++k) {
            a[i][k] = To::times_power(a[i][k], -exponent);
            a[i][dim] = a[i][dim] + a[i][k] * a[i][k];
        }
        a[i][dim] = To::times_power(a[i][dim], exponent - 1);
    }
    int column[dimension_max];
    for (int k = 0; k < dim; ++k) column[k] = k;
    for (int k = 0; k < dim; ++k) {
        int row = k, at = k;
        for (int i = k; i < dim; ++i)
            for (int j = k; j < dim; ++j)
                if (absolute(To::rounded(a[i][j])) > absolute(To::rounded(a[row][at]))) row = i, at = j;
        if (!(absolute(To::rounded(a[row][at])) > To::least_pivot)) return false;
        for (int j = 0; j <= dim; ++j) {
            const Number kept = a[k][j];
            a[k][j] = a[row][j];
            a[row][j] = kept;
        }
        for (int i = 0; i < dim; ++i) {
            const Number kept = a[i][k];
            a[i][k] = a[i][at];
            a[i][at] = kept;
        }
        const int moved = column[k];
        column[k] = column[at];
        column[at] = moved;
        for (int i = k + 1; i < dim; ++i) {
            const Number factor = a[i][k] / a[k][k];
            for (int j = k; j <= dim; ++j) a[i][j] = a[i][j] - factor * a[k][j];
        }
    }
    Number solution[dimension_max];
    for (int k = dim - 1; k >= 0; --k) {
        solution[k] = a[k][dim];
        for (int j = k + 1; j < dim; ++j) solution[k] = solution[k] - a[k][j] * solution[j];
        solution[k] = solution[k] / a[k][k];
    }
    for (int k = 0; k < dim; ++k) x[column[k]] = solution[k];
    return true;
}

class Reach {
public:
    Reach(const AnyStore& store, const ReachRequest& request) : dim(store.dim), store_(store), request_(request) {}

    Status find_beyond(std::uint32_t* beyond);

private:
    // Of vertex v: what |x - c| <= r and |x - v| >= s leave is slope . (x - v) <= level. centre: c - v.
    struct HalfSpace {
        double slope[dimension_max], centre[dimension_max], level, radius;
    };
    // A cell's circumcentre, as far as 106 bits tell.
    struct Centre {
        bool known;
        DoubleDouble x[dimension_max];
    };
    // A corner as seen from a vertex, and how far above the half-space it is.
    struct Corner {
        bool known;
        double y[dimension_max], y2, above;
    };
    enum class Found { within, beyond, undecided, out_of_memory };

    HalfSpace half_space_of(VertexId v) const;
    Centre centre_of(CellId c) const {
        Centre centre;
        centre.known = solve_centre<DoubleDouble>(store_, c, centre.x);
        return centre;
    }
    template <class Number>
    void see(CellId c, const Number* x, VertexId v, const HalfSpace& half, Corner* corner, double* size) const;
    Corner corner_of(CellId c, const Centre& centre, VertexId v, const HalfSpace& half) const;
    Found crosses_beyond(VertexId v, const HalfSpace& half, const Corner& y, CellId n) const;
    Found judge(CellId c, const Centre& centre, VertexId v, const HalfSpace& half) const;
    Found judge_from_outside(VertexId v, const HalfSpace& half) const;
    // The feet of `origin` (from v) on the faces of v's cell, or of its cut with the plane, no farther from it than the
    // root of bound2: calls visit(foot) for those that are the cell's own, so that each is a point of it.
    template <class Visit>
    void visit_feet(VertexId v, const AnyCellList& star, const HalfSpace* plane, const double* origin, double bound2,
                    Visit&& visit) const;
    bool is_own(VertexId v, const double* y, const AnyCellList& star) const;

    const int dim;
    const AnyStore& store_;
    const ReachRequest& request_;
};

[[gnu::cold]] Reach::HalfSpace Reach::half_space_of(VertexId v) const {
    const std::uint32_t d = request_.domains != nullptr ? request_.domains[v] : none;
    const double* centre = request_.outermost.centre;
    HalfSpace half = {};
    half.radius = request_.outermost.radius;
    if (d != none) {
        centre = store_.point(request_.cages[d].centre);
        half.radius = cage_epsilon * request_.cages[d].radius;
    }
    half.level = half.radius * half.radius - request_.limit2[v];
    for (int k = 0; k < dim; ++k) {
        const double a = store_.point(v)[k] - centre[k];
        half.centre[k] = -a;
        half.slope[k] = 2 * a;
        half.level -= a * a;
    }
    return half;
}

// *size: of what `above` is the sum.
template <class Number>
[[gnu::cold, gnu::noinline]] void Reach::see(CellId c, const Number* x, VertexId v, const HalfSpace& half,
                                             Corner* corner, double* size) const {
    using To = Digits<Number>;
    const double *const p = store_.point(store_.cell(c).vertex[0]), *const q = store_.point(v);
    Number above = To::of(-half.level);
    *size = absolute(half.level);
    corner->known = true;
    corner->y2 = 0;
    for (int k = 0; k < dim; ++k) {
        const Number y = x[k] - To::difference(q[k], p[k]);
        corner->y[k] = To::rounded(y);
        corner->y2 += corner->y[k] * corner->y[k];
        above = above + To::of(half.slope[k]) * y;
        *size += absolute(half.slope[k] * corner->y[k]);
    }
    corner->above = To::rounded(above);
}

// A corner far beyond the limit may be near the plane as seen from there, and is known to 2^-50 of its distance alone.
[[gnu::cold]] Reach::Corner Reach::corner_of(CellId c, const Centre& centre, VertexId v, const HalfSpace& half) const {
    Corner corner = {};
    double size = 0;
    if (centre.known) {
        see(c, centre.x, v, half, &corner, &size);
        if (!(corner.y2 > request_.limit2[v]) || absolute(corner.above) > sum_error * size) return corner;
    }
    WideFloat x[dimension_max];
    corner.known = solve_centre<WideFloat>(store_, c, x);
    if (corner.known) see(c, x, v, half, &corner, &size);
    return corner;
}

// Does the edge from the corner y, outside of the half-space, to that of cell n enter it beyond the limit?
[[gnu::cold]] Reach::Found Reach::crosses_beyond(VertexId v, const HalfSpace& half, const Corner& y, CellId n) const {
    const Corner z = corner_of(n, centre_of(n), v, half);
    if (!z.known) return Found::undecided;
    if (z.above > 0) return Found::within;
    // From z: it is within the limit, or else it is beyond as a corner.
    const double t = z.above / (z.above - y.above);
    double x2 = 0;
    for (int k = 0; k < dim; ++k) {
        const double x = z.y[k] + t * (y.y[k] - z.y[k]);
        x2 += x * x;
    }
    return x2 <= request_.limit2[v] ? Found::within : Found::beyond;
}

// By the corner of v's cell that is the centre of cell c, and the edges from there.
[[gnu::cold]] Reach::Found Reach::judge(CellId c, const Centre& centre, VertexId v, const HalfSpace& half) const {
    const Corner y = corner_of(c, centre, v, half);
    if (!y.known) return Found::undecided;
    // An edge is no longer than to its ends: only corners beyond the limit have edges that are.
    if (y.y2 <= request_.limit2[v]) return Found::within;
    Found found = y.above > 0 ? Found::within : Found::beyond;
    for (int i = 0; i <= dim && found == Found::within; ++i)
        if (store_.cell(c).vertex[i] != v) found = crosses_beyond(v, half, y, store_.cell(c).neighbour[i].cell());
    return found == Found::beyond && half.level < 0 ? judge_from_outside(v, half) : found;
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

template <class Visit>
[[gnu::cold]] void Reach::visit_feet(VertexId v, const AnyCellList& star, const HalfSpace* plane, const double* origin,
                                     double bound2, Visit&& visit) const {
    // Normals that others leave less of, by squares, than this of the whole count as dependent: an angle of 2^-60.
    // Frames have some that are so but for a rounding of coordinates, 2^-53.
    constexpr double least = 0x1p-120;
    for (std::uint32_t s = 0; s < star.size(); ++s) {
        const AnyCell cell = store_.cell(star[s]);
        store_.arena.pass(4u << dim);
        for (unsigned set = 0; set < (2u << dim) - 1; ++set) {
            // Orthonormal normals, and how far along each of them the flat is from the origin; the plane's first.
            DoubleDouble normal[dimension_max][dimension_max], along[dimension_max];
            double foot2 = 0;
            int size = 0;
            bool proper = true;
            for (int i = plane != nullptr ? -1 : 0; i <= dim && proper; ++i) {
                if (i >= 0 && (set >> i & 1u) == 0) continue;
                if (i >= 0 && (cell.vertex[i] == v || size == dim)) {
                    proper = false;
                    break;
                }
                DoubleDouble* const n = normal[size];
                DoubleDouble level = {i < 0 ? plane->level : 0, 0}, length2 = {0, 0}, rest2 = {0, 0};
                for (int k = 0; k < dim; ++k) {
                    n[k] = i < 0 ? DoubleDouble{plane->slope[k], 0}
                                 : exact_difference(store_.point(cell.vertex[i])[k], store_.point(v)[k]);
                    length2 = length2 + n[k] * n[k];
                }
                if (i >= 0) level = scaled(length2, 0.5);
                for (int k = 0; k < dim; ++k) level = level - n[k] * DoubleDouble{origin[k], 0};
                // Twice: what the first time leaves of directions before, by roundings, goes the second time.
                for (int pass = 0; pass < 2; ++pass)
                    for (int j = 0; j < size; ++j) {
                        DoubleDouble common = {0, 0};
                        for (int k = 0; k < dim; ++k) common = common + n[k] * normal[j][k];
                        for (int k = 0; k < dim; ++k) n[k] = n[k] - common * normal[j][k];
                        level = level - common * along[j];
                    }
                for (int k = 0; k < dim; ++k) rest2 = rest2 + n[k] * n[k];
                proper = rest2.high > least * length2.high;
                if (!proper) break;
                const DoubleDouble rest = {square_root(rest2.high), 0};
                for (int k = 0; k < dim; ++k) n[k] = n[k] / rest;
                along[size] = level / rest;
                foot2 += along[size].high * along[size].high;
                ++size;
                proper = foot2 <= bound2;
            }
            if (!proper) continue;
            double foot[dimension_max];
            for (int k = 0; k < dim; ++k) {
                DoubleDouble sum = {origin[k], 0};
                for (int j = 0; j < size; ++j) sum = sum + along[j] * normal[j][k];
                foot[k] = sum.high;
            }
            if (is_own(v, foot, star)) visit(foot);
        }
    }
}

// v is outside of the half-space, and what that leaves of its cell reaches beyond the limit. Is the point of it nearest
// to v within the limit, so that the segment between the two crosses the sphere of the limit, in the ball? If not all
// of it is beyond. Then nothing of it is in the ball when v is; else what is in the ball is all beyond or all within.
[[gnu::cold]] Reach::Found Reach::judge_from_outside(VertexId v, const HalfSpace& half) const {
    AnyCellList star(store_);
    bool fits = star.add(store_.vertex(v).cell);
    for (std::uint32_t s = 0; s < star.size() && fits; ++s) {
        const AnyCell cell = store_.cell(star[s]);
        for (int i = 0; i <= dim && fits; ++i) fits = cell.vertex[i] == v || star.add(cell.neighbour[i].cell());
    }
    if (!fits) return Found::out_of_memory;
    const double limit2 = request_.limit2[v], radius2 = half.radius * half.radius;
    const double nothing[dimension_max] = {};
    bool found = false;
    visit_feet(v, star, &half, nothing, limit2, [&](const double*) { found = true; });
    if (found) return Found::beyond;
    double away2 = 0, nearest2 = infinity, reach2 = 0;
    for (int k = 0; k < dim; ++k) away2 += half.centre[k] * half.centre[k];
    if (away2 <= radius2) return Found::within;
    const double inside2 = radius2 * (1 - cell_slack);
    visit_feet(v, star, nullptr, half.centre, inside2, [&](const double* foot) {
        double x2 = 0, y2 = 0;
        for (int k = 0; k < dim; ++k) {
            x2 += (foot[k] - half.centre[k]) * (foot[k] - half.centre[k]);
            y2 += foot[k] * foot[k];
        }
        if (!(x2 < nearest2)) return;
        nearest2 = x2;
        reach2 = y2;
    });
    return nearest2 < infinity && reach2 > limit2 ? Found::beyond : Found::within;
}

[[gnu::cold]] Status Reach::find_beyond(std::uint32_t* beyond) {
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 100 * dim); c < piece; ++c) {
            const Centre centre = centre_of(c);
            for (const VertexId v : store_.cell(c).vertex) {
                if (!(request_.limit2[v] < infinity)) continue;
                const Found found = judge(c, centre, v, half_space_of(v));
                if (found == Found::within) continue;
                if (found == Found::out_of_memory) return Status::out_of_memory;
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
