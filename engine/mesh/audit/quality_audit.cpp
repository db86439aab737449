#include "mesh/audit/quality_audit.hpp"

#include "mesh/audit/step_audit.hpp"
#include "mesh/cages/any_cage.hpp"
#include "mesh/cages/cage_corner.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Marks in Vertex::queued, beside that of the bucket queue, taken back before a step's audit ends.
constexpr std::uint8_t in_list = 2, seen = 4;

void raise(double value, double* most) {
    if (value > *most) *most = value;
}

// Takes the mark off a vertex. False when it had none.
bool take_mark(const AnyVertex& vertex, std::uint8_t mark) {
    const bool had = (vertex.queued & mark) != 0;
    vertex.queued = static_cast<std::uint8_t>(vertex.queued & ~mark);
    return had;
}
// False when it has had one.
bool put_mark(const AnyVertex& vertex, std::uint8_t mark) {
    const bool had = (vertex.queued & mark) != 0;
    vertex.queued = static_cast<std::uint8_t>(vertex.queued | mark);
    return !had;
}

}  // namespace

// Calls visit(cell), perhaps several times, for each cell at a vertex that the step has inserted, or that is in a cage
// which it has made grow or has released. False when the gap is too small for the search.
template <class Visit> [[gnu::cold]] bool StepAudit::visit_changed(Visit&& visit) {
    for (VertexId v(all_features_rise_ ? frame_ + 2 * static_cast<std::uint32_t>(dim) : step_.first_made);
         v < store_.state.vertex_count; ++v)
        if (!visit_any_star(store_, v, visit)) return false;
    if (step_.vertex < step_.first_made && !visit_any_star(store_, VertexId(step_.vertex), visit)) return false;
    for (std::uint32_t k = 0; k < step_.note_count; ++k) {
        const AuditNote& note = step_.notes[k];
        if (note.cage == none) {
            if (!visit_any_star(store_, VertexId(note.vertex), visit)) return false;
            continue;
        }
        std::uint32_t cells;
        if (!list_cage_cells(store_, made_->cage(note.cage), &cells)) return false;
        const CellId* const list = store_.list_top();
        for (std::uint32_t i = 0; i < cells; ++i) visit(list[-1 - static_cast<std::ptrdiff_t>(i)]);
    }
    return true;
}

// Are there two inputs in the outermost domain? Before, f_P is infinite there, and there may be vertices: a cage that
// holds all inputs counts as one.
[[gnu::cold]] bool StepAudit::has_outermost_features() {
    TwoNearest inputs(none);
    find_second(outermost_.centre, is_thesis() ? 0 : none, 0x1p1000, &inputs);
    return inputs.second2 < infinity;
}

// Counts, then lists the vertices of these cells.
[[gnu::cold]] bool StepAudit::list_changed() {
    const bool counted = visit_changed([&](CellId c) {
        for (const VertexId v : store_.cell(c).vertex)
            if (v != none) count_ += put_mark(store_.vertex(v), in_list);
    });
    list_ = counted ? store_.arena.take_low<std::uint32_t>(count_) : nullptr;
    std::uint32_t listed = 0;
    const bool fits = list_ != nullptr && visit_changed([&](CellId c) {
                          for (const VertexId v : store_.cell(c).vertex)
                              if (v != none && take_mark(store_.vertex(v), in_list)) list_[listed++] = v;
                          list_cages(c);
                      });
    if (fits) return true;
    for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) take_mark(store_.vertex(v), in_list);
    return false;
}

// The cell belongs to the boundary of each cage that has some of its vertices but not all.
[[gnu::cold]] void StepAudit::list_cages(CellId c) {
    if (hierarchy_ == nullptr || store_.is_ghost(c)) return;
    std::uint32_t domains[dimension_max + 1];
    bool equal = true;
    for (int i = 0; i <= dim; ++i) {
        domains[i] = domain_in_hierarchy(store_.cell(c).vertex[i]);
        equal &= domains[i] == domains[0];
    }
    for (int i = 0; i <= dim && !equal; ++i)
        for (std::uint32_t d = domains[i]; d != none && is_on_boundary(store_, hierarchy_->cage(d), c);
             d = hierarchy_->parent(d)) {
            Cage& cage = hierarchy_->cage(d);
            if (cage.next != none || (is_thesis() && cage.parent == none)) continue;
            cage.next = cages_ == none ? d : cages_;
            cages_ = d;
        }
}

