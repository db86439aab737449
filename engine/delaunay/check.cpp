#include "delaunay/check.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

Sign orientation(int dim, const double* const* p, PredicateCounts& counts) {
    return with_dimension(static_cast<std::uint32_t>(dim),
                          [&](auto dimension) { return orient<decltype(dimension)::value>(p, counts); });
}

Sign in_ball_of(int dim, const double* const* cell, const double* q, PredicateCounts& counts) {
    return with_dimension(static_cast<std::uint32_t>(dim),
                          [&](auto dimension) { return in_ball<decltype(dimension)::value>(cell, q, counts); });
}

int position_of(const AnyCell& cell, VertexId v) {
    for (int i = 0; i < cell.vertex.count; ++i)
        if (cell.vertex[i] == v) return i;
    return -1;
}

void points_of(const AnyStore& store, CellId c, const double** p) {
    for (int i = 0; i <= store.dim; ++i) p[i] = store.point(store.cell(c).vertex[i]);
}

// From hull facet `facet` of cell c across its ridge without vertex `ridge`: the vertex of the next hull facet that is
// not on the ridge. Turns around the ridge through at most all cells; `none` if that does not end.
VertexId across_ridge(const AnyStore& store, CellId c, int facet, int ridge) {
    int enter = facet, leave = ridge;
    for (std::uint32_t steps = 0; steps <= store.state.cell_slots; ++steps) {
        const AnyCell cell = store.cell(c);
        const FacetId next = cell.neighbour[leave];
        if (next == none) return cell.vertex[enter];
        const VertexId pivot = cell.vertex[enter];
        c = next.cell();
        enter = static_cast<int>(next.position());
        leave = position_of(store.cell(c), pivot);
    }
    return none;
}

// The sign of orient with p[at] a point o inside cell 0: v_0 + e (v_1 - v_0) + e^2 (v_2 - v_0) + ..., e > 0 as small as
// need be, so that no double has to lie there. orient is affine in each of its points: the sign is that with the first
// v_b in place of o with which it is not zero. Zero only when the other points are affinely dependent, as cell 0 is not
// flat. Mostly one test, dim + 1 at worst. Changes p[at].
Sign seen_from_inside(const AnyStore& store, const double** p, int at, PredicateCounts& counts) {
    Sign sign = Sign::zero;
    for (int b = 0; b <= store.dim && sign == Sign::zero; ++b) {
        p[at] = store.point(store.cell(0u).vertex[b]);
        sign = orientation(store.dim, p, counts);
    }
    return sign;
}

// Does the ray from o through hull facet `target` pass through another one, whose vertices are in p but for p[at], and
// which has o on its inner side? The ray goes through a point of the target that is made of its vertices as o is of
// those of cell 0, with an e so small that o is decided first. No sign is zero: it would be with each vertex of the
// target, and all of these would lie in the affine hull of a ridge.
bool ray_meets(const AnyStore& store, FacetId target, const double** p, int at, PredicateCounts& counts) {
    for (int j = 0; j <= store.dim; ++j) {
        if (j == at) continue;
        const double* const kept = p[j];
        Sign sign = Sign::zero;
        for (int a = 0; a <= store.dim && sign == Sign::zero; ++a) {
            if (a == static_cast<int>(target.position())) continue;
            p[j] = store.point(store.cell(target.cell()).vertex[a]);
            sign = seen_from_inside(store, p, at, counts);
        }
        p[j] = kept;
        if (sign != Sign::positive) return false;
    }
    return true;
}

// Cells are positively oriented, neighbours on opposite sides of their facet, and each ridge of the hull is locally
// convex. Then this is a triangulation of the convex hull of its vertices if and only if
//   (1) o is strictly inside of each hull facet, and
//   (2) a ray from o, in general position, passes through one hull facet only.
// Proof. In the boundary of the sum of all cells, as an oriented chain, inner facets cancel. The hull is what remains:
// a cycle, so its winding number about a point off it is how many facets a generic ray from there meets, with signs,
// and is the number of cells over the point. About o all signs are + by (1), and (2) says 1: each generic ray from o
// meets one facet. So the cones from o over hull facets fill space and overlap nowhere, and each wall of a cone, over a
// ridge, is one of the cone that across_ridge finds. The function that is linear on each cone and 1 on its facet is
// then continuous and, as ridges are locally convex, convex along each line that meets walls inside only: almost all
// lines, hence all. So the hull is where a convex function is 1, the boundary of a convex body. About points in it the
// winding number is 1, about others 0: each generic point of the body is in one cell. The body, having its corners
// among the vertices, is their convex hull. And cells that fill it facet to facet meet in common faces, which rules out
// vertices that are two in one place. The converse is plain.
CheckResult check_hull(const AnyStore& store, PredicateCounts& counts) {
    const int dim = store.dim;
    const double* p[dimension_max + 1];
    FacetId target = none;
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 100 * dim * dim); c < piece; ++c)
            for (int i = 0; i <= dim; ++i) {
                if (store.cell(c).neighbour[i] != none) continue;
                points_of(store, c, p);
                bool fails = seen_from_inside(store, p, i, counts) != Sign::positive;
                if (target == none)
                    target = FacetId(c, static_cast<std::uint32_t>(i));
                else
                    fails = fails || ray_meets(store, target, p, i, counts);
                if (fails) return {"the hull is not that of one convex body", c};
            }
    return {nullptr, none};
}

}  // namespace

