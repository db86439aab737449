// Values of the alpha filtration of points in the plane, without a list of its simplices but of edges that have radii
// of their own. Templates: a part of jobs/alpha_of_plane.cpp.
//
// Edges and triangles alone have radii. A triangle marks at most one edge, the one opposite an angle that is not acute
// (filtration/alpha.cpp): it has the triangle's radius, and the two are a pair of zero length, so the edge need not be
// listed. A right-angled triangle and its mirror image may mark the same edge.
#pragma once
#include "delaunay/plane_cells.hpp"
#include "geometry/circumsphere_fast.hpp"
#include "geometry/circumsphere_settle.hpp"
#include "geometry/half_distance.hpp"
#include "memory/work.hpp"
#include "numerics/value_order.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

template <class Words> struct PlaneValues {
    static constexpr std::uint8_t unmarked = 3;

    PlaneTriangulation<Words> mesh;
    double* radius;      // of cells
    std::uint8_t* mark;  // of cells: the position of the edge that one marks, or unmarked
    // Edges that are not marked, in the order of their values: half their lengths, and the facets that they are, each
    // in one word.
    double* half;
    std::uint32_t* label;
    std::uint32_t own_edges;

    std::uint32_t edge_count() const { return mesh.point_count + mesh.cell_count - 1; }
    FacetId beyond(std::uint32_t cell, std::uint32_t position) const { return mesh.cells[cell].neighbour[position]; }
    bool is_marked(FacetId facet) const { return facet != none && mark[facet.cell()] == facet.position(); }
};

template <int D, class Words> class PlaneValuesFinder {
public:
    PlaneValuesFinder(const Work& work, PlaneValues<Words>* values)
        : arena_(work.arena), monitor_(work.monitor), values_(*values) {}

    Status run();

private:
    static constexpr std::uint32_t batch_most = circumsphere_is_shared ? 1 : 2;
    using Lanes = std::conditional_t<circumsphere_is_shared, double, DoublePair>;
    static constexpr int shared = circumsphere_is_shared ? any_dimension : D;

    const double* point(std::uint32_t cell, std::uint32_t position) const {
        return values_.mesh.points + 2 * std::size_t{VertexId(values_.mesh.cells[cell].vertex[position])};
    }
    // act(facet) for each edge that is not marked, once, by its cell of lower number.
    template <class Act> void each_own_edge(std::uint32_t cell, Act&& act) const {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const FacetId facet(CellId(cell), i), other = values_.beyond(cell, i);
            const bool is_met_first = other == none || other.cell() > cell;
            if (is_met_first && !values_.is_marked(facet) && !values_.is_marked(other)) act(facet);
        }
    }
    bool stop(std::uint32_t work) { return monitor_.advance(done_, work); }

    Status find_radii();
    Status find_batch(std::uint32_t first, std::uint32_t count);
    Status list_edges();
    void measure_edges(const FacetId* facet, std::uint32_t count, double* half) const;
    void give_points_back();

    Arena& arena_;
    Monitor& monitor_;
    PlaneValues<Words>& values_;
    std::uint64_t done_ = 0;
};

template <int D, class Words> [[gnu::noinline]] Status PlaneValuesFinder<D, Words>::find_radii() {
    const std::uint32_t count = values_.mesh.cell_count;
    monitor_.begin(NETMESH_STAGE_FILTER, std::uint64_t{count} + values_.edge_count());
    values_.radius = arena_.take_low<double>(count);
    values_.mark = arena_.take_low<std::uint8_t>(count);
    if (values_.radius == nullptr || values_.mark == nullptr) return Status::out_of_memory;
    for (std::uint32_t c = 0; c < count; c += batch_most) {
        const std::uint32_t size = count - c < batch_most ? count - c : batch_most;
        const Status status = find_batch(c, size);
        if (status != Status::ok) return status;
        done_ += size;
        if (stop(2 * size)) return Status::cancelled;
    }
    return Status::ok;
}

template <int D, class Words>
inline Status PlaneValuesFinder<D, Words>::find_batch(std::uint32_t first, std::uint32_t count) {
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
        values_.radius[first + b] = sphere[b].radius;
        values_.mark[first + b] = PlaneValues<Words>::unmarked;
        for (std::uint8_t i = 0; i < 3; ++i)
            if ((sphere[b].within >> i & 1u) != 0) values_.mark[first + b] = i;
    }
    return Status::ok;
}

// Half the lengths of up to batch_most edges.
template <int D, class Words>
void PlaneValuesFinder<D, Words>::measure_edges(const FacetId* facet, std::uint32_t count, double* half) const {
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

template <int D, class Words> [[gnu::noinline]] Status PlaneValuesFinder<D, Words>::list_edges() {
    const std::uint32_t cells = values_.mesh.cell_count;
    values_.own_edges = 0;
    arena_.each(cells, 20, [this](std::uint64_t c) {
        each_own_edge(static_cast<std::uint32_t>(c), [this](FacetId) { ++values_.own_edges; });
    });
    values_.half = arena_.take_high<double>(values_.own_edges);
    values_.label = arena_.take_high<std::uint32_t>(values_.own_edges);
    if (values_.half == nullptr || values_.label == nullptr) return Status::out_of_memory;
    FacetId waiting[batch_most];
    std::uint32_t done = 0, waits = 0;
    const auto measure = [&] {
        measure_edges(waiting, waits, values_.half + done);
        for (std::uint32_t b = 0; b < waits; ++b) values_.label[done + b] = waiting[b].word();
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
        done_ += found;
        if (stop(1 + found)) return Status::cancelled;
    }
    if (waits > 0) measure();
    return Status::ok;
}

// What stands below the points moves up to where they were.
template <int D, class Words> void PlaneValuesFinder<D, Words>::give_points_back() {
    const std::size_t high = arena_.high_mark(), points = arena_.offset_of(values_.mesh.points);
    const std::size_t bytes = sizeof(double) * 2 * std::size_t{values_.mesh.point_count};
    move_bytes(arena_.at(high + bytes), arena_.at(high), points - high, arena_);
    arena_.release_high(high + bytes);
    values_.half += 2 * std::size_t{values_.mesh.point_count};
    values_.label += 4 * std::size_t{values_.mesh.point_count};
}

template <int D, class Words> Status PlaneValuesFinder<D, Words>::run() {
    Status status = find_radii();
    if (status == Status::ok) status = list_edges();
    if (status != Status::ok) return status;
    give_points_back();
    return sort_labelled(values_.half, values_.label, values_.own_edges, arena_) ? Status::ok : Status::out_of_memory;
}

// values->mesh is given: its cells are the last piece at the arena's low end, its points the last one at the high end.
// These are given back. Radii and marks are put behind the cells, the rest at the high end.
// ok, out_of_memory, out_of_range, cancelled.
template <int D, class Words> Status plane_values(const Work& work, PlaneValues<Words>* values) {
    return PlaneValuesFinder<D, Words>(work, values).run();
}

}  // namespace netmesh
