// Points of a diagram as an implicit k-d tree: the root of a stretch is its middle, births and deaths split in turns.
// Every point carries a set of marks, and every node the union of the marks below it, so that a search sees only points
// that have the mark it looks for.
#pragma once
#include <cstdint>

#include "diagram/cost.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct DiagramPoint {
    double coordinate[2];    // birth, death: finite
    std::uint64_t diagonal;  // key of the distance to the diagonal
};

class PointTree {
public:
    // Puts points[count] into the order of the tree. mark[count], below[count]: for the marks. O(count log count).
    // monitor: is told of the work, also later; null: nobody is.
    void build(DiagramPoint* points, std::uint64_t* mark, std::uint64_t* below, std::uint32_t count,
               Monitor* monitor = nullptr) {
        monitor_ = monitor;
        points_ = points;
        mark_ = mark;
        below_ = below;
        count_ = count;
        Range stack[levels_max];
        int height = 0;
        for (Range now = {0, count, 0};;) {
            if (now.end - now.begin > 1) {
                const std::uint32_t middle = middle_of(now);
                select(now, middle);
                const int axis = 1 - now.axis;
                stack[height++] = {middle + 1, now.end, axis};
                now = {now.begin, middle, axis};
                continue;
            }
            if (height == 0) return;
            now = stack[--height];
        }
    }

    std::uint32_t count() const { return count_; }
    const DiagramPoint& operator[](std::uint32_t i) const { return points_[i]; }

    // Reports work, step i of a loop, or a piece of one; see Arena.
    void pass(std::uint32_t work) const {
        if (monitor_ != nullptr) monitor_->pass(work);
    }
    void step(std::uint64_t i, std::uint32_t cost) const {
        if (i % 256 == 0) pass(cost);
    }
    [[gnu::noinline]] std::uint64_t piece(std::uint64_t from, std::uint64_t to, std::uint32_t cost) const {
        pass(cost / 4);
        return to - from < 64 ? to : from + 64;
    }
    // The same marks for every point. O(count).
    void mark_all(std::uint64_t marks) {
        for (std::uint32_t i = 0; i < count_; ++i) {
            step(i, 4);
            mark_[i] = below_[i] = marks;
        }
    }
    // Replaces the marks of point i, some of which it must have now. O(log count).
    void mark(std::uint32_t i, std::uint64_t marks) {
        Range path[levels_max];
        int depth = 0;
        Range now = {0, count_, 0};
        while (middle_of(now) != i) {
            path[depth++] = now;
            const std::uint32_t middle = middle_of(now);
            (i < middle ? now.end : now.begin) = i < middle ? middle : middle + 1;
        }
        path[depth++] = now;
        mark_[i] = marks;
        while (depth > 0) {
            const Range r = path[--depth];
            const std::uint32_t middle = middle_of(r);
            std::uint64_t all = mark_[middle];
            if (middle > r.begin) all |= below_[middle_of({r.begin, middle, 0})];
            if (middle + 1 < r.end) all |= below_[middle_of({middle + 1, r.end, 0})];
            if (below_[middle] == all) return;
            below_[middle] = all;
        }
    }

    // A point that has one of `marks`, is no farther than `limit` from `from` and is accepted; `none` if there is none.
    template <class Scale, class Accept>
    std::uint32_t find(const DiagramPoint& from, std::uint64_t limit, std::uint64_t marks, Accept accept) const {
        Range stack[levels_max];
        int height = 0;
        Range now = {0, count_, 0};
        for (;;) {
            std::uint32_t middle = 0;
            if (now.begin < now.end && (below_[middle = middle_of(now)] & marks) != 0) {
                const DiagramPoint& p = points_[middle];
                const double x = from.coordinate[now.axis], split = p.coordinate[now.axis];
                const bool near = Scale::between(x, split) <= limit;
                if (near && (mark_[middle] & marks) != 0 &&
                    Scale::between(from.coordinate[1 - now.axis], p.coordinate[1 - now.axis]) <= limit &&
                    accept(middle)) {
                    return middle;
                }
                const Range left = {now.begin, middle, 1 - now.axis}, right = {middle + 1, now.end, 1 - now.axis};
                if (near) stack[height++] = x <= split ? right : left;
                now = x <= split ? left : right;
                continue;
            }
            if (height == 0) return none;
            now = stack[--height];
        }
    }

