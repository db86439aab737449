#include "tools/io/provenance.hpp"

#include <algorithm>
#include <cmath>

#include "tools/asked_function.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/points.hpp"
#include "tools/requests.hpp"
#include "tools/vertex_function.hpp"

namespace netmesh::tool {

namespace {

constexpr std::string_view marker = "# netmesh diagram 1: degree birth death";
constexpr std::string_view any_marker = "# netmesh diagram ";

// In the order of the file.
constexpr const char* option_names[] = {
    "filter", "distances", "sparse", "threshold", "k",     "values",     "function", "values-at", "lipschitz",
    "cut",    "error",     "method", "finish",    "tau",   "fit",        "memory",   "ratio",     "whole-cells",
    "focus",  "from",      "to",     "eps",       "theta", "max-degree", "all",      "bounds",    "seed"};

bool is_option(std::string_view name) {
    return std::any_of(std::begin(option_names), std::end(option_names), [&](const char* o) { return name == o; });
}

const HeadLine* find_line(const Head& head, std::string_view name) {
    for (const HeadLine& line : head) {
        if (line.name == name) return &line;
    }
    return nullptr;
}

// Collects lines in the order in which they are written.
class HeadWriter {
public:
    void add(const char* name, const std::string& value = "") { head_.push_back({name, value}); }
    void add(const char* name, double value) { add(name, number_text(value)); }
    void add_count(const char* name, std::uint64_t value) { add(name, std::to_string(value)); }
    Head take() { return std::move(head_); }

private:
    Head head_;
};

bool is_meshed(const Options& options) { return about(filter_of(options)).source == NETMESH_SOURCE_MESH; }
bool is_by_scales(const Options& options) { return about(filter_of(options)).source == NETMESH_SOURCE_SCALES; }
bool has_scales_of_interest(const Options& options) { return options.focus > 0 || options.from > 0 || options.to > 0; }

void add_mesh_options(const Options& options, HeadWriter* head) {
    if (is_meshed(options) && !refines_by_certificate(options) && !fits_error(options)) {
        head->add("method", method_name(options.method.value_or(NETMESH_METHOD_SVR)));
        if (options.finish) head->add("finish");
    }
    if ((is_meshed(options) && !options.fit) || is_by_scales(options)) head->add("tau", options.tau.value_or(0));
    if (options.fit) {
        head->add("fit");
        head->add_count("memory", options.memory_bytes);
    }
    if (refines_by_certificate(options)) head->add("ratio", options.ratio.value_or(0));
    if (clips_cells(options) && options.whole_cells) head->add("whole-cells");
    if (!has_scales_of_interest(options)) return;
    if (!options.fit) head->add("focus", options.focus);
    head->add("from", options.from);
    head->add("to", options.to);
}

}  // namespace

std::string head_text(const HeadLine& line) { return line.value.empty() ? line.name : line.name + " " + line.value; }

Options settled(const Options& given, std::uint32_t dim) {
    const Options options = suited(given, dim);
    Options all = options;
    const netmesh_filter_info& filter = about(filter_of(options));
    all.filter = filter.filter;
    if (filter.has_values != 0) all.values = choice_of(options).values;
    if (filter.needs_k != 0) all.k = options.k.value_or(1);
    all.max_degree = max_degree_of(options, dim);
    if (!is_on_points(filter.filter)) all.max_degree = std::min(*all.max_degree, dim - 1);
    if (filter.has_eps != 0 && options.eps == 0 && !options.ratio) all.eps = default_eps;
    if (filter.has_theta != 0 && options.theta == 0) all.theta = default_theta;
    const requests::Mesh mesh = mesh_request(options, std::min(dim, dim_max));
    all.tau = tau(mesh);
    if (!refines_by_certificate(options)) return all;
    if (!options.ratio) all.ratio = options.fit ? fit_request(options, dim).ratio : mesh.certificate.ratio;
    return all;
}

Head option_head(const Options& options) {
    const netmesh_filter_info& filter = about(filter_of(options));
    HeadWriter head;
    head.add("filter", filter.name);
    if (options.distances) head.add("distances");
    if (options.sparse) head.add("sparse");
    if (options.threshold) head.add("threshold", *options.threshold);
    if (filter.needs_k != 0) head.add_count("k", options.k.value_or(0));
    if (filter.has_values != 0) head.add("values", values_name(choice_of(options).values));
    if (filter.needs_function != 0) {
        if (options.values_at.empty())
            head.add("function", options.function ? options.function->text() : "");
        else  // what was read from a head is the fingerprint
            head.add("values-at",
                     options.vertex_function ? options.vertex_function->values_fingerprint() : options.values_at);
        head.add("lipschitz", options.lipschitz.value_or(0));
        head.add("cut", options.cut.value_or(0));
        if (options.error > 0) head.add("error", options.error);
    }
    const bool is_made = options.values_at.empty();  // the mesh, from points
    if (is_made) add_mesh_options(options, &head);
    if (filter.has_eps != 0 && !options.ratio) head.add("eps", options.eps);
    if (filter.has_theta != 0) head.add("theta", options.theta);
    head.add_count("max-degree", options.max_degree.value_or(0));
    if (options.all) head.add("all");
    if (options.bounds) head.add("bounds");
    if ((is_meshed(options) && is_made) || is_by_scales(options)) head.add_count("seed", options.seed);
    return head.take();
}

Head head_of(const Options& options, const netmesh_report& report) {
    const netmesh_input_report& input = report.input;
    HeadWriter head;
    head.add("version", netmesh_version_text());
    Head lines = option_head(settled(options, options.distances ? dim_min : input.dim));
    Head all = head.take();
    all.insert(all.end(), lines.begin(), lines.end());
    if (!options.distances) head.add_count("dim", input.dim);
    head.add_count("points", input.points);
    if (!options.distances) head.add_count("duplicates", input.duplicates);
    if (options.vertex_function)
        head.add("mesh", options.vertex_function->mesh_fingerprint());
    else
        head.add("input", hexadecimal(input.fingerprint));
    if (report.mesh.is_mesh != 0) {
        std::string ball;
        for (std::uint32_t k = 0; k <= input.dim; k++) ball += (k > 0 ? " " : "") + number_text(report.mesh.domain[k]);
        head.add("domain", ball);
    }
    head.add("certified-ratio", report.diagram.certified_ratio);
    if (report.diagram.certified_from > 0) head.add("certified-from", report.diagram.certified_from);
    if (report.diagram.filter == NETMESH_FILTER_FUNCTION) head.add("certified-error", report.diagram.certified_error);
    if (fits_error(options)) head.add("fitted-error", report.diagram.fitted_error);
    head.add("reference", reference_name(report));
    lines = head.take();
    all.insert(all.end(), lines.begin(), lines.end());
    return all;
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
            const std::vector<std::string_view> words = split_blanks(line.substr(1));
            if (words.empty() || words[0] == "scale") continue;
            const std::size_t end = static_cast<std::size_t>(words[0].data() + words[0].size() - line.data());
            std::string_view value = line.substr(end);
            while (!value.empty() && (value.front() == ' ' || value.front() == '\t')) value.remove_prefix(1);
            found_.lines.push_back({std::string(words[0]), std::string(value), reader.number()});
        }
    }
    return {};
}

