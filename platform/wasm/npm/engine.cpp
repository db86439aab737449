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
    longer_than,
    by_error,
    lipschitz,
    distance_factor,
    cut,
    vertices_at,
    starts_at,
    entries_at,
    simplices,
    vertex_count,
    step_count,
    by_vertex,
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

double evaluate(void*, const double* x) { return evaluate_javascript(x); }

bool asks_function() { return options[filter] == NETMESH_FILTER_FUNCTION; }

netmesh::requests::Function function_asked() {
    netmesh::requests::Function function;
    function.evaluate = evaluate;
    function.lipschitz = options[lipschitz];
    function.distance_factor = options[distance_factor];
    function.cut = options[cut];
    return function;
}

double size_for_error(void*, const double* x) { return function_asked().size_for_error(options[error], x); }

// An array that JavaScript has put somewhere.
template <class Number> const Number* array(Option option) {
    return reinterpret_cast<const Number*>(static_cast<std::uintptr_t>(options[option]));
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
    if (asks_function() && options[error] != 0) request.sizes.size = size_for_error;
    return request;
}

netmesh::requests::Auto auto_request() {
    netmesh::requests::Auto request(number(dim));
    place(request);
    request.seed = static_cast<std::uint64_t>(options[seed]);
    request.max_degree = number(max_degree);
    request.keep_zero_pairs = number(keep_zero_pairs);
    return request;
}

netmesh::requests::Fit fit_request() {
    netmesh::requests::Fit request(number(dim));
    place(diagram(request));
    request.seed = static_cast<std::uint64_t>(options[seed]);
    request.filter = asked();
    request.k = number(k);
    request.by_error = number(by_error);
    request.ratio = options[ratio];
    request.focus_from = options[from];
    request.focus_to = options[to];
    request.longer_than = options[longer_than];
    request.bounds = number(bounds);
    request.whole_cells = number(whole_cells);
    return request;
}

netmesh::requests::PointsVineyard points_vineyard_request() {
    netmesh::requests::PointsVineyard request(number(dim), asked());
    place(request);
    request.values = static_cast<netmesh_values>(options[values]);
    request.max_degree = number(max_degree);
    request.k_first = number(k);
    request.k_last = number(k_last);
    return request;
}

// A complex, and values for it or steps of them.
template <class Request> Request complex_request() {
    Request request;
    watch(request);
    request.vertices = array<std::uint32_t>(vertices_at);
    request.starts = array<std::uint64_t>(starts_at);
    request.entries = array<double>(entries_at);
    request.simplex_count = size(simplices);
    request.vertex_count = size(vertex_count);
    request.max_degree = number(max_degree);
    return request;
}

netmesh::requests::Homology homology_request() {
    auto request = complex_request<netmesh::requests::Homology>();
    request.keep_zero_pairs = number(keep_zero_pairs);
    request.representatives = number(representatives);
    return request;
}

