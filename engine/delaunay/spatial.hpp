// Space's own way of filling a cavity: the new cells stand on the triangles of a sphere, so what borders what is read
// off the sphere's edges. A part of kernel.cpp; templates, so that nothing of it is made where space is not served.
#pragma once
#include "delaunay/kernel.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__

// A triangulated sphere of n vertices has 2 n - 4 triangles.
constexpr std::uint32_t boundary_vertices_max = 32;
constexpr std::uint32_t boundary_facets_max = 2 * boundary_vertices_max - 4;

// An edge from the new point to a vertex of the boundary, used by some six new cells.
struct SpatialEdge {
    double x[3], half_square;
};

// The vertices of a cavity's boundary with numbers of their own, in the order in which they are met. A hash table with
// four slots for each, as a vertex is looked for three times as often as there are facets.
class BoundaryVertices {
public:
    BoundaryVertices() {
        for (std::uint32_t& v : vertex_) v = vacant;
    }
    // The number of vertex v; calls meet(number) when it is a new one.
    template <class Meet> std::uint32_t number_of(std::uint32_t v, Meet&& meet) {
        std::uint32_t slot = v * 0x9E3779B1u >> (32 - slot_bits);
        while (vertex_[slot] != v) {
            if (vertex_[slot] == vacant) {
                vertex_[slot] = v;
                number_[slot] = static_cast<std::uint8_t>(count_);
                meet(count_);
                ++count_;
                break;
            }
            slot = (slot + 1) & (slots - 1);
        }
        return number_[slot];
    }

private:
    static constexpr int slot_bits = 7;
    static constexpr std::uint32_t slots = 1u << slot_bits, vacant = Store<3>::freed;
    static_assert(slots >= 4 * boundary_vertices_max);
    std::uint32_t vertex_[slots];
    std::uint32_t count_ = 0;
    std::uint8_t number_[slots];
};

// What solve_sphere does, for q and the ends of three edges from it that neither underflow nor overflow. False when it
// has to be asked.
inline bool circumscribe(const double* q, const SpatialEdge& a, const SpatialEdge& b, const SpatialEdge& c,
                         double error_max, Cell<3>& cell) {
    constexpr double shape = shape_factor<3>();
    double bc[3], ca[3], ab[3];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        bc[i] = b.x[j] * c.x[k] - b.x[k] * c.x[j];
        ca[i] = c.x[j] * a.x[k] - c.x[k] * a.x[j];
        ab[i] = a.x[j] * b.x[k] - a.x[k] * b.x[j];
    }
    const double inverse = 1 / (a.x[0] * bc[0] + a.x[1] * bc[1] + a.x[2] * bc[2]);
    double centre[3], radius2 = 0, size2 = 0;
    for (int i = 0; i < 3; ++i) {
        centre[i] = q[i] + (a.half_square * bc[i] + b.half_square * ca[i] + c.half_square * ab[i]) * inverse;
        const double d = q[i] - centre[i];
        radius2 += d * d;
        size2 += centre[i] * centre[i];
    }
    const double lengths2 = 8 * a.half_square * b.half_square * c.half_square;
    const double error2 =
        2.1 * (shape * shape * lengths2 * (inverse * inverse) + 8 * unit_roundoff * unit_roundoff * (size2 / radius2));
    if (!(error2 < error_max * error_max)) return false;
    for (int i = 0; i < 3; ++i) cell.centre[i] = centre[i];
    cell.radius2 = radius2;
    cell.error = static_cast<float>(1.01 * square_root(error2));
    return true;
}

// Seen from the new point all triangles of the sphere turn the same way, so each edge is met once in either direction:
// what stands behind it is written down under one of them and read under the other. As the edges to the new point are
// at hand, balls are solved from points, which costs no more than from other balls and leaves smaller errors.
template <int D> void SpatialCavity<D>::make_cells(Kernel<D>& kernel, const Cavity& cavity, VertexId id,
                                                   CellSupply<D>& supply) {
    // turn[i]: the positions other than i, so that i and they are an even permutation.
    constexpr std::uint8_t turn[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
    Store<D>& store = kernel.store_;
    Cell<D>* const cells = &store.cell(0);
    CavityLine* const end = kernel.list_end();
    const double* const q = store.point(id);
    const std::uint32_t facets = cavity.facets;
    BoundaryVertices vertices;
    SpatialEdge edge[boundary_vertices_max];
    std::uint8_t number[boundary_facets_max][3];
    std::uint8_t behind[boundary_vertices_max * boundary_vertices_max];  // 4 * new cell + position of its facet
    bool plain = kernel.balls_ == Balls::from_points;
    for (std::uint32_t k = 0; k < facets; ++k) {
        CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const CellId n = line.made = supply.take();
        const std::uint32_t i = line.facet.position();
        const Cell<D>& old = cells[line.facet.cell()];
        Cell<D>& fresh = cells[n];
        const FacetId outer = old.neighbour[i];
        for (std::uint32_t j = 0; j <= D; ++j) fresh.vertex[j] = old.vertex[j];
        fresh.vertex[i] = id;
        fresh.neighbour[i] = outer;
        fresh.mark = 0;
        cells[outer.cell()].neighbour[outer.position()] = FacetId(n, i);
        for (int r = 0; r < 3; ++r) {
            const VertexId v = old.vertex[turn[i][r]];
            number[k][r] = static_cast<std::uint8_t>(vertices.number_of(v, [&](std::uint32_t at) {
                if (v == none) return;
                const double* const p = store.point(v);
                double square = 0;
                for (int j = 0; j < D; ++j) {
                    edge[at].x[j] = p[j] - q[j];
                    square += edge[at].x[j] * edge[at].x[j];
                }
                edge[at].half_square = 0.5 * square;
                plain = plain && edge[at].half_square > edge_square_min && edge[at].half_square < edge_square_max;
            }));
        }
        for (std::uint32_t r = 0; r < 3; ++r)
            behind[number[k][(r + 1) % 3] * boundary_vertices_max + number[k][(r + 2) % 3]] =
                static_cast<std::uint8_t>(k << 2 | turn[i][r]);
    }
    for (std::uint32_t k = 0; k < facets; ++k) {
        const CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const std::uint32_t i = line.facet.position();
        Cell<D>& fresh = cells[line.made];
        for (std::uint32_t r = 0; r < 3; ++r) {
            const std::uint32_t other = behind[number[k][(r + 2) % 3] * boundary_vertices_max + number[k][(r + 1) % 3]];
            fresh.neighbour[turn[i][r]] = FacetId(end[-static_cast<std::ptrdiff_t>(other >> 2)].made, other & 3u);
        }
        bool infinite = false;
        for (std::uint32_t r = 0; r < 3; ++r) infinite |= fresh.vertex[turn[i][r]] == none;
        if (infinite)
            make_ghost<D>(fresh);
        else if (!plain || !circumscribe(q, edge[number[k][0]], edge[number[k][1]], edge[number[k][2]],
                                         kernel.error_max_, fresh))
            GeneralCavity<D>::make_sphere(kernel, cells[line.facet.cell()], cells[fresh.neighbour[i].cell()], q, fresh);
    }
}

#endif

}  // namespace netmesh
