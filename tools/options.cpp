#include "tools/options.hpp"

#include <algorithm>

#include "tools/closest.hpp"
#include "tools/option_table.hpp"

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
    if (elsewhere) return usage_error("option " + name + " does not apply to " + command_name(command));
    std::vector<std::string> names;
    for (const OptionEntry& entry : option_entries())
        if ((entry.commands & bit(command)) != 0) names.emplace_back(entry.name);
    return usage_error("unknown option " + name + did_you_mean(name, names) + "; `netmesh " + command_name(command) +
                       " --help` lists them");
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
    const std::string complaint = entry->apply(*options, value);
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
    if (!several && options.positionals.size() > due)
        return usage_error("unexpected argument " + options.positionals[due] + " after " + command.name);
    return {};
}

Outcome check_audit(const Options& options) {
    if (options.audit == 0) return {};
    if (options.method == NETMESH_METHOD_REFINE) return usage_error("--audit goes with --method svr or netmesh");
    const bool persists = options.command == Command::persist;
    if ((options.audit & NETMESH_AUDIT_LOCATION) != 0 && (persists || options.eps > 0 || options.size_at_inputs > 0))
        return usage_error("--audit location goes with the command mesh, and not with --eps or --cell-size");
    const netmesh_filter_info& filter = about(filter_of(options));
    if (persists &&
        (options.fit || options.focus_auto || filter.source != NETMESH_SOURCE_MESH || filter.has_theta != 0))
        return usage_error("--audit is of one mesh: for filters on a mesh but scales, and not with --fit "
                           "or --focus auto");
    return {};
}

}  // namespace

std::string apply_option(Options* options, const std::string& name, const std::string& value) {
    const OptionEntry* entry = nullptr;
    const Outcome outcome = find_option(name, options->command, &entry);
    if (!outcome.good()) return outcome.message;
    if (entry->value == nullptr && !value.empty()) return "takes no value";
    return entry->apply(*options, value);
}

Outcome check_together(const Options& options) {
    const bool hierarchical = options.method == NETMESH_METHOD_HIERARCHY;
    const Outcome audited = check_audit(options);
    if (!audited.good()) return audited;
    if (hierarchical && !options.finish && (options.eps > 0 || options.size_at_inputs > 0))
        return usage_error("--eps and --cell-size go with --method netmesh only where --finish removes the cages");
    if (options.domain_factor > 0 && options.method == NETMESH_METHOD_REFINE)
        return usage_error("--domain does not go with --method refine, which has the domain of 3.5");
    const bool thesis = options.cages == NETMESH_CAGES_THESIS;
    if (thesis && (options.eps > 0 || options.size_at_inputs > 0))
        return usage_error("--eps and --cell-size do not go with --cages thesis");
    if (options.cages && !hierarchical) return usage_error("--cages goes with --method netmesh");
    if (thesis && (options.audit & NETMESH_AUDIT_LOCATION) != 0)
        return usage_error("--audit location does not go with --cages thesis");
    if (thesis && options.tau && *options.tau < 3.4) return usage_error("--cages thesis needs a --tau of at least 3.4");
    if (thesis && options.dim > 4) return usage_error("--cages thesis is for D = 2, 3 and 4");
    if (options.net_spacing > 0 && options.method != NETMESH_METHOD_REFINE && options.command != Command::check)
        return usage_error("--net goes with --method refine, which has a boundary net");
    if (options.pace_theta > 0 && options.pace_path.empty()) return usage_error("--theta goes with --pace");
    if (!options.weighted_path.empty() && (!hierarchical || options.finish))
        return usage_error("--weighted-cells goes with --method netmesh, without --finish, which removes cages");
    if (options.order > 0 && options.log) return usage_error("--log goes with the bottleneck distance alone");
    if (options.command == Command::distance && options.error > 0 && options.order == 0)
        return usage_error("--error goes with --wasserstein; the bottleneck distance is exact");
    if (options.sparse && !options.distances) return usage_error("--sparse goes with --distances");
    if (options.threshold && !options.distances && options.filter != NETMESH_FILTER_RIPS)
        return usage_error("--threshold goes with --filter rips or --distances");
    if (options.finish && !hierarchical) return usage_error("--finish goes with --method netmesh");
    if (options.command == Command::persist && hierarchical && !options.finish)
        return usage_error("--method netmesh leaves cages, which have no filter; --finish removes them");
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
    settle_auto(options);
    outcome = check_together(*options);
    return outcome.good() ? check_positionals(*options) : outcome;
}

bool asks_for_json(const std::vector<std::string>& arguments) {
    const auto end = std::find(arguments.begin(), arguments.end(), "--");
    return std::find(arguments.begin(), end, "--json") != end;
}

std::string option_of(const Options& options, netmesh_field field) {
    const char* const name = option_name(field);
    if (name == nullptr) return {};
    const auto is_it = [&](const auto& given) { return given.first == name; };
    const auto last = std::find_if(options.given.rbegin(), options.given.rend(), is_it);
    return last == options.given.rend() ? name : last->first + " " + last->second;
}

