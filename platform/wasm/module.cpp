// netmesh for a page: points in, mesh and diagram out, in a block behind the program that the page makes as large as it
// wants to: the module has no imports and never asks for memory. Numbers of 64 bits cross the border as doubles, which
// hold every count exactly.
#include <cstddef>
#include <cstdint>

#include "determinism/slice.hpp"
#include "netmesh.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name), visibility("default")))

extern "C" unsigned char __heap_base;  // by the linker: the first byte that the program does not use

namespace {

constexpr std::size_t text_bytes = 1 << 15;

netmesh_context* context;
netmesh_report report;
netmesh_detail detail;
netmesh_filter_info filter;
netmesh_monitor monitor;
double lattice[NETMESH_DIM_MAX * NETMESH_DIM_MAX];
std::uint32_t lattice_count;
char text[text_bytes];
std::size_t text_length;

void add_line(const char* line) {
    for (; *line != 0 && text_length < text_bytes - 2; ++line) text[text_length++] = *line;
    text[text_length++] = '\n';
    text[text_length] = 0;
}

template <class Item>
const Item* item_at(netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*), double i) {
    static Item item;
    item.struct_bytes = sizeof item;
    return get(context, static_cast<std::uint64_t>(i), &item) == NETMESH_OK ? &item : nullptr;
}

// Of that number, 0: the engine chooses; null: there is none.
const netmesh_filter* choose(std::uint32_t id) {
    const netmesh_filter* found = id == 0 ? &netmesh_filter_auto : nullptr;
    netmesh::for_each_filter([&](const netmesh_filter_info& info) {
        if (info.id != static_cast<netmesh_filter_id>(id)) return;
        filter = info;
        found = info.filter;
    });
    return found;
}

// ratio 0: what the dimension's tau promises.
netmesh::Request request_of(const double* points, std::uint32_t n, std::uint32_t dim, std::uint32_t id, std::uint32_t k,
                            std::uint32_t max_degree, double ratio) {
    filter = {};
    netmesh::Request request(choose(id));
    request.points = {points, n, dim, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
    if (lattice_count != 0) {
        request.points.lattice = lattice;
        request.points.lattice_count = lattice_count;
        request.periods = &netmesh_periodic;
    }
    request.max_degree = max_degree;
    request.monitor = monitor;
    if (filter.needs_k != 0) request.k = k;
    if (filter.is_on_mesh != 0) {
        request.mesh.method = &netmesh_method_certificate;
        request.goal.ratio = ratio;
    }
    return request;
}

}  // namespace

// Where the page's memory begins: coordinates, row by row, and behind them, at a multiple of 16, the block.
EXPORT(heap) unsigned char* heap() {
    return &__heap_base + (16 - reinterpret_cast<std::uintptr_t>(&__heap_base) % 16) % 16;
}

// A function of the page's, an index of the table, that is called now and then with a netmesh_progress; 0: none.
EXPORT(watch) void watch(std::uint32_t poll) { monitor.poll = reinterpret_cast<netmesh_poll>(poll); }

// Of points that repeat: where so many vectors of as many coordinates as points have are written, one behind the other,
// before plan and run, which read them; null: they are too many.
EXPORT(repeat) double* repeat(std::uint32_t count) {
    lattice_count = count <= NETMESH_DIM_MAX ? count : 0;
    return lattice_count != 0 ? lattice : nullptr;
}

// Bytes to plan for; 0 when nothing is known about such a request. id: of a filter, 0: the engine chooses.
EXPORT(plan)
double plan(std::uint32_t n, std::uint32_t dim, std::uint32_t id, std::uint32_t k, std::uint32_t max_degree,
            double ratio) {
    return static_cast<double>(netmesh::plan(request_of(nullptr, n, dim, id, k, max_degree, ratio)));
}

