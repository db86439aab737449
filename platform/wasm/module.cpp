// netmesh for a page: points in, mesh and diagram out, in memory of fixed size that the module owns. No imports.
// Numbers of 64 bits cross the border as doubles, which hold every count exactly.
#include <cstddef>
#include <cstdint>

#include "determinism/slice.hpp"
#include "netmesh.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name), visibility("default")))

namespace {

constexpr std::size_t coordinates_max = 1 << 19, arena_bytes = std::size_t{56} << 20, text_bytes = 1 << 15;

alignas(16) unsigned char arena[arena_bytes];
double coordinates[coordinates_max];
const netmesh_context* context;
netmesh_report report;
char text[text_bytes];
std::size_t text_length;

void add_line(const char* line) {
    for (; *line != 0 && text_length < text_bytes - 2; ++line) text[text_length++] = *line;
    text[text_length++] = '\n';
    text[text_length] = 0;
}

template <class Item>
const Item* item_at(netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*), std::uint32_t i) {
    static Item item;
    item.struct_bytes = sizeof item;
    return get(context, i, &item) == NETMESH_OK ? &item : nullptr;
}

}  // namespace

// Where the page puts the coordinates, row by row, and how many there is room for.
EXPORT(points) double* points() { return coordinates; }
EXPORT(coordinates_max) std::uint32_t most_coordinates() { return coordinates_max; }
EXPORT(arena_bytes) std::uint32_t all_bytes() { return arena_bytes; }

// Mesh and diagram of the first n points; a netmesh_status. tau 0: the dimension's default.
EXPORT(run) int run(std::uint32_t n, std::uint32_t dim, double tau) {
    netmesh::requests::Mesh mesh(dim);
    mesh.points = coordinates;
    mesh.point_count = n;
    mesh.purpose = NETMESH_PURPOSE_PERSIST;
    mesh.tau = tau;
    netmesh::Engine engine(arena, sizeof arena);
    netmesh_status status = engine.status();
    if (status == NETMESH_OK) status = engine.mesh(mesh);
    if (status == NETMESH_OK) status = engine.persist();
    context = engine.context();
    report = engine.report();
    return status;
}
EXPORT(status_text) const char* text_of_status(int status) {
    return netmesh_status_text(static_cast<netmesh_status>(status));
}

// Of the last run.
EXPORT(vertices) double vertex_count() { return static_cast<double>(report.mesh.vertices); }
EXPORT(inputs) double input_count() { return static_cast<double>(report.mesh.inputs); }
EXPORT(cells) double cell_count() { return static_cast<double>(report.mesh.cells); }
EXPORT(simplices) double simplex_count() { return static_cast<double>(report.diagram.simplices); }
EXPORT(peak_bytes) double peak() { return static_cast<double>(report.memory.peak_bytes); }
EXPORT(aspect_ratio) double worst_aspect_ratio() { return report.mesh.aspect_ratio_max; }
EXPORT(certified_ratio) double ratio() { return report.diagram.certified_ratio; }
EXPORT(fingerprint_high) std::uint32_t high_half() { return static_cast<std::uint32_t>(report.fingerprint >> 32); }
EXPORT(fingerprint_low) std::uint32_t low_half() { return static_cast<std::uint32_t>(report.fingerprint); }

// Item i of the last run, as the struct of netmesh.h; null past the end.
EXPORT(vertex) const netmesh_vertex* vertex_at(std::uint32_t i) { return item_at(netmesh_get_vertex, i); }
EXPORT(cell) const netmesh_cell* cell_at(std::uint32_t i) { return item_at(netmesh_get_cell, i); }
EXPORT(pair) const netmesh_pair* pair_at(std::uint32_t i) { return item_at(netmesh_get_pair, i); }

// The lines of the slice of tests/determinism, as text that ends in a zero.
EXPORT(fingerprints) const char* fingerprints() {
    text_length = 0;
    slice::run(arena, sizeof arena, NETMESH_DIM_MIN, NETMESH_DIM_MAX, add_line);
    for (int dim = 2; dim <= 3; ++dim) slice::demo(dim, arena, slice::demo_bytes, &report, add_line);
    return text;
}
