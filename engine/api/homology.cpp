// Homology of complexes given by their simplices, and the cycles of any explicit complex.
#include "api/complex_job.hpp"
#include "numerics/sort.hpp"
#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

struct SimplexList {
    const std::uint32_t* vertices;
    const std::uint64_t* starts;
    const double* values;
    std::uint64_t count;

    std::uint64_t size(std::uint64_t i) const { return starts[i + 1] - starts[i]; }
};

constexpr const char* text_not_finite = "the value of a simplex is not a finite number";
constexpr const char* text_size = "a simplex has no vertices or more than 32";
constexpr const char* text_twice = "a simplex has a vertex twice";
constexpr const char* text_many = "more than 2^31 simplices of one dimension";

// What each simplex by itself has to satisfy; counts the dimensions. index: the simplex at fault.
const char* count_simplices(const SimplexList& list, ListedComplex* complex, Status* status, std::uint64_t* index) {
    *complex = {};
    for (std::uint64_t i = 0; i < list.count; ++i) {
        *index = i;
        *status = Status::not_a_complex;
        if (list.starts[i + 1] <= list.starts[i] || list.size(i) > ListedComplex::dimension_max + 1) return text_size;
        const std::uint32_t k = static_cast<std::uint32_t>(list.size(i) - 1);
        if (k > complex->dimension) complex->dimension = k;
        if (++complex->count[k] > 0x7FFFFFFFu) return text_many;
        *status = Status::not_finite;
        if (!is_finite(list.values[i])) return text_not_finite;
    }
    *status = Status::ok;
    return nullptr;
}

// False: out of memory, or (with *twice set to the simplex) a vertex that a simplex has twice.
bool copy_simplices(const SimplexList& list, Arena& arena, ListedComplex& complex, std::uint64_t* fingerprint,
                    std::uint64_t* twice) {
    *twice = UINT64_MAX;
    if (!take_complex(arena, complex)) return false;
    std::uint32_t filled[ListedComplex::dimension_max + 1] = {};
    Fingerprint f;
    for (std::uint64_t i = 0; i < list.count; ++i) {
        const std::uint32_t size = static_cast<std::uint32_t>(list.size(i)), k = size - 1;
        std::uint32_t* const row = complex.rows[k] + std::size_t{filled[k]} * size;
        for (std::uint32_t n = 0; n < size; ++n) {
            const std::uint32_t vertex = list.vertices[list.starts[i] + n];
            std::uint32_t hole = n;
            for (; hole > 0 && row[hole - 1] > vertex; --hole) row[hole] = row[hole - 1];
            row[hole] = vertex;
            if (hole > 0 && row[hole - 1] == vertex) *twice = i;
        }
        if (*twice == i) return false;
        complex.value[k][filled[k]++] = list.values[i] + 0.0;
        f.add(static_cast<std::uint64_t>(size));
        for (std::uint32_t n = 0; n < size; ++n) f.add(static_cast<std::uint64_t>(row[n]));
        f.add(list.values[i]);
    }
    *fingerprint = f.value();
    return true;
}

// The place in the list of the simplex that is number `index` of its dimension.
std::uint64_t place_of(const SimplexList& list, std::uint32_t k, std::uint32_t index) {
    for (std::uint64_t i = 0; i < list.count; ++i) {
        if (list.size(i) != k + 1) continue;
        if (index-- == 0) return i;
    }
    return list.count;
}

netmesh_status finish_fault(netmesh_context* context, const SimplexList& list, const ComplexFault& fault) {
    const std::uint64_t a = place_of(list, fault.dimension, fault.index);
    switch (fault.kind) {
    case ComplexFault::repeated:
        return finish(context, Status::not_a_complex, "a simplex is listed twice", a,
                      place_of(list, fault.dimension, fault.other));
    case ComplexFault::face_missing:
        return finish(context, Status::not_a_complex, "a face of a simplex is missing", a, fault.other);
    default:
        return finish(context, Status::not_a_complex, "a face enters later than its simplex", a,
                      place_of(list, fault.dimension - 1, fault.other));
    }
}

FilteredComplex complex_of(const netmesh_context* context, const unsigned char* base, const std::uint32_t** labels) {
    const auto* const kept = reinterpret_cast<const KeptComplex*>(base + context->kept_offset);
    FilteredComplex complex = {};
    complex.dimension = kept->dimension;
    for (std::uint32_t k = 0; k <= kept->dimension; ++k) {
        complex.of[k] = {kept->count[k], reinterpret_cast<const std::uint32_t*>(base + kept->rows[k]),
                         reinterpret_cast<const double*>(base + kept->values[k])};
    }
    *labels = complex.of[0].faces;
    return complex;
}

// The cycle of a pair, and the arena as it would be at the context's present place.
netmesh_status find_cycle(const netmesh_context* context, std::uint64_t index, Arena* arena, std::uint32_t* degree,
                          Cycle* cycle) {
    if (context == nullptr || context->magic != context_magic) return NETMESH_INVALID_ARGUMENT;
    if (!context->has_diagram || !context->has_cycles) return NETMESH_NO_RESULT;
    if (index >= context->pair_count) return NETMESH_INVALID_ARGUMENT;
    const auto* const base = reinterpret_cast<const unsigned char*>(context);
    const Pair& pair = reinterpret_cast<const Pair*>(base + context->pairs_offset)[index];
    *arena = context->arena;
    arena->rebase(const_cast<netmesh_context*>(context));
    *degree = pair.degree;
    const std::uint32_t* labels;
    *cycle = context->kept_offset == 0 ? lower_star_cycle(context->cycles, *arena, pair)
                                       : cycle_of(complex_of(context, base, &labels), context->cycles, *arena, pair);
    return NETMESH_OK;
}

