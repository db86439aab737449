#include "diagram_file.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace referee {
namespace {

bool to_number(const std::string& word, double* x) {
    char* end = nullptr;
    *x = std::strtod(word.c_str(), &end);
    return !word.empty() && *end == 0 && !std::isnan(*x);
}

bool read_number(std::istream& words, double* x) {
    std::string word;
    return words >> word && to_number(word, x);
}

bool read_named(std::istream& words, const char* name, double* x) {
    std::string word;
    return words >> word && word == name && read_number(words, x);
}

bool read_step(std::istream& words, Step* step) {
    return read_number(words, &step->from) && read_named(words, "low", &step->low) &&
           read_named(words, "high", &step->high) && read_named(words, "reach", &step->reach) &&
           read_named(words, "ratio", &step->ratio);
}

bool read_bar(std::istream& words, Bar* bar) {
    if (!(words >> bar->degree) || !read_number(words, &bar->birth) || !read_number(words, &bar->death)) return false;
    std::string mark;
    if (!(words >> mark)) return true;
    bar->bounded = true;
    if (mark != "#" || !read_named(words, "birth", &bar->birth_low) || !read_number(words, &bar->birth_high) ||
        !read_named(words, "death", &bar->death_low) || !read_number(words, &bar->death_high))
        return false;
    if (!(words >> mark)) return true;
    bar->real = mark == "exists";
    return bar->real && !(words >> mark);
}

const char* const first_line = "# netmesh diagram 1: degree birth death";

}  // namespace

bool DiagramFile::has(const std::string& name) const {
    for (const auto& line : head)
        if (line.first == name) return true;
    return false;
}

std::string DiagramFile::text(const std::string& name) const {
    for (const auto& line : head)
        if (line.first == name) return line.second;
    return {};
}

double DiagramFile::number(const std::string& name, double otherwise) const {
    double x;
    return to_number(text(name), &x) ? x : otherwise;
}

void DiagramFile::set(const std::string& name, const std::string& value) {
    for (auto& line : head)
        if (line.first == name) line.second = value;
}

std::string exact_text(double x) {
    if (std::isinf(x)) return "inf";
    char text[64];
    return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}

std::string read_diagram(const std::string& path, DiagramFile* diagram) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line) || line != first_line) return "the first line of the diagram is another";
    while (std::getline(file, line)) {
        std::istringstream words(line);
        if (line.rfind("# ", 0) != 0) {
            Bar bar;
            if (!read_bar(words, &bar)) return "not a bar: " + line;
            diagram->bars.push_back(bar);
            continue;
        }
        std::string mark, name, value;
        words >> mark >> name;
        if (name == "scale") {
            Step step;
            if (!read_step(words, &step)) return "not a scale: " + line;
            diagram->steps.push_back(step);
        } else {
            std::getline(words >> std::ws, value);
            diagram->head.emplace_back(name, value);
        }
    }
    return {};
}

void write_diagram(const std::string& path, const DiagramFile& diagram) {
    std::ofstream file(path);
    file << first_line << '\n';
    for (const auto& line : diagram.head)
        file << "# " << line.first << (line.second.empty() ? "" : " ") << line.second << '\n';
    for (const Step& step : diagram.steps)
        file << "# scale " << exact_text(step.from) << " low " << exact_text(step.low) << " high "
             << exact_text(step.high) << " reach " << exact_text(step.reach) << " ratio " << exact_text(step.ratio)
             << '\n';
    for (const Bar& bar : diagram.bars) {
        file << bar.degree << ' ' << exact_text(bar.birth) << ' ' << exact_text(bar.death);
        if (bar.bounded)
            file << " # birth " << exact_text(bar.birth_low) << ' ' << exact_text(bar.birth_high) << " death "
                 << exact_text(bar.death_low) << ' ' << exact_text(bar.death_high) << (bar.real ? " exists" : "");
        file << '\n';
    }
}

std::string json_text(const std::string& json, const std::string& part, const std::string& name) {
    const std::size_t start = json.find("\"" + part + "\": {");
    if (start == std::string::npos) return {};
    const std::size_t close = json.find("\n  }", start);
    const std::size_t found = json.find("\"" + name + "\": ", start);
    if (found == std::string::npos || found > close) return {};
    const std::size_t from = found + name.size() + 4, end = json.find('\n', from);
    std::string text = json.substr(from, end - from);
    if (!text.empty() && text.back() == ',') text.pop_back();
    return text;
}

std::vector<double> json_numbers(const std::string& text) {
    std::string plain = text;
    for (char& c : plain)
        if (c == '[' || c == ']' || c == ',') c = ' ';
    std::istringstream words(plain);
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        double x = 0;
        if (word == "null" || word == "inf") {
            x = INFINITY;
        } else if (word == "true" || word == "false") {
            x = word == "true" ? 1 : 0;
        } else if (!to_number(word, &x)) {
            x = NAN;
        }
        numbers.push_back(x);
    }
    return numbers;
}

std::string read_cycles(const std::string& path, std::vector<Cycle>* cycles) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string mark;
        Cycle cycle;
        std::size_t count = 0;
        if (!(words >> mark >> cycle.degree) || mark != "bar" || !read_number(words, &cycle.birth) ||
            !read_number(words, &cycle.death) || !(words >> count))
            return "not a cycle: " + line;
        for (std::size_t i = 0; i < count; i++) {
            if (!std::getline(file, line)) return "a cycle ends early";
            std::istringstream numbers(line);
            std::vector<std::uint32_t> simplex;
            for (std::uint32_t v; numbers >> v;) simplex.push_back(v);
            cycle.simplices.push_back(simplex);
        }
        cycles->push_back(cycle);
    }
    return {};
}

void write_cycles(const std::string& path, const std::vector<Cycle>& cycles) {
    std::ofstream file(path);
    for (const Cycle& cycle : cycles) {
        file << "bar " << cycle.degree << ' ' << exact_text(cycle.birth) << ' ' << exact_text(cycle.death) << ' '
             << cycle.simplices.size() << '\n';
        for (const auto& simplex : cycle.simplices)
            for (std::size_t i = 0; i < simplex.size(); i++)
                file << simplex[i] << (i + 1 < simplex.size() ? ' ' : '\n');
    }
}

std::string read_vines(const std::string& path, VineFile* vines) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        if (line.rfind("# k ", 0) == 0) {
            std::string mark, name, word;
            unsigned k;
            double ratio;
            if (!(words >> mark >> name >> k >> word) || !read_named(words, "ratio", &ratio)) return "not a k: " + line;
            vines->ratios.emplace_back(k, ratio);
        } else if (line.rfind("#", 0) != 0) {
            VinePoint point;
            if (!(words >> point.vine >> point.bar.degree >> point.k) || !read_number(words, &point.bar.birth) ||
                !read_number(words, &point.bar.death))
                return "not a vine: " + line;
            vines->points.push_back(point);
        }
    }
    return vines->ratios.empty() ? "no k" : "";
}

}  // namespace referee
