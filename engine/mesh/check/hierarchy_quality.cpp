#include "mesh/check/hierarchy_quality.hpp"

#include "delaunay/sphere.hpp"
#include "mesh/cages/any_cage.hpp"
#include "mesh/cages/cage_corner.hpp"
#include "mesh/check/hierarchy_measurement.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {
namespace {

bool solve_corner(int dim, const double* const* p, KnownCorner* found) {
    return with_dimension(static_cast<std::uint32_t>(dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Cell<D> scratch;
        solve_sphere<D>(p, corner_error_max, scratch);
        copy<D>(scratch.centre, found->x);
        found->radius2 = scratch.radius2;
        const double error = static_cast<double>(scratch.error);
        found->blur = scratch.error > blurred_error ? error * square_root(scratch.radius2) : 0;
        return scratch.radius2 < infinity;
    });
}

}  // namespace

[[gnu::cold]] Status HierarchyMeasurement::open() {
    [[maybe_unused]] const std::size_t low = arena_.low_mark();
    const std::uint32_t vertices = store_.state.vertex_count, cells = store_.state.cell_slots;
    order_ = arena_.take_low<std::uint32_t>(count_);
    cage_out2_ = arena_.take_low<double>(count_);
    cage_leaves_ball_ = arena_.take_low<bool>(count_);
    domain_ = arena_.take_low<std::uint32_t>(vertices);
    nearest2_ = arena_.take_low<double>(vertices);
    out2_ = arena_.take_low<double>(vertices);
    leaves_ball_ = arena_.take_low<bool>(vertices);
    list_ = arena_.take_low<CellId>(cells);
    mark_ = arena_.take_low<std::uint32_t>(cells);
    if (order_ == nullptr || cage_out2_ == nullptr || cage_leaves_ball_ == nullptr || domain_ == nullptr ||
        nearest2_ == nullptr || out2_ == nullptr || leaves_ball_ == nullptr || list_ == nullptr || mark_ == nullptr)
        return Status::out_of_memory;
    NETMESH_ASSERT(arena_.low_mark() - low <= HierarchyScratch::cage_bytes * count_ +
                                                  HierarchyScratch::vertex_bytes * vertices +
                                                  HierarchyScratch::cell_bytes * cells + 9 * Arena::alignment);
    for (std::uint32_t c = 0; c < cells;)
        for (const std::uint64_t piece = arena_.piece(c, cells, 6); c < piece; ++c) {
            mark_[c] = 0;
        }
    return Status::ok;
}

// The corner of cell c; false when the cell is too flat for doubles to know it.
[[gnu::noinline]] bool HierarchyMeasurement::corner(std::uint32_t c, KnownCorner* found) const {
    const double* p[dimension_max + 1];
    for (int i = 0; i <= dim; ++i) p[i] = store_.point(store_.cell(c).vertex[i]);
    return solve_corner(dim, p, found);
}

// The corner of cell c, when the ball contains it, or the crossings of its edges.
[[gnu::noinline]] void HierarchyMeasurement::clip(const AnyDomain& ball, std::uint32_t c, const double* here,
                                                  Clipped* points) const {
    points->count = 0;
    if (ball.contains(here)) return points->add(dim, here, -1);
    for (int i = 0; i <= dim; ++i) {
        const std::uint32_t n = neighbour(c, i);
        KnownCorner there;
        if (n == none || !corner(n, &there)) continue;
        double z[2][dimension_max];
        const int crossings = sphere_crossings(ball, here, there.x, z);
        for (int j = 0; j < crossings; ++j) points->add(dim, z[j], i);
    }
}

