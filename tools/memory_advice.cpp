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

void add_way(std::string* text, const std::string& way) { *text += (text->empty() ? "" : "; ") + way; }

// Whether these options fit; their plan.
bool fits(const Options& options, const Cloud& cloud, std::size_t* plan) {
    *plan = plan_of(options, cloud.dim, cloud.points);
    return *plan > 0 && *plan <= cloud.bytes;
}

// Of the same sets, the offsets of points, where this filter's are others.
void add_alpha(const Options& options, const Cloud& cloud, std::string* text) {
    const netmesh_filter_info& alpha = about(NETMESH_FILTER_ALPHA);
    // The filter auto takes alpha itself where that fits.
    const bool is_tried = filter_of(options) == NETMESH_FILTER_ALPHA || options.request.filter == &netmesh_filter_auto;
    if (is_tried || cloud.dim > NETMESH_DIM_MAX) return;
    if (std::strcmp(about(filter_of(options)).reference, alpha.reference) != 0) return;
    Options exact;
    exact.command = Command::persist;
    exact.request.filter = &netmesh_filter_alpha;
    exact.representatives = options.representatives;
    std::size_t plan;
    if (fits(exact, cloud, &plan)) add_way(text, "--filter alpha is exact: plan for " + bytes_text_up(plan));
}

void add_lower_degree(const Options& options, const Cloud& cloud, std::string* text) {
    Options lower = options;
    for (std::uint32_t degree = settled(options, cloud.dim).request.max_degree; degree-- > 0;) {
        lower.request.max_degree = degree;
        std::size_t plan;
        if (!fits(lower, cloud, &plan)) continue;
        add_way(text, "--max-degree " + std::to_string(degree) + " fits: plan for " + bytes_text_up(plan));
        return;
    }
}

void add_coarser_mesh(const Options& options, std::uint32_t dim, std::string* text) {
    Options meshed = options;
    if (options.request.filter == &netmesh_filter_auto) meshed.request.filter = &netmesh_filter_complete;
    const netmesh_request r = settled(meshed, dim).request;
    const double eps = options.request.goal.eps + r.mesh.sizes.eps;
    if (eps > 0) add_way(text, "an --eps above " + number_text(eps) + " takes less");
    if (r.mesh.sizes.at_inputs > 0)
        add_way(text, "a --cell-size above " + number_text(r.mesh.sizes.at_inputs) + " takes less");
    if (r.goal.error > 0) add_way(text, "an --error above " + number_text(r.goal.error) + " takes less");
    if (r.fit != nullptr) return;
    if (r.goal.ratio > 0) {
        add_way(text, "a --ratio above " + rounded_text(r.goal.ratio, 4) + " takes less");
    } else if (r.goal.eps == 0) {
        add_way(text, "a --tau above " + rounded_text(r.mesh.tau, 4) + " takes less");
    }
}

std::string advice_on_diagram(const Options& options, const Cloud& cloud) {
    std::string text;
    if (!options.table.weights.empty() || options.table.lattice.kind != Lattice::none) return text;  // of alpha alone
    add_alpha(options, cloud, &text);
    const netmesh_request& r = options.request;
    const netmesh_filter_info& filter = about(r.filter);
    if (filter.is_on_points != 0) {
        add_lower_degree(options, cloud, &text);
        if (filter.id == NETMESH_FILTER_RIPS) add_way(&text, "--threshold R joins fewer points");
    } else if (filter.is_on_triangulation != 0) {
        add_way(&text, "--filter complete --fit finds the best ratio that fits");
    } else {
        const bool can_fit = filter.is_on_mesh != 0 && filter.has_eps == 0 && r.mesh.method == nullptr &&
                             r.fit == nullptr && options.values_at.empty() && r.goal.error == 0;
        if (can_fit)
            add_way(&text, filter.needs_function != 0 ? "--fit finds the least error that fits"
                                                      : "--fit finds the best ratio that fits");
        if (options.values_at.empty()) add_coarser_mesh(options, cloud.dim, &text);
    }
    return text;
}

}  // namespace

std::string memory_advice(const Options& options, std::uint32_t dim, std::size_t points, std::size_t bytes) {
    std::string text;
    if (options.distances) return "a lower --max-degree or a --threshold takes less";
    if (dim == 0) return text;
    if (goes_by_pieces(options)) return "a leaf takes less with more --pieces";
    if (options.command == Command::persist) return advice_on_diagram(options, {dim, points, bytes});
    const bool meshes = options.command == Command::vineyard && !is_on_points(filter_of(options));
    if (options.command == Command::mesh || meshes) add_coarser_mesh(options, dim, &text);
    return text;
}

}  // namespace netmesh::tool
