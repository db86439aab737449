// From points in the plane to the diagram of their alpha complex, without a list of its simplices but of edges that
// have radii of their own. A part of alpha_of_points.cpp; templates, so that nothing of it is made where the plane is
// not served.
//
// Edges and triangles alone have radii. A triangle marks at most one edge, the one opposite
// an angle that is not acute (filtration/alpha.cpp): it has the triangle's radius, and the two are a pair of zero
// length, so the edge need not be listed. A right-angled triangle and its mirror image may mark the same edge; then one
// of the two is a triangle without a mark.
//
// Degree 1 by duality: from the last edge to the first, an edge joins the regions on its two sides, the outside being
// the oldest, and ends the younger one, which was born with its triangle of largest radius. So the edge is the birth
// and this triangle the death of a bar. A marked edge joins its triangle to what is beyond from the start on: no other
// edge of that comes before. Every other edge joins two components of degree 0, as a disk has no loop in the end.
#pragma once
#include "delaunay/independent_points.hpp"
#include "delaunay/insert_all.hpp"
#include "delaunay/plane.hpp"
#include "geometry/circumsphere_fast.hpp"
#include "geometry/circumsphere_settle.hpp"
#include "geometry/half_distance.hpp"
#include "homology/pair_writer.hpp"
#include "homology/progress.hpp"
#include "homology/union_find.hpp"
#include "jobs/alpha_of_points.hpp"
#include "memory/prefetch.hpp"
#include "numerics/value_order.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D, class Words> class PlaneAlpha {
public:
    // The triangulation is the last piece at the arena's low end, from `low` on, and its points at the high end.
    PlaneAlpha(const PlaneTriangulation<Words>& mesh, std::size_t low, DiagramRequest request, const Work& work)
        : mesh_(mesh), low_(low), request_(request), arena_(work.arena), progress_{work.monitor} {}

    Status run(CountedPairs* out);

private:
    using Index = typename Words::Index;
    static constexpr std::uint8_t unmarked = 3;
    static constexpr std::uint32_t batch_most = circumsphere_is_shared ? 1 : 2;
    using Lanes = std::conditional_t<circumsphere_is_shared, double, DoublePair>;
    static constexpr int shared = circumsphere_is_shared ? any_dimension : D;

    std::uint32_t edge_count() const { return mesh_.point_count + mesh_.cell_count - 1; }
    FacetId beyond(std::uint32_t cell, std::uint32_t position) const { return mesh_.cells[cell].neighbour[position]; }
    const double* point(std::uint32_t cell, std::uint32_t position) const {
        return mesh_.points + 2 * std::size_t{VertexId(mesh_.cells[cell].vertex[position])};
    }
    bool is_marked(FacetId facet) const { return facet != none && mark_[facet.cell()] == facet.position(); }
    // Act(facet) for each edge that is not marked, once, by its cell of lower number.
    template <class Act> void each_own_edge(std::uint32_t cell, Act&& act) const {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const FacetId facet(CellId(cell), i), other = beyond(cell, i);
            if ((other == none || other.cell() > cell) && !is_marked(facet) && !is_marked(other)) act(facet);
        }
    }

    Status find_radii();
    Status find_batch(std::uint32_t first, std::uint32_t count);
    Status list_edges();
    void measure_edges(const FacetId* facet, std::uint32_t count, double* half) const;
    void give_points_back();
    void begin_regions();
    Status unite_regions();
    bool gather_deaths();
    Status write(CountedPairs* out);

    const PlaneTriangulation<Words> mesh_;
    const std::size_t low_;
    const DiagramRequest request_;
    Arena& arena_;
    Progress progress_;
    double* radius_ = nullptr;      // of cells
    std::uint8_t* mark_ = nullptr;  // of cells: the position of the edge that one marks, or unmarked
    // Edges that are not marked, in the order of their values: half their lengths, and the facets that they are, each
    // in one word; in the end 1 of those that begin a bar, else 0.
    double* half_ = nullptr;
    std::uint32_t* label_ = nullptr;
    std::uint32_t own_edges_ = 0;
    Index* region_ = nullptr;  // [cells + 1], the forest of regions; the last one is the outside
    double* death_ = nullptr;  // of bars in degree 1, in the order of their births; then of pairs of zero length
    std::uint32_t bars_ = 0, zero_bars_ = 0;
};

