#include "tools/options.hpp"

#include <cmath>

#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

namespace {

constexpr unsigned bit(Command command) { return 1u << static_cast<unsigned>(command); }
constexpr unsigned mesh = bit(Command::mesh), delaunay = bit(Command::delaunay), persist = bit(Command::persist);
constexpr unsigned size = bit(Command::size), check = bit(Command::check), sample = bit(Command::sample);
constexpr unsigned homology = bit(Command::homology), distance = bit(Command::distance);
constexpr unsigned vineyard = bit(Command::vineyard);
constexpr unsigned engine = mesh | delaunay | persist;

struct CommandEntry {
    Command command;
    const char* name;
    const char* positional;  // the names of all, null for none
    std::size_t positional_count;
    const char* summary;
    const char* details;
};

constexpr CommandEntry commands[] = {
    {Command::mesh, "mesh", "POINTS", 1, "quality mesh",
     "Every vertex but the boundary's gets a Voronoi cell whose aspect ratio, clipped to the domain, is at most "
     "tau.\n"},
    {Command::delaunay, "delaunay", "POINTS", 1, "Delaunay triangulation", ""},
    {Command::persist, "persist", "POINTS", 1, "persistence diagram",
     "Prints lines `degree birth death`, radii, inf for the essential class.\n"},
    {Command::homology, "homology", "FILE", 1, "persistent homology of a filtered complex",
     "One simplex a line: its vertices, whole numbers from 0, then the value at which it enters: `3 1 4 0.5` is a\n"
     "triangle. Any order; # starts a comment. Every face must be listed and enter no later. Prints `degree birth death`;\n"
     "the bars that never die are the Betti numbers.\n"},
    {Command::distance, "distance", "A.pers B.pers", 2, "bottleneck distance between two diagrams",
     "Prints a line `degree distance` for every degree of either diagram, inf where the numbers of essential classes "
     "differ.\n"},
    {Command::vineyard, "vineyard", "POINTS", 1, "diagrams of d_k for a range of k, and their vines",
     "One mesh for all k. Prints lines `vine degree k birth death` behind comments with the certified ratio of each k; a "
     "vine\nfollows one class from k to k.\n"},
    {Command::size, "size", nullptr, 0, "bytes of memory to plan for",
     "One integer: enough for N uniform points, an estimate for others. Without --filter it covers mesh and "
     "persist.\n"},
    {Command::check, "check", "MESH.node | DIAGRAM.pers | FILE.vines", 1, "recompute every certificate from the files alone",
     "MESH.node is read with its .ele and .neigh; --points says which inputs it must hold. A diagram, with its bounds\n"
     "where it has any, or a vineyard is recomputed from --points or --mesh; alone, it is only looked at for what every\n"
     "diagram must satisfy.\n"},
    {Command::sample, "sample", "SHAPE", 1, "point sets by formula", nullptr},
};

using Apply = std::string (*)(Options&, const std::string&);  // a complaint, or empty

std::string apply_tau(Options& options, const std::string& text) {
    double tau;
    if (!parse_finite(text, &tau) || !(tau > 2)) return "must be a finite number above 2";
    options.tau = tau;
    return {};
}

std::string apply_eps(Options& options, const std::string& text) {
    return parse_finite(text, &options.eps) && options.eps > 0 ? "" : "must be a finite number above 0";
}

std::string apply_theta(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.theta) && options.theta > 0 && options.theta <= 1.0 / 9;
    return good ? "" : "must be a number above 0 and at most 1/9";
}

std::string apply_ratio(Options& options, const std::string& text) {
    double ratio;
    if (!parse_finite(text, &ratio) || !(ratio * ratio > 2)) return "must be a finite number above the root of 2";
    options.ratio = ratio;
    return {};
}

std::string apply_focus(Options& options, const std::string& text) {
    return parse_finite(text, &options.focus) && options.focus > 1 ? "" : "must be a finite number above 1";
}
std::string apply_from(Options& options, const std::string& text) {
    return parse_finite(text, &options.from) && options.from > 0 ? "" : "must be a finite radius above 0";
}
std::string apply_to(Options& options, const std::string& text) {
    return parse_finite(text, &options.to) && options.to > 0 ? "" : "must be a finite radius above 0";
}

