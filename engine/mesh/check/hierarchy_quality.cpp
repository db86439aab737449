#include "mesh/check/hierarchy_quality.hpp"

#include "delaunay/sphere.hpp"
#include "mesh/cages/any_cage.hpp"
#include "mesh/cages/cage_corner.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {
namespace {

struct LargerCage {
    const Cage* cages;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
        return cages[a].radius > cages[b].radius || (cages[a].radius == cages[b].radius && a < b);
    }
};

// A corner within a ball, or the points in which its edges leave that ball.
struct Clipped {
    int count = 0;
    int facet[2 * (dimension_max + 1)];  // that the edge of a point crosses; -1: the corner itself
    double x[2 * (dimension_max + 1)][dimension_max];

    void add(int dim, const double* point, int across) {
        facet[count] = across;
        copy(dim, point, x[count++]);
    }
};

// The corner of the cell of these vertices. False when it is too flat for doubles to know it.
bool solve_corner(int dim, const double* const* p, double* centre) {
    return with_dimension(static_cast<std::uint32_t>(dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Cell<D> scratch;
        solve_sphere<D>(p, corner_error_max, scratch);
        copy<D>(scratch.centre, centre);
        return scratch.radius2 < infinity;
    });
}

class Measurement {
public:
    Measurement(const AnyStore& store, const HierarchyRequest& request, Arena& arena)
        : dim(store.dim), store_(store), cages_(request.cages), count_(request.count), outermost_(request.outermost),
          arena_(arena), kind_(request.kind) {}

    Status open();
    CheckResult find_domains();
    CheckResult find_shells();
    CheckResult find_encroached();
    void measure_cells();
    Status measure_poles();
    void worst(HierarchyQuality* quality) const;
    void report(const HierarchyRequest& request) const;

private:
    template <class Visit> std::uint32_t visit_ball(std::uint32_t centre, double radius, Visit&& visit);
    CageBoundary list_boundary(const Cage& cage);
    bool is_finite(std::uint32_t c) const { return store_.is_live(c) && !store_.is_ghost(c); }
    // The cell behind facet i; none outside, where a store in use has a ghost.
    std::uint32_t neighbour(std::uint32_t c, int i) const {
        const FacetId facet = store_.cell(c).neighbour[i];
        return facet == none || store_.is_ghost(facet.cell()) ? none : facet.cell();
    }
    bool corner(std::uint32_t c, double* centre) const;
    bool counts(std::uint32_t v) const {
        return store_.vertex(v).cell != none && store_.vertex(v).marker != Marker::exempt && !has_yielded(v);
    }
    // Cells are not clipped then.
    bool is_thesis() const { return dim <= thesis_dim_max && kind_ == CageKind::thesis; }
    // Is v an input in the place of a shell vertex? With cages of the thesis alone.
    bool has_yielded(std::uint32_t v) const { return is_thesis() && has_yielded_to(store_, cages_, domain_[v], v); }
    bool is_outermost(std::uint32_t d) const { return is_thesis() && cages_[d].parent == none; }
    // The ball that cells of a domain are clipped to.
    AnyDomain ball_of(std::uint32_t domain) const {
        AnyDomain ball = domain_ball(store_, cages_, is_thesis() ? none : domain, outermost_);
        if (is_thesis()) ball.radius = infinity;
        return ball;
    }
    double in_radius_of(const Cage& cage) const {
        return is_thesis() ? 0.5 * square_root(cage.nearest2) : in_radius(cage);
    }
    CheckResult find_thesis_shells();
    bool is_template_covered(std::uint32_t d);
    double ratio(std::uint32_t v) const { return counts(v) ? 2 * square_root(out2_[v] / nearest2_[v]) : 0; }
    void raise_vertices(std::uint32_t c, const double* corner);
    void raise_cages(std::uint32_t c, const double* corner);
    void clip(const AnyDomain& ball, std::uint32_t c, const double* corner, Clipped* points) const;

    const int dim;
    const AnyStore& store_;
    Cage* cages_;
    std::uint32_t count_;
    const AnyDomain& outermost_;
    Arena& arena_;
    const CageKind kind_;
    std::uint32_t *order_, *domain_, *mark_;
    CellId* list_;
    std::uint32_t stamp_ = 0;
    double *nearest2_, *out2_, *cage_out2_;
    bool *leaves_ball_, *cage_leaves_ball_;  // has the cell a corner outside of its ball, or one that is not known?
};

