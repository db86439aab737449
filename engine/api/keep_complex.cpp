#include "api/keep_complex.hpp"

namespace netmesh {

void keep_cycles(netmesh_context* context, const CycleStore& cycles, std::size_t high_end) {
    context->cycles = {};
    context->cycles.present = true;
    context->cycles.store = cycles;
    context->cycles.high_end = high_end;
}

void keep_complex(netmesh_context* context, const ListedComplex& complex) {
    const Arena& arena = context->arena;
    KeptComplex& kept = context->cycles.complex;
    context->cycles.is_listed = true;
    kept.dimension = complex.dimension;
    for (std::uint32_t k = 0; k <= complex.dimension; ++k) {
        kept.of[k] = {arena.offset_of(complex.rows[k]), arena.offset_of(complex.value[k]), complex.count[k]};
    }
}

void keep_diagram(netmesh_context* context, const KeptInput& input, const KeptDiagram& diagram,
                  const ComplexDiagram& made, const ListedComplex* complex) {
    context->complete = true;
    context->input = input;
    context->diagram = diagram;
    context->diagram.present = true;
    context->diagram.pairs = Slice<Pair>::of(context->arena, made.pairs.pairs, made.pairs.count);
    context->diagram.simplices = made.simplices;
    if (complex == nullptr) return;
    keep_cycles(context, made.cycles, context->arena.bytes());
    keep_complex(context, *complex);
}

FilteredComplex kept_complex(const netmesh_context* context, const std::uint32_t** labels) {
    const KeptComplex& kept = context->cycles.complex;
    const void* const block = context;
    FilteredComplex complex = {};
    complex.dimension = kept.dimension;
    for (std::uint32_t k = 0; k <= kept.dimension; ++k) {
        const KeptComplex::Simplices& of = kept.of[k];
        complex.of[k] = {static_cast<std::uint32_t>(of.count), Slice<std::uint32_t>{of.rows, of.count}.in(block),
                         Slice<double>{of.values, of.count}.in(block)};
    }
    *labels = complex.of[0].faces;
    return complex;
}

}  // namespace netmesh