std::string apply_method(Options& options, const std::string& text) {
    for (const netmesh_method method : {NETMESH_METHOD_SVR, NETMESH_METHOD_NETMESH, NETMESH_METHOD_REFINE}) {
        if (text != method_name(method)) continue;
        options.method = method;
        return {};
    }
    return "there are svr, netmesh and refine";
}

std::string apply_filter(Options& options, const std::string& text) {
    for (const netmesh_filter filter :
         {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_BASIC, NETMESH_FILTER_ALPHA, NETMESH_FILTER_KNN,
          NETMESH_FILTER_KDISTANCE, NETMESH_FILTER_TIGHT, NETMESH_FILTER_SCALES, NETMESH_FILTER_RIPS,
          NETMESH_FILTER_CECH, NETMESH_FILTER_BARYCENTRIC_CECH, NETMESH_FILTER_BARYCENTRIC_RIPS}) {
        if (text != filter_name(filter)) continue;
        options.filter = filter;
        return {};
    }
    return "the filters are complete, basic, alpha, knn, kdistance, tight, scales, rips, cech, barycentric-cech and "
           "barycentric-rips";
}

std::string apply_values(Options& options, const std::string& text) {
    if (text != "certified" && text != "thesis") return "there are certified and thesis";
    options.values = text == "thesis" ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED;
    return {};
}

std::string apply_k(Options& options, const std::string& text) {
    const std::size_t dots = options.command == Command::vineyard ? text.find("..") : std::string::npos;
    std::uint64_t first, last;
    const bool good = parse_unsigned(text.substr(0, dots), &first) &&
                      (dots == std::string::npos || parse_unsigned(text.substr(dots + 2), &last));
    if (dots == std::string::npos) last = first;
    if (!good || first == 0 || last < first || last >= 4294967295u) {
        return options.command == Command::vineyard ? "must be a range of numbers of neighbours from 1 on: 1..20"
                                                    : "must be a number of neighbours, 1 or more";
    }
    options.k = static_cast<std::uint32_t>(first);
    if (options.command == Command::vineyard) options.k_last = static_cast<std::uint32_t>(last);
    return {};
}

std::string apply_max_degree(Options& options, const std::string& text) {
    std::uint64_t degree;
    if (!parse_unsigned(text, &degree) || degree > 1000) return "must be a degree: 0, 1, 2, ...";
    options.max_degree = static_cast<std::uint32_t>(degree);
    return {};
}

std::string apply_memory(Options& options, const std::string& text) {
    const std::string complaint = "must be a size above 0: 65536, 64K, 512M, 2G";
    std::string digits = text;
    int shift = 0;
    if (!digits.empty()) {
        const std::string units = "KMGT";
        const char last = digits.back();
        const std::size_t unit = units.find(last >= 'a' && last <= 'z' ? static_cast<char>(last - 'a' + 'A') : last);
        if (unit != std::string::npos) {
            shift = 10 * (static_cast<int>(unit) + 1);
            digits.pop_back();
        }
    }
    std::uint64_t number;
    if (!parse_unsigned(digits, &number) || number == 0 || number > (SIZE_MAX >> shift)) return complaint;
    options.memory_bytes = static_cast<std::size_t>(number << shift);
    return {};
}

std::string apply_seed(Options& options, const std::string& text) {
    return parse_unsigned(text, &options.seed) ? "" : "must be a whole number from 0 to 2^64 - 1";
}

std::string apply_dim(Options& options, const std::string& text) {
    std::uint64_t dim;
    if (!parse_unsigned(text, &dim) || dim < dim_min || dim > dim_max) return "must be a dimension from 2 to 6";
    options.dim = static_cast<std::uint32_t>(dim);
    return {};
}

std::string apply_count(Options& options, const std::string& text) {
    if (parse_unsigned(text, &options.point_count) && options.point_count > 0 && options.point_count < 4294967296u) {
        return {};
    }
    return "must be a number of points, 1 or more";
}