Outcome HeadReader::take_options() {
    found_.options.command = Command::persist;
    for (const HeadLine& line : found_.lines) {
        if (!is_option(line.name)) continue;
        const std::string complaint = apply_option(&found_.options, "--" + line.name, line.value);
        if (!complaint.empty()) return fault(line, complaint);
    }
    return {};
}

// Every line that is due once, and no other. Which are due is what the writer says.
Outcome HeadReader::check_names() {
    if (const HeadLine* const old = found_.find("value-error"))
        return fault(*old, "this file was made by netmesh 0.2.0 or before, whose births and deaths were not rounded to "
                           "nearest; make the diagram again");
    constexpr const char* facts[] = {"version", "points", "certified-ratio", "reference"};
    Head due = option_head(found_.options);
    for (const char* fact : facts) due.push_back({fact, ""});
    if (!found_.options.distances)
        for (const char* fact : {"dim", "duplicates"}) due.push_back({fact, ""});
    if (is_meshed(found_.options)) due.push_back({"domain", ""});
    due.push_back({found_.options.values_at.empty() ? "input" : "mesh", ""});
    if (filter_of(found_.options) == NETMESH_FILTER_FUNCTION) due.push_back({"certified-error", ""});
    if (fits_error(found_.options)) due.push_back({"fitted-error", ""});
    for (const HeadLine& line : found_.lines) {
        if (find_line(found_.lines, line.name) != &line)
            return fault(line, "the head says that twice; leave one of the two lines out");
        if (find_line(due, line.name) != nullptr || line.name == "certified-from") continue;
        constexpr const char* others[] = {"dim",  "duplicates",      "domain",      "input",
                                          "mesh", "certified-error", "fitted-error"};
        if (!is_option(line.name) &&
            std::none_of(std::begin(others), std::end(others), [&](const char* other) { return line.name == other; }))
            return fault(line, "not a line of a head; comments of your own go behind the bars or before the head");
        return fault(line, "contradicts the other lines: a diagram of " + choice_text(choice_of(found_.options)) +
                               " that is made as they say does not have it");
    }
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
    for (const char* name : {"dim", "points", "duplicates"}) {
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
    for (const char* name : {"certified-ratio", "certified-from", "certified-error", "fitted-error"}) {
        const HeadLine* const line = found_.find(name);
        const double least = name == std::string_view("certified-ratio") ? 1 : 0;
        if (line != nullptr && !is_number(line->value, least))
            return fault(*line, "must be a number, at least " + number_text(least));
    }
    const HeadLine& degree = *found_.find("max-degree");
    if (!is_on_points(filter_of(found_.options)) && *found_.options.max_degree >= dim)
        return fault(degree, "contradicts # dim: at most " + std::to_string(dim - 1));
    return {};
}

Outcome HeadReader::check_options() {
    for (Outcome (*check)(const Options&) :
         {check_together, check_accuracy, check_ratio, check_max_degree, check_function}) {
        const Outcome outcome = check(found_.options);
        if (!outcome.good()) return fault(first_, "the head contradicts itself: " + outcome.message);
    }
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

Outcome parse_head(std::string_view content, const std::string& file, std::optional<Provenance>* provenance) {
    return HeadReader(content, file).read(provenance);
}

Outcome check_contradiction(const Provenance& provenance, const std::string& file, const Options& command_line) {
    const Head have = option_head(provenance.options);
    for (const auto& [name, value] : command_line.given) {
        const std::string bare = name.substr(std::min<std::size_t>(2, name.size()));
        // Memory is a matter of the file only where a diagram was fitted to it; values are compared when they are read.
        if (!is_option(bare) || (bare == "values-at" && !provenance.options.values_at.empty()) ||
            (bare == "memory" && !provenance.options.fit))
            continue;
        Options other = provenance.options;
        apply_option(&other, name, value);
        const Head given = option_head(other);
        const bool same = std::equal(given.begin(), given.end(), have.begin(), have.end(),
                                     [](const HeadLine& a, const HeadLine& b) { return head_text(a) == head_text(b); });
        const HeadLine* const line = provenance.find(bare);
        if (same && line != nullptr) continue;
        const std::string option = value.empty() ? name : name + " " + value;
        return usage_error(option + " contradicts " + file +
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
