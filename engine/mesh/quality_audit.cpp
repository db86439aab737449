#include "mesh/quality_audit.hpp"

#include "delaunay/cell_list.hpp"
#include "mesh/cage_corner.hpp"
#include "mesh/clipped_cell.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Marks in Vertex::queued, beside that of the bucket queue, taken back before a step's audit ends.
constexpr std::uint8_t in_list = 2, seen = 4;

void raise(double value, double* most) {
    if (value > *most) *most = value;
}

// Takes the mark off a vertex. False when it had none.
template <int D> bool take_mark(Vertex<D>& vertex, std::uint8_t mark) {
    const bool had = (vertex.queued & mark) != 0;
    vertex.queued = static_cast<std::uint8_t>(vertex.queued & ~mark);
    return had;
}
// False when it has had one.
template <int D> bool put_mark(Vertex<D>& vertex, std::uint8_t mark) {
    const bool had = (vertex.queued & mark) != 0;
    vertex.queued = static_cast<std::uint8_t>(vertex.queued | mark);
    return !had;
}

// The two inputs nearest to a vertex, or, when that is an input itself, it and the nearest other one.
struct TwoNearest {
    std::uint32_t first = none, second = none;
    double first2 = infinity, second2 = infinity;

    explicit TwoNearest(std::uint32_t itself) : first(itself), first2(itself == none ? infinity : 0) {}

    void offer(std::uint32_t input, double d2) {
        if (!(d2 < second2) || input == first || input == second) return;
        const bool is_first = d2 < first2;
        second = is_first ? first : input;
        second2 = is_first ? first2 : d2;
        if (!is_first) return;
        first = input;
        first2 = d2;
    }
};

template <int D> class StepAudit {
public:
    StepAudit(const AuditedMesh<D>& mesh, const AuditStep& step, QualityAudit* audit)
        : store_(mesh.store), tree_(mesh.tree), outermost_(mesh.outermost), terms_(mesh.terms),
          hierarchy_(mesh.hierarchy != nullptr && mesh.hierarchy->live() > 0 ? mesh.hierarchy : nullptr),
          made_(mesh.hierarchy), kind_(mesh.kind), step_(step), audit_(*audit), frame_(mesh.tree.root().end) {}

    Status run();

private:
    template <class Visit> bool visit_changed(Visit&& visit);
    template <class Visit> bool visit_inside(const Cage& cage, Visit&& visit);
    template <class Visit> bool visit_noted(const AuditNote& note, Visit&& visit);
    bool has_outermost_features();
    bool list_changed();
    void list_cages(CellId c);
    bool measure_listed();
    bool measure_vertex(VertexId v);
    bool measure_ratio(VertexId v, std::uint32_t cells, double nearest2, const Domain<D>& ball);
    bool measure_cage(std::uint32_t d);
    double reach_of_cage(const Cage& cage, const CellId* boundary, std::uint32_t cells, double bound2) const;
    void look_from_outside(const Cage& cage, std::uint32_t w);
    void look_at_step();
    void look_at_shells();
    void raise_feature(const double* x, std::uint32_t domain, double mesh2, TwoNearest* inputs, double* kind);
    void find_second(const double* x, std::uint32_t domain, double enough2, TwoNearest* inputs);
    bool offer_member(const double* x, std::uint32_t domain, std::uint32_t input, double reach, TwoNearest* inputs);

    // Cells are whole then.
    bool is_thesis() const { return D <= thesis_dim_max && kind_ == CageKind::thesis; }
    // Is input v in the place of a vertex of the shell of its domain? With cages of the thesis alone.
    bool has_yielded(std::uint32_t v) const {
        return is_thesis() && hierarchy_ != nullptr &&
               has_yielded_to<D>(store_, hierarchy_->cages(), hierarchy_->of(v), v);
    }
    bool is_noted(std::uint32_t v) const {
        for (std::uint32_t k = 0; k < step_.note_count; ++k)
            if (step_.notes[k].vertex == v) return true;
        return false;
    }
    bool is_new(std::uint32_t v) const { return v >= step_.first_made || v == step_.vertex; }
    bool is_frame(std::uint32_t v) const { return v >= frame_ && v < frame_ + 2 * D; }
    std::uint32_t domain_of(std::uint32_t v) const { return hierarchy_ == nullptr ? none : hierarchy_->of(v); }
    std::uint32_t member(std::uint32_t v, std::uint32_t domain, std::uint32_t* within) const;
    // K' of those that the step has inserted.
    double* kind_of(std::uint32_t v) const {
        if (v == step_.vertex) return step_.cleaning ? &audit_.steiner : &audit_.input;
        const bool is_of_shell = v >= step_.first_made || (v < frame_ && is_noted(v) && has_yielded(v));
        return is_of_shell ? &audit_.cage : nullptr;
    }

    Store<D>& store_;
    const InputTree<D>& tree_;
    const Domain<D>& outermost_;
    const AuditTerms terms_;
    Hierarchy<D>*const hierarchy_, *const made_;  // null: no cages now; none ever
    const CageKind kind_;
    const AuditStep step_;
    QualityAudit& audit_;
    const std::uint32_t frame_;  // the first vertex of the frame
    std::uint32_t* list_ = nullptr;
    std::uint32_t count_ = 0;
    std::uint32_t cages_ = none;  // whose cells have changed: a list as that of AuditStep
    bool encroached_ = false;
    bool all_features_rise_ = false;  // f_P has just become finite in the outermost domain
};

