#include "filtration/filters.hpp"

#include <type_traits>

#include "filtration/function_filter.hpp"
#include "filtration/mesh_filter.hpp"
#include "filtration/tight_filter.hpp"
#include "mesh/clip/clipped_nerve.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

// Where traits need no prefix.
namespace filter_trait {
namespace {

constexpr const char *offsets = "closed offsets of the points in R^{D}", *kth = "sublevel sets of d_{k} in R^{D}";

// Words stand in a table of their own, see filter.hpp.
struct ListedFilter {
    Filter filter;
    FilterText text;
};
constexpr ListedFilter listed[] = {
    {{NETMESH_FILTER_COMPLETE, FilterSource::mesh,
      has_values | has_goal | has_cycles | zero_at_inputs | inputs_enter_first | bounds_by_scale | has_tighter_cells |
          clips_cells},
     {"complete", offsets}},
    {{NETMESH_FILTER_BASIC, FilterSource::mesh,
      has_values | has_cycles | zero_at_inputs | bounds_by_scale | has_tighter_cells | clips_cells},
     {"basic", offsets}},
    {{NETMESH_FILTER_ALPHA, FilterSource::delaunay, has_cycles}, {"alpha", offsets}},
    {{NETMESH_FILTER_KNN, FilterSource::mesh, needs_k | has_values | has_vineyard | has_cycles | bounds_by_scale},
     {"knn", kth}},
    {{NETMESH_FILTER_KDISTANCE, FilterSource::mesh, needs_k | has_values | has_vineyard | has_cycles | bounds_by_scale},
     {"kdistance", "sublevel sets of the k-distance, k = {k}, in R^{D}"}},
    {{NETMESH_FILTER_FUNCTION, FilterSource::mesh, needs_function | has_values | has_cycles | bounds_by_scale},
     {"function", "sublevel sets of the function in R^{D}"}},
    {{NETMESH_FILTER_TIGHT, FilterSource::mesh,
      has_eps | has_values | has_cycles | zero_at_inputs | inputs_enter_first | bounds_by_scale},
     {"tight", offsets}},
    {{NETMESH_FILTER_SCALES, FilterSource::scales, has_eps | has_theta | has_values | has_cycles}, {"scales", offsets}},
    {{NETMESH_FILTER_RIPS, FilterSource::points, has_cycles | made_of_edges},
     {"rips", "Vietoris-Rips complex of the points, edges at half their length"}},
    {{NETMESH_FILTER_CECH, FilterSource::points, has_cycles}, {"cech", offsets}},
    {{NETMESH_FILTER_BARYCENTRIC_CECH, FilterSource::points, needs_k}, {"barycentric-cech", kth}},
    {{NETMESH_FILTER_BARYCENTRIC_RIPS, FilterSource::points, needs_k | has_values | made_of_edges},
     {"barycentric-rips", kth}},
};

}  // namespace
}  // namespace filter_trait

namespace {

constexpr std::uint32_t rows = sizeof filter_trait::listed / sizeof filter_trait::listed[0];

template <class Part> struct Column {
    Part row[rows];
    constexpr const Part& operator[](std::uint32_t i) const { return row[i]; }
};
template <class Part> constexpr Column<Part> column_of(Part filter_trait::ListedFilter::*part) {
    Column<Part> column = {};
    for (std::uint32_t i = 0; i < rows; ++i) column.row[i] = filter_trait::listed[i].*part;
    return column;
}
constexpr Column<Filter> table = column_of(&filter_trait::ListedFilter::filter);
constexpr Column<FilterText> texts = column_of(&filter_trait::ListedFilter::text);

constexpr bool rows_are_in_order() {
    for (std::uint32_t i = 0; i < rows; ++i)
        if (static_cast<std::uint32_t>(table[i].id) != i + 1) return false;
    return true;
}
static_assert(rows == filter_count && rows_are_in_order(), "row i is that of filter i + 1");

// Where results of jobs are not in its way.
bool move_high(const StoreState& state, Arena& arena, AnyPart* part) {
    const std::size_t cells = state.cell_slots, vertices = state.vertex_count;
    std::uint8_t* const cell = arena.take_high<std::uint8_t>(cells);
    std::uint8_t* const vertex = arena.take_high<std::uint8_t>(vertices);
    if (cell == nullptr || vertex == nullptr || !part->faces.move_high(arena)) return false;
    __builtin_memcpy(cell, part->cell, cells);
    __builtin_memcpy(vertex, part->vertex, vertices);
    part->cell = cell;
    part->vertex = vertex;
    return true;
}

}  // namespace