template <int D, class Words> Status PlaneAlpha<D, Words>::find_radii() {
    const std::uint32_t count = mesh_.cell_count;
    progress_.monitor.begin(NETMESH_STAGE_FILTER, std::uint64_t{count} + edge_count());
    radius_ = arena_.take_low<double>(count);
    mark_ = arena_.take_low<std::uint8_t>(count);
    if (radius_ == nullptr || mark_ == nullptr) return Status::out_of_memory;
    for (std::uint32_t c = 0; c < count; c += batch_most) {
        const std::uint32_t size = count - c < batch_most ? count - c : batch_most;
        const Status status = find_batch(c, size);
        if (status != Status::ok) return status;
        progress_.done += size;
        if (progress_.stop(2 * size)) return Status::cancelled;
    }
    return Status::ok;
}

template <int D, class Words> inline Status PlaneAlpha<D, Words>::find_batch(std::uint32_t first, std::uint32_t count) {
    const double* corner[batch_most][3];
    const double* const* points[batch_most];
    for (std::uint32_t b = 0; b < batch_most; ++b) {
        const std::uint32_t c = first + (b < count ? b : 0);
        for (std::uint32_t i = 0; i < 3; ++i) corner[b][i] = point(c, i);
        points[b] = corner[b];
    }
    Circumsphere sphere[batch_most];
    const Certainty certain =
        circumspheres_fast<Lanes, shared, shared>(DimensionOf<shared>(2), DimensionOf<shared>(2), points, sphere);
    for (std::uint32_t b = 0; b < count; ++b) {
        const bool knows_within = (certain.within >> b & 1u) != 0, knows_radius = (certain.radius >> b & 1u) != 0;
        if (!(knows_within && knows_radius)) {
            const Status status =
                settle_circumsphere(points[b], 2, 2, !knows_within, !knows_radius, arena_, &sphere[b]);
            if (status != Status::ok) return status;
        }
        radius_[first + b] = sphere[b].radius;
        mark_[first + b] = unmarked;
        for (std::uint8_t i = 0; i < 3; ++i)
            if ((sphere[b].within >> i & 1u) != 0) mark_[first + b] = i;
    }
    return Status::ok;
}

// Half the lengths of up to batch_most edges.
template <int D, class Words>
void PlaneAlpha<D, Words>::measure_edges(const FacetId* facet, std::uint32_t count, double* half) const {
    const double* end[batch_most][2];
    for (std::uint32_t b = 0; b < batch_most; ++b) {
        const FacetId f = facet[b < count ? b : 0];
        end[b][0] = point(f.cell(), f.position() == 0 ? 1 : 0);
        end[b][1] = point(f.cell(), f.position() == 2 ? 1 : 2);
    }
    const auto difference = [&end](std::uint32_t d) {
        Lanes from = {}, to = {};
        for (std::uint32_t b = 0; b < batch_most; ++b) {
            set_lane(from, static_cast<int>(b), end[b][0][d]);
            set_lane(to, static_cast<int>(b), end[b][1][d]);
        }
        return exact_difference(to, from);
    };
    double fast[batch_most];
    const std::uint32_t certain = half_distances_fast<Lanes>(2, difference, fast);
    for (std::uint32_t b = 0; b < count; ++b)
        half[b] = (certain >> b & 1u) != 0 ? fast[b] : exact_half_distance(2, end[b][0], end[b][1]);
}

template <int D, class Words> Status PlaneAlpha<D, Words>::list_edges() {
    const std::uint32_t cells = mesh_.cell_count;
    own_edges_ = 0;
    arena_.each(cells, 20, [this](std::uint64_t c) {
        each_own_edge(static_cast<std::uint32_t>(c), [this](FacetId) { ++own_edges_; });
    });
    half_ = arena_.take_high<double>(own_edges_);
    label_ = arena_.take_high<std::uint32_t>(own_edges_);
    if (half_ == nullptr || label_ == nullptr) return Status::out_of_memory;
    FacetId waiting[batch_most];
    std::uint32_t done = 0, waits = 0;
    const auto measure = [&] {
        measure_edges(waiting, waits, half_ + done);
        for (std::uint32_t b = 0; b < waits; ++b) label_[done + b] = waiting[b].word();
        done += waits;
        waits = 0;
    };
    for (std::uint32_t c = 0; c < cells; ++c) {
        std::uint32_t found = 0;
        each_own_edge(c, [&](FacetId facet) {
            waiting[waits++] = facet;
            ++found;
            if (waits == batch_most) measure();
        });
        progress_.done += found;
        if (progress_.stop(1 + found)) return Status::cancelled;
    }
    if (waits > 0) measure();
    return Status::ok;
}