// Calls visit(cell), perhaps several times, for each cell at a vertex that the step has inserted, or that was in a cage
// which it has released. False when the gap is too small for the search.
template <int D> template <class Visit> [[gnu::cold]] bool StepAudit<D>::visit_changed(Visit&& visit) {
    for (VertexId v(all_features_rise_ ? frame_ + 2 * D : step_.first_made); v < store_.state.vertex_count; ++v)
        if (!visit_star(store_, v, visit)) return false;
    if (step_.vertex < step_.first_made && !visit_star(store_, VertexId(step_.vertex), visit)) return false;
    for (std::uint32_t d = step_.released, next; d != none; d = next == d ? none : next) {
        const Cage& cage = made_->cage(d);
        next = cage.next;
        if (!visit_inside(cage, visit)) return false;
    }
    for (std::uint32_t k = 0; is_thesis() && k < step_.note_count; ++k)
        if (!visit_noted(step_.notes[k], visit)) return false;
    return true;
}

// A shell's own vertices follow one another; what comes after them does no harm.
template <int D>
template <class Visit>
[[gnu::cold]] bool StepAudit<D>::visit_noted(const AuditNote& note, Visit&& visit) {
    if (note.released != none) return visit_inside(made_->cage(note.released), visit);
    std::uint32_t end = note.vertex + 1;
    if constexpr (D <= thesis_dim_max)
        if (note.vertex >= frame_) end = note.vertex + CageTemplate<D>::size;
    if (end > store_.state.vertex_count) end = store_.state.vertex_count;
    for (VertexId v(note.vertex); v < end; ++v)
        if (!visit_star(store_, v, visit)) return false;
    return true;
}

// Any vertex in a ball about another one has a neighbour nearer to that, so the cells at vertices of a ball are
// connected.
template <int D> template <class Visit> [[gnu::cold]] bool StepAudit<D>::visit_inside(const Cage& cage, Visit&& visit) {
    CellList<D> list(store_);
    if (!list.add(store_.vertex(cage.centre).cell)) return false;
    for (std::uint32_t k = 0; k < list.size(); ++k) {
        const Cell<D>& cell = store_.cell(list[k]);
        visit(list[k]);
        unsigned inside = 0;
        for (int i = 0; i <= D; ++i)
            if (cell.vertex[i] != none && is_inside<D>(store_, cage, store_.point(cell.vertex[i]))) inside |= 1u << i;
        for (int i = 0; i <= D; ++i)
            if ((inside & ~(1u << i)) != 0 && cell.neighbour[i] != none && !list.add(cell.neighbour[i].cell()))
                return false;
    }
    return true;
}

// Are there two inputs in the outermost domain? Before, f_P is infinite there, and there may be vertices: a cage that
// holds all inputs counts as one.
template <int D> [[gnu::cold]] bool StepAudit<D>::has_outermost_features() {
    TwoNearest inputs(none);
    find_second(outermost_.centre, is_thesis() ? 0 : none, 0x1p1000, &inputs);
    return inputs.second2 < infinity;
}

