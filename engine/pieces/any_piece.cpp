// Leaves' faces and splits where the dimension is a number.
#include "pieces/leaf_faces.hpp"
#include "pieces/split.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

Status list_leaf_faces(const PointSource& source, PieceNode node, const Work& work, LeafFaces* out,
                       StarsReport* report) {
    return with_dimension(source.from.dim, [&](auto dimension) {
        return list_leaf_faces<decltype(dimension)::value>(source, node, work, out, report);
    });
}

Status split_points(const InputRows& points, std::uint32_t n, int dim, std::uint32_t pieces, const Work& work,
                    SplitPoints* out) {
    const std::size_t low = work.arena.low_mark();
    const HighScope scope(work.arena);
    *out = SplitPoints{};
    const Status status = with_dimension(static_cast<std::uint32_t>(dim), [&](auto dimension) {
        return split_points<decltype(dimension)::value>(points, n, pieces, work, out);
    });
    if (status != Status::ok) work.arena.release_low(low);
    return status;
}

}  // namespace netmesh
