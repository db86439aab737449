// Points of a file that need not fit memory, some rows at a time.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "platform/files.hpp"
#include "tools/io/table.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

class PointStream {
public:
    virtual ~PointStream() = default;

    std::uint32_t dim() const { return dim_; }
    const std::string& note() const { return note_; }  // as of Table; known once the first rows are
    // Appends some rows to *rows, about a mebibyte of them; none at the end of the file. Faults are those that
    // read_points finds in the same file.
    virtual Outcome read(std::vector<double>* rows) = 0;
    // Set by read(): the file is not as its beginning said, and has to be read whole.
    bool gave_up() const { return gave_up_; }

protected:
    // Exit::data where a table is no points.
    Outcome begin(const Table& table);
    std::uint32_t dim_ = 0;
    std::string note_;
    bool gave_up_ = false;
};

// The rows that read_points gives of the same file, in bounded memory: of .npy in both orders, binary .ply, and tables
// of plain numbers with one delimiter, each an ordinary file. *stream stays empty where it is none of these, or where
// the beginning of the file, so many bytes, leaves something open that only the whole of it says.
Outcome open_stream(const std::string& path, const TableOptions& options, std::unique_ptr<PointStream>* stream,
                    std::uint64_t head_bytes = std::uint64_t{1} << 20);

// The formats one by one: `head` is the beginning of the file, all of it where it is short.
Outcome open_npy_stream(std::string_view head, const std::string& name, const TableOptions& options,
                        std::unique_ptr<platform::InputFile> file, std::unique_ptr<PointStream>* stream);
// Not of those in text.
Outcome open_ply_stream(std::string_view head, const std::string& name, std::unique_ptr<platform::InputFile> file,
                        std::unique_ptr<PointStream>* stream);
Outcome open_table_stream(std::string_view head, const std::string& name, const TableOptions& options,
                          std::unique_ptr<platform::InputFile> file, std::unique_ptr<PointStream>* stream);

}  // namespace netmesh::tool
