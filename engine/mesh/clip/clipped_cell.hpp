// How far a Voronoi cell, clipped to a ball, reaches from a point (the out-radius of definitions 2.4 and 4.5).
//
// The farthest point x is a corner of the cell inside the ball or it is on the ball's sphere. There it lies in the
// relative interior of some face of the cell. The sphere meets the flat of that face, of dimension j, in a sphere of
// dimension j - 1, on which the distance is largest at one point alone, its pole: opposite to the foot of the point
// that distances are measured from. So x is a corner, or the pole of a face of any dimension from 1 on: for an edge
// either of its two crossings, for the cell itself the point of the sphere that is opposite.
//
// In most cells x is a corner or a crossing of an edge. A plane tells the others: whatever of the ball is at s or more
// from u lies on one side of the plane that contains the intersection of the ball's sphere with that of radius s about
// u, because |x - c|^2 <= r^2 and |x - u| >= s give 2 (x - u) (u - c) <= r^2 - s^2 - |u - c|^2. A cell cut by this
// half-space is a polytope; when none of its corners is farther than s from u, no point of the clipped cell is. The
// other way round, when it has points on both sides of the sphere about u, the segment between them meets that sphere
// in a point of the clipped cell.
#pragma once
#include <cstdint>

#include "mesh/clip/any_corner.hpp"

namespace netmesh {

// Is the place y from p, |y| = length, nearer to w than to p? By the angle of y and w - p, so that it is as sharp for
// neighbours of p that are far nearer than the place as for others; to 2^-30, for places are poles with roundings.
inline bool is_nearer_to(int dim, const double* w, const double* p, const double* y, double length) {
    double nearer = 0, apart2 = 0;  // |y|^2 - |y - e|^2
    for (int k = 0; k < dim; ++k) {
        const double e = w[k] - p[k];
        nearer += e * (2 * y[k] - e);
        apart2 += e * e;
    }
    return nearer > 0 && nearer > 0x1p-30 * length * square_root(apart2);
}

// That half-space.
class Cut {
public:
    template <int D>
    Cut(const Domain<D>& ball, const double* u, double s2) : Cut(ball.dim, ball.centre, ball.radius, u, s2) {}
    // At most 0 in the half-space; dim is that of the ball.
    double height(int dim, const double* x) const {
        double sum = -level_;
        for (int k = 0; k < dim; ++k) sum += normal_[k] * (x[k] - u_[k]);
        return sum;
    }
    const double* origin() const { return u_; }
    double distance2() const { return s2_; }

private:
    Cut(int dim, const double* centre, double radius, const double* u, double s2) : u_(u), s2_(s2) {
        double away2 = 0;
        for (int k = 0; k < dim; ++k) {
            const double a = u[k] - centre[k];
            normal_[k] = 2 * a;
            away2 += a * a;
        }
        level_ = radius * radius - away2 - s2;
    }

    const double* u_;
    double s2_, level_, normal_[dimension_max];
};

// Corners of a cell cut by the half-space: the farthest one from its origin, and the nearest.
struct CutCorners {
    AnyCorner far;
    double near[dimension_max], near2 = infinity;
    bool unknown = false;  // a corner of the whole cell is not known: it is too flat for doubles

    explicit CutCorners(int dim) : far(dim) {}
    void offer(const double* x, double d2, CellId c) {
        far.offer(x, d2, c);
        if (!(d2 < near2)) return;
        near2 = d2;
        copy(far.dim, x, near);
    }
    bool reach_beyond(double s2) const { return unknown || far.distance2 > s2; }
};

// Where the cut meets the edge between the corners of two cells, Cell<dim> or AnyCell, at these heights, one of them
// above 0.
template <class Cell>
void cut_edge(int dim, const Cell& cell, double here, const Cell& other, double there, double* x) {
    // From the nearer end, as the other one may be farther away than its digits reach.
    const bool swap = other.radius2 < cell.radius2;
    const double* const a = swap ? other.centre : cell.centre;
    const double* const b = swap ? cell.centre : other.centre;
    const double t = swap ? there / (there - here) : here / (here - there);
    for (int k = 0; k < dim; ++k) x[k] = a[k] + t * (b[k] - a[k]);
}

// Offers those corners of Vor(w) after the cut that corner c of it gives rise to: itself, and where its edges are cut
// but for those that lead to a corner with a smaller index.
void offer_cut_corners(const AnyStore& store, const Cut& cut, VertexId w, CellId c, CutCorners* corners);

// May a corner of Vor(v) after the cut that cell c gives rise to be farther from the cut's origin u than its distance
// s? What is between corners within s cannot. near2: what is within the root of this from v is within s of u.
template <int D> bool may_reach_beyond(const Store<D>& store, const Cut& cut, VertexId v, double near2, CellId c) {
    const double s2 = cut.distance2();
    const Cell<D>& cell = store.cell(c);
    if (is_within(cell, near2)) return false;
    if (!(cell.radius2 < infinity)) return !store.is_ghost(c);
    if (!(distance2<D>(store.dim, cell.centre, cut.origin()) > s2)) return false;
    const double here = cut.height(store.dim, cell.centre);
    if (!(here > 0)) return true;
    for (int i = 0; i <= store.dim; ++i) {
        if (cell.vertex[i] == v || cell.neighbour[i] == none) continue;
        const Cell<D>& other = store.cell(cell.neighbour[i].cell());
        if (!(other.radius2 < infinity)) continue;
        const double there = cut.height(store.dim, other.centre);
        double x[DimensionOf<D>::most];
        if (there > 0) continue;
        cut_edge(store.dim, cell, here, other, there, x);
        if (distance2<D>(store.dim, x, cut.origin()) > s2) return true;
    }
    return false;
}

// The same for all cells at v. star[-1 - k], k < count: these.
template <int D>
[[gnu::noinline]] bool may_reach_beyond(const Store<D>& store, const Cut& cut, VertexId v, double near2,
                                        const CellId* star, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k)
        if (may_reach_beyond<D>(store, cut, v, near2, star[-1 - static_cast<std::ptrdiff_t>(k)])) return true;
    return false;
}

