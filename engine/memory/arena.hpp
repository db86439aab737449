// The caller's block as one two-ended stack.
//
//   base                                                        base + size
//   | context | low end: cells, tables -->   gap   <-- high end: vertices, scratch |
//
// Nothing has a pool of its own: whatever one structure leaves free, any other can take. Both ends are
// stacks; a mark taken before a piece of work gives all of its memory back at once. What lives in the
// block refers to the block by offset or index only, so the block may be copied elsewhere byte by byte. What stands at
// which end, job by job: engine/ARCHITECTURE.md, "The block".
#pragma once
#include <cstddef>
#include <cstdint>

#include "vocabulary/monitor.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {

#ifdef NETMESH_SWEEP
// Defined by tests/sweep, which makes chosen requests fail that would fit.
bool sweep_refuses();
#else
constexpr bool sweep_refuses() { return false; }
#endif

class Arena {
public:
    static constexpr std::size_t alignment = 16;

    // Takes over [base, base + bytes). base must be 16-byte aligned; the tail past a multiple of 16 is unused.
    void adopt(void* base, std::size_t bytes) {
        NETMESH_ASSERT(reinterpret_cast<std::uintptr_t>(base) % alignment == 0);
        base_ = static_cast<unsigned char*>(base);
        size_ = bytes & ~(alignment - 1);
        low_ = 0;
        high_ = size_;
        peak_ = 0;
        wanted_ = 0;
    }
    // The same block at a new address, with nobody who watches.
    void rebase(void* base) {
        base_ = static_cast<unsigned char*>(base);
        watch(nullptr);
    }

    // Who watches the job that works in this block, for the time of one call; null: nobody. So whoever is given memory
    // can report from the loops that work on it, which are short steps and many of them. A wish to stop is remembered
    // there (Monitor::pass), so these loops go on to their end and leave nothing half done.
    void watch(Monitor* monitor) { monitor_ = monitor; }
    // Reports work that has been done, in units of roughly 100 ns.
    void pass(std::uint32_t work) const;
    // For a loop over [from, to), in pieces: reports the piece that begins at `from`, and returns where it ends. cost:
    // instructions of one step, or so.
    //     for (std::uint32_t i = 0; i < count;)
    //         for (const std::uint64_t piece = arena.piece(i, count, 20); i < piece; ++i) ...
    // Where size counts a piece is one step, as two loops in one another and three arguments take more code than a call
    // in each step.
#ifdef __OPTIMIZE_SIZE__
    std::uint64_t piece(std::uint64_t from, std::uint64_t, std::uint32_t cost) const {
        tick(cost);
        return from + 1;
    }
#else
    std::uint64_t piece(std::uint64_t from, std::uint64_t to, std::uint32_t cost) const {
        const std::uint64_t most = cost < 300 ? 1024 : 64;
        pass(static_cast<std::uint32_t>(most / 64) * cost / 4);
        return to - from < most ? to : from + most;
    }
#endif
    // For other loops: reports step i, in each 256th for all of them.
    void step(std::uint64_t i, std::uint32_t cost) const {
#ifdef __OPTIMIZE_SIZE__
        static_cast<void>(i);
        tick(cost);
#else
        if (i % 256 == 0) pass(cost);
#endif
    }
    // Does step(i) for i in [0, count), with reports between.
    template <class Step> void each(std::uint64_t count, std::uint32_t cost, Step&& take_step) const {
        for (std::uint64_t i = 0; i < count;)
            for (const std::uint64_t end = piece(i, count, cost); i < end; ++i) take_step(i);
    }
    // Has whoever watches said that it wants to stop?
    bool has_stopped() const { return monitor_ != nullptr && monitor_->has_stopped(); }

    std::size_t bytes() const { return size_; }
    std::size_t bytes_free() const { return sweep_refuses() ? 0 : high_ - low_; }
    std::size_t bytes_used() const { return low_ + (size_ - high_); }
    // The size of the smallest block that all requests so far fit: a multiple of the alignment, as what a block has
    // beyond one is not used. bytes_wanted: the largest total that a refused request asked for, 0 if none.
    std::size_t bytes_peak() const { return (peak_ + alignment - 1) & ~(alignment - 1); }
    std::size_t bytes_wanted() const { return wanted_; }