// A simplex of the complex that was kept.
void listed_simplex(const netmesh_context* context, std::uint32_t degree, std::uint32_t at, netmesh_simplex* simplex) {
    const std::uint32_t* labels;
    const FilteredComplex complex = complex_of(context, reinterpret_cast<const unsigned char*>(context), &labels);
    simplex->value = complex.of[degree].value[at];
    vertices_of(complex, labels, degree, at, simplex->vertices);
}

// A simplex of a mesh: it enters with its last vertex, unless it is an input that enters at 0.
void mesh_simplex(const netmesh_context* context, const Arena& arena, std::uint32_t degree,
                  const std::uint32_t* vertices, netmesh_simplex* simplex) {
    const auto* const value = reinterpret_cast<const double*>(arena.at(context->values_offset));
    simplex->value = value[vertices[0]] + 0.0;
    for (std::uint32_t i = 0; i <= degree; ++i) {
        simplex->vertices[i] = vertices[i];
        if (value[vertices[i]] > simplex->value) simplex->value = value[vertices[i]];
    }
    if (degree == 0 && vertices[0] < born_at_zero(context)) simplex->value = 0;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_homology(netmesh_context* context, const uint32_t* vertices, const uint64_t* starts,
                                const double* values, uint64_t count, uint32_t max_degree, int keep_zero_pairs,
                                int representatives, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (vertices == nullptr) return finish(context, Status::invalid_argument, "vertices is null", 2);
    if (starts == nullptr) return finish(context, Status::invalid_argument, "starts is null", 3);
    if (values == nullptr) return finish(context, Status::invalid_argument, "values is null", 4);
    if (count == 0) return finish(context, Status::invalid_argument, "there are no simplices", 5);
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 9);
    clear(context);
    const SimplexList list = {vertices, starts, values, count};
    Monitor monitor = monitor_of(*options);
    ListedComplex complex;
    Status status;
    std::uint64_t index = 0, twice = 0;
    const char* const fault_text = count_simplices(list, &complex, &status, &index);
    if (fault_text != nullptr) return finish(context, status, fault_text, index);
    ComplexFault fault = {};
    if (!copy_simplices(list, context->arena, complex, &context->input_fingerprint, &twice)) {
        status = Status::out_of_memory;
    } else {
        status = link_faces(complex, true, {context->arena, monitor}, &fault);
    }
    if (status == Status::ok) {
        context->point_dim = 0;
        context->points = context->duplicates = 0;
        context->inputs = complex.count[0];
        context->certified_ratio = context->certified_ratio_best = 1;
        context->k = 0;
        context->filter = NETMESH_FILTER_NONE;
        const std::uint32_t degree = max_degree < complex.dimension ? max_degree : complex.dimension;
        status = keep_diagram_of(context, complex, {{degree, keep_zero_pairs != 0}, representatives != 0}, monitor);
    }
    if (status == Status::ok) return finish(context, status, "");
    const netmesh_status result =
        twice != UINT64_MAX ? finish(context, Status::not_a_complex, text_twice, twice)
        : status == Status::check_failed
            ? finish_fault(context, list, fault)
            : finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    const netmesh_detail detail = context->detail;
    clear(context);
    context->detail = detail;
    return result;
}

size_t netmesh_homology_bytes(uint64_t count, uint64_t vertices) {
    if (count == 0 || vertices < count || vertices > UINT64_MAX / 128) return 0;
    // Rows and values; a table of faces or orders while they are linked, columns and sets while they are reduced, 31
    // pieces.
    const double bytes = 4.0 * static_cast<double>(vertices) + 40.0 * static_cast<double>(count) + 65536;
    if (bytes >= static_cast<double>(SIZE_MAX / 2)) return SIZE_MAX;
    return (static_cast<size_t>(bytes) + Arena::alignment) & ~(Arena::alignment - 1);
}

netmesh_status netmesh_get_cycle(const netmesh_context* context, uint64_t pair, uint64_t* simplices) {
    Arena arena;
    std::uint32_t degree;
    Cycle cycle = {};
    if (simplices == nullptr) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status status = find_cycle(context, pair, &arena, &degree, &cycle);
    *simplices = cycle.count;
    return status;
}

netmesh_status netmesh_get_cycle_simplex(const netmesh_context* context, uint64_t pair, uint64_t index,
                                         netmesh_simplex* simplex) {
    Arena arena;
    std::uint32_t degree;
    Cycle cycle = {};
    if (simplex == nullptr) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status status = find_cycle(context, pair, &arena, &degree, &cycle);
    if (status != NETMESH_OK) return status;
    if (index >= cycle.count) return NETMESH_INVALID_ARGUMENT;
    const auto at = static_cast<std::size_t>(index);
    *simplex = netmesh_simplex{};
    if (context->kept_offset != 0) {
        listed_simplex(context, degree, cycle.simplices[at], simplex);
    } else {
        mesh_simplex(context, arena, degree, cycle.simplices + at * (degree + 1), simplex);
    }
    insertion_sort(simplex->vertices, std::uint64_t{degree} + 1,
                   [](std::uint32_t a, std::uint32_t b) { return a < b; });
    return NETMESH_OK;
}

}  // extern "C"
