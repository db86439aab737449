#include "nerve.hpp"

#include <algorithm>

namespace referee {
namespace {

using Simplex = std::vector<std::uint32_t>;

enum class Answer { no, yes, by_cofacets, unknown };

template <class T> Answer ask(const Mesh& mesh, const Simplex& simplex, const Simplex& beside) {
    const int dim = mesh.dim, n = static_cast<int>(simplex.size()) - 1;
    const Point& v = mesh.vertices[simplex[0]];
    const Vector<T> centre = difference<T>(v, mesh.centre, dim);
    Matrix<T> edges, gram;
    Vector<T> right, weights, off;
    for (int i = 0; i < n; i++)
        edges[i] = difference<T>(v, mesh.vertices[simplex[1 + static_cast<std::size_t>(i)]], dim);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) gram[i][j] = dot<T>(edges[i], edges[j], dim);
        right[i] = gram[i][i] * T(0.5) - dot<T>(edges[i], centre, dim);
    }
    if (!solve<T>(gram, right, n, &weights)) return Answer::unknown;
    for (int k = 0; k < dim; k++) {
        off[k] = T(0.0);
        for (int i = 0; i < n; i++) off[k] = off[k] + weights[i] * edges[i][k];
    }
    const int outside_ball = sign_of(T(norm2<T>(off, dim) - square(T(mesh.radius))));
    if (outside_ball == 1) return Answer::no;
    Vector<T> x;
    for (int k = 0; k < dim; k++) x[k] = centre[k] + off[k];
    bool known = outside_ball != 2;
    for (const std::uint32_t w : beside) {
        const Vector<T> a = difference<T>(v, mesh.vertices[w], dim);
        const int sign = sign_of(T(dot<T>(a, x, dim) - norm2<T>(a, dim) * T(0.5)));
        if (sign == 1) return Answer::by_cofacets;
        known = known && sign != 2;
    }
    return known ? Answer::yes : Answer::unknown;
}

}  // namespace

Nerve::Nerve(const Mesh& mesh) {
    std::map<Simplex, Simplex> beside;  // vertices of cofacets
    for (const Entries& cell : mesh.cells) {
        Simplex all(cell.begin(), cell.begin() + mesh.dim + 1);
        std::sort(all.begin(), all.end());
        for (unsigned subset = 1; subset < 2u << mesh.dim; subset++) {
            Simplex simplex, rest;
            for (std::size_t i = 0; i < all.size(); i++) (subset >> i & 1u ? simplex : rest).push_back(all[i]);
            Simplex& list = beside[simplex];
            list.insert(list.end(), rest.begin(), rest.end());
        }
    }
    for (int size = mesh.dim + 1; size > 0; size--)
        for (auto& [simplex, list] : beside) {
            if (simplex.size() != static_cast<std::size_t>(size)) continue;
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
            Answer answer = ask<Interval>(mesh, simplex, list);
            if (answer == Answer::unknown) answer = ask<Rational>(mesh, simplex, list);
            bool meets = answer == Answer::yes;
            for (std::size_t i = 0; answer == Answer::by_cofacets && !meets && i < list.size(); i++) {
                Simplex cofacet = simplex;
                cofacet.insert(std::upper_bound(cofacet.begin(), cofacet.end(), list[i]), list[i]);
                meets = meets_.at(cofacet);
            }
            meets_[simplex] = meets;
        }
}

}  // namespace referee
