#include "tools/vertex_function.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

Outcome parse_vertex_values(std::string_view content, const std::string& name, const PointCloud& cloud,
                            std::vector<double>* values, std::vector<std::uint64_t>* lines) {
    LineReader reader(content);
    std::string_view line;
    std::vector<double> numbers;
    const std::string due = cloud.name + " has " + counted(cloud.rows(), "vertex", "vertices");
    while (reader.next_content(&line)) {
        Complaint complaint = parse_numbers(line, &numbers);
        if (complaint.empty() && numbers.size() != 1)
            complaint = counted(numbers.size(), "value", "values") + "; a line is the value at one vertex";
        if (complaint.empty() && values->size() == cloud.rows()) complaint = "a value too many; " + due;
        if (!complaint.empty()) return line_error(name, reader.number(), complaint);
        values->push_back(numbers[0]);
        lines->push_back(reader.number());
    }
    if (values->size() == cloud.rows()) return {};
    return line_error(name, std::max<std::uint64_t>(reader.number(), 1),
                      "the input ends after " + counted(values->size(), "value", "values") + "; " + due);
}

Outcome VertexFunction::read(const std::string& path, const PointCloud& cloud, VertexFunction* function) {
    VertexFunction f;
    f.name_ = shown_name(path);
    std::string content;
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_vertex_values(content, f.name_, cloud, &f.values_, &f.lines_);
    if (!outcome.good()) return outcome;
    f.dim_ = cloud.dim;
    f.coordinates_ = cloud.coordinates;
    f.sorted_.resize(cloud.rows());
    for (std::size_t v = 0; v < f.sorted_.size(); v++) f.sorted_[v] = v;
    std::sort(f.sorted_.begin(), f.sorted_.end(),
              [&](std::size_t a, std::size_t b) { return f.compare(a, f.coordinates_.data() + b * f.dim_) < 0; });
    *function = std::move(f);
    return {};
}

int VertexFunction::compare(std::size_t vertex, const double* x) const {
    const double* const at = coordinates_.data() + vertex * dim_;
    for (std::uint32_t k = 0; k < dim_; k++)
        if (at[k] != x[k]) return at[k] < x[k] ? -1 : 1;
    return 0;
}

double VertexFunction::operator()(const double* x) const {
    const auto at = std::partition_point(sorted_.begin(), sorted_.end(),
                                         [&](std::size_t vertex) { return compare(vertex, x) < 0; });
    const bool found = at != sorted_.end() && compare(*at, x) == 0;
    return found ? values_[*at] : std::numeric_limits<double>::quiet_NaN();
}

// FNV-1a of the bytes, the least significant of each number first.
std::string VertexFunction::fingerprint(const std::vector<double>& numbers) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const double number : numbers) {
        std::uint64_t bits;
        std::memcpy(&bits, &number, sizeof bits);
        for (int byte = 0; byte < 8; byte++, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3u;
    }
    return hexadecimal(hash);
}

}  // namespace netmesh::tool
