// A second opinion on diagrams: every simplex as a sorted vertex list, columns as sorted vectors, the textbook
// reduction.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "diagram/pair.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "homology/matrix/matrix.hpp"

namespace oracle {

using Simplex = std::vector<std::uint32_t>;  // sorted

struct Filtered {
    std::vector<Simplex> simplices;  // faces before cofaces, values non-decreasing
    std::vector<double> values;
};

inline std::vector<Simplex> all_faces(const std::vector<Simplex>& maximal) {
    std::set<Simplex> faces;
    for (const Simplex& m : maximal) {
        for (std::uint32_t mask = 1; mask < (1u << m.size()); ++mask) {
            Simplex s;
            for (std::size_t i = 0; i < m.size(); ++i) {
                if (mask >> i & 1) s.push_back(m[i]);
            }
            std::sort(s.begin(), s.end());
            faces.insert(s);
        }
    }
    return {faces.begin(), faces.end()};
}

template <class Value> Filtered filter(const std::vector<Simplex>& simplices, Value value) {
    std::vector<std::pair<double, Simplex>> order;
    for (const Simplex& s : simplices) order.push_back({value(s), s});
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        if (a.first != b.first) return a.first < b.first;
        if (a.second.size() != b.second.size()) return a.second.size() < b.second.size();
        return a.second < b.second;
    });
    Filtered f;
    for (auto& [t, s] : order) {
        f.values.push_back(t);
        f.simplices.push_back(s);
    }
    return f;
}

inline Filtered lower_star(const std::vector<Simplex>& simplices, const std::vector<double>& value,
                           std::uint32_t zero_born_count) {
    return filter(simplices, [&](const Simplex& s) {
        if (s.size() == 1 && s[0] < zero_born_count) return 0.0;
        double t = value[s[0]];
        for (const std::uint32_t v : s) t = std::max(t, value[v]);
        return t;
    });
}

inline std::vector<netmesh::Pair> diagram(const Filtered& f, std::uint32_t max_degree, bool keep_zero) {
    std::map<Simplex, std::uint32_t> index;
    for (std::uint32_t i = 0; i < f.simplices.size(); ++i) index[f.simplices[i]] = i;
    std::vector<std::vector<std::uint32_t>> reduced(f.simplices.size());  // by pivot
    std::vector<bool> paired(f.simplices.size());
    std::vector<netmesh::Pair> pairs;
    const auto add = [&](double birth, double death, std::size_t degree) {
        if (degree > max_degree || (birth == death && (!keep_zero || std::isinf(birth)))) return;
        pairs.push_back({birth, death, static_cast<std::uint32_t>(degree), 0});
    };
    for (std::uint32_t j = 0; j < f.simplices.size(); ++j) {
        std::vector<std::uint32_t> column;
        const Simplex& s = f.simplices[j];
        for (std::size_t i = 0; i < s.size() && s.size() > 1; ++i) {
            Simplex face = s;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
            column.push_back(index.at(face));
        }
        std::sort(column.begin(), column.end());
        while (!column.empty() && !reduced[column.back()].empty()) {
            std::vector<std::uint32_t> sum;
            const auto& other = reduced[column.back()];
            std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                          std::back_inserter(sum));
            column.swap(sum);
        }
        if (column.empty()) continue;
        const std::uint32_t i = column.back();
        paired[i] = paired[j] = true;
        add(f.values[i], f.values[j], s.size() - 2);
        reduced[i] = std::move(column);
    }
    for (std::uint32_t i = 0; i < f.simplices.size(); ++i) {
        if (!paired[i]) add(f.values[i], std::numeric_limits<double>::infinity(), f.simplices[i].size() - 1);
    }
    std::sort(pairs.begin(), pairs.end(), netmesh::CanonicalOrder{});
    return pairs;
}

inline bool same(const std::vector<netmesh::Pair>& a, const netmesh::PairList& b) {
    if (a.size() != b.count) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].birth != b.pairs[i].birth || a[i].death != b.pairs[i].death || a[i].degree != b.pairs[i].degree) {
            return false;
        }
    }
    return true;
}

// The same filtration in the engine's form.
struct Explicit {
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<std::vector<double>> values;
    netmesh::FilteredComplex complex;

    explicit Explicit(const Filtered& f) {
        std::size_t dimension = 0;
        for (const Simplex& s : f.simplices) dimension = std::max(dimension, s.size() - 1);
        faces.resize(dimension + 1);
        values.resize(dimension + 1);
        std::map<Simplex, std::uint32_t> index;
        for (std::size_t n = 0; n < f.simplices.size(); ++n) {
            const Simplex& s = f.simplices[n];
            const std::size_t k = s.size() - 1;
            index[s] = static_cast<std::uint32_t>(values[k].size());
            values[k].push_back(f.values[n]);
            for (std::size_t i = 0; i < s.size() && k > 0; ++i) {
                Simplex face = s;
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
                faces[k].push_back(index.at(face));
            }
        }
        complex.dimension = static_cast<std::uint32_t>(dimension);
        for (std::size_t k = 0; k <= dimension; ++k) {
            complex.of[k] = {static_cast<std::uint32_t>(values[k].size()), faces[k].data(), values[k].data()};
        }
    }
};

}  // namespace oracle
