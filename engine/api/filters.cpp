// The table of filters, for callers.
#include "filtration/filters.hpp"

#include "api/objects.hpp"
#include "api/structs.hpp"

namespace netmesh {
namespace {

constexpr const netmesh_filter* objects[] = {
    &netmesh_filter_complete,
    &netmesh_filter_basic,
    &netmesh_filter_alpha,
    &netmesh_filter_knn,
    &netmesh_filter_kdistance,
    &netmesh_filter_function,
    &netmesh_filter_tight,
    &netmesh_filter_scales,
    &netmesh_filter_rips,
    &netmesh_filter_cech,
    &netmesh_filter_barycentric_cech,
    &netmesh_filter_barycentric_rips,
};

static_assert(sizeof objects / sizeof objects[0] == filter_count,
              "each filter has its object, in the order of numbers");

netmesh_filter_info info_of(const Filter& filter, const FilterText& text) {
    using namespace filter_trait;
    netmesh_filter_info info = {};
    info.id = filter.id;
    info.filter = objects[filter.id - 1];
    info.is_on_mesh = filter.source == FilterSource::mesh;
    info.is_on_triangulation = filter.source == FilterSource::delaunay;
    info.is_on_points = filter.source == FilterSource::points;
    info.is_by_scales = filter.source == FilterSource::scales;
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

const netmesh_filter* filter_object(std::uint32_t index) { return objects[index]; }

}  // namespace netmesh

extern "C" netmesh_status netmesh_get_filter_info(uint32_t index, netmesh_filter_info* info) {
    using namespace netmesh;
    if (index >= filter_count) return NETMESH_INVALID_ARGUMENT;
    return give_result(info_of(filter_row(index), filter_text(index)), info) ? NETMESH_OK : NETMESH_INVALID_ARGUMENT;
}
