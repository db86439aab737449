// Point location and insertion in a Delaunay triangulation with ghost cells.
#pragma once
#include <cstdint>
#include <type_traits>

#include "delaunay/cell_list.hpp"
#include "delaunay/sphere.hpp"
#include "delaunay/store.hpp"

namespace netmesh {

// What an insertion would replace: the cells in conflict with the new point and the facets that bound them. Their list
// stands in the store's gap until the next search, and in space what spatial.hpp keeps below it.
struct Cavity {
    std::uint32_t cells;
    std::uint32_t facets;
    std::uint32_t stamp;  // D > 2: mark of the cells in conflict; their neighbours outside carry stamp + 1
    bool has_tables;      // in space: the search has left what spatial.hpp fills it by
};

// How far a search has come: so many cells in conflict and bounding facets are listed, and the first `searched` of
// these cells have been left by all of their facets.
struct CavitySearch {
    std::uint32_t stamp;
    std::ptrdiff_t cells, facets, searched;
};

// Line k of the list, line 0 highest in memory: columns of different lengths.
struct CavityLine {
    FacetId entry;  // a cell in conflict and, but of the first, the facet by which the search came to it
    FacetId facet;  // a bounding facet, of the cell in conflict
    CellId made;    // the cell that fill puts behind this facet
};
// In the plane the facets come counterclockwise and are seen from outside.
struct PlanarLine {
    CellId made;      // a cell in conflict; after fill the new cell behind the facet
    FacetId beyond;   // the facet, of the cell outside
    VertexId start;   // the vertex at which the facet starts
    FacetId waiting;  // stack of facets still to be crossed
};

// Whether insertions keep Vertex::cell up to date, which visit_star and visit_neighbours need.
enum class VertexCells : bool { ignored, kept };

// What breaks ties: the numbers of vertices, or the rows that they come from (Vertex::origin), where vertices come in
// another order than rows do.
enum class TieOrder : bool { of_vertices, of_rows };

// The cells that the search meets when it comes to this cell's turn: by then they are in the cache.
template <int D> inline void ask_for_neighbours(const Cell<D>* cells, const Cell<D>& cell) {
    for (int i = 0; i <= D; ++i) {
        const Cell<D>& other = cells[cell.neighbour[i].cell()];
        __builtin_prefetch(&other.centre);
        __builtin_prefetch(&other.mark);
    }
}

// What the kernel does in the plane, see planar.hpp. For D = 2.
template <int D, class W> class Kernel;
template <int D> struct PlanarCavity {
    static bool find(Kernel<D, NoWeights>& kernel, const double* q, VertexId id, CellId first, Cavity* cavity);
    static void fill(Kernel<D, NoWeights>& kernel, const Cavity& cavity, VertexId id);
};
// What it does in space, see spatial.hpp. The search ends early where tables of it have no room; make_cells then does
// nothing and returns false. For D = 3.
template <int D, class W> struct SpatialCavity {
    static void search(Kernel<D, W>& kernel, const double* q, VertexId id, CavitySearch* progress);
    static bool make_cells(Kernel<D, W>& kernel, const Cavity& cavity, VertexId id, CellSupply<D>& supply);
};

// What the kernel knows of weights, and of the point in question.
template <class W> struct AskedPoint {
    void put(const Weights&) {}
    void look_at(const double*, int) {}
};
template <> struct AskedPoint<Weights> {
    Weights weights;
    double height = 0;
    void put(const Weights& all) { weights = all; }
    void look_at(const double* q, int dim) { height = weights.height(q[dim]); }
};

// With Weights, a number behind the coordinates of each point, it makes the regular triangulation, the Delaunay one of
// powers. A point can be in no cell's ball then: it is hidden. And a cavity can hold all cells of a vertex, which is in
// no cell any more. Both leave no trace; what is hidden once stays hidden, as balls only become emptier.
template <int D, class W = NoWeights> class Kernel : AskedPoint<W> {
    // Cavities of points in the plane are trees of cells, but with weights.
    static constexpr bool is_planar = D == 2 && !W::has;

public:
    // error_max: a new ball whose error bound would exceed this (relative to its radius) is computed afresh. Conflicts
    // are decided exactly whatever it is; corners that results depend on want it small.
    Kernel(Store<D>& store, double error_max, VertexCells vertex_cells, TieOrder tie_order = TieOrder::of_vertices)
        : store_(store), error_max_(error_max), vertex_cells_(vertex_cells), tie_order_(tie_order) {}

    // Of points with weights; before start.
    void weigh(const Weights& weights) { this->put(weights); }

    // Makes the D+1 points with these indices, affinely independent, the first cell with its ghosts. out_of_memory.
    Status start(const VertexId* ids);

    // Does the open ball of cell c contain point q with index id, ties broken by index? A ghost is in conflict with
    // what lies strictly beyond its facet, or in the facet's plane and inside the ball of the cell behind it.
    bool in_conflict(CellId c, const double* q, VertexId id) {
        double bound;
        const double value = power_of(c, q, &bound);
        if (!(__builtin_fabs(value) > bound)) return undecided_conflict(c, q, id);
        ++store_.state.in_ball_counts.calls[0];
        return value < 0;
    }

    // A cell in conflict with q, found by descending powers from cell `from`; the powers of adjacent balls compare as q
    // lies to the sides of their common facet, so a local minimum contains q. Expected 2-7 steps from a near start.
    // With weights: none when q is hidden.
    CellId locate(const double* q, VertexId id, CellId from);
    // Cells that it has gone on from, in all.
    std::uint64_t steps() const { return steps_; }

    // The cells in conflict with q, found from `first`, one of them. False when the gap is too small for the list;
    // nothing but marks has changed.
    bool find_cavity(const double* q, VertexId id, CellId first, Cavity* cavity);
    // Its cells, k < cavity.cells, until it is filled.
    CellId cavity_cell(std::uint32_t k) const {
        if constexpr (is_planar)
            return line(k).made;
        else
            return line(k).entry.cell();
    }
    // Where cell k has the only vertex that no cell before it in the list has; none: where that is not told, as of the
    // first cell and in the plane.
    std::uint32_t cavity_position(std::uint32_t k) const {
        if constexpr (is_planar)
            return none;
        else
            return k == 0 ? std::uint32_t{none} : line(k).entry.position();
    }
    // Is there room to fill this cavity (and for `vertices` new vertices)?
    bool can_fill(const Cavity& cavity, std::uint32_t vertices) {
        const std::size_t lines = cavity.cells > cavity.facets ? cavity.cells : cavity.facets;
        return store_.has_room(cavity.facets, vertices, (lines + 1) * sizeof(Line));
    }

    // Replaces the cavity by the star of vertex id. Needs can_fill. new_cell(k), k < cavity.facets, lists the new cells
    // until the next search.
    void fill(const Cavity& cavity, VertexId id);
    CellId new_cell(std::uint32_t k) const { return line(k).made; }

    // Calls visit(w) once for each neighbour w of the vertex that filled the cavity; needs VertexCells::kept. Filling
    // leaves each of them pointing at one of the new cells: there it is visited.
    template <class Visit> void visit_neighbours(const Cavity& cavity, VertexId v, Visit&& visit) const {
        for (std::uint32_t k = 0; k < cavity.facets; ++k)
            for (const VertexId w : store_.cell(new_cell(k)).vertex)
                if (w != v && w != none && store_.vertex(w).cell == new_cell(k)) visit(w);
    }

    // The cells at vertex v, see visit_star; needs VertexCells::kept.
    template <class Visit> bool visit_star(VertexId v, Visit&& visit) { return netmesh::visit_star(store_, v, visit); }

private:
    friend struct PlanarCavity<D>;
    friend struct SpatialCavity<D, W>;

    // That of the point that was looked at last.
    double power_of(CellId c, const double* q, double* bound) const {
        if constexpr (W::has)
            return power<D>(store_.cell(c), q, this->height, bound);
        else
            return power<D>(store_.cell(c), q, bound);
    }
    // Weights, or NoWeights.
    auto weights_used() const {
        if constexpr (W::has)
            return this->weights;
        else
            return W{};
    }

    CellId walk(const double* q, CellId from);
    bool ghost_in_conflict(CellId c, int infinite, const double* q, VertexId id);
    bool exact_conflict(CellId c, const double* q, VertexId id);
    bool undecided_conflict(CellId c, const double* q, VertexId id);
    bool refuse_list(std::size_t lines) {
        store_.arena.refuse(2 * lines * sizeof(Line));
        return false;
    }

    using Line = std::conditional_t<is_planar, PlanarLine, CavityLine>;
    Line* list_end() const { return reinterpret_cast<Line*>(store_.list_top()) - 1; }
    Line& line(std::uint32_t k) const { return list_end()[-static_cast<std::ptrdiff_t>(k)]; }
    std::size_t list_capacity() const { return store_.list_capacity() * 4 / sizeof(Line); }

    Store<D>& store_;
    double error_max_;
    std::uint64_t steps_ = 0;
    VertexCells vertex_cells_;
    TieOrder tie_order_;
};

// Calls visit(w) for each vertex of the cells in conflict, at least once, until the cavity is filled. From space on a
// cell that the search has come to by a facet has one vertex that the cell on the other side has not. D: the dimension,
// or any_dimension.
template <int D, class Visit>
inline void visit_cavity_vertices(const Kernel<D>& kernel, const Store<D>& store, const Cavity& cavity, Visit&& visit) {
    for (std::uint32_t k = 0; k < cavity.cells; ++k) {
        const std::uint32_t position = kernel.cavity_position(k);
        auto&& vertices = store.cell(kernel.cavity_cell(k)).vertex;
        const bool is_told = position != none;
        const std::uint32_t end = is_told ? position + 1 : static_cast<std::uint32_t>(store.dim) + 1;
        for (std::uint32_t i = is_told ? position : 0; i < end; ++i) visit(vertices[i]);
    }
}

}  // namespace netmesh
