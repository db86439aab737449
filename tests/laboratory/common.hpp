// A mesh or a triangulation made by the inner folders, and linear algebra by the book, for these tests.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "common/meshed.hpp"

template <int D> struct Held {
    explicit Held(std::size_t bytes = std::size_t{1} << 26) : block(bytes), store(block.arena, state) {}
    netmesh::Status mesh(const inputs::Points& points, double tau, netmesh::SizeRule rule = {}) {
        netmesh::MeshRequest request = by_quality(tau);
        request.size = rule;
        return mesh(points, request);
    }
    netmesh::Status mesh(const inputs::Points& points, const netmesh::MeshRequest& request) {
        netmesh::MeshResult<D> mesh;
        const netmesh::Status status =
            netmesh::mesh_points<D>(store, points.data(), points.size() / D, request, {block.arena, monitor}, &mesh);
        input = mesh.input;
        domain = mesh.domain;
        cages = mesh.cages;
        cage_count = mesh.hierarchy.cages;
        return status;
    }
    netmesh::Status triangulate(const inputs::Points& points) {
        const netmesh::Status status =
            netmesh::triangulate<D>(store, points.data(), points.size() / D, 1, monitor, &input);
        if (status == netmesh::Status::ok) netmesh::recompute_balls<D>(store);
        return status;
    }
    std::uint32_t inputs() const { return static_cast<std::uint32_t>(input.rows - input.duplicates); }

    Block block;
    netmesh::StoreState state = {};
    netmesh::Store<D> store;
    netmesh::Monitor monitor;
    netmesh::InputReport input = {};
    netmesh::Domain<D> domain = {};
    netmesh::Cage* cages = nullptr;
    std::uint32_t cage_count = 0;
};

inline double distance(const double* a, const double* b, int dim) {
    double d2 = 0;
    for (int k = 0; k < dim; ++k) d2 += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(d2);
}

// Distance to the second nearest of points[n][dim].
inline double second_nearest(const inputs::Points& points, int dim, const double* x) {
    double first = HUGE_VAL, second = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim)) {
        const double d = distance(&points[i], x, dim);
        second = std::min(second, std::max(first, d));
        first = std::min(first, d);
    }
    return second;
}

// Solves the m x m system a x = b, rows of a with b behind; false when it is singular.
inline bool solve(std::vector<std::vector<double>> a, std::vector<double>* x) {
    const std::size_t m = a.size();
    for (std::size_t k = 0; k < m; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < m; ++i)
            if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        if (!(std::fabs(a[k][k]) > 1e-11)) return false;
        for (std::size_t i = 0; i < m; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j <= m; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    x->resize(m);
    for (std::size_t k = 0; k < m; ++k) (*x)[k] = a[k][m] / a[k][k];
    return true;
}

// Calls visit(indices) for each subset of `size` of 0..count-1 until it returns true; whether it did.
template <class Visit> bool any_subset(int count, int size, Visit&& visit) {
    std::vector<int> chosen(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) chosen[static_cast<std::size_t>(i)] = i;
    while (size <= count) {
        if (visit(chosen)) return true;
        int i = size - 1;
        while (i >= 0 && chosen[static_cast<std::size_t>(i)] == count - size + i) --i;
        if (i < 0) return false;
        ++chosen[static_cast<std::size_t>(i)];
        for (int j = i + 1; j < size; ++j)
            chosen[static_cast<std::size_t>(j)] = chosen[static_cast<std::size_t>(j - 1)] + 1;
    }
    return false;
}
