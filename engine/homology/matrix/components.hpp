// What the reductions of a listed complex share: its highest dimension that counts, and degree 0.
#pragma once
#include <cstdint>

#include "homology/bit_set.hpp"
#include "homology/matrix/listed_columns.hpp"
#include "homology/pair_writer.hpp"
#include "homology/union_find.hpp"

namespace netmesh {

// The request as far as the complex can answer it.
inline DiagramRequest limited(DiagramRequest request, const FilteredComplex& complex) {
    if (request.max_degree > complex.dimension) request.max_degree = complex.dimension;
    return request;
}

// The highest dimension whose simplices matter to degrees up to max_degree.
inline std::uint32_t top_dimension(const FilteredComplex& complex, std::uint32_t max_degree) {
    return max_degree + 1 < complex.dimension ? max_degree + 1 : complex.dimension;
}

// The largest number of simplices of one dimension up to top, at least 1.
inline std::uint32_t largest_count(const FilteredComplex& complex, std::uint32_t top) {
    std::uint32_t most = 1;
    for (std::uint32_t k = 0; k <= top; ++k) {
        if (complex.of[k].count > most) most = complex.of[k].count;
    }
    return most;
}

// For unite_edges(): writes the pairs of degree 0 and marks the edges that join two components.
struct ComponentWriter {
    const FilteredComplex& complex;
    PairWriter& writer;
    BitSet& joining;
    Progress& progress;

    Status visit(std::uint32_t) {
        const bool stop = progress.stop(1);
        ++progress.done;
        return stop ? Status::cancelled : Status::ok;
    }
    EdgeEnds ends(std::uint32_t e) const {
        const std::uint32_t* const vertices = complex.of[1].faces + 2 * std::size_t{e};
        return {vertices[0], vertices[1]};
    }
    Status merge(std::uint32_t e, std::uint32_t, std::uint32_t younger) {
        joining.insert(e);
        return writer.add(complex.of[0].value[younger], complex.of[1].value[e], 0) ? Status::ok : Status::out_of_memory;
    }
    Status keep(std::uint32_t v) {
        return writer.add_essential(complex.of[0].value[v], 0) ? Status::ok : Status::out_of_memory;
    }
};

}  // namespace netmesh