std::string apply_noise(Options& options, const std::string& text) {
    if (parse_finite(text, &options.noise) && options.noise >= 0) return {};
    return "must be a finite number, 0 or more";
}

std::string apply_turns(Options& options, const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos && parse_unsigned(text.substr(0, comma), &options.turns[0]) &&
        parse_unsigned(text.substr(comma + 1), &options.turns[1]) && options.turns[0] <= 1000000 &&
        options.turns[1] <= 1000000) {
        return {};
    }
    return "must be two whole numbers: 1,10";
}

std::string apply_out(Options& options, const std::string& text) {
    options.out = text == "-" ? "" : text;
    return text.empty() ? "must be a file name" : "";
}
std::string apply_svg(Options& options, const std::string& text) {
    options.svg = text;
    return text.empty() ? "must be a file name" : "";
}
std::string apply_representatives(Options& options, const std::string& text) {
    options.representatives = text;
    return text.empty() ? "must be a file name" : "";
}
std::string apply_mesh_out(Options& options, const std::string& text) {
    options.mesh_out = text;
    return text.empty() ? "must be a file name" : "";
}
std::string apply_points_path(Options& options, const std::string& text) {
    options.points_path = text;
    return text.empty() ? "must be a file name" : "";
}
std::string apply_mesh_path(Options& options, const std::string& text) {
    options.mesh_path = text;
    return text.empty() ? "must be a file name" : "";
}
std::string apply_json(Options& options, const std::string&) { return options.json = true, ""; }
std::string apply_analyse(Options& options, const std::string&) { return options.analyse = true, ""; }
std::string apply_check(Options& options, const std::string&) { return options.check = true, ""; }
std::string apply_audit(Options& options, const std::string& value) {
    constexpr std::pair<const char*, unsigned> names[] = {{"location", NETMESH_AUDIT_LOCATION},
                                                          {"quality", NETMESH_AUDIT_QUALITY},
                                                          {"all", NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY}};
    for (const auto& [name, what] : names)
        if (value == name) return options.audit = what, "";
    return "not location, quality or all";
}
std::string apply_finish(Options& options, const std::string&) { return options.finish = true, ""; }
std::string apply_fit(Options& options, const std::string&) { return options.fit = true, ""; }
std::string apply_all(Options& options, const std::string&) { return options.all = true, ""; }
std::string apply_log(Options& options, const std::string&) { return options.log = true, ""; }
std::string apply_bounds(Options& options, const std::string&) { return options.bounds = true, ""; }
std::string apply_quiet(Options& options, const std::string&) { return options.quiet = true, ""; }

struct OptionEntry {
    const char* name;
    unsigned commands;
    const char* value;  // how the help calls the value; null for a switch
    Apply apply;
    const char* help;
};

