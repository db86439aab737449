// netmesh for JavaScript: one job in the memory of one instance. JavaScript writes the input to input(), sets options,
// calls a job with the rest of the memory as its block, and has results written behind it.
// Numbers of 64 bits cross the border as doubles, which hold every count exactly.
#include <cstddef>
#include <cstdint>

#include "arrays.h"
#include "netmesh.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name), visibility("default")))

// 1 stops the job.
extern "C" __attribute__((import_module("netmesh"), import_name("poll"))) int
poll_javascript(int stage, double done, double total, double vertices, double cells);
extern "C" unsigned char __heap_base;

namespace {

// By the numbers that index.mjs has for them.
enum Option {
    dim,
    points,
    format,
    filter,
    values,
    k,
    k_last,
    max_degree,
    ratio,
    focus,
    from,
    to,
    tau,
    method,
    finish,
    eps,
    theta,
    seed,
    keep_zero_pairs,
    bounds,
    representatives,
    whole_cells,
    purpose,
    threshold,
    layout,
    degree,
    is_log,
    order,
    error,
    count_a,
    count_b,
    watched,
    options_count
};

double options[options_count];
netmesh_context* context;
netmesh_report report;
netmesh_detail detail;
double results[2];

std::uint32_t number(Option option) { return static_cast<std::uint32_t>(options[option]); }
std::size_t size(Option option) { return static_cast<std::size_t>(options[option]); }

int poll(void*, const netmesh_progress* p) {
    return poll_javascript(static_cast<int>(p->stage), static_cast<double>(p->done), static_cast<double>(p->total),
                           static_cast<double>(p->vertices), static_cast<double>(p->cells));
}

template <class Request> Request& watch(Request& request) {
    if (options[watched] != 0) request.monitor.poll = poll;
    return request;
}

unsigned char* input() { return &__heap_base + (16 - reinterpret_cast<std::uintptr_t>(&__heap_base) % 16) % 16; }

// What requests on points have in common.
template <class Request> Request& place(Request& request) {
    request.dim = number(dim);
    request.points = input();
    request.point_count = size(points);
    request.point_format = options[format] != 0 ? NETMESH_POINTS_FLOAT32 : NETMESH_POINTS_FLOAT64;
    return watch(request);
}

template <class Request> Request& diagram(Request& request) {
    request.values = static_cast<netmesh_values>(options[values]);
    request.max_degree = number(max_degree);
    request.keep_zero_pairs = number(keep_zero_pairs);
    return request;
}

netmesh_filter asked() { return static_cast<netmesh_filter>(options[filter]); }

netmesh::requests::Mesh mesh_request() {
    netmesh::requests::Mesh request(number(dim));
    place(request);
    request.seed = static_cast<std::uint64_t>(options[seed]);
    request.purpose = static_cast<netmesh_purpose>(options[purpose]);
    request.method = static_cast<netmesh_method>(options[method]);
    request.tau = options[tau];
    request.finish = number(finish);
    (request.purpose == NETMESH_PURPOSE_TIGHT ? request.tight_eps : request.sizes.eps) = options[eps];
    request.certificate = {options[ratio], options[focus], options[from], options[to]};
    request.whole_cells = number(whole_cells);
    return request;
}

netmesh::requests::Delaunay delaunay_request() {
    netmesh::requests::Delaunay request(number(dim));
    place(request);
    request.seed = static_cast<std::uint64_t>(options[seed]);
    request.purpose = static_cast<netmesh_purpose>(options[purpose]);
    return request;
}

netmesh::requests::Alpha alpha_request() {
    netmesh::requests::Alpha request(number(dim));
    place(request);
    request.max_degree = number(max_degree);
    request.keep_zero_pairs = number(keep_zero_pairs);
    return request;
}

netmesh::requests::Points points_request() {
    netmesh::requests::Points request(number(dim), asked());
    place(diagram(request));
    request.k = number(k);
    request.representatives = number(representatives);
    return request;
}

netmesh::requests::Scales scales_request() {
    netmesh::requests::Scales request(number(dim));
    place(diagram(request));
    request.seed = static_cast<std::uint64_t>(options[seed]);
    request.tau = options[tau];
    request.eps = options[eps];
    request.ratio = options[ratio];
    request.theta = options[theta];
    request.bounds = number(bounds);
    request.representatives = number(representatives);
    return request;
}

netmesh::requests::Distances distances_request() {
    netmesh::requests::Distances request;
    watch(request);
    request.layout = static_cast<netmesh_distance_layout>(options[layout]);
    request.numbers = reinterpret_cast<const double*>(input());
    request.point_count = size(points);
    request.threshold = options[threshold];
    request.max_degree = number(max_degree);
    request.keep_zero_pairs = number(keep_zero_pairs);
    request.representatives = number(representatives);
    return request;
}

netmesh_status begin(void* block, std::size_t bytes) {
    const netmesh_status status = netmesh_init(block, bytes, &context);
    detail = {};
    if (status != NETMESH_OK) detail.message = netmesh_status_text(status);
    return status;
}

int end(netmesh_status status) {
    report = netmesh::sized<netmesh_report>();
    netmesh_get_report(context, &report);
    if (context == nullptr || status == NETMESH_OK) return status;
    detail = netmesh::sized<netmesh_detail>();
    netmesh_get_detail(context, &detail);
    return status;
}

template <class Request, class Call> int run(void* block, std::size_t bytes, const Request& request, Call call) {
    netmesh_status status = begin(block, bytes);
    if (status == NETMESH_OK) status = call(context, &request);
    return end(status);
}

}  // namespace

