#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/npy_writer.hpp"
#include "tools/report/report.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

namespace {

void write_text(const std::vector<double>& coordinates, std::uint32_t dim, char separator, TextWriter& out) {
    for (std::size_t i = 0; i < coordinates.size(); i++)
        out << coordinates[i] << ((i + 1) % dim == 0 ? '\n' : separator);
}

void write_npy(const std::vector<double>& coordinates, std::uint32_t dim, TextWriter& out) {
    write_npy_head(coordinates.size() / dim, dim, out);
    for (const double coordinate : coordinates) write_npy_double(coordinate, out);
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
    request.seed = options.request.seed;
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
