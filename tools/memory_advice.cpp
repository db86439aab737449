#include "tools/memory_advice.hpp"

#include <cstring>

#include "tools/io/numbers.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

struct Cloud {
    std::uint32_t dim;
    std::size_t points, bytes;
};

void add(std::string* text, const std::string& way) { *text += (text->empty() ? "" : "; ") + way; }

// Whether these options fit; their plan.
bool fits(const Options& options, const Cloud& cloud, std::size_t* plan) {
    *plan = plan_diagram(options, filter_of(options), cloud.dim, cloud.points);
    return *plan > 0 && *plan <= cloud.bytes;
}

// Of the same sets, the offsets of points, where this filter's are others.
void add_alpha(const Options& options, const Cloud& cloud, std::string* text) {
    const netmesh_filter_info& alpha = about(NETMESH_FILTER_ALPHA);
    if (filter_of(options) == NETMESH_FILTER_ALPHA || cloud.dim > NETMESH_DIM_MAX) return;
    if (std::strcmp(about(filter_of(options)).reference, alpha.reference) != 0) return;
    Options exact;
    exact.command = Command::persist;
    exact.filter = NETMESH_FILTER_ALPHA;
    std::size_t plan;
    if (fits(exact, cloud, &plan)) add(text, "--filter alpha is exact and fits: plan for " + bytes_text_up(plan));
}

void add_lower_degree(const Options& options, const Cloud& cloud, std::string* text) {
    Options lower = options;
    for (std::uint32_t degree = max_degree_of(options, cloud.dim); degree-- > 0;) {
        lower.max_degree = degree;
        std::size_t plan;
        if (!fits(lower, cloud, &plan)) continue;
        add(text, "--max-degree " + std::to_string(degree) + " fits: plan for " + bytes_text_up(plan));
        return;
    }
}

void add_coarser_mesh(const Options& options, std::uint32_t dim, std::string* text) {
    if (options.eps > 0) add(text, "an --eps above " + number_text(options.eps) + " takes less");
    if (options.size_at_inputs > 0)
        add(text, "a --cell-size above " + number_text(options.size_at_inputs) + " takes less");
    if (options.error > 0) add(text, "an --error above " + number_text(options.error) + " takes less");
    const requests::Mesh mesh = mesh_request(options, dim);
    if (refines_by_certificate(options) && !options.fit) {
        add(text, "a --ratio above " + rounded_text(mesh.certificate.ratio, 4) + " takes less");
    } else if (!options.fit && !promises_accuracy(options)) {
        add(text, "a --tau above " + rounded_text(tau(mesh), 4) + " takes less");
    }
}

std::string advice_on_diagram(const Options& options, const Cloud& cloud) {
    std::string text;
    const netmesh_filter_info& filter = about(filter_of(options));
    if (filter.source == NETMESH_SOURCE_POINTS) {
        add_lower_degree(options, cloud, &text);
        if (filter.filter == NETMESH_FILTER_RIPS) add(&text, "--threshold R joins fewer points");
    } else if (filter.source == NETMESH_SOURCE_DELAUNAY) {
        add(&text, "--filter complete --fit finds the best ratio that fits");
    } else {
        const bool can_fit = filter.source == NETMESH_SOURCE_MESH && filter.has_eps == 0 && !options.method &&
                             !options.fit && options.values_at.empty() && options.error == 0;
        if (can_fit)
            add(&text, filter.needs_function != 0 ? "--fit finds the least error that fits"
                                                  : "--fit finds the best ratio that fits");
        if (options.values_at.empty()) add_coarser_mesh(options, cloud.dim, &text);
    }
    add_alpha(options, cloud, &text);
    return text;
}

}  // namespace

std::string memory_advice(const Options& options, std::uint32_t dim, std::size_t points, std::size_t bytes) {
    std::string text;
    if (options.distances) return "a lower --max-degree or a --threshold takes less";
    if (dim == 0) return text;
    if (options.command == Command::persist) return advice_on_diagram(options, {dim, points, bytes});
    const bool meshes = options.command == Command::vineyard && !is_on_points(filter_of(options));
    if (options.command == Command::mesh || meshes) add_coarser_mesh(options, dim, &text);
    return text;
}

}  // namespace netmesh::tool