    // count objects of T, uninitialised, at the low (high) end, 16-byte aligned; nullptr when the gap is too small,
    // and then nothing has changed. O(1).
    template <class T> T* take_low(std::size_t count) { return reinterpret_cast<T*>(take_items_low(count, sizeof(T))); }
    template <class T> T* take_high(std::size_t count) {
        return reinterpret_cast<T*>(take_items_high(count, sizeof(T)));
    }
    // Makes the last piece at the low (high) end longer by exactly this many bytes (a multiple of 8). False: no room.
    bool extend_low(std::size_t bytes) {
        NETMESH_ASSERT(bytes % 8 == 0);
        std::size_t need;
        if (!fits(bytes, 1, 0, &need)) return false;
        low_ += bytes;
        return true;
    }
    bool extend_high(std::size_t bytes) {
        NETMESH_ASSERT(bytes % 8 == 0);
        std::size_t need;
        if (!fits(bytes, 1, 0, &need)) return false;
        high_ -= bytes;
        return true;
    }
    // Counts what a larger block would have been needed for, without being taken: bytes in the gap that were asked for
    // or written to; in all what the same call used before the arena was adopted anew.
    void raise_peak(std::size_t bytes) {
        if (bytes > peak_) peak_ = bytes;
    }
    void use_gap(std::size_t bytes) { raise_peak(bytes_used() + bytes); }
    // What is done depends on how large the block is, so nothing smaller does the same.
    void use_all() { peak_ = size_ & ~(alignment - 1); }
    // Remembers a request that was found not to fit without being made.
    void refuse(std::size_t bytes) {
        const std::size_t total = bytes_used() + bytes;
        if (total > wanted_) wanted_ = total;
    }

    std::size_t low_mark() const { return low_; }
    std::size_t high_mark() const { return high_; }
    // Gives back what was taken since the mark; or, for owners that know what else stands there, sets the end anew.
    void release_low(std::size_t mark) {
        NETMESH_ASSERT(mark <= high_);
        low_ = mark;
    }
    void release_high(std::size_t mark) {
        NETMESH_ASSERT(low_ <= mark && mark <= size_);
        high_ = mark;
    }
    unsigned char* at(std::size_t offset) const { return base_ + offset; }
    std::size_t offset_of(const void* p) const {
        return static_cast<std::size_t>(static_cast<const unsigned char*>(p) - base_);
    }

private:
#ifdef __OPTIMIZE_SIZE__
    void tick(std::uint32_t cost) const;
#endif
    // One piece of code for all types.
    unsigned char* take_items_low(std::size_t count, std::size_t item_bytes) {
        const std::size_t start = (low_ + alignment - 1) & ~(alignment - 1);
        std::size_t need;
        if (sweep_refuses() || !fits(count, item_bytes, start - low_, &need)) return nullptr;
        low_ = start + need;
        return base_ + start;
    }
    unsigned char* take_items_high(std::size_t count, std::size_t item_bytes) {
        const std::size_t end = high_ & ~(alignment - 1);
        std::size_t need;
        if (sweep_refuses() || !fits(count, item_bytes, high_ - end, &need)) return nullptr;
        high_ = (end - need) & ~(alignment - 1);
        return base_ + high_;
    }
    bool fits(std::size_t count, std::size_t item_bytes, std::size_t padding, std::size_t* need) {
        if (count > (SIZE_MAX / 2) / item_bytes) {
            wanted_ = SIZE_MAX;
            return false;
        }
        *need = count * item_bytes;
        if (*need + padding + alignment <= high_ - low_) {
            use_gap(*need + padding + alignment);
            return true;
        }
        refuse(*need + padding + alignment);
        return false;
    }
    unsigned char* base_;
    std::size_t size_, low_, high_, peak_, wanted_;
    Monitor* monitor_ = nullptr;
};

// memmove of what may be large, with reports to whoever watches `arena`.
inline void move_bytes(void* to, const void* from, std::size_t bytes, const Arena& arena) {
    constexpr std::size_t piece = std::size_t{1} << 16;
    auto* const a = static_cast<unsigned char*>(to);
    const auto* const b = static_cast<const unsigned char*>(from);
    const bool down = a <= b;
    for (std::size_t moved = 0; moved < bytes;) {
        const std::size_t next = bytes - moved < piece ? bytes - moved : piece;
        const std::size_t at = down ? moved : bytes - moved - next;
        __builtin_memmove(a + at, b + at, next);
        moved += next;
        arena.pass(64);
    }
}

// Gives everything taken at both ends since its construction back, unless kept.
class ArenaScope {
public:
    explicit ArenaScope(Arena& arena) : arena_(arena), low_(arena.low_mark()), high_(arena.high_mark()) {}
    ~ArenaScope() {
        arena_.release_low(low_);
        arena_.release_high(high_);
    }
    ArenaScope(const ArenaScope&) = delete;
    ArenaScope& operator=(const ArenaScope&) = delete;
    // What was taken at the low end stays, also what is taken from now on.
    void keep_low_from_now() { low_ = arena_.low_mark(); }

private:
    Arena& arena_;
    std::size_t low_, high_;
};

// Gives what was taken at the high end since its construction back.
class HighScope {
public:
    explicit HighScope(Arena& arena) : arena_(arena), high_(arena.high_mark()) {}
    ~HighScope() { arena_.release_high(high_); }
    HighScope(const HighScope&) = delete;
    HighScope& operator=(const HighScope&) = delete;

private:
    Arena& arena_;
    std::size_t high_;
};

}  // namespace netmesh
