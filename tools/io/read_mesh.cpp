#include <algorithm>
#include <iterator>

#include "tools/io/lines.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

Complaint keep_domain(const std::vector<double>& numbers, NodeFile* node) {
    if (numbers.size() < dim_min + 1 || numbers.size() > dim_max + 1 || !(numbers.back() > 0))
        return "a domain is a centre and a radius above 0";
    node->domain = numbers;
    return {};
}

Complaint keep_cage(const std::vector<double>& numbers, NodeFile* node) {
    if (numbers.size() != 2 || !is_count(numbers[0]) || !(numbers[0] < NETMESH_NONE) || !(numbers[1] > 0))
        return "a cage is the id of its centre and a radius above 0";
    const std::uint32_t centre = static_cast<std::uint32_t>(numbers[0]);
    node->cages.push_back({sizeof(netmesh_cage), centre, NETMESH_NONE, numbers[1]});
    return {};
}

Complaint keep_size(const std::vector<double>& numbers, NodeFile* node) {
    if (numbers.size() != 2 || !(numbers[0] > 0) || !(numbers[1] >= 0))
        return "a cell-size is a number above 0 and one of 0 or more";
    node->size_at_inputs = numbers[0];
    node->size_growth = numbers[1];
    return {};
}

Complaint keep_clipped(std::size_t words, NodeFile* node) {
    if (words != 1) return "clipped is a word alone";
    if (node->clipped) return "clipped is said twice";
    if (node->domain.empty() || !(node->ratio > 0)) return "clipped stands behind a domain and a ratio";
    node->clipped = true;
    return {};
}

// `# domain c1 .. cD r`, `# tau T`, `# ratio C`, `# clipped`, `# eps E`, `# cell-size A B`, `# boundary-net S`, `#
// cages thesis` and
// `# cage V R`; other comments say nothing.
Complaint parse_remark(std::string_view raw, NodeFile* node) {
    const std::vector<std::string_view> words = split_blanks(raw.substr(1));
    if (!words.empty() && words[0] == "cages") {
        node->has_thesis_cages = true;
        if (words.size() == 2 && words[1] == "thesis") return {};
        return "cages of a kind that is not known: " + std::string(raw);
    }
    if (!words.empty() && words[0] == "clipped") return keep_clipped(words.size(), node);
    static constexpr std::string_view known[] = {"domain", "tau", "ratio", "eps", "cell-size", "boundary-net", "cage"};
    if (words.empty() || std::find(std::begin(known), std::end(known), words[0]) == std::end(known)) return {};
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); i++) {
        double value;
        if (!parse_finite(std::string(words[i]), &value)) return not_a_number(words[i]);
        numbers.push_back(value);
    }
    if (words[0] == "domain") return keep_domain(numbers, node);
    if (words[0] == "cage") return keep_cage(numbers, node);
    if (words[0] == "cell-size") return keep_size(numbers, node);
    const double number = numbers.size() == 1 ? numbers[0] : 0;
    if (words[0] == "tau") {
        node->tau = number;
        return number > 2 ? "" : "tau is one number above 2";
    }
    if (words[0] == "ratio") {
        node->ratio = number;
        return number >= 1.4143 ? "" : "ratio is one number, at least 1.4143";
    }
    if (words[0] == "boundary-net") {
        node->net_spacing = number;
        return number >= 1.0 / 64 && number <= 8 ? "" : "boundary-net is one number from 1/64 to 8";
    }
    node->eps = number;
    return number > 0 ? "" : "eps is one number above 0";
}

// Lines with comments kept, so that remarks are seen; content lines come without theirs.
bool next_node_line(LineReader& reader, NodeFile* node, std::string_view* line, Outcome* outcome) {
    while (reader.next(line)) {
        if (!line->empty() && line->front() == '#') {
            const Complaint complaint = parse_remark(*line, node);
            if (complaint.empty()) continue;
            *outcome = line_error(node->cloud.name, reader.number(), complaint);
            return false;
        }
        *line = line->substr(0, line->find('#'));
        if (!line->empty()) return true;
    }
    return false;
}

struct NodeHeader {
    std::uint64_t count = 0;
    bool known = false;
};

