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

// The vertices of a cavity's boundary with numbers from 1 on, in the order in which they are met. A hash table of many
// more slots than vertices, as whether a vertex is there already cannot be predicted and must not be asked.
class BoundaryVertices {
public:
    std::uint32_t number_of(VertexId v) {
        vertex_[next_] = v;
        std::uint32_t slot = v * 0x9E3779B1u >> (32 - slot_bits), number = number_in(slot);
        while (vertex_[number] != v) number = number_in(slot = (slot + 1) & (slots - 1));
        number_[slot] = static_cast<std::uint8_t>(number);
        next_ += number == next_;
        return number;
    }
    bool has_infinity() const {
        bool has = false;
        for (std::uint32_t number = 1; number < next_; ++number) has |= vertex_[number] == none;
        return has;
    }

private:
    // Of a vacant slot the number that comes next.
    std::uint32_t number_in(std::uint32_t slot) const {
        const std::uint32_t number = number_[slot];
        return number | (next_ & (0u - static_cast<std::uint32_t>(number == 0)));
    }
    static constexpr int slot_bits = 8;
    static constexpr std::uint32_t slots = 1u << slot_bits;
    std::uint32_t next_ = 1;
    std::uint8_t number_[slots] = {};  // 0: vacant
    VertexId vertex_[boundary_vertices_max + 2];
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
    struct {
        std::uint16_t edge[3];
        std::uint16_t position;
    } triangle[boundary_facets_max];
    constexpr std::uint32_t most = boundary_vertices_max + 1;
    FacetId behind[most * most];
    for (std::uint32_t k = 0; k < facets; ++k) {
        CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const CellId n = line.made = supply.take();
        const std::uint32_t i = line.facet.position();
        const Cell<D>& old = cells[line.facet.cell()];
        Cell<D>& fresh = cells[n];
        const FacetId outer = old.neighbour[i];
        const std::uint32_t number[3] = {vertices.number_of(old.vertex[turn[i][0]]),
                                         vertices.number_of(old.vertex[turn[i][1]]),
                                         vertices.number_of(old.vertex[turn[i][2]])};
        __builtin_memcpy(fresh.vertex, old.vertex, sizeof fresh.vertex);
        fresh.vertex[i] = id;
        fresh.neighbour[i] = outer;
        fresh.mark = 0;
        cells[outer.cell()].neighbour[outer.position()] = FacetId(n, i);
        triangle[k].position = static_cast<std::uint16_t>(i);
        for (std::uint32_t r = 0; r < 3; ++r) {
            const std::uint32_t from = number[(r + 1) % 3], to = number[(r + 2) % 3];
            triangle[k].edge[r] = static_cast<std::uint16_t>(to * most + from);
            behind[from * most + to] = FacetId(n, turn[i][r]);
        }
    }
    const bool at_hull = vertices.has_infinity();
    for (std::uint32_t k = 0; k < facets; ++k) {
        const CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const std::uint32_t i = triangle[k].position;
        Cell<D>& fresh = cells[line.made];
        const Cell<D>& inside = cells[line.facet.cell()];
        const Cell<D>& outside = cells[fresh.neighbour[i].cell()];
        for (std::uint32_t r = 0; r < 3; ++r) fresh.neighbour[turn[i][r]] = behind[triangle[k].edge[r]];
        if (at_hull && store.is_ghost(line.made))
            make_ghost<D>(fresh);
        else if (!pencil_sphere<D>(inside, outside, q, kernel.error_max_, fresh))
            GeneralCavity<D>::solve(kernel, fresh);
    }
}

#endif

}  // namespace netmesh
