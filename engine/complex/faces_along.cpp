// Faces of a triangulation, made vertex by vertex along a given order, each from those made before.
//
// When a vertex comes, every cell around it knows the greatest of its faces whose vertices have all come before. The
// faces that the vertex adds to the cell are the cones from it over the faces of that one: the facets of a cone are the
// cones over the facets and the face itself. What is known of a face is the last cone over it. Numbers ascend, so one
// comparison tells whether that was made from the vertex at work; nothing is searched for, hashed or sorted, and what
// is looked up was made by vertices that are near in the order.
#include "complex/faces_along.hpp"

#include "memory/arena.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class FacesAlong {
    static_assert(D >= 2 && D <= 4, "the numbers of faces are known beforehand from edges and facets alone");

public:
    FacesAlong(const TriangulationView<D>& complex, Arena& arena) : complex_(complex), arena_(arena) {}

    // Takes all that is needed of the cells; they are not read again. order[vertex_count]: all vertices; those that are
    // in cells stay, and are the 0-faces. hull_facets: how many facets have one cell. Sets count[0..D]. Scratch stays
    // at the high end. out_of_memory; internal: it is not the triangulation of a ball.
    Status read_cells(std::uint32_t* order, const FaceCounting& counting, std::uint32_t* count);
    // Makes the faces into facets[k][count[k]], taken by the caller. internal: it is not the triangulation of a ball.
    Status run(const std::uint32_t* count, std::uint32_t* const* facets, Monitor& monitor);

private:
    void number_vertices(std::uint32_t* order, std::uint32_t* place);
    std::uint64_t count_edges(const std::uint32_t* order, std::uint32_t whole_stars, std::uint32_t* seen_from) const;
    Status count_faces(const std::uint32_t* order, const FaceCounting& counting, std::uint32_t* count) const;
    template <int K> std::uint32_t cone(std::uint32_t face);
    void visit(FacetId incidence);

    const TriangulationView<D> complex_;
    Arena& arena_;
    std::uint32_t* begin_ = nullptr;    // [0-faces + 1] into incidence_
    FacetId* incidence_ = nullptr;      // a cell, and how many of its vertices come before this one
    std::uint32_t* of_cell_ = nullptr;  // [cells] the greatest face of those vertices
    std::uint32_t* last_cone_[D] = {};  // [k-faces] one more than the number of the last cone over it; 0: none
    std::uint32_t* facets_[D + 1] = {};
    std::uint32_t vertex_ = 0, vertices_ = 0;  // at work; how many there are
    std::uint32_t most_[D + 1] = {}, made_[D + 1] = {};
    std::uint32_t first_[D + 1] = {};  // made before the vertex at work came
    bool fits_ = true;
};

// Vertices that are in no cell go; place: the number of each other one. begin_ is that of the vertex before.
template <int D> void FacesAlong<D>::number_vertices(std::uint32_t* order, std::uint32_t* place) {
    std::uint32_t* const degree = place;
    arena_.each(complex_.vertex_count, 1, [degree](std::uint64_t v) { degree[v] = 0; });
    arena_.each(complex_.cell_count, 5 * (D + 1), [&](std::uint64_t c) {
        const VertexId* const vertex = complex_.vertices(CellId(static_cast<std::uint32_t>(c)));
        for (int i = 0; i <= D; ++i) ++degree[vertex[i]];
    });
    std::uint32_t sum = 0;
    begin_[0] = 0;
    arena_.each(complex_.vertex_count, 12, [&](std::uint64_t i) {
        const std::uint32_t v = order[i];
        if (degree[v] == 0) return;
        order[vertices_] = v;
        begin_[++vertices_] = sum;
        sum += degree[v];
        place[v] = vertices_ - 1;
    });
}

