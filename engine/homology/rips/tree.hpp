// Degree 0 of a Rips complex: a shortest spanning tree, which grows by one vertex at a time. No edge is stored.
#pragma once
#include <cstdint>

#include "homology/pair_writer.hpp"
#include "memory/work.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// half(i, j, near, limit): when vertices i and j < i are joined, or if that is not before `near`, a number that is not
// and within the limit where that is; edges later than the limit, or never, are none. stop(v): whether the
// caller wants to stop, before each half().
template <class Half, class Stop> class RipsTree {
public:
    RipsTree(std::uint32_t n, double limit, Half half, Stop stop, bool keep_zero, Arena& arena)
        : n_(n), limit_(limit), half_(half), stop_(stop), arena_(arena), writer_(arena, {0, keep_zero}) {}

    Status run() {
        std::uint32_t* const left = arena_.take_high<std::uint32_t>(n_);  // vertices that are not in the tree
        double* const near = arena_.take_high<double>(n_);                // how near it is to them
        if (left == nullptr || near == nullptr) return Status::out_of_memory;
        arena_.each(n_, 1, [&](std::uint64_t i) {
            left[i] = static_cast<std::uint32_t>(i);
            near[i] = __builtin_inf();
        });
        simplices_ = n_;
        std::uint32_t next = n_ - 1;
        for (std::uint32_t count = n_; count > 0;) {
            const std::uint32_t v = left[next];
            const bool joined = near[next] < __builtin_inf();
            if (!(joined ? writer_.add(0, near[next], 0) : writer_.add_essential(0, 0))) return Status::out_of_memory;
            left[next] = left[--count];
            near[next] = near[count];
            next = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                if (stop_(n_ - count)) return Status::cancelled;
                const std::uint32_t w = left[i];
                const double half = v > w ? half_(v, w, near[i], limit_) : half_(w, v, near[i], limit_);
                if (half <= limit_ && half < __builtin_inf()) {
                    ++simplices_;
                    if (half < near[i]) near[i] = half;
                }
                if (near[i] < near[next]) next = i;
            }
        }
        return Status::ok;
    }
    PairList finish() { return writer_.finish(); }
    std::uint64_t simplices() const { return simplices_; }  // vertices and edges

private:
    std::uint32_t n_;
    double limit_;
    Half half_;
    Stop stop_;
    Arena& arena_;
    PairWriter writer_;
    std::uint64_t simplices_ = 0;
};

}  // namespace netmesh
