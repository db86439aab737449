#include "tools/options.hpp"

#include <algorithm>

#include "tools/asked_function.hpp"
#include "tools/closest.hpp"
#include "tools/engine_options.hpp"
#include "tools/option_table.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

const CommandEntry* find_command(const std::string& name) {
    for (const CommandEntry& entry : command_entries()) {
        if (name == entry.name) return &entry;
    }
    return nullptr;
}

Outcome find_option(const std::string& name, Command command, const OptionEntry** found) {
    bool elsewhere = false;
    for (const OptionEntry& entry : option_entries()) {
        if (name != entry.name) continue;
        elsewhere = true;
        if ((entry.commands & bit(command)) == 0) continue;
        *found = &entry;
        return {};
    }
    const bool of_periods = name == "--box" || name == "--cell";
    if (elsewhere)
        return usage_error("option " + name + " does not apply to " + command_name(command) +
                           (of_periods ? "; points repeat for persist alone" : ""));
    std::vector<std::string> names;
    for (const OptionEntry& entry : option_entries())
        if ((entry.commands & bit(command)) != 0) names.emplace_back(entry.name);
    return usage_error("unknown option " + name + did_you_mean(name, names) + "; `netmesh " + command_name(command) +
                       " --help` lists them");
}

// Words of the engine's that the command line does not offer are none.
std::string apply(const OptionEntry& entry, const std::string& value, Options* options) {
    if (entry.effect.member == nullptr) return entry.effect.apply(*options, value);
    const std::vector<std::string> words = words_of(entry, options->command);
    if (words.empty() || std::find(words.begin(), words.end(), value) != words.end())
        return set_option(&options->request, entry.effect.member, value);
    std::string text;
    for (std::size_t i = 0; i < words.size(); i++)
        text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
    return "there are " + text;
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
    if (name == "-q") name = "--quiet";
    const OptionEntry* entry = nullptr;
    const Outcome outcome = find_option(name, options->command, &entry);
    if (!outcome.good()) return outcome;
    if (entry->value == nullptr) {
        if (attached) return usage_error("option " + name + " takes no value");
    } else if (!attached) {
        if (*at == arguments.size()) return usage_error("option " + name + " needs a value: " + entry->value);
        value = arguments[(*at)++];
    }
    const std::string complaint = apply(*entry, value, options);
    options->given.emplace_back(name, value);
    if (complaint.empty()) return {};
    return usage_error(name + " " + value + ": " + complaint + did_you_mean(value, words_of(*entry, options->command)));
}

Outcome unknown_command(const std::string& name) {
    std::vector<std::string> names = {"help"};
    for (const CommandEntry& entry : command_entries()) names.emplace_back(entry.name);
    return usage_error("unknown command '" + name + "'" + did_you_mean(name, names) + "; `netmesh --help` lists them");
}

