// Bars of two programs that round differently.
#pragma once
#include <iostream>  // which GUDHI's headers use without it

#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace oracle {

struct Bar {
    int degree;
    double birth, death;
};
using Bars = std::vector<Bar>;

// All bars of a complex that GUDHI has made; its last degree, too, if it is a torus.
inline Bars bars_of_tree(Gudhi::Simplex_tree<>& tree, bool has_last_degree) {
    using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>,
                                                                           Gudhi::persistent_cohomology::Field_Zp>;
    tree.initialize_filtration();
    Cohomology cohomology(tree, has_last_degree);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology(-1);
    Bars bars;
    for (const auto& pair : cohomology.get_persistent_pairs())
        bars.push_back({tree.dimension(std::get<0>(pair)), tree.filtration(std::get<0>(pair)),
                        tree.filtration(std::get<1>(pair))});
    return bars;
}

// Those that are longer than what roundings can make, in order.
inline Bars long_ones(const Bars& bars, double slack) {
    Bars kept;
    for (const Bar& bar : bars)
        if (bar.death - bar.birth > 4 * slack) kept.push_back(bar);
    std::sort(kept.begin(), kept.end(), [](const Bar& a, const Bar& b) {
        return a.degree != b.degree ? a.degree < b.degree : a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
    });
    return kept;
}

// How many of the first have none of their own in the other, of as many, with ends within slack. In order.
inline std::size_t count_unlike(const Bars& ours, const Bars& theirs, double slack) {
    const auto near = [=](double a, double b) { return a == b || std::fabs(a - b) <= slack; };
    std::vector<bool> is_taken(theirs.size(), false);
    std::size_t unlike = 0, low = 0;
    for (const Bar& bar : ours) {
        while (low < theirs.size() && (theirs[low].degree < bar.degree ||
                                       (theirs[low].degree == bar.degree && theirs[low].birth < bar.birth - slack)))
            ++low;
        std::size_t j = low;
        const auto goes_on = [&] {
            return j < theirs.size() && theirs[j].degree == bar.degree && theirs[j].birth <= bar.birth + slack;
        };
        while (goes_on() && (is_taken[j] || !near(theirs[j].birth, bar.birth) || !near(theirs[j].death, bar.death)))
            ++j;
        if (goes_on())
            is_taken[j] = true;
        else
            ++unlike;
    }
    return unlike;
}

}  // namespace oracle
