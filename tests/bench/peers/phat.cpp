// PHAT is given the filtration as a boundary matrix: all faces of the cells of our mesh, by our values.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include <phat/algorithms/chunk_reduction.h>
#include <phat/algorithms/twist_reduction.h>
#include <phat/compute_persistence_pairs.h>
#include <phat/representations/default_representations.h>

#include "common/session.hpp"
#include "contestants.hpp"

namespace bench {
namespace {

using Matrix = phat::boundary_matrix<phat::bit_tree_pivot_column>;

struct Filtration {
    std::vector<double> value;         // by position
    std::vector<std::uint8_t> degree;  // by position
    Matrix boundary;
};

// One simplex of degree K-1 with its value and, in the end, its position in the filtration.
template <std::size_t K> struct Simplex {
    std::array<std::uint32_t, K> v;
    std::uint32_t position;
    double value;
};

template <std::size_t K> using Level = std::vector<Simplex<K>>;

template <std::size_t K, int D>
Level<K> level(const std::vector<std::array<std::uint32_t, D + 1>>& cells, const std::vector<double>& t,
               const std::vector<double>& own) {
    Level<K> all;
    for (unsigned mask = 0; mask < 1u << (D + 1); ++mask) {
        if (__builtin_popcount(mask) != static_cast<int>(K)) continue;
        for (const auto& cell : cells) {
            Simplex<K> s = {};
            std::size_t k = 0;
            for (std::size_t i = 0; i <= D; ++i)
                if (mask >> i & 1) s.v[k++] = cell[i];
            all.push_back(s);
        }
    }
    std::sort(all.begin(), all.end(), [](const Simplex<K>& a, const Simplex<K>& b) { return a.v < b.v; });
    all.erase(std::unique(all.begin(), all.end(), [](const Simplex<K>& a, const Simplex<K>& b) { return a.v == b.v; }),
              all.end());
    for (Simplex<K>& s : all) {
        s.value = K == 1 ? own[s.v[0]] : 0.0;
        if (K > 1)
            for (std::uint32_t v : s.v) s.value = std::max(s.value, t[v]);
    }
    return all;
}

template <std::size_t K> void columns(const Level<K>& simplices, const Level<K - 1>& faces, Matrix& boundary) {
    std::vector<phat::index> column(K);
    for (const Simplex<K>& s : simplices) {
        for (std::size_t skip = 0; skip < K; ++skip) {
            std::array<std::uint32_t, K - 1> f;
            for (std::size_t i = 0; i + 1 < K; ++i) f[i] = s.v[i + (i >= skip)];
            const auto at = std::lower_bound(faces.begin(), faces.end(), f,
                                             [](const Simplex<K - 1>& a, const auto& b) { return a.v < b; });
            column[skip] = at->position;
        }
        std::sort(column.begin(), column.end());
        boundary.set_col(s.position, column);
    }
}

// By value, then degree, then vertices.
template <int D, std::size_t... K>
void build(const std::vector<std::array<std::uint32_t, D + 1>>& cells, const std::vector<double>& t,
           const std::vector<double>& own, Filtration& filtration, std::index_sequence<K...>) {
    std::tuple<Level<K + 1>...> levels(level<K + 1, D>(cells, t, own)...);
    struct Key {
        double value;
        std::uint32_t degree, index;
    };
    std::vector<Key> keys;
    (
        [&](const auto& simplices) {
            for (std::size_t i = 0; i < simplices.size(); ++i)
                keys.push_back({simplices[i].value, static_cast<std::uint32_t>(K), static_cast<std::uint32_t>(i)});
        }(std::get<K>(levels)),
        ...);
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
        return a.value != b.value ? a.value < b.value : a.degree != b.degree ? a.degree < b.degree : a.index < b.index;
    });
    filtration.boundary.set_num_cols(static_cast<phat::index>(keys.size()));
    for (std::size_t p = 0; p < keys.size(); ++p) {
        filtration.value.push_back(keys[p].value);
        filtration.degree.push_back(static_cast<std::uint8_t>(keys[p].degree));
        filtration.boundary.set_dim(static_cast<phat::index>(p), static_cast<phat::dimension>(keys[p].degree));
        ((keys[p].degree == K ? void(std::get<K>(levels)[keys[p].index].position = static_cast<std::uint32_t>(p))
                              : void()),
         ...);
    }
    (
        [&](auto degree) {
            constexpr std::size_t k = decltype(degree)::value;
            if constexpr (k > 0) columns<k + 1>(std::get<k>(levels), std::get<k - 1>(levels), filtration.boundary);
        }(std::integral_constant<std::size_t, K>()),
        ...);
}

template <int D> void persist(Trial& trial, const inputs::Points& points, double tau, bool chunk) {
    std::vector<double> t, own;
    std::vector<std::array<std::uint32_t, D + 1>> cells;
    {
        Session session(D);
        session.request.mesh.tau = tau;
        if (session.mesh_and_persist(points) != NETMESH_OK) std::exit(1);
        for (const netmesh_vertex& vertex : session.vertices()) {
            t.push_back(vertex.value);
            own.push_back(vertex.marker == 0 ? 0.0 : vertex.value);
        }
        cells = session.cells<D + 1>();
    }
    Filtration filtration;
    const double before = resident_bytes();
    trial.start();
    build<D>(cells, t, own, filtration, std::make_index_sequence<D + 1>());
    trial.stop();
    const double build = trial.outcome.seconds, matrix = resident_bytes() - before;
    phat::persistence_pairs pairs;
    trial.start();
    if (chunk)
        phat::compute_persistence_pairs<phat::chunk_reduction>(pairs, filtration.boundary);
    else
        phat::compute_persistence_pairs<phat::twist_reduction>(pairs, filtration.boundary);
    trial.stop();
    trial.outcome.bytes += matrix;
    trial.figure(build_seconds, build);
    trial.figure(simplices, static_cast<double>(filtration.value.size()));
    std::vector<bool> paired(filtration.value.size(), false);
    for (phat::index i = 0; i < pairs.get_num_pairs(); ++i) {
        const auto [a, b] = pairs.get_pair(i);
        const std::size_t birth = static_cast<std::size_t>(a), death = static_cast<std::size_t>(b);
        paired[birth] = paired[death] = true;
        if (filtration.value[birth] != filtration.value[death])
            trial.outcome.diagram.push_back(
                bar(filtration.degree[birth], filtration.value[birth], filtration.value[death]));
    }
    for (std::size_t i = 0; i < paired.size(); ++i)
        if (!paired[i]) trial.outcome.diagram.push_back(bar(filtration.degree[i], filtration.value[i], INFINITY));
}

}  // namespace

void phat_persist(Trial& trial, int dim, const inputs::Points& points, double tau, bool chunk) {
    if (dim == 2) persist<2>(trial, points, tau, chunk);
    if (dim == 3) persist<3>(trial, points, tau, chunk);
    if (dim == 4) persist<4>(trial, points, tau, chunk);
}

}  // namespace bench