    // Calls visit(i) for the points no farther than `limit` from `from`, until one call returns false.
    template <class Scale, class Visit>
    void visit_within(const DiagramPoint& from, std::uint64_t limit, Visit visit) const {
        Range stack[levels_max];
        int height = 0;
        Range now = {0, count_, 0};
        for (;;) {
            if (now.begin < now.end) {
                const std::uint32_t middle = middle_of(now);
                const DiagramPoint& p = points_[middle];
                const double x = from.coordinate[now.axis], split = p.coordinate[now.axis];
                const bool near = Scale::between(x, split) <= limit;
                if (near && Scale::between(from.coordinate[1 - now.axis], p.coordinate[1 - now.axis]) <= limit &&
                    !visit(middle)) {
                    return;
                }
                const Range left = {now.begin, middle, 1 - now.axis}, right = {middle + 1, now.end, 1 - now.axis};
                if (near) stack[height++] = x <= split ? right : left;
                now = x <= split ? left : right;
                continue;
            }
            if (height == 0) return;
            now = stack[--height];
        }
    }

    // Distance from `from` to the nearest point that has one of `marks`, `limit` if that is not farther.
    template <class Scale>
    std::uint64_t nearest(const DiagramPoint& from, std::uint64_t limit, std::uint64_t marks) const {
        struct Later {
            Range range;
            std::uint64_t distance;
        };
        Later stack[levels_max];
        int height = 0;
        Range now = {0, count_, 0};
        for (;;) {
            std::uint32_t middle = 0;
            if (now.begin < now.end && (below_[middle = middle_of(now)] & marks) != 0) {
                const DiagramPoint& p = points_[middle];
                const double x = from.coordinate[now.axis], split = p.coordinate[now.axis];
                const std::uint64_t across = Scale::between(x, split);
                if ((mark_[middle] & marks) != 0) {
                    std::uint64_t distance = Scale::between(from.coordinate[1 - now.axis], p.coordinate[1 - now.axis]);
                    if (distance < across) distance = across;
                    if (distance < limit) limit = distance;
                }
                const Range left = {now.begin, middle, 1 - now.axis}, right = {middle + 1, now.end, 1 - now.axis};
                if (across < limit) stack[height++] = {x <= split ? right : left, across};
                now = x <= split ? left : right;
                continue;
            }
            while (height > 0 && stack[height - 1].distance >= limit) --height;
            if (height == 0) return limit;
            now = stack[--height].range;
        }
    }

private:
    static constexpr int levels_max = 34;
    struct Range {
        std::uint32_t begin, end;
        int axis;
    };
    static std::uint32_t middle_of(const Range& r) { return r.begin + (r.end - r.begin) / 2; }

    // Moves the point that belongs at `middle` there, those before it to its left.
    void select(Range range, std::uint32_t middle) {
        const int axis = range.axis;
        std::uint64_t compared = 0;
        const auto less = [this, axis, &compared](const DiagramPoint& a, const DiagramPoint& b) {
            step(++compared, 15);
            return a.coordinate[axis] < b.coordinate[axis];
        };
        netmesh::select(points_ + range.begin, range.end - range.begin, middle - range.begin, less);
    }

    Monitor* monitor_ = nullptr;
    DiagramPoint* points_ = nullptr;
    std::uint64_t *mark_ = nullptr, *below_ = nullptr;
    std::uint32_t count_ = 0;
};

}  // namespace netmesh