// In space the cells at a vertex that has all of them are seen from it as the triangles of a sphere, so there are twice
// as many as edges but two.
template <int D>
std::uint64_t FacesAlong<D>::count_edges(const std::uint32_t* order, std::uint32_t whole_stars,
                                         std::uint32_t* seen_from) const {
    std::uint64_t ends = 0;
    arena_.each(complex_.vertex_count, 1, [seen_from](std::uint64_t v) { seen_from[v] = none; });
    arena_.each(vertices_, 100 * D * D, [&](std::uint64_t i) {
        constexpr std::uint32_t ahead = 16;
        if (D == 3 && order[i] < whole_stars) {
            ends += (begin_[i + 1] - begin_[i]) / 2 + 2;
            return;
        }
        seen_from[order[i]] = static_cast<std::uint32_t>(i);
        for (std::uint32_t t = begin_[i]; t < begin_[i + 1]; ++t) {
            const std::uint32_t later = t + ahead < begin_[vertices_] ? t + ahead : t;
            prefetch(complex_.vertices(incidence_[later].cell()));
            const VertexId* const vertex = complex_.vertices(incidence_[t].cell());
            for (int j = 0; j <= D; ++j) {
                ends += seen_from[vertex[j]] != i;
                seen_from[vertex[j]] = static_cast<std::uint32_t>(i);
            }
        }
    });
    return ends / 2;
}

// A facet belongs to two cells or is on the hull; a ball has Euler characteristic 1. That leaves the edges in R^4.
// last_cone_[0] is scratch.
template <int D>
Status FacesAlong<D>::count_faces(const std::uint32_t* order, const FaceCounting& counting,
                                  std::uint32_t* count) const {
    const std::uint64_t vertices = vertices_, cells = complex_.cell_count,
                        facets = ((D + 1) * cells + counting.hull_facets) / 2;
    std::uint64_t of[D + 1] = {vertices};
    of[D] = cells;
    of[D - 1] = facets;
    if (D == 2 && counting.is_ball && facets + 1 != vertices + cells) return Status::internal;
    if constexpr (D == 3)
        of[1] =
            counting.is_ball ? vertices + facets - cells - 1 : count_edges(order, counting.whole_stars, last_cone_[0]);
    if constexpr (D == 4) {
        of[1] = count_edges(order, counting.whole_stars, last_cone_[0]);
        of[2] = 1 + of[1] + facets - vertices - cells;
    }
    for (int k = 0; k <= D; ++k) {
        if (of[k] - 1 >= UINT64_MAX / 2) return Status::internal;  // none, or fewer
        if (of[k] >= none) return Status::out_of_memory;
        count[k] = static_cast<std::uint32_t>(of[k]);
    }
    return Status::ok;
}

template <int D>
Status FacesAlong<D>::read_cells(std::uint32_t* order, const FaceCounting& counting, std::uint32_t* count) {
    const std::size_t n = complex_.vertex_count, cells = complex_.cell_count;
    begin_ = arena_.take_high<std::uint32_t>(n + 1);
    incidence_ = arena_.take_high<FacetId>(cells * (D + 1));
    of_cell_ = arena_.take_high<std::uint32_t>(cells);
    last_cone_[0] = arena_.take_high<std::uint32_t>(n);
    if (begin_ == nullptr || incidence_ == nullptr || of_cell_ == nullptr || last_cone_[0] == nullptr ||
        cells * (D + 1) >= none)
        return Status::out_of_memory;
    std::uint32_t* const place = last_cone_[0];  // until faces are made
    number_vertices(order, place);
    arena_.each(cells, 20 * (D + 1), [&](std::uint64_t c) {
        const CellId cell(static_cast<std::uint32_t>(c));
        std::uint32_t at[D + 1];
        for (int i = 0; i <= D; ++i) at[i] = place[complex_.vertices(cell)[i]];
        for (int i = 0; i <= D; ++i) {
            std::uint32_t before = 0;
            for (int j = 0; j <= D; ++j) before += at[j] < at[i] ? 1 : 0;
            incidence_[begin_[at[i] + 1]++] = FacetId(cell, before);
        }
    });
    const Status status = count_faces(order, counting, count);
    for (int k = 1; k + 1 < D && status == Status::ok; ++k) {
        last_cone_[k] = arena_.take_high<std::uint32_t>(count[k]);
        if (last_cone_[k] == nullptr) return Status::out_of_memory;
    }
    return status;
}

