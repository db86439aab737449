// What measure_hierarchy takes down of a mesh with cages: domains in hierarchy_domains.cpp, cells in
// hierarchy_quality.cpp.
#pragma once
#include "mesh/cages/any_cage.hpp"
#include "mesh/cages/cage_corner.hpp"
#include "mesh/check/hierarchy_quality.hpp"

namespace netmesh {

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

// The corner of a cell. Where coordinates hardly resolve it `blur` is how far it may be off, else 0; the cell's radius
// is known all the same (delaunay/sphere.hpp).
struct KnownCorner {
    double x[dimension_max];
    double radius2, blur;
};

class HierarchyMeasurement {
public:
    HierarchyMeasurement(const AnyStore& store, const HierarchyRequest& request, Arena& arena)
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
    bool corner(std::uint32_t c, KnownCorner* found) const;
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
    void raise_vertices(std::uint32_t c, const KnownCorner& corner);
    void raise_cages(std::uint32_t c, const KnownCorner& corner);
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

// Calls visit(vertex, squared distance) for each vertex within the ball, perhaps several times: any vertex has a
// Delaunay neighbour nearer to the centre, so the cells at vertices of a ball are connected. They are in list_ then,
// as many as are returned.
template <class Visit>
std::uint32_t HierarchyMeasurement::visit_ball(std::uint32_t centre, double radius, Visit&& visit) {
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

}  // namespace netmesh
