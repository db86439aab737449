// The matching of two diagrams that a map between their persistence modules induces. Bauer, Lesnick: Induced matchings
// and the algebraic stability of persistence barcodes (2015).
#pragma once
#include <cstdint>

#include "diagram/pair.hpp"

namespace netmesh {

// The diagrams of two modules and of the image of a map from one to the other, each in the canonical order, without
// pairs of zero length.
struct MappedDiagrams {
    PairList source, image, target;
};

// A pair of the image begins with one of the source that lasts at least as long, and ends with one of the target that
// began no later; of pairs with one birth (one death) the longest ones are taken, in their order. Each pair of the
// image so joins a pair of the source and one of the target: to[source.count] is the target's or `none`. Scratch: 4
// bytes for each pair of image and target. out_of_memory; internal: these are no diagrams of such modules.
Status match_induced(const MappedDiagrams& diagrams, Arena& arena, std::uint32_t* to);

}  // namespace netmesh