// help, help COMMAND; --completion SHELL; --manual, --manual COMMAND.
Outcome take_words(const std::vector<std::string>& arguments, Options* options, bool* taken) {
    *taken =
        !arguments.empty() && (arguments[0] == "help" || arguments[0] == "--completion" || arguments[0] == "--manual");
    if (!*taken) return {};
    std::vector<std::string> rest;
    for (std::size_t i = 1; i < arguments.size(); i++)
        if (arguments[i] != "--json") rest.push_back(arguments[i]);
    if (arguments[0] == "--completion") {
        if (rest.size() == 1 && (rest[0] == "bash" || rest[0] == "zsh"))
            return options->completion = rest[0], Outcome{};
        return usage_error("--completion takes bash or zsh");
    }
    (arguments[0] == "help" ? options->help : options->manual) = true;
    if (rest.size() > 1) return usage_error(arguments[0] + " takes one command; unexpected argument " + rest[1]);
    const CommandEntry* const command = rest.empty() ? nullptr : find_command(rest[0]);
    if (command != nullptr) options->command = command->command;
    return rest.empty() || command != nullptr ? Outcome{} : unknown_command(rest[0]);
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
            return unknown_command(argument);
        } else if (!only_positionals && (argument == "--help" || argument == "-h")) {
            options->help = true;
        } else if (may_be_command && rest->empty() && (argument == "--version" || argument == "-V")) {
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

Outcome check_positionals(const Options& options) {
    const CommandEntry& command = entry_of(options.command);
    const std::size_t due = command.positional_count;
    bool empty = options.positionals.size() < due;
    for (std::size_t i = 0; i < due && !empty; i++) empty = options.positionals[i].empty();
    if (empty) return usage_error(std::string(command.name) + " needs " + command.positional);
    const Command c = options.command;
    const bool several = c == Command::mesh || c == Command::delaunay || c == Command::persist;
    if (several && std::find(options.positionals.begin(), options.positionals.end(), "") != options.positionals.end())
        return usage_error("an empty name of a file");
    if (c == Command::pieces) return {};  // as many as each of its tasks has
    if (!several && options.positionals.size() > due)
        return usage_error("unexpected argument " + options.positionals[due] + " after " + command.name);
    return {};
}

// What words of the tool's own stand for. Without --filter, or with --filter auto, the choice is the engine's unless an
// option asks for a mesh.
void complete(Options* options) {
    netmesh_request& r = options->request;
    if (options->cages == "thesis") r.mesh.method = &netmesh_method_thesis;
    if (options->focus_auto) {
        r.fit = &netmesh_fit;
        r.bounds = &netmesh_bounds;
        if (r.goal.longer_than == 0) r.goal.longer_than = default_longer_than;
    }
    if (options->distances && r.filter == nullptr) r.filter = &netmesh_filter_rips;
    const bool is_left_open = r.filter == nullptr || r.filter == &netmesh_filter_auto;
    const bool asks_for_alpha = goes_by_pieces(*options) || !options->proof.empty();
    if (options->command == Command::pieces || (asks_for_alpha && is_left_open)) r.filter = &netmesh_filter_alpha;
    if (options->command == Command::vineyard && r.filter == nullptr) r.filter = &netmesh_filter_knn;
    const bool is_open = options->command == Command::persist || options->command == Command::size;
    if (is_open && (r.filter == nullptr || r.filter == &netmesh_filter_auto)) {
        r.filter = &netmesh_filter_auto;
        options->implies_mesh = option_against_auto(*options);
        // Weights and periods are alpha's, which says itself what is not wanted of it.
        const bool is_alpha = !options->table.weights.empty() || options->table.lattice.kind != Lattice::none;
        for (const char* const want : {"--bounds", "--representatives"})
            if (is_alpha && options->implies_mesh.rfind(want, 0) == 0) options->implies_mesh.clear();
        if (!options->implies_mesh.empty()) r.filter = &netmesh_filter_complete;
    }
    if (options->command == Command::size && is_of_eps(*options)) take_eps_as_goal(options);
}

// What the engine refuses whatever the points are. Files say what check is of, and complexes bring their own.
Outcome check_request(const Options& given) {
    Options options = given;
    const Command command = options.command;
    const bool is_of_points = command <= Command::persist || command == Command::size ||
                              (command == Command::vineyard && options.values_path.empty());
    const std::uint32_t dim = options.dim != 0 ? options.dim : NETMESH_DIM_MIN;
    netmesh_request settled;
    if (command == Command::size && !options.implies_mesh.empty()) {  // of any mesh, and of a diagram
        options.request.mesh = {};
        const Outcome outcome = settle(options, dim, &settled);
        if (!outcome.good()) return outcome;
        options = given;
        options.command = Command::mesh;
        options.request.filter = nullptr;
    }
    return is_of_points ? settle(options, dim, &settled) : Outcome{};
}

using Names = std::initializer_list<const char*>;

// What persist takes beside --pieces and beside --proof; any other option is refused there.
constexpr Names beside_both = {"-o",       "--columns",    "--delimiter", "--skip",   "--drop-missing",
                               "--filter", "--max-degree", "--seed",      "--memory", "--svg",
                               "--axis",   "--json",       "--quiet",     "--jobs"};
constexpr Names beside_pieces = {"--pieces", "--scratch", "--all", "--least", "--min-persistence", "--top"};
constexpr Names beside_proof = {"--proof", "--bounds",  "--check",   "--distances", "--sparse",         "--threshold",
                                "--radii", "--weights", "--squares", "--mesh",      "--representatives"};

Outcome refuse_all_but(const Options& options, Names taken, const std::string& why) {
    const auto has = [](Names names, const std::string& name) {
        return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
    };
    for (const auto& given : options.given)
        if (!has(taken, given.first) && !has(beside_both, given.first))
            return usage_error(given.first + " does not go with " + why);
    return {};
}

}  // namespace