[[gnu::cold]] Status Measurement::open() {
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

// Calls visit(vertex, squared distance) for each vertex within the ball, perhaps several times: any vertex has a
// Delaunay neighbour nearer to the centre, so the cells at vertices of a ball are connected. They are in list_ then,
// as many as are returned.
template <class Visit> std::uint32_t Measurement::visit_ball(std::uint32_t centre, double radius, Visit&& visit) {
    const double* const x = store_.point(centre);
    ++stamp_;
    std::uint32_t count = 0;
    list_[count++] = store_.vertex(centre).cell;
    mark_[list_[0]] = stamp_;
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = store_.arena.piece(k, count, 50 * dim); k < piece; ++k) {
            const AnyCell cell = store_.cell(list_[k]);
            unsigned inside = 0;
            for (int i = 0; i <= dim; ++i) {
                const double d2 = distance2(dim, store_.point(cell.vertex[i]), x);
                if (!(d2 < radius * radius)) continue;
                inside |= 1u << i;
                visit(cell.vertex[i], d2);
            }
            for (int i = 0; i <= dim; ++i) {
                // The neighbour has all vertices of the cell but the i-th.
                const std::uint32_t n = (inside & ~(1u << i)) == 0 ? none : neighbour(list_[k], i);
                if (n == none || mark_[n] == stamp_) continue;
                mark_[n] = stamp_;
                list_[count++] = CellId(n);
            }
        }
    return count;
}

// From the largest cage to the smallest: each takes its vertices from the one around it.
[[gnu::cold]] CheckResult Measurement::find_domains() {
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
[[gnu::cold]] CheckResult Measurement::find_shells() {
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
[[gnu::cold]] bool Measurement::is_template_covered(std::uint32_t d) {
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
[[gnu::cold]] CheckResult Measurement::find_thesis_shells() {
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

[[gnu::cold]] CheckResult Measurement::find_encroached() {
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

// The corner of cell c; false when the cell is too flat for doubles to know it.
[[gnu::noinline]] bool Measurement::corner(std::uint32_t c, double* centre) const {
    const double* p[dimension_max + 1];
    for (int i = 0; i <= dim; ++i) p[i] = store_.point(store_.cell(c).vertex[i]);
    return solve_corner(dim, p, centre);
}

// The corner of cell c, when the ball contains it, or the crossings of its edges.
[[gnu::noinline]] void Measurement::clip(const AnyDomain& ball, std::uint32_t c, const double* here,
                                         Clipped* points) const {
    points->count = 0;
    if (ball.contains(here)) return points->add(dim, here, -1);
    for (int i = 0; i <= dim; ++i) {
        const std::uint32_t n = neighbour(c, i);
        double there[dimension_max];
        if (n == none || !corner(n, there)) continue;
        double z[2][dimension_max];
        const int crossings = sphere_crossings(ball, here, there, z);
        for (int j = 0; j < crossings; ++j) points->add(dim, z[j], i);
    }
}

void Measurement::raise_vertices(std::uint32_t c, const double* here) {
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
        for (int i = first; i <= dim && !ball.contains(here); ++i)
            if (equal >> i & 1u) leaves_ball_[cell.vertex[i]] = true;
        clip(ball, c, here, &points);
        for (int k = 0; k < points.count; ++k)
            for (int i = 0; i <= dim; ++i) {
                if (i == points.facet[k] || (equal >> i & 1u) == 0) continue;
                const double d2 = distance2(dim, points.x[k], store_.point(cell.vertex[i]));
                if (d2 > out2_[cell.vertex[i]]) out2_[cell.vertex[i]] = d2;
            }
    }
}

// The corner belongs to each cage that has some of the cell's vertices but not all.
[[gnu::cold]] void Measurement::raise_cages(std::uint32_t c, const double* here) {
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
            if (!ball.contains(here)) cage_leaves_ball_[d] = true;
            clip(ball, c, here, &points);
            for (int k = 0; k < points.count; ++k) {
                const int facet = points.facet[k];
                if (facet >= 0 && !is_mixed(store_, cages_[d], c, facet)) continue;
                const double d2 = distance2(dim, points.x[k], centre);
                if (d2 > cage_out2_[d]) cage_out2_[d] = d2;
            }
        }
}

void Measurement::measure_cells() {
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
            double here[dimension_max];
            if (!corner(c, here)) {
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
CageBoundary Measurement::list_boundary(const Cage& cage) {
    const std::uint32_t cells = visit_ball(cage.centre, cage.radius, [](std::uint32_t, double) {});
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k < cells;)
        for (const std::uint64_t piece = store_.arena.piece(k, cells, 10 * dim); k < piece; ++k)
            if (is_on_boundary(store_, cage, list_[k])) list_[count++] = list_[k];
    return {list_ + count, count};
}

// What lies on a sphere, but on no edge. The lists of the search for domains are not needed any more.
[[gnu::cold]] Status Measurement::measure_poles() {
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

[[gnu::cold]] void Measurement::worst(HierarchyQuality* quality) const {
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

[[gnu::cold]] void Measurement::report(const HierarchyRequest& request) const {
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

}  // namespace

Status measure_hierarchy(const AnyStore& store, const HierarchyRequest& request, Arena& arena,
                         HierarchyQuality* quality) {
    ArenaScope scope(arena);
    *quality = {0, none, false, {nullptr, none}};
    Measurement measurement(store, request, arena);
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
