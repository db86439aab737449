#include "jobs/list_simplices.hpp"

#include "numerics/fingerprint.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

// What each simplex by itself has to satisfy; counts the dimensions.
Status count_simplices(const SimplexList& list, const Arena& arena, ListedComplex* complex, SimplexFault* fault) {
    *complex = {};
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena.piece(i, list.count, 20); i < piece; ++i) {
            fault->simplex = i;
            fault->kind = NETMESH_FAULT_SIZE;
            if (list.starts[i + 1] <= list.starts[i] || list.size(i) > ListedComplex::dimension_max + 1)
                return Status::not_a_complex;
            const std::uint32_t k = static_cast<std::uint32_t>(list.size(i) - 1);
            if (k > complex->dimension) complex->dimension = k;
            fault->kind = NETMESH_FAULT_TOO_MANY;
            if (++complex->count[k] > 0x7FFFFFFFu) return Status::not_a_complex;
            fault->kind = NETMESH_FAULT_NONE;
            if (list.values != nullptr && !is_finite(list.values[i])) return Status::not_finite;
        }
    *fault = {};
    return Status::ok;
}

// The vertices of a simplex in ascending order; false: it has one twice.
bool sort_vertices(const std::uint32_t* vertices, std::uint32_t size, std::uint32_t* row) {
    bool distinct = true;
    for (std::uint32_t n = 0; n < size; ++n) {
        std::uint32_t hole = n;
        for (; hole > 0 && row[hole - 1] > vertices[n]; --hole) row[hole] = row[hole - 1];
        row[hole] = vertices[n];
        distinct = distinct && (hole == 0 || row[hole - 1] != vertices[n]);
    }
    return distinct;
}

bool take_complex(Arena& arena, ListedComplex& complex) {
    for (std::uint32_t k = 0; k <= complex.dimension; ++k) {
        complex.rows[k] = arena.take_low<std::uint32_t>(std::size_t{complex.count[k]} * (k + 1));
        complex.value[k] = arena.take_low<double>(complex.count[k]);
        if (complex.rows[k] == nullptr || complex.value[k] == nullptr) return false;
    }
    return true;
}

Status copy_simplices(const SimplexList& list, Arena& arena, ListedSimplices* out) {
    ListedComplex& complex = out->complex;
    if (!take_complex(arena, complex)) return Status::out_of_memory;
    std::uint32_t filled[ListedComplex::dimension_max + 1] = {};
    Fingerprint f;
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena.piece(i, list.count, static_cast<std::uint32_t>(60 + 20 * list.size(i)));
             i < piece; ++i) {
            const std::uint32_t size = static_cast<std::uint32_t>(list.size(i)), k = size - 1;
            std::uint32_t* const row = complex.rows[k] + std::size_t{filled[k]} * size;
            if (!sort_vertices(list.vertices + list.starts[i], size, row)) {
                out->fault = {NETMESH_FAULT_VERTEX_TWICE, i, 0};
                return Status::not_a_complex;
            }
            const double value = list.values == nullptr ? 0 : list.values[i] + 0.0;
            complex.value[k][filled[k]++] = value;
            f.add(static_cast<std::uint64_t>(size));
            for (std::uint32_t n = 0; n < size; ++n) f.add(static_cast<std::uint64_t>(row[n]));
            if (list.values != nullptr) f.add(list.values[i]);
        }
    out->input_fingerprint = f.value();
    return Status::ok;
}

SimplexFault fault_in_list(const SimplexList& list, const ComplexFault& fault) {
    const std::uint64_t at = place_of(list, fault.dimension, fault.index);
    switch (fault.kind) {
    case ComplexFault::repeated: return {NETMESH_FAULT_LISTED_TWICE, at, place_of(list, fault.dimension, fault.other)};
    case ComplexFault::face_missing: return {NETMESH_FAULT_FACE_MISSING, at, fault.other};
    default: return {NETMESH_FAULT_FACE_LATER, at, place_of(list, fault.dimension - 1, fault.other)};
    }
}

}  // namespace

std::uint64_t place_of(const SimplexList& list, std::uint32_t k, std::uint32_t index) {
    for (std::uint64_t i = 0; i < list.count; ++i) {
        if (list.size(i) != k + 1) continue;
        if (index-- == 0) return i;
    }
    return list.count;
}

Status list_simplices(const SimplexList& list, const Work& work, ListedSimplices* out) {
    *out = {};
    Status status = count_simplices(list, work.arena, &out->complex, &out->fault);
    if (status == Status::ok) status = copy_simplices(list, work.arena, out);
    if (status != Status::ok) return status;
    ComplexFault fault = {};
    status = link_faces(out->complex, true, work, &fault);
    if (status != Status::check_failed) return status;
    out->fault = fault_in_list(list, fault);
    return Status::not_a_complex;
}

}  // namespace netmesh