std::string apply_option(Options* options, const std::string& name, const std::string& value) {
    const OptionEntry* entry = nullptr;
    const Outcome outcome = find_option(name, options->command, &entry);
    if (!outcome.good()) return outcome.message;
    if (entry->value == nullptr && !value.empty()) return "takes no value";
    return apply(*entry, value, options);
}

Outcome check_together(const Options& options) {
    const netmesh_request& r = options.request;
    const bool hierarchical = r.mesh.method == &netmesh_method_netmesh || r.mesh.method == &netmesh_method_thesis;
    if (!options.weighted_path.empty() && (!hierarchical || r.mesh.finish != 0))
        return usage_error("--weighted-cells goes with --method netmesh, without --finish, which removes cages");
    if (options.pace_theta > 0 && options.pace_path.empty()) return usage_error("--theta goes with --pace");
    if (options.command == Command::persist && !was_given(options, "--filter") && was_given(options, "--k"))
        return usage_error("--k is of the distance to the k-th nearest point: --filter knn or kdistance");
    if (options.order > 0 && options.log) return usage_error("--log goes with the bottleneck distance alone");
    if (options.relative_error > 0 && options.order == 0)
        return usage_error("--error goes with --wasserstein; the bottleneck distance is exact");
    if (options.command == Command::persist && !goes_by_pieces(options)) {
        if (!options.scratch.empty()) return usage_error("--scratch goes with --pieces");
        if (options.jobs > 0 && options.positionals.size() < 2)
            return usage_error("--jobs goes with --pieces, or with several POINTS");
    }
    if (options.command == Command::persist && goes_by_pieces(options)) {
        if (r.filter != &netmesh_filter_alpha)
            return usage_error("--pieces is of filter alpha alone, not of " +
                               std::string(filter_name(filter_of(options))));
        // Weights and lattices are said with their values below.
        const bool is_of_points = options.table.weights.empty() && options.table.lattice.kind == Lattice::none;
        if (is_of_points) {
            const Outcome outcome = refuse_all_but(options, beside_pieces, "--pieces, which keep bars alone");
            if (!outcome.good()) return outcome;
        }
    }
    if (!options.proof.empty()) {
        const bool has_proofs = options.command == Command::homology || r.filter == &netmesh_filter_alpha ||
                                r.filter == &netmesh_filter_rips || r.filter == &netmesh_filter_cech;
        if (!has_proofs)
            return usage_error("--proof is of filters alpha, rips and cech, not of " +
                               std::string(filter_name(filter_of(options))) +
                               "; `netmesh check` looks at its diagrams");
        for (const char* const name : {"--all", "--least", "--min-persistence", "--top"})
            if (was_given(options, name))
                return usage_error("--proof does not go with " + std::string(name) +
                                   ": it proves all bars, and no other");
        if (options.table.lattice.kind != Lattice::none)
            return usage_error("--proof does not go with " + std::string(options.table.lattice.option()) +
                               ": there are no such proofs yet");
        if (options.command == Command::persist) {
            const Outcome outcome = refuse_all_but(options, beside_proof, "--proof");
            if (!outcome.good()) return outcome;
        }
    }
    if (!options.table.weights.empty() && goes_by_pieces(options))
        return usage_error(weights_option(options.table) + " does not go with --pieces, which are of points alone");
    const Lattice& lattice = options.table.lattice;
    if (lattice.kind != Lattice::none && goes_by_pieces(options))
        return usage_error(std::string(lattice.option()) + " does not go with --pieces, which are of points alone");
    if (lattice.kind != Lattice::none && options.check)
        return usage_error("--check does not go with " + std::string(lattice.option()) +
                           ": there is no second opinion of points that repeat yet");
    if (options.sparse && !options.distances) return usage_error("--sparse goes with --distances");
    if (r.goal.longer_than > 0 && !options.focus_auto) return usage_error("--longer-than goes with --focus auto");
    if (options.focus_auto && was_given(options, "--fit"))
        return usage_error("--fit finds the best ratio, --focus auto which bars are certified to exist; leave one out");
    const bool fits_error = r.fit != nullptr && r.filter == &netmesh_filter_function;
    if (fits_error && (r.values == NETMESH_VALUES_CERTIFIED || was_given(options, "--method")))
        return usage_error(
            "--fit of a function is of --values thesis, the function's own, whose error is the least, and "
            "makes the mesh itself, without --method");
    if (r.fit != nullptr && options.memory_bytes == 0)
        return usage_error(std::string(options.focus_auto ? "--focus auto" : "--fit") +
                           " needs --memory, the size to fit in");
    return {};
}