// What stands below the points moves up to where they were.
template <int D, class Words> void PlaneAlpha<D, Words>::give_points_back() {
    const std::size_t high = arena_.high_mark(), points = arena_.offset_of(mesh_.points);
    const std::size_t bytes = sizeof(double) * 2 * std::size_t{mesh_.point_count};
    move_bytes(arena_.at(high + bytes), arena_.at(high), points - high, arena_);
    arena_.release_high(high + bytes);
    half_ += 2 * std::size_t{mesh_.point_count};
    label_ += 4 * std::size_t{mesh_.point_count};
}

// Regions of one triangle each, but for those whose marked edge joins them to what is beyond.
template <int D, class Words> void PlaneAlpha<D, Words>::begin_regions() {
    const std::uint32_t outside = mesh_.cell_count;
    arena_.each(outside, 10, [this, outside](std::uint64_t at) {
        const std::uint32_t c = static_cast<std::uint32_t>(at);
        std::uint32_t region = c;
        if (mark_[c] != unmarked) {
            const FacetId other = beyond(c, mark_[c]);
            region = other == none ? outside : std::uint32_t{other.cell()};
            if (is_marked(other)) mark_[other.cell()] = unmarked;
            ++zero_bars_;
        }
        region_[c] = static_cast<Index>(region);
    });
    region_[outside] = static_cast<Index>(outside);
}

template <int D, class Words> Status PlaneAlpha<D, Words>::unite_regions() {
    const std::uint32_t outside = mesh_.cell_count;
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, own_edges_);
    progress_.done = 0;
    region_ = arena_.take_high<Index>(std::size_t{outside} + 1);
    if (region_ == nullptr) return Status::out_of_memory;
    begin_regions();
    const double* const radius = radius_;
    const auto is_older = [=](std::uint32_t a, std::uint32_t b) {
        if (a == outside || b == outside) return a == outside;
        return radius[a] != radius[b] ? radius[a] > radius[b] : a > b;
    };
    for (std::uint32_t i = own_edges_; i-- > 0;) {
        constexpr std::uint32_t far = 24, near = 8;
        if (jumps_matter && i >= far) {
            prefetch(mesh_.cells + FacetId::from_word(label_[i - far]).cell());
            const FacetId later = FacetId::from_word(label_[i - near]), other = beyond(later.cell(), later.position());
            prefetch(region_ + later.cell());
            prefetch(region_ + (other == none ? outside : std::uint32_t{other.cell()}));
        }
        const FacetId facet = FacetId::from_word(label_[i]), other = beyond(facet.cell(), facet.position());
        std::uint32_t a = facet.cell(), b = other == none ? outside : std::uint32_t{other.cell()};
        label_[i] = none;
        if (unite(region_, a, b, is_older)) {
            label_[i] = b;
            ++bars_;
        }
        ++progress_.done;
        if (progress_.stop(1)) return Status::cancelled;
    }
    return Status::ok;
}

// Radii are wanted no more but as deaths, and cells not at all. False: out of memory.
template <int D, class Words> bool PlaneAlpha<D, Words>::gather_deaths() {
    arena_.release_high(arena_.offset_of(label_));
    // Where cells were; a cell takes more than a double.
    double* const gathered = reinterpret_cast<double*>(arena_.at(low_));
    std::uint32_t count = 0;
    arena_.each(own_edges_, 6, [&](std::uint64_t i) {
        if (label_[i] != none) gathered[count++] = radius_[label_[i]];
        label_[i] = label_[i] != none ? 1 : 0;
    });
    if (request_.keep_zero)
        arena_.each(mesh_.cell_count, 4, [&](std::uint64_t c) {
            if (mark_[c] != unmarked) gathered[count++] = radius_[c];
        });
    arena_.release_low(low_ + sizeof(double) * count);
    death_ = arena_.take_high<double>(count);
    if (death_ == nullptr) return false;
    move_bytes(death_, gathered, sizeof(double) * count, arena_);
    arena_.release_low(low_);
    return true;
}

