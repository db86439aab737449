#include "tools/io/diagram_file.hpp"

#include <algorithm>
#include <cmath>

#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr const char* certain_word = " exists";  // of a bar that is certified to exist

}  // namespace

bool comes_before(const Bar& a, const Bar& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    if (a.birth != b.birth) return a.birth < b.birth;
    return a.death < b.death;
}

void write_diagram(const BarSource& bars, const Bounds& known, TextWriter& out) {
    for (const netmesh_scale_step& step : known.steps) {
        out << "# scale " << step.from << " low " << step.low << " high " << step.high << " reach " << step.reach
            << (known.by_error ? " error " : " ratio ") << (known.by_error ? step.error : step.ratio) << '\n';
    }
    const std::vector<netmesh_bar_bounds>& bounds = known.bars;
    std::size_t i = 0;
    bars.for_each([&](const Bar& bar) {
        out << bar.degree << ' ' << bar.birth << ' ' << bar.death;
        if (i < bounds.size()) {
            const netmesh_bar_bounds& b = bounds[i++];
            out << " # birth " << b.birth_low << ' ' << b.birth_high << " death " << b.death_low << ' ' << b.death_high;
            if (b.certain != 0) out << certain_word;
        }
        out << '\n';
    });
}

std::vector<BoundLine> bound_lines(std::string_view content) {
    std::vector<BoundLine> lines;
    std::uint64_t number = 0;
    while (!content.empty()) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        std::string_view line = content.substr(0, end);
        content.remove_prefix(std::min(end + 1, content.size()));
        number++;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        const bool of_bar = line.find(" # birth ") != std::string_view::npos;
        // Until 0.2.0 the word was another one.
        constexpr std::string_view old_word = " real";
        const std::size_t body = line.size() - std::min(line.size(), old_word.size());
        const bool is_old = of_bar && line.substr(body) == old_word;
        if (is_old) {
            lines.push_back({number, std::string(line.substr(0, body)) + certain_word});
            continue;
        }
        if (of_bar || line.substr(0, 8) == "# scale ") lines.push_back({number, std::string(line)});
    }
    return lines;
}

std::string parse_bar(std::string_view line, Bar* bar) {
    const std::vector<std::string_view> words = split_blanks(line);
    if (words.size() != 3) return counted(words.size(), "field", "fields") + "; a line is: degree birth death";
    std::uint64_t degree;
    if (!parse_unsigned(std::string(words[0]), &degree) || degree > 1000) {
        return quoted(words[0]) + " is not a degree";
    }
    bar->degree = static_cast<std::uint32_t>(degree);
    if (!parse_finite(std::string(words[1]), &bar->birth)) return quoted(words[1]) + " is not a birth: finite";
    if (words[2] == "inf") {
        bar->death = HUGE_VAL;
    } else if (!parse_finite(std::string(words[2]), &bar->death) || bar->death < bar->birth) {
        return quoted(words[2]) + " is not a death: inf, or finite and not before the birth";
    }
    return {};
}

Outcome parse_diagram(std::string_view content, const std::string& name, std::vector<Bar>* bars,
                      std::vector<std::uint64_t>* lines) {
    LineReader reader(content);
    std::string_view line;
    while (reader.next_content(&line)) {
        Bar bar;
        const Complaint complaint = parse_bar(line, &bar);
        if (!complaint.empty()) return line_error(name, reader.number(), complaint);
        bars->push_back(bar);
        if (lines != nullptr) lines->push_back(reader.number());
    }
    return {};
}

}  // namespace netmesh::tool
