#include <cstring>

#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/report/report.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

namespace {

void write_text(const std::vector<double>& coordinates, std::uint32_t dim, char separator, TextWriter& out) {
    for (std::size_t i = 0; i < coordinates.size(); i++)
        out << coordinates[i] << ((i + 1) % dim == 0 ? '\n' : separator);
}

// Version 1.0, little-endian doubles, the header padded so that the data starts at a multiple of 64.
void write_npy(const std::vector<double>& coordinates, std::uint32_t dim, TextWriter& out) {
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(coordinates.size() / dim) + ", " + std::to_string(dim) + "), }";
    while ((10 + header.size() + 1) % 64 != 0) header += ' ';
    header += '\n';
    out << std::string_view("\x93NUMPY\x01\x00", 8) << static_cast<char>(header.size() & 255)
        << static_cast<char>(header.size() >> 8) << header;
    for (const double coordinate : coordinates) {
        const double value = coordinate + 0.0;  // -0.0 becomes 0.0
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        char bytes[8];
        for (int i = 0; i < 8; i++) bytes[i] = static_cast<char>(bits >> (8 * i) & 255);
        out << std::string_view(bytes, 8);
    }
}

}  // namespace

Outcome run_sample(const Options& options) {
    const std::string ending = ending_of(options.out);
    if (!options.out.empty() && ending != ".txt" && ending != ".xyz" && ending != ".csv" && ending != ".npy") {
        return usage_error(options.out + ": points are written to .txt, .xyz, .csv or .npy");
    }
    if (options.point_count == 0) return usage_error("sample needs -n N");
    SampleRequest request;
    request.shape = options.positionals[0];
    request.count = options.point_count;
    request.dim = options.dim;
    request.seed = options.seed;
    request.noise = options.noise;
    request.turns[0] = options.turns[0];
    request.turns[1] = options.turns[1];
    std::vector<double> coordinates;
    std::uint32_t dim = 0;
    const Outcome outcome = sample_points(request, &coordinates, &dim);
    if (!outcome.good()) return outcome;
    return write_files({{options.out, [&](TextWriter& out) {
                             if (ending == ".npy") {
                                 write_npy(coordinates, dim, out);
                             } else {
                                 write_text(coordinates, dim, ending == ".csv" ? ',' : ' ', out);
                             }
                         }}});
}

}  // namespace netmesh::tool