void HierarchyMeasurement::raise_vertices(std::uint32_t c, const KnownCorner& here) {
    const AnyCell cell = store_.cell(c);
    unsigned left = (2u << dim) - 1;
    for (int first = 0; first <= dim; ++first) {
        if ((left >> first & 1u) == 0) continue;
        const std::uint32_t d = domain_[cell.vertex[first]];
        unsigned equal = 0;
        for (int i = first; i <= dim; ++i)
            if (domain_[cell.vertex[i]] == d) equal |= 1u << i;
        left &= ~equal;
        Clipped points;
        const AnyDomain ball = ball_of(d);
        for (int i = first; i <= dim && !ball.contains(here.x); ++i)
            if (equal >> i & 1u) leaves_ball_[cell.vertex[i]] = true;
        clip(ball, c, here.x, &points);
        for (int k = 0; k < points.count; ++k)
            for (int i = 0; i <= dim; ++i) {
                if (i == points.facet[k] || (equal >> i & 1u) == 0) continue;
                const bool is_blurred = points.facet[k] < 0 && here.blur > 0;
                const double d2 = is_blurred ? here.radius2 : distance2(dim, points.x[k], store_.point(cell.vertex[i]));
                if (d2 > out2_[cell.vertex[i]]) out2_[cell.vertex[i]] = d2;
            }
    }
}

// The corner belongs to each cage that has some of the cell's vertices but not all.
[[gnu::cold]] void HierarchyMeasurement::raise_cages(std::uint32_t c, const KnownCorner& here) {
    const AnyCell cell = store_.cell(c);
    for (int i = 0; i <= dim; ++i)
        for (std::uint32_t d = domain_[cell.vertex[i]]; d != none && is_on_boundary(store_, cages_[d], c);
             d = cages_[d].parent) {
            const double* const centre = store_.point(cages_[d].centre);
            for (const std::uint32_t v : cell.vertex)
                if (!is_inside(store_, cages_[d], store_.point(v))) {
                    const double d2 = distance2(dim, store_.point(v), centre);
                    if (d2 < cages_[d].nearest2) cages_[d].nearest2 = d2;
                }
            Clipped points;
            const AnyDomain ball = ball_of(cages_[d].parent);
            if (!ball.contains(here.x)) cage_leaves_ball_[d] = true;
            clip(ball, c, here.x, &points);
            for (int k = 0; k < points.count; ++k) {
                const int facet = points.facet[k];
                if (facet >= 0 && !is_mixed(store_, cages_[d], c, facet)) continue;
                double d2 = distance2(dim, points.x[k], centre);
                if (is_thesis() && here.blur > 0) {
                    const double most = square_root(d2) + here.blur;
                    d2 = most * most;
                }
                if (d2 > cage_out2_[d]) cage_out2_[d] = d2;
            }
        }
}

void HierarchyMeasurement::measure_cells() {
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 10); v < piece; ++v) {
            nearest2_[v] = infinity;
            out2_[v] = 0;
            leaves_ball_[v] = false;
        }
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            cages_[d].nearest2 = infinity;
            cage_out2_[d] = 0;
            cage_leaves_ball_[d] = false;
        }
    for (std::uint32_t c = 0; c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 200 * dim * dim); c < piece;
             ++c) {
            if (!is_finite(c)) continue;
            const AnyCell cell = store_.cell(c);
            bool equal = true;
            for (int i = 0; i <= dim; ++i) {
                equal &= domain_[cell.vertex[i]] == domain_[cell.vertex[0]];
                for (int j = 0; j < i; ++j) {
                    const double d2 = distance2(dim, store_.point(cell.vertex[i]), store_.point(cell.vertex[j]));
                    if (d2 < nearest2_[cell.vertex[i]]) nearest2_[cell.vertex[i]] = d2;
                    if (d2 < nearest2_[cell.vertex[j]]) nearest2_[cell.vertex[j]] = d2;
                }
            }
            for (int i = 0; i <= dim; ++i)
                for (int k = 0; k <= dim && cell.neighbour[i] == none; ++k)
                    if (k != i) out2_[cell.vertex[k]] = infinity;
            KnownCorner here;
            if (!corner(c, &here)) {
                for (const VertexId v : cell.vertex) {
                    leaves_ball_[v] = true;
                    for (std::uint32_t d = domain_[v]; d != none; d = cages_[d].parent) cage_leaves_ball_[d] = true;
                }
                continue;
            }
            raise_vertices(c, here);
            if (!equal) raise_cages(c, here);
        }
}

