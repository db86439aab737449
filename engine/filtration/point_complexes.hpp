// Filtrations on the points themselves: Cech and Vietoris-Rips complexes, and their barycentric decompositions, whose
// level k stands for the places within a radius of k points. Thesis 6.4, 7.7, 8.5.
#pragma once
#include <cstdint>

#include "complex/listed_complex.hpp"
#include "filtration/distance_source.hpp"
#include "memory/work.hpp"

namespace netmesh {

// All values are radii: balls of that radius about the vertices meet pairwise (Rips: half the longest edge), or all in
// one point (Cech: the radius of the smallest enclosing ball), rounded to the nearest double. coordinates: [n][dim],
// distinct points. The complexes are linked but not in order of value, and lie at the arena's low end. `dimension` <=
// ListedComplex::dimension_max and < n; a complex of which a dimension would have 2^31 simplices or more is
// out_of_memory.

// The skeleton up to `dimension` of the Vietoris-Rips complex, as far as the threshold, or the radius from which on
// one point is joined to everything: the complex is a cone then and nothing is born any more. out_of_memory, cancelled.
Status rips_complex(int dim, const double* coordinates, std::uint32_t n, std::uint32_t dimension, double threshold,
                    const Work& work, ListedComplex* out);

// The same without an end: all simplices of up to dimension + 1 points.
Status full_rips_complex(int dim, const double* coordinates, std::uint32_t n, std::uint32_t dimension, const Work& work,
                         ListedComplex* out);

// The skeleton up to `dimension` of the flag complex of points within twice the limit, which is finite. Otherwise as
// rips_complex.
Status distance_complex(const DistanceSource& source, std::uint32_t dimension, double limit, const Work& work,
                        ListedComplex* out);

// All simplices of up to dimension + 1 points. The value of a simplex is the radius of its smallest circumsphere if
// that has its centre inside, otherwise the largest of its facets': the smallest enclosing ball. Scratch: see
// settle_circumsphere. out_of_memory, cancelled; out_of_range, as alpha_values.
Status cech_complex(int dim, const double* coordinates, std::uint32_t n, std::uint32_t dimension, const Work& work,
                    ListedComplex* out);

// The barycentric decomposition of `complex` (linked) on its simplices of at least k vertices, up to simplices of
// `dimension`, each a chain of nested sets that enters with its largest set. Homology of degree p needs the sets of k
// to k + p + 1 vertices and chains of dimension p + 1. The largest set of a chain has at most `span` vertices more than
// the smallest: what is made is the union, for all l >= k, of the decompositions on sets of l to l + span vertices. The
// label of a set (rows[0]) is its number among the sets of at least k vertices, by size. The result lies behind
// `complex`, which must stay.
Status barycentric_complex(const ListedComplex& complex, std::uint32_t k, std::uint32_t span, std::uint32_t dimension,
                           const Work& work, ListedComplex* out);

// Vertices of the set with that label.
std::uint32_t set_size(const ListedComplex& complex, std::uint32_t k, std::uint32_t label);

// Simplices that the complexes have at most, of each dimension 0..dimension (numbers that do not fit are infinite).
double skeleton_count(std::uint64_t n, std::uint32_t dimension);
// On the sets of k to `sets` vertices.
double barycentric_count(std::uint64_t n, std::uint32_t k, std::uint32_t sets, std::uint32_t dimension);
// Pairs of degrees 0..max_degree that have a length, at most, of the decomposition on sets of at least k vertices. The
// chains whose largest set is u enter together: a cone over the chains of smaller sets, which are a wedge of
// binomial(|u| - 1, k - 1) spheres of dimension |u| - k - 1. So u is worth that many cells of dimension |u| - k, and a
// pair of degree p needs one of dimension p.
double barycentric_pairs(std::uint64_t n, std::uint32_t k, std::uint32_t max_degree);

}  // namespace netmesh