// A point of Vor(w) within the ball at distance s from u, the cut's origin, on the way to the farthest corner after the
// cut from w or from the nearest one, whichever is within s of u. False when none is, or no corner is beyond s.
bool find_reaching_point(const AnyStore& store, const Cut& cut, VertexId w, const CutCorners& corners, double* x);

// The flat of points equidistant from w and some others, by orthonormal normals; relative to u.
struct Flat {
    int dim;
    double normal[dimension_max][dimension_max];
    double offset[dimension_max];
    int codimension = 0;

    explicit Flat(int dim) : dim(dim) {}
    // False when the bisector of w and x is parallel to what there is.
    bool cut(const double* u, const double* w, const double* x);
    // The point of the flat nearest to p.
    void foot(const double* p, double* at) const;
    // A unit vector along the flat, the longest that an axis leaves.
    void direction(double* along) const;
    // The pole of the ball's sphere cut with the flat, as seen from u, and the point opposite to it; relative to u.
    // False when they do not meet.
    bool poles(const AnyDomain& ball, const double* u, double (&x)[2][dimension_max]) const;
};

// Offers the poles, as seen from u, of the faces of Vor(w) that its corner c belongs to, where contains(x), x relative
// to u, is true of them and they are farther than what has been offered; `left`: but for faces that a neighbour of c
// across a facet at any of these positions belongs to as well.
template <class Contains>
[[gnu::cold]] void offer_poles(const AnyStore& store, const AnyDomain& ball, const double* u, VertexId w, CellId c,
                               unsigned left, Contains&& contains, AnyCorner* farthest) {
    const int dim = store.dim;
    const AnyCell cell = store.cell(c);
    unsigned own = 0;
    for (int i = 0; i <= dim; ++i)
        if (cell.vertex[i] == w) own = 1u << i;
    for (unsigned set = 0; set < (2u << dim) - 1; ++set) {
        if ((set & own) != 0 || (left & ~set) != 0) continue;
        Flat flat(dim);
        bool proper = true;
        for (int i = 0; i <= dim && proper; ++i)
            if (set >> i & 1u)
                proper = flat.codimension < dim - 1 && flat.cut(u, store.point(w), store.point(cell.vertex[i]));
        double at[2][dimension_max];
        if (!proper || !flat.poles(ball, u, at)) continue;
        for (int side = 0; side < (flat.codimension == dim - 1 ? 2 : 1); ++side) {
            const double d2 = dot(dim, at[side], at[side]);
            if (!(d2 > farthest->distance2)) continue;
            if (!contains(at[side])) continue;
            for (int k = 0; k < dim; ++k) at[side][k] += u[k];
            farthest->offer(at[side], d2, c);
        }
    }
}

// The same for all faces of the cell of v. star[-1 - k], k < count: the cells at v, of which those that are finite
// count. O(2^D (D^2 + D count)) a cell, of which most is seldom needed.
void offer_poles(const AnyStore& store, const AnyDomain& ball, const double* u, VertexId v, const CellId* star,
                 std::uint32_t count, AnyCorner* farthest);
template <int D>
[[gnu::cold]] void offer_poles(const Store<D>& store, const Domain<D>& ball, const double* u, VertexId v,
                               const CellId* star, std::uint32_t count, Corner<D>* farthest) {
    AnyCorner corner(*farthest);
    offer_poles(AnyStore(store), AnyDomain(ball), u, v, star, count, &corner);
    *farthest = corner.of_dimension<D>();
}

// A point of v's clipped cell that is farther from u than the root of bound2, when no corner and no crossing of an edge
// is. distance2 of *found is negative when there is none. Just before, v's star of `count` cells has been visited.
void find_beyond(const AnyStore& store, const AnyDomain& ball, const double* u, VertexId v, double bound2,
                 std::uint32_t count, AnyCorner* found);
template <int D>
[[gnu::cold]] void find_beyond(const Store<D>& store, const Domain<D>& ball, const double* u, VertexId v, double bound2,
                               std::uint32_t count, Corner<D>* found) {
    *found = Corner<D>(store.dim);
    if (u == store.point(v) && !may_reach_beyond<D>(store, Cut(ball, u, bound2), v, bound2, store.list_top(), count))
        return;
    AnyCorner corner(store.dim);
    find_beyond(AnyStore(store), AnyDomain(ball), u, v, bound2, count, &corner);
    *found = corner.of_dimension<D>();
}

// Raises *out2, the squared distance from v to the farthest corner of its clipped cell or crossing of an edge, to that
// of its farthest pole. False when the gap is too small for v's star.
bool raise_to_poles(const AnyStore& store, const AnyDomain& ball, VertexId v, double* out2);

// out2[v] := squared distance to which v's clipped cell reaches; 0 for vertices that are exempt or not in the mesh,
// +infinity where the whole cell is not bounded. Corners that are not known are left out: neighbours have the same
// ones. Needs a compact store, and room for the star of a vertex in its gap. O(cells) and what poles take.
// out_of_memory.
Status measure_clipped_cells(const AnyStore& store, const AnyDomain& ball, double* out2);
// The same where out2[v] over nearest2 is largest; less elsewhere, perhaps. Most cells are only looked at.
Status measure_worst_cells(const AnyStore& store, const AnyDomain& ball, double* out2);

}  // namespace netmesh
