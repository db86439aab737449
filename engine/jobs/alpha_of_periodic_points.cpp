#include "jobs/alpha_of_periodic_points.hpp"

#include "complex/faces.hpp"
#include "filtration/alpha.hpp"
#include "filtration/point_records.hpp"
#include "homology/matrix/ball.hpp"
#include "numerics/sort.hpp"
#include "periods/final_stars.hpp"
#include "periods/orbits.hpp"
#include "periods/wanted_copies.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Of points spread evenly, mostly enough: the largest empty balls are this many times as wide as points are apart.
template <int D> constexpr double first_margin = D == 2 ? 3.5 : 2.9;
// Copies that are this near are triangulated without being asked for; in the plane all are, as they are few.
template <int D> constexpr double near_margin = D == 3 ? 1.2 : 1;
// So few copies are taken at once, and nothing is asked.
constexpr double copies_at_once = 300;

template <int D> class PeriodicAlpha {
public:
    PeriodicAlpha(const AlphaOfPeriodicPoints& request, const Work& work, PeriodicAlphaDiagram* out,
                  QuotientCycles* cycles)
        : request_(request), work_(work), arena_(work.arena), out_(*out), cycles_(cycles) {}

    Status run() {
        const std::size_t low = arena_.low_mark();
        Status status = take_periodic_points<D>(request_.input, work_, &points_, &out_.report);
        if (status == Status::ok) status = triangulate_copies();
        const std::size_t high = arena_.high_mark();
        if (status == Status::ok) status = find_values();
        std::uint32_t* vertices[D + 1];
        const bool wants_cycles = cycles_ != nullptr;
        if (status == Status::ok)
            status = take_orbits(points_, copies_, dimension(), work_, &faces_, value_,
                                 wants_cycles ? vertices : nullptr, &repeats_);
        if (status != Status::ok) return status;
        arena_.release_high(high);
        return wants_cycles ? reduce_with_cycles(low, vertices) : reduce();
    }

private:
    static constexpr int numbers = D + 1;
    bool has_weights() const { return request_.input.weights != nullptr; }
    bool are_radii() const { return has_weights() && request_.input.weights->are_radii; }
    int dimension() const {
        const std::uint32_t wanted = request_.diagram.max_degree + 1;
        return wanted < D ? static_cast<int>(wanted) : D;
    }

    // How far points are apart, the box cut into cubes.
    double spacing() const {
        double sides[D], volume = 1;
        for (int k = 0; k < D; ++k) {
            double least = infinity, most = -infinity;
            arena_.each(points_.count, 4, [&](std::uint64_t i) {
                const double x = points_.x[i * numbers + static_cast<std::size_t>(k)];
                least = x < least ? x : least;
                most = x > most ? x : most;
            });
            sides[k] = most - least;
        }
        // Sides of the lattice take the place of as many of the longest ones.
        for (int j = 0; j < points_.lattice.count; ++j) {
            int longest = 0;
            for (int k = 1; k < D; ++k)
                if (sides[k] > sides[longest]) longest = k;
            sides[longest] = -1;
            volume *= points_.lattice.h[j];
        }
        int axes = points_.lattice.count;
        for (int k = 0; k < D; ++k)
            if (sides[k] > 0) {
                volume *= sides[k];
                ++axes;
            }
        // The root, by halves: nothing depends on its last digits but work.
        double low = 0, high = 1;
        for (int k = 0; k < points_.lattice.count; ++k) high += points_.lattice.h[k];
        for (int k = 0; k < D; ++k) high += sides[k] > 0 ? sides[k] : 0;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            double cubes = static_cast<double>(points_.count);
            for (int k = 0; k < axes; ++k) cubes *= middle;
            (cubes < volume ? low : high) = middle;
        }
        return high;
    }
    double copies_in_all() const {
        double times = static_cast<double>(points_.count);
        for (int j = 0; j < points_.lattice.count; ++j)
            times *= 1 + (points_.high[j] - points_.low[j] + 2 * points_.far[j]) / points_.lattice.h[j];
        return times;
    }

    Status triangulate_copies() {
        const std::size_t low = arena_.low_mark(), high = arena_.high_mark();
        const int count = points_.lattice.count;
        const double apart = spacing();
        const bool are_few = copies_in_all() <= copies_at_once;
        double wanted = are_few ? infinity : first_margin<D> * apart;
        bool asks = !are_few && D > 2 && count == D;
        for (;;) {
            double margin[Lattice::most];
            bool are_all = true;
            for (int j = 0; j < count; ++j) {
                margin[j] = wanted < points_.far[j] ? wanted : points_.far[j];
                are_all &= margin[j] == points_.far[j];
            }
            StarReach reach = {true, 0};
            const Status status = triangulate_within(margin, asks ? apart : 0, are_all && !asks ? nullptr : &reach);
            const bool is_cut_off = status == Status::flat && (asks || !are_all);
            if (status != Status::ok && !is_cut_off) return status;
            if (status == Status::ok && reach.are_final) return Status::ok;
            arena_.release_low(low);
            arena_.release_high(high);
            const bool is_known = status == Status::ok && reach.wanted < infinity;
            // Where all copies that matter have been asked for, all of them are inserted.
            if (are_all) asks = false;
            wanted = is_known && reach.wanted > 1.05 * wanted ? reach.wanted * (1 + 0x1p-10) : 2 * wanted;
        }
    }
    // apart: how far points are apart, where copies are inserted as they are asked for; 0: all are inserted. reach:
    // what the stars of the points say; null: nothing is asked.
    Status triangulate_within(const double* margin, double apart, StarReach* reach) {
        Status status = make_copies<D>(points_, margin, work_, &copies_);
        if (status != Status::ok) return status;
        StoreState state = {};
        Store<D> store(arena_, state);
        Weights weights;
        weights.are_radii = are_radii();
        weights.index = copies_.index;
        weights.top = -infinity;
        arena_.each(points_.count, 2, [&](std::uint64_t i) {
            const double number = points_.x[i * numbers + D];
            weights.top = number > weights.top ? number : weights.top;
        });
        status = apart > 0 ? triangulate_wanted<D>(store, points_, copies_, near_margin<D> * apart, apart, weights,
                                                   has_weights(), request_.seed, work_)
                           : triangulate_all(store);
        if (status != Status::ok) return status;
        out_.report.copies = state.vertex_count - points_.count;
        return keep_cells(store, margin, weights, reach);
    }
    Status triangulate_all(Store<D>& store) {
        InputReport input;
        HiddenPoints hidden;
        const WeightRows rows = {{copies_.x + D, sizeof(double) * numbers, false}, are_radii(), copies_.index};
        const Status status =
            triangulate_weighted<D>(store, {copies_.x, sizeof(double) * numbers, false}, copies_.count, rows,
                                    request_.seed, work_.monitor, &input, &hidden);
        return status == Status::ok && input.duplicates != 0 ? Status::internal : status;
    }
    // Of the triangulation nothing stays but the cells at points, by rows of the copies: where reach, if any, says that
    // they are final.
    Status keep_cells(Store<D>& store, const double* margin, const Weights& weights, StarReach* reach) {
        constexpr std::size_t row_bytes = sizeof(VertexId) * (D + 1);
        const std::size_t begin = static_cast<std::size_t>(store.state.cells_offset);
        unsigned char* const rows = arena_.at(begin);
        std::uint32_t kept = 0, seen = 0;
        {
            // By an array of the copies, which is nearer than vertices are.
            const HighScope scope(arena_);
            std::uint32_t* const copy_of = arena_.template take_high<std::uint32_t>(store.state.vertex_count);
            std::uint8_t* const at_points = arena_.template take_high<std::uint8_t>(store.state.cell_slots);
            if (copy_of == nullptr || at_points == nullptr) return Status::out_of_memory;
            arena_.each(store.state.vertex_count, 2, [&](std::uint64_t v) {
                const Vertex<D>& vertex = store.vertex(static_cast<std::uint32_t>(v));
                copy_of[v] = vertex.origin;
                seen += vertex.origin < points_.count && vertex.cell != none;
            });
            if (reach != nullptr) {
                *reach =
                    reach_of_stars<D>(store, points_, margin, has_weights() ? &weights : nullptr, copy_of, at_points);
                // Beyond all copies that matter balls may reach.
                bool are_all = reach->wanted < infinity;
                for (int j = 0; j < points_.lattice.count; ++j) are_all &= margin[j] == points_.far[j];
                reach->are_final |= are_all;
                if (!reach->are_final) return Status::ok;
            } else {
                mark_cells(store, copy_of, at_points);
            }
            kept = move_together(store, copy_of, at_points, rows);
        }
        out_.distinct = seen;
        store.truncate_vertices(0);
        arena_.release_low(begin);
        unsigned char* const moved = arena_.template take_low<unsigned char>(std::size_t{kept} * row_bytes);
        if (moved == nullptr) return Status::out_of_memory;
        move_bytes(moved, rows, std::size_t{kept} * row_bytes, arena_);
        cells_ = {moved, row_bytes, kept, copies_.count};
        return list_hidden(points_.count - seen) ? Status::ok : Status::out_of_memory;
    }
    void mark_cells(Store<D>& store, const std::uint32_t* copy_of, std::uint8_t* at_points) {
        arena_.each(store.state.cell_slots, 3 * D, [&](std::uint64_t c) {
            at_points[c] = 0;
            for (const VertexId v : store.cell(static_cast<std::uint32_t>(c)).vertex)
                at_points[c] |= copy_of[v] < points_.count;
        });
    }
    // The copies of cells at points, one cell after the other to `rows`, where cells begin. Returns how many, and
    // counts their outer facets.
    std::uint32_t move_together(Store<D>& store, const std::uint32_t* copy_of, const std::uint8_t* at_points,
                                unsigned char* rows) {
        std::uint32_t kept = 0;
        outer_facets_ = 0;
        arena_.each(store.state.cell_slots, 20, [&](std::uint64_t c) {
            const Cell<D>& cell = store.cell(static_cast<std::uint32_t>(c));
            if (at_points[c] == 0) return;
            for (const FacetId facet : cell.neighbour) outer_facets_ += facet == none || at_points[facet.cell()] == 0;
            std::uint32_t row[D + 1];
            for (int i = 0; i <= D; ++i) row[i] = copy_of[cell.vertex[i]];
            __builtin_memcpy(rows + std::size_t{kept++} * sizeof row, row, sizeof row);
        });
        return kept;
    }
    // Points in no cell, by rows, ascending: at the high end, where nothing else is.
    bool list_hidden(std::uint32_t count) {
        HiddenPoints& hidden = out_.hidden;
        hidden.count = count;
        if (count == 0) return true;
        hidden.rows = arena_.template take_high<std::uint32_t>(count);
        const std::size_t low = arena_.low_mark();
        std::uint8_t* const seen = arena_.template take_low<std::uint8_t>(points_.count);
        if (hidden.rows == nullptr || seen == nullptr) return false;
        arena_.each(points_.count, 1, [seen](std::uint64_t i) { seen[i] = 0; });
        arena_.each(cells_.cell_count, 3 * D, [&](std::uint64_t c) {
            const VertexId* const vertex = cells_.vertices(CellId(static_cast<std::uint32_t>(c)));
            for (int i = 0; i <= D; ++i)
                if (vertex[i] < points_.count) seen[vertex[i]] = 1;
        });
        std::uint32_t listed = 0;
        arena_.each(points_.count, 3, [&](std::uint64_t i) {
            if (seen[i] == 0) hidden.rows[listed++] = points_.row[i];
        });
        arena_.release_low(low);
        sort(hidden.rows, count, Ascending{}, arena_);
        return true;
    }

    // Along the curve of the points and that of each of their translates, where faces of some cells are counted by
    // these.
    Status list_faces(Faces<D>* faces, PointRecords* points) {
        if constexpr (lists_follow_order<D> && D < 4) {
            std::uint32_t* const order = arena_.template take_high<std::uint32_t>(copies_.count);
            if (order == nullptr) return Status::out_of_memory;
            arena_.each(copies_.count, 1, [order](std::uint64_t v) { order[v] = static_cast<std::uint32_t>(v); });
            const FaceCounting counting(outer_facets_, false, points_.lattice.count == D ? points_.count : 0);
            const Status status = enumerate_faces_along<D>(cells_, counting, order, true, work_, faces);
            if (status != Status::ok) return status;
            return points->template put_in_order<numbers>(order, faces->count[0], arena_) ? Status::ok
                                                                                          : Status::out_of_memory;
        } else {
            static_cast<void>(points);
            return enumerate_faces(cells_, D, work_, faces);
        }
    }
    Status find_values() {
        work_.monitor.begin(NETMESH_STAGE_FILTER, 0);
        Faces<D> faces;
        PointRecords points = {copies_.x, sizeof(double) * numbers};
        Status status = list_faces(&faces, &points);
        if (status != Status::ok) return status;
        for (int k = 0; k <= D; ++k) {
            value_[k] = arena_.template take_low<double>(faces.count[k]);
            if (value_[k] == nullptr || faces.count[k] > 0x7FFFFFFFu) return Status::out_of_memory;
        }
        const double* const x = points.coordinates;
        const std::ptrdiff_t stride = points.stride_bytes;
        PowerValues powers = {};
        powers.are_radii = are_radii();
        powers.squares = request_.squares;
        status = has_weights() ? alpha_values_weighted(faces, x, stride, powers, work_, value_)
                               : alpha_values(faces, x, stride, work_, value_);
        faces_ = faces.template of_dimension<any_dimension>();
        return status;
    }
    Status reduce() {
        FilteredBall quotient = {D, static_cast<std::uint32_t>(dimension()), false, {}, repeats_};
        out_.found.simplices = 0;
        for (int k = 0; k <= dimension(); ++k) {
            quotient.of[k] = {faces_.count[k], faces_.facets[k], value_[k]};
            out_.found.simplices += faces_.count[k];
        }
        return persist_quotient(quotient, request_.diagram, work_, &out_.found.pairs);
    }

    // Everything that cycles name goes up; then nothing but that and pairs is there. low: of the arena, before all.
    Status reduce_with_cycles(std::size_t low, std::uint32_t* const* vertices) {
        ListedComplex& complex = cycles_->complex;
        complex.dimension = static_cast<std::uint32_t>(dimension());
        Status status = label_copies();
        for (std::uint32_t k = 0; k <= complex.dimension && status == Status::ok; ++k) {
            const std::uint32_t count = complex.count[k] = faces_.count[k];
            const std::size_t words = std::size_t{count} * (k + 1);
            complex.rows[k] = arena_.template take_high<std::uint32_t>(words);
            complex.value[k] = arena_.template take_high<double>(count);
            std::uint32_t* const own = cycles_->vertices[k] = arena_.template take_high<std::uint32_t>(words);
            if (complex.rows[k] == nullptr || complex.value[k] == nullptr || own == nullptr)
                return Status::out_of_memory;
            const std::size_t bytes = sizeof(std::uint32_t) * words;
            move_bytes(complex.rows[k], k == 0 ? vertices[0] : faces_.facets[k], bytes, arena_);
            move_bytes(complex.value[k], value_[k], sizeof(double) * count, arena_);
            move_bytes(own, vertices[k], bytes, arena_);
            status = order_beside(value_[k], count, own, k + 1, arena_);
            out_.found.simplices += count;
        }
        if (status == Status::ok) status = order_by_value(complex, arena_);
        if (status != Status::ok) return status;
        arena_.release_low(low);
        Representatives made = {};
        status = persist_quotient_with_cycles(complex.filtered(), request_.diagram, work_, &made);
        out_.found.pairs = made.pairs;
        cycles_->store = made.store;
        return status;
    }
    Status label_copies() {
        const std::uint32_t axes = cycles_->axes = static_cast<std::uint32_t>(points_.lattice.count);
        const std::size_t width = std::size_t{axes} + 1;
        cycles_->copies = arena_.template take_high<std::int32_t>(copies_.count * width);
        if (cycles_->copies == nullptr) return Status::out_of_memory;
        GivenTranslations given;
        find_given(request_.input, D, &given);
        bool are_near = true;
        arena_.each(copies_.count, 60 * D, [&](std::uint64_t at) {
            const auto v = static_cast<std::uint32_t>(at);
            const std::uint32_t i = copies_.point_of(v, points_.count);
            std::int32_t* const label = cycles_->copies + at * width;
            label[0] = static_cast<std::int32_t>(points_.row[i]);
            if (!are_near) return;
            are_near =
                translations_of<D>(request_.input, given, points_, i, copies_.shift_of(v, points_.count), label + 1);
            out_.report.input.row_a = points_.row[i];
        });
        out_.is_far = !are_near;
        return are_near ? Status::ok : Status::out_of_range;
    }

    const AlphaOfPeriodicPoints& request_;
    const Work& work_;
    Arena& arena_;
    PeriodicAlphaDiagram& out_;
    QuotientCycles* const cycles_;
    bool repeats_ = false;
    PeriodicPoints points_;
    Copies copies_;
    TriangulationView<D> cells_;
    std::uint64_t outer_facets_ = 0;  // of cells at points
    AnyFaces faces_;
    double* value_[D + 1];
};

}  // namespace

template <int D>
Status alpha_of_periodic_points(const AlphaOfPeriodicPoints& request, const Work& work, PeriodicAlphaDiagram* out,
                                QuotientCycles* cycles) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *out = PeriodicAlphaDiagram{};
    const Status status = PeriodicAlpha<D>(request, work, out, cycles).run();
    if (status == Status::ok && cycles != nullptr) return status;
    work.arena.release_low(low);
    const bool keeps = status == Status::ok && out->hidden.count > 0;
    work.arena.release_high(keeps ? work.arena.offset_of(out->hidden.rows) : high);
    return status == Status::ok ? move_pairs_down(low, work.arena, &out->found.pairs) : status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_of_periodic_points<D>(const AlphaOfPeriodicPoints&, const Work&, PeriodicAlphaDiagram*,      \
                                                QuotientCycles*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
