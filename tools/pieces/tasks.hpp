// Single tasks of a job in pieces, on the files of a folder: pure functions, each of which writes one file, whole or
// not at all.
//
//   DIR/points         the points in the order of the tree (points_file.hpp)
//   DIR/piece-NODE     what netmesh_leaf or netmesh_join has made
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/pieces/points_file.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

class PiecesFolder {
public:
    explicit PiecesFolder(std::string path) : path_(std::move(path)) {}
    const std::string& path() const { return path_; }
    std::string points() const { return path_ + "/points"; }
    std::string piece(std::uint32_t node) const { return path_ + "/piece-" + std::to_string(node); }

private:
    std::string path_;
};

// The options of persist that the diagram of a job is of.
Options persist_options(const Options& options, const PiecesJob& job);

// How many pieces are advised for so many points: a power of 2. memory_bytes: what a leaf may take; 0: anything.
std::uint32_t advised_pieces(std::uint32_t dim, std::uint64_t points, std::size_t memory_bytes);

// What messages are about where no point is.
PointCloud nothing_of(const PiecesJob& job);

// Reads the points of a file, which need not fit memory, and writes them split, into as many pieces as the options say
// or are advised. A folder that holds the same job already is left as it is; one that holds another is refused.
// *read_seconds: what reading took. --memory is that of the points, a quarter of a gibibyte where none is given.
// *points: those of the folder, which are these.
Outcome split_task(const Options& options, const PiecesFolder& folder, const std::string& input, double* read_seconds,
                   PointsFile* points);
// The piece of a node, of a leaf or a join by its number. One that is there already, whole, is left as it is. Whoever
// replaces points or pieces in the meantime has them refused: all that is read is of this job.
// block: where the engine works, for one task after the other.
Outcome piece_task(const Options& options, const PiecesFolder& folder, const PiecesJob& job, std::uint32_t node,
                   platform::Reservation* block);
// Whole, and of this job.
bool has_piece(const PiecesFolder& folder, const PiecesJob& job, std::uint32_t node);
// The diagram of all pieces in the session's engine. One file is open at a time.
class Collection {
public:
    // Whether all are there.
    Outcome open(const PiecesFolder& folder, const PiecesJob& job);
    // Bytes that are more than the diagram takes.
    std::size_t plan() const { return plan_; }
    netmesh_status collect(Session& session);
    // What is wrong with a piece, by the engine's detail; good: nothing.
    Outcome explain(const netmesh_detail& detail) const;

private:
    static netmesh_status open_piece(void* self, std::size_t i, netmesh_piece* piece);

    PiecesJob job_ = {};
    std::vector<std::string> names_;
    platform::MappedFile file_;
    std::size_t at_ = 0, plan_ = 65536;
    std::string fault_;  // of file at_
};

}  // namespace netmesh::tool
