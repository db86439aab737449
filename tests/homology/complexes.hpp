// Complexes with known homology, and random ones.
#pragma once
#include <random>

#include "oracle.hpp"

using oracle::Simplex;

inline std::vector<Simplex> sphere(std::uint32_t dimension) {
    std::vector<Simplex> maximal;
    for (std::uint32_t skip = 0; skip < dimension + 2; ++skip) {
        Simplex s;
        for (std::uint32_t v = 0; v < dimension + 2; ++v) {
            if (v != skip) s.push_back(v);
        }
        maximal.push_back(s);
    }
    return maximal;
}

// A square grid of n x n, its sides glued; turned: the second pair of sides is glued with a flip.
inline std::vector<Simplex> glued_square(std::uint32_t n, bool turned) {
    std::vector<Simplex> maximal;
    const auto at = [&](std::uint32_t x, std::uint32_t y) {
        if (x == n && turned) y = n - y;
        return x % n * n + y % n;
    };
    for (std::uint32_t x = 0; x < n; ++x) {
        for (std::uint32_t y = 0; y < n; ++y) {
            maximal.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            maximal.push_back({at(x, y), at(x, y + 1), at(x + 1, y + 1)});
        }
    }
    return maximal;
}

// Six vertices, the icosahedron with opposite points identified.
inline const std::vector<Simplex> projective_plane = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 1, 5},
                                                      {1, 2, 4}, {2, 3, 5}, {1, 3, 4}, {2, 4, 5}, {1, 3, 5}};

inline oracle::Filtered random_filtration(std::mt19937& random, std::uint32_t vertices, std::uint32_t dimension,
                                          std::uint32_t maximal_count, std::uint32_t levels) {
    std::vector<Simplex> maximal;
    for (std::uint32_t i = 0; i < maximal_count; ++i) {
        std::set<std::uint32_t> s;
        while (s.size() < dimension + 1) s.insert(random() % vertices);
        maximal.push_back(Simplex(s.begin(), s.end()));
    }
    const auto simplices = oracle::all_faces(maximal);
    std::map<Simplex, double> value;
    for (std::size_t size = 1; size <= dimension + 1; ++size) {
        for (const Simplex& s : simplices) {
            if (s.size() != size) continue;
            double t = double(random() % levels) - 2;
            for (std::size_t i = 0; i < size && size > 1; ++i) {
                Simplex face = s;
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
                t = std::max(t, value.at(face));
            }
            value[s] = t;
        }
    }
    return oracle::filter(simplices, [&](const Simplex& s) { return value.at(s); });
}
