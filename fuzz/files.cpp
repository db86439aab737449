// Bytes as files of every format that the tool reads; the first byte chooses the format. Each reader ends in data that
// keep their promises, or in bad data with a sentence that names the file.
#include <cmath>
#include <optional>
#include <string_view>

#include "fuzz/decoder.hpp"
#include "tools/io/complex_file.hpp"
#include "tools/io/cycle_file.hpp"
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/other_diagrams.hpp"
#include "tools/io/points.hpp"
#include "tools/io/provenance.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/vertex_function.hpp"

using namespace netmesh::tool;
using fuzz::require;

namespace {

constexpr const char* name = "a-file";

// True when there are data to look at.
bool ended(const Outcome& outcome) {
    if (outcome.good()) {
        require(outcome.message.empty());
        return true;
    }
    require(outcome.exit == Exit::data && outcome.message.find(name) != std::string::npos);
    for (const char c : outcome.message) require(static_cast<unsigned char>(c) >= ' ' || c == '\n');
    return false;
}

void check_cloud(const PointCloud& cloud) {
    require(cloud.dim >= dim_min && cloud.dim <= dim_max && cloud.coordinates.size() == cloud.rows() * cloud.dim);
    require(cloud.lines.empty() || cloud.lines.size() == cloud.rows());
    for (const double x : cloud.coordinates) require(std::isfinite(x) && (x != 0 || !std::signbit(x)));
    if (cloud.rows() > 0) require(!cloud.where(cloud.rows() - 1).empty() && !cloud.place(0).empty());
}

void read_points_by(Outcome (*parse)(std::string_view, PointCloud*), std::string_view content) {
    PointCloud cloud;
    cloud.name = name;
    if (ended(parse(content, &cloud))) check_cloud(cloud);
}

void read_atoms(std::string_view content) {
    for (Outcome (*parse)(std::string_view, bool, PointCloud*) : {parse_pdb_atoms, parse_pqr_atoms, parse_xyz_atoms}) {
        if (parse == parse_xyz_atoms && !is_chemical_xyz(content)) continue;
        for (const bool with_radii : {false, true}) {
            PointCloud cloud;
            cloud.name = name;
            const bool good = ended(parse(content, with_radii, &cloud));
            cloud.dim += with_radii;  // a radius stands behind each place
            if (good) check_cloud(cloud);
        }
    }
}

void check_table(const Outcome& outcome, const Table& table) {
    if (!ended(outcome)) return;
    require(table.width > 0 && table.rows() > 0 && table.values.size() == table.rows() * table.width);
    require(table.lines.empty() || table.lines.size() == table.rows());
    for (const double x : table.values) require(std::isfinite(x) && (x != 0 || !std::signbit(x)));
    for (const char c : table.note) require(static_cast<unsigned char>(c) >= ' ');
}

void read_array(std::string_view content) {
    Table table;
    table.name = name;
    check_table(parse_npz_table(content, "", {}, &table), table);
}

// A table read by options: the first bytes choose them.
void read_asked(std::string_view content) {
    if (content.size() < 3) return;
    TableOptions options;
    constexpr char delimiters[] = {0, ',', ';', '\t', ' ', '|', ':', '/'};
    options.delimiter = delimiters[static_cast<unsigned char>(content[0]) % 8];
    options.skip = static_cast<unsigned char>(content[1]) % 4;
    constexpr const char* columns[] = {"", "1", "2,1", "2-4", "x,y", "1,x"};
    const std::string chosen = columns[static_cast<unsigned char>(content[2]) % 6];
    if (!chosen.empty()) require(parse_columns(chosen, &options.columns).empty());
    Table table;
    table.name = name;
    check_table(parse_table(content.substr(3), options, &table), table);
}

void read_node(std::string_view content) {
    NodeFile node;
    node.cloud.name = name;
    if (!ended(parse_node(content, &node))) return;
    check_cloud(node.cloud);
    const std::size_t rows = node.cloud.rows();
    require(node.markers.size() == rows && node.attributes.size() == rows * node.attribute_count);
    require(node.first_id <= 1 && (node.domain.empty() || node.domain.size() == node.cloud.dim + 1u));
    for (const netmesh_cage& cage : node.cages) require(cage.centre < rows);
}

void read_cells(std::string_view content) {
    if (content.empty()) return;
    const unsigned how = static_cast<unsigned char>(content[0]);
    CellTable table;
    table.name = name;
    table.columns = 3 + how % 5;
    EntryRange range;
    range.first_id = how / 32 % 2;
    range.limit = how / 8 % 2 == 0 ? 6 : 1000;
    range.allow_outside = how / 16 % 2 != 0;
    if (!ended(parse_cell_table(content.substr(1), range, &table))) return;
    require(table.entries.size() % table.columns == 0);
    for (const std::uint32_t v : table.entries) require(v < range.limit || (range.allow_outside && v == NETMESH_NONE));
}

void read_diagram(std::string_view content) {
    std::vector<Bar> any, bars, again;
    if (ended(parse_any_diagram(content, name, &any)))
        for (const Bar& bar : any) require(std::isfinite(bar.birth) && bar.death >= bar.birth);
    std::vector<std::uint64_t> lines;
    if (!ended(parse_diagram(content, name, &bars, &lines))) return;
    require(lines.size() == bars.size());
    for (const Bar& bar : bars) require(std::isfinite(bar.birth) && bar.birth >= 0 && bar.death >= bar.birth);
    TextWriter text;
    write_diagram(bars, {}, text);
    require(parse_diagram(text.text(), name, &again).good() && again == bars);
    for (const BoundLine& line : bound_lines(content)) require(line.number > 0 && !line.text.empty());
}

// What is read from a head writes the same head again.
void read_head(std::string_view content) {
    std::optional<Provenance> found, again;
    if (!ended(parse_head(content, name, &found)) || !found) return;
    const netmesh_request& asked = found->options.request;
    require(found->options.command == Command::persist && asked.filter != nullptr && asked.max_degree != NETMESH_OPEN);
    for (const HeadLine& line : found->lines) require(line.number > 0 && found->find(line.name) == &line);
    TextWriter text;
    write_head(found->lines, text);
    require(parse_head(text.text(), name, &again).good() && again && again->lines.size() == found->lines.size());
    for (std::size_t i = 0; i < found->lines.size(); ++i)
        require(head_text(again->lines[i]) == head_text(found->lines[i]));
    require(check_contradiction(*found, name, Options{}).good());
}

void read_cycles(std::string_view content) {
    std::vector<CycleEntry> cycles;
    if (!ended(parse_cycles(content, name, &cycles))) return;
    for (const CycleEntry& entry : cycles) {
        require(entry.line > 0 && std::isfinite(entry.bar.birth) && entry.bar.death >= entry.bar.birth);
        for (const auto& vertices : entry.simplices) require(vertices.size() == entry.bar.degree + 1u);
    }
}

void read_vines(std::string_view content) {
    VineFile file;
    if (!ended(parse_vines(content, name, &file))) return;
    const Vines& vines = file.vines;
    require(!vines.ratios.empty() && file.lines.size() == vines.points.size());
    require(file.choice.filter == NETMESH_FILTER_KNN || file.choice.filter == NETMESH_FILTER_KDISTANCE);
    for (std::size_t i = 0; i < vines.points.size(); ++i) {
        const netmesh_vine_point& p = vines.points[i];
        require(p.k >= vines.k_first && p.k - vines.k_first < vines.ratios.size());
        require(std::isfinite(p.birth) && p.birth >= 0 && p.death > p.birth);
        require(i == 0 ? p.vine == 0 : p.vine - vines.points[i - 1].vine <= 1);
    }
}

void read_complex(std::string_view content) {
    SimplexFile file;
    file.lines.name = name;
    if (!ended(parse_simplices(content, &file))) return;
    require(file.starts.size() == file.count() + 1 && file.starts.back() == file.vertices.size());
    for (std::uint64_t i = 0; i < file.count(); ++i) {
        require(file.starts[i + 1] > file.starts[i] && file.starts[i + 1] - file.starts[i] <= 32);
        require(std::isfinite(file.values[i]) && !simplex_text(file, i).empty());
    }
}

void read_vertex_values(std::string_view content) {
    for (const std::size_t count : {1, 3}) {
        PointCloud cloud;
        cloud.name = name;
        cloud.dim = 2;
        cloud.coordinates.resize(2 * count);
        std::vector<double> values;
        std::vector<std::uint64_t> lines;
        if (!ended(parse_vertex_values(content, name, cloud, &values, &lines))) continue;
        require(values.size() == count && lines.size() == count && lines[0] > 0);
        for (const double value : values) require(std::isfinite(value));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 17) {
    case 0: read_points_by(parse_text_points, content); break;
    case 1: read_points_by(parse_npy_points, content); break;
    case 2: read_points_by(parse_off_points, content); break;
    case 3: read_points_by(parse_ply_points, content); break;
    case 4: read_points_by(parse_node_points, content); break;
    case 5: read_node(content); break;
    case 6: read_cells(content); break;
    case 7:
        read_diagram(content);
        read_head(content);
        break;
    case 9: read_vines(content); break;
    case 10: read_cycles(content); break;
    case 11: read_vertex_values(content); break;
    case 12: read_points_by(parse_obj_points, content); break;
    case 13: read_points_by(parse_stl_points, content); break;
    case 14: read_atoms(content); break;
    case 15: read_array(content); break;
    case 16: read_asked(content); break;
    default: read_complex(content); break;
    }
    return 0;
}
