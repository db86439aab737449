// A diagram as the tool's files say it: lines `degree birth death` behind a head of remarks.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace referee {

struct Bar {
    int degree = 0;
    double birth = 0, death = 0;  // infinity for an essential class
    bool bounded = false;         // the line has what follows
    double birth_low = 0, birth_high = 0, death_low = 0, death_high = 0;
    bool real = false;
};

// From the radius `from` on, up to the next step's.
struct Step {
    double from = 0, low = 0, high = 0, reach = 0, ratio = 1;
};

struct DiagramFile {
    std::vector<std::pair<std::string, std::string>> head;  // `# name value`
    std::vector<Step> steps;
    std::vector<Bar> bars;

    bool has(const std::string& name) const;
    std::string text(const std::string& name) const;                 // empty: no such line
    double number(const std::string& name, double otherwise) const;  // of the line's first word
    void set(const std::string& name, const std::string& value);
    double ratio() const { return number("certified-ratio", 0); }
};

// Shortest text that reads as the same double; inf.
std::string exact_text(double x);

// An empty text, or what is wrong.
std::string read_diagram(const std::string& path, DiagramFile* diagram);
void write_diagram(const std::string& path, const DiagramFile& diagram);

// Of a run with --json: the text of "name" in the object "part", on one line; empty when it is not there.
std::string json_text(const std::string& json, const std::string& part, const std::string& name);
std::vector<double> json_numbers(const std::string& text);  // brackets are skipped; null is infinity, true 1, false 0

struct Cycle {
    int degree = 0;
    double birth = 0, death = 0;
    std::vector<std::vector<std::uint32_t>> simplices;
};
std::string read_cycles(const std::string& path, std::vector<Cycle>* cycles);
void write_cycles(const std::string& path, const std::vector<Cycle>& cycles);

struct VinePoint {
    unsigned vine = 0, k = 0;
    Bar bar;
};
struct VineFile {
    std::vector<std::pair<unsigned, double>> ratios;  // of each k
    std::vector<VinePoint> points;
};
std::string read_vines(const std::string& path, VineFile* vines);

}  // namespace referee