// The vertex of M_Omega, Omega a domain, that stands for v: itself, or the centre of the cage *within directly inside
// of Omega; none when v is outside of Omega's ball.
[[gnu::cold]] std::uint32_t StepAudit::member(std::uint32_t v, std::uint32_t domain, std::uint32_t* within) const {
    *within = none;
    if (is_frame(v)) return none;
    if (hierarchy_ == nullptr) return v;
    std::uint32_t d = domain_in_hierarchy(v);
    for (; d != domain && d != none; d = hierarchy_->parent(d)) *within = d;
    if (d != domain) return none;
    return *within == none ? v : hierarchy_->cage(*within).centre;
}

// Offers what stands for an input in M_Omega. True when all within `reach` of the input is within the same cage.
[[gnu::cold]] bool StepAudit::offer_member(const double* x, std::uint32_t domain, std::uint32_t input, double reach,
                                           TwoNearest* inputs) {
    if (terms_.inserted_inputs && store_.vertex(input).cell == none) return false;
    if (hierarchy_ == nullptr) {
        inputs->offer(input, distance2(dim, x, store_.point(input)));
        return false;
    }
    std::uint32_t within;
    const std::uint32_t m = member(input, domain, &within);
    if (m == none) return false;
    inputs->offer(m, distance2(dim, x, store_.point(m)));
    if (within == none) return false;
    const double offset = distance(dim, store_.point(input), store_.point(m));
    return (offset + reach) * (1 + 8 * unit_roundoff) < hierarchy_->cage(within).radius;
}

// Finds the second nearest input of M_Omega, or any two inputs that are near enough.
[[gnu::cold]] void StepAudit::find_second(const double* x, std::uint32_t domain, double enough2, TwoNearest* inputs) {
    AnyTreePart stack[40];
    int depth = 0;
    stack[depth++] = {tree_.root(), 0, {}};
    while (depth > 0 && inputs->second2 > enough2) {
        const AnyTreePart part = stack[--depth];
        if (!(part.least2 < inputs->second2)) continue;
        TreeRange range = part.range;
        bool passed = false;
        while (!range.is_leaf() && !passed) {
            const std::uint32_t middle = range.middle(), item = tree_.item(middle);
            passed = offer_member(x, domain, item, tree_.reach(middle), inputs);
            const int axis = tree_.axis(middle);
            const double offset = x[axis] - store_.point(item)[axis];
            stack[depth] = part.beyond(dim, axis, offset, offset < 0 ? range.above() : range.below());
            if (!passed && stack[depth].least2 < inputs->second2) ++depth;
            range = offset < 0 ? range.below() : range.above();
        }
        for (std::uint32_t i = range.begin; i < range.end && !passed; ++i)
            offer_member(x, domain, tree_.item(i), infinity, inputs);
    }
}

// `inputs` holds what is known. A feature size that does not make K or K' larger need not be known any better.
[[gnu::cold]] void StepAudit::raise_feature(const double* x, std::uint32_t domain, double mesh2, TwoNearest* inputs,
                                            double* kind) {
    const double least = kind != nullptr && *kind < audit_.feature ? *kind : audit_.feature;
    find_second(x, domain, least * least * mesh2, inputs);
    if (!(inputs->second2 < infinity)) return;
    const double ratio = square_root(inputs->second2 / mesh2);
    raise(ratio, &audit_.feature);
    if (kind != nullptr) raise(ratio, kind);
}

