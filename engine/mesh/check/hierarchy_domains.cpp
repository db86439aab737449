// Domains, shells and encroachment of a mesh with cages.
#include "mesh/check/hierarchy_measurement.hpp"
#include "numerics/sort.hpp"

namespace netmesh {
namespace {

struct LargerCage {
    const Cage* cages;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
        return cages[a].radius > cages[b].radius || (cages[a].radius == cages[b].radius && a < b);
    }
};

}  // namespace

// From the largest cage to the smallest: each takes its vertices from the one around it.
[[gnu::cold]] CheckResult HierarchyMeasurement::find_domains() {
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 10); v < piece; ++v) {
            domain_[v] = none;
            out2_[v] = 0;
            leaves_ball_[v] = false;
        }
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            order_[d] = d;
            const Cage& cage = cages_[d];
            if (cage.centre >= store_.state.vertex_count || store_.vertex(cage.centre).marker != Marker::input ||
                store_.vertex(cage.centre).cell == none || !(cage.radius > 0 && cage.radius < infinity))
                return {"a cage's centre is not an input, or its radius not positive", cage.centre};
        }
    sort_alike(order_, count_, LargerCage{cages_}, arena_);
    for (std::uint32_t k = 0; k < count_;)
        for (const std::uint64_t piece = store_.arena.piece(k, count_, 60); k < piece; ++k) {
            const std::uint32_t d = order_[k];
            Cage& cage = cages_[d];
            cage.parent = domain_[cage.centre];
            if (cage.parent != none) {
                const Cage& around = cages_[cage.parent];
                const double offset =
                    square_root(distance2(dim, store_.point(cage.centre), store_.point(around.centre)));
                if (!(offset + cage.radius <= around.radius))
                    return {"a cage sticks out of the one around it", cage.centre};
            }
            visit_ball(cage.centre, cage.radius, [&](std::uint32_t v, double) { domain_[v] = d; });
        }
    return {nullptr, none};
}

// Exempt vertices of a cage's domain are its shell: near its sphere, and as many as a cross-polytope has.
[[gnu::cold]] CheckResult HierarchyMeasurement::find_shells() {
    if (is_thesis()) return find_thesis_shells();
    CheckResult result = {nullptr, none};
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            cages_[d].next = 0;
        }
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 10); v < piece; ++v) {
            if (domain_[v] == none || store_.vertex(v).marker != Marker::exempt) continue;
            Cage& cage = cages_[domain_[v]];
            const double least = shell_least * cage.radius;
            if (distance2(dim, store_.point(v), store_.point(cage.centre)) >= least * least)
                ++cage.next;
            else
                result = {"an exempt vertex within a cage is not of its shell", v};
        }
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            if (cages_[d].next != 2 * static_cast<std::uint32_t>(dim))
                result = {"a cage lacks its shell", cages_[d].centre};
            cages_[d].next = none;
        }
    return result;
}

// Has each point of the template a vertex of the shell near it? Points of a template are farther apart than twice what
// a vertex may be off, so it has one and no other where there are as many as points.
[[gnu::cold]] bool HierarchyMeasurement::is_template_covered(std::uint32_t d) {
    const Cage& cage = cages_[d];
    const std::uint32_t size = template_size(dim, is_outermost(d));
    const double radius = ThesisCage::shell_factor * cage.radius;
    double off = ThesisCage::gamma * radius * (1 + 0x1p-30);
    // Places are a few roundings of the coordinates off.
    for (int i = 0; i < dim; ++i) off += 0x1p-51 * (absolute(store_.point(cage.centre)[i]) + cage.radius);
    std::uint64_t seen[(RootTemplate<4>::size + 63) / 64] = {};
    visit_ball(cage.centre, cage.radius, [&](std::uint32_t v, double d2) {
        // A vertex is visited in each of its cells. The marks have no other use before measuring, which clears them.
        bool& looked_at = leaves_ball_[v];
        if (looked_at || domain_[v] != d || !(d2 > 0.25 * radius * radius)) return;
        looked_at = true;
        if (store_.vertex(v).marker != Marker::exempt && !has_yielded(v)) return;
        store_.arena.pass(size / 4);
        for (std::uint32_t k = 0; k < size; ++k) {
            double place[dimension_max];
            template_point(dim, is_outermost(d), k, place);
            for (int i = 0; i < dim; ++i) place[i] = store_.point(cage.centre)[i] + radius * place[i];
            if (distance2(dim, place, store_.point(v)) <= off * off) seen[k / 64] |= std::uint64_t{1} << k % 64;
        }
    });
    std::uint32_t covered = 0;
    for (std::uint32_t k = 0; k < size; ++k) covered += seen[k / 64] >> k % 64 & 1u;
    return covered == size;
}