Outcome parse_options(const std::vector<std::string>& arguments, Options* options) {
    *options = {};
    std::vector<std::string> rest;
    bool taken = false;
    Outcome outcome = take_words(arguments, options, &taken);
    if (taken) return outcome;
    outcome = take_command(arguments, options, &rest);
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
            outcome = parse_option(rest, &at, options);
            if (!outcome.good()) return outcome;
        }
    }
    // Checked before words are turned into others, so that messages are about what was written.
    const bool has_cages = options->request.mesh.method == &netmesh_method_netmesh;
    if (!options->cages.empty() && !has_cages) return usage_error("--cages goes with --method netmesh");
    complete(options);
    outcome = check_together(*options);
    if (outcome.good() && options->command == Command::persist) outcome = check_function(*options);
    if (outcome.good()) outcome = check_request(*options);
    return outcome.good() ? check_positionals(*options) : outcome;
}

bool asks_for_json(const std::vector<std::string>& arguments) {
    const auto end = std::find(arguments.begin(), arguments.end(), "--");
    return std::find(arguments.begin(), end, "--json") != end;
}

bool was_given(const Options& options, const std::string& name) {
    return std::any_of(options.given.begin(), options.given.end(),
                       [&](const auto& given) { return given.first == name; });
}

std::string option_of(const Options& options, netmesh_field field) {
    if (field == NETMESH_FIELD_METHOD && !options.cages.empty()) return "--cages " + options.cages;
    const std::vector<std::string> names = option_names(field);
    for (const std::string& name : names) {
        const auto is_it = [&](const auto& given) { return given.first == name; };
        const auto last = std::find_if(options.given.rbegin(), options.given.rend(), is_it);
        if (last != options.given.rend()) return last->second.empty() ? name : last->first + " " + last->second;
    }
    return names.empty() ? std::string() : names[0];
}

bool is_of_eps(const Options& options) {
    const netmesh_filter* const filter = options.request.filter;
    return filter != nullptr && about(filter).has_eps != 0;
}

void take_eps_as_goal(Options* options) {
    netmesh_request& r = options->request;
    r.goal.eps = r.mesh.sizes.eps;
    r.mesh.sizes.eps = 0;
}

const char* command_name(Command command) { return command == Command::none ? "" : entry_of(command).name; }

}  // namespace netmesh::tool