// Counts, then lists the vertices of these cells.
template <int D> [[gnu::cold]] bool StepAudit<D>::list_changed() {
    const bool counted = visit_changed([&](CellId c) {
        for (const VertexId v : store_.cell(c).vertex)
            if (v != none) count_ += put_mark<D>(store_.vertex(v), in_list);
    });
    list_ = counted ? store_.arena.template take_low<std::uint32_t>(count_) : nullptr;
    std::uint32_t listed = 0;
    const bool fits = list_ != nullptr && visit_changed([&](CellId c) {
                          for (const VertexId v : store_.cell(c).vertex)
                              if (v != none && take_mark<D>(store_.vertex(v), in_list)) list_[listed++] = v;
                          list_cages(c);
                      });
    if (fits) return true;
    for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) take_mark<D>(store_.vertex(v), in_list);
    return false;
}

// The cell belongs to the boundary of each cage that has some of its vertices but not all.
template <int D> [[gnu::cold]] void StepAudit<D>::list_cages(CellId c) {
    if (hierarchy_ == nullptr || store_.is_ghost(c)) return;
    std::uint32_t domains[D + 1];
    bool equal = true;
    for (int i = 0; i <= D; ++i) {
        domains[i] = hierarchy_->of(store_.cell(c).vertex[i]);
        equal &= domains[i] == domains[0];
    }
    for (int i = 0; i <= D && !equal; ++i)
        for (std::uint32_t d = domains[i]; d != none && is_on_boundary<D>(store_, hierarchy_->cage(d), c);
             d = hierarchy_->parent(d)) {
            Cage& cage = hierarchy_->cage(d);
            if (cage.next != none || (is_thesis() && cage.parent == none)) continue;
            cage.next = cages_ == none ? d : cages_;
            cages_ = d;
        }
}

// The vertex of M_Omega, Omega a domain, that stands for v: itself, or the centre of the cage *within directly inside
// of Omega; none when v is outside of Omega's ball.
template <int D>
[[gnu::cold]] std::uint32_t StepAudit<D>::member(std::uint32_t v, std::uint32_t domain, std::uint32_t* within) const {
    *within = none;
    if (is_frame(v)) return none;
    if (hierarchy_ == nullptr) return v;
    std::uint32_t d = hierarchy_->of(v);
    for (; d != domain && d != none; d = hierarchy_->parent(d)) *within = d;
    if (d != domain) return none;
    return *within == none ? v : hierarchy_->cage(*within).centre;
}

// Offers what stands for an input in M_Omega. True when all within `reach` of the input is within the same cage.
template <int D>
[[gnu::cold]] bool StepAudit<D>::offer_member(const double* x, std::uint32_t domain, std::uint32_t input, double reach,
                                              TwoNearest* inputs) {
    if (terms_.inserted_inputs && store_.vertex(input).cell == none) return false;
    if (hierarchy_ == nullptr) {
        inputs->offer(input, distance2<D>(x, store_.point(input)));
        return false;
    }
    std::uint32_t within;
    const std::uint32_t m = member(input, domain, &within);
    if (m == none) return false;
    inputs->offer(m, distance2<D>(x, store_.point(m)));
    if (within == none) return false;
    const double offset = distance<D>(store_.point(input), store_.point(m));
    return (offset + reach) * (1 + 8 * unit_roundoff) < hierarchy_->cage(within).radius;
}

// Finds the second nearest input of M_Omega, or any two inputs that are near enough.
template <int D>
[[gnu::cold]] void StepAudit<D>::find_second(const double* x, std::uint32_t domain, double enough2,
                                             TwoNearest* inputs) {
    TreePart<D> stack[40];
    int depth = 0;
    stack[depth++] = {tree_.root(), 0, {}};
    while (depth > 0 && inputs->second2 > enough2) {
        const TreePart<D> part = stack[--depth];
        if (!(part.least2 < inputs->second2)) continue;
        TreeRange range = part.range;
        bool passed = false;
        while (!range.is_leaf() && !passed) {
            const std::uint32_t middle = range.middle(), item = tree_.item(middle);
            passed = offer_member(x, domain, item, tree_.reach(middle), inputs);
            const int axis = tree_.axis(middle);
            const double offset = x[axis] - store_.point(item)[axis];
            stack[depth] = part.beyond(axis, offset, offset < 0 ? range.above() : range.below());
            if (!passed && stack[depth].least2 < inputs->second2) ++depth;
            range = offset < 0 ? range.below() : range.above();
        }
        for (std::uint32_t i = range.begin; i < range.end && !passed; ++i)
            offer_member(x, domain, tree_.item(i), infinity, inputs);
    }
}