// As many vertices near the sphere as the template has points, of which inputs may be some, and one at each; the other
// exempt vertices are on the hull.
[[gnu::cold]] CheckResult HierarchyMeasurement::find_thesis_shells() {
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            cages_[d].next = 0;
        }
    const std::uint32_t cells = store_.state.cell_slots;
    for (std::uint32_t c = 0; c < cells;)
        for (const std::uint64_t piece = store_.arena.piece(c, cells, 300 * dim); c < piece; ++c) {
            for (int i = 0; i <= dim && is_finite(c); ++i)
                for (int k = 0; k <= dim && neighbour(c, i) == none; ++k)
                    if (k != i) out2_[store_.cell(c).vertex[k]] = infinity;
        }
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 200); v < piece; ++v) {
            if (store_.vertex(v).cell == none) continue;
            const bool exempt = store_.vertex(v).marker == Marker::exempt;
            if (domain_[v] == none) {
                if (!exempt) return {"a vertex is outside of the outermost cage", v};
                if (out2_[v] < infinity) return {"an exempt vertex is of no shell and not on the hull", v};
                continue;
            }
            Cage& cage = cages_[domain_[v]];
            if (exempt && !is_by_shell(store_, cage, v))
                return {"an exempt vertex within a cage is not of its shell", v};
            if (exempt || has_yielded(v)) ++cage.next;
        }
    CheckResult result = {nullptr, none};
    std::uint32_t outermost = 0;
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            if (is_outermost(d) && ++outermost > 1) return {"there are two outermost cages", cages_[d].centre};
            const std::uint32_t size = template_size(dim, is_outermost(d));
            if (cages_[d].next != size)
                result = {"a cage lacks its shell", cages_[d].centre};
            else if (!is_template_covered(d))
                result = {"a shell has a hole", cages_[d].centre};
            cages_[d].next = none;
        }
    return result;
}

[[gnu::cold]] CheckResult HierarchyMeasurement::find_encroached() {
    for (std::uint32_t d = 0; d < count_;)
        for (const std::uint64_t piece = store_.arena.piece(d, count_, 40); d < piece; ++d) {
            Cage& cage = cages_[d];
            const double inside = is_thesis() ? ThesisCage::epsilon : cage_epsilon;
            const double r2 = cage.radius * cage.radius, e2 = inside * inside * r2;
            bool inner = false, outer = false;
            visit_ball(cage.centre, (is_thesis() ? ThesisCage::clearance : cage_clearance) * cage.radius,
                       [&](std::uint32_t v, double d2) {
                           const Marker marker = store_.vertex(v).marker;
                           if (d2 < r2)
                               inner |= marker == Marker::input && d2 > e2 && !(domain_[v] == d && has_yielded(v));
                           else if (d2 > r2)
                               outer |= is_thesis() || marker == Marker::input || domain_[v] == none ||
                                        (marker == Marker::steiner &&
                                         is_inside(store_, cages_[domain_[v]], store_.point(cage.centre)));
                       });
            if (inner) return {"an input encroaches on a cage from inside", cage.centre};
            if (outer) return {"a vertex encroaches on a cage from outside", cage.centre};
        }
    return {nullptr, none};
}

}  // namespace netmesh