// Stands in list_ until the next walk.
CageBoundary HierarchyMeasurement::list_boundary(const Cage& cage) {
    const std::uint32_t cells = visit_ball(cage.centre, cage.radius, [](std::uint32_t, double) {});
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k < cells;)
        for (const std::uint64_t piece = store_.arena.piece(k, cells, 10 * dim); k < piece; ++k)
            if (is_on_boundary(store_, cage, list_[k])) list_[count++] = list_[k];
    return {list_ + count, count};
}

// What lies on a sphere, but on no edge. The lists of the search for domains are not needed any more.
[[gnu::cold]] Status HierarchyMeasurement::measure_poles() {
    if (is_thesis()) return Status::ok;
    for (VertexId v(0); v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 20); v < piece; ++v) {
            if (!leaves_ball_[v] || !(out2_[v] < infinity) || !counts(v)) continue;
            const AnyDomain ball = domain_ball(store_, cages_, domain_[v], outermost_);
            if (!raise_to_poles(store_, ball, v, &out2_[v])) return Status::out_of_memory;
        }
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            const AnyDomain ball = domain_ball(store_, cages_, cages_[d].parent, outermost_);
            if (!cage_leaves_ball_[d]) continue;
            const double pole2 = distance2_of_cage_pole(store_, cages_[d], ball, list_boundary(cages_[d]),
                                                        cage_out2_[d] * (1 + 0x1p-40));
            if (pole2 > cage_out2_[d]) cage_out2_[d] = pole2;
        }
    return Status::ok;
}

[[gnu::cold]] void HierarchyMeasurement::worst(HierarchyQuality* quality) const {
    quality->worst = 0;
    quality->vertex = none;
    const auto offer = [&](double ratio, std::uint32_t v) {
        if (!(ratio > quality->worst)) return;
        quality->worst = ratio;
        quality->vertex = v;
    };
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 200); v < piece; ++v) {
            offer(ratio(v), v);
        }
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            if (!is_outermost(d)) offer(square_root(cage_out2_[d]) / in_radius_of(cages_[d]), cages_[d].centre);
        }
}

[[gnu::cold]] void HierarchyMeasurement::report(const HierarchyRequest& request) const {
    for (std::uint32_t v = 0; v < store_.state.vertex_count && request.ratios != nullptr; ++v) {
        store_.arena.step(v, 200);
        request.ratios[v] = ratio(v);
        request.domains[v] = domain_[v];
    }
    for (std::uint32_t d = 0; d < count_ && request.cage_radii != nullptr; ++d) {
        store_.arena.step(d, 40);
        request.cage_radii[2 * d] = in_radius_of(cages_[d]);
        request.cage_radii[2 * d + 1] = square_root(cage_out2_[d]);
    }
}

Status measure_hierarchy(const AnyStore& store, const HierarchyRequest& request, Arena& arena,
                         HierarchyQuality* quality) {
    ArenaScope scope(arena);
    *quality = {0, none, false, {nullptr, none}};
    HierarchyMeasurement measurement(store, request, arena);
    if (measurement.open() != Status::ok) return Status::out_of_memory;
    quality->encroached = measurement.find_domains();
    if (quality->encroached.violation != nullptr) return Status::ok;
    quality->is_hierarchy = true;
    quality->encroached = measurement.find_shells();
    if (quality->encroached.violation == nullptr) quality->encroached = measurement.find_encroached();
    measurement.measure_cells();
    if (measurement.measure_poles() != Status::ok) return Status::out_of_memory;
    measurement.worst(quality);
    measurement.report(request);
    return Status::ok;
}

}  // namespace netmesh
