// The points of other nodes, as the triangulation about one node asks for them.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"
#include "numerics/sort.hpp"
#include "pieces/box.hpp"
#include "pieces/source.hpp"
#include "pieces/stars.hpp"

namespace netmesh {

// Points near a star, read once for all of its cells.
template <int D> struct NearPoints {
    static constexpr std::uint32_t most = 160;
    std::uint32_t count;
    double x[most * D];
    std::uint32_t row[most], position[most];
};

template <int D> class Others {
public:
    static constexpr std::uint32_t stack_max = 72;

    Others(const PointSource& source, PieceNode node, StarsReport& report)
        : source_(source), node_(node), levels_(source.levels()), report_(report) {}

    // Reads the boxes that all searches begin with. reach: how far the neighbourhood goes, in sides of a cube that
    // holds one of the node's own points.
    // They are taken at the arena's low end.
    Status open(double reach, Arena& arena) {
        beside_ = arena.take_low<Box<D>>(depth_of(node_));
        if (beside_ == nullptr) return Status::out_of_memory;
        Status status = read_box(node_, &own_);
        if (status == Status::ok) status = take_beside();
        return status == Status::ok ? take_neighbourhood(reach) : status;
    }
    const Box<D>& own() const { return own_; }

    // The neighbourhood of the node's own box, without end where there are no other points.
    bool is_near(const Box<D>& box) const {
        bool meets = true;
        for (int k = 0; k < D; ++k) meets &= box.least[k] <= around_.most[k] && box.most[k] >= around_.least[k];
        return meets;
    }
    // Whether the ball, its error added, is within the neighbourhood.
    bool is_inside(const Cell<D>& cell) const {
        const double error = static_cast<double>(cell.error) + 0x1p-40;
        if (!(error < 0.125)) return false;
        const double reach2 = (cell.radius2 * (1 + 4 * error) + 0x1p-950) * (1 + 4 * error);
        for (int k = 0; k < D; ++k) {
            const double above = cell.centre[k] - around_.least[k], below = around_.most[k] - cell.centre[k];
            if (!(above > 0 && below > 0 && above * above > reach2 && below * below > reach2)) return false;
        }
        return true;
    }

    // Calls lowest(range) for lowest nodes of others that wants(node, box) does not refuse, and begins with the nearest
    // to x; what is farther than the square root of *most2 is left out. Both may lower that. A status of lowest's other
    // than ok ends it.
    template <class Wants, class Lowest>
    [[gnu::noinline]] Status walk(const double* x, const double* most2, Wants&& wants, Lowest&& lowest) {
        Search search;
        const auto offer = [&](PieceNode node, const Box<D>& box) {
            const double away2 = box.distance2(x) * (1 - 0x1p-40);
            if (!(away2 > *most2) && wants(node, box)) search.push(node, away2);
        };
        report_.visits += beside_count_;
        for (std::uint32_t i = 0; i < beside_count_; ++i) offer(beside_node_[i], beside_[i]);
        search.order(0);
        Status status = Status::ok;
        while (!search.is_empty() && status == Status::ok) {
            const Waiting next = search.pop();
            if (next.away2 > *most2) continue;
            if (depth_of(next.node) == levels_) {
                status = lowest(source_.range(next.node));
                continue;
            }
            const std::uint32_t begin = search.count();
            for (PieceNode node = 2 * next.node; node <= 2 * next.node + 1 && status == Status::ok; ++node) {
                Box<D> box;
                status = read_box(node, &box);
                if (status == Status::ok) offer(node, box);
            }
            search.order(begin);
        }
        return status;
    }

    // Points within the square root of reach2 of x, and some more. *is_read: there were not too many.
    [[gnu::noinline]] Status read_near(const double* x, double reach2, NearPoints<D>* near, bool* is_read) {
        near->count = 0;
        *is_read = true;
        return walk(
            x, &reach2, [&](PieceNode, const Box<D>&) { return *is_read; },
            [&](PieceRange range) {
                if (near->count + range.count() > NearPoints<D>::most) *is_read = false;
                if (!*is_read) return Status::ok;
                double* const some = near->x + near->count * D;
                std::uint32_t* const row = near->row + near->count;
                const Status status = source_.read(range, some, row);
                for (std::uint32_t i = 0, kept = 0; i < range.count(); ++i) {
                    double away2 = 0;
                    for (std::uint32_t k = 0; k < D; ++k) {
                        const double d = (some[kept * D + k] = some[i * D + k]) - x[k];
                        away2 += d * d;
                    }
                    if (away2 * (1 - 0x1p-40) > reach2) continue;
                    row[kept++] = row[i];
                    near->position[near->count++] = range.first + i;
                }
                return status;
            });
    }

    // Others to begin with: take(range) for lowest nodes that meet the neighbourhood, take_one(position) for one of
    // each box that is small for how far away it is, by a factor of squares.
    template <class Take, class TakeOne> Status begin(double factor, Take&& take, TakeOne&& take_one) {
        PieceNode stack[stack_max];
        std::uint32_t waiting = 0;
        for (std::uint32_t i = 0; i < beside_count_; ++i) stack[waiting++] = beside_node_[i];
        Status status = Status::ok;
        while (waiting > 0 && status == Status::ok) {
            const PieceNode node = stack[--waiting];
            Box<D> box;
            status = read_box(node, &box);
            if (status != Status::ok) break;
            const bool meets = is_near(box), is_lowest = depth_of(node) == levels_;
            const PieceRange range = source_.range(node);
            if (meets && is_lowest) {
                status = take(range);
            } else if (is_lowest || (!meets && box.diagonal2() < factor * box.distance2(own_))) {
                status = take_one(range.first + range.count() / 2);
            } else {
                stack[waiting++] = 2 * node + 1;
                stack[waiting++] = 2 * node;
            }
        }
        return status;
    }

private:
    struct Waiting {
        PieceNode node;
        double away2;
    };
    // Boxes that are still to be looked at, the nearest last.
    class Search {
    public:
        bool is_empty() const { return count_ == 0; }
        Waiting pop() { return stack_[--count_]; }
        void push(PieceNode node, double away2) { stack_[count_++] = {node, away2}; }
        // Puts the last one or two, from `begin` on, in order.
        void order(std::uint32_t begin) {
            insertion_sort(stack_ + begin, count_ - begin,
                           [](const Waiting& a, const Waiting& b) { return a.away2 > b.away2; });
        }
        std::uint32_t count() const { return count_; }

    private:
        Waiting stack_[stack_max];
        std::uint32_t count_ = 0;
    };

    Status read_box(PieceNode node, Box<D>* box) {
        ++report_.visits;
        return source_.read_box(node, box->least, box->most);
    }
    // Boxes beside the path from node 1 to this one, which hold all other points.
    Status take_beside() {
        for (PieceNode node = node_; node != root_piece; node /= 2) {
            const std::uint32_t i = beside_count_++;
            beside_node_[i] = node ^ 1u;
            const Status status = read_box(node ^ 1u, &beside_[i]);
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }
    Status take_neighbourhood(double reach) {
        Box<D> all;
        const Status status = read_box(root_piece, &all);
        if (status != Status::ok) return status;
        // A cube of this side holds one of the node's own points.
        double widest = 0;
        for (int k = 0; k < D; ++k)
            widest = own_.most[k] - own_.least[k] > widest ? own_.most[k] - own_.least[k] : widest;
        double share = 1;
        for (int k = 0; k < D; ++k) share *= widest > 0 ? (own_.most[k] - own_.least[k]) / widest : 0;
        double least = 0, most = 1;
        for (int step = 0; step < 40; ++step) {
            const double middle = 0.5 * (least + most);
            double count = source_.range(node_).count();
            for (int k = 0; k < D; ++k) count *= middle;
            (count < share ? least : most) = middle;
        }
        const double away = reach * least * widest;
        for (int k = 0; k < D; ++k) {
            around_.least[k] = all.least[k] < own_.least[k] ? own_.least[k] - away : -infinity;
            around_.most[k] = all.most[k] > own_.most[k] ? own_.most[k] + away : infinity;
        }
        return Status::ok;
    }

    const PointSource& source_;
    const PieceNode node_;
    const std::uint32_t levels_;
    StarsReport& report_;
    Box<D> own_, around_, *beside_ = nullptr;
    PieceNode beside_node_[32];
    std::uint32_t beside_count_ = 0;
};

}  // namespace netmesh
