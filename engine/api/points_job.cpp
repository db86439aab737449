// Filtrations on the points themselves: from points to a complex, from the complex to a diagram.
#include "api/complex_job.hpp"
#include "filtration/filters.hpp"
#include "jobs/persist_points.hpp"

namespace netmesh {
namespace {

bool is_points_filter(const netmesh_filter& filter) {
    const Filter* const row = find_filter(filter);
    return row != nullptr && row->source == FilterSource::points;
}

const char* complaint_of(const netmesh_filter& filter, const netmesh_values& values, std::uint32_t k,
                         std::uint32_t max_degree, int representatives, std::uint64_t* position) {
    *position = 4;
    if (!is_points_filter(filter)) return "the filter is not one on points";
    *position = 5;
    if (!in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS)) return "unknown kind of values";
    const bool sets = find_filter(filter)->has(filter_trait::needs_k);
    *position = 6;
    if (sets && k == 0) return "k is 0";
    *position = 7;
    if (max_degree > points_degree_max) return "max_degree is above 30";
    if (sets && (k > points_degree_max || k + max_degree > points_degree_max)) return "k + max_degree is above 30";
    *position = 9;
    if (sets && representatives != 0) return "there are no representatives of barycentric filtrations";
    return nullptr;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_persist_points(netmesh_context* context, const double* points, size_t n, netmesh_filter filter,
                                      netmesh_values values, uint32_t k, uint32_t max_degree, int keep_zero_pairs,
                                      int representatives, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    std::uint64_t position = 0;
    if (points == nullptr) return finish(context, Status::invalid_argument, "points is null", 2);
    if (n == 0) return finish(context, Status::invalid_argument, "there are no points", 3);
    if (n > (size_t{1} << 28)) return finish(context, Status::invalid_argument, "more than 2^28 points", 3);
    if (!usable(options))
        return finish(context, Status::invalid_argument, "options are not initialised or the dimension is not 2..6",
                      10);
    const char* const complaint = complaint_of(filter, values, k, max_degree, representatives, &position);
    if (complaint != nullptr) return finish(context, Status::invalid_argument, complaint, position);
    clear(context);
    Monitor monitor = monitor_of(*options);
    const bool sets = find_filter(filter)->has(filter_trait::needs_k);
    PointsRequest request = {};
    request.filter = {filter, values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified, k,
                      max_degree};
    request.points = points;
    request.count = static_cast<std::uint32_t>(n);
    request.dim = options->dim;
    request.keep_zero = keep_zero_pairs != 0;
    request.representatives = representatives != 0;
    PointsDiagram made;
    Status status = persist_points(request, {context->arena, monitor}, &made);
    if (status == Status::invalid_argument)
        return finish(context, Status::invalid_argument, "k is above the number of distinct points", 6);
    if (status == Status::ok) {
        context->point_dim = options->dim;
        context->points = n;
        context->duplicates = n - made.distinct;
        context->inputs = made.distinct;
        context->input_fingerprint = made.input_fingerprint;
        context->k = sets ? k : 0;
        context->filter = filter;
        context->values = values;
        context->certified_ratio = context->certified_ratio_best = made.ratio;
        context->simplices = made.diagram.simplices;
        context->cycles = made.diagram.cycles;
        status = keep_pairs(context, made.diagram.pairs, {{max_degree, request.keep_zero}, request.representatives});
        if (status == Status::ok && made.is_listed && !keep_complex(context, made.complex))
            status = Status::out_of_memory;
    }
    if (status == Status::ok) return finish(context, status, "");
    const netmesh_status result = finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)),
                                         status == Status::not_finite ? made.culprit : 0);
    const netmesh_detail detail = context->detail;
    clear(context);
    context->detail = detail;
    return result;
}

size_t netmesh_points_bytes(netmesh_filter filter, const netmesh_options* options, uint64_t points, uint32_t k,
                            uint32_t max_degree) {
    std::uint64_t position;
    if (!usable(options) || points == 0 || points > (uint64_t{1} << 28)) return 0;
    if (complaint_of(filter, NETMESH_VALUES_CERTIFIED, k, max_degree, 0, &position) != nullptr) return 0;
    const double bytes = points_bytes({filter, FilterValues::certified, k, max_degree}, points, options->dim) +
                         sizeof(netmesh_context) + 65536;
    if (!(bytes < 0x1p62) || bytes >= static_cast<double>(SIZE_MAX / 2)) return SIZE_MAX;
    return (static_cast<size_t>(bytes) + Arena::alignment) & ~(Arena::alignment - 1);
}

}  // extern "C"