EXPORT(input) unsigned char* where_input_is() { return input(); }
EXPORT(options) double* all_options() { return options; }
EXPORT(options_count) int how_many_options() { return options_count; }

// Bytes to plan for; 0 where a request is invalid.
EXPORT(plan_mesh) double plan_mesh() { return static_cast<double>(netmesh::plan(mesh_request())); }
EXPORT(plan_delaunay) double plan_delaunay() { return static_cast<double>(netmesh::plan(delaunay_request())); }
EXPORT(plan_alpha) double plan_alpha() { return static_cast<double>(netmesh::plan(alpha_request())); }
EXPORT(plan_points) double plan_points() { return static_cast<double>(netmesh::plan(points_request())); }
EXPORT(plan_scales) double plan_scales() { return static_cast<double>(netmesh::plan(scales_request())); }
EXPORT(plan_distances) double plan_distances() { return static_cast<double>(netmesh::plan(distances_request())); }
EXPORT(default_tau) double default_tau() { return netmesh::tau(mesh_request()); }

// Jobs in a new context; a netmesh_status.
EXPORT(mesh) int make_mesh(void* block, std::size_t bytes) { return run(block, bytes, mesh_request(), netmesh_mesh); }
EXPORT(delaunay) int make_triangulation(void* block, std::size_t bytes) {
    return run(block, bytes, delaunay_request(), netmesh_delaunay);
}
EXPORT(alpha) int persist_alpha(void* block, std::size_t bytes) {
    return run(block, bytes, alpha_request(), netmesh_persist_alpha);
}
EXPORT(points) int persist_points(void* block, std::size_t bytes) {
    return run(block, bytes, points_request(), netmesh_persist_points);
}
EXPORT(scales) int persist_scales(void* block, std::size_t bytes) {
    return run(block, bytes, scales_request(), netmesh_persist_scales);
}
EXPORT(distances) int persist_distances(void* block, std::size_t bytes) {
    return run(block, bytes, distances_request(), netmesh_persist_distances);
}

// On what the context holds.
EXPORT(persist) int persist() {
    netmesh::requests::Persist request(asked());
    watch(diagram(request));
    request.k = number(k);
    netmesh_status status = netmesh_persist(context, &request);
    if (status == NETMESH_OK && options[bounds] != 0) {
        netmesh::requests::Bounds of_bars;
        status = netmesh_bound_bars(context, &watch(of_bars));
    }
    if (status == NETMESH_OK && options[representatives] != 0) {
        netmesh::requests::Represent cycles;
        status = netmesh_represent(context, &watch(cycles));
    }
    return end(status);
}
EXPORT(bound_bars) int bound_bars() {
    netmesh::requests::Bounds request;
    return end(netmesh_bound_bars(context, &watch(request)));
}
EXPORT(check) int check() {
    netmesh::requests::Check request;
    const netmesh::requests::Mesh promised = mesh_request();
    request.mesh = &promised;
    return end(netmesh_check(context, &watch(request)));
}

// Distances of two diagrams, count_a and count_b netmesh_pairs one after the other; results are at results().
namespace {
template <class Request> Request& pair_up(Request& request) {
    request.pairs_a = reinterpret_cast<const netmesh_pair*>(input());
    request.pairs_b = request.pairs_a + size(count_a);
    request.count_a = size(count_a);
    request.count_b = size(count_b);
    request.degree = number(degree);
    return watch(request);
}
netmesh::requests::Bottleneck bottleneck_request() {
    netmesh::requests::Bottleneck request;
    request.scale = options[is_log] != 0 ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
    return pair_up(request);
}
netmesh::requests::Wasserstein wasserstein_request() {
    netmesh::requests::Wasserstein request;
    request.order = number(order);
    request.relative_error = options[error];
    return pair_up(request);
}
}  // namespace
EXPORT(results) double* where_results_are() { return results; }
EXPORT(plan_bottleneck) double plan_bottleneck() {
    return static_cast<double>(netmesh::bottleneck_bytes(bottleneck_request()));
}
EXPORT(plan_wasserstein) double plan_wasserstein() {
    return static_cast<double>(netmesh::wasserstein_bytes(wasserstein_request()));
}
EXPORT(bottleneck) int bottleneck(void* block, std::size_t bytes) {
    netmesh::requests::Bottleneck request = bottleneck_request();
    request.scratch = block;
    request.scratch_bytes = bytes;
    netmesh_distance distance;
    const netmesh_status status = netmesh::bottleneck(request, &distance, &detail);
    results[0] = distance.value;
    results[1] = distance.exponent;
    return status;
}
EXPORT(wasserstein) int wasserstein(void* block, std::size_t bytes) {
    netmesh::requests::Wasserstein request = wasserstein_request();
    request.scratch = block;
    request.scratch_bytes = bytes;
    netmesh_wasserstein_distance distance;
    const netmesh_status status = netmesh::wasserstein(request, &distance, &detail);
    results[0] = distance.value;
    results[1] = distance.lower;
    return status;
}

