// How far Voronoi cells reach within a ball, as proven bounds: measure_clipped_cells (clipped_cell.hpp) has the same
// distances as they are computed.
//
// A cell of v, clipped to the ball of centre c and radius r, and a point u that distances are measured from: v itself
// or its nearest input. For any s >= 0 what is in the ball and at s or more from u lies in the half-space h(x) <= 0,
//
//   h(x) = |x - c|^2 - r^2 - |x - u|^2 + s^2 = 2 (x - u) (u - c) + |u - c|^2 - r^2 + s^2,
//
// so no point of the clipped cell is farther from u than the larger of s and B, B the distance of the farthest corner
// of the whole cell cut by the half-space. That holds whatever s is. It is near the truth when s is: a cell that has
// points on both sides of the sphere of radius s in the half-space has one on it, and that is in the ball.
//
// So when s is a little more than the true reach the cut cell is within s, and B proves s; or all of it is beyond, and
// then no point of it is in the ball. That is proven by a plane between the two: a unit vector w with w (x - c) > r for
// all corners x of the cut cell. Which of the two it is depends on how the farthest point moves when the ball grows:
// by less than the ball, or by more. A cell next to the sphere that is crossed by it is of the first kind; one that
// lies on the other side of c from u is of the second. w comes from the cut cell's point nearest to c. Where that is
// a corner, as where an edge crosses the sphere, or the pole of a face, it is known at once; for others a few steps are
// taken towards it (Gilbert): w from the nearest point so far, then on to the corner that is first along w.
//
// Roundings. Corners are known within `error` times their radius: a point of a true edge is within d of the point of
// the computed edge at the same share of its length, d the bounds of its two ends, mixed by that share, or the larger
// of them. (The far end of an edge that leaves the ball is often known much worse.) h changes by 2 |u - c| a unit of
// length, and its own evaluation is off by less than e = 2^-44 (2 |x - u| |u - c| + |u - c|^2 + r^2 + s^2), by
// sum_slack of rounding.hpp. So what is in the half-space of a true edge lies within d of the part of the computed one
// where the computed h is at most 2 |u - c| d + e; it is cut at 2 |u - c| d + 4 e, which leaves 2 e for the quotient
// that says where. |y - u| + d is largest at one of the part's two ends, as it is convex, and w y - d is least at one
// of them. For a corner x of the true cut cell and the end y of a part that stands for it, w (x - c) is less than
// the computed w (y - u) + w (u - c) by at most d, the rounding of y, 3 u times the distances of the edge's two ends,
// and 2^-44 (|y - u| + |u - c| + r), again by sum_slack, for the D + 1 roundings of the sum and those of |w| = 1.
//
// A vertex v outside of the ball, at |v - c| - r from it: the parts of its cell in the ball are at most that much less
// than B or s below the ball's sphere. Nor are they farther below it than r less the distance from c to the bisector of
// v and any other vertex w, (|v - c|^2 - |w - c|^2) / (2 |v - w|), where that is positive: c is on w's side.
#pragma once
#include "mesh/clip/any_corner.hpp"

