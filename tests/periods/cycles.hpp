// Cycles of points that repeat, judged by the complex of truth.hpp: closed, born with their bars, and boundaries
// exactly from the deaths of their bars on. No code of the engine.
#pragma once
#include <cmath>
#include <string>

#include "periods/truth.hpp"

namespace periods {

// A vertex and how many of each given vector take its point to it.
struct Corner {
    std::size_t row;
    std::vector<long> times;
};
struct CycleSimplex {
    std::vector<Corner> corners;
    double value;
};
struct CycleOfBar {
    Bar bar;
    std::vector<CycleSimplex> simplices;
};

class CycleJudge {
public:
    explicit CycleJudge(const Cloud& cloud) : scene_(cloud), values_(values_of_cells(cloud)) {
        for (std::size_t j = 0; j < cloud.periods(); ++j) given_.push_back(scene_.whole(cloud.lattice, j));
        for (Values::const_iterator i = values_.begin(); i != values_.end(); ++i) order_.push_back(i);
        std::stable_sort(order_.begin(), order_.end(), [](const auto& a, const auto& b) {
            const int sign = cmp(a->second, b->second);
            return sign != 0 ? sign < 0 : a->first.size() < b->first.size();
        });
        for (std::size_t j = 0; j < order_.size(); ++j) place_[order_[j]->first] = j;
        owner_.assign(order_.size(), SIZE_MAX);
        for (std::size_t j = 0; j < order_.size(); ++j) {
            Chain own = boundary(order_[j]->first);
            reduce(&own);
            if (!own.empty()) owner_[*own.rbegin()] = j;
            column_.push_back(own);
        }
    }

    // What is wrong with it; empty: nothing.
    std::string judge(const CycleOfBar& cycle) const {
        Chain chain, edge;
        double last = -HUGE_VAL;
        const bool dies = !std::isinf(cycle.bar.death);
        for (const CycleSimplex& simplex : cycle.simplices) {
            if (simplex.corners.size() != cycle.bar.degree + 1) return "a simplex of another dimension";
            const Simplex own = simplex_of(simplex);
            const auto found = place_.find(own);
            if (found == place_.end()) return "a simplex that no complex has";
            if (weights::value_of(values_.at(own), false) != simplex.value) return "a simplex of another value";
            if (!chain.insert(found->second).second) return "a simplex twice";
            last = std::fmax(last, simplex.value);
            add(boundary(own), &edge);
        }
        if (chain.empty()) return "no simplices";
        if (cycle.bar.degree == 0 && chain.size() != (dies ? 2 : 1)) return "not a vertex, or two";
        if (!edge.empty()) return "a boundary";
        if (last != cycle.bar.birth) return "another birth";
        const std::size_t end = reduce(&chain);
        if (!chain.empty()) return dies ? "it never dies" : "";
        if (!dies) return "it dies";
        return weights::value_of(order_[end]->second, false) == cycle.bar.death ? "" : "another death";
    }

private:
    using Chain = std::set<std::size_t>;

    static void add(const Chain& other, Chain* to) {
        for (const std::size_t i : other)
            if (!to->insert(i).second) to->erase(i);
    }
    Chain boundary(const Simplex& simplex) const {
        Chain facets;
        for (std::size_t i = 0; i < simplex.size() && simplex.size() > 1; ++i) {
            Simplex facet = simplex;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            settle(&facet);
            add({place_.at(facet)}, &facets);
        }
        return facets;
    }
    // The last column that was needed.
    std::size_t reduce(Chain* chain) const {
        std::size_t last = 0;
        while (!chain->empty() && owner_[*chain->rbegin()] != SIZE_MAX) {
            const std::size_t j = owner_[*chain->rbegin()];
            last = std::max(last, j);
            add(column_[j], chain);
        }
        return last;
    }
    // In multiples of the short basis.
    Simplex simplex_of(const CycleSimplex& simplex) const {
        Simplex own;
        for (const Corner& corner : simplex.corners) {
            Vector v(scene_.dim);
            for (std::size_t j = 0; j < given_.size(); ++j) v = sum_of(v, given_[j], corner.times[j]);
            Copy copy{static_cast<int>(corner.row)};
            for (std::size_t j = 0; j < scene_.basis.size(); ++j) {
                mpq_class times = 0;
                for (std::size_t i = 0; i < scene_.basis.size(); ++i)
                    times += scene_.inverse[j][i] * dot(scene_.basis[i], v);
                if (times.get_den() != 1) std::abort();
                copy[j + 1] = static_cast<int>(times.get_num().get_si());
            }
            own.push_back(copy);
        }
        settle(&own);
        return own;
    }

    Scene scene_;
    Values values_;
    std::vector<Vector> given_;
    std::vector<Values::const_iterator> order_;
    std::map<Simplex, std::size_t> place_;
    std::vector<std::size_t> owner_;
    std::vector<Chain> column_;
};

}  // namespace periods