const Filter& filter_row(std::uint32_t index) { return table[index]; }
const FilterText& filter_text(std::uint32_t index) { return texts[index]; }

const Filter* find_filter(const netmesh_filter_id& filter) {
    // As a number: C++ must not read an enumeration whose value is none of its names.
    std::underlying_type_t<netmesh_filter_id> number;
    __builtin_memcpy(&number, &filter, sizeof number);
    const std::uint32_t index = static_cast<std::uint32_t>(number) - 1;
    return index < rows ? &table[index] : nullptr;
}

const Filter& evaluated_filter(netmesh_filter_id filter, std::uint32_t k) {
    const Filter& row = table[filter - 1];
    return row.source == FilterSource::mesh && row.has(filter_trait::needs_k) && k <= 1
               ? table[NETMESH_FILTER_COMPLETE - 1]
               : row;
}

std::uint32_t zero_born_count(netmesh_filter_id filter, std::uint32_t k, std::uint32_t inputs) {
    return evaluated_filter(filter, k).has(filter_trait::inputs_enter_first) ? inputs : 0;
}

Status clip_cells(const FilterRequest& request, const Work& work, AnyMesh* mesh) {
    if (!built::certificate || !mesh->is_clipped || !table[request.filter - 1].has(filter_trait::clips_cells))
        return Status::ok;
    Arena& arena = work.arena;
    const std::size_t low = arena.low_mark();
    bool found = false;
    Status status = choose_clipped_nerve(mesh->store, &mesh->domain, work, &mesh->part, &found);
    if (status == Status::ok && found && !move_high(mesh->store.state, arena, &mesh->part))
        status = Status::out_of_memory;
    if (status == Status::ok && found) mesh->present = mesh->part.vertex;
    arena.release_low(low);
    return status;
}

namespace {

Status evaluate_complete(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    return complete_filter(mesh, request.values, work, out);
}
Status evaluate_basic(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    return basic_filter(mesh, request.values, work, out);
}
// With one neighbour both are the complete filter (7.4.2).
template <InputDistance distance>
Status evaluate_nearest(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    if (request.k <= 1) return complete_filter(mesh, request.values, work, out);
    return distance_filter(mesh, {distance, request.k}, request.values, work, out);
}
Status evaluate_function(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    return function_filter(mesh, *request.function, request.values, work, out);
}
Status evaluate_tight(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    return tight_filter(mesh, request.values, work, out);
}

}  // namespace

// The objects of api/on_meshes.cpp name them.
#define NETMESH_EVALUATED(name, by)                                                                                    \
    extern const MeshFilter name##_on_mesh;                                                                            \
    const MeshFilter name##_on_mesh = {by};
NETMESH_EVALUATED(complete, evaluate_complete)
NETMESH_EVALUATED(basic, evaluate_basic)
NETMESH_EVALUATED(knn, evaluate_nearest<InputDistance::kth>)
NETMESH_EVALUATED(kdistance, evaluate_nearest<InputDistance::root_mean_square>)
NETMESH_EVALUATED(function, evaluate_function)
NETMESH_EVALUATED(tight, evaluate_tight)
#undef NETMESH_EVALUATED

Status evaluate(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    out->zero_born =
        evaluated_filter(request.filter, request.k).has(filter_trait::inputs_enter_first) ? mesh.inputs : 0;
    return request.on_mesh->evaluate(mesh, request, work, out);
}

}  // namespace netmesh
