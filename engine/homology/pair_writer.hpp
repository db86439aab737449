// Collects a diagram at the arena's low end. While it is in use nobody else may hold memory at that end.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/persistence.hpp"
#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

class PairWriter {
public:
    PairWriter(Arena& arena, DiagramRequest request)
        : arena_(arena), begin_((arena.low_mark() + Arena::alignment - 1) & ~(Arena::alignment - 1)),
          request_(request) {}

    // Room for this many pairs and no more, so that others may take memory at the low end. False: out of memory.
    bool reserve(std::uint64_t pairs) {
        reserved_ = pairs;
        return pairs <= SIZE_MAX && arena_.take_low<Pair>(static_cast<std::size_t>(pairs)) != nullptr;
    }
    // Notes a pair unless its degree or its zero length leaves it out. False: out of memory.
    bool add(double birth, double death, std::uint32_t degree, std::uint32_t cycle = 0) {
        NETMESH_ASSERT(birth <= death);
        if (!keeps(birth, death, degree)) return true;
        if (!grow()) return false;
        pairs()[count_++] = Pair{birth + 0.0, death + 0.0, degree, cycle};  // no negative zeros
        return true;
    }
    bool add_essential(double birth, std::uint32_t degree) { return add(birth, __builtin_inf(), degree); }
    // Moves what is noted down to `offset`, from where on nothing but pairs stands at the low end any more.
    void move_down(std::size_t offset);
    // Whether add() would note such a pair. What never enters, beyond the largest double, is none.
    bool keeps(double birth, double death, std::uint32_t degree) const {
        return degree <= request_.max_degree && (birth != death || (request_.keep_zero && birth < __builtin_inf()));
    }
    bool keeps_zero() const { return request_.keep_zero; }

    // The pairs in the canonical order. In a file of its own, so that sorting is in the library once.
    PairList finish();
    // The same where no pair names a cycle.
    PairList finish_without_cycles();

    const Arena& arena() const { return arena_; }

private:
    Pair* pairs() const { return reinterpret_cast<Pair*>(arena_.at(begin_)); }
    // Nothing is taken ahead, so a larger block never does worse.
    bool grow() {
        if (reserved_ > 0) return count_ < reserved_;
        return count_ == 0 ? arena_.take_low<Pair>(1) != nullptr : arena_.extend_low(sizeof(Pair));
    }

    Arena& arena_;
    std::size_t begin_;
    DiagramRequest request_;
    std::uint64_t count_ = 0, reserved_ = 0;
};

// Runs a reduction, which has finish() for its pairs at the arena's low end; what it took besides is given back.
template <class Reduction> Status write_diagram(Reduction& reduction, Arena& arena, PairList* out) {
    ArenaScope scope(arena);
    const std::size_t low = arena.low_mark();
    const Status status = reduction.run();
    if (status != Status::ok) {
        if (arena.low_mark() < low) scope.keep_low_from_now();  // of a stacked ball something is gone
        return status;
    }
    *out = reduction.finish();
    scope.keep_low_from_now();
    return Status::ok;
}

}  // namespace netmesh
