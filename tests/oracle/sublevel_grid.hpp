// Sublevel sets of d_k and the k-distance on a fine grid, by GUDHI's cubical complexes.
#pragma once
#include <gudhi/Bitmap_cubical_complex.h>
#include <gudhi/Persistent_cohomology.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "common/inputs.hpp"

struct KDistance {
    const inputs::Points* points;
    int dim;
    std::size_t k;
    bool mean;

    double operator()(const double* x) const {
        std::vector<double> d2;
        const std::size_t d = static_cast<std::size_t>(dim);
        for (std::size_t i = 0; i < points->size(); i += d) {
            double sum = 0;
            for (std::size_t a = 0; a < d; ++a) sum += (x[a] - (*points)[i + a]) * (x[a] - (*points)[i + a]);
            d2.push_back(sum);
        }
        std::nth_element(d2.begin(), d2.begin() + static_cast<std::ptrdiff_t>(k - 1), d2.end());
        if (!mean) return std::sqrt(d2[k - 1]);
        double sum = 0;
        for (std::size_t i = 0; i < k; ++i) sum += d2[i];
        return std::sqrt(sum / static_cast<double>(k));
    }
};

using GridBars = std::map<std::uint32_t, std::vector<std::pair<double, double>>>;

// The diagram of cubes of this width, `side` along each edge of a box about the centre, each with f in its middle.
template <class F> GridBars diagram_of_cubes(int dim, const double* centre, double width, unsigned side, F&& f) {
    using Complex =
        Gudhi::cubical_complex::Bitmap_cubical_complex<Gudhi::cubical_complex::Bitmap_cubical_complex_base<double>>;
    using Persistence =
        Gudhi::persistent_cohomology::Persistent_cohomology<Complex, Gudhi::persistent_cohomology::Field_Zp>;
    std::vector<double> cubes;
    std::vector<unsigned> at(static_cast<std::size_t>(dim), 0);
    for (bool more = true; more;) {
        double x[6];
        for (std::size_t a = 0; a < at.size(); ++a) x[a] = centre[a] + width * (at[a] + 0.5 - side / 2.0);
        cubes.push_back(f(x));
        std::size_t a = 0;
        while (a < at.size() && ++at[a] == side) at[a++] = 0;
        more = a < at.size();
    }
    Complex complex(std::vector<unsigned>(static_cast<std::size_t>(dim), side), cubes);
    Persistence persistence(complex);
    persistence.init_coefficients(2);
    persistence.compute_persistent_cohomology(0);
    GridBars diagram;
    for (const auto& pair : persistence.get_persistent_pairs()) {
        const double birth = complex.filtration(std::get<0>(pair)), death = complex.filtration(std::get<1>(pair));
        diagram[static_cast<std::uint32_t>(complex.get_dimension_of_a_cell(std::get<0>(pair)))].push_back(
            {birth, death});
    }
    return diagram;
}

// The diagram of min(f, cut) on cubes with `side` of them along each edge of the box centre +- 2.1 cut, outside of
// which f >= cut; *doubt: how far f may be from its value in the middle of a cube.
inline GridBars on_grid(const KDistance& f, const double* centre, double cut, unsigned side, double* least,
                        double* doubt) {
    const double width = 4.2 * cut / side;
    *doubt = width * std::sqrt(static_cast<double>(f.dim)) / 2;
    *least = cut;
    return diagram_of_cubes(f.dim, centre, width, side, [&](const double* x) {
        const double value = std::min(f(x), cut);
        *least = std::min(*least, value);
        return value;
    });
}