// The K-face of a (K-1)-face and the vertex at work.
template <int D> template <int K> inline std::uint32_t FacesAlong<D>::cone(std::uint32_t face) {
    if constexpr (K == 0) {
        return vertex_;
    } else {
        if constexpr (K < D) {
            const std::uint32_t known = last_cone_[K - 1][face];
            if (known > first_[K]) return known - 1;
        }
        if (made_[K] == most_[K]) {
            fits_ = false;
            return 0;
        }
        const std::uint32_t made = made_[K]++;
        if constexpr (K < D) last_cone_[K - 1][face] = made + 1;
        std::uint32_t* const facet = facets_[K] + std::size_t{made} * (K + 1);
        facet[0] = vertex_;
        if constexpr (K > 1) {
            const std::uint32_t* const below = facets_[K - 1] + std::size_t{face} * K;
            for (int i = 0; i < K; ++i) facet[i] = cone<K - 1>(below[i]);
        }
        facet[K] = face;
        return made;
    }
}

template <int D> inline void FacesAlong<D>::visit(FacetId incidence) {
    std::uint32_t& face = of_cell_[incidence.cell()];
    switch (incidence.position()) {
    case 0: face = vertex_; break;
    case 1: face = cone<1>(face); break;
    case 2: face = cone<2>(face); break;
    case 3:
        if constexpr (D > 2) face = cone<3>(face);
        break;
    default:
        if constexpr (D > 3) cone<4>(face);
    }
}

template <int D> Status FacesAlong<D>::run(const std::uint32_t* count, std::uint32_t* const* facets, Monitor& monitor) {
    for (int k = 1; k <= D; ++k) {
        facets_[k] = facets[k];
        most_[k] = count[k];
        if (k == D) continue;
        std::uint32_t* const last_cone = last_cone_[k - 1];
        arena_.each(count[k - 1], 1, [last_cone](std::uint64_t f) { last_cone[f] = 0; });
    }
    for (; vertex_ < vertices_ && fits_; ++vertex_) {
        for (int k = 1; k <= D; ++k) first_[k] = made_[k];
        for (std::uint32_t t = begin_[vertex_]; t < begin_[vertex_ + 1]; ++t) visit(incidence_[t]);
        if (monitor.advance(vertex_, 1 + (begin_[vertex_ + 1] - begin_[vertex_]) / 2)) return Status::cancelled;
    }
    for (int k = 1; k <= D; ++k) fits_ = fits_ && made_[k] == most_[k];
    return fits_ ? Status::ok : Status::internal;
}

}  // namespace

template <int D>
Status enumerate_along(const TriangulationView<D>& complex, const FaceCounting& counting, std::uint32_t* order,
                       const Work& work, std::size_t low, Faces<D>* out) {
    if constexpr (lists_follow_order<D>) {
        Arena& arena = work.arena;
        const std::size_t high = arena.high_mark();
        Faces<D> faces = {};
        faces.dimension_max = D;
        FacesAlong<D> along(complex, arena);
        Status status = along.read_cells(order, counting, faces.count);
        if (status != Status::ok) return status;
        arena.release_low(low);
        for (int k = 1; k <= D; ++k) {
            faces.facets[k] =
                arena.take_low<std::uint32_t>(std::size_t{faces.count[k]} * static_cast<std::size_t>(k + 1));
            if (faces.facets[k] == nullptr) return Status::out_of_memory;
        }
        status = along.run(faces.count, faces.facets, work.monitor);
        if (status != Status::ok) return status;
        arena.release_high(high);
        faces.last_vertex[0] = order;
        *out = faces;
        return Status::ok;
    } else {
        return Status::internal;
    }
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status enumerate_along<D>(const TriangulationView<D>&, const FaceCounting&, std::uint32_t*, const Work&,  \
                                       std::size_t, Faces<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
