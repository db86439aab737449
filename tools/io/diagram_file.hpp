// Persistence diagrams in files: lines `degree birth death`.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.h"
#include "tools/io/text_writer.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

class Json;

// A point of a diagram. Radii; death is infinite for an essential class.
struct Bar {
    std::uint32_t degree;
    double birth, death;
};

inline bool operator==(const Bar& a, const Bar& b) {
    return a.degree == b.degree && a.birth == b.birth && a.death == b.death;
}
// The order of .pers files: degree, birth, death.
bool comes_before(const Bar& a, const Bar& b);

// Bars where they stand, read one at a time and as often as one likes: of a list, which must outlive this, or of
// anything else that visits them in their order.
class BarSource {
public:
    using Visit = std::function<void(const Bar&)>;
    BarSource(const std::vector<Bar>& bars)
        : count_(bars.size()), for_each_([&bars](const Visit& visit) {
              for (const Bar& bar : bars) visit(bar);
          }) {}
    BarSource(std::uint64_t count, std::function<void(const Visit&)> for_each)
        : count_(count), for_each_(std::move(for_each)) {}
    std::uint64_t size() const { return count_; }
    void for_each(const Visit& visit) const { for_each_(visit); }

private:
    std::uint64_t count_;
    std::function<void(const Visit&)> for_each_;
};

// What is surely known about a diagram: of each bar, and the certified ratio by scale.
struct Bounds {
    std::vector<netmesh_bar_bounds> bars;
    std::vector<netmesh_scale_step> steps;
    bool by_error = false;  // of a function: steps by differences
};

// With bounds, comments `# scale FROM low LOW high HIGH reach REACH ratio RATIO` (netmesh_scale_step) come first, of a
// function with `error ERROR` in place of the ratio, and
// every line ends in a comment: `# birth A B death C D exists`, the last word where the bar is certified to exist.
void write_diagram(const BarSource& bars, const Bounds& bounds, TextWriter& out);

// For other programs: a header and a bar a line, `inf` for deaths that are none, behind them the bounds if there are
// some; {"schema": 1, "bars": [[degree, birth, death], ...]}, with null for inf; doubles [bars][3].
void write_diagram_csv(const BarSource& bars, const Bounds& bounds, TextWriter& out);
// An entry `bars`, [degree, birth, death] each; infinity is null.
void write_json_bars(Json& json, const BarSource& bars, TextWriter* out = nullptr);  // out gets it on the way
void write_diagram_json(const BarSource& bars, TextWriter& out);
void write_diagram_npy(const BarSource& bars, TextWriter& out);

// A line that write_diagram makes of bounds; for `exists` files of version 0.2.0 have `real`.
struct BoundLine {
    std::uint64_t number;
    std::string text;
};
std::vector<BoundLine> bound_lines(std::string_view content);

// `degree birth death`: a complaint, or empty.
std::string parse_bar(std::string_view line, Bar* bar);

// Comments and blank lines are skipped; births are finite and >= 0, deaths >= births. Any order. lines[i], when asked
// for, is the physical line of bar i. Faults are Exit::data with file and line.
Outcome parse_diagram(std::string_view content, const std::string& name, std::vector<Bar>* bars,
                      std::vector<std::uint64_t>* lines = nullptr);

}  // namespace netmesh::tool
