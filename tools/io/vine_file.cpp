#include "tools/io/vine_file.hpp"

#include <cmath>
#include <string>

#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

Vines vines_of(const Engine& engine) {
    Vines vines;
    const netmesh_vineyard_report report = engine.report().vineyard;
    vines.k_first = report.k_first;
    for (std::uint32_t k = report.k_first; k <= report.k_last; k++) vines.ratios.push_back(engine.vine_ratio(k));
    engine.for_each_vine_point([&](std::uint64_t, const netmesh_vine_point& p) { vines.points.push_back(p); });
    return vines;
}

void write_vine_point(const netmesh_vine_point& p, TextWriter& out) {
    out << p.vine << ' ' << p.degree << ' ' << p.k << ' ' << p.birth << ' ' << p.death;
}

constexpr std::string_view vines_marker = "# netmesh vineyard 1: vine degree k birth death";
constexpr std::string_view any_vines_marker = "# netmesh vineyard ";

void write_vines(const Vines& vines, const netmesh_vineyard_report& report, TextWriter& out) {
    out << vines_marker << "\n# filter " << filter_name(report.filter) << ", "
        << (report.filter == NETMESH_FILTER_NONE ? "given" : values_name(report.values)) << " values\n";
    for (std::size_t i = 0; i < vines.ratios.size(); i++) {
        out << "# k " << static_cast<std::uint64_t>(vines.k_first + i) << " certified ratio " << vines.ratios[i]
            << '\n';
    }
    for (const netmesh_vine_point& point : vines.points) {
        write_vine_point(point, out);
        out << '\n';
    }
}

namespace {

bool parse_index(std::string_view word, std::uint32_t* index) {
    std::uint64_t value;
    if (!parse_unsigned(std::string(word), &value) || value >= NETMESH_NONE) return false;
    *index = static_cast<std::uint32_t>(value);
    return true;
}

// The marker, `# filter knn, certified values` or `# k 3 certified ratio 2.1`; other comments say nothing.
Complaint parse_comment(std::string_view line, VineFile* file) {
    const std::vector<std::string_view> words = split_blanks(line);
    const bool has_filter = file->choice.filter != NETMESH_FILTER_NONE || file->of_values;
    if (line.substr(0, any_vines_marker.size()) == any_vines_marker) {
        if (line != vines_marker)
            return quoted(line) + " is of another version of the format; this one reads `# netmesh vineyard 1`";
        return has_filter ? "a second head; a file holds one vineyard" : "";
    }
    if (words.size() == 5 && words[1] == "filter") {
        if (has_filter) return "a second line of the filter";
        if (words[3] != "certified" && words[3] != "thesis" && words[3] != "given")
            return quoted(words[3]) + " are not values: certified, thesis or given";
        for (const netmesh_filter_info& info : filters()) {
            if (has_vineyard(info) && words[2] == std::string(info.name) + ",") file->choice.filter = info.id;
        }
        file->of_values = words[2] == "none," && words[3] == "given";
        file->choice.values = words[3] == "thesis" ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED;
        if (file->choice.filter != NETMESH_FILTER_NONE || file->of_values) return {};
        return "a vineyard's filter is " + list_filters(has_vineyard, "or") + ", or `none, given values`";
    }
    if (words.size() != 6 || words[1] != "k" || words[3] != "certified") return {};
    std::uint32_t k;
    double ratio;
    if (!parse_index(words[2], &k) || !parse_finite(std::string(words[5]), &ratio) || !(ratio >= 1))
        return "not `# k K certified ratio C`";
    Vines& vines = file->vines;
    if (vines.ratios.empty()) vines.k_first = k;
    if (k < 1 || k != vines.k_first + vines.ratios.size()) return "the k of the ratios are not one after the other";
    vines.ratios.push_back(ratio);
    return {};
}

Complaint parse_point(std::string_view line, const VineFile& file, netmesh_vine_point* point) {
    const Vines& vines = file.vines;
    const std::vector<std::string_view> words = split_blanks(line);
    if (words.size() != 5) return counted(words.size(), "field", "fields") + "; a line is: vine degree k birth death";
    if (!parse_index(words[0], &point->vine)) return quoted(words[0]) + " is not a vine";
    if (!parse_index(words[1], &point->degree)) return quoted(words[1]) + " is not a degree";
    if (!parse_index(words[2], &point->k) || point->k < vines.k_first ||
        point->k - vines.k_first >= vines.ratios.size())
        return quoted(words[2]) + " is not a k with a certified ratio above";
    if (!parse_finite(std::string(words[3]), &point->birth) || (point->birth < 0 && !file.of_values))
        return quoted(words[3]) + " is not a birth: finite" + (file.of_values ? "" : " and not below 0");
    point->death = HUGE_VAL;
    if (words[4] != "inf" && (!parse_finite(std::string(words[4]), &point->death) || point->death <= point->birth))
        return quoted(words[4]) + " is not a death: inf, or finite and after the birth";
    if (vines.points.empty()) return point->vine == 0 ? "" : "the first vine is not 0";
    const netmesh_vine_point& before = vines.points.back();
    if (point->vine == before.vine) {
        if (point->k <= before.k) return "the k of a vine do not ascend";
        return point->degree == before.degree ? "" : "a vine changes its degree";
    }
    return point->vine == before.vine + 1 ? "" : "vines are not numbered one after the other";
}

}  // namespace

Outcome parse_vines(std::string_view content, const std::string& name, VineFile* file) {
    std::uint64_t number = 0;
    while (!content.empty()) {
        const std::size_t end = content.find('\n');
        std::string_view line = content.substr(0, end);
        content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
        number++;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (split_blanks(line).empty()) continue;
        netmesh_vine_point point = sized<netmesh_vine_point>();
        const bool comment = line.front() == '#';
        const Complaint complaint = comment ? parse_comment(line, file) : parse_point(line, *file, &point);
        if (!complaint.empty()) return line_error(name, number, complaint);
        if (comment) continue;
        file->vines.points.push_back(point);
        file->lines.push_back(number);
    }
    if (file->choice.filter == NETMESH_FILTER_NONE && !file->of_values)
        return line_error(name, 1, "no line `# filter F, V values`");
    if (file->vines.ratios.empty()) return line_error(name, 1, "no line `# k K certified ratio C`");
    return {};
}

}  // namespace netmesh::tool