// False when the gap is too small.
[[gnu::cold]] bool StepAudit::measure_vertex(VertexId v) {
    if (is_frame(v)) return true;
    const AnyVertex vertex = store_.vertex(v);
    const std::uint32_t domain = domain_of(v);
    TwoNearest inputs(vertex.marker == Marker::input ? v : none);
    double nearest2 = infinity, mesh2 = infinity;
    const bool may_all_rise = is_new(v) || step_.note_count > 0 || all_features_rise_;
    bool ratio_may_rise = may_all_rise, feature_may_rise = may_all_rise;
    std::uint32_t cells = 0, degree = 0;
    const bool fits = visit_any_star(store_, v, [&](CellId c) {
        ++cells;
        for (const VertexId w : store_.cell(c).vertex) {
            if (w == v || w == none || !put_mark(store_.vertex(w), seen)) continue;
            ++degree;
            const double d2 = distance2(dim, vertex.x, store_.point(w));
            if (d2 < nearest2) {
                nearest2 = d2;
                ratio_may_rise = may_all_rise || is_new(w);
            }
            std::uint32_t within;
            const std::uint32_t m = terms_.features ? member(w, domain, &within) : none;
            if (m == none) continue;
            const double member2 = m == w ? d2 : distance2(dim, vertex.x, store_.point(m));
            if (member2 < mesh2) {
                mesh2 = member2;
                feature_may_rise = may_all_rise || is_new(w);
            }
            if (store_.vertex(m).marker == Marker::input) inputs.offer(m, member2);
        }
    });
    const CellId* const star = store_.list_top();
    for (std::uint32_t k = 0; k < cells; ++k)
        for (const VertexId w : store_.cell(star[-1 - static_cast<std::ptrdiff_t>(k)]).vertex)
            if (w != none) take_mark(store_.vertex(w), seen);
    if (!fits) return false;
    if (degree > audit_.degree_max) audit_.degree_max = degree;
    if (mesh2 < infinity && feature_may_rise) {
        if (vertex.marker != Marker::input) offer_member(vertex.x, domain, vertex.origin, infinity, &inputs);
        raise_feature(vertex.x, domain, mesh2, &inputs, kind_of(v));
    }
    const bool has_ratio =
        vertex.marker == Marker::input || (vertex.marker == Marker::steiner && terms_.steiner_ratios);
    if (!has_ratio || !ratio_may_rise || has_yielded(v)) return true;
    if (hierarchy_ == nullptr) return measure_ratio(v, cells, nearest2, outermost_);
    AnyDomain ball = domain_ball(store_, hierarchy_->cages(), domain, outermost_);
    if (is_thesis()) ball.radius = infinity;
    return measure_ratio(v, cells, nearest2, ball);
}

// Just before, v's star of `cells` cells has been visited.
[[gnu::cold]] bool StepAudit::measure_ratio(VertexId v, std::uint32_t cells, double nearest2, const AnyDomain& ball) {
    const double* const p = store_.point(v);
    const double bound2 = 0.25 * audit_.worst * audit_.worst * nearest2;
    const CellId* const star = store_.list_top();
    double out2 = bound2;
    bool leaves_ball = false, bounded = true;
    for (std::uint32_t k = 0; k < cells; ++k) {
        const CellId c = star[-1 - static_cast<std::ptrdiff_t>(k)];
        const AnyCell cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) {
            leaves_ball = true;
            bounded &= !store_.is_ghost(c);
        } else if (ball.contains(cell.centre)) {
            if (cell.radius2 * (1 + 0x1p-20) > bound2) raise(distance2(dim, cell.centre, p), &out2);
        } else {
            leaves_ball |= cell.radius2 * (1 + 0x1p-20) > bound2;  // then crossings of edges are poles too
        }
    }
    if (!bounded) out2 = infinity;
    if (leaves_ball && bounded && !is_thesis() && !raise_to_poles(store_, ball, v, &out2)) return false;
    if (out2 > bound2) raise(2 * square_root(out2 / nearest2), &audit_.worst);
    return true;
}

// Does w, outside of the cage and near its boundary, encroach on it?
[[gnu::cold]] void StepAudit::look_from_outside(const Cage& cage, std::uint32_t w) {
    const double* const centre = store_.point(cage.centre);
    const double clear = (is_thesis() ? ThesisCage::clearance : cage_clearance) * cage.radius;
    if (!(distance2(dim, store_.point(w), centre) < clear * clear)) return;
    if (is_thesis()) encroached_ = true;
    const Marker marker = store_.vertex(w).marker;
    const std::uint32_t domain = domain_in_hierarchy(w);
    encroached_ |=
        marker == Marker::input ||
        (!is_growing(cage) &&
         (domain == none || (marker == Marker::steiner && is_inside(store_, hierarchy_->cage(domain), centre))));
}

