// netmesh for JavaScript: one request and one context in the memory of one instance. JavaScript writes options into the
// request where the engine's table of options says, and arrays behind the program; the rest of the memory is the block,
// behind which results are written. Structs are read where they are.
// Numbers of 64 bits cross the border as doubles, which hold every count exactly.
#include <cstddef>
#include <cstdint>

#include "netmesh.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name), visibility("default")))

// 1 stops the job.
extern "C" __attribute__((import_module("netmesh"), import_name("poll"))) int
poll_javascript(int stage, double done, double total, double vertices, double cells);
// A function of the caller's at x[D].
extern "C" __attribute__((import_module("netmesh"), import_name("evaluate"))) double
evaluate_javascript(const double* x);
extern "C" unsigned char __heap_base;

// What the engine asks of a C library; the others are instructions.
extern "C" int memcmp(const void* a, const void* b, std::size_t bytes) {
    const auto* x = static_cast<const unsigned char*>(a);
    const auto* y = static_cast<const unsigned char*>(b);
    for (std::size_t i = 0; i < bytes; ++i)
        if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
    return 0;
}

namespace {

netmesh_request request;
netmesh_request of_mesh;  // that the context's mesh was made by
netmesh_function function;
netmesh_distances distances;
netmesh_simplices simplices;
netmesh_bottleneck_request bottleneck_request;
netmesh_wasserstein_request wasserstein_request;
netmesh_context* context;
netmesh_report report;
netmesh_detail detail;
double results[2];

int poll(void*, const netmesh_progress* p) {
    return poll_javascript(static_cast<int>(p->stage), static_cast<double>(p->done), static_cast<double>(p->total),
                           static_cast<double>(p->vertices), static_cast<double>(p->cells));
}
double evaluate(void*, const double* x) { return evaluate_javascript(x); }

int end(netmesh_status status) {
    report = netmesh::sized<netmesh_report>();
    netmesh_get_report(context, &report);
    detail = netmesh::sized<netmesh_detail>();
    netmesh_get_detail(context, &detail);
    return status;
}
// In a new context.
int run(void* block, std::size_t bytes, netmesh_status (*call)(netmesh_context*, const netmesh_request*),
        const netmesh_request& r) {
    const netmesh_status status = netmesh_init(block, bytes, &context);
    return end(status == NETMESH_OK ? call(context, &r) : status);
}

// Row `index` of a table that the engine has; null past the end.
template <class Row, class Get> const Row* row_of(Get get) {
    static Row row;
    row = netmesh::sized<Row>();
    return get(&row) == NETMESH_OK ? &row : nullptr;
}

template <class Request> void pair_up(Request& r, const netmesh_pair* pairs, double a, double b, std::uint32_t degree) {
    r.pairs_a = pairs;
    r.pairs_b = pairs + static_cast<std::size_t>(a);
    r.count_a = static_cast<std::uint64_t>(a);
    r.count_b = static_cast<std::uint64_t>(b);
    r.degree = degree;
}

}  // namespace

// Calls of netmesh.h and arrays.h are exported as they are, by the linker.
EXPORT(context) netmesh_context* the_context() { return context; }
EXPORT(input) unsigned char* input() {
    return &__heap_base + (16 - reinterpret_cast<std::uintptr_t>(&__heap_base) % 16) % 16;
}

// The request, with its defaults.
EXPORT(fresh) netmesh_request* fresh(int is_watched) {
    request = netmesh_default_request();
    if (is_watched != 0) request.monitor.poll = poll;
    return &request;
}
// Its source, and a function; arrays are where JavaScript has put them.
EXPORT(set_points) void set_points(const void* coordinates, double count, std::uint32_t dim, int is_float) {
    request.points = {coordinates,
                      static_cast<std::size_t>(count),
                      dim,
                      is_float != 0 ? NETMESH_POINTS_FLOAT32 : NETMESH_POINTS_FLOAT64,
                      0,
                      nullptr,
                      0,
                      nullptr,
                      0};
}
EXPORT(set_weights) void set_weights(const double* weights) { request.points.weights = weights; }
EXPORT(set_lattice) void set_lattice(const double* vectors, std::uint32_t count) {
    request.points.lattice = vectors;
    request.points.lattice_count = count;
}
EXPORT(set_distances) void set_distances(const double* numbers, double count) {
    distances = netmesh::sized<netmesh_distances>();
    distances.numbers = numbers;
    distances.count = static_cast<std::uint64_t>(count);
    request.distances = &distances;
}
EXPORT(set_simplices)
void set_simplices(const std::uint32_t* vertices, const std::uint64_t* starts, const double* entries, double count,
                   double vertex_count, double steps, std::uint32_t by_vertex) {
    simplices = {sizeof simplices,
                 by_vertex,
                 vertices,
                 starts,
                 entries,
                 static_cast<std::uint64_t>(count),
                 static_cast<std::uint64_t>(vertex_count),
                 static_cast<std::uint64_t>(steps)};
    request.simplices = &simplices;
}
EXPORT(set_function) void set_function(int is_there, double lipschitz, double distance_factor, double cut) {
    function = {sizeof function, is_there != 0 ? evaluate : nullptr, nullptr, lipschitz, distance_factor, cut};
    request.function = &function;
}

