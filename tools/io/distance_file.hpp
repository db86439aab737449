// Distances from files.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "netmesh.h"
#include "tools/io/points.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

struct DistanceFile {
    netmesh_distance_layout layout = NETMESH_DISTANCES_FULL;
    std::uint64_t points = 0;
    std::vector<double> numbers;                  // infinity: never joined
    std::vector<netmesh_distance_entry> entries;  // of SPARSE
    PointCloud place;                             // the file's name, and the line of each row or entry; no coordinates
    std::string note;                             // what was left out or understood; empty when nothing

    // FILE:LINE, field N of row a and column b; of SPARSE of entry a.
    std::string where(std::uint64_t a, std::uint64_t b) const;
    // What is wrong there.
    Outcome fault(std::uint64_t a, std::uint64_t b, const std::string& complaint) const;
};

// Text: a full square matrix, or a lower triangle as ripser takes it: a line for each point but the first (or
// an empty one for that), with as many numbers as there are points before it, 0 behind them or not. A square with
// nothing but zeros on one side of its diagonal is a triangle, too (numpy's tril and triu). An upper triangle, with its
// diagonal or not, and scipy's condensed form in one line or one column. The rounding noise of a square, up to 2^-36 of
// its largest distance, is taken off and said. sparse: lines `i j d`, points numbered from 0. `inf` is a distance. A
// header is skipped, and behind it a name in front of each row, which may be a number where the header's first field is
// empty (pandas, R); file->note says so. A header must have as many names as there are points. .npy, .npz: a square, `i
// j d` rows if sparse, or one axis of n (n - 1) / 2 numbers, the upper triangle row by row, which is the lower one
// column by column, as scipy's pdist and R's dist have it. Every fault is Exit::data with file, line and field.
Outcome read_distances(const std::string& path, bool sparse, DistanceFile* file);
Outcome parse_distances(std::string_view content, bool sparse, DistanceFile* file);
// A NumPy array of one or two axes.
Outcome take_distances(Table table, bool sparse, DistanceFile* file);

}  // namespace netmesh::tool