constexpr OptionEntry option_entries[] = {
    {"-o", mesh | delaunay, "OUT", apply_out,
     ".node (with .ele and .neigh), .vtu (D = 2, 3) or .off; without it OFF on stdout"},
    {"-o", persist | homology, "OUT.pers", apply_out, "the diagram; without it on stdout"},
    {"-o", vineyard, "OUT.vines", apply_out, "the vines; without it on stdout"},
    {"-o", sample, "OUT", apply_out, ".txt .xyz .csv or .npy; without it text on stdout"},
    {"-n", sample, "N", apply_count, "number of points"},
    {"--dim", size | sample, "D", apply_dim, "dimension, 2 to 6"},
    {"--points", size, "N", apply_count, "number of points"},
    {"--points", check, "FILE", apply_points_path, "the points that the mesh, diagram or vineyard was made of"},
    {"--mesh", check, "MESH.node", apply_mesh_path, "the mesh that the diagram or vineyard was made of"},
    {"--mesh", persist, "MESH.node", apply_mesh_out, "also write the mesh that is filtered, with the filter's values"},
    {"--tau", mesh | persist | vineyard | size | check, "T", apply_tau,
     "bound on the aspect ratio of Voronoi cells, above 2 (2.5 for D = 2, 3; 3.08; 4 for D = 5, 6)"},
    {"--eps", mesh | size | check, "E", apply_eps,
     "also refine until no cell reaches farther than E times the distance to the second nearest input"},
    {"--eps", persist, "E", apply_eps,
     "log distance that tight promises, above 0 and at most 1/2 (1/2); scales: 3 theta more"},
    {"--theta", persist | size | check, "T", apply_theta,
     "how medial points of one scale are, above 0 and at most 1/9 (1/9)"},
    {"--ratio", persist | check, "C", apply_ratio,
     "refine by the certificate until this ratio is certified, above 1.4142 (sqrt(2 + tau)); complete filter only"},
    {"--focus", persist | check, "C", apply_focus,
     "certify this ratio, above 1, of what matters to radii --from to --to"},
    {"--from", persist | check, "A", apply_from, "least radius of interest"},
    {"--to", persist | check, "B", apply_to, "largest radius of interest"},
    {"--fit", persist, nullptr, apply_fit,
     "the least ratio that fits in --memory, of the radii --from to --to if given; --ratio C is where it begins (4)"},
    {"--method", persist, "M", apply_method,
     "of a quality mesh to filter, in place of refinement by the certificate: svr, netmesh with --finish, refine"},
    {"--method", mesh | size, "M", apply_method,
     "svr (default); netmesh: hierarchical, of linear size whatever the points' spread; refine: the thesis's 3.2"},
    {"--finish", mesh | persist | size, nullptr, apply_finish,
     "go on from a hierarchical mesh to one of quality tau without cages"},
    {"--audit", mesh | size, "WHAT", apply_audit,
     "location: points stored in all D-balls, inserted in rounds of range nets; quality: invariants measured after each\n"
     "                    insertion, for small runs; or all. Figures go to the report"},
    {"--filter", vineyard, "F", apply_filter, "knn (default) or kdistance"},
    {"--filter", persist | size | check, "F", apply_filter,
     "complete (default), basic, tight, scales, alpha, knn or kdistance; of few points rips, cech, barycentric-cech or\n"
     "                    barycentric-rips"},
    {"--k", persist | size | check, "K", apply_k,
     "neighbours of knn and kdistance, the point itself counted (1); kdistance is their root mean square; points in\n"
     "                    every set of a barycentric filter, at least"},
    {"--values", persist | vineyard | size | check, "V", apply_values,
     "certified (default) or thesis: the filter's own"},
    {"--k", vineyard, "A..B", apply_k, "the numbers of neighbours, the point itself counted"},
    {"--max-degree", persist | vineyard | size | check, "P", apply_max_degree,
     "highest homology degree (D-1; 1 for rips, cech and barycentric filters)"},
    {"--max-degree", homology, "P", apply_max_degree, "highest homology degree (the dimension of the complex)"},
    {"--representatives", persist | homology, "FILE", apply_representatives,
     "a cycle for each bar: a line `bar DEGREE BIRTH DEATH N`, then N simplices, one a line"},
    {"--memory", engine | vineyard | homology | size | check, "SIZE", apply_memory,
     "the block that the engine works in: 64K, 512M, 2G; reserved lazily until the job fits if not given"},
    {"--seed", engine | vineyard | size | check | sample, "S", apply_seed, "of every random choice (1)"},
    {"--noise", sample, "X", apply_noise, "standard deviation of a normal offset of every coordinate (0)"},
    {"--turns", sample, "A,B", apply_turns, "of the Clifford winding about its two circles (1,10)"},
    {"--svg", mesh | delaunay, "FILE", apply_svg, "picture of a mesh in the plane"},
    {"--svg", persist | homology, "FILE", apply_svg, "picture of barcode and diagram"},
    {"--svg", vineyard, "FILE", apply_svg, "picture of the vines, k against radius"},
    {"--analyse", mesh | delaunay, nullptr, apply_analyse,
     "report degrees, ply and fatness of the result and, for a mesh, bounds on its size"},
    {"--log", distance, nullptr, apply_log,
     "distance of natural logarithms; births at 0 are matched to births at 0 alone"},
    {"--check", engine | vineyard, nullptr, apply_check, "run the independent checkers on the result"},
    {"--check", homology, nullptr, apply_check, "check that each cycle is one, and born with its bar"},
    {"--bounds", persist, nullptr, apply_bounds,
     "where each birth and death surely is and which bars surely are real, behind the bars, and the certified ratio by\n"
     "                    scale, in front of them; both in JSON and in the picture"},
    {"--all", persist | homology | size | check, nullptr, apply_all, "keep bars of length zero"},
    {"--json", engine | vineyard | homology | distance | size | check, nullptr, apply_json,
     "report as JSON on stdout; data then goes to -o only, but bars without -o stand in the JSON"},
    {"--quiet", engine | vineyard | homology | distance | size | check | sample, nullptr, apply_quiet,
     "no progress, no summary"},
};