CheckResult check_combinatorial(const AnyStore& store) {
    const int dim = store.dim;
    const std::uint32_t corners = static_cast<std::uint32_t>(dim) + 1;
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 30 * dim * dim); c < piece; ++c) {
            const AnyCell cell = store.cell(c);
            for (int i = 0; i <= dim; ++i) {
                if (cell.vertex[i] >= store.state.vertex_count) return {"a cell has a vertex that does not exist", c};
                for (int j = 0; j < i; ++j)
                    if (cell.vertex[i] == cell.vertex[j]) return {"a cell has a vertex twice", c};
            }
            for (std::uint32_t i = 0; i < corners; ++i) {
                const FacetId facet = cell.neighbour[i];
                if (facet == none) continue;
                const CellId n = facet.cell();
                const std::uint32_t j = facet.position();
                if (n >= store.state.cell_slots || n == c || j >= corners) return {"a neighbour does not exist", c};
                const AnyCell other = store.cell(n);
                if (other.neighbour[j] != FacetId(c, i)) return {"neighbours are not mutual", c};
                for (std::uint32_t k = 0; k < corners; ++k)
                    if (k != i && position_of(other, cell.vertex[k]) < 0) return {"neighbours do not share a facet", c};
                if (position_of(cell, other.vertex[j]) >= 0) return {"neighbours share more than a facet", c};
            }
        }
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 12); v < piece; ++v) {
            const CellId c = store.vertex(v).cell;
            if (c == none) continue;
            if (c >= store.state.cell_slots || position_of(store.cell(c), v) < 0)
                return {"a vertex points to a cell that it does not belong to", none};
        }
    return {nullptr, none};
}

CheckResult check_geometric(const AnyStore& store) {
    const int dim = store.dim;
    PredicateCounts counts = {};
    const double* p[dimension_max + 1];
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 100 * dim * dim); c < piece;
             ++c) {
            points_of(store, c, p);
            if (orientation(dim, p, counts) != Sign::positive) return {"a cell is flat or not positively oriented", c};
            for (int i = 0; i <= dim; ++i) {
                const FacetId beyond = store.cell(c).neighbour[i];
                const double* const kept = p[i];
                if (beyond != none && beyond.cell() < c) {
                    p[i] = store.point(store.cell(beyond.cell()).vertex[beyond.position()]);
                    if (orientation(dim, p, counts) == Sign::positive) return {"two neighbours overlap", c};
                    p[i] = kept;
                }
                if (beyond != none) continue;
                for (int j = 0; j <= dim; ++j) {
                    if (j == i) continue;
                    const VertexId w = across_ridge(store, c, i, j);
                    if (w == none) return {"the hull is not closed", c};
                    p[i] = store.point(w);
                    if (orientation(dim, p, counts) == Sign::negative) return {"the hull is not convex", c};
                }
                p[i] = kept;
            }
        }
    return check_hull(store, counts);
}

CheckResult check_delaunay(const AnyStore& store) {
    const int dim = store.dim;
    PredicateCounts counts = {};
    const double* p[dimension_max + 1];
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 100 * dim); c < piece; ++c) {
            points_of(store, c, p);
            for (int i = 0; i <= dim; ++i) {
                const FacetId facet = store.cell(c).neighbour[i];
                if (facet == none || facet.cell() < c) continue;
                const double* const q = store.point(store.cell(facet.cell()).vertex[facet.position()]);
                if (in_ball_of(dim, p, q, counts) == Sign::positive)
                    return {"a vertex lies inside the ball of a cell", c};
            }
        }
    return {nullptr, none};
}

#ifdef NETMESH_VALIDATE
namespace {

const char* violation_at(const AnyStore& store, CellId c) {
    const int dim = store.dim;
    const std::uint32_t corners = static_cast<std::uint32_t>(dim) + 1;
    const AnyCell cell = store.cell(c);
    int infinite = 0;
    for (int i = 0; i <= dim; ++i) {
        infinite += cell.vertex[i] == none;
        if (cell.vertex[i] != none && cell.vertex[i] >= store.state.vertex_count) return "a vertex does not exist";
        for (int j = 0; j < i; ++j)
            if (cell.vertex[i] == cell.vertex[j]) return "a cell has a vertex twice";
    }
    for (std::uint32_t i = 0; i < corners; ++i) {
        const FacetId facet = cell.neighbour[i];
        const CellId n = facet.cell();
        if (n >= store.state.cell_slots || n == c || !store.is_live(n) || facet.position() >= corners)
            return "a neighbour does not exist";
        if (store.cell(n).neighbour[facet.position()] != FacetId(c, i)) return "neighbours are not mutual";
        for (std::uint32_t k = 0; k < corners; ++k)
            if (k != i && position_of(store.cell(n), cell.vertex[k]) < 0) return "neighbours do not share a facet";
    }
    if (infinite != 0) return nullptr;
    PredicateCounts counts = {};
    const double* p[dimension_max + 1];
    points_of(store, c, p);
    if (orientation(dim, p, counts) != Sign::positive) return "a cell is not positively oriented";
    for (const FacetId facet : cell.neighbour) {
        const VertexId q = store.cell(facet.cell()).vertex[facet.position()];
        if (q != none && in_ball_of(dim, p, store.point(q), counts) == Sign::positive)
            return "a vertex lies inside the ball of a cell";
    }
    return nullptr;
}

}  // namespace

const char* violation_in_use(const AnyStore& store) {
    if (store.state.cell_slots > validated_cells_max) return nullptr;
    std::uint32_t free = 0;
    for (CellId c(0); c < store.state.cell_slots; ++c) {
        const bool live = store.is_live(c);
        free += !live;
        const char* const violation = live ? violation_at(store, c) : nullptr;
        if (violation != nullptr) return violation;
    }
    return free == store.state.cells_free ? nullptr : "the count of free cells is wrong";
}

#endif

}  // namespace netmesh