Complaint parse_node_header(const std::vector<double>& numbers, NodeFile* node, NodeHeader* header) {
    if (numbers.size() < 2 || numbers.size() > 4) return "the header is: count D attributes marker";
    for (const double number : numbers) {
        if (!is_count(number)) return "the header holds a number that is not a count";
    }
    if (numbers[1] < dim_min || numbers[1] > dim_max) {
        return "dimension " + std::to_string(static_cast<std::uint64_t>(numbers[1])) +
               "; points have 2 to 6 coordinates";
    }
    if (numbers[0] == 0) return "no vertices: no point";
    if (numbers.size() > 2 && numbers[2] > 1000) return "more than 1000 attributes";
    if (numbers.size() > 3 && numbers[3] > 1) return "the header's marker is 0 or 1";
    header->count = static_cast<std::uint64_t>(numbers[0]);
    header->known = true;
    node->cloud.dim = static_cast<std::uint32_t>(numbers[1]);
    node->attribute_count = numbers.size() > 2 ? static_cast<std::uint32_t>(numbers[2]) : 0;
    node->has_markers = numbers.size() > 3 && numbers[3] == 1;
    return {};
}

Complaint parse_node_row(const std::vector<double>& numbers, std::uint64_t row, NodeFile* node) {
    const std::size_t dim = node->cloud.dim, attributes = node->attribute_count;
    const std::size_t due = 1 + dim + attributes + (node->has_markers ? 1 : 0);
    if (numbers.size() != due) {
        return counted(numbers.size(), "number", "numbers") + " where " + std::to_string(due) + " are due";
    }
    if (row == 0) {
        if (numbers[0] != 0 && numbers[0] != 1) return "ids start at 0 or 1";
        node->first_id = static_cast<std::uint64_t>(numbers[0]);
    }
    if (numbers[0] != static_cast<double>(row + node->first_id)) {
        return "id " + number_text(numbers[0]) + " where " + std::to_string(row + node->first_id) + " is due";
    }
    const auto at = numbers.begin() + 1;
    node->cloud.coordinates.insert(node->cloud.coordinates.end(), at, at + static_cast<std::ptrdiff_t>(dim));
    node->attributes.insert(node->attributes.end(), at + static_cast<std::ptrdiff_t>(dim),
                            at + static_cast<std::ptrdiff_t>(dim + attributes));
    const double marker = node->has_markers ? numbers.back() : 0;
    // Other programs use markers of their own; they stand for nothing here, and any small number will do.
    node->markers.push_back(is_count(marker) && marker < 255 ? static_cast<std::uint8_t>(marker) : 255);
    return {};
}

}  // namespace

Outcome parse_node(std::string_view content, NodeFile* node) {
    LineReader reader(content, false);
    std::string_view line;
    std::vector<double> numbers;
    NodeHeader header;
    std::uint64_t row = 0;
    Outcome outcome;
    while (next_node_line(reader, node, &line, &outcome)) {
        Complaint complaint = parse_numbers(line, &numbers);
        if (complaint.empty() && !header.known) {
            complaint = parse_node_header(numbers, node, &header);
        } else if (complaint.empty() && row == header.count) {
            complaint = "more than the " + counted(header.count, "vertex", "vertices") + " of the header";
        } else if (complaint.empty()) {
            complaint = parse_node_row(numbers, row, node);
            node->cloud.lines.push_back(reader.number());
            row++;
        }
        if (!complaint.empty()) return line_error(node->cloud.name, reader.number(), complaint);
    }
    if (!outcome.good()) return outcome;
    const std::uint64_t last = reader.number() == 0 ? 1 : reader.number();
    if (!header.known) return line_error(node->cloud.name, last, "the input ends without a point");
    if (row < header.count) {
        return line_error(node->cloud.name, last,
                          "the file ends after " + std::to_string(row) + " of " +
                              counted(header.count, "vertex", "vertices"));
    }
    for (netmesh_cage& cage : node->cages) {
        if (cage.centre < node->first_id || cage.centre - node->first_id >= header.count || node->domain.empty()) {
            return line_error(node->cloud.name, last, "a cage about a vertex that is not there, or without a domain");
        }
        cage.centre -= static_cast<std::uint32_t>(node->first_id);
    }
    if (!node->domain.empty() && node->domain.size() != node->cloud.dim + 1) {
        return line_error(node->cloud.name, last, "the domain has another dimension than the vertices");
    }
    return {};
}