// What an error is about.
EXPORT(status_text) const char* text_of_status(int status) {
    return netmesh_status_text(static_cast<netmesh_status>(status));
}
EXPORT(message) const char* message() { return detail.message != nullptr ? detail.message : ""; }
EXPORT(field) const char* field() { return detail.field != 0 ? netmesh_field_text(detail.field) : ""; }
EXPORT(row) double row() { return static_cast<double>(detail.index_a); }
EXPORT(other_row) double other_row() { return static_cast<double>(detail.index_b); }
EXPORT(version) const char* version() { return netmesh_version_text(); }

// The library's table of filters.
EXPORT(filter_name) const char* filter_name(std::uint32_t index) {
    static netmesh_filter_info info;
    info.struct_bytes = sizeof info;
    return netmesh_get_filter_info(index, &info) == NETMESH_OK ? info.name : nullptr;
}
EXPORT(filter_number) int filter_number(std::uint32_t index) {
    netmesh_filter_info info = netmesh::sized<netmesh_filter_info>();
    return netmesh_get_filter_info(index, &info) == NETMESH_OK ? info.filter : 0;
}
// source, purpose, has_eps, has_theta, has_goal, has_representatives, needs_k, needs_function, clips_cells, has_values
EXPORT(filter_fact) int filter_fact(std::uint32_t index, int which) {
    netmesh_filter_info i = netmesh::sized<netmesh_filter_info>();
    netmesh_get_filter_info(index, &i);
    const std::uint32_t facts[] = {static_cast<std::uint32_t>(i.source),
                                   static_cast<std::uint32_t>(i.purpose),
                                   i.has_eps,
                                   i.has_theta,
                                   i.has_goal,
                                   i.has_representatives,
                                   i.needs_k,
                                   i.needs_function,
                                   i.clips_cells,
                                   i.has_values};
    return static_cast<int>(facts[which]);
}

// Of the last job.
EXPORT(fingerprint_high) std::uint32_t high_half() { return static_cast<std::uint32_t>(report.fingerprint >> 32); }
EXPORT(fingerprint_low) std::uint32_t low_half() { return static_cast<std::uint32_t>(report.fingerprint); }
EXPORT(vertices) double vertices() { return static_cast<double>(report.mesh.vertices); }
EXPORT(inputs) double inputs() { return static_cast<double>(report.mesh.inputs); }
EXPORT(cells) double cells() { return static_cast<double>(report.mesh.cells); }
EXPORT(is_mesh) int is_mesh() { return static_cast<int>(report.mesh.is_mesh); }
EXPORT(domain) double domain(int i) { return report.mesh.domain[i]; }
EXPORT(aspect_ratio) double aspect_ratio() { return report.mesh.aspect_ratio_max; }
EXPORT(degrees) int degrees() {
    return report.diagram.present != 0 ? static_cast<int>(report.diagram.max_degree) + 1 : 0;
}
EXPORT(pairs) double pairs(int of) { return static_cast<double>(report.diagram.pairs[of]); }
EXPORT(certified_ratio) double certified_ratio() { return report.diagram.certified_ratio; }
EXPORT(value_error) double value_error() { return report.diagram.value_error; }
EXPORT(steps) double steps() { return static_cast<double>(report.bounds.steps); }
EXPORT(peak_bytes) double peak_bytes() { return static_cast<double>(report.memory.peak_bytes); }

// Arrays, written to where JavaScript has made room: see arrays.h.
EXPORT(read_vertices) int read_vertices(double n, double* x, std::uint8_t* markers, double* of_filter) {
    return netmesh_array_vertices(context, number(dim), static_cast<std::uint64_t>(n), x, markers, of_filter);
}
EXPORT(read_cells) int read_cells(double n, std::uint32_t* of_cells, std::uint32_t* neighbours) {
    return netmesh_array_cells(context, number(dim), static_cast<std::uint64_t>(n), of_cells, neighbours);
}
EXPORT(read_pairs) int read_pairs(double n, double* intervals) {
    return netmesh_array_pairs(context, static_cast<std::uint64_t>(n), intervals, nullptr);
}
EXPORT(read_bounds) int read_bounds(double n, double* intervals, std::uint8_t* certain) {
    return netmesh_array_bounds(context, static_cast<std::uint64_t>(n), intervals, certain);
}
EXPORT(read_cycle_starts) int read_cycle_starts(double n, std::uint64_t* starts) {
    return netmesh_array_cycle_starts(context, static_cast<std::uint64_t>(n), starts);
}
EXPORT(read_cycle) int read_cycle(double pair, std::uint32_t of_degree, double n, std::uint32_t* of_cycle) {
    return netmesh_array_cycle(context, static_cast<std::uint64_t>(pair), of_degree, static_cast<std::uint64_t>(n),
                               of_cycle, nullptr);
}