[[gnu::cold]] bool StepAudit::measure_cage(std::uint32_t d) {
    Cage cage = hierarchy_->cage(d);
    const double* const centre = store_.point(cage.centre);
    const std::uint32_t around = hierarchy_->parent(d);
    const double epsilon = is_thesis() ? ThesisCage::epsilon : cage_epsilon;
    const double r2 = cage.radius * cage.radius, inner2 = epsilon * epsilon * r2;
    cage.nearest2 = infinity;
    double mesh2 = infinity;
    TwoNearest inputs(cage.centre);
    std::uint32_t cells;
    if (!list_cage_boundary(store_, cage, &cells)) return false;
    const CellId* const boundary = store_.list_top();
    for (std::uint32_t k = 0; k < cells; ++k)
        for (const VertexId w : store_.cell(boundary[-1 - static_cast<std::ptrdiff_t>(k)]).vertex) {
            if (w == none || !put_mark(store_.vertex(w), seen)) continue;
            const double d2 = distance2(dim, store_.point(w), centre);
            if (d2 < r2) {
                encroached_ |= store_.vertex(w).marker == Marker::input && d2 > inner2 &&
                               !(has_yielded(w) && domain_in_hierarchy(w) == d);
                continue;
            }
            if (d2 < cage.nearest2) cage.nearest2 = d2;
            look_from_outside(cage, w);
            std::uint32_t within;
            const std::uint32_t m = member(w, around, &within);
            if (m == none || m == cage.centre) continue;
            const double member2 = m == w ? d2 : distance2(dim, centre, store_.point(m));
            if (member2 < mesh2) mesh2 = member2;
            if (store_.vertex(m).marker == Marker::input) inputs.offer(m, member2);
        }
    for (std::uint32_t k = 0; k < cells; ++k)
        for (const VertexId w : store_.cell(boundary[-1 - static_cast<std::ptrdiff_t>(k)]).vertex)
            if (w != none) take_mark(store_.vertex(w), seen);
    const double inner = is_thesis() ? 0.5 * square_root(cage.nearest2) : in_radius(cage);
    const double bound2 = audit_.worst * audit_.worst * inner * inner;
    const double out2 = reach_of_cage(cage, boundary, cells, bound2);
    if (out2 > bound2) raise(square_root(out2) / inner, &audit_.worst);
    if (terms_.features && mesh2 < infinity) raise_feature(centre, around, mesh2, &inputs, nullptr);
    return true;
}

// Squared, or bound2 where that is more. boundary as in raise_to_cage_cell.
[[gnu::cold]] double StepAudit::reach_of_cage(const Cage& cage, const CellId* boundary, std::uint32_t cells,
                                              double bound2) const {
    double out2 = bound2;
    if (!is_thesis()) {
        const AnyDomain ball = domain_ball(store_, hierarchy_->cages(), cage.parent, outermost_);
        raise_to_cage_cell(store_, cage, ball, {boundary, cells}, &out2);
        return out2;
    }
    for (std::uint32_t k = 0; k < cells; ++k) {
        const AnyCell cell = store_.cell(boundary[-1 - static_cast<std::ptrdiff_t>(k)]);
        if (cell.radius2 < infinity) raise(distance2(dim, cell.centre, store_.point(cage.centre)), &out2);
    }
    return out2;
}

// Inputs that the step has inserted, and the shells that it has made, of cages of the thesis.
[[gnu::cold]] void StepAudit::look_at_shells() {
    const auto look_at_input = [&](std::uint32_t v) {
        if (v >= frame_) return;
        const std::uint32_t own = has_yielded(v) ? domain_in_hierarchy(v) : none;
        for (std::uint32_t d = domain_in_hierarchy(v); d != none; d = hierarchy_->parent(d)) {
            const Cage& cage = hierarchy_->cage(d);
            const double inner = ThesisCage::epsilon * cage.radius;
            encroached_ |= d != own && distance2(dim, store_.point(v), store_.point(cage.centre)) > inner * inner;
        }
    };
    look_at_input(step_.vertex);
    for (std::uint32_t k = 0; k < step_.note_count; ++k) look_at_input(step_.notes[k].vertex);
    for (std::uint32_t v = step_.first_made; v < store_.state.vertex_count; ++v) {
        if (store_.vertex(v).marker != Marker::exempt) continue;
        const std::uint32_t d = domain_in_hierarchy(v), around = d == none ? none : hierarchy_->parent(d);
        encroached_ |= d == none || !is_by_shell(store_, hierarchy_->cage(d), v);
        if (around == none) continue;
        const Cage &cage = hierarchy_->cage(d), &outer = hierarchy_->cage(around);
        encroached_ |=
            !(distance(dim, store_.point(cage.centre), store_.point(outer.centre)) + cage.radius <= outer.radius);
    }
}

