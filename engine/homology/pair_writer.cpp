#include "homology/pair_writer.hpp"

#include "numerics/sort.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__
namespace {

void reverse(Pair* pairs, std::uint64_t count, const Arena& arena) {
    for (std::uint64_t i = 0, j = count; i + 1 < j; ++i) {
        arena.step(i, 12);
        const Pair t = pairs[i];
        pairs[i] = pairs[--j];
        pairs[j] = t;
    }
}

// Puts pairs[at] among those before it, which are in order.
void insert_backwards(Pair* pairs, std::uint64_t at, const Arena& arena) {
    constexpr CanonicalOrder before;
    const Pair moved = pairs[at];
    for (; at > 0 && before(moved, pairs[at - 1]); --at) {
        arena.step(at, 6);
        pairs[at] = pairs[at - 1];
    }
    pairs[at] = moved;
}

// Pairs of one degree. Union-find writes them in order or backwards; of a quotient a few classes that last come behind.
void sort_degree(Pair* pairs, std::uint64_t count, const Arena& arena) {
    constexpr CanonicalOrder before;
    std::uint64_t up = 0, down = 0;
    for (std::uint64_t i = 1; i < count; ++i) {
        arena.step(i, 5);
        up += before(pairs[i - 1], pairs[i]);
        down += before(pairs[i], pairs[i - 1]);
    }
    if (down == 0) return;
    if (up == 0) return reverse(pairs, count, arena);
    constexpr std::uint64_t behind_max = 16;
    std::uint64_t falling = 1;
    while (falling < count && !before(pairs[falling - 1], pairs[falling])) arena.step(falling++, 4);
    if (count - falling > behind_max) return sort(pairs, count, before, arena);
    reverse(pairs, falling, arena);
    for (; falling < count; ++falling) insert_backwards(pairs, falling, arena);
}

// Pairs of one degree are mostly written one after the other. Puts the degrees in order, then sorts each. False: they
// are too mixed, and nothing was done.
bool sort_by_degree(Pair* pairs, std::uint64_t count, const Arena& arena) {
    constexpr int runs_max = 8;
    std::uint64_t begin[runs_max + 1] = {};
    int runs = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        arena.step(i, 3);
        if (i > 0 && pairs[i].degree == pairs[i - 1].degree) continue;
        if (runs == runs_max) return false;
        begin[runs++] = i;
    }
    begin[runs] = count;
    for (int done = 0; done < runs; ++done) {
        int least = done;
        for (int r = done + 1; r < runs; ++r) {
            if (pairs[begin[r]].degree < pairs[begin[least]].degree) least = r;
        }
        if (least == done) continue;
        // Those before it change places with it.
        const std::uint64_t start = begin[done], middle = begin[least], size = begin[least + 1] - middle;
        reverse(pairs + start, middle - start, arena);
        reverse(pairs + middle, size, arena);
        reverse(pairs + start, middle + size - start, arena);
        for (int r = least; r > done; --r) begin[r] = begin[r - 1] + size;
    }
    for (int r = 0, end; r < runs; r = end) {
        end = r + 1;
        while (end < runs && pairs[begin[end]].degree == pairs[begin[r]].degree) ++end;
        sort_degree(pairs + begin[r], begin[end] - begin[r], arena);
    }
    return true;
}

}  // namespace
#endif

void PairWriter::move_down(std::size_t offset) {
    const std::size_t begin = (offset + Arena::alignment - 1) & ~(Arena::alignment - 1);
    NETMESH_ASSERT(begin <= begin_ && reserved_ == 0);
    move_bytes(arena_.at(begin), pairs(), count_ * sizeof(Pair), arena_);
    begin_ = begin;
    arena_.release_low(begin + count_ * sizeof(Pair));
}

PairList PairWriter::finish() {
    sort(pairs(), count_, CanonicalOrder{}, arena_);
    return PairList{pairs(), count_};
}

PairList PairWriter::finish_without_cycles() {
#ifndef __OPTIMIZE_SIZE__
    if (sort_by_degree(pairs(), count_, arena_)) return PairList{pairs(), count_};
#endif
    sort_alike(pairs(), count_, CanonicalOrder{}, arena_);
    return PairList{pairs(), count_};
}

}  // namespace netmesh
