// The points of a job in pieces as a file: in the order of the tree, with boxes, read in place.
//
// A header, coordinates [count][dim], rows [count], boxes [2^(levels + 1) - 1][2][dim], and a checksum for each 64 KiB
// of that. Numbers are those of the machine. A part is checked when it is first looked at.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "netmesh.h"
#include "platform/files.hpp"
#include "platform/mapped_file.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// What all tasks of a job have to agree in.
struct PiecesJob {
    std::uint64_t magic, bytes, checksum;  // of the header behind it
    std::uint64_t count, rows, fingerprint;
    std::uint32_t dim, levels, pieces, max_degree, keep_zero, name_bytes;
    std::uint64_t parts;  // checksums of parts, at this offset
    char name[256];       // of the input, for messages
};

// In what two jobs differ, as a phrase; empty: they ask for the same pieces of the same points.
std::string difference_of(const PiecesJob& there, const PiecesJob& wanted);

class PointsFile {
public:
    PointsFile() = default;
    PointsFile(const PointsFile&) = delete;
    PointsFile& operator=(const PointsFile&) = delete;

    // Exit::data for what is no such file, or damaged.
    Outcome open(const std::string& path);
    // And for the points of another job.
    Outcome open(const std::string& path, const PiecesJob& wanted);
    const PiecesJob& job() const { return job_; }
    // Whose functions read this; it must outlive the source.
    netmesh_source source();
    // Empty, or what a function of the source has found wrong.
    const std::string& fault() const { return fault_; }

private:
    static netmesh_status read(void* self, std::uint64_t first, std::uint32_t count, double* points,
                               std::uint32_t* rows);
    static netmesh_status box(void* self, std::uint32_t node, double* box);
    bool copy(std::uint64_t offset, std::size_t bytes, void* to);

    std::string path_, fault_;
    platform::MappedFile file_;
    PiecesJob job_ = {};
    std::uint64_t rows_at_ = 0, boxes_at_ = 0;
    std::vector<bool> checked_;
};

// Writes such a file, whole or not at all, part by part in any order. Faults are remembered until finish().
class PointsWriter {
public:
    // `job` says count, rows, fingerprint, dim, levels, pieces, max_degree and keep_zero.
    Outcome open(const std::string& path, const std::string& name, const PiecesJob& job);
    void put_points(std::uint64_t first, const double* coordinates, const std::uint32_t* rows, std::size_t count);
    void put_boxes(std::uint32_t node, const double* boxes, std::size_t count);
    Outcome finish();

private:
    std::string path_;
    platform::OutputFile file_;
    PiecesJob job_ = {};
};

}  // namespace netmesh::tool