namespace netmesh {

struct ClippedReach {
    double from_vertex;  // no point of the cell in the ball is farther from the vertex
    double below;        // nor farther from the sphere; for vertices in the ball infinite
};

// reach[v], rounded outwards. out_radius[v]: R_v or more of whole cells, as of measure_cells; becomes infinite for
// cells that are unbounded. Uses the marks `queued`, which must be 0 and are again. O(cells). Scratch: 16 bytes a
// vertex and the list of a star. out_of_memory.
Status bound_clipped_cells(const AnyStore& store, const AnyDomain& ball, double* out_radius, Arena& arena,
                           ClippedReach* reach);

// What of the bounds below is asked for.
struct NeededReach {
    const std::uint8_t* present = nullptr;  // [vertices] 0: the cell is outside of the ball; null: not known
    bool least_alone = false;               // out_radius of Steiner vertices only as far as d - R > d / 2 needs it
    double cut = infinity;                  // nor a reach, or out_radius of an input, that is more than this
};

// Lowers out_radius[v] and reach[v - first], as of measure_cells, to what holds in the ball: R_v of the clipped cell or
// more, and the largest distance of a point of it from v's nearest input or more. Both stay what they are for exempt
// vertices and where the whole cell is in the ball. Of a cell outside of the ball they say nothing, and what is not
// needed may stay.
//
// How much they are too large: s has to be so much more than the reach t that the half-space of a true edge, moved by
// the bounds of corners and by roundings, is still one for more than t: s^2 - t^2 >= S = 4 |u - c| d + 8 e. s/t - 1 is
// tried from 2^-38 on, 2^6 times as much a step, so it is at most 2^6 times the larger of 2^-38 and S / (2 t^2) where
// that is below 2^-20; 2 d are added for the corners themselves. For most cells that is 2^-32. Where the cut cell is
// outside of the ball but hardly so, few steps may not find the plane, and s is one that is larger; tests have found
// none (filtration/clipped_cells.cpp).
//
// Uses the marks `queued`, which must be 0 and are again, and those of cells. Needs a compact store and room for the
// star of a vertex in its gap. O(cells) and, of what the sphere crosses, a few walks over each star. out_of_memory.
Status clip_cell_bounds(const AnyStore& store, const AnyDomain& ball, const NeededReach& needed, double* out_radius,
                        double* reach, std::uint32_t first = 0);

// The same cell by cell, for those that can do without some: mark(), then for each that is_marked open() and what is
// needed, or pass_over(). Costs and needs as above.
class CellClipper {
public:
    CellClipper(const AnyStore& store, const AnyDomain& ball, const NeededReach& needed)
        : dim(store.dim), store_(store), ball_(ball), needed_(needed) {}

    // Marks as queued the vertices whose bounds can be lowered.
    void mark();
    bool is_marked(VertexId v) const { return store_.vertex(v).queued != 0; }
    void pass_over(VertexId v) { store_.vertex(v).queued = 0; }
    // Takes the mark of v. False: no room for its star. What follows is about v.
    bool open(VertexId v);
    // Lowers its bounds as clip_cell_bounds does; reach may be null for an input.
    void clip(double* out_radius, double* reach) const;
    // No point of the clipped cell is farther from u than this; `whole` holds for the whole cell, and is what comes
    // back when some point is as far as `enough`.
    double bound(const double* u, double whole, double enough) const;
    // Is B of the head at most s, so that no point of the clipped cell is farther from u than s?
    bool is_bound(const double* u, double s) const;

private:
    // What is beyond a distance s from u in the half-space.
    struct Beyond {
        double far = 0, near = infinity;  // most of any corner of the cut cell, least distance of one
        double first[dimension_max];      // the corner of the cut cell nearest to c, from c
        double first2 = infinity;
    };

    CellId star(std::uint32_t k) const { return store_.list_top()[-1 - static_cast<std::ptrdiff_t>(k)]; }
    // What goes over whole stars, for a dimension that the compiler knows: most of the time is theirs.
    template <int D> void mark_cells();
    template <int D> void measure(const double* u, double enough2, Corner<D>* farthest) const;
    template <int D> bool is_bound(const double* u, double s) const;
    template <class Show>
    void show_edge(const double* u, double s, const AnyCell& cell, const AnyCell& other, Show&& show) const;
    template <class Show> void cut(const double* u, double s, Show&& show) const;
    Beyond look_beyond(const double* u, double s) const;
    bool is_apart(const double* u, double s, const double* w, double* first) const;
    bool is_outside(const double* u, double s, const double* farthest, const Beyond& beyond) const;

    const int dim;
    const AnyStore& store_;
    const AnyDomain& ball_;
    const NeededReach needed_;
    VertexId v_ = none;
    std::uint32_t count_ = 0;
};

}  // namespace netmesh
