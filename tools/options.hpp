// The command line as the commands see it. The tables of option_table.cpp are the one place where commands and options
// are declared: the parser and the help text both come from there.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "netmesh.h"
#include "tools/expression.hpp"
#include "tools/filters.hpp"
#include "tools/io/table.hpp"
#include "tools/outcome.hpp"
#include "tools/plot/axis.hpp"

namespace netmesh::tool {

class VertexFunction;

enum class Command { none, mesh, delaunay, persist, homology, distance, size, check, sample, vineyard };

struct Options {
    Command command = Command::none;
    std::vector<std::string> positionals;
    std::vector<std::pair<std::string, std::string>> given;  // options and their values, as they were written
    bool help = false, version = false;
    std::string completion;  // the shell whose completion file is asked for
    bool manual = false;     // the manual page of the command, or of the program, is asked for

    TableOptions table;  // how points are read
    std::string out;     // empty: stdout
    std::string svg;
    std::string mesh_out;         // persist: where the filtered mesh goes
    std::string representatives;  // where the cycles go
    std::string pace_path;        // where the order of the inputs goes
    std::string weighted_path;    // where the weighted cells of cages go
    double min_persistence = 0;   // of bars that are written
    std::uint64_t top = 0;        // so many of each degree, the longest; 0: all
    Axis axis = Axis::natural;    // of pictures of diagrams
    bool voronoi = false;         // pictures of meshes show Voronoi cells
    bool json = false, analyse = false, check = false, all = false, bounds = false, quiet = false, log = false;

    std::optional<double> tau;
    std::optional<netmesh_method> method;    // persist: a quality mesh, in place of refinement by the certificate
    std::optional<double> ratio;             // asked of the certificate
    double focus = 0, from = 0, to = 0;      // ratio at scales of interest, and the scales; 0: not given
    bool focus_auto = false;                 // scales of interest are those where bars are undecided
    double longer_than = 0;                  // death over birth of bars to be decided; 0: not given
    bool fit = false;                        // the best ratio that the memory holds
    bool finish = false;                     // a hierarchical mesh
    std::optional<netmesh_cage_kind> cages;  // of a hierarchical mesh
    std::uint32_t audit = 0;                 // netmesh_audit_what
    double eps = 0;    // over-refinement, or what the filters tight and scales promise; 0: not given
    double theta = 0;  // scales; 0: not given
    double size_at_inputs = 0, size_growth = 0;  // over-refinement by the distance to the inputs; 0: not given
    double domain_factor = 0;                    // 0: not given
    double net_spacing = 0;                      // 0: not given
    bool whole_cells = false;                    // of refinement by the certificate
    double pace_theta = 0;                       // of --pace; 0: not given
    std::optional<netmesh_filter> filter;
    bool auto_filter = false;  // persist, size: alpha where it is affordable, else complete; until that is known
    std::string implies_mesh;  // persist, size: the option that takes auto's choice away
    std::optional<netmesh_values> values;
    std::string values_path;   // vineyard, check: vectors of values, of the simplices of a complex
    std::string complex_path;  // check
    std::optional<std::uint32_t> max_degree;
    std::optional<std::uint32_t> k,
        k_last;                            // knn, kdistance, barycentric filters; of a vineyard the first and the last
    std::optional<Expression> function;    // of the filter function
    std::optional<double> lipschitz, cut;  // of that
    double error = 0;                      // asked of its diagram, or relative of --wasserstein; 0: not given
    std::uint32_t order = 0;               // of --wasserstein; 0: not given
    std::string values_at;  // in place of the expression: a file of values at the vertices of a mesh; of a head the
                            // fingerprint of the values
    std::shared_ptr<const VertexFunction> vertex_function;  // what was read of it
    std::size_t memory_bytes = 0;                           // 0: reserved lazily
    std::uint64_t seed = 1;

    std::uint32_t dim = 0;                   // size, sample
    std::uint64_t point_count = 0;           // size: --points, sample: -n
    std::string points_path, mesh_path;      // check
    bool distances = false, sparse = false;  // persist: the file has distances and no points
    std::optional<double> threshold;         // of distances, a radius
    double noise = 0;
    std::uint64_t turns[2] = {1, 10};
};

// Fills *options from the arguments behind the program's name. Exit::usage with a sentence that names the argument at
// fault. Positionals are counted; whether required options are there is for the command to say.
Outcome parse_options(const std::vector<std::string>& arguments, Options* options);

// Whether --json is among the arguments, also where they cannot be parsed.
bool asks_for_json(const std::vector<std::string>& arguments);

// The effect of one option of options->command on *options: a complaint, or empty.
std::string apply_option(Options* options, const std::string& name, const std::string& value);
// What no command can do with the options that it was given together.
Outcome check_together(const Options& options);

// The option that a field of the library's requests comes from, as the user wrote it: "--k 15". Its name alone when it
// was not given, nothing when the field comes from no option.
std::string option_of(const Options& options, netmesh_field field);

// Without --filter, or with --filter auto: leaves the choice to the engine, or to the option that implies a mesh.
void settle_auto(Options* options);

// What a diagram is of, with the defaults of the command. COMPLETE where the choice is still open.
netmesh_filter default_filter(Command command);
FilterChoice choice_of(const Options& options);
inline netmesh_filter filter_of(const Options& options) { return choice_of(options).filter; }

// Whether --fit goes by the additive error of a function's diagram.
bool fits_error(const Options& options);
// Whether the mesh is refined by the certificate, and what is wrong with the options that say how.
bool refines_by_certificate(const Options& options);
// Whether its cells are clipped unless --whole-cells says otherwise.
bool clips_cells(const Options& options);
Outcome check_ratio(const Options& options);

// Whether --eps is a promise about the diagram and not a size of cells; and what is wrong with --eps and --theta for
// the filter asked for.
bool promises_accuracy(const Options& options);
Outcome check_accuracy(const Options& options);

// Highest degree when none is asked for: 1 where the complex grows with it, otherwise D - 1.
std::uint32_t max_degree_of(const Options& options, std::uint32_t dim);
// What is wrong with --max-degree and --k for a filter on the points themselves.
Outcome check_max_degree(const Options& options);

const char* command_name(Command command);
// What --help prints, for the program (Command::none) or one command.
std::string help_text(Command command);
std::string version_text();

}  // namespace netmesh::tool
