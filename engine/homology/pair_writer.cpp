#include "homology/pair_writer.hpp"

#include "numerics/sort.hpp"

namespace netmesh {

PairList PairWriter::finish() {
    sort(pairs(), count_, CanonicalOrder{}, arena_);
    return PairList{pairs(), count_};
}

}  // namespace netmesh
