#include "pieces/split.hpp"

#include "delaunay/spatial_order.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/sort.hpp"
#include "pieces/box.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Points are moved with their rows, so that each node's stand together.
template <int D> class TreeOrder {
public:
    TreeOrder(const InputRows& points, std::uint32_t n, std::uint32_t pieces, const Work& work, SplitPoints* out)
        : points_(points), n_(n), pieces_(pieces), arena_(work.arena), work_(work), out_(*out) {}

    Status run() {
        Status status = read();
        if (status == Status::ok) status = drop_equal();
        if (status == Status::ok) status = cut();
        return status == Status::ok && arena_.has_stopped() ? Status::cancelled : status;
    }

private:
    struct Point {
        double x[D];
        std::uint32_t row;
    };

    Status read() {
        work_.monitor.begin(NETMESH_STAGE_SORT, n_);
        out_.order = arena_.take_low<std::uint32_t>(n_);
        point_ = arena_.take_high<Point>(n_);
        if (out_.order == nullptr || point_ == nullptr) return Status::out_of_memory;
        Fingerprint fingerprint;
        fingerprint.add(std::uint64_t{D});
        for (std::uint32_t i = 0; i < n_; ++i) {
            arena_.step(i, 10 * D);
            point_[i].row = i;
            if (!points_.read(i, D, point_[i].x)) {
                out_.culprit = i;
                return Status::not_finite;
            }
            for (const double x : point_[i].x) fingerprint.add(x);
        }
        out_.fingerprint = fingerprint.value();
        return Status::ok;
    }

    // Equal points are neighbours in a spatial order, the one with the smallest index first.
    Status drop_equal() {
        bool repeats;
        std::uint32_t* const order = out_.order;
        const Status status =
            spatial_order<D>(reinterpret_cast<const unsigned char*>(point_), static_cast<std::ptrdiff_t>(sizeof(Point)),
                             n_, 0, arena_, order, &repeats, false);
        if (status != Status::ok) return status;
        // Along the cycles of the order, each place done becoming its own.
        arena_.each(n_, 30, [this, order](std::uint64_t first) {
            auto to = static_cast<std::uint32_t>(first);
            if (order[to] == to) return;
            const Point point = point_[to];
            for (std::uint32_t from; (from = order[to]) != first; to = from) {
                point_[to] = point_[from];
                order[to] = to;
            }
            point_[to] = point;
            order[to] = to;
        });
        std::uint32_t kept = 0;
        arena_.each(n_, 4 * D, [this, &kept](std::uint64_t i) {
            bool is_equal = kept > 0;
            for (int k = 0; k < D && is_equal; ++k) is_equal = point_[i].x[k] == point_[kept - 1].x[k];
            if (!is_equal) point_[kept++] = point_[i];
        });
        out_.count = kept;
        arena_.release_low(arena_.offset_of(out_.order + kept));
        return Status::ok;
    }

    Status cut() {
        if (pieces_ > out_.count) return Status::invalid_argument;
        const std::uint32_t levels = out_.levels = piece_levels(out_.count, pieces_), nodes = (2u << levels) - 1;
        out_.boxes = arena_.take_low<double>(std::size_t{nodes} * 2 * D);
        if (out_.boxes == nullptr) return Status::out_of_memory;
        // Each node before those below it, which follow at once.
        for (PieceNode node = root_piece; node != no_piece; node = next_piece(node, levels)) {
            const PieceRange range = range_of(node, out_.count);
            const Box<D> box = box_of(range);
            double* const to = out_.boxes + std::size_t{node - 1} * 2 * D;
            int axis = 0;
            for (int k = 0; k < D; ++k) {
                to[k] = box.least[k];
                to[D + k] = box.most[k];
                if (box.most[k] - box.least[k] > box.most[axis] - box.least[axis]) axis = k;
            }
            if (work_.monitor.advance(range.first, 1 + range.count() / 10)) return Status::cancelled;
            if (depth_of(node) == levels) {
                // By rows, so that the order does not depend on how medians are found.
                insertion_sort(point_ + range.first, range.count(),
                               [](const Point& a, const Point& b) { return a.row < b.row; });
                continue;
            }
            select(point_ + range.first, range.count(), range.count() / 2, [axis](const Point& a, const Point& b) {
                if (a.x[axis] != b.x[axis]) return a.x[axis] < b.x[axis];
                for (int k = 0; k < D; ++k)
                    if (a.x[k] != b.x[k]) return a.x[k] < b.x[k];
                return a.row < b.row;
            });
        }
        arena_.each(out_.count, 2, [this](std::uint64_t i) { out_.order[i] = point_[i].row; });
        return Status::ok;
    }
    Box<D> box_of(PieceRange range) const {
        Box<D> box;
        for (int k = 0; k < D; ++k) box.least[k] = box.most[k] = point_[range.first].x[k];
        arena_.each(range.count(), 2 * D, [&](std::uint64_t i) {
            const double* const x = point_[range.first + i].x;
            for (int k = 0; k < D; ++k) {
                box.least[k] = x[k] < box.least[k] ? x[k] : box.least[k];
                box.most[k] = x[k] > box.most[k] ? x[k] : box.most[k];
            }
        });
        return box;
    }

    const InputRows& points_;
    const std::uint32_t n_, pieces_;
    Arena& arena_;
    const Work& work_;
    SplitPoints& out_;
    Point* point_ = nullptr;
};

}  // namespace

template <int D>
Status split_points(const InputRows& points, std::uint32_t n, std::uint32_t pieces, const Work& work,
                    SplitPoints* out) {
    return TreeOrder<D>(points, n, pieces, work, out).run();
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status split_points<D>(const InputRows&, std::uint32_t, std::uint32_t, const Work&, SplitPoints*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
