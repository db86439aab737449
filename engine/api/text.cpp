// Versions, statuses and fields as text.
#include "api/call.hpp"
#include "api/objects.hpp"

#define NETMESH_TEXT_OF(x) #x
#define NETMESH_TEXT(x) NETMESH_TEXT_OF(x)
#define NETMESH_NAMED(name, member, field, text)                                                                       \
    case NETMESH_FIELD_##field: return text;

namespace netmesh {
namespace {

// Of texts with a 0 behind each the one of this number. They are one array, which a program links with the function
// that reads them; literals in a table would come with those of all tables of the library.
const char* text_at(const char* text, int number) {
    for (; number > 0; ++text) number -= *text == 0;
    return text;
}

constexpr int texts_in(const char* texts, std::size_t bytes) {
    int count = 0;
    for (std::size_t i = 0; i < bytes; ++i) count += texts[i] == 0;
    return count;
}

}  // namespace
}  // namespace netmesh

extern "C" {

uint32_t netmesh_version(void) { return NETMESH_VERSION; }

const char* netmesh_version_text(void) {
    return NETMESH_TEXT(NETMESH_VERSION_MAJOR) "." NETMESH_TEXT(NETMESH_VERSION_MINOR) "." NETMESH_TEXT(
        NETMESH_VERSION_PATCH);
}

const char* netmesh_status_text(netmesh_status status) {
    static constexpr char texts[] = "done\0"
                                    "invalid argument\0"
                                    "the block of memory is too small\0"
                                    "cancelled\0"
                                    "a coordinate is not a finite number\0"
                                    "a coordinate or a distance is outside the range that meshing admits\0"
                                    "the points lie in a hyperplane\0"
                                    "two points are closer than their coordinates resolve\0"
                                    "an earlier step is missing\0"
                                    "a check failed\0"
                                    "the floating-point mode is not IEEE double precision, rounding to nearest\0"
                                    "an invariant of the library does not hold\0"
                                    "the simplices are not a filtered complex\0"
                                    "left out of this build of the library\0"
                                    "the job has paused\0"
                                    "the job's stack is too small";
    static_assert(netmesh::texts_in(texts, sizeof texts) == NETMESH_STACK_OVERFLOW + 1, "a status has no text");
    if (!netmesh::in_range(status, NETMESH_OK, NETMESH_STACK_OVERFLOW)) return "unknown status";
    return netmesh::text_at(texts, status);
}

const char* netmesh_why_text(netmesh_why why) {
    static constexpr char texts[] = "it was asked for\0"
                                    "the exact alpha complex is affordable\0"
                                    "the points are too close or too far apart for a mesh\0"
                                    "the exact alpha complex would take more work than a mesh\0"
                                    "the exact alpha complex does not fit in the memory\0"
                                    "the points lie in a hyperplane and have no Delaunay triangulation\0"
                                    "coordinates are too far apart in size for an exact alpha complex\0"
                                    "no other filter takes weights or periods";
    static_assert(netmesh::texts_in(texts, sizeof texts) == NETMESH_WHY_ALONE + 1, "a reason has no text");
    if (!netmesh::in_range(why, NETMESH_WHY_ASKED, NETMESH_WHY_ALONE)) return "unknown reason";
    return netmesh::text_at(texts, why);
}

const char* netmesh_field_text(netmesh_field field) {
    if (!netmesh::in_range(field, NETMESH_FIELD_NONE, NETMESH_FIELD_COUNT)) return "unknown field";
    switch (field) {
        NETMESH_EACH_GIVEN(NETMESH_NAMED)
    case NETMESH_FIELD_NONE: return "none";
    case NETMESH_FIELD_REQUEST: return "request";
    case NETMESH_FIELD_STRUCT_BYTES: return "struct_bytes";
    case NETMESH_FIELD_RESULT: return "result";
    case NETMESH_FIELD_POINTS: return "points";
    case NETMESH_FIELD_DIM: return "dim";
    case NETMESH_FIELD_POINT_COUNT: return "count";
    case NETMESH_FIELD_POINT_FORMAT: return "format";
    case NETMESH_FIELD_POINT_STRIDE_BYTES: return "stride_bytes";
    case NETMESH_FIELD_WEIGHTS: return "weights";
    case NETMESH_FIELD_WEIGHT_STRIDE_BYTES: return "weight_stride_bytes";
    case NETMESH_FIELD_LATTICE: return "lattice";
    case NETMESH_FIELD_LATTICE_COUNT: return "lattice_count";
    case NETMESH_FIELD_DISTANCES: return "distances";
    case NETMESH_FIELD_LAYOUT: return "layout";
    case NETMESH_FIELD_NUMBERS: return "numbers";
    case NETMESH_FIELD_ENTRIES: return "entries";
    case NETMESH_FIELD_ENTRY_COUNT: return "entry_count";
    case NETMESH_FIELD_EVALUATE: return "evaluate";
    case NETMESH_FIELD_SIMPLICES: return "simplices";
    case NETMESH_FIELD_VERTICES: return "vertices";
    case NETMESH_FIELD_VERTEX_COUNT: return "vertex_count";
    case NETMESH_FIELD_STARTS: return "starts";
    case NETMESH_FIELD_SIMPLEX_COUNT: return "simplex_count";
    case NETMESH_FIELD_STEP_COUNT: return "step_count";
    case NETMESH_FIELD_FILTER: return "filter";
    case NETMESH_FIELD_VALUES: return "values";
    case NETMESH_FIELD_MAX_DEGREE: return "max_degree";
    case NETMESH_FIELD_KEEP_ZERO_PAIRS: return "keep_zero_pairs";
    case NETMESH_FIELD_LIPSCHITZ: return "lipschitz";
    case NETMESH_FIELD_DISTANCE_FACTOR: return "distance_factor";
    case NETMESH_FIELD_CUT: return "cut";
    case NETMESH_FIELD_BOUNDS: return "bounds";
    case NETMESH_FIELD_PROMISED: return "promised";
    case NETMESH_FIELD_MARKERS: return "markers";
    case NETMESH_FIELD_CELLS: return "cells";
    case NETMESH_FIELD_CELL_COUNT: return "cell_count";
    case NETMESH_FIELD_DOMAIN: return "domain";
    case NETMESH_FIELD_CAGES: return "cages";
    case NETMESH_FIELD_CAGE_COUNT: return "cage_count";
    case NETMESH_FIELD_CAGE_BYTES: return "cage_bytes";
    case NETMESH_FIELD_WHAT: return "what";
    case NETMESH_FIELD_TOLERANCE: return "tolerance";
    case NETMESH_FIELD_ORDER: return "order";
    case NETMESH_FIELD_THETAS: return "theta[]";
    case NETMESH_FIELD_SCALE: return "scale";
    case NETMESH_FIELD_SCRATCH: return "scratch";
    case NETMESH_FIELD_PAIRS_A: return "pairs_a";
    case NETMESH_FIELD_PAIRS_B: return "pairs_b";
    case NETMESH_FIELD_PAIR_BYTES: return "pair_bytes";
    case NETMESH_FIELD_RELATIVE_ERROR: return "relative_error";
    case NETMESH_FIELD_MATES: return "mates_a";
    case NETMESH_FIELD_POTENTIALS: return "potentials_a, potentials_b";
    case NETMESH_FIELD_SOURCE: return "source";
    case NETMESH_FIELD_PIECES: return "pieces";
    case NETMESH_FIELD_NODE: return "node";
    case NETMESH_FIELD_ONE: return "one";
    case NETMESH_FIELD_OTHER: return "other";
    case NETMESH_FIELD_MONITOR: return "monitor";
    case NETMESH_FIELD_COUNT: break;
    }
    return "unknown field";
}

}  // extern "C"

#undef NETMESH_TEXT
#undef NETMESH_TEXT_OF
#undef NETMESH_NAMED