Outcome parse_node_points(std::string_view content, PointCloud* cloud) {
    NodeFile node;
    node.cloud.name = cloud->name;
    const Outcome outcome = parse_node(content, &node);
    *cloud = node.cloud;
    return outcome;
}

namespace {

// count columns [attributes]
struct CellHeader {
    bool known = false;
    std::uint64_t count = 0;
    std::size_t attributes = 0;
};

Complaint parse_cell_header(const std::vector<double>& numbers, const EntryRange& range, const CellTable& table,
                            CellHeader* header) {
    header->known = true;
    const bool has_attributes = numbers.size() == 3;
    if (numbers.size() < 2 || numbers.size() > 3 || !is_count(numbers[0]) ||
        numbers[1] != static_cast<double>(table.columns) ||
        (has_attributes && !(is_count(numbers[2]) && numbers[2] < 1000))) {
        return "the header is: count " + std::to_string(table.columns);
    }
    header->count = static_cast<std::uint64_t>(numbers[0]);
    header->attributes = has_attributes ? static_cast<std::size_t>(numbers[2]) : 0;
    return range.allow_outside && range.limit != header->count ? "not as many rows as there are cells" : "";
}

Complaint parse_cell_row(const std::vector<double>& numbers, const CellHeader& header, const EntryRange& range,
                         CellTable* table) {
    const std::uint64_t row = table->lines.size();
    if (row == header.count) return "more than the " + counted(header.count, "row", "rows") + " of the header";
    const std::size_t due = 1 + table->columns + header.attributes;
    if (numbers.size() != due) {
        return counted(numbers.size(), "number", "numbers") + " where " + std::to_string(due) + " are due";
    }
    if (numbers[0] != static_cast<double>(row + range.first_id)) {
        return "id " + number_text(numbers[0]) + " where " + std::to_string(row + range.first_id) + " is due";
    }
    for (std::uint32_t k = 1; k <= table->columns; k++) {
        const double index = numbers[k] - static_cast<double>(range.first_id);
        if (range.allow_outside && numbers[k] == -1) {
            table->entries.push_back(NETMESH_NONE);
        } else if (is_count(index) && index < static_cast<double>(range.limit)) {
            table->entries.push_back(static_cast<std::uint32_t>(index));
        } else {
            return "index " + number_text(numbers[k]) + " does not exist";
        }
    }
    return {};
}

}  // namespace

Outcome parse_cell_table(std::string_view content, const EntryRange& range, CellTable* table) {
    LineReader reader(content);
    std::string_view line;
    std::vector<double> numbers;
    CellHeader header;
    while (reader.next_content(&line)) {
        Complaint complaint = parse_numbers(line, &numbers);
        if (complaint.empty() && !header.known) {
            complaint = parse_cell_header(numbers, range, *table, &header);
        } else if (complaint.empty()) {
            complaint = parse_cell_row(numbers, header, range, table);
            table->lines.push_back(reader.number());
        }
        if (!complaint.empty()) return line_error(table->name, reader.number(), complaint);
    }
    const std::uint64_t rows = table->lines.size();
    if (!header.known || rows < header.count) {
        return line_error(table->name, reader.number() == 0 ? 1 : reader.number(),
                          "the file ends after " + std::to_string(rows) + " of " +
                              counted(header.count, "row", "rows"));
    }
    return {};
}

Outcome read_mesh_files(const std::string& path, MeshFiles* files) {
    std::string content;
    files->node.cloud.name = shown_name(path);
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_node(content, &files->node);
    if (!outcome.good()) return outcome;
    const std::uint64_t first_id = files->node.first_id;
    const std::string stem = path.substr(0, path.size() - ending_of(path).size());
    files->cells.name = stem + ".ele";
    files->neighbours.name = stem + ".neigh";
    files->cells.columns = files->neighbours.columns = files->node.cloud.dim + 1;
    outcome = read_content(files->cells.name, &content);
    if (!outcome.good()) return outcome;
    outcome = parse_cell_table(content, {first_id, files->node.cloud.rows(), false}, &files->cells);
    if (!outcome.good()) return outcome;
    outcome = read_content(files->neighbours.name, &content);
    if (!outcome.good()) return outcome;
    return parse_cell_table(content, {first_id, files->cells.lines.size(), true}, &files->neighbours);
}

}  // namespace netmesh::tool
