// Where pieces have their points from: the caller's points in the order of the tree, of which a job reads few.
#pragma once
#include <cstdint>

#include "numerics/real.hpp"
#include "pieces/node.hpp"
#include "vocabulary/callback.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct PointSource {
    netmesh_source from;

    std::uint32_t points() const { return static_cast<std::uint32_t>(from.count); }
    int dim() const { return static_cast<int>(from.dim); }
    std::uint32_t levels() const { return from.levels; }
    PieceRange range(PieceNode node) const { return range_of(node, points()); }

    // Points [range.first, range.last), at most piece_points_most of them, and their rows. not_finite, and what the
    // caller's function says.
    Status read(PieceRange range, double* x, std::uint32_t* row) const {
        const netmesh_status status = read_rows(from, range.first, range.count(), x, row);
        if (status != NETMESH_OK) return static_cast<Status>(status);
        for (std::uint32_t i = 0; i < range.count() * from.dim; ++i) {
            if (!is_finite(x[i])) return Status::not_finite;
            x[i] += 0.0;
        }
        return Status::ok;
    }
    Status read_box(PieceNode node, double* least, double* most) const {
        double box[2 * dimension_most()];
        const netmesh_status status = read_node(from, node, box);
        if (status != NETMESH_OK) return static_cast<Status>(status);
        bool is_box = true;
        for (std::uint32_t k = 0; k < from.dim; ++k) {
            least[k] = box[k];
            most[k] = box[from.dim + k];
            is_box &= most[k] - least[k] >= 0;  // not where one is no number
        }
        return is_box ? Status::ok : Status::not_finite;
    }
};

}  // namespace netmesh
