// NumPy arrays on their way out: version 1.0, little-endian doubles, two axes in C order.
#pragma once
#include <cstdint>

#include "tools/io/text_writer.hpp"

namespace netmesh::tool {

// The header, padded so that the data starts at a multiple of 64; rows * columns numbers have to follow.
void write_npy_head(std::uint64_t rows, std::uint64_t columns, TextWriter& out);
void write_npy_double(double number, TextWriter& out);

}  // namespace netmesh::tool
