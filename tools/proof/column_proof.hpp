// The proof of a Rips or Cech diagram, or of that of a complex that is listed: what a reduction adds to columns, in the
// format of docs/proofs.md.
#pragma once
#include <cstdint>
#include <string>

#include "tools/io/complex_file.hpp"
#include "tools/io/diagram_file.hpp"
#include "tools/io/distance_file.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

// Of a diagram of all bars of degrees 0 to max_degree. The same bytes wherever they are made. Each reduces on its own:
// it takes about as long as the diagram without the bound by alpha. Empty where simplices of dimension max_degree + 1
// cannot be numbered in 64 bits.
std::string rips_proof(const PointCloud& points, double threshold, std::uint32_t max_degree, const BarSource& bars);
std::string rips_proof(const DistanceFile& distances, double threshold, std::uint32_t max_degree,
                       const BarSource& bars);
// Every set of up to max_degree + 2 points is listed, some 200 bytes each.
std::string cech_proof(const PointCloud& points, std::uint32_t max_degree, const BarSource& bars);
// Of a file that lists a complex.
std::string complex_proof(const SimplexFile& file, std::uint32_t max_degree, const BarSource& bars);

}  // namespace netmesh::tool
