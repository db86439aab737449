#include "tools/io/cycle_file.hpp"

#include <algorithm>

#include "netmesh.h"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

Complaint parse_simplex(std::string_view line, std::uint32_t degree, std::vector<std::uint32_t>* vertices) {
    for (const std::string_view word : split_blanks(line)) {
        std::uint64_t vertex;
        if (!parse_unsigned(std::string(word), &vertex) || vertex >= NETMESH_NONE)
            return quoted(word) + " is not a vertex";
        vertices->push_back(static_cast<std::uint32_t>(vertex));
    }
    if (vertices->size() != degree + std::size_t{1})
        return counted(vertices->size(), "vertex", "vertices") + "; a simplex of this bar has " +
               std::to_string(degree + 1);
    if (std::is_sorted(vertices->begin(), vertices->end())) return "";
    return "the vertices do not ascend";
}

}  // namespace

Outcome parse_cycles(std::string_view content, const std::string& name, std::vector<CycleEntry>* cycles) {
    LineReader reader(content);
    std::string_view line;
    std::uint64_t left = 0;  // simplices of the last bar
    while (reader.next_content(&line)) {
        if (left > 0) {
            CycleEntry& entry = cycles->back();
            entry.simplices.emplace_back();
            const Complaint complaint = parse_simplex(line, entry.bar.degree, &entry.simplices.back());
            if (!complaint.empty()) return line_error(name, reader.number(), complaint);
            left--;
            continue;
        }
        const std::vector<std::string_view> words = split_blanks(line);
        CycleEntry entry;
        entry.line = reader.number();
        if (words.size() != 5 || words[0] != "bar" || !parse_unsigned(std::string(words[4]), &left))
            return line_error(name, reader.number(), "not `bar DEGREE BIRTH DEATH N`");
        const Complaint complaint = parse_bar(line.substr(4, line.rfind(words[4]) - 4), &entry.bar);
        if (!complaint.empty()) return line_error(name, reader.number(), complaint);
        cycles->push_back(std::move(entry));
    }
    if (left == 0) return {};
    return line_error(name, reader.number(), "the file ends before the cycle does");
}

}  // namespace netmesh::tool
