#include "api/complex_job.hpp"

#include "homology/matrix/matrix.hpp"
#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

std::uint64_t fingerprint_of(const netmesh_context* context, const PairList& pairs) {
    Fingerprint f;
    f.add(context->input_fingerprint);
    f.add(context->simplices);
    f.add(context->certified_ratio);
    for (std::uint64_t i = 0; i < pairs.count; ++i) {
        f.add(static_cast<std::uint64_t>(pairs.pairs[i].degree));
        f.add(pairs.pairs[i].birth);
        f.add(pairs.pairs[i].death);
    }
    return f.value();
}

// Whether most simplices are of the highest dimension that matters.
bool is_skeleton(const FilteredComplex& complex, std::uint32_t max_degree) {
    const std::uint32_t top = max_degree < complex.dimension ? max_degree + 1 : complex.dimension;
    return top > 0 && complex.of[top].count / 2 > complex.of[top - 1].count;
}

}  // namespace

bool take_complex(Arena& arena, ListedComplex& complex) {
    for (std::uint32_t k = 0; k <= complex.dimension; ++k) {
        complex.rows[k] = arena.take_low<std::uint32_t>(std::size_t{complex.count[k]} * (k + 1));
        complex.value[k] = arena.take_low<double>(complex.count[k]);
        if (complex.rows[k] == nullptr || complex.value[k] == nullptr) return false;
    }
    return true;
}

bool keep_complex(netmesh_context* context, const ListedComplex& complex) {
    Arena& arena = context->arena;
    KeptComplex* const kept = arena.take_low<KeptComplex>(1);
    if (kept == nullptr) return false;
    *kept = {};
    kept->dimension = complex.dimension;
    for (std::uint32_t k = 0; k <= complex.dimension; ++k) {
        kept->count[k] = complex.count[k];
        kept->rows[k] = arena.offset_of(complex.rows[k]);
        kept->values[k] = arena.offset_of(complex.value[k]);
    }
    context->kept_offset = arena.offset_of(kept);
    return true;
}

std::uint32_t born_at_zero(const netmesh_context* context) {
    switch (context->filter) {
    case NETMESH_FILTER_COMPLETE:
    case NETMESH_FILTER_TIGHT: return context->inputs;
    case NETMESH_FILTER_KNN:
    case NETMESH_FILTER_KDISTANCE: return context->k <= 1 ? context->inputs : 0;
    default: return 0;
    }
}

Status keep_diagram_of(netmesh_context* context, ListedComplex& complex, const ComplexRequest& request,
                       Monitor& monitor) {
    Arena& arena = context->arena;
    Status status = order_by_value(complex, arena);
    if (status != Status::ok) return status;
    const FilteredComplex filtered = complex.filtered();
    context->simplices = 0;
    for (std::uint32_t k = 0; k <= complex.dimension && k <= request.counted; ++k)
        context->simplices += complex.count[k];
    const DiagramRequest wanted = {request.max_degree, request.keep_zero};
    PairList pairs = {};
    if (request.representatives) {
        if (!keep_complex(context, complex)) return Status::out_of_memory;
        Representatives found = {};
        status = persist_with_cycles(filtered, wanted, {arena, monitor}, &found);
        pairs = found.pairs;
        context->cycles = found.store;
    } else {
        status = is_skeleton(filtered, request.max_degree)
                     ? persist_cohomology(filtered, wanted, {arena, monitor}, &pairs)
                     : persist_homology(filtered, wanted, {arena, monitor}, &pairs);
    }
    return status == Status::ok ? keep_pairs(context, pairs, request) : status;
}

Status keep_pairs(netmesh_context* context, PairList pairs, const ComplexRequest& request) {
    if (!request.representatives) {
        context->arena.release_low(context->start);
        Pair* const moved = context->arena.take_low<Pair>(static_cast<std::size_t>(pairs.count));  // not above pairs
        if (moved == nullptr) return Status::out_of_memory;
        __builtin_memmove(moved, pairs.pairs, sizeof(Pair) * static_cast<std::size_t>(pairs.count));
        pairs.pairs = moved;
    }
    context->is_complex = context->complete = context->has_diagram = true;
    context->has_cycles = request.representatives;
    context->pairs_offset = context->arena.offset_of(pairs.pairs);
    context->pair_count = pairs.count;
    context->max_degree = request.max_degree;
    context->result_fingerprint = fingerprint_of(context, pairs);
    return Status::ok;
}

}  // namespace netmesh
