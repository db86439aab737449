#include "api/complex_job.hpp"

#include "filtration/filters.hpp"
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
    return zero_born_count(context->filter, context->k, context->inputs);
}

Status keep_diagram_of(netmesh_context* context, ListedComplex& complex, const ComplexRequest& request,
                       Monitor& monitor) {
    ComplexDiagram diagram;
    const Status status = persist_complex(complex, request, {context->arena, monitor}, &diagram);
    if (status != Status::ok) return status;
    context->simplices = diagram.simplices;
    context->cycles = diagram.cycles;
    const Status kept = keep_pairs(context, diagram.pairs, request);
    if (kept == Status::ok && request.representatives && !keep_complex(context, complex)) return Status::out_of_memory;
    return kept;
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
    context->max_degree = request.diagram.max_degree;
    context->result_fingerprint = fingerprint_of(context, pairs);
    return Status::ok;
}

}  // namespace netmesh