// Of the step's input, and the cage that was made for it.
[[gnu::cold]] void StepAudit::look_at_step() {
    if (hierarchy_ == nullptr) return;
    if (is_thesis()) return look_at_shells();
    if (step_.vertex != none && store_.vertex(step_.vertex).marker == Marker::input)
        for (std::uint32_t d = domain_in_hierarchy(step_.vertex); d != none; d = hierarchy_->parent(d)) {
            const Cage& cage = hierarchy_->cage(d);
            const double inner = cage_epsilon * cage.radius;
            encroached_ |= distance2(dim, store_.point(step_.vertex), store_.point(cage.centre)) > inner * inner;
        }
    const std::uint32_t last = hierarchy_->made() - 1;
    const Cage& cage = hierarchy_->cage(last);
    if (cage.shell != step_.first_made) return;
    const double* const centre = store_.point(cage.centre);
    const double least = shell_least * cage.radius;
    for (std::uint32_t v = cage.shell; v < cage.shell + 2 * static_cast<std::uint32_t>(dim); ++v)
        encroached_ |= store_.vertex(v).marker != Marker::exempt || !is_inside(store_, cage, store_.point(v)) ||
                       distance2(dim, store_.point(v), centre) < least * least;
    const std::uint32_t around = hierarchy_->parent(last);
    if (around == none) return;
    const Cage& outer = hierarchy_->cage(around);
    encroached_ |= !(distance(dim, centre, store_.point(outer.centre)) + cage.radius <= outer.radius);
}

[[gnu::cold]] bool StepAudit::measure_listed() {
    for (std::uint32_t k = 0; k < count_; ++k)
        if (!measure_vertex(VertexId(list_[k]))) return false;
    for (std::uint32_t d = cages_, next; d != none; d = next == d ? none : next) {
        next = hierarchy_->cage(d).next;
        if (!measure_cage(d)) return false;
    }
    return true;
}

[[gnu::cold]] Status StepAudit::run() {
    ArenaScope scope(store_.arena);
    if (terms_.features && !audit_.outermost_features && has_outermost_features())
        audit_.outermost_features = all_features_rise_ = true;
    const bool fits = list_changed() && measure_listed();
    for (std::uint32_t d = cages_, next; d != none; d = next == d ? none : next) {
        Cage& cage = hierarchy_->cage(d);
        next = cage.next;
        cage.next = none;
    }
    if (!fits) return Status::out_of_memory;
    look_at_step();
    ++audit_.meshes;
    audit_.encroached += encroached_;
    return Status::ok;
}

double cage_insertion_bound(int dim, CageKind kind) {
    if (kind == CageKind::thesis && dim <= thesis_dim_max) {
        using Is = ThesisCage;
        const double apart = (template_packing(dim) - 2 * Is::gamma) * Is::shell_factor;
        const double off = Is::shell_factor * (1 - Is::gamma) - Is::epsilon;
        return (Is::shell_factor * (1 + Is::gamma) + Is::epsilon) / (apart < off ? apart : off);
    }
    // No shell vertex is nearer to another than to the inputs: corners are sqrt(2) apart.
    const double off = shell_jitter * square_root(dim), inner = shell_factor * (1 - shell_jitter);
    return (shell_factor * (1 + off) + cage_epsilon) / (inner - cage_epsilon);
}

Status audit_quality(const AnyAuditedMesh& mesh, const AuditStep& step, QualityAudit* audit) {
    return StepAudit(mesh, step, audit).run();
}

}  // namespace netmesh
