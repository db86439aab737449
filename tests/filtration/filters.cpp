// The table of filters, and what evaluate promises of every filter on meshes.
#include "filtration/filters.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "api/objects.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"

using namespace netmesh;

namespace {

// A function that every mesh can certify: never smaller than its change across the cells of the inputs below.
double far_from_zero(void*, const double* x) { return 20 + x[0]; }

netmesh_function function_row() {
    netmesh_function function = {};
    function.evaluate = far_from_zero;
    function.lipschitz = 1;
    function.cut = 19;
    return function;
}

}  // namespace

TEST_CASE("rows have names of their own and are found by their filter, numbers of no filter by none") {
    std::set<std::string> names;
    for (std::uint32_t i = 0; i < filter_count; ++i) {
        const Filter& filter = filter_row(i);
        const std::string name = filter_text(i).name, reference = filter_text(i).reference;
        CHECK(find_filter(filter.id) == &filter);
        CHECK(names.insert(name).second);
        CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos);
        CHECK(reference.size() > 10);
        // The number of neighbours is in the name of the function exactly where it matters.
        CHECK((reference.find("{k}") != std::string::npos) == filter.has(filter_trait::needs_k));
        if (filter.has(filter_trait::inputs_enter_first)) CHECK(filter.has(filter_trait::zero_at_inputs));
        if (filter.source != FilterSource::mesh) {
            CHECK(!filter.has(filter_trait::bounds_by_scale | filter_trait::has_tighter_cells));
            CHECK(!filter.has(filter_trait::has_vineyard | filter_trait::has_goal));
        }
    }
    for (const std::uint32_t number : {0u, filter_count + 1, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
        netmesh_filter_id filter;
        std::memcpy(&filter, &number, sizeof filter);
        CHECK(find_filter(filter) == nullptr);
    }
}

TEST_CASE("with one neighbour filters by neighbours are the complete filter") {
    for (const netmesh_filter_id filter : {NETMESH_FILTER_KNN, NETMESH_FILTER_KDISTANCE}) {
        CHECK(evaluated_filter(filter, 0).id == NETMESH_FILTER_COMPLETE);
        CHECK(evaluated_filter(filter, 1).id == NETMESH_FILTER_COMPLETE);
        CHECK(evaluated_filter(filter, 2).id == filter);
        CHECK(zero_born_count(filter, 1, 7) == 7);
        CHECK(zero_born_count(filter, 2, 7) == 0);
    }
    CHECK(evaluated_filter(NETMESH_FILTER_BARYCENTRIC_CECH, 1).id == NETMESH_FILTER_BARYCENTRIC_CECH);
    CHECK(zero_born_count(NETMESH_FILTER_BASIC, 0, 7) == 0);
}

TEST_CASE("every filter on meshes gives values within its ratio of its intervals") {
    std::vector<netmesh_filter> filters;
    for (std::uint32_t i = 0; i < filter_count; ++i)
        if (filter_row(i).source == FilterSource::mesh) filters.push_back(*filter_object(i));
    REQUIRE(filters.size() > 5);

    Block block(std::size_t{1} << 24);
    StoreState state = {};
    Store<2> store(block.arena, state);
    Monitor monitor;
    const inputs::Points points = inputs::uniform(2, 40);
    MeshResult<2> meshed = {};
    REQUIRE(mesh_points<2>(store, points.data(), 40, by_quality(2.5, 1, true), {block.arena, monitor}, &meshed) ==
            Status::ok);
    const FilteredMesh<2> mesh = {store, meshed.domain, 40};
    const netmesh_function function = function_row();
    const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
    for (const auto& filter : filters)
        for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
            CAPTURE(filter_text(filter.id - 1).name);
            std::vector<double> value(state.vertex_count);
            std::vector<Interval> interval(state.vertex_count);
            Evaluation out = {value.data(), interval.data()};
            REQUIRE(evaluate(mesh, {filter.id, filter.on_mesh, values, 3, &function}, {block.arena, monitor}, &out) ==
                    Status::ok);
            CHECK(block.arena.low_mark() == low);
            CHECK(block.arena.high_mark() == high);
            CHECK(out.zero_born == zero_born_count(filter.id, 3, mesh.inputs));
            const double c = out.certificate.ratio;
            CHECK(is_finite(c));
            CHECK(c >= out.certificate.ratio_best * (1 - 1e-9));
            if (values == FilterValues::certified) CHECK(c == doctest::Approx(out.certificate.ratio_best));
            for (std::uint32_t v = 0; v < state.vertex_count; ++v) {
                CHECK(interval[v].lo <= interval[v].hi);
                if (filter.id == NETMESH_FILTER_BASIC && v < mesh.inputs) {
                    CHECK(value[v] == 0);
                    CHECK(interval[v].hi <= out.certificate.from);
                    continue;
                }
                CHECK(interval[v].hi <= value[v] * c * (1 + 1e-12));
                CHECK(value[v] <= interval[v].lo * c * (1 + 1e-12));
            }
        }
}