EXPORT(settle) int settle() {
    netmesh_request settled;
    return netmesh::settle(request, &settled, &detail);
}
// Bytes to plan for; 0 where a request is refused.
EXPORT(plan) double plan() { return static_cast<double>(netmesh::plan(request)); }
EXPORT(plan_mesh) double plan_mesh() { return static_cast<double>(netmesh::plan_mesh(request)); }

// Jobs; a netmesh_status.
EXPORT(persist) int persist(void* block, std::size_t bytes) { return run(block, bytes, netmesh_persist, request); }
EXPORT(mesh_again) int mesh_again(void* block, std::size_t bytes) { return run(block, bytes, netmesh_mesh, of_mesh); }
EXPORT(mesh) int mesh(void* block, std::size_t bytes) {
    of_mesh = request;
    return mesh_again(block, bytes);
}
// On what the context holds.
EXPORT(persist_here) int persist_here() { return end(netmesh_persist(context, &request)); }
EXPORT(check) int check() {
    auto asked = netmesh::sized<netmesh_check_request>();
    asked.monitor = of_mesh.monitor;
    asked.promised = &of_mesh;
    return end(netmesh_check(context, &asked));
}

// Distances of two diagrams, pairs of one behind those of the other; results are at results().
EXPORT(results) double* where_results_are() { return results; }
EXPORT(plan_bottleneck)
double plan_bottleneck(const netmesh_pair* pairs, double a, double b, std::uint32_t degree, int is_log) {
    bottleneck_request = netmesh_default_bottleneck();
    bottleneck_request.scale = is_log != 0 ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
    pair_up(bottleneck_request, pairs, a, b, degree);
    return static_cast<double>(netmesh::bottleneck_bytes(bottleneck_request));
}
EXPORT(plan_wasserstein)
double plan_wasserstein(const netmesh_pair* pairs, double a, double b, std::uint32_t degree, std::uint32_t order,
                        double error) {
    wasserstein_request = netmesh_default_wasserstein();
    wasserstein_request.order = order;
    wasserstein_request.relative_error = error;
    pair_up(wasserstein_request, pairs, a, b, degree);
    return static_cast<double>(netmesh::wasserstein_bytes(wasserstein_request));
}
// As planned last.
EXPORT(bottleneck) int bottleneck(void* block, std::size_t bytes) {
    bottleneck_request.scratch = block;
    bottleneck_request.scratch_bytes = bytes;
    netmesh_distance distance;
    const netmesh_status status = netmesh::bottleneck(bottleneck_request, &distance, &detail);
    results[0] = distance.value;
    results[1] = distance.exponent;
    return status;
}
EXPORT(wasserstein) int wasserstein(void* block, std::size_t bytes) {
    wasserstein_request.scratch = block;
    wasserstein_request.scratch_bytes = bytes;
    netmesh_wasserstein_distance distance;
    const netmesh_status status = netmesh::wasserstein(wasserstein_request, &distance, &detail);
    results[0] = distance.value;
    results[1] = distance.lower;
    return status;
}

// What the last job that failed has to say.
EXPORT(detail) const netmesh_detail* last_detail() { return &detail; }

// The engine's tables, and the last job's report.
EXPORT(option) const netmesh_option* option(std::uint32_t index) {
    return row_of<netmesh_option>([&](netmesh_option* row) { return netmesh_get_option(index, row); });
}
EXPORT(option_word) const netmesh_option_word* option_word(std::uint32_t of, std::uint32_t index) {
    return row_of<netmesh_option_word>(
        [&](netmesh_option_word* row) { return netmesh_get_option_word(of, index, row); });
}
EXPORT(filter) const netmesh_filter_info* filter(std::uint32_t index) {
    return row_of<netmesh_filter_info>([&](netmesh_filter_info* row) { return netmesh_get_filter_info(index, row); });
}
EXPORT(figure) const netmesh_figure* figure(std::uint32_t index) {
    return row_of<netmesh_figure>([&](netmesh_figure* row) { return netmesh_get_report_figure(&report, index, row); });
}
EXPORT(why) const char* why() { return netmesh_why_text(report.diagram.why); }
EXPORT(vine_ratio) double vine_ratio(std::uint32_t at) {
    double of = 0;
    return netmesh_get_vine_ratio(context, at, &of) == NETMESH_OK ? of : 0;
}
