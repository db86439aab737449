// Sorting in place, the same on every platform: quicksort without recursion, heapsort where it degenerates.
#pragma once
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

struct Ascending {
    template <class T> bool operator()(const T& a, const T& b) const { return a < b; }
};

template <class T, class Less> void heap_sort(T* items, std::uint64_t count, Less less) {
    for (std::uint64_t left = count / 2, end = count; end > 1;) {
        T item;
        if (left > 0) {
            item = items[--left];
        } else {
            item = items[--end];
            items[end] = items[0];
        }
        std::uint64_t hole = left;
        for (std::uint64_t child; (child = 2 * hole + 1) < end; hole = child) {
            if (child + 1 < end && less(items[child], items[child + 1])) ++child;
            if (!less(item, items[child])) break;
            items[hole] = items[child];
        }
        items[hole] = item;
    }
}

template <class T, class Less> void insertion_sort(T* items, std::uint64_t count, Less less) {
    for (std::uint64_t i = 1; i < count; ++i) {
        const T item = items[i];
        std::uint64_t hole = i;
        for (; hole > 0 && less(item, items[hole - 1]); --hole) items[hole] = items[hole - 1];
        items[hole] = item;
    }
}

// Splits items[0, count), count >= 3, at a median of three: returns p such that items[0, p) do not follow and items[p,
// count) do not precede the median, 0 < p < count.
template <class T, class Less> std::uint64_t split(T* items, std::uint64_t count, Less less) {
    T a = items[0], b = items[count / 2], c = items[count - 1];
    const T pivot = less(a, b) ? (less(b, c) ? b : less(a, c) ? c : a) : (less(a, c) ? a : less(b, c) ? c : b);
    std::uint64_t i = 0, j = count - 1;
    for (;;) {
        while (less(items[i], pivot)) ++i;
        while (less(pivot, items[j])) --j;
        if (i >= j) return i == 0 ? 1 : i;
        const T t = items[i];
        items[i++] = items[j];
        items[j--] = t;
    }
}

// What is told of the work when nobody is.
struct NoReports {
    void pass(std::uint32_t) const {}
    void step(std::uint64_t, std::uint32_t) const {}
};

// Sorts by the strict weak order `less`; equal items must be interchangeable. O(count log count), O(1) scratch.
// Reports: an Arena, in sorts that may be large.
template <class T, class Less, class Reports = NoReports>
void sort(T* items, std::uint64_t count, Less less, const Reports& reports = {}) {
    constexpr std::uint64_t split_in_pieces = 1 << 17;
    struct Range {
        T* items;
        std::size_t count;
        int splits_left;
    };
    // With k parts waiting at most count / 2^k items are left to split, and no fewer than 25 are split.
    constexpr int waiting_max = 8 * sizeof(std::size_t) - 4;
    Range waiting[waiting_max];
    int waiting_count = 0;
    int levels = 2;
    for (std::uint64_t n = count; n > 0; n >>= 1) levels += 2;
    Range now = {items, static_cast<std::size_t>(count), levels};
    for (;;) {
        if (now.count <= 24 || now.splits_left == 0) {
            if (now.count <= 24) {
                insertion_sort(now.items, now.count, less);
            } else {
                heap_sort(now.items, now.count, [&reports, less](const T& a, const T& b) {
                    reports.pass(1);
                    return less(a, b);
                });
            }
            if (waiting_count == 0) return;
            now = waiting[--waiting_count];
            continue;
        }
        std::uint64_t compared = 0;
        std::size_t p;
        if (now.count < split_in_pieces) {
            reports.pass(static_cast<std::uint32_t>(now.count / 16));
            p = static_cast<std::size_t>(split(now.items, now.count, less));
        } else {
            p = static_cast<std::size_t>(
                split(now.items, now.count, [&reports, &compared, less](const T& a, const T& b) {
                    reports.step(++compared, 20);
                    return less(a, b);
                }));
        }
        const Range first = {now.items, p, now.splits_left - 1};
        const Range second = {now.items + p, now.count - p, now.splits_left - 1};
        // The larger part waits.
        waiting[waiting_count++] = first.count < second.count ? second : first;
        now = first.count < second.count ? first : second;
    }
}

// Puts the item that belongs at items[nth] there, and those that precede it before it. Sorts where splitting does not
// get on. O(count) expected.
template <class T, class Less> void select(T* items, std::uint64_t count, std::uint64_t nth, Less less) {
    for (int splits_left = 68; count > 24; --splits_left) {
        if (splits_left == 0) return sort(items, count, less);
        const std::uint64_t p = split(items, count, less);
        if (nth < p) {
            count = p;
        } else {
            items += p;
            count -= p;
            nth -= p;
        }
    }
    insertion_sort(items, count, less);
}

// Sorts items that are alike in every bit when neither is less: no way of sorting shows in the result, and where
// size counts the smallest one will do.
template <class T, class Less, class Reports = NoReports>
void sort_alike(T* items, std::uint64_t count, Less less, const Reports& reports = {}) {
#ifdef __OPTIMIZE_SIZE__
    heap_sort(items, count, [&reports, less](const T& a, const T& b) {
        reports.step(0, 20);
        return less(a, b);
    });
#else
    sort(items, count, less, reports);
#endif
}

// Ascending, without branches.
template <int N, class T> void sort_small(T* items) {
    for (int end = N - 1; end > 0; --end) {
        for (int i = 0; i < end; ++i) {
            const T a = items[i], b = items[i + 1];
            items[i] = a < b ? a : b;
            items[i + 1] = a < b ? b : a;
        }
    }
}

}  // namespace netmesh
