#include "homology/pair_writer.hpp"

#include "numerics/sort.hpp"

namespace netmesh {

PairList PairWriter::finish() {
    sort(pairs(), count_, CanonicalOrder{}, arena_);
    return PairList{pairs(), count_};
}

PairList PairWriter::finish_without_cycles() {
    sort_alike(pairs(), count_, CanonicalOrder{}, arena_);
    return PairList{pairs(), count_};
}

}  // namespace netmesh
