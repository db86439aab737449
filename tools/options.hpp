// The command line as the commands see it. The table in options.cpp is the one place where an option is declared: the
// parser and the help text both come from it.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "netmesh.h"
#include "tools/outcome.hpp"

namespace netmesh::tool {

enum class Command { none, mesh, delaunay, persist, homology, distance, size, check, sample, vineyard };

struct Options {
    Command command = Command::none;
    std::vector<std::string> positionals;
    bool help = false, version = false;

    std::string out;  // empty: stdout
    std::string svg;
    std::string mesh_out;         // persist: where the filtered mesh goes
    std::string representatives;  // where the cycles go
    bool json = false, analyse = false, check = false, all = false, bounds = false, quiet = false, log = false;

    std::optional<double> tau;
    std::optional<netmesh_method> method;  // persist: a quality mesh, in place of refinement by the certificate
    std::optional<double> ratio;           // asked of the certificate
    double focus = 0, from = 0, to = 0;    // ratio at scales of interest, and the scales; 0: not given
    bool fit = false;                      // the best ratio that the memory holds
    bool finish = false;                   // a hierarchical mesh
    std::uint32_t audit = 0;               // netmesh_audit_what
    double eps = 0;    // over-refinement, or what the filters tight and scales promise; 0: not given
    double theta = 0;  // scales; 0: not given
    std::optional<netmesh_filter> filter;
    std::optional<netmesh_values> values;
    std::optional<std::uint32_t> max_degree;
    std::optional<std::uint32_t> k,
        k_last;                    // knn, kdistance, barycentric filters; of a vineyard the first and the last
    std::size_t memory_bytes = 0;  // 0: reserved lazily
    std::uint64_t seed = 1;

    std::uint32_t dim = 0;               // size, sample
    std::uint64_t point_count = 0;       // size: --points, sample: -n
    std::string points_path, mesh_path;  // check
    double noise = 0;
    std::uint64_t turns[2] = {1, 10};
};

// Fills *options from the arguments behind the program's name. Exit::usage with a sentence that names the argument at
// fault. Positionals are counted; whether required options are there is for the command to say.
Outcome parse_options(const std::vector<std::string>& arguments, Options* options);

// Whether the mesh is refined by the certificate, and what is wrong with the options that say how.
bool refines_by_certificate(const Options& options);
Outcome check_ratio(const Options& options);

// Whether --eps is a promise about the diagram (tight, scales) and not a size of cells; and what is wrong with --eps and
// --theta for the filter asked for.
bool promises_accuracy(const Options& options);
Outcome check_accuracy(const Options& options);

const char* command_name(Command command);
const char* method_name(netmesh_method method);
const char* filter_name(netmesh_filter filter);
const char* values_name(netmesh_values values);
// Filters on the points themselves, without a triangulation.
bool is_points_filter(netmesh_filter filter);
bool is_barycentric(netmesh_filter filter);
// Highest degree when none is asked for: 1 where the complex grows with it, otherwise D - 1.
std::uint32_t max_degree_of(const Options& options, std::uint32_t dim);
// The function that a certified ratio is about: "closed offsets of the points in R^3", "sublevel sets of d_5 in R^3", ...
std::string reference_name(const netmesh_report& report);

// What --help prints, for the program (Command::none) or one command.
std::string help_text(Command command);
std::string version_text();

}  // namespace netmesh::tool
