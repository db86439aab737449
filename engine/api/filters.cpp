// The table of filters, for callers.
#include "filtration/filters.hpp"

#include "api/structs.hpp"

namespace netmesh {
namespace {

netmesh_filter_info info_of(const Filter& filter, const FilterText& text) {
    using namespace filter_trait;
    netmesh_filter_info info = {};
    info.filter = filter.id;
    info.source = static_cast<netmesh_source>(filter.source);
    info.purpose = static_cast<netmesh_purpose>(filter.purpose);
    info.name = text.name;
    info.reference = text.reference;
    info.needs_k = filter.has(needs_k);
    info.needs_function = filter.has(needs_function);
    info.has_eps = filter.has(has_eps);
    info.has_theta = filter.has(has_theta);
    info.has_values = filter.has(has_values);
    info.has_vineyard = filter.has(has_vineyard);
    info.has_goal = filter.has(has_goal);
    info.has_representatives = filter.has(has_cycles);
    info.bounds_by_scale = filter.has(bounds_by_scale);
    info.clips_cells = filter.has(clips_cells);
    return info;
}

}  // namespace
}  // namespace netmesh

extern "C" netmesh_status netmesh_get_filter_info(uint32_t index, netmesh_filter_info* info) {
    using namespace netmesh;
    if (index >= filter_count) return NETMESH_INVALID_ARGUMENT;
    return give_result(info_of(filter_row(index), filter_text(index)), info) ? NETMESH_OK : NETMESH_INVALID_ARGUMENT;
}
