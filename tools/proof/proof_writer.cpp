#include "tools/proof/proof_writer.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string_view>

#include "tools/io/fingerprint.hpp"

namespace netmesh::tool {

namespace {

constexpr char magic[] = "netmesh proof 1\n";
constexpr std::uint32_t kind_alpha = 1;

std::uint64_t bits_of(double x) {
    std::uint64_t bits = 0;
    if (x != 0) std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

// The bytes of a proof. They are held until all are there, as their number is the first that their fingerprint is of.
class Bytes {
public:
    void text(std::string_view text) { bytes_ += text; }
    void number(std::uint64_t value, std::uint32_t bytes) {
        for (std::uint32_t i = 0; i < bytes; i++) bytes_ += static_cast<char>(value >> 8 * i);
    }
    // 7 bits a byte, the least first.
    void number(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
        bytes_ += static_cast<char>(value);
    }
    std::uint64_t fingerprint() const {
        Fingerprint f;
        f.add(bytes_.size());
        for (std::size_t i = 0; i < bytes_.size(); i += 8) {
            std::uint64_t word = 0;
            for (std::size_t j = std::min(bytes_.size(), i + 8); j-- > i;)
                word = word << 8 | static_cast<unsigned char>(bytes_[j]);
            f.add(word);
        }
        return f.value();
    }
    const std::string& all() const { return bytes_; }

private:
    std::string bytes_;
};

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

std::uint64_t points_fingerprint(const PointCloud& cloud) {
    Fingerprint f;
    f.add(cloud.dim);
    for (const double x : cloud.coordinates) f.add(bits_of(x));
    return f.value();
}

std::uint64_t bars_fingerprint(const BarSource& bars) {
    Fingerprint f;
    bars.for_each([&](const Bar& bar) {
        f.add(bar.degree);
        f.add(bits_of(bar.birth));
        f.add(bits_of(bar.death));
    });
    return f.value();
}

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
template <std::uint32_t D>
void write_cells(std::vector<std::uint32_t>* cells, const std::vector<std::uint32_t>& place, Bytes& out) {
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
    std::uint32_t before = 0;
    for (std::uint32_t first = 0; first < place.size(); first++) {
        std::sort(others.begin() + end[first], others.begin() + end[first + 1]);
        for (std::uint32_t i = end[first]; i < end[first + 1]; i++) {
            out.number(first - before);
            before = first;
            for (std::uint32_t j = 0, last = first; j < D; last = others[i][j++]) out.number(others[i][j] - last - 1);
        }
    }
}

}  // namespace

void write_proof(const MeshSource& triangulation, const PointCloud& cloud, const BarSource& bars, TextWriter& to) {
    const std::vector<std::uint32_t> rows = rows_of(triangulation, cloud);
    Bytes out;
    out.text(magic);
    out.number(kind_alpha, 4);
    out.number(cloud.dim, 4);
    out.number(rows.size(), 8);
    out.number(triangulation.cell_count, 8);
    out.number(points_fingerprint(cloud), 8);
    out.number(bars_fingerprint(bars), 8);

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
    list = {};
    switch (cloud.dim) {
    case 2: write_cells<2>(&cells, place, out); break;
    case 3: write_cells<3>(&cells, place, out); break;
    case 4: write_cells<4>(&cells, place, out); break;
    case 5: write_cells<5>(&cells, place, out); break;
    default: write_cells<6>(&cells, place, out); break;
    }
    out.number(out.fingerprint(), 8);
    to << out.all();
}

}  // namespace netmesh::tool
