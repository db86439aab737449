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

// Does cell c contain x, boundary included?
bool contains(const AnyStore& store, CellId c, const double* x, PredicateCounts& counts) {
    const int dim = store.dim;
    const double* p[dimension_max + 1];
    points_of(store, c, p);
    for (int i = 0; i <= dim; ++i) {
        const double* const kept = p[i];
        p[i] = x;
        if (orientation(dim, p, counts) == Sign::negative) return false;
        p[i] = kept;
    }
    return true;
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
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 80 * dim); c < piece; ++c) {
            points_of(store, c, p);
            if (orientation(dim, p, counts) != Sign::positive) return {"a cell is not positively oriented", c};
            for (int i = 0; i <= dim; ++i) {
                if (store.cell(c).neighbour[i] != none) continue;
                const double* const kept = p[i];
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
    if (store.state.cell_slots == 0) return {nullptr, none};
    // A point inside cell 0: its barycentre, pulled towards nothing else, is in no other cell.
    double x[dimension_max];
    points_of(store, CellId(0), p);
    for (int k = 0; k < dim; ++k) {
        x[k] = 0;
        for (int i = 0; i <= dim; ++i) x[k] += p[i][k] * (1.0 / (dim + 1));
    }
    if (!contains(store, CellId(0), x, counts)) return {nullptr, none};  // a cell too thin for a double inside
    for (CellId c(1); c < store.state.cell_slots; ++c) {
        store.arena.step(c, 40 * dim);
        if (!contains(store, c, x, counts)) continue;
        // On a common facet is fine, inside of both is not.
        points_of(store, c, p);
        bool inside = true;
        for (int i = 0; i <= dim && inside; ++i) {
            const double* const kept = p[i];
            p[i] = x;
            inside = orientation(dim, p, counts) == Sign::positive;
            p[i] = kept;
        }
        if (inside) return {"two cells overlap", c};
    }
    return {nullptr, none};
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
