// Diagrams for other programs: .csv, .json and .npy.
#include <cstring>

#include "tools/io/diagram_file.hpp"
#include "tools/io/npy_writer.hpp"
#include "tools/report/json.hpp"

namespace netmesh::tool {

void write_diagram_csv(const BarSource& bars, const Bounds& known, TextWriter& out) {
    const bool bounded = known.bars.size() == bars.size() && bars.size() > 0;
    out << "degree,birth,death" << (bounded ? ",birth_low,birth_high,death_low,death_high,exists\n" : "\n");
    std::size_t i = 0;
    bars.for_each([&](const Bar& bar) {
        out << bar.degree << ',' << bar.birth << ',' << bar.death;
        if (bounded) {
            const netmesh_bar_bounds& b = known.bars[i++];
            out << ',' << b.birth_low << ',' << b.birth_high << ',' << b.death_low << ',' << b.death_high << ','
                << (b.certain != 0 ? '1' : '0');
        }
        out << '\n';
    });
}

void write_json_bars(Json& json, const BarSource& bars, TextWriter* out) {
    json.key("bars");
    json.open('[');
    bars.for_each([&](const Bar& bar) {
        json.open('[');
        json.value(bar.degree);
        json.value(bar.birth);
        json.value(bar.death);
        json.close(']');
        if (out != nullptr) *out << json.take();
    });
    json.close(']');
}

void write_diagram_json(const BarSource& bars, TextWriter& out) {
    Json json;
    json.open('{');
    json.entry("schema", std::uint64_t{1});
    write_json_bars(json, bars, &out);
    json.close('}');
    out << json.text();
}

void write_diagram_npy(const BarSource& bars, TextWriter& out) {
    write_npy_head(bars.size(), 3, out);
    bars.for_each([&](const Bar& bar) {
        write_npy_double(bar.degree, out);
        write_npy_double(bar.birth, out);
        write_npy_double(bar.death, out);
    });
}

void write_npy_head(std::uint64_t rows, std::uint64_t columns, TextWriter& out) {
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
                         std::to_string(columns) + "), }";
    while ((10 + header.size() + 1) % 64 != 0) header += ' ';
    header += '\n';
    out << std::string_view("\x93NUMPY\x01\x00", 8) << static_cast<char>(header.size() & 255)
        << static_cast<char>(header.size() >> 8) << header;
}

void write_npy_double(double number, TextWriter& out) {
    const double value = number + 0.0;  // -0.0 becomes 0.0
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    char bytes[8];
    for (int i = 0; i < 8; i++) bytes[i] = static_cast<char>(bits >> (8 * i) & 255);
    out << std::string_view(bytes, 8);
}

}  // namespace netmesh::tool
