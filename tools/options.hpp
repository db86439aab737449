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

enum class Command { none, mesh, delaunay, persist, homology, distance, size, check, sample, vineyard, pieces };

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
    std::string proof;            // persist: where the proof of the diagram goes
    std::string pace_path;        // where the order of the inputs goes
    std::string weighted_path;    // where the weighted cells of cages go
    double least = 0;             // of bars that are written
    std::uint64_t top = 0;        // so many of each degree, the longest; 0: all
    Axis axis = Axis::natural;    // of pictures of diagrams
    bool voronoi = false;         // pictures of meshes show Voronoi cells
    bool json = false, analyse = false, check = false, quiet = false, log = false;

    // What the engine is asked for, as far as it was given: of what the diagram is and where it is put is for
    // requests.hpp to say. The option --eps, which is two members, is the goal's until parse_options or check knows
    // better.
    netmesh_request request = netmesh_default_request();
    std::string implies_mesh;              // persist, size: the option that takes the choice of a filter away
    bool focus_auto = false;               // scales of interest are those where bars are undecided
    std::string cages;                     // of a hierarchical mesh: compact or thesis; empty: not given
    double pace_theta = 0;                 // of --pace; 0: not given
    std::string values_path;               // vineyard, check: vectors of values, of the simplices of a complex
    std::string complex_path;              // check
    std::optional<Expression> function;    // of the filter function
    std::optional<double> lipschitz, cut;  // of that
    std::string values_at;  // in place of the expression: a file of values at the vertices of a mesh; of a head the
                            // fingerprint of the values
    std::shared_ptr<const VertexFunction> vertex_function;  // what was read of it
    std::uint32_t order = 0;                                // of --wasserstein; 0: not given
    double relative_error = 0;                              // of that; 0: not given
    std::size_t memory_bytes = 0;                           // 0: reserved lazily

    std::uint32_t dim = 0;                   // size, sample
    std::uint64_t point_count = 0;           // size: --points, sample: -n
    std::string points_path, mesh_path;      // check
    std::string proof_path;                  // check; empty: the one beside the diagram
    bool distances = false, sparse = false;  // persist: the file has distances and no points
    std::uint32_t pieces = 0;                // persist, pieces: into so many, a power of 2; 0: not given
    bool pieces_auto = false;                // as many as are advised
    std::uint32_t jobs = 0;                  // of pieces or inputs: processes at a time; 0: not given
    std::string scratch;                     // of pieces: the folder for their files; empty: one that does not stay
    double noise = 0;
    std::uint64_t turns[2] = {1, 10};
};

// Fills *options from the arguments behind the program's name. Exit::usage with a sentence that names the argument at
// fault, and for what the engine refuses whatever the points are. Positionals are counted; whether required options are
// there is for the command to say.
Outcome parse_options(const std::vector<std::string>& arguments, Options* options);

// Whether --json is among the arguments, also where they cannot be parsed.
bool asks_for_json(const std::vector<std::string>& arguments);

// The effect of one option of options->command on *options: a complaint, or empty.
std::string apply_option(Options* options, const std::string& name, const std::string& value);
// What the words of the command line that the engine does not know say together.
Outcome check_together(const Options& options);

// Whether the diagram is made in pieces.
inline bool goes_by_pieces(const Options& options) { return options.pieces > 0 || options.pieces_auto; }

bool was_given(const Options& options, const std::string& name);
// The option that a field of the library's requests comes from, as the user wrote it: "--k 15". Its name alone when it
// was not given, nothing when the field comes from no option.
std::string option_of(const Options& options, netmesh_field field);

// --eps of mesh, size and check is a size of cells, until it turns out to be what a filter promises.
bool is_of_eps(const Options& options);
void take_eps_as_goal(Options* options);

// What a diagram is of, as far as it is known.
inline FilterChoice choice_of(const Options& options) { return choice_of(options.request); }
inline netmesh_filter_id filter_of(const Options& options) { return choice_of(options).filter; }

const char* command_name(Command command);
// What --help prints, for the program (Command::none) or one command.
std::string help_text(Command command);
std::string version_text();

}  // namespace netmesh::tool