// `inputs` holds what is known. A feature size that does not make K or K' larger need not be known any better.
template <int D>
[[gnu::cold]] void StepAudit<D>::raise_feature(const double* x, std::uint32_t domain, double mesh2, TwoNearest* inputs,
                                               double* kind) {
    const double least = kind != nullptr && *kind < audit_.feature ? *kind : audit_.feature;
    find_second(x, domain, least * least * mesh2, inputs);
    if (!(inputs->second2 < infinity)) return;
    const double ratio = square_root(inputs->second2 / mesh2);
    raise(ratio, &audit_.feature);
    if (kind != nullptr) raise(ratio, kind);
}

// False when the gap is too small.
template <int D> [[gnu::cold]] bool StepAudit<D>::measure_vertex(VertexId v) {
    if (is_frame(v)) return true;
    const Vertex<D>& vertex = store_.vertex(v);
    const std::uint32_t domain = domain_of(v);
    TwoNearest inputs(vertex.marker == Marker::input ? v : none);
    double nearest2 = infinity, mesh2 = infinity;
    const bool may_all_rise = is_new(v) || step_.released != none || step_.note_count > 0 || all_features_rise_;
    bool ratio_may_rise = may_all_rise, feature_may_rise = may_all_rise;
    std::uint32_t cells = 0, degree = 0;
    const bool fits = visit_star(store_, v, [&](CellId c) {
        ++cells;
        for (const VertexId w : store_.cell(c).vertex) {
            if (w == v || w == none || !put_mark<D>(store_.vertex(w), seen)) continue;
            ++degree;
            const double d2 = distance2<D>(vertex.x, store_.point(w));
            if (d2 < nearest2) {
                nearest2 = d2;
                ratio_may_rise = may_all_rise || is_new(w);
            }
            std::uint32_t within;
            const std::uint32_t m = terms_.features ? member(w, domain, &within) : none;
            if (m == none) continue;
            const double member2 = m == w ? d2 : distance2<D>(vertex.x, store_.point(m));
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
            if (w != none) take_mark<D>(store_.vertex(w), seen);
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
    Domain<D> ball = domain_ball<D>(store_, hierarchy_->cages(), domain, outermost_);
    if (is_thesis()) ball.radius = infinity;
    return measure_ratio(v, cells, nearest2, ball);
}

// Just before, v's star of `cells` cells has been visited.
template <int D>
[[gnu::cold]] bool StepAudit<D>::measure_ratio(VertexId v, std::uint32_t cells, double nearest2,
                                               const Domain<D>& ball) {
    const double* const p = store_.point(v);
    const double bound2 = 0.25 * audit_.worst * audit_.worst * nearest2;
    const CellId* const star = store_.list_top();
    Corner<D> farthest;
    farthest.distance2 = bound2;
    bool leaves_ball = false, bounded = true;
    for (std::uint32_t k = 0; k < cells; ++k) {
        const CellId c = star[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) {
            leaves_ball = true;
            bounded &= !store_.is_ghost(c);
        } else if (ball.contains(cell.centre)) {
            if (cell.radius2 * (1 + 0x1p-20) > bound2) farthest.offer(cell.centre, distance2<D>(cell.centre, p), c);
        } else {
            leaves_ball |= cell.radius2 * (1 + 0x1p-20) > bound2;  // then crossings of edges are poles too
        }
    }
    double out2 = bounded ? farthest.distance2 : infinity;
    if (leaves_ball && bounded && !is_thesis() && !raise_to_poles<D>(store_, ball, v, &out2)) return false;
    if (out2 > bound2) raise(2 * square_root(out2 / nearest2), &audit_.worst);
    return true;
}

// Does w, outside of the cage and near its boundary, encroach on it?
template <int D> [[gnu::cold]] void StepAudit<D>::look_from_outside(const Cage& cage, std::uint32_t w) {
    const double* const centre = store_.point(cage.centre);
    const double clear = (is_thesis() ? ThesisCage::clearance : cage_clearance) * cage.radius;
    if (!(distance2<D>(store_.point(w), centre) < clear * clear)) return;
    if (is_thesis()) encroached_ = true;
    const Marker marker = store_.vertex(w).marker;
    const std::uint32_t domain = hierarchy_->of(w);
    encroached_ |= marker == Marker::input || domain == none ||
                   (marker == Marker::steiner && hierarchy_->contains(domain, centre));
}

template <int D> [[gnu::cold]] bool StepAudit<D>::measure_cage(std::uint32_t d) {
    Cage cage = hierarchy_->cage(d);
    const double* const centre = store_.point(cage.centre);
    const std::uint32_t around = hierarchy_->parent(d);
    const double epsilon = is_thesis() ? ThesisCage::epsilon : cage_epsilon;
    const double r2 = cage.radius * cage.radius, inner2 = epsilon * epsilon * r2;
    cage.nearest2 = infinity;
    double mesh2 = infinity;
    TwoNearest inputs(cage.centre);
    std::uint32_t cells = 0;
    const bool fits = visit_cage_boundary(store_, cage, [&](CellId c) {
        ++cells;
        for (const VertexId w : store_.cell(c).vertex) {
            if (w == none || !put_mark<D>(store_.vertex(w), seen)) continue;
            const double d2 = distance2<D>(store_.point(w), centre);
            if (d2 < r2) {
                encroached_ |= store_.vertex(w).marker == Marker::input && d2 > inner2 &&
                               !(has_yielded(w) && hierarchy_->of(w) == d);
                continue;
            }
            if (d2 < cage.nearest2) cage.nearest2 = d2;
            look_from_outside(cage, w);
            std::uint32_t within;
            const std::uint32_t m = member(w, around, &within);
            if (m == none || m == cage.centre) continue;
            const double member2 = m == w ? d2 : distance2<D>(centre, store_.point(m));
            if (member2 < mesh2) mesh2 = member2;
            if (store_.vertex(m).marker == Marker::input) inputs.offer(m, member2);
        }
    });
    const CellId* const boundary = store_.list_top();
    for (std::uint32_t k = 0; k < cells; ++k)
        for (const VertexId w : store_.cell(boundary[-1 - static_cast<std::ptrdiff_t>(k)]).vertex)
            if (w != none) take_mark<D>(store_.vertex(w), seen);
    if (!fits) return false;
    const double inner = is_thesis() ? 0.5 * square_root(cage.nearest2) : in_radius<D>(cage);
    const double bound2 = audit_.worst * audit_.worst * inner * inner;
    const double out2 = reach_of_cage(cage, boundary, cells, bound2);
    if (out2 > bound2) raise(square_root(out2) / inner, &audit_.worst);
    if (terms_.features && mesh2 < infinity) raise_feature(centre, around, mesh2, &inputs, nullptr);
    return true;
}

// Squared, or bound2 where that is more. boundary as in raise_to_cage_cell.
template <int D>
[[gnu::cold]] double StepAudit<D>::reach_of_cage(const Cage& cage, const CellId* boundary, std::uint32_t cells,
                                                 double bound2) const {
    double out2 = bound2;
    if (!is_thesis()) {
        const Domain<D> ball = domain_ball<D>(store_, hierarchy_->cages(), cage.parent, outermost_);
        raise_to_cage_cell<D>(store_, cage, ball, boundary, cells, &out2);
        return out2;
    }
    for (std::uint32_t k = 0; k < cells; ++k) {
        const Cell<D>& cell = store_.cell(boundary[-1 - static_cast<std::ptrdiff_t>(k)]);
        if (cell.radius2 < infinity) raise(distance2<D>(cell.centre, store_.point(cage.centre)), &out2);
    }
    return out2;
}

// Inputs that the step has inserted, and the shells that it has made, of cages of the thesis.
template <int D> [[gnu::cold]] void StepAudit<D>::look_at_shells() {
    const auto look_at_input = [&](std::uint32_t v) {
        if (v >= frame_) return;
        const std::uint32_t own = has_yielded(v) ? hierarchy_->of(v) : none;
        for (std::uint32_t d = hierarchy_->of(v); d != none; d = hierarchy_->parent(d)) {
            const Cage& cage = hierarchy_->cage(d);
            const double inner = ThesisCage::epsilon * cage.radius;
            encroached_ |= d != own && distance2<D>(store_.point(v), store_.point(cage.centre)) > inner * inner;
        }
    };
    look_at_input(step_.vertex);
    for (std::uint32_t k = 0; k < step_.note_count; ++k) look_at_input(step_.notes[k].vertex);
    for (std::uint32_t v = step_.first_made; v < store_.state.vertex_count; ++v) {
        if (store_.vertex(v).marker != Marker::exempt) continue;
        const std::uint32_t d = hierarchy_->of(v), around = d == none ? none : hierarchy_->parent(d);
        encroached_ |= d == none || !is_by_shell<D>(store_, hierarchy_->cage(d), v);
        if (around == none) continue;
        const Cage &cage = hierarchy_->cage(d), &outer = hierarchy_->cage(around);
        encroached_ |=
            !(distance<D>(store_.point(cage.centre), store_.point(outer.centre)) + cage.radius <= outer.radius);
    }
}

// Of the step's input, and the cage that was made for it.
template <int D> [[gnu::cold]] void StepAudit<D>::look_at_step() {
    if (hierarchy_ == nullptr) return;
    if (is_thesis()) return look_at_shells();
    if (step_.vertex != none && store_.vertex(step_.vertex).marker == Marker::input)
        for (std::uint32_t d = hierarchy_->of(step_.vertex); d != none; d = hierarchy_->parent(d)) {
            const Cage& cage = hierarchy_->cage(d);
            const double inner = cage_epsilon * cage.radius;
            encroached_ |= distance2<D>(store_.point(step_.vertex), store_.point(cage.centre)) > inner * inner;
        }
    const std::uint32_t last = hierarchy_->made() - 1;
    const Cage& cage = hierarchy_->cage(last);
    if (cage.shell != step_.first_made) return;
    const double* const centre = store_.point(cage.centre);
    const double least = shell_least * cage.radius;
    for (std::uint32_t v = cage.shell; v < cage.shell + shell_size<D>; ++v)
        encroached_ |= store_.vertex(v).marker != Marker::exempt || !is_inside<D>(store_, cage, store_.point(v)) ||
                       distance2<D>(store_.point(v), centre) < least * least;
    const std::uint32_t around = hierarchy_->parent(last);
    if (around == none) return;
    const Cage& outer = hierarchy_->cage(around);
    encroached_ |= !(distance<D>(centre, store_.point(outer.centre)) + cage.radius <= outer.radius);
}

template <int D> [[gnu::cold]] bool StepAudit<D>::measure_listed() {
    for (std::uint32_t k = 0; k < count_; ++k)
        if (!measure_vertex(VertexId(list_[k]))) return false;
    for (std::uint32_t d = cages_, next; d != none; d = next == d ? none : next) {
        next = hierarchy_->cage(d).next;
        if (!measure_cage(d)) return false;
    }
    return true;
}

template <int D> [[gnu::cold]] Status StepAudit<D>::run() {
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

}  // namespace

template <int D> double cage_insertion_bound(CageKind kind) {
    if constexpr (D <= thesis_dim_max)
        if (kind == CageKind::thesis) {
            using Is = ThesisCage;
            const double apart = (CageTemplate<D>::packing - 2 * Is::gamma) * Is::shell_factor;
            const double off = Is::shell_factor * (1 - Is::gamma) - Is::epsilon;
            return (Is::shell_factor * (1 + Is::gamma) + Is::epsilon) / (apart < off ? apart : off);
        }
    // No shell vertex is nearer to another than to the inputs: corners are sqrt(2) apart.
    const double off = shell_jitter * square_root(D), inner = shell_factor * (1 - shell_jitter);
    return (shell_factor * (1 + off) + cage_epsilon) / (inner - cage_epsilon);
}

template <int D> Status audit_quality(const AuditedMesh<D>& mesh, const AuditStep& step, QualityAudit* audit) {
    return StepAudit<D>(mesh, step, audit).run();
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template double cage_insertion_bound<D>(CageKind);                                                                 \
    template Status audit_quality<D>(const AuditedMesh<D>&, const AuditStep&, QualityAudit*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
