#include "api/figures.hpp"

#include <cstddef>

#include "api/structs.hpp"
#include "filtration/filters.hpp"

namespace netmesh {
namespace {

enum class Kind : std::uint8_t { flag, uint32, uint64, real, fingerprint, method, filter, values, why };

// Marks of a figure.
constexpr std::uint8_t array = 1, on_request = 2, positive = 4;  // positive: says nothing when it is 0

// The word that says whether a figure applies: by one of its bits, or any; as a whole where `value` is not 0.
struct Condition {
    std::uint16_t offset;
    std::uint32_t bits, value;
};
// How many places of an array are used: a uint32 of the struct and what is added to it.
struct Length {
    std::uint16_t offset, plus;
};

struct Row {
    const char* path;
    Kind kind;
    std::uint8_t marks;
    std::uint16_t offset, places;
    Condition condition;
    Length length;
    std::uint8_t rank;  // the order in which figures enter the fingerprint; 0: does not. Arrays of one rank take turns
};

constexpr std::uint16_t always = 0xFFFF;
constexpr std::uint32_t any_bit = 0xFFFFFFFFu;
constexpr Length all_places = {always, 0};

#define AT(member) static_cast<std::uint16_t>(offsetof(Struct, member))
#define IF(member)                                                                                                     \
    Condition { AT(member), any_bit, 0 }
#define IF_BIT(member, bit)                                                                                            \
    Condition { AT(member), bit, 0 }
#define IF_IS(member, value)                                                                                           \
    Condition { AT(member), any_bit, static_cast<std::uint32_t>(value) }
#define ONE(path, kind, member, condition, marks, rank)                                                                \
    Row { path, Kind::kind, marks, AT(member), 1, condition, all_places, rank }
#define ARRAY(path, kind, member, places, condition, length, plus, marks, rank)                                        \
    Row { path, Kind::kind, array | marks, AT(member), places, condition, Length{AT(length), plus}, rank }
#define WHOLE_ARRAY(path, kind, member, places, condition, rank)                                                       \
    Row { path, Kind::kind, array, AT(member), places, condition, all_places, rank }

template <class Report> struct Figures_of;

template <> struct Figures_of<netmesh_report> {
    using Struct = netmesh_report;
    static constexpr Condition unconditional = {always, 0, 0};
    static constexpr Condition points = IF(input.dim), meshed = IF(mesh.present), domain = IF(mesh.is_mesh),
                               hierarchy = IF(mesh.hierarchy.present),
                               location = IF_BIT(mesh.audit.what, NETMESH_AUDIT_LOCATION),
                               quality = IF_BIT(mesh.audit.what, NETMESH_AUDIT_QUALITY), diagram = IF(diagram.present),
                               function = IF_IS(diagram.filter, NETMESH_FILTER_FUNCTION), scales = IF(scales.present),
                               bounds = IF(bounds.present), vines = IF(vineyard.present),
                               decision = IF(decision.present);
    static constexpr std::uint16_t degrees = NETMESH_DEGREE_MAX + 1;
    static constexpr auto before_pairs = static_cast<std::uint8_t>(FingerprintPart::diagram);
    static constexpr auto before_vines = static_cast<std::uint8_t>(FingerprintPart::vineyard);
    static constexpr Row rows[] = {
        ONE("complete", flag, complete, IF(input.present), 0, 0),
        ONE("input.points", uint64, input.points, points, 0, 0),
        ONE("input.duplicates", uint64, input.duplicates, points, 0, 0),
        ONE("input.hidden", uint64, input.hidden, IF(input.weighting), on_request, 0),
        ONE("input.periods", uint32, input.periods, IF(input.periods), on_request, 0),
        ONE("input.copies", uint64, input.copies, IF(input.periods), on_request, 0),
        ONE("input.moved", real, input.moved, IF(input.periods), on_request, 0),
        ONE("input.distinct", uint64, input.distinct, IF(input.present), 0, 0),
        ONE("input.dim", uint32, input.dim, points, 0, 0),
        ONE("input.fingerprint", fingerprint, input.fingerprint, IF(input.present), 0, 0),

        ONE("mesh.method", method, mesh.method, domain, 0, 0),
        ONE("mesh.vertices", uint64, mesh.vertices, meshed, 0, 0),
        ONE("mesh.inputs", uint64, mesh.inputs, meshed, 0, 0),
        ONE("mesh.steiner", uint64, mesh.steiner, meshed, 0, 0),
        ONE("mesh.exempt", uint64, mesh.exempt, meshed, 0, 0),
        ONE("mesh.cells", uint64, mesh.cells, meshed, 0, 0),
        ONE("mesh.cells_created", uint64, mesh.cells_created, meshed, 0, 0),
        ONE("mesh.aspect_ratio_max", real, mesh.aspect_ratio_max, domain, 0, 0),
        ONE("mesh.tau", real, mesh.tau, domain, positive, 0),
        ONE("mesh.ratio", real, mesh.goal.ratio, domain, on_request | positive, 0),
        ONE("mesh.focus_ratio", real, mesh.goal.focus_ratio, domain, on_request | positive, 0),
        ONE("mesh.focus_from", real, mesh.goal.focus_from, domain, on_request | positive, 0),
        ONE("mesh.focus_to", real, mesh.goal.focus_to, domain, on_request | positive, 0),
        ONE("mesh.clipped", flag, mesh.clipped, domain, on_request | positive, 0),
        ONE("mesh.size_eps", real, mesh.sizes.eps, domain, on_request | positive, 0),
        ONE("mesh.size_ratio_max", real, mesh.sizes.ratio_max, domain, on_request | positive, 0),
        ARRAY("mesh.domain", real, mesh.domain, NETMESH_DIM_MAX + 1, domain, input.dim, 1, 0, 0),
        ONE("mesh.cages", uint64, mesh.hierarchy.cages, hierarchy, on_request, 0),
        ONE("mesh.cages_made", uint64, mesh.hierarchy.cages_made, hierarchy, on_request, 0),
        ONE("mesh.touches", uint64, mesh.touches, domain, on_request | positive, 0),
        ARRAY("mesh.audit.location.load", uint32, mesh.audit.load, NETMESH_ROUNDS_MAX, location, mesh.audit.rounds, 0,
              on_request, 0),
        ONE("mesh.audit.location.nets", uint32, mesh.audit.nets, location, on_request, 0),
        ONE("mesh.audit.location.nets_max", uint32, mesh.audit.nets_max, location, on_request, 0),
        ONE("mesh.audit.location.ply_max", uint32, mesh.audit.ply_max, location, on_request, 0),
        ONE("mesh.audit.location.ply_mean", real, mesh.audit.ply_mean, location, on_request, 0),
        ONE("mesh.audit.location.touches_max", uint32, mesh.audit.touches_max, location, on_request, 0),
        ONE("mesh.audit.location.touches_mean", real, mesh.audit.touches_mean, location, on_request, 0),
        ONE("mesh.audit.location.tests_mean", real, mesh.audit.tests_mean, location, on_request, 0),
        ONE("mesh.audit.quality.meshes", uint64, mesh.audit.meshes, quality, on_request, 0),
        ONE("mesh.audit.quality.aspect_ratio_max", real, mesh.audit.aspect_ratio_max, quality, on_request, 0),
        ONE("mesh.audit.quality.degree_max", uint64, mesh.audit.degree_max, quality, on_request, 0),
        ONE("mesh.audit.quality.feature_ratio", real, mesh.audit.feature_ratio, quality, on_request, 0),
        ONE("mesh.audit.quality.cage_ratio", real, mesh.audit.cage_ratio, quality, on_request, 0),
        ONE("mesh.audit.quality.steiner_ratio", real, mesh.audit.steiner_ratio, quality, on_request, 0),
        ONE("mesh.audit.quality.input_ratio", real, mesh.audit.input_ratio, quality, on_request, 0),

        ONE("diagram.filter", filter, diagram.filter, diagram, 0, 0),
        ONE("diagram.why", why, diagram.why, diagram, 0, 0),
        ONE("diagram.tried_points", uint64, diagram.tried_points, diagram, on_request | positive, 0),
        ONE("diagram.tried_cells", uint64, diagram.tried_cells, diagram, on_request | positive, 0),
        ONE("diagram.values", values, diagram.values, diagram, 0, 0),
        ONE("diagram.max_degree", uint32, diagram.max_degree, diagram, 0, 0),
        ONE("diagram.k", uint32, diagram.k, diagram, positive, 0),
        ONE("diagram.representatives", flag, diagram.representatives, diagram, 0, 0),
        ARRAY("diagram.pairs", uint64, diagram.pairs, degrees, diagram, diagram.max_degree, 1, 0, 0),
        ARRAY("diagram.essential", uint64, diagram.essential, degrees, diagram, diagram.max_degree, 1, 0, 0),
        ONE("diagram.certified_ratio", real, diagram.certified_ratio, diagram, 0, before_pairs),
        ONE("diagram.certified_ratio_best", real, diagram.certified_ratio_best, diagram, 0, 0),
        ONE("diagram.certified_from", real, diagram.certified_from, diagram, 0, 0),
        ONE("diagram.certified_error", real, diagram.certified_error, function, on_request, 0),
        ONE("diagram.fitted_error", real, diagram.fitted_error, diagram, on_request | positive, 0),
        ONE("diagram.certified_focus", real, diagram.certified_focus, diagram, on_request | positive, 0),
        ONE("diagram.simplices", uint64, diagram.simplices, diagram, 0, 0),
        ONE("diagram.scales.count", uint32, scales.count, scales, on_request, 0),
        ONE("diagram.scales.separation", real, scales.separation, scales, on_request, 0),
        ONE("diagram.scales.points_max", uint64, scales.points_max, scales, on_request, 0),
        ONE("diagram.scales.vertices_max", uint64, scales.vertices_max, scales, on_request, 0),
        ONE("diagram.scales.vertices", uint64, scales.vertices, scales, on_request, 0),
        ARRAY("diagram.certain", uint64, bounds.certain, degrees, bounds, bounds.max_degree, 1, on_request, 0),
        ONE("diagram.steps", uint64, bounds.steps, bounds, on_request, 0),
        ONE("diagram.longer_than", real, decision.longer_than, decision, on_request, 0),
        ARRAY("diagram.undecided", uint64, decision.undecided, degrees, decision, decision.max_degree, 1, on_request,
              0),
        ONE("diagram.undecided_to", real, decision.undecided_to, decision, on_request, 0),
        ONE("diagram.decided_from", real, decision.decided_from, decision, on_request, 0),

        ONE("vineyard.filter", filter, vineyard.filter, vines, on_request, 0),
        ONE("vineyard.values", values, vineyard.values, vines, on_request, 0),
        ONE("vineyard.max_degree", uint32, vineyard.max_degree, vines, on_request, 0),
        ONE("vineyard.k_first", uint32, vineyard.k_first, vines, on_request, 0),
        ONE("vineyard.k_last", uint32, vineyard.k_last, vines, on_request, 0),
        ONE("vineyard.vines", uint64, vineyard.vines, vines, on_request, 0),
        ONE("vineyard.points", uint64, vineyard.points, vines, on_request, 0),
        ONE("vineyard.transpositions", uint64, vineyard.transpositions, vines, on_request, 0),
        ONE("vineyard.simplices", uint64, vineyard.simplices, vines, on_request, 0),
        ONE("vineyard.certified_ratio", real, vineyard.certified_ratio, vines, on_request, before_vines),

        ONE("memory.block_bytes", uint64, memory.block_bytes, unconditional, positive, 0),
        ONE("memory.peak_bytes", uint64, memory.peak_bytes, unconditional, positive, 0),
        ONE("memory.used_bytes", uint64, memory.used_bytes, unconditional, positive, 0),
        ONE("predicates.in_ball.cached", uint64, predicates.in_ball[NETMESH_PREDICATE_CACHED], meshed, 0, 0),
        ONE("predicates.in_ball.float", uint64, predicates.in_ball[NETMESH_PREDICATE_FLOAT], meshed, 0, 0),
        ONE("predicates.in_ball.integer", uint64, predicates.in_ball[NETMESH_PREDICATE_INTEGER], meshed, 0, 0),
        ONE("predicates.in_ball.exact", uint64, predicates.in_ball[NETMESH_PREDICATE_EXACT], meshed, 0, 0),
        ONE("predicates.in_ball.tie", uint64, predicates.in_ball[NETMESH_PREDICATE_TIE], meshed, 0, 0),
        ONE("predicates.orient.cached", uint64, predicates.orient[NETMESH_PREDICATE_CACHED], meshed, 0, 0),
        ONE("predicates.orient.float", uint64, predicates.orient[NETMESH_PREDICATE_FLOAT], meshed, 0, 0),
        ONE("predicates.orient.integer", uint64, predicates.orient[NETMESH_PREDICATE_INTEGER], meshed, 0, 0),
        ONE("predicates.orient.exact", uint64, predicates.orient[NETMESH_PREDICATE_EXACT], meshed, 0, 0),
        ONE("predicates.orient.tie", uint64, predicates.orient[NETMESH_PREDICATE_TIE], meshed, 0, 0),
        ONE("fingerprint", fingerprint, fingerprint, IF(input.present), 0, 0),
    };
};

#define FATNESS(part, member, condition, first)                                                                        \
    ONE("fatness." #part ".cells", uint64, member.cells, condition, 0, first),                                         \
        ONE("fatness." #part ".beta_max", real, member.beta_max, condition, 0, first + 3),                             \
        ONE("fatness." #part ".beta_mean", real, member.beta_mean, condition, 0, first + 4),                           \
        ONE("fatness." #part ".aspect_ratio_max", real, member.aspect_ratio_max, condition, 0, first + 5),             \
        ONE("fatness." #part ".edges", uint64, member.edges, condition, 0, first + 1),                                 \
        ONE("fatness." #part ".edges_bound", real, member.edges_bound, condition, 0, first + 6),                       \
        ONE("fatness." #part ".faces", real, member.faces, condition, 0, first + 7),                                   \
        ONE("fatness." #part ".faces_bound", real, member.faces_bound, condition, 0, first + 8),                       \
        ONE("fatness." #part ".degree_max", uint64, member.degree_max, condition, 0, first + 2),                       \
        ONE("fatness." #part ".degree_share", real, member.degree_share, condition, 0, first + 9),                     \
        ONE("fatness." #part ".planar_share", real, member.planar_share, condition, 0, first + 10),                    \
        ONE("fatness." #part ".corners_share", real, member.corners_share, condition, 0, first + 11)

template <> struct Figures_of<netmesh_analysis> {
    using Struct = netmesh_analysis;
    static constexpr Condition unconditional = {always, 0, 0};
    static constexpr Condition size = IF(size.present), structure = IF(structure.present),
                               fatness = IF(fatness.present), boundary = IF(boundary.present),
                               all_cells = IF(all_cells.present);
    static constexpr std::uint8_t ranks = 70;
    static constexpr Row rows[] = {
        ONE("what", uint32, what, unconditional, 0, 1),
        ONE("size.vertices", uint64, size.vertices, size, 0, 2),
        ONE("size.lower", real, size.lower, size, 0, 11),
        ONE("size.upper", real, size.upper, size, 0, 12),
        ONE("size.upper_over_lower", real, size.upper_over_lower, size, 0, 0),
        ONE("size.domains", uint64, size.domains, size, 0, 0),
        ONE("size.feature_ratio", real, size.feature_ratio, size, 0, 13),
        ONE("size.feature_ratio_bound", real, size.feature_ratio_bound, size, 0, 14),
        ONE("size.theta", real, size.theta, size, 0, 15),
        ONE("size.theta_limit", real, size.theta_limit, size, 0, 16),
        ONE("size.theta_log_sum", real, size.theta_log_sum, size, 0, 17),
        WHOLE_ARRAY("size.radii", real, size.radii, 3, size, 26),
        WHOLE_ARRAY("size.integral_lower", real, size.integral_lower, 3, size, 26),
        WHOLE_ARRAY("size.integral_upper", real, size.integral_upper, 3, size, 26),
        ONE("size.pace_lower", real, size.pace_lower, size, 0, 18),
        ONE("size.pace_upper", real, size.pace_upper, size, 0, 19),
        ONE("size.boxes", uint64, size.boxes, size, 0, 3),
        ONE("structure.degree_max", uint64, structure.degree_max, structure, 0, 4),
        ONE("structure.degree_mean", real, structure.degree_mean, structure, 0, 20),
        ONE("structure.star_max", uint64, structure.star_max, structure, 0, 5),
        ONE("structure.star_mean", real, structure.star_mean, structure, 0, 21),
        ONE("structure.ply_points", uint64, structure.ply_points, structure, 0, 6),
        ONE("structure.ply_max", uint64, structure.ply_max, structure, 0, 7),
        ONE("structure.ply_mean", real, structure.ply_mean, structure, 0, 22),
        ONE("structure.balls", uint64, structure.balls, structure, 0, 8),
        ONE("structure.intersections_max", uint64, structure.intersections_max, structure, 0, 9),
        ONE("structure.intersections_mean", real, structure.intersections_mean, structure, 0, 23),
        ONE("structure.ply_stride", uint64, structure.ply_stride, structure, 0, 51),
        ONE("structure.balls_stride", uint64, structure.balls_stride, structure, 0, 52),
        ONE("structure.boundary.vertices", uint64, boundary.vertices, boundary, 0, 53),
        ONE("structure.boundary.degree_max", uint64, boundary.degree_max, boundary, 0, 54),
        ONE("structure.boundary.balls", uint64, boundary.balls, boundary, 0, 55),
        ONE("structure.boundary.intersections_max", uint64, boundary.intersections_max, boundary, 0, 56),
        FATNESS(bounded, fatness.bounded, fatness, 27),
        FATNESS(inside, fatness.inside, fatness, 39),
        FATNESS(all, all_cells.cells, all_cells, 59),
        ONE("fatness.left_out", uint64, all_cells.left_out, all_cells, 0, 57),
        ONE("fatness.radius", real, all_cells.radius, all_cells, 0, 58),
        ONE("fatness.clipped_cells", uint64, fatness.clipped_cells, fatness, 0, 10),
        ONE("fatness.clipped_beta_max", real, fatness.clipped_beta_max, fatness, 0, 24),
        ONE("fatness.clipped_beta_mean", real, fatness.clipped_beta_mean, fatness, 0, 25),
        ONE("fingerprint", fingerprint, fingerprint, unconditional, positive, 0),
    };
};

#undef FATNESS
#undef WHOLE_ARRAY
#undef ARRAY
#undef ONE
#undef IF_IS
#undef IF_BIT
#undef IF
#undef AT

template <class T> T read(const void* base, std::uint16_t offset) {
    T value;
    __builtin_memcpy(&value, static_cast<const unsigned char*>(base) + offset, sizeof value);
    return value;
}

std::uint16_t bytes_of(Kind kind) {
    return kind == Kind::uint64 || kind == Kind::real || kind == Kind::fingerprint ? 8 : 4;
}

netmesh_figure_type type_of(Kind kind) {
    switch (kind) {
    case Kind::flag: return NETMESH_FIGURE_FLAG;
    case Kind::uint32: return NETMESH_FIGURE_UINT32;
    case Kind::uint64: return NETMESH_FIGURE_UINT64;
    case Kind::real: return NETMESH_FIGURE_DOUBLE;
    case Kind::fingerprint: return NETMESH_FIGURE_FINGERPRINT;
    default: return NETMESH_FIGURE_NAME;
    }
}

const char* method_name(std::uint32_t method) {
    switch (method) {
    case NETMESH_METHOD_SVR: return "svr";
    case NETMESH_METHOD_NETMESH: return "netmesh";
    case NETMESH_METHOD_REFINE: return "refine";
    case NETMESH_METHOD_CERTIFICATE: return "certificate";
    case NETMESH_METHOD_THESIS: return "thesis";
    case NETMESH_METHOD_DELAUNAY: return "delaunay";
    default: return "unknown";
    }
}

const char* why_name(std::uint32_t why) {
    switch (why) {
    case NETMESH_WHY_ASKED: return "asked";
    case NETMESH_WHY_AFFORDABLE: return "affordable";
    case NETMESH_WHY_NO_MESH: return "no-mesh";
    case NETMESH_WHY_CELLS: return "cells";
    case NETMESH_WHY_MEMORY: return "memory";
    case NETMESH_WHY_FLAT: return "flat";
    case NETMESH_WHY_RANGE: return "range";
    case NETMESH_WHY_ALONE: return "alone";
    default: return "unknown";
    }
}

const char* text_of(Kind kind, std::uint32_t value) {
    switch (kind) {
    case Kind::method: return method_name(value);
    case Kind::values: return value == NETMESH_VALUES_THESIS ? "thesis" : "certified";
    case Kind::why: return why_name(value);
    case Kind::filter: {
        const Filter* const row = find_filter(static_cast<netmesh_filter_id>(value));
        return row != nullptr ? filter_text(value - 1).name : "none";
    }
    default: return nullptr;
    }
}

// Of a struct of `bytes` at base. What lies past its end does not apply.
netmesh_figure figure_of(const Row& row, const void* base, std::size_t bytes) {
    netmesh_figure figure = {};
    figure.type = type_of(row.kind);
    figure.path = row.path;
    figure.is_array = (row.marks & array) != 0;
    figure.on_request = (row.marks & on_request) != 0;
    figure.in_fingerprint = row.rank != 0;
    const std::size_t end = std::size_t{row.offset} + std::size_t{row.places} * bytes_of(row.kind);
    const auto has_word = [bytes](std::uint16_t offset) { return offset == always || offset + 4u <= bytes; };
    if (end > bytes || !has_word(row.condition.offset) || !has_word(row.length.offset)) return figure;
    figure.values = static_cast<const unsigned char*>(base) + row.offset;
    figure.count = row.places;
    if (row.length.offset != always) figure.count = read<std::uint32_t>(base, row.length.offset) + row.length.plus;
    if (figure.count > row.places) figure.count = row.places;
    const Condition& condition = row.condition;
    if (condition.offset == always) {
        figure.applies = 1;
    } else {
        const std::uint32_t word = read<std::uint32_t>(base, condition.offset);
        figure.applies = condition.value != 0 ? word == condition.value : (word & condition.bits) != 0;
    }
    if ((row.marks & positive) != 0) {
        const bool is_zero = bytes_of(row.kind) == 4 ? read<std::uint32_t>(base, row.offset) == 0
                                                     : read<std::uint64_t>(base, row.offset) == 0;
        if (is_zero) figure.applies = 0;
    }
    if (figure.type == NETMESH_FIGURE_NAME) figure.text = text_of(row.kind, read<std::uint32_t>(base, row.offset));
    return figure;
}

template <class Report> netmesh_status give_figure(const Report* report, std::uint32_t index, netmesh_figure* figure) {
    constexpr std::size_t count = sizeof Figures_of<Report>::rows / sizeof(Row);
    if (!has_room(report) || !has_room(figure) || index >= count) return NETMESH_INVALID_ARGUMENT;
    const std::size_t bytes = read<std::uint32_t>(report, 0);
    give_result(figure_of(Figures_of<Report>::rows[index], report, bytes), figure);
    return NETMESH_OK;
}

void add(Fingerprint* f, const Row& row, const void* base, std::uint16_t place) {
    const std::uint16_t offset = static_cast<std::uint16_t>(row.offset + place * bytes_of(row.kind));
    if (row.kind == Kind::real) {
        f->add(read<double>(base, offset));
    } else {
        f->add(bytes_of(row.kind) == 4 ? std::uint64_t{read<std::uint32_t>(base, offset)}
                                       : read<std::uint64_t>(base, offset));
    }
}

// The figures of one rank, arrays in turns.
template <class Report> void add_rank(Fingerprint* f, const Report& report, std::uint8_t rank) {
    bool more = true;
    for (std::uint16_t place = 0; more; ++place) {
        more = false;
        for (const Row& row : Figures_of<Report>::rows) {
            if (row.rank != rank || place >= row.places) continue;
            add(f, row, &report, place);
            more = true;
        }
    }
}

}  // namespace

void add_figures(Fingerprint* f, const netmesh_report& report, FingerprintPart part) {
    add_rank<netmesh_report>(f, report, static_cast<std::uint8_t>(part));
}

std::uint64_t fingerprint_of(const netmesh_analysis& analysis) {
    Fingerprint f;
    for (std::uint8_t rank = 1; rank <= Figures_of<netmesh_analysis>::ranks; ++rank)
        add_rank<netmesh_analysis>(&f, analysis, rank);
    return f.value();
}

}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_get_report_figure(const netmesh_report* report, uint32_t index, netmesh_figure* figure) {
    return give_figure(report, index, figure);
}

netmesh_status netmesh_get_analysis_figure(const netmesh_analysis* analysis, uint32_t index, netmesh_figure* figure) {
    return give_figure(analysis, index, figure);
}

}  // extern "C"