// Mesh and diagram of n points in block[0, bytes); a netmesh_status.
EXPORT(run)
int run(const double* points, std::uint32_t n, std::uint32_t dim, void* block, std::uint32_t bytes, std::uint32_t id,
        std::uint32_t k, std::uint32_t max_degree, double ratio, std::uint32_t bounds, std::uint32_t cycles) {
    context = nullptr;
    report = {};
    detail = netmesh::sized<netmesh_detail>();
    netmesh::Engine engine(block, bytes);
    if (engine.status() != NETMESH_OK) return engine.status();
    netmesh::Request request = request_of(points, n, dim, id, k, max_degree, ratio);
    if (filter.is_on_points == 0 && bounds != 0) request.bounds = &netmesh_bounds;
    if ((id == 0 || filter.has_representatives != 0) && cycles != 0) request.cycles = &netmesh_cycles;
    // With periods the engine keeps no triangulation, of which the page draws the complex.
    request.keep_mesh = lattice_count == 0 && (id == 0 || filter.is_on_triangulation != 0);
    const netmesh_status status = engine.persist(request);
    context = engine.context();
    report = engine.report();
    detail = engine.detail();
    return status;
}
EXPORT(status_text) const char* text_of_status(int status) {
    return netmesh_status_text(static_cast<netmesh_status>(status));
}
EXPORT(version) const char* version_text() { return netmesh_version_text(); }

// Of the last run.
EXPORT(message) const char* message() { return detail.message != nullptr ? detail.message : ""; }
EXPORT(field) const char* field() { return detail.field != NETMESH_FIELD_NONE ? netmesh_field_text(detail.field) : ""; }
EXPORT(bytes_wanted) double bytes_wanted() { return static_cast<double>(detail.bytes_wanted); }
EXPORT(vertices) double vertex_count() { return static_cast<double>(report.mesh.vertices); }
EXPORT(inputs) double input_count() { return static_cast<double>(report.input.distinct); }
EXPORT(copies) double copy_count() { return static_cast<double>(report.input.copies); }
EXPORT(moved) double moved() { return report.input.moved; }
EXPORT(cells) double cell_count() { return static_cast<double>(report.mesh.cells); }
EXPORT(simplices) double simplex_count() { return static_cast<double>(report.diagram.simplices); }
EXPORT(peak_bytes) double peak() { return static_cast<double>(report.memory.peak_bytes); }
EXPORT(aspect_ratio) double worst_aspect_ratio() { return report.mesh.aspect_ratio_max; }
EXPORT(filter_taken) std::uint32_t filter_taken() { return report.diagram.filter; }
EXPORT(why) const char* why() { return netmesh_why_text(report.diagram.why); }
// The engine chose a mesh because the exact complex did not fit in the block.
EXPORT(gave_up) int gave_up() { return report.diagram.why == NETMESH_WHY_MEMORY ? 1 : 0; }
EXPORT(certified_ratio) double certified() { return report.diagram.certified_ratio; }
EXPORT(certified_from) double certified_from() { return report.diagram.certified_from; }
EXPORT(fingerprint_high) std::uint32_t high_half() { return static_cast<std::uint32_t>(report.fingerprint >> 32); }
EXPORT(fingerprint_low) std::uint32_t low_half() { return static_cast<std::uint32_t>(report.fingerprint); }

// Item i of the last run, as the struct of netmesh.h; null past the end.
EXPORT(vertex) const netmesh_vertex* vertex_at(double i) { return item_at(netmesh_get_vertex, i); }
EXPORT(cell) const netmesh_cell* cell_at(double i) { return item_at(netmesh_get_cell, i); }
EXPORT(pair) const netmesh_pair* pair_at(double i) { return item_at(netmesh_get_pair, i); }
EXPORT(bar_bounds) const netmesh_bar_bounds* bounds_at(double i) { return item_at(netmesh_get_bar_bounds, i); }
// How many simplices the cycle of pair i has, and simplex j of it.
EXPORT(cycle_length) double cycle_length(double i) {
    std::uint64_t count = 0;
    return netmesh_get_cycle(context, static_cast<std::uint64_t>(i), &count) == NETMESH_OK ? static_cast<double>(count)
                                                                                           : 0;
}
EXPORT(cycle_simplex) const netmesh_simplex* cycle_simplex(double i, double j) {
    static netmesh_simplex simplex;
    simplex.struct_bytes = sizeof simplex;
    const netmesh_status status =
        netmesh_get_cycle_simplex(context, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j), &simplex);
    return status == NETMESH_OK ? &simplex : nullptr;
}

// The lines of the slice of tests/determinism, made in block[0, bytes), as text that ends in a zero.
EXPORT(fingerprints) const char* fingerprints(void* block, std::uint32_t bytes) {
    text_length = 0;
    slice::run(static_cast<unsigned char*>(block), bytes, NETMESH_DIM_MIN, NETMESH_DIM_MAX, add_line);
    for (int dim = 2; dim <= 3; ++dim)
        slice::demo(dim, static_cast<unsigned char*>(block), slice::demo_bytes, &report, add_line);
    return text;
}
