#include "tools/io/provenance.hpp"

#include <algorithm>
#include <cstring>

#include "tools/asked_function.hpp"
#include "tools/engine_options.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/points.hpp"
#include "tools/option_table.hpp"
#include "tools/requests.hpp"
#include "tools/vertex_function.hpp"

namespace netmesh::tool {

namespace {

constexpr std::string_view marker = "# netmesh diagram 1: degree birth death";
constexpr std::string_view any_marker = "# netmesh diagram ";

// An option of persist in a head, by its name; the engine's member that it is, null for the tool's own.
struct HeadOption {
    const char *name, *member;
};

// In the order of the file.
constexpr HeadOption head_options[] = {{"filter", "filter"},
                                       {"distances", nullptr},
                                       {"sparse", nullptr},
                                       {"threshold", "threshold"},
                                       {"radii", nullptr},
                                       {"weights", nullptr},
                                       {"squares", "squares"},
                                       {"box", nullptr},
                                       {"cell", nullptr},
                                       {"k", "k"},
                                       {"values", "values"},
                                       {"function", nullptr},
                                       {"values-at", nullptr},
                                       {"lipschitz", nullptr},
                                       {"cut", nullptr},
                                       {"error", "error"},
                                       {"method", "method"},
                                       {"finish", "finish"},
                                       {"tau", "tau"},
                                       {"fit", "fit"},
                                       {"memory", nullptr},
                                       {"ratio", "ratio"},
                                       {"whole-cells", "whole_cells"},
                                       {"focus", "focus_ratio"},
                                       {"from", "focus_from"},
                                       {"to", "focus_to"},
                                       {"eps", "eps"},
                                       {"theta", "theta"},
                                       {"max-degree", "max_degree"},
                                       {"all", "keep_zero_pairs"},
                                       {"bounds", "bounds"},
                                       {"seed", "seed"}};

const HeadOption* find_option(std::string_view name) {
    for (const HeadOption& option : head_options)
        if (name == option.name) return &option;
    return nullptr;
}

bool is_option(std::string_view name) { return find_option(name) != nullptr; }

bool fits_error(const netmesh_request& r) { return r.fit != nullptr && r.filter == &netmesh_filter_function; }

// What of the settled request a head says, beside what is not as by default.
bool is_said(const Options& options, const std::string& name) {
    const netmesh_request& r = options.request;
    const netmesh_filter_info& filter = about(r.filter);
    const bool is_made = filter.is_on_mesh != 0 && options.values_at.empty();  // the mesh, from points
    if (name == "values") return filter.has_values != 0;
    if (name == "function") return filter.needs_function != 0 && options.values_at.empty();
    if (name == "values-at" || name == "lipschitz" || name == "cut")
        return filter.needs_function != 0 && (name != "values-at" || !options.values_at.empty());
    if (name == "method")
        return is_made && r.mesh.method != nullptr && r.mesh.method != &netmesh_method_certificate && !fits_error(r);
    if (name == "tau") return (is_made && r.fit == nullptr) || filter.is_by_scales != 0;
    if (name == "memory") return r.fit != nullptr;
    if (name == "whole-cells") return r.mesh.whole_cells != 0 && filter.clips_cells != 0;
    if (name == "seed") return is_made || filter.is_by_scales != 0;
    if (name == "distances") return options.distances;
    if (name == "sparse") return options.sparse;
    if (name == "radii" || name == "weights")
        return !options.table.weights.empty() && options.table.are_radii == (name == "radii");
    if (name == "box" || name == "cell")
        return options.table.lattice.kind == (name == "box" ? Lattice::box : Lattice::cell);
    return name == "filter" || name == "max-degree" || is_given(r, find_option(name)->member);
}

// Its value; of a switch nothing. What was read of --values-at is the fingerprint.
std::string said_value(const Options& options, const HeadOption& option) {
    const std::string name = option.name;
    if (option.member != nullptr) return option_text(options.request, option.member);
    if (name == "function") return options.function ? options.function->text() : "";
    if (name == "values-at")
        return options.vertex_function ? options.vertex_function->values_fingerprint() : options.values_at;
    if (name == "radii" || name == "weights") return options.table.weights;
    if (name == "box" || name == "cell") return options.table.lattice.text;
    if (name == "lipschitz") return number_text(options.lipschitz.value_or(0));
    if (name == "cut") return number_text(options.cut.value_or(0));
    return name == "memory" ? std::to_string(options.memory_bytes) : "";
}

Head option_head(const Options& settled) {
    Head head;
    for (const HeadOption& option : head_options)
        if (is_said(settled, option.name)) head.push_back({option.name, said_value(settled, option)});
    return head;
}

}  // namespace

std::string head_text(const HeadLine& line) { return line.value.empty() ? line.name : line.name + " " + line.value; }

Options said_by_head(const Options& options, std::uint32_t dim) {
    Options all = settled(options, dim);
    if (all.request.mesh.tau == 0) all.request.mesh.tau = default_tau(std::min(dim, dim_max));
    return all;
}

Head head_of(const Options& options, const netmesh_report& report) {
    const netmesh_input_report& input = report.input;
    const netmesh_diagram_report& diagram = report.diagram;
    Head head = option_head(said_by_head(options, options.distances ? dim_min : input.dim));
    const auto add = [&](const char* name, const std::string& value) { head.push_back({name, value}); };
    head.insert(head.begin(), {"version", netmesh_version_text()});
    if (!options.distances) add("dim", std::to_string(input.dim));
    add("points", std::to_string(input.points));
    if (!options.distances) add("duplicates", std::to_string(input.duplicates));
    options.vertex_function ? add("mesh", options.vertex_function->mesh_fingerprint())
                            : add("input", hexadecimal(input.fingerprint));
    if (input.periods > 0) add("copies", std::to_string(input.copies));
    if (input.moved > 0) add("moved", number_text(input.moved));
    if (report.mesh.is_mesh != 0) {
        std::string ball;
        for (std::uint32_t k = 0; k <= input.dim; k++) ball += (k > 0 ? " " : "") + number_text(report.mesh.domain[k]);
        add("domain", ball);
    }
    add("certified-ratio", number_text(diagram.certified_ratio));
    if (diagram.certified_from > 0) add("certified-from", number_text(diagram.certified_from));
    if (diagram.filter == NETMESH_FILTER_FUNCTION) add("certified-error", number_text(diagram.certified_error));
    if (fits_error(options.request)) add("fitted-error", number_text(diagram.fitted_error));
    add("reference", reference_name(report));
    return head;
}

void write_head(const Head& head, TextWriter& out) {
    if (head.empty()) return;
    out << marker << '\n';
    for (const HeadLine& line : head) out << "# " << head_text(line) << '\n';
}

const HeadLine* Provenance::find(std::string_view name) const { return find_line(lines, name); }

namespace {

// What a line that is no option may say, apart from whether it is true.
bool is_number(const std::string& text, double least) {
    double value;
    return text == "inf" || (parse_finite(text, &value) && value >= least);
}

bool is_ball(const std::string& text, std::uint64_t dim) {
    const std::vector<std::string_view> words = split_blanks(text);
    double value = 0;
    bool good = words.size() == dim + 1;
    for (std::size_t i = 0; i < words.size() && good; i++) good = parse_finite(std::string(words[i]), &value);
    return good && value > 0;
}

bool is_fingerprint(const std::string& text) {
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// The field that the engine refuses; NONE: none.
netmesh_field refused_at(const Options& options, std::string* why = nullptr) {
    netmesh_request settled;
    netmesh_field field;
    const Outcome outcome = settle(options, dim_min, &settled, &field);
    if (why != nullptr) *why = outcome.message.substr(std::min(outcome.message.size(), std::strlen("netmesh: ")));
    return field;
}

// A comment behind the marker as a line of the head, but for `# scale` and for nothing.
void take_line(std::string_view line, std::uint64_t number, Head* head) {
    const std::vector<std::string_view> words = split_blanks(line.substr(1));
    if (words.empty() || words[0] == "scale") return;
    const std::size_t end = static_cast<std::size_t>(words[0].data() + words[0].size() - line.data());
    std::string_view value = line.substr(end);
    while (!value.empty() && (value.front() == ' ' || value.front() == '\t')) value.remove_prefix(1);
    head->push_back({std::string(words[0]), std::string(value), number});
}

// Reads the head of one file.
class HeadReader {
public:
    HeadReader(std::string_view content, const std::string& file) : content_(content), file_(file) {}
    Outcome read(std::optional<Provenance>* provenance);

private:
    Outcome collect();
    Outcome take_options();
    Outcome check_names();
    Outcome check_version();
    Outcome check_facts();
    Outcome check_options();
    Outcome fault(std::uint64_t line, const std::string& complaint) const { return line_error(file_, line, complaint); }
    Outcome fault(const HeadLine& line, const std::string& complaint) const {
        return fault(line.number, quoted("# " + head_text(line)) + ": " + complaint);
    }
    std::uint64_t count_of(const char* name) const {
        std::uint64_t count = 0;
        parse_unsigned(find_line(found_.lines, name)->value, &count);
        return count;
    }

    std::string_view content_;
    const std::string& file_;
    std::uint64_t first_ = 0;  // line of the marker; 0: there is none
    Provenance found_;
};

// The lines from the marker to the first bar.
Outcome HeadReader::collect() {
    LineReader reader(content_, false);
    std::string_view line;
    while (reader.next(&line) && (line.empty() || line.front() == '#')) {
        if (line.substr(0, any_marker.size()) == any_marker) {
            if (first_ != 0) return fault(reader.number(), "a second head; a file holds one diagram");
            if (line != marker)
                return fault(reader.number(),
                             quoted(line) + " is of another version of the format; this one reads " + quoted(marker));
            first_ = reader.number();
        } else if (first_ != 0 && !line.empty()) {
            take_line(line, reader.number(), &found_.lines);
        }
    }
    return {};
}

Outcome HeadReader::take_options() {
    Options& options = found_.options;
    options.command = Command::persist;
    for (const HeadLine& line : found_.lines) {
        if (!is_option(line.name)) continue;
        const std::string complaint = apply_option(&options, "--" + line.name, line.value);
        if (!complaint.empty()) return fault(line, complaint);
        if (line.value == "auto" || options.table.lattice.kind == Lattice::file)
            return fault(line, "contradicts the other lines, which are of what was taken");
    }
    if (options.request.filter == nullptr) options.request.filter = &netmesh_filter_complete;
    // Beside a ratio that does not follow from it tau says nothing; check_tau looks at it.
    Options without = options;
    without.request.goal.ratio = 0;
    found_.tau = options.request.mesh.tau;
    if (refused_at(options) == NETMESH_FIELD_TAU && refused_at(without) != NETMESH_FIELD_TAU)
        options.request.mesh.tau = 0;
    return {};
}

// Every line that is due once, and no other. Which are due is what the writer says.
Outcome HeadReader::check_names() {
    if (const HeadLine* const old = found_.find("value-error"))
        return fault(*old, "this file was made by netmesh 0.2.0 or before, whose births and deaths were not rounded to "
                           "nearest; make the diagram again");
    constexpr const char* facts[] = {"version", "points", "certified-ratio", "reference"};
    Head due = option_head(said_by_head(found_.options, dim_min));
    for (const char* fact : facts) due.push_back({fact, ""});
    if (!found_.options.distances)
        for (const char* fact : {"dim", "duplicates"}) due.push_back({fact, ""});
    if (about(found_.options.request.filter).is_on_mesh != 0) due.push_back({"domain", ""});
    due.push_back({found_.options.values_at.empty() ? "input" : "mesh", ""});
    const bool repeats = found_.options.table.lattice.kind != Lattice::none;
    if (repeats) due.push_back({"copies", ""});
    if (filter_of(found_.options) == NETMESH_FILTER_FUNCTION) due.push_back({"certified-error", ""});
    if (fits_error(found_.options.request)) due.push_back({"fitted-error", ""});
    for (const HeadLine& line : found_.lines) {
        if (find_line(found_.lines, line.name) != &line)
            return fault(line, "the head says that twice; leave one of the two lines out");
        const bool may_be = line.name == "certified-from" || (line.name == "moved" && repeats);
        if (find_line(due, line.name) != nullptr || may_be) continue;
        constexpr const char* others[] = {"dim",   "duplicates", "domain",          "input",       "mesh",
                                          "moved", "copies",     "certified-error", "fitted-error"};
        if (!is_option(line.name) &&
            std::none_of(std::begin(others), std::end(others), [&](const char* other) { return line.name == other; }))
            return fault(line, "not a line of a head; comments of your own go behind the bars or before the head");
        return fault(line, "contradicts the other lines: a diagram of " + choice_text(choice_of(found_.options)) +
                               " that is made as they say does not have it");
    }
    std::string why;
    for (const std::string& name : option_names(refused_at(found_.options, &why)))
        if (const HeadLine* const line = found_.find(name.substr(2)))
            return fault(*line, "contradicts the other lines: " + why);
    for (const HeadLine& line : due) {
        if (find_line(found_.lines, line.name) == nullptr)
            return fault(first_, "the head lacks the line " + quoted("# " + line.name) +
                                     "; write the file anew, or take the head out and give options");
    }
    return {};
}

// MAJOR.MINOR.PATCH, not after this program's own: a later one may mean something else by the same lines.
Outcome HeadReader::check_version() {
    const HeadLine& line = *found_.find("version");
    std::uint64_t number[3] = {};
    std::size_t parts = 0, at = 0;
    bool good = true;
    while (good && parts < 3) {
        const std::size_t end = std::min(line.value.find('.', at), line.value.size());
        const std::string digits = line.value.substr(at, end - at);
        good = !digits.empty() && digits.size() < 5 && digits.find_first_not_of("0123456789") == std::string::npos &&
               parse_unsigned(digits, &number[parts]) && (parts < 2) == (end < line.value.size());
        at = end + 1;
        parts++;
    }
    if (!good) return fault(line, "not a version, such as " + std::string(netmesh_version_text()));
    constexpr std::uint64_t own[] = {NETMESH_VERSION_MAJOR, NETMESH_VERSION_MINOR, NETMESH_VERSION_PATCH};
    if (std::lexicographical_compare(std::begin(own), std::end(own), std::begin(number), std::end(number)))
        return fault(line, "made by a later version than this program, which is " +
                               std::string(netmesh_version_text()) + "; use one that is not older than the file");
    return {};
}

Outcome HeadReader::check_facts() {
    for (const char* name : {"dim", "points", "duplicates", "copies"}) {
        std::uint64_t count;
        const HeadLine* const line = found_.find(name);
        if (line != nullptr && !parse_unsigned(line->value, &count)) return fault(*line, "must be a whole number");
    }
    const bool has_points = !found_.options.distances, any = filter_of(found_.options) == NETMESH_FILTER_RIPS;
    const std::uint64_t dim = has_points ? count_of("dim") : 0;
    if (has_points && (dim < dim_min || dim > (any ? NETMESH_RIPS_DIM_MAX : dim_max)))
        return fault(*found_.find("dim"), any ? "must be from 2 to 65536" : "must be from 2 to 6");
    if (has_points && count_of("duplicates") >= count_of("points"))
        return fault(*found_.find("duplicates"), "contradicts the number of points: fewer of them are duplicates");
    for (const char* name : {"input", "values-at", "mesh"}) {
        const HeadLine* const line = found_.find(name);
        if (line != nullptr && !is_fingerprint(line->value)) return fault(*line, "must be 16 hexadecimal digits");
    }
    const HeadLine* const domain = found_.find("domain");
    if (domain != nullptr && !is_ball(domain->value, dim))
        return fault(*domain, "must be a centre of as many coordinates as # dim says, and a radius above 0");
    for (const char* name : {"moved", "certified-ratio", "certified-from", "certified-error", "fitted-error"}) {
        const HeadLine* const line = found_.find(name);
        const double least = name == std::string_view("certified-ratio") ? 1 : 0;
        if (line != nullptr && !is_number(line->value, least))
            return fault(*line, "must be a number, at least " + number_text(least));
    }
    const HeadLine& degree = *found_.find("max-degree");
    const Lattice& lattice = found_.options.table.lattice;
    const std::uint64_t top = dim - (lattice.kind == Lattice::none ? 1 : 0);
    if (!is_on_points(filter_of(found_.options)) && found_.options.request.max_degree > top)
        return fault(degree, "contradicts # dim: at most " + std::to_string(top));
    if (lattice.kind != Lattice::none && lattice.dim != dim)
        return fault(*found_.find(lattice.option() + 2), "contradicts # dim: has another number of entries");
    return {};
}

Outcome HeadReader::check_options() {
    netmesh_request settled;
    Outcome outcome = check_together(found_.options);
    if (outcome.good()) outcome = check_function(found_.options);
    if (outcome.good()) outcome = settle(found_.options, dim_min, &settled);
    if (!outcome.good()) return fault(first_, "the head contradicts itself: " + outcome.message);
    return {};
}

Outcome HeadReader::read(std::optional<Provenance>* provenance) {
    provenance->reset();
    Outcome outcome = collect();
    if (!outcome.good() || first_ == 0) return outcome;
    outcome = take_options();
    if (outcome.good()) outcome = check_names();
    if (outcome.good()) outcome = check_version();
    if (outcome.good()) outcome = check_facts();
    if (outcome.good()) outcome = check_options();
    if (outcome.good()) *provenance = std::move(found_);
    return outcome;
}

}  // namespace

Head head_lines(std::string_view content) {
    Head head;
    LineReader reader(content, false);
    std::string_view line;
    bool is_in = false;
    while (reader.next(&line) && (line.empty() || line.front() == '#')) {
        if (is_in && !line.empty()) take_line(line, reader.number(), &head);
        is_in = is_in || line.substr(0, any_marker.size()) == any_marker;
    }
    return head;
}

const HeadLine* find_line(const Head& head, std::string_view name) {
    for (const HeadLine& line : head) {
        if (line.name == name) return &line;
    }
    return nullptr;
}

Outcome parse_head(std::string_view content, const std::string& file, std::optional<Provenance>* provenance) {
    return HeadReader(content, file).read(provenance);
}

namespace {

// What a value stands for.
std::string meaning(const HeadOption& option, const std::string& value) {
    Options options;
    options.command = Command::persist;
    const std::string complaint = apply_option(&options, std::string("--") + option.name, value);
    return complaint.empty() ? said_value(options, option) : value;
}

}  // namespace

Outcome check_contradiction(const Provenance& provenance, const std::string& file, const Options& command_line) {
    for (const auto& [name, value] : command_line.given) {
        const HeadOption* const option = find_option(name.substr(std::min<std::size_t>(2, name.size())));
        if (option == nullptr) continue;
        // Memory is a matter of the file only where a diagram was fitted to it; values are compared when they are read.
        const std::string_view bare = option->name;
        if ((bare == "values-at" && !provenance.options.values_at.empty()) ||
            (bare == "memory" && provenance.options.request.fit == nullptr))
            continue;
        const HeadLine* const line = provenance.find(bare);
        if (line != nullptr && meaning(*option, value) == meaning(*option, line->value)) continue;
        return usage_error((value.empty() ? name : name + " " + value) + " contradicts " + file +
                           (line == nullptr ? ", which was made without " + name
                                            : ":" + std::to_string(line->number) + ": " +
                                                  quoted("# " + head_text(*line)) + "; leave the option out"));
    }
    return {};
}

bool says_how(const Options& command_line) {
    return std::any_of(command_line.given.begin(), command_line.given.end(), [](const auto& given) {
        return given.first.size() > 2 && given.first != "--memory" && is_option(given.first.substr(2));
    });
}

}  // namespace netmesh::tool
