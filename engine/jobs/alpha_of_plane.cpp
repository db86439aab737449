// Degree 1 by duality: from the last edge to the first, an edge joins the regions on its two sides, the outside being
// the oldest, and ends the younger one, which was born with its triangle of largest radius. So the edge is the birth
// and this triangle the death of a bar. A marked edge (plane_values.hpp) joins its triangle to what is beyond from the
// start on: no other edge of that comes before. Where two triangles mark the same edge, one of them counts as one
// without a mark. Every other edge joins two components of degree 0, as a disk has no loop in the end.
#include "jobs/alpha_of_plane.hpp"

#include "delaunay/independent_points.hpp"
#include "delaunay/insert_all.hpp"
#include "delaunay/plane.hpp"
#include "filtration/plane_values.hpp"
#include "homology/pair_writer.hpp"
#include "homology/progress.hpp"
#include "homology/union_find.hpp"
#include "memory/prefetch.hpp"

namespace netmesh {
namespace {

template <class Words> class PlaneRegions {
public:
    // values: they end at the arena's high mark; the cells begin at `low`, and nothing else stands behind them.
    PlaneRegions(PlaneValues<Words>& values, std::size_t low, DiagramRequest request, const Work& work)
        : values_(values), low_(low), request_(request), arena_(work.arena), progress_{work.monitor} {}

    Status run(CountedPairs* out) {
        const Status status = unite_regions();
        if (status != Status::ok) return status;
        return gather_deaths() ? write(out) : Status::out_of_memory;
    }

private:
    using Index = typename Words::Index;

    void begin_regions();
    Status unite_regions();
    bool gather_deaths();
    Status write(CountedPairs* out);

    PlaneValues<Words>& values_;  // labels become 1 for edges that begin a bar, else 0
    const std::size_t low_;
    const DiagramRequest request_;
    Arena& arena_;
    Progress progress_;
    Index* region_ = nullptr;  // [cells + 1], the forest of regions; the last one is the outside
    double* death_ = nullptr;  // of bars in degree 1, in the order of their births; then of pairs of zero length
    std::uint32_t bars_ = 0, zero_bars_ = 0;
};

// Regions of one triangle each, but for those whose marked edge joins them to what is beyond.
template <class Words> void PlaneRegions<Words>::begin_regions() {
    const std::uint32_t outside = values_.mesh.cell_count;
    arena_.each(outside, 10, [this, outside](std::uint64_t at) {
        const std::uint32_t c = static_cast<std::uint32_t>(at);
        std::uint32_t region = c;
        if (values_.mark[c] != PlaneValues<Words>::unmarked) {
            const FacetId other = values_.beyond(c, values_.mark[c]);
            region = other == none ? outside : std::uint32_t{other.cell()};
            if (values_.is_marked(other)) values_.mark[other.cell()] = PlaneValues<Words>::unmarked;
            ++zero_bars_;
        }
        region_[c] = static_cast<Index>(region);
    });
    region_[outside] = static_cast<Index>(outside);
}

template <class Words> [[gnu::noinline]] Status PlaneRegions<Words>::unite_regions() {
    const std::uint32_t outside = values_.mesh.cell_count;
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, values_.own_edges);
    progress_.done = 0;
    region_ = arena_.take_high<Index>(std::size_t{outside} + 1);
    if (region_ == nullptr) return Status::out_of_memory;
    begin_regions();
    const double* const radius = values_.radius;
    const auto is_older = [=](std::uint32_t a, std::uint32_t b) {
        if (a == outside || b == outside) return a == outside;
        return radius[a] != radius[b] ? radius[a] > radius[b] : a > b;
    };
    for (std::uint32_t i = values_.own_edges; i-- > 0;) {
        constexpr std::uint32_t far = 24, near = 8;
        if (jumps_matter && i >= far) {
            prefetch(values_.mesh.cells + FacetId::from_word(values_.label[i - far]).cell());
            const FacetId later = FacetId::from_word(values_.label[i - near]),
                          other = values_.beyond(later.cell(), later.position());
            prefetch(region_ + later.cell());
            prefetch(region_ + (other == none ? outside : std::uint32_t{other.cell()}));
        }
        const FacetId facet = FacetId::from_word(values_.label[i]),
                      other = values_.beyond(facet.cell(), facet.position());
        std::uint32_t a = facet.cell(), b = other == none ? outside : std::uint32_t{other.cell()};
        values_.label[i] = none;
        if (unite(region_, a, b, is_older)) {
            values_.label[i] = b;
            ++bars_;
        }
        ++progress_.done;
        if (progress_.stop(1)) return Status::cancelled;
    }
    return Status::ok;
}

// Radii are wanted no more but as deaths, and cells not at all. False: out of memory.
template <class Words> [[gnu::noinline]] bool PlaneRegions<Words>::gather_deaths() {
    arena_.release_high(arena_.offset_of(values_.label));
    // Where cells were; a cell takes more than a double.
    double* const gathered = reinterpret_cast<double*>(arena_.at(low_));
    std::uint32_t count = 0;
    arena_.each(values_.own_edges, 6, [&](std::uint64_t i) {
        if (values_.label[i] != none) gathered[count++] = values_.radius[values_.label[i]];
        values_.label[i] = values_.label[i] != none ? 1 : 0;
    });
    if (request_.keep_zero)
        arena_.each(values_.mesh.cell_count, 4, [&](std::uint64_t c) {
            if (values_.mark[c] != PlaneValues<Words>::unmarked) gathered[count++] = values_.radius[c];
        });
    arena_.release_low(low_ + sizeof(double) * count);
    death_ = arena_.take_high<double>(count);
    if (death_ == nullptr) return false;
    move_bytes(death_, gathered, sizeof(double) * count, arena_);
    arena_.release_low(low_);
    return true;
}

template <class Words> [[gnu::noinline]] Status PlaneRegions<Words>::write(CountedPairs* out) {
    PairWriter writer(arena_, request_);
    bool fits = true;
    for (std::uint32_t degree = 0; degree < 2; ++degree) {
        const double* death = death_;
        arena_.each(values_.own_edges, 8, [&](std::uint64_t i) {
            if (values_.label[i] != degree || !fits) return;
            fits = degree == 0 ? writer.add(0, values_.half[i], 0) : writer.add(values_.half[i], *death++, 1);
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
    out->simplices = std::uint64_t{values_.mesh.point_count} + values_.edge_count() +
                     (request_.max_degree > 0 ? values_.mesh.cell_count : 0);
    return arena_.has_stopped() ? Status::cancelled : Status::ok;
}

// From the points as vertices of the store, in this order at the low end, from `low` on.
template <int D, class Words>
[[gnu::noinline]] Status triangulate_order(Store<D>& store, const std::uint32_t* order, std::size_t low,
                                           const VertexId* first, Monitor& monitor, PlaneTriangulation<Words>* out) {
    PlaneRun<D, NoWeights, Words> run(store, PlaneEnd::close);
    Status status = run.open(order, low);
    if (status == Status::ok) status = run.start(first);
    if (status == Status::ok) status = insert_all(run, store.state, monitor, nullptr);
    if (status == Status::ok) *out = run.close();
    return status;
}

template <int D, class Words>
[[gnu::noinline]] Status alpha_of_order(Store<D>& store, const std::uint32_t* order, std::size_t low,
                                        const VertexId* first, DiagramRequest request, const Work& work,
                                        CountedPairs* out) {
    PlaneValues<Words> values = {};
    Status status = triangulate_order<D, Words>(store, order, low, first, work.monitor, &values.mesh);
    if (status != Status::ok) return status;
    work.arena.release_high(work.arena.offset_of(values.mesh.points));
    status = plane_values<D>(work, &values);
    if (status != Status::ok) return status;
    return PlaneRegions<Words>(values, work.arena.offset_of(values.mesh.cells), request, work).run(out);
}

template <int D, bool are_few>
Status diagram_of_given(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
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
        return alpha_of_order<D, NarrowWords>(store, order, low, first, request.diagram, work, &out->found);
    if constexpr (!are_few)
        return alpha_of_order<D, WideWords>(store, order, low, first, request.diagram, work, &out->found);
}

template <bool are_few> Status diagram_in_plane(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    return with_dimension(2, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        if constexpr (D == 2)
            return diagram_of_given<D, are_few>(request, work, out);
        else
            return Status::internal;
    });
}

}  // namespace

Status alpha_of_plane(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    return diagram_in_plane<false>(request, work, out);
}

Status alpha_of_few_in_plane(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    return diagram_in_plane<true>(request, work, out);
}

}  // namespace netmesh
