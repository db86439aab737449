// Points on disk, on their way from the input's order to that of the tree of pieces.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "platform/files.hpp"
#include "tools/io/fingerprint.hpp"
#include "tools/outcome.hpp"
#include "tools/pieces/points_file.hpp"

namespace netmesh::tool {

// Records [dim + 1] of doubles: the coordinates of a point, and its row in the input.
using Records = std::vector<double>;

// What the engine makes of the points of one node that are in memory; their order in the input is that of their rows.
// Exit::done with a result whose order and boxes stand until the next call.
using SplitNode = std::function<Outcome(const Records& records, std::uint32_t pieces, netmesh_split_result* split)>;

class ScratchPoints {
public:
    // A file of the folder without a name. `points_most`: so many points are in memory at a time.
    Outcome open(const std::string& folder, std::uint32_t dim, std::uint64_t points_most);
    // The next rows of the input, whole ones.
    Outcome add(const std::vector<double>& coordinates);
    Outcome end();

    std::uint64_t rows() const { return rows_; }
    std::uint64_t fingerprint() const { return print_.value(); }  // of all rows, as reports have it

    // Fewer pieces than `job` says will do where there are fewer different points.
    void lower_pieces() { lowers_ = true; }
    // Writes all points in the order of the tree, each of several equal ones once. `job` says pieces and what is kept,
    // and is told the rest. The file is the same whatever points_most is. Exit::usage where there are fewer different
    // points than pieces.
    Outcome write(const std::string& path, const std::string& name, const SplitNode& split, PiecesJob* job);

private:
    using Box = std::vector<double>;  // least coordinates, then greatest
    // Records first, first + 1, .. of the file.
    struct Part {
        std::uint64_t first, count;
        std::uint32_t node;  // of the tree; 0: none
        Box box;
    };
    // The order of a cut: by one coordinate, then by all, then by rows.
    struct Before {
        std::uint32_t axis, words;
        bool operator()(const double* a, const double* b) const;
    };
    class Block;

    std::uint32_t words() const { return dim_ + 1; }
    bool is_equal(const double* a, const double* b) const;
    void grow(const double* record, Box* box) const;
    Box no_box() const;
    Outcome fault() const;
    bool load(std::uint64_t first, std::uint64_t count, Records* records);
    bool save(std::uint64_t first, const double* records, std::uint64_t count);
    // Calls with each record of a part. False: the file cannot be read.
    bool each(const Part& part, const std::function<void(const double*)>& visit);

    // The record with so many others of the part before it; *repeats: is the one before it equal to it?
    bool find(const Part& part, const Before& before, std::uint64_t rank, Records* found, bool* repeats);
    // Puts those that are first in front. Of how many, and boxes about both.
    bool partition(const Part& part, const std::function<bool(const double*)>& is_first, Part* one, Part* other);
    // The tree below a node. *repeats: there are equal points, and nothing that was written is of use.
    Outcome cut_all(const Part& root, const SplitNode& split, std::uint32_t levels, PointsWriter* out, bool* repeats);
    Outcome cut_in_memory(const Part& part, const SplitNode& split, std::uint32_t pieces, netmesh_split_result* made,
                          Records* records);
    void put(const Part& part, const netmesh_split_result& made, const Records& records, PointsWriter* out);
    Outcome drop_equal();
    Outcome drop_equal_in(const Part& part, std::vector<Part>* parts, std::uint64_t* kept);

    std::string folder_;
    platform::ScratchFile file_;
    std::uint32_t dim_ = 0;
    std::uint64_t most_ = 0, rows_ = 0, count_ = 0;
    Fingerprint print_;
    bool lowers_ = false;
    Box box_;
    Records pending_;
};

}  // namespace netmesh::tool