const CommandEntry* find_command(const std::string& name) {
    for (const CommandEntry& entry : commands) {
        if (name == entry.name) return &entry;
    }
    return nullptr;
}

const CommandEntry& entry_of(Command command) {
    for (const CommandEntry& entry : commands) {
        if (entry.command == command) return entry;
    }
    return commands[0];
}

Outcome find_option(const std::string& name, Command command, const OptionEntry** found) {
    bool elsewhere = false;
    for (const OptionEntry& entry : option_entries) {
        if (name != entry.name) continue;
        elsewhere = true;
        if ((entry.commands & bit(command)) == 0) continue;
        *found = &entry;
        return {};
    }
    if (elsewhere) return usage_error("option " + name + " does not apply to " + command_name(command));
    return usage_error("unknown option " + name + "; `netmesh " + command_name(command) + " --help` lists them");
}

// One option with its value, at arguments[*at]; steps *at over both.
Outcome parse_option(const std::vector<std::string>& arguments, std::size_t* at, Options* options) {
    std::string name = arguments[(*at)++], value;
    const std::size_t equals = name.rfind("--", 0) == 0 ? name.find('=') : std::string::npos;
    const bool attached = equals != std::string::npos;
    if (attached) {
        value = name.substr(equals + 1);
        name.resize(equals);
    }
    const OptionEntry* entry = nullptr;
    const Outcome outcome = find_option(name, options->command, &entry);
    if (!outcome.good()) return outcome;
    if (entry->value == nullptr) {
        if (attached) return usage_error("option " + name + " takes no value");
    } else if (!attached) {
        if (*at == arguments.size()) return usage_error("option " + name + " needs a value: " + entry->value);
        value = arguments[(*at)++];
    }
    const std::string complaint = entry->apply(*options, value);
    if (complaint.empty()) return {};
    return usage_error(name + " " + value + ": " + complaint);
}

// Finds the command, --help and --version; the other arguments go to *rest. The command is the first argument, or, when
// options come before it, the first one that is the name of a command.
Outcome take_command(const std::vector<std::string>& arguments, Options* options, std::vector<std::string>* rest) {
    const CommandEntry* command = nullptr;
    bool only_positionals = false;
    for (const std::string& argument : arguments) {
        only_positionals = only_positionals || argument == "--";
        const bool may_be_command = command == nullptr && !only_positionals;
        const CommandEntry* const found = may_be_command ? find_command(argument) : nullptr;
        if (found != nullptr) {
            command = found;
        } else if (rest->empty() && may_be_command && argument.rfind('-', 0) != 0) {
            return usage_error("unknown command '" + argument + "'; `netmesh --help` lists them");
        } else if (!only_positionals && (argument == "--help" || argument == "-h")) {
            options->help = true;
        } else if (may_be_command && rest->empty() && argument == "--version") {
            options->version = true;
            return {};
        } else {
            rest->push_back(argument);
        }
    }
    if (command != nullptr) options->command = command->command;
    if (options->help || command != nullptr) return {};
    if (rest->empty()) return usage_error("no command; `netmesh --help` lists them");
    return usage_error("unknown option " + rest->front() + " and no command; `netmesh --help` lists them");
}

}  // namespace

