// Star by star. The cells at a point are asked for conflicts with points that are not there yet; what is found is
// inserted, until nothing is found. Then the star is final, for no point can be in conflict with its cells, and none of
// them is asked for again at its other vertices.
//
// To ask for a cell means to walk down the tree of boxes, but not into the node's own points. A ball meets a box if it
// does with its error added; what lies beyond a hull facet is beyond the plane through it, so a box whose corners are
// all not beyond it, exactly, has no such point. A point in the plane of a hull facet that is in conflict with the
// outside is in conflict with the cell behind, too, and found there. Of all points in conflict with a cell the one that
// is nearest to the star's vertex is taken: mostly it stays in the star.
//
// From the start all points are there that are near the node's own box, about as far as its points are apart: balls
// that do not leave that neighbourhood need not be asked for. And so that there are no huge balls some others are
// there, too: one of each box that is small for how far away it is.
#include "pieces/stars.hpp"

#include "delaunay/independent_points.hpp"
#include "delaunay/kernel.hpp"
#include "delaunay/spatial_order.hpp"
#include "pieces/others.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// As in triangulate.cpp: balls only answer whether a point is inside.
constexpr double star_error_max = 0x1p-7;

template <int D> class Stars {
public:
    Stars(Store<D>& store, const PointSource& source, PieceNode node, const Work& work, StarsReport* report)
        : store_(store), kernel_(store, star_error_max, VertexCells::kept, TieOrder::of_rows), source_(source),
          others_(source, node, *report), node_(node), work_(work), report_(*report) {}

    Status run() {
        Status status = take_own();
        if (status == Status::ok) status = take_others();
        if (status == Status::ok) status = triangulate_first();
        if (status == Status::ok) status = certify();
        if (status != Status::ok) return status;
        store_.truncate_vertices(store_.state.vertex_count - 1);  // the probe
        store_.compact(low_);
        report_.halo = store_.state.vertex_count - report_.own;
        return Status::ok;
    }

private:
    // Functions are not inlined into one another: their buffers would stand on the stack at once.
    static constexpr double reach_factor = 1.6, graded_factor = 16;  // measured
    static constexpr std::uint32_t found_max = 64;
    // Of balls whose points are asked for together; of others each is asked for by itself.
    static constexpr double near_error = 0.01;

    void fill_vertex(VertexId v, const double* x, std::uint32_t row, std::uint32_t position) {
        Vertex<D>& vertex = store_.vertex(v);
        for (int k = 0; k < D; ++k) vertex.x[k] = x[k];
        vertex.nearest2 = infinity;
        vertex.cell = none;
        vertex.next = VertexId(position);
        vertex.origin = row;
        vertex.marker = Marker::input;
        vertex.queued = 0;
        vertex.size_hint = 0;
    }
    Status append(std::uint32_t position) {
        double x[D];
        std::uint32_t row;
        if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
        const Status status = source_.read({position, position + 1}, x, &row);
        if (status == Status::ok) fill_vertex(store_.new_vertex(), x, row, position);
        return status;
    }

    // The node's own points become the first vertices.
    [[gnu::noinline]] Status take_own() {
        low_ = work_.arena.low_mark();
        const PieceRange own = source_.range(node_);
        report_.own = own.count();
        near_ = work_.arena.template take_low<NearPoints<D>>(1);
        if (near_ == nullptr) return Status::out_of_memory;
        const Status opened = store_.open_vertices(own.count());
        if (opened != Status::ok) return opened;
        for (std::uint32_t first = own.first; first < own.last;) {
            const std::uint32_t left = own.last - first;
            const PieceRange some = {first, first + (left < piece_points_most ? left : piece_points_most)};
            double x[piece_points_most * D];
            std::uint32_t row[piece_points_most];
            const Status status = source_.read(some, x, row);
            if (status != Status::ok) return status;
            for (std::uint32_t i = 0; i < some.count(); ++i)
                fill_vertex(VertexId(first - own.first + i), x + i * D, row[i], first + i);
            first = some.last;
            work_.arena.step(first / piece_points_most, 300 * D);
        }
        return Status::ok;
    }

    [[gnu::noinline]] Status append_neighbours(PieceRange range) {
        double x[piece_points_most * D];
        std::uint32_t row[piece_points_most];
        const Status status = source_.read(range, x, row);
        for (std::uint32_t i = 0; i < range.count() && status == Status::ok; ++i) {
            Box<D> point;
            for (int k = 0; k < D; ++k) point.least[k] = point.most[k] = x[i * D + static_cast<std::uint32_t>(k)];
            if (!others_.is_near(point)) continue;
            if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
            fill_vertex(store_.new_vertex(), x + i * D, row[i], range.first + i);
        }
        return status;
    }

    // Points of others to begin with.
    [[gnu::noinline]] Status take_others() {
        const Status status = others_.open(reach_factor, work_.arena);
        if (status != Status::ok) return status;
        return others_.begin(
            graded_factor, [this](PieceRange range) { return append_neighbours(range); },
            [this](std::uint32_t position) { return append(position); });
    }

    // More points until they span space; flat: all do not. Those that are there already are refused once more.
    [[gnu::noinline]] Status span(IndependentPoints* first) {
        const std::uint32_t vertices = store_.state.vertex_count;
        for (std::uint32_t v = 0; v < vertices && !first->are_enough(); ++v) {
            work_.arena.step(v, 300);
            first->offer(VertexId(v));
        }
        for (std::uint32_t i = 0; i < source_.points() && !first->are_enough(); ++i) {
            const std::uint32_t last = store_.state.vertex_count;
            const Status status = append(i);
            if (status != Status::ok) return status;
            first->offer(VertexId(last));
            if (work_.monitor.advance(i, 1)) return Status::cancelled;
            // Those that are of no use are not kept.
            if (first->last() != VertexId(last)) store_.truncate_vertices(last);
        }
        return first->are_enough() ? Status::ok : Status::flat;
    }

    [[gnu::noinline]] Status triangulate_first() {
        const AnyStore any(store_);
        IndependentPoints first(any);
        Status status = span(&first);
        if (status != Status::ok) return status;
        const std::uint32_t count = store_.state.vertex_count;
        std::uint32_t* const order = work_.arena.take_low<std::uint32_t>(count);
        if (order == nullptr) return Status::out_of_memory;
        bool repeats;
        status = spatial_order<D>(reinterpret_cast<const unsigned char*>(store_.point(0)), Store<D>::vertex_stride,
                                  count, 0, work_.arena, order, &repeats);
        if (status == Status::ok) status = store_.open_cells();
        if (status == Status::ok) status = kernel_.start(first.ids());
        if (status != Status::ok) return status;
        if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
        store_.new_vertex();  // the probe: whoever is asked about, inserted or not
        work_.monitor.begin(NETMESH_STAGE_DELAUNAY, count);
        for (std::uint32_t k = 0; k < count; ++k) {
            const VertexId v(order[k]);
            if (store_.vertex(v).cell != none) continue;
            if (!insert(v, store_.state.last_cell)) return Status::out_of_memory;
            if (work_.monitor.advance(k, 8 * D)) return Status::cancelled;
        }
        return Status::ok;
    }
    [[gnu::noinline]] bool insert(VertexId v, CellId near) {
        const double* const q = store_.point(v);
        const CellId hit = kernel_.locate(q, v, near);
        Cavity cavity;
        if (!kernel_.find_cavity(q, v, hit, &cavity) || !kernel_.can_fill(cavity, 1)) return false;
        kernel_.fill(cavity, v);
        return true;
    }

    VertexId probe() const { return VertexId(store_.state.vertex_count - 1); }

    [[gnu::noinline]] Status certify() {
        work_.monitor.begin(NETMESH_STAGE_DELAUNAY, report_.own);
        find_inside();
        for (std::uint32_t v = 0; v < report_.own; ++v) {
            if (store_.vertex(v).queued != 0) continue;
            const Status status = certify_star(VertexId(v));
            if (status != Status::ok) return status;
            if (work_.monitor.advance(v, 8 * D)) return Status::cancelled;
        }
        return Status::ok;
    }
    // Stars of cells that are where no other points are need not be looked at.
    void find_inside() {
        for (std::uint32_t v = 0; v < report_.own; ++v) store_.vertex(v).queued = 1;
        work_.arena.each(store_.state.cell_slots, 10 * D, [this](std::uint64_t index) {
            const Cell<D>& cell = store_.cell(static_cast<std::uint32_t>(index));
            if (!store_.is_live(static_cast<std::uint32_t>(index)) || others_.is_inside(cell)) return;
            for (const VertexId w : cell.vertex)
                if (w != none) store_.vertex(w).queued = 0;
        });
    }
    [[gnu::noinline]] Status certify_star(VertexId v) {
        for (;;) {
            found_count_ = 0;
            Status status = ask_for_star(v);
            if (status != Status::ok) return status;
            if (found_count_ == 0) break;
            for (std::uint32_t i = 0; i < found_count_; ++i) {
                double x[D];
                std::uint32_t row;
                status = source_.read({found_[i], found_[i] + 1}, x, &row);
                if (status != Status::ok) return status;
                const VertexId w = probe();
                fill_vertex(w, x, row, found_[i]);
                if (!insert(w, store_.vertex(v).cell)) return Status::out_of_memory;
                store_.new_vertex();
            }
            if (work_.arena.has_stopped()) return Status::cancelled;
        }
        store_.vertex(v).queued = 1;
        return Status::ok;
    }
    // Looks for a point in conflict with each cell of the star. Where balls are of the size of the star, the points
    // that reach into any of them are read once; else the tree is walked for each.
    [[gnu::noinline]] Status ask_for_star(VertexId v) {
        double reach2 = 0;
        Status status = Status::ok;
        const auto measure = [&](CellId c) {
            const Cell<D>& cell = store_.cell(c);
            if (!(static_cast<double>(cell.error) < near_error)) return;
            if (cell.radius2 > reach2 && !is_final(c) && !others_.is_inside(cell)) reach2 = cell.radius2;
        };
        if (!kernel_.visit_star(v, measure)) return Status::out_of_memory;
        // A point of a ball, its error included, is no farther from v than 2.04 times the radius: its distance from the
        // centre is at most r sqrt((1 + 3 E) / (1 - E)), that of v at most r (1 + 2 E).
        bool is_read = false;
        if (reach2 > 0) status = others_.read_near(store_.point(v), 4.2 * reach2, near_, &is_read);
        const auto ask = [&](CellId c) {
            if (status != Status::ok || found_count_ == found_max || is_final(c)) return;
            const bool is_ghost = store_.ghost_position(c) >= 0;
            if (!is_ghost && others_.is_inside(store_.cell(c))) return;
            ++report_.queries;
            if (!is_ghost && is_read && static_cast<double>(store_.cell(c).error) < near_error)
                find_near(c, store_.point(v));
            else
                status = ask_for(c, v);
        };
        if (status == Status::ok && !kernel_.visit_star(v, ask)) return Status::out_of_memory;
        return status;
    }
    void find_near(CellId c, const double* centre) {
        double best2 = infinity;
        std::uint32_t best = none;
        for (std::uint32_t i = 0; i < near_->count; ++i)
            if (is_better(c, near_->x + i * D, near_->row[i], near_->position[i], centre, best != none, &best2))
                best = near_->position[i];
        if (best != none) add_found(best);
    }
    // Whether a point is in conflict with the cell and nearer than the one that was found before.
    bool is_better(CellId c, const double* x, std::uint32_t row, std::uint32_t position, const double* centre,
                   bool is_found, double* best2) {
        double bound;
        const Cell<D>& cell = store_.cell(c);
        if (power<D>(cell, x, &bound) > bound && cell.radius2 < infinity) return false;
        double away2 = 0;
        for (int k = 0; k < D; ++k) away2 += (x[k] - centre[k]) * (x[k] - centre[k]);
        if (away2 > *best2 || (away2 == *best2 && is_found)) return false;
        for (const VertexId w : cell.vertex)
            if (w != none && store_.vertex(w).origin == row) return false;
        fill_vertex(probe(), x, row, position);
        if (!kernel_.in_conflict(c, store_.point(probe()), probe())) return false;
        *best2 = away2;
        return true;
    }
    // Is it in a star that is final?
    bool is_final(CellId c) const {
        for (const VertexId w : store_.cell(c).vertex)
            if (w != none && store_.vertex(w).queued != 0) return true;
        return false;
    }

    // Looks for a point that is in conflict with the cell and adds it to found_.
    [[gnu::noinline]] Status ask_for(CellId c, VertexId v) {
        const int infinite = store_.ghost_position(c);
        if (infinite < 0) sharpen(c);
        const double* const centre = store_.point(v);
        double best2 = infinity;
        std::uint32_t best = none;
        const Status status = others_.walk(
            centre, &best2,
            [&](PieceNode, const Box<D>& box) {
                return infinite < 0 ? meets_ball(c, box) : reaches_beyond(c, infinite, box);
            },
            [&](PieceRange range) { return look_through(c, range, centre, &best2, &best); });
        if (status != Status::ok) return status;
        if (best != none) add_found(best);
        return Status::ok;
    }
    [[gnu::noinline]] Status look_through(CellId c, PieceRange range, const double* centre, double* best2,
                                          std::uint32_t* best) {
        double x[piece_points_most * D];
        std::uint32_t row[piece_points_most];
        const Status status = source_.read(range, x, row);
        if (status != Status::ok) return status;
        for (std::uint32_t i = 0; i < range.count(); ++i)
            if (is_better(c, x + i * D, row[i], range.first + i, centre, *best != none, best2)) *best = range.first + i;
        return Status::ok;
    }
    void add_found(std::uint32_t position) {
        for (std::uint32_t i = 0; i < found_count_; ++i)
            if (found_[i] == position) return;
        found_[found_count_++] = position;
    }

    // Of a ball that is larger than the points are apart, even a small part of its radius is far.
    void sharpen(CellId c) {
        constexpr double error_max = 0x1p-42;
        Cell<D>& cell = store_.cell(c);
        const double error = static_cast<double>(cell.error);
        if (error > error_max && !(error * error * cell.radius2 < others_.own().diagonal2() * 0x1p-24))
            solve_cell<D>(store_, error_max, cell);
    }
    // A point of the box in conflict has |q - c|^2 - r^2 <= E (|q - c|^2 + 3 r^2) (sphere.hpp), so a box at distance d
    // is out of reach when d^2 (1 - 2 E) > r^2 (1 + 4 E); E is taken larger than all roundings here.
    bool meets_ball(CellId c, const Box<D>& box) const {
        const Cell<D>& cell = store_.cell(c);
        const double error = static_cast<double>(cell.error) + 0x1p-40;
        if (!(error < 0.125)) return true;
        return !(box.distance2(cell.centre) * (1 - 2 * error) > cell.radius2 * (1 + 4 * error) + 0x1p-950);
    }
    [[gnu::noinline]] bool reaches_beyond(CellId c, int infinite, const Box<D>& box) {
        const Cell<D>& cell = store_.cell(c);
        double corner[D];
        const double* p[D + 1];
        for (int i = 0; i <= D; ++i) p[i] = i == infinite ? corner : store_.point(cell.vertex[i]);
        for (std::uint32_t bits = 0; bits < 1u << D; ++bits) {
            for (int k = 0; k < D; ++k) corner[k] = (bits >> k & 1u) != 0 ? box.most[k] : box.least[k];
            if (orient<D>(p, store_.state.orient_counts) == Sign::positive) return true;
        }
        return false;
    }

    Store<D>& store_;
    Kernel<D> kernel_;
    const PointSource& source_;
    Others<D> others_;
    const PieceNode node_;
    const Work& work_;
    StarsReport& report_;
    std::size_t low_ = 0;
    std::uint32_t found_[found_max], found_count_ = 0;  // positions
    NearPoints<D>* near_ = nullptr;                     // at the low end, where cells come to lie
};

}  // namespace

template <int D>
Status certified_stars(Store<D>& store, const PointSource& source, PieceNode node, const Work& work,
                       StarsReport* report) {
    *report = StarsReport{};
    return Stars<D>(store, source, node, work, report).run();
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status certified_stars<D>(Store<D>&, const PointSource&, PieceNode, const Work&, StarsReport*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
