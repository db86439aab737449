// The table of options: members of a request that users set by name.
#include <cstddef>

#include "api/objects.hpp"
#include "api/structs.hpp"
#include "filtration/filters.hpp"

namespace netmesh {
namespace {

struct Word {
    const char* name;
    std::uint32_t value;
    const void* object;
};
// Without a first one: the filters, and how many more there are.
struct Words {
    const Word* first;
    std::uint32_t count;
};

constexpr Word method_words[] = {
    {"svr", 0, &netmesh_method_svr},
    {"netmesh", 0, &netmesh_method_netmesh},
    {"thesis", 0, &netmesh_method_thesis},
    {"refine", 0, &netmesh_method_refine},
    {"certificate", 0, &netmesh_method_certificate},
    {"delaunay", 0, &netmesh_method_delaunay},
};
constexpr Word values_words[] = {{"certified", NETMESH_VALUES_CERTIFIED, nullptr},
                                 {"thesis", NETMESH_VALUES_THESIS, nullptr}};
constexpr Word audit_words[] = {{"location", NETMESH_AUDIT_LOCATION, nullptr},
                                {"quality", NETMESH_AUDIT_QUALITY, nullptr}};

constexpr Word weighting_words[] = {{"radii", 0, &netmesh_radii}, {"weights", 0, &netmesh_weights}};

template <std::size_t n> constexpr Words words(const Word (&list)[n]) { return {list, n}; }
constexpr Words no_words = {nullptr, 0}, filter_words = {nullptr, 2};

struct Option {
    const char* name;
    netmesh_option_type type;
    netmesh_field field;
    std::uint32_t offset;
    const char *range, *default_is, *sentence;
    const void* object;
    Words words;
};

#define OPTION(name, type, field, member, range, otherwise, sentence, object, words)                                   \
    {                                                                                                                  \
        name, NETMESH_OPTION_##type, NETMESH_FIELD_##field,                                                            \
            static_cast<std::uint32_t>(offsetof(netmesh_request, member)), range, otherwise, sentence, object, words   \
    }
#define NUMBER(name, type, field, member, range, otherwise, sentence)                                                  \
    OPTION(name, type, field, member, range, otherwise, sentence, nullptr, no_words)

constexpr Option options[] = {
    OPTION("filter", NAME, FILTER, filter, "a filter", "none; name one", "what the diagram is of", nullptr,
           filter_words),
    OPTION("values", NAME, VALUES, values, "certified or thesis", "certified; thesis with an error",
           "values clamped so that the certified ratio is the best possible, or the filter's own", nullptr,
           words(values_words)),
    NUMBER("k", UINT32, K, k, "1 or more", "1", "neighbours, the point itself counted"),
    NUMBER("k_last", UINT32, K_LAST, k_last, "at least k", "k", "with vines: the last number of neighbours"),
    NUMBER("max_degree", UINT32, MAX_DEGREE, max_degree, "0 or more",
           "D - 1, D with periods; 1 of complexes on the points", "highest degree of homology"),
    NUMBER("threshold", DOUBLE, THRESHOLD, threshold, "a radius, 0 or more", "inf",
           "of the filter rips: points are joined to this radius, half of their distance"),
    OPTION("weighting", NAME, WEIGHTING, weighting, "radii or weights", "none",
           "of the filter alpha: what the numbers beside the points are, radii or squares of any sign", nullptr,
           words(weighting_words)),
    NUMBER("squares", FLAG, SQUARES, squares, "0 or 1", "0",
           "with a weighting: values are squares of radii, not their roots with a sign"),
    OPTION("periods", FLAG, PERIODS, periods, "0 or 1", "0",
           "of the filter alpha: points repeat by the vectors of their lattice", &netmesh_periodic, no_words),
    NUMBER("keep_zero_pairs", FLAG, KEEP_ZERO_PAIRS, keep_zero_pairs, "0 or 1", "0", "keep bars of length zero"),
    NUMBER("seed", UINT64, SEED, seed, "0 to 2^64 - 1", "1", "of every random choice"),
    NUMBER("ratio", DOUBLE, RATIO, goal.ratio, "1.4143 or more", "sqrt(2 + tau); of fit 4",
           "certified ratio at most this; with fit where its ladder begins"),
    NUMBER("eps", DOUBLE, EPS, goal.eps, "in (0, 1/2]", "1/2; from D = 4 on a ratio",
           "of the filters tight and scales: certified ratio at most 1 + eps"),
    NUMBER("theta", DOUBLE, THETA, goal.theta, "in (0, 1/9]", "1/9",
           "of the filter scales: how medial points of one scale are"),
    NUMBER("error", DOUBLE, ERROR, goal.error, "above 0", "none",
           "of the filter function: each birth and death is off by at most this"),
    NUMBER("focus_ratio", DOUBLE, FOCUS_RATIO, goal.focus_ratio, "between 1 and ratio", "none",
           "certified ratio of what matters to the radii of interest"),
    NUMBER("focus_from", DOUBLE, FOCUS_FROM, goal.focus_from, "above 0", "none", "least radius of interest"),
    NUMBER("focus_to", DOUBLE, FOCUS_TO, goal.focus_to, "above focus_from", "none", "largest radius of interest"),
    NUMBER("longer_than", DOUBLE, LONGER_THAN, goal.longer_than, "above 1", "none",
           "with fit: bars that may die after so many times their birth are decided"),
    OPTION("method", NAME, METHOD, mesh.method, "a method", "certificate where a ratio is promised, else svr",
           "how the mesh is made", nullptr, words(method_words)),
    NUMBER("tau", DOUBLE, TAU, mesh.tau, "above 2", "2.5 (D = 2, 3), 3.08 (4), 4 (5, 6); 7 of the method thesis",
           "bound on the aspect ratio of Voronoi cells"),
    NUMBER("domain_factor", DOUBLE, DOMAIN_FACTOR, mesh.domain_factor, "1 to 8", "1",
           "radius of the ball that is meshed over that of the smallest one that holds the points"),
    NUMBER("net_spacing", DOUBLE, NET_SPACING, mesh.net_spacing, "1/64 to 8", "1",
           "of the method refine: spacing of its boundary net over the diameter of the points"),
    NUMBER("size_eps", DOUBLE, SIZE_EPS, mesh.sizes.eps, "above 0", "none",
           "no cell reaches farther than this times the distance to the second nearest input"),
    NUMBER("size_at_inputs", DOUBLE, SIZE_AT_INPUTS, mesh.sizes.at_inputs, "above 0", "none",
           "no cell reaches farther than this, and size_growth times its vertex's distance to the nearest input"),
    NUMBER("size_growth", DOUBLE, SIZE_GROWTH, mesh.sizes.growth, "0 or more", "0", "goes with size_at_inputs"),
    NUMBER("finish", FLAG, FINISH, mesh.finish, "0 or 1", "0",
           "methods with cages go on to a mesh of quality tau without cages"),
    NUMBER("whole_cells", FLAG, WHOLE_CELLS, mesh.whole_cells, "0 or 1", "0",
           "refine by the certificate for whole Voronoi cells, not for cells clipped to a ball around the points"),
    OPTION("audit", NAMES, AUDIT, mesh.audit, "location, quality or both", "none", "measure every intermediate mesh",
           nullptr, words(audit_words)),
    OPTION("bounds", FLAG, BOUNDS, bounds, "0 or 1", "0",
           "where each birth and death surely is and which bars are certified to exist", &netmesh_bounds, no_words),
    OPTION("cycles", FLAG, CYCLES, cycles, "0 or 1", "0", "a representative of each bar", &netmesh_cycles, no_words),
    OPTION("vines", FLAG, VINES, vines, "0 or 1", "0", "diagrams for k to k_last, or for each step, and their vines",
           &netmesh_vines, no_words),
    OPTION("fit", FLAG, FIT, fit, "0 or 1", "0", "the best that the memory holds", &netmesh_fit, no_words),
    NUMBER("keep_mesh", FLAG, KEEP_MESH, keep_mesh, "0 or 1", "0", "of the filter alpha: keep the triangulation"),
};
constexpr std::uint32_t option_count = sizeof options / sizeof options[0];

#undef NUMBER
#undef OPTION

// The table of filters between the two that are of requests alone.
Word filter_word(std::uint32_t index) {
    if (index == 0) return {"auto", 0, &netmesh_filter_auto};
    if (index > filter_count) return {"simplices", 0, &netmesh_filter_simplices};
    return {filter_text(index - 1).name, 0, filter_object(index - 1)};
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_get_option(uint32_t index, netmesh_option* option) {
    if (index >= option_count) return NETMESH_INVALID_ARGUMENT;
    const Option& row = options[index];
    const netmesh_option found = {0,         row.type,       row.field,    row.offset, row.name,
                                  row.range, row.default_is, row.sentence, row.object};
    return give_result(found, option) ? NETMESH_OK : NETMESH_INVALID_ARGUMENT;
}

netmesh_status netmesh_get_option_word(uint32_t option, uint32_t index, netmesh_option_word* word) {
    if (option >= option_count) return NETMESH_INVALID_ARGUMENT;
    const Words& words = options[option].words;
    const bool of_filters = words.first == nullptr && words.count > 0;
    if (index >= words.count + (of_filters ? filter_count : 0)) return NETMESH_INVALID_ARGUMENT;
    const Word row = of_filters ? filter_word(index) : words.first[index];
    const netmesh_option_word found = {0, row.value, row.name, row.object};
    return give_result(found, word) ? NETMESH_OK : NETMESH_INVALID_ARGUMENT;
}

}  // extern "C"