Outcome parse_options(const std::vector<std::string>& arguments, Options* options) {
    *options = {};
    std::vector<std::string> rest;
    const Outcome outcome = take_command(arguments, options, &rest);
    if (!outcome.good() || options->help || options->version) return outcome;
    std::size_t at = 0;
    bool only_positionals = false;
    while (at < rest.size()) {
        const std::string& argument = rest[at];
        if (!only_positionals && argument == "--") {
            only_positionals = true;
            at++;
        } else if (only_positionals || argument.size() < 2 || argument[0] != '-') {
            options->positionals.push_back(rest[at++]);
        } else {
            const Outcome parsed = parse_option(rest, &at, options);
            if (!parsed.good()) return parsed;
        }
    }
    const bool hierarchical = options->method == NETMESH_METHOD_NETMESH;
    if (options->audit != 0 && (options->method == NETMESH_METHOD_REFINE || options->eps > 0))
        return usage_error("--audit goes with --method svr or netmesh, and not with --eps");
    if (options->finish && !hierarchical) return usage_error("--finish goes with --method netmesh");
    if (options->command == Command::persist && hierarchical && !options->finish) {
        return usage_error("--method netmesh leaves cages, which have no filter; --finish removes them");
    }
    const CommandEntry& command = entry_of(options->command);
    const std::size_t due = command.positional_count;
    bool empty = options->positionals.size() < due;
    for (std::size_t i = 0; i < due && !empty; i++) empty = options->positionals[i].empty();
    if (empty) {
        return usage_error(std::string(command.name) + " needs " + command.positional);
    }
    if (options->positionals.size() > due) {
        return usage_error("unexpected argument " + options->positionals[due] + " after " + command.name);
    }
    return {};
}

const char* command_name(Command command) { return command == Command::none ? "" : entry_of(command).name; }

const char* method_name(netmesh_method method) {
    switch (method) {
    case NETMESH_METHOD_NETMESH: return "netmesh";
    case NETMESH_METHOD_REFINE: return "refine";
    default: return "svr";
    }
}

bool refines_by_certificate(const Options& options) {
    return options.command == Command::persist && !options.method && !options.finish &&
           options.filter.value_or(NETMESH_FILTER_COMPLETE) == NETMESH_FILTER_COMPLETE &&
           options.values.value_or(NETMESH_VALUES_CERTIFIED) == NETMESH_VALUES_CERTIFIED;
}

Outcome check_ratio(const Options& options) {
    const bool focused = options.focus > 0 || options.from > 0 || options.to > 0;
    if (options.command == Command::persist && (options.ratio || focused || options.fit) &&
        !refines_by_certificate(options)) {
        return usage_error(
            "--ratio, --focus and --fit are for the complete filter with certified values, without --method");
    }
    if (options.fit && options.memory_bytes == 0) return usage_error("--fit needs --memory, the size to fit in");
    if (options.fit && options.focus > 0) return usage_error("--focus is what --fit finds");
    if (options.fit && focused && !(options.from > 0 && options.to > options.from)) {
        return usage_error("--from A and --to B belong together, A below B");
    }
    if (!focused || options.fit) return {};
    if (!(options.focus > 0 && options.from > 0 && options.to > options.from)) {
        return usage_error("--focus C, --from A and --to B belong together, A below B");
    }
    return {};
}

bool promises_accuracy(const Options& options) {
    return options.filter == NETMESH_FILTER_TIGHT || options.filter == NETMESH_FILTER_SCALES;
}

Outcome check_accuracy(const Options& options) {
    if (options.theta > 0 && options.filter != NETMESH_FILTER_SCALES)
        return usage_error("--theta goes with --filter scales");
    if (promises_accuracy(options)) {
        return options.eps <= 0.5 ? Outcome{} : usage_error("--eps must be at most 1/2 for tight and scales");
    }
    if (options.eps > 0 && options.command == Command::persist) {
        return usage_error("--eps goes with --filter tight or scales");
    }
    return {};
}

const char* filter_name(netmesh_filter filter) {
    switch (filter) {
    case NETMESH_FILTER_COMPLETE: return "complete";
    case NETMESH_FILTER_BASIC: return "basic";
    case NETMESH_FILTER_ALPHA: return "alpha";
    case NETMESH_FILTER_RIPS: return "rips";
    case NETMESH_FILTER_CECH: return "cech";
    case NETMESH_FILTER_BARYCENTRIC_CECH: return "barycentric-cech";
    case NETMESH_FILTER_BARYCENTRIC_RIPS: return "barycentric-rips";
    case NETMESH_FILTER_KNN: return "knn";
    case NETMESH_FILTER_KDISTANCE: return "kdistance";
    case NETMESH_FILTER_TIGHT: return "tight";
    case NETMESH_FILTER_SCALES: return "scales";
    default: return "none";
    }
}

