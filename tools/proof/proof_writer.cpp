#include "tools/proof/proof_writer.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "tools/opinion/exact_spheres.hpp"
#include "tools/proof/proof_bytes.hpp"

namespace netmesh::tool {

namespace {

constexpr char magic[] = "netmesh proof 1\n", magic_of_balls[] = "netmesh proof 2\n";
constexpr std::uint32_t kind_alpha = 1, kind_alpha_of_balls = 2;

// Where a point is along a Hilbert curve through the box around all, by J. Skilling, Programming the Hilbert curve
// (2004). Only the length of the proof depends on it.
class Curve {
public:
    // The boxes at the curve's finest level are some hundred times as many as the points.
    Curve(std::uint32_t dim, const std::vector<double>& coordinates) : dim_(dim), bits_(8 / dim + 1) {
        while (bits_ < 63 / dim && coordinates.size() >> (bits_ * dim - 8) != 0) bits_++;
        std::fill(low_, low_ + dim, std::numeric_limits<double>::infinity());
        std::fill(high_, high_ + dim, -std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < coordinates.size(); i++) {
            low_[i % dim] = std::min(low_[i % dim], coordinates[i]);
            high_[i % dim] = std::max(high_[i % dim], coordinates[i]);
        }
    }
    std::uint64_t place(const double* x) const {
        const std::uint64_t cells = std::uint64_t{1} << bits_;
        std::uint64_t at[NETMESH_DIM_MAX];
        for (std::uint32_t c = 0; c < dim_; c++) {
            const double extent = high_[c] / 2 - low_[c] / 2;  // which does not overflow
            const double share = extent > 0 ? (x[c] / 2 - low_[c] / 2) / extent : 0;
            at[c] = std::min(cells - 1, static_cast<std::uint64_t>(share * static_cast<double>(cells)));
        }
        for (std::uint64_t bit = cells / 2; bit > 1; bit /= 2)
            for (std::uint32_t c = 0; c < dim_; c++) {
                const std::uint64_t swapped = (at[c] & bit) != 0 ? 0 : (at[0] ^ at[c]) & (bit - 1);
                at[0] ^= (at[c] & bit) != 0 ? bit - 1 : swapped;
                at[c] ^= swapped;
            }
        for (std::uint32_t c = 1; c < dim_; c++) at[c] ^= at[c - 1];
        std::uint64_t turned = 0;
        for (std::uint64_t bit = cells / 2; bit > 1; bit /= 2)
            if ((at[dim_ - 1] & bit) != 0) turned ^= bit - 1;
        std::uint64_t key = 0;
        for (std::uint32_t b = bits_; b-- > 0;)
            for (std::uint32_t c = 0; c < dim_; c++) key = 2 * key + ((at[c] ^ turned) >> b & 1);
        return key;
    }

private:
    std::uint32_t dim_, bits_;
    double low_[NETMESH_DIM_MAX] = {}, high_[NETMESH_DIM_MAX] = {};
};

// The row of each vertex: of equal rows the first one is the vertex, and vertices are in the order of their rows.
std::vector<std::uint32_t> rows_of(const MeshSource& triangulation, const PointCloud& cloud) {
    std::vector<std::uint32_t> rows;
    rows.reserve(triangulation.vertex_count);
    for (std::size_t row = 0; row < cloud.rows() && rows.size() < triangulation.vertex_count; row++) {
        const netmesh_vertex next = triangulation.vertex(rows.size());
        if (std::equal(next.coordinates, next.coordinates + cloud.dim, &cloud.coordinates[row * cloud.dim]))
            rows.push_back(static_cast<std::uint32_t>(row));
    }
    return rows;
}

// The same with weights: of equal rows the first of the heaviest is the vertex, or hidden.
std::vector<std::uint32_t> rows_of_balls(const PointCloud& cloud, const std::vector<std::uint64_t>& hidden) {
    std::vector<std::uint32_t> order(cloud.rows()), rows;
    std::iota(order.begin(), order.end(), 0);
    const auto compare = [&](std::uint32_t a, std::uint32_t b) {
        const double *const x = &cloud.coordinates[std::size_t{a} * cloud.dim],
                            *const y = &cloud.coordinates[std::size_t{b} * cloud.dim];
        const auto [at, other] = std::mismatch(x, x + cloud.dim, y);
        return at == x + cloud.dim ? 0 : *at < *other ? -1 : 1;
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const int c = compare(a, b);
        if (c != 0 || a == b) return c < 0;
        return cloud.weights[a] != cloud.weights[b] ? cloud.weights[a] > cloud.weights[b] : a < b;
    });
    for (std::size_t i = 0; i < order.size(); i++)
        if ((i == 0 || compare(order[i - 1], order[i]) != 0) &&
            !std::binary_search(hidden.begin(), hidden.end(), order[i]))
            rows.push_back(order[i]);
    std::sort(rows.begin(), rows.end());
    return rows;
}

std::uint64_t points_fingerprint(const PointCloud& cloud, bool are_radii) {
    Fingerprint f;
    f.add(cloud.dim);
    for (const double x : cloud.coordinates) f.add(bits_of(x));
    if (cloud.weights.empty()) return f.value();
    Fingerprint with_weights;
    with_weights.add(f.value());
    with_weights.add(are_radii ? 1 : 0);
    for (const double w : cloud.weights) with_weights.add(bits_of(w));
    return with_weights.value();
}

// Cells that contain places, each found by a walk from the one before: on to the cell behind a facet that the place is
// strictly beyond. Such walks end, as the cells' powers of the place fall along them.
class CellWalker {
public:
    CellWalker(const MeshSource& triangulation, const PointCloud& cloud, const std::vector<std::uint32_t>& rows)
        : triangulation_(triangulation), cloud_(cloud), rows_(rows) {}
    std::uint64_t cell_of(std::uint64_t row) {
        const ExactPlace place = exact(row);
        std::uint32_t beyond = 0;
        while ((beyond = facet_before(place)) <= cloud_.dim) at_ = triangulation_.cell(at_).neighbours[beyond];
        return at_;
    }

private:
    ExactPlace exact(std::uint64_t row) const {
        const double* const x = &cloud_.coordinates[row * cloud_.dim];
        ExactPlace place;
        for (std::uint32_t c = 0; c < cloud_.dim; c++) place.push_back(Exact(x[c]));
        return place;
    }
    // A facet of the cell that the place is beyond; D + 1: none.
    std::uint32_t facet_before(const ExactPlace& place) const {
        const netmesh_cell cell = triangulation_.cell(at_);
        std::vector<ExactPlace> corners;
        for (std::uint32_t j = 0; j <= cloud_.dim; j++) corners.push_back(exact(rows_[cell.vertices[j]]));
        for (std::uint32_t j = 0; j <= cloud_.dim; j++) {
            std::vector<const ExactPlace*> with_place;
            for (std::uint32_t i = 0; i <= cloud_.dim; i++) with_place.push_back(i == j ? &place : &corners[i]);
            if (orientation(with_place) < 0) return j;
        }
        return cloud_.dim + 1;
    }