template <int D, class Words> Status PlaneAlpha<D, Words>::write(CountedPairs* out) {
    PairWriter writer(arena_, request_);
    bool fits = true;
    for (std::uint32_t degree = 0; degree < 2; ++degree) {
        const double* death = death_;
        arena_.each(own_edges_, 8, [&](std::uint64_t i) {
            if (label_[i] != degree || !fits) return;
            fits = degree == 0 ? writer.add(0, half_[i], 0) : writer.add(half_[i], *death++, 1);
        });
        if (degree == 0) fits = fits && writer.add_essential(0, 0);
    }
    if (request_.keep_zero)
        arena_.each(zero_bars_, 8, [&](std::uint64_t i) {
            const double radius = death_[bars_ + i];
            fits = fits && writer.add(radius, radius, 1);
        });
    if (!fits) return Status::out_of_memory;
    out->pairs = writer.finish_without_cycles();
    out->simplices = std::uint64_t{mesh_.point_count} + edge_count() + (request_.max_degree > 0 ? mesh_.cell_count : 0);
    return arena_.has_stopped() ? Status::cancelled : Status::ok;
}

template <int D, class Words> Status PlaneAlpha<D, Words>::run(CountedPairs* out) {
    Status status = find_radii();
    if (status == Status::ok) status = list_edges();
    if (status != Status::ok) return status;
    give_points_back();
    if (!sort_labelled(half_, label_, own_edges_, arena_)) return Status::out_of_memory;
    status = unite_regions();
    if (status != Status::ok) return status;
    return gather_deaths() ? write(out) : Status::out_of_memory;
}

// From the points as vertices of the store, in this order at the low end, from `low` on.
template <int D, class Words>
Status alpha_of_order(Store<D>& store, const std::uint32_t* order, const VertexId* first, std::size_t low,
                      DiagramRequest request, const Work& work, CountedPairs* out) {
    PlaneRun<D, NoWeights, Words> run(store);
    Status status = run.open(order, low);
    if (status == Status::ok) status = run.start(first);
    if (status == Status::ok) status = insert_all(run, store.state, work.monitor, nullptr);
    if (status != Status::ok) return status;
    const PlaneTriangulation<Words> mesh = run.close();
    work.arena.release_high(work.arena.offset_of(mesh.points));
    return PlaneAlpha<D, Words>(mesh, work.arena.offset_of(mesh.cells), request, work).run(out);
}

// As alpha_of_points, for D = 2, but that the pairs are left somewhere above the arena's low mark, with what was taken
// on the way. Memory, in 16-bit words up to 8,192 points and in 32-bit words beyond: 42 and 68 bytes a point while
// points are inserted; 58 and 82, and 12 for each edge with no point in its smallest circle, when radii are known; in
// the end 12 for each such edge, 8 for each bar of degree 1 and 24 for each bar. Uniform points have 2 such edges and
// nearly 2 bars each. are_few: there is no code for wide words.
template <int D, bool are_few>
Status alpha_of_plane(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    const std::size_t low = work.arena.low_mark();
    StoreState state = {};
    Store<D> store(work.arena, state);
    std::uint32_t* order;
    const Status status =
        take_input<D>(store, request.points, request.count, request.seed, work.monitor, &out->input, &order);
    if (status != Status::ok) return status;
    out->distinct = state.vertex_count;
    VertexId first[D + 1];
    if (!independent_points(store, order, state.vertex_count, first)) return Status::flat;
    if (are_few || state.vertex_count <= NarrowWords::points_max)
        return alpha_of_order<D, NarrowWords>(store, order, first, low, request.diagram, work, &out->found);
    if constexpr (!are_few)
        return alpha_of_order<D, WideWords>(store, order, first, low, request.diagram, work, &out->found);
}

}  // namespace netmesh