netmesh::requests::ValueVineyard value_vineyard_request() {
    auto request = complex_request<netmesh::requests::ValueVineyard>();
    request.step_count = size(step_count);
    request.by_vertex = number(by_vertex);
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
    request.threshold = options[threshold] != 0 ? options[threshold] : 0x1p-1074;  // 0 is no limit there
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

// What is asked for beside the diagram that a job has left, as far as the job has not made it.
netmesh_status bound_here() {
    netmesh::requests::Bounds request;
    const netmesh::requests::Function function = function_asked();
    if (asks_function()) request.function = &function;
    return options[bounds] != 0 ? netmesh_bound_bars(context, &watch(request)) : NETMESH_OK;
}
netmesh_status represent_here() {
    netmesh::requests::Represent request;
    return options[representatives] != 0 ? netmesh_represent(context, &watch(request)) : NETMESH_OK;
}
netmesh_status complete(netmesh_status status) {
    if (status == NETMESH_OK) status = bound_here();
    return status == NETMESH_OK ? represent_here() : status;
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
EXPORT(plan_auto) double plan_auto() { return static_cast<double>(netmesh::plan(auto_request())); }
EXPORT(plan_nested) double plan_nested() { return static_cast<double>(netmesh::plan(points_vineyard_request())); }
EXPORT(plan_homology) double plan_homology() { return static_cast<double>(netmesh::plan(homology_request())); }
EXPORT(plan_filtrations) double plan_filtrations() {
    return static_cast<double>(netmesh::plan(value_vineyard_request()));
}
EXPORT(default_tau) double default_tau() { return netmesh::tau(mesh_request()); }

// Jobs in a new context; a netmesh_status.
EXPORT(mesh) int make_mesh(void* block, std::size_t bytes) { return run(block, bytes, mesh_request(), netmesh_mesh); }
EXPORT(delaunay) int make_triangulation(void* block, std::size_t bytes) {
    return run(block, bytes, delaunay_request(), netmesh_delaunay);
}
EXPORT(alpha) int persist_alpha(void* block, std::size_t bytes) {
    return run(block, bytes, alpha_request(), [](netmesh_context* c, const netmesh_alpha_request* request) {
        const netmesh_status status = netmesh_persist_alpha(c, request);
        return status == NETMESH_OK ? bound_here() : status;
    });
}
EXPORT(points) int persist_points(void* block, std::size_t bytes) {
    return run(block, bytes, points_request(), [](netmesh_context* c, const netmesh_points_request* request) {
        const netmesh_status status = netmesh_persist_points(c, request);
        return status == NETMESH_OK ? bound_here() : status;
    });
}
EXPORT(scales) int persist_scales(void* block, std::size_t bytes) {
    return run(block, bytes, scales_request(), netmesh_persist_scales);
}
EXPORT(distances) int persist_distances(void* block, std::size_t bytes) {
    return run(block, bytes, distances_request(), netmesh_persist_distances);
}
// By the filter that the engine chooses.
EXPORT(auto) int persist_auto(void* block, std::size_t bytes) {
    return run(block, bytes, auto_request(), [](netmesh_context* c, const netmesh_auto_request* request) {
        return complete(netmesh_persist_auto(c, request));
    });
}
EXPORT(fit) int fit(void* block, std::size_t bytes) {
    netmesh::requests::Fit request = fit_request();
    const netmesh::requests::Function function = function_asked();
    if (asks_function()) request.function = &function;
    return run(block, bytes, request, [](netmesh_context* c, const netmesh_fit_request* r) {
        const netmesh_status status = netmesh_fit(c, r);
        return status == NETMESH_OK ? represent_here() : status;
    });
}
EXPORT(nested) int points_vineyard(void* block, std::size_t bytes) {
    return run(block, bytes, points_vineyard_request(), netmesh_points_vineyard);
}
EXPORT(homology) int homology(void* block, std::size_t bytes) {
    return run(block, bytes, homology_request(), netmesh_homology);
}
EXPORT(filtrations) int value_vineyard(void* block, std::size_t bytes) {
    return run(block, bytes, value_vineyard_request(), netmesh_value_vineyard);
}

// On what the context holds.
EXPORT(persist) int persist() {
    netmesh::requests::Persist request(asked());
    watch(diagram(request));
    request.k = number(k);
    const netmesh::requests::Function function = function_asked();
    if (asks_function()) request.function = &function;
    return end(complete(netmesh_persist(context, &request)));
}
EXPORT(vineyard) int vineyard() {
    netmesh::requests::Vineyard request(asked());
    watch(request);
    request.values = static_cast<netmesh_values>(options[values]);
    request.max_degree = number(max_degree);
    request.k_first = number(k);
    request.k_last = number(k_last);
    return end(netmesh_vineyard(context, &request));
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
EXPORT(fault) int fault() { return detail.fault; }
EXPORT(step) double step() { return static_cast<double>(detail.step); }
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
// source, purpose, has_eps, has_theta, has_goal, has_representatives, needs_k, needs_function, clips_cells, has_values,
// has_vineyard
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
                                   i.has_values,
                                   i.has_vineyard};
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
EXPORT(filter_taken) int filter_taken() { return report.diagram.filter; }
// "auto" has taken a mesh because the alpha complex did not fit in the block.
EXPORT(gave_up) int gave_up() { return report.diagram.why == NETMESH_WHY_MEMORY ? 1 : 0; }
EXPORT(why) const char* why() { return netmesh_why_text(report.diagram.why); }
EXPORT(certified_error) double certified_error() { return report.diagram.certified_error; }
EXPORT(steps) double steps() { return static_cast<double>(report.bounds.steps); }
EXPORT(vines) double vines() { return static_cast<double>(report.vineyard.vines); }
EXPORT(vine_points) double vine_points() { return static_cast<double>(report.vineyard.points); }
EXPORT(vine_fact) double vine_fact(int which) {
    const double facts[] = {static_cast<double>(report.vineyard.k_first), static_cast<double>(report.vineyard.k_last),
                            static_cast<double>(report.vineyard.max_degree)};
    return facts[which];
}
EXPORT(vine_ratio) double vine_ratio(std::uint32_t at) {
    double of = 0;
    return netmesh_get_vine_ratio(context, at, &of) == NETMESH_OK ? of : 0;
}
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
EXPORT(read_vines)
int read_vines(double n, std::uint32_t* of_vines, std::uint32_t* of_degrees, std::uint32_t* ks, double* intervals) {
    return netmesh_array_vines(context, static_cast<std::uint64_t>(n), of_vines, of_degrees, ks, intervals);
}