    const MeshSource& triangulation_;
    const PointCloud& cloud_;
    const std::vector<std::uint32_t>& rows_;
    std::uint64_t at_ = 0;
};

// The vertices of cells, D + 1 each, as they come.
std::vector<std::uint32_t> cells_of(const MeshSource& triangulation) {
    const std::uint32_t size = triangulation.dim + 1;
    std::vector<std::uint32_t> cells(triangulation.cell_count * size);
    for (std::uint64_t i = 0; i < triangulation.cell_count; i++) {
        const netmesh_cell cell = triangulation.cell(i);
        std::copy(cell.vertices, cell.vertices + size, &cells[i * size]);
    }
    return cells;
}

// cells: of vertices, which become places.
// cell_numbers, if there are some, become the numbers that the cells have in the file.
template <std::uint32_t D>
void write_cells(std::vector<std::uint32_t>* cells, const std::vector<std::uint32_t>& place,
                 std::vector<std::uint64_t>* cell_numbers, ProofBytes& out) {
    // The others of those whose first place is p begin at begin[p], and end there as soon as all stand there.
    std::vector<std::uint32_t> end(place.size() + 2, 0);
    for (std::size_t i = 0; i < cells->size(); i += D + 1) {
        std::uint32_t* const p = &(*cells)[i];
        for (std::uint32_t j = 0; j <= D; j++) p[j] = place[p[j]];
        std::sort(p, p + D + 1);
        end[p[0] + 2]++;
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::array<std::uint32_t, D>> others(cells->size() / (D + 1));
    for (std::size_t i = 0; i < cells->size(); i += D + 1) {
        const std::uint32_t* const p = &(*cells)[i];
        std::copy(p + 1, p + D + 1, others[end[p[0] + 1]++].begin());
    }
    std::vector<std::array<std::uint32_t, D + 1>> asked;
    for (const std::uint64_t number : *cell_numbers) {
        asked.emplace_back();
        std::copy_n(&(*cells)[number * (D + 1)], D + 1, asked.back().begin());
    }
    std::uint32_t before = 0;
    for (std::uint32_t first = 0; first < place.size(); first++) {
        std::sort(others.begin() + end[first], others.begin() + end[first + 1]);
        for (std::uint32_t i = end[first]; i < end[first + 1]; i++) {
            out.number(first - before);
            before = first;
            for (std::uint32_t j = 0, last = first; j < D; last = others[i][j++]) out.number(others[i][j] - last - 1);
        }
    }
    for (std::size_t i = 0; i < asked.size(); i++) {
        std::array<std::uint32_t, D> rest;
        std::copy(asked[i].begin() + 1, asked[i].end(), rest.begin());
        const auto begin = others.begin() + end[asked[i][0]], last = others.begin() + end[asked[i][0] + 1];
        (*cell_numbers)[i] = static_cast<std::uint64_t>(std::lower_bound(begin, last, rest) - others.begin());
    }
}

}  // namespace

void write_proof(const MeshSource& triangulation, const PointCloud& cloud, const std::vector<std::uint64_t>& hidden,
                 const BarSource& bars, bool are_radii, TextWriter& to) {
    const bool of_balls = !cloud.weights.empty();
    const std::vector<std::uint32_t> rows = of_balls ? rows_of_balls(cloud, hidden) : rows_of(triangulation, cloud);
    ProofBytes out;
    out.text(of_balls ? magic_of_balls : magic);
    out.number(of_balls ? kind_alpha_of_balls : kind_alpha, 4);
    out.number(cloud.dim, 4);
    out.number(rows.size(), 8);
    out.number(triangulation.cell_count, 8);
    out.number(points_fingerprint(cloud, are_radii), 8);
    out.number(bars_fingerprint(bars), 8);
    if (of_balls) out.number(hidden.size(), 8);

    const Curve curve(cloud.dim, cloud.coordinates);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> list;  // places on the curve, vertices
    list.reserve(rows.size());
    for (std::uint32_t v = 0; v < rows.size(); v++)
        list.push_back({curve.place(&cloud.coordinates[std::size_t{rows[v]} * cloud.dim]), v});
    std::sort(list.begin(), list.end());
    std::vector<std::uint32_t> cells = cells_of(triangulation), place(rows.size());
    std::uint32_t row_bytes = 1;
    while (row_bytes < 4 && (cloud.rows() - 1) >> 8 * row_bytes != 0) row_bytes++;
    for (std::uint32_t i = 0; i < list.size(); i++) {
        place[list[i].second] = i;
        out.number(rows[list[i].second], row_bytes);
    }
    list.clear();
    for (const std::uint64_t row : hidden)
        list.push_back({curve.place(&cloud.coordinates[row * cloud.dim]), static_cast<std::uint32_t>(row)});
    std::sort(list.begin(), list.end());
    std::vector<std::uint64_t> cell_numbers;
    CellWalker walker(triangulation, cloud, rows);
    for (const auto& [at, row] : list) {
        out.number(row, row_bytes);
        cell_numbers.push_back(walker.cell_of(row));
    }
    list = {};
    switch (cloud.dim) {
    case 2: write_cells<2>(&cells, place, &cell_numbers, out); break;
    case 3: write_cells<3>(&cells, place, &cell_numbers, out); break;
    case 4: write_cells<4>(&cells, place, &cell_numbers, out); break;
    case 5: write_cells<5>(&cells, place, &cell_numbers, out); break;
    default: write_cells<6>(&cells, place, &cell_numbers, out); break;
    }
    for (const std::uint64_t number : cell_numbers) out.number(number);
    out.number(out.fingerprint(), 8);
    to << out.all();
}

}  // namespace netmesh::tool
