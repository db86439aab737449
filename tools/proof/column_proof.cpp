#include "tools/proof/column_proof.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "tools/opinion/complexes.hpp"
#include "tools/proof/column_reduction.hpp"
#include "tools/proof/edge_matrix.hpp"
#include "tools/proof/listed_cofaces.hpp"
#include "tools/proof/proof_bytes.hpp"
#include "tools/proof/rips_cliques.hpp"
#include "tools/proof/rips_edges.hpp"

namespace netmesh::tool {

namespace {

enum Kind : std::uint32_t { kind_rips_of_points = 3, kind_rips_of_distances = 4, kind_complex = 5, kind_cech = 6 };

// Which edges, one after the other, join two components. ends(e, 0), ends(e, 1): vertices.
template <class Ends> std::vector<bool> joining_edges(std::uint32_t vertices, std::uint32_t edges, Ends ends) {
    std::vector<std::uint32_t> root(vertices);
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    std::vector<bool> joins(edges);
    for (std::uint32_t e = 0; e < edges; e++) {
        const std::uint32_t a = find(ends(e, 0)), b = find(ends(e, 1));
        joins[e] = a != b;
        root[a] = b;
    }
    return joins;
}

template <class Complex>
void write_columns(const Complex& complex, const std::vector<bool>& joins, std::uint32_t max_degree, ProofBytes& out) {
    ColumnReduction<Complex> reduction(complex, joins);
    for (std::uint32_t p = 1; p <= max_degree; p++) reduction.reduce(p, out);
}

struct Head {
    Kind kind;
    std::uint32_t dim, vertices, max_degree;
    double limit;
    std::uint64_t input;
};

ProofBytes begin(const Head& head, const BarSource& bars) {
    ProofBytes out;
    out.text("netmesh proof 3\n");
    out.number(head.kind, 4);
    out.number(head.dim, 4);
    out.number(head.vertices, 8);
    out.number(head.max_degree, 8);
    out.number(bits_of(head.limit), 8);
    out.number(head.input, 8);
    out.number(bars_fingerprint(bars), 8);
    return out;
}

std::string finish(ProofBytes& out) {
    out.number(out.fingerprint(), 8);
    return out.all();
}

std::string proof_of(const ListedCofaces& complex, const Head& head, const BarSource& bars) {
    ProofBytes out = begin(head, bars);
    const auto ends = [&](std::uint32_t e, int which) { return complex.facets(e, 1)[which]; };
    write_columns(complex, joining_edges(complex.count(0), complex.count(1), ends), head.max_degree, out);
    return finish(out);
}

std::string proof_of(const RipsEdges& edges, Head head, const BarSource& bars) {
    const RipsCliques cliques(edges);
    const std::uint32_t most = std::max(edges.vertices, 2u) - 1;  // dimension of a set of all points
    if (!cliques.has_keys(std::min(head.max_degree + 1, most))) return {};
    head.vertices = edges.vertices;
    head.limit = edges.limit;
    ProofBytes out = begin(head, bars);
    const auto ends = [&](std::uint32_t e, int which) {
        return which == 0 ? cliques.edge(e).larger : cliques.edge(e).smaller;
    };
    write_columns(cliques, joining_edges(edges.vertices, cliques.edge_count(), ends), head.max_degree, out);
    return finish(out);
}

// The dimension, and the coordinates of different points.
std::uint64_t points_fingerprint(const PointCloud& different) {
    Fingerprint f;
    f.add(different.dim);
    for (const double x : different.coordinates) f.add(bits_of(x));
    return f.value();
}

// n and the halves of all distances; of entries, each edge once, with its vertices.
std::uint64_t distances_fingerprint(const DistanceFile& file) {
    Fingerprint f;
    f.add(file.points);
    using Entry = std::tuple<std::uint32_t, std::uint32_t, double>;
    std::vector<Entry> entries;
    for (const netmesh_distance_entry& e : file.entries)
        if (e.i != e.j) entries.emplace_back(std::max(e.i, e.j), std::min(e.i, e.j), e.distance);
    std::sort(entries.begin(), entries.end());
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    for (const auto& [larger, smaller, distance] : entries) {
        f.add(larger);
        f.add(smaller);
        f.add(bits_of(distance / 2));
    }
    if (file.layout == NETMESH_DISTANCES_SPARSE) return f.value();
    const bool is_full = file.layout == NETMESH_DISTANCES_FULL;
    for (std::uint64_t i = 0; i < file.points; i++)
        for (std::uint64_t j = 0; j < i; j++)
            f.add(bits_of(file.numbers[is_full ? i * file.points + j : i * (i - 1) / 2 + j] / 2));
    return f.value();
}

}  // namespace

std::string rips_proof(const PointCloud& points, double threshold, std::uint32_t max_degree, const BarSource& bars) {
    const PointCloud different = different_points(points);
    const std::uint64_t input = points_fingerprint(different);
    return proof_of(rips_edges(different, threshold), {kind_rips_of_points, different.dim, 0, max_degree, 0, input},
                    bars);
}

std::string cech_proof(const PointCloud& points, std::uint32_t max_degree, const BarSource& bars) {
    const PointCloud different = different_points(points);
    const SimplexList sets = complex_of_points(different, false, max_degree + 1, SIZE_MAX);
    SimplexFile file;
    for (const FilteredSimplex& s : *sets) {
        file.vertices.insert(file.vertices.end(), s.vertices.begin(), s.vertices.end());
        file.starts.push_back(file.vertices.size());
        file.values.push_back(s.value);
    }
    const auto count = static_cast<std::uint32_t>(different.rows());
    return proof_of(ListedCofaces(file),
                    {kind_cech, different.dim, count, max_degree, 0, points_fingerprint(different)}, bars);
}

std::string rips_proof(const DistanceFile& distances, double threshold, std::uint32_t max_degree,
                       const BarSource& bars) {
    return proof_of(rips_edges(distances, threshold),
                    {kind_rips_of_distances, 0, 0, max_degree, 0, distances_fingerprint(distances)}, bars);
}

std::string complex_proof(const SimplexFile& file, std::uint32_t max_degree, const BarSource& bars) {
    Fingerprint f;
    for (std::size_t i = 0; i < file.count(); i++) {
        std::vector<std::uint32_t> row(file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i]),
                                       file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i + 1]));
        std::sort(row.begin(), row.end());
        f.add(row.size());
        for (const std::uint32_t v : row) f.add(v);
        f.add(bits_of(file.values[i]));
    }
    const ListedCofaces complex(file);
    const std::uint32_t degree = std::min(max_degree, complex.dimension());
    return proof_of(complex, {kind_complex, 0, complex.count(0), degree, 0, f.value()}, bars);
}

}  // namespace netmesh::tool