void settle_auto(Options* options) {
    static constexpr const char* of_a_mesh[] = {
        "--tau",       "--ratio",     "--whole-cells", "--focus", "--longer-than", "--from", "--to",
        "--fit",       "--method",    "--finish",      "--audit", "--values",      "--mesh", "--eps",
        "--cell-size", "--domain",    "--net",         "--cages", "--theta",       "--k",    "--function",
        "--values-at", "--lipschitz", "--cut",         "--error"};
    const bool is_open = options->command == Command::persist || options->command == Command::size;
    if (!is_open || options->filter || options->distances) return;
    for (const auto& given : options->given)
        for (const char* const name : of_a_mesh)
            if (given.first == name) options->implies_mesh = name;
    options->auto_filter = options->implies_mesh.empty();
}

netmesh_filter default_filter(Command command) {
    return command == Command::vineyard ? NETMESH_FILTER_KNN : NETMESH_FILTER_COMPLETE;
}

FilterChoice choice_of(const Options& options) {
    // An error that is asked for, or the least that fits, is that of a function's own values.
    const bool is_least_error = options.error > 0 || (options.fit && options.filter == NETMESH_FILTER_FUNCTION);
    return {options.filter.value_or(default_filter(options.command)),
            options.values.value_or(is_least_error ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED)};
}

bool fits_error(const Options& options) {
    return options.fit && !options.method && !options.finish && about(filter_of(options)).needs_function != 0;
}

bool refines_by_certificate(const Options& options) {
    if (options.command != Command::persist || options.method || options.finish) return false;
    const FilterChoice choice = choice_of(options);
    const netmesh_filter_info& filter = about(choice.filter);
    if (options.fit) return filter.source == NETMESH_SOURCE_MESH && filter.has_eps == 0 && filter.needs_function == 0;
    return (filter.has_goal != 0 || (filter.has_eps != 0 && options.ratio)) &&
           choice.values == NETMESH_VALUES_CERTIFIED;
}

bool clips_cells(const Options& options) {
    return refines_by_certificate(options) && about(filter_of(options)).clips_cells != 0;
}

namespace {

Outcome check_focus_auto(const Options& options) {
    if (!refines_by_certificate(options) || about(filter_of(options)).has_goal == 0)
        return usage_error("--focus auto is for the complete filter with certified values, without --method");
    if (options.fit) return usage_error("--fit finds the best ratio, --focus auto which bars are real; leave one out");
    if (options.from > 0 || options.to > 0)
        return usage_error("--focus auto finds the scales; leave out --from and --to");
    if (options.memory_bytes == 0) return usage_error("--focus auto needs --memory, the size to fit in");
    return {};
}

}  // namespace

Outcome check_ratio(const Options& options) {
    if (options.longer_than > 0 && !options.focus_auto) return usage_error("--longer-than goes with --focus auto");
    if (options.focus_auto) return check_focus_auto(options);
    const bool focused = options.focus > 0 || options.from > 0 || options.to > 0;
    if (fits_error(options) && (options.ratio || focused))
        return usage_error(
            "--fit of a function goes by its error: --ratio, --focus, --from and --to do not go with it");
    if (options.command == Command::persist && (options.ratio || focused || (options.fit && !fits_error(options))) &&
        !refines_by_certificate(options)) {
        return usage_error(
            options.fit
                ? "--fit is for filters on a mesh but tight, without --method"
                : "--ratio, --focus, --from and --to are for the complete filter, --ratio for tight and scales; "
                  "with certified values, without --method");
    }
    if (options.command == Command::persist && options.whole_cells && !clips_cells(options))
        return usage_error("--whole-cells is for meshes refined by the certificate for the complete or basic filter");
    if (focused && about(filter_of(options)).has_theta != 0)
        return usage_error("--focus is of one mesh: not for scales");
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

bool promises_accuracy(const Options& options) { return about(filter_of(options)).has_eps != 0; }

Outcome check_accuracy(const Options& options) {
    const auto has_eps = [](const netmesh_filter_info& info) { return info.has_eps != 0; };
    const auto has_theta = [](const netmesh_filter_info& info) { return info.has_theta != 0; };
    if (options.theta > 0 && about(filter_of(options)).has_theta == 0)
        return usage_error("--theta goes with --filter " + list_filters(has_theta, "or"));
    if (promises_accuracy(options)) {
        if (options.eps > 0 && options.ratio && options.command == Command::persist)
            return usage_error("--eps and --ratio both say what is asked of the diagram; leave one of them out");
        if (options.eps <= 0.5) return {};
        return usage_error("--eps must be at most 1/2 for " + list_filters(has_eps, "and"));
    }
    if (options.eps > 0 && options.command == Command::persist)
        return usage_error("--eps goes with --filter " + list_filters(has_eps, "or"));
    return {};
}

std::uint32_t max_degree_of(const Options& options, std::uint32_t dim) {
    return options.max_degree.value_or(is_on_points(filter_of(options)) ? 1 : dim - 1);
}

Outcome check_max_degree(const Options& options) {
    const netmesh_filter filter = filter_of(options);
    if (!is_on_points(filter)) return {};
    const std::uint64_t k = is_barycentric(filter) ? options.k_last.value_or(options.k.value_or(1)) : 0;
    if (k + max_degree_of(options, NETMESH_DIM_MIN) < NETMESH_DEGREE_MAX) return {};
    return usage_error("--max-degree, with --k added for barycentric filters, is at most 30");
}

const char* command_name(Command command) { return command == Command::none ? "" : entry_of(command).name; }

}  // namespace netmesh::tool