std::string reference_name(const netmesh_report& report) {
    const std::string space = " in R^" + std::to_string(report.dim), k = std::to_string(report.k);
    if (report.filter == NETMESH_FILTER_KNN) return "sublevel sets of d_" + k + space;
    if (report.filter == NETMESH_FILTER_KDISTANCE) return "sublevel sets of the k-distance, k = " + k + "," + space;
    switch (report.filter) {
    case NETMESH_FILTER_RIPS: return "Vietoris-Rips complex of the points, edges at half their length";
    case NETMESH_FILTER_BARYCENTRIC_CECH:
    case NETMESH_FILTER_BARYCENTRIC_RIPS: return "sublevel sets of d_" + k + space;
    default: return report.dim == 0 ? "filtered complex" : "closed offsets of the points" + space;
    }
}

const char* values_name(netmesh_values values) { return values == NETMESH_VALUES_THESIS ? "thesis" : "certified"; }

bool is_barycentric(netmesh_filter filter) {
    return filter == NETMESH_FILTER_BARYCENTRIC_CECH || filter == NETMESH_FILTER_BARYCENTRIC_RIPS;
}

bool is_points_filter(netmesh_filter filter) {
    return filter == NETMESH_FILTER_RIPS || filter == NETMESH_FILTER_CECH || is_barycentric(filter);
}

std::uint32_t max_degree_of(const Options& options, std::uint32_t dim) {
    return options.max_degree.value_or(options.filter && is_points_filter(*options.filter) ? 1 : dim - 1);
}

std::string version_text() {
    return "netmesh " + std::to_string(NETMESH_VERSION_MAJOR) + "." + std::to_string(NETMESH_VERSION_MINOR) + "." +
           std::to_string(NETMESH_VERSION_PATCH) + "\n";
}

namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(text.size() + 2 > width ? text.size() + 2 : width, ' ');
    return text;
}

std::string program_help() {
    std::string text = "netmesh: quality meshes and certified persistent homology of point clouds in R^2 .. R^6\n\n";
    for (const CommandEntry& entry : commands) {
        std::string usage = std::string("  netmesh ") + entry.name + " ";
        usage += entry.positional == nullptr ? "--dim D --points N" : entry.positional;
        if (entry.command == Command::sample) usage += " -n N";
        text += padded(usage, 43) + entry.summary + "\n";
    }
    text +=
        "  netmesh COMMAND --help\n  netmesh --version\n\n"
        "POINTS is a text file with one point a line (blanks, tabs, commas or semicolons between coordinates, # for\n"
        "comments, - for stdin), or a .npy, .off, .ply or .node file. Data goes to stdout or to the file of -o, "
        "messages\n"
        "to stderr. Files appear whole or not at all.\n\n"
        "Exit: 0 done, 1 internal error, 2 usage, 3 bad data or file, 4 memory too small, 5 degenerate input refused,\n"
        "6 cancelled, 7 check failed.\n";
    return text;
}

}  // namespace

std::string help_text(Command command) {
    if (command == Command::none) return program_help();
    const CommandEntry& entry = entry_of(command);
    std::string text = std::string("netmesh ") + entry.name;
    if (entry.positional != nullptr) text += std::string(" ") + entry.positional;
    text += std::string(" [OPTION]...\n\n") + entry.summary + "\n";
    text += command == Command::sample ? "\nshapes:\n" + shapes_help() : std::string(entry.details);
    text += "\noptions:\n";
    for (const OptionEntry& option : option_entries) {
        if ((option.commands & bit(command)) == 0) continue;
        std::string usage = std::string("  ") + option.name;
        if (option.value != nullptr) usage += std::string(" ") + option.value;
        text += padded(usage, 20) + option.help + "\n";
    }
    return text + padded("  --help", 20) + "this text\n";
}

}  // namespace netmesh::tool
