#include "numerics/value_order.hpp"

#include "numerics/bits.hpp"
#include "numerics/radix_sort.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

#ifndef __OPTIMIZE_SIZE__
// A stretch of the array and the bit of its key at which the digit to sort by begins; the key is the value's 64 bits
// and, once these are equal, the position's 32.
struct Range {
    std::uint32_t begin, end;
};
constexpr std::uint32_t digits = 256;
constexpr int digit_bits = 8;
constexpr int depth_max = 14;  // 8 digits of the value and 4 of the position, one more each for an odd start
constexpr std::uint32_t short_range = 40, spare_max = 2048;
#endif

constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

// Orders like the values, negative ones included.
std::uint64_t key_of_value(double x) {
    const std::uint64_t b = bits_of(x);
    return (b & sign_bit) != 0 ? ~b : b | sign_bit;
}

#ifdef __OPTIMIZE_SIZE__

// The keys stand where the values were.
void sort_in_place(double* value, std::uint32_t* label, std::uint32_t count, const Arena& arena) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t key = key_of_value(value[i]);
        __builtin_memcpy(value + i, &key, sizeof key);
    }
    sort_keys(value, label, count, arena);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::uint64_t key;
        __builtin_memcpy(&key, value + i, sizeof key);
        value[i] = double_of_bits((key & sign_bit) != 0 ? key ^ sign_bit : ~key);
    }
}

#else

struct Items {
    double* value;
    std::uint32_t* position;

    bool before(std::uint32_t i, double v, std::uint32_t p) const {
        return value[i] != v ? value[i] < v : position[i] < p;
    }
    void swap(std::uint32_t i, std::uint32_t j) const {
        const double v = value[i];
        const std::uint32_t p = position[i];
        value[i] = value[j];
        position[i] = position[j];
        value[j] = v;
        position[j] = p;
    }
};

void sort_short(const Items& items, Range range) {
    for (std::uint32_t i = range.begin + 1; i < range.end; ++i) {
        const double v = items.value[i];
        const std::uint32_t p = items.position[i];
        std::uint32_t j = i;
        for (; j > range.begin && !items.before(j - 1, v, p); --j) {
            items.value[j] = items.value[j - 1];
            items.position[j] = items.position[j - 1];
        }
        items.value[j] = v;
        items.position[j] = p;
    }
}

// How to read a digit of an item.
struct Digit {
    bool of_position;
    int shift;
    std::uint32_t of(const Items& items, std::uint32_t i) const {
        const std::uint64_t key = of_position ? items.position[i] : key_of_value(items.value[i]);
        return static_cast<std::uint32_t>(key >> shift) & (digits - 1);
    }
};

// The highest digit in which the items of a range differ: value first, then position. Positions are distinct.
Digit leading_digit(const Items& items, Range range, const Arena& arena) {
    std::uint64_t differ = 0;
    std::uint32_t positions = 0;
    for (std::uint32_t i = range.begin + 1; i < range.end;)
        for (const std::uint64_t piece = arena.piece(i, range.end, 12); i < piece; ++i) {
            differ |= key_of_value(items.value[i]) ^ key_of_value(items.value[range.begin]);
            positions |= items.position[i] ^ items.position[range.begin];
        }
    const bool of_position = differ == 0;
    int top = 63;
    if (of_position) differ = positions;
    while (top >= digit_bits && (differ >> top) == 0) --top;
    return {of_position, top - digit_bits + 1 > 0 ? top - digit_bits + 1 : 0};
}

// Puts every item into the bucket of its digit; bucket d then ends at end[d]. spare: room for `spare_count` items.
void distribute(const Items& items, Range range, Digit digit, std::uint32_t* end, const Items& spare,
                std::uint32_t spare_count, const Arena& arena) {
    std::uint32_t next[digits];
    for (std::uint32_t d = 0; d < digits; ++d) end[d] = 0;
    for (std::uint32_t i = range.begin; i < range.end;)
        for (const std::uint64_t piece = arena.piece(i, range.end, 12); i < piece; ++i) {
            ++end[digit.of(items, i)];
        }
    std::uint32_t sum = range.begin;
    for (std::uint32_t d = 0; d < digits; ++d) {
        next[d] = sum;
        sum += end[d];
        end[d] = sum;
    }
    if (const std::uint32_t count = range.end - range.begin; count <= spare_count) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const std::uint32_t to = next[digit.of(items, i)]++ - range.begin;
            spare.value[to] = items.value[i];
            spare.position[to] = items.position[i];
        }
        __builtin_memcpy(items.value + range.begin, spare.value, sizeof(double) * count);
        __builtin_memcpy(items.position + range.begin, spare.position, sizeof(std::uint32_t) * count);
        arena.pass(count / 16);
        return;
    }
    for (std::uint32_t d = 0; d < digits; ++d) {
        while (next[d] < end[d]) {
            std::uint32_t left = digits;
            for (; left > 0 && next[d] < end[d]; --left) {
                const std::uint32_t home = digit.of(items, next[d]);
                if (home == d) {
                    ++next[d];
                } else {
                    items.swap(next[d], next[home]++);
                }
            }
            arena.pass((digits - left) / 5);
        }
    }
}

struct SortScratch {
    Range* stack = nullptr;
    std::uint32_t* end = nullptr;
    Items spare = {};
    std::uint32_t spare_count = 0;

    // The ranges that wait at any time are disjoint and longer than short_range.
    bool take(std::uint32_t count, Arena& arena) {
        const std::uint32_t most = count / short_range + 1;
        stack = arena.take_high<Range>(most < depth_max * digits ? most : depth_max * digits);
        end = arena.take_high<std::uint32_t>(digits);
        spare_count = count < many_values ? 0 : spare_max;
        spare = {arena.take_high<double>(spare_count), arena.take_high<std::uint32_t>(spare_count)};
        return stack != nullptr && end != nullptr && spare.value != nullptr && spare.position != nullptr;
    }
};

void sort_range(const Items& items, Range whole, const SortScratch& scratch, const Arena& arena) {
    Range* const stack = scratch.stack;
    std::uint32_t* const end = scratch.end;
    std::size_t height = 0;
    const auto sort_or_wait = [&](Range range) {
        if (range.end - range.begin > short_range) {
            stack[height++] = range;
        } else {
            sort_short(items, range);
            arena.pass((range.end - range.begin) / 8);
        }
    };
    if (whole.end > whole.begin) sort_or_wait(whole);
    while (height > 0) {
        const Range range = stack[--height];
        distribute(items, range, leading_digit(items, range, arena), end, scratch.spare, scratch.spare_count, arena);
        arena.pass(8);
        std::uint32_t begin = range.begin;
        for (std::uint32_t d = 0; d < digits; ++d) {
            if (end[d] - begin > 1) sort_or_wait({begin, end[d]});
            begin = end[d];
        }
    }
}

#endif

}  // namespace

bool sort_values(double* value, std::uint32_t* position, std::uint32_t count, Arena& arena) {
#ifdef __OPTIMIZE_SIZE__
    for (std::uint32_t i = 0; i < count; ++i) position[i] = i;
    return sort_labelled(value, position, count, arena);
#else
    const ArenaScope scope(arena);
    SortScratch scratch;
    if (!scratch.take(count, arena)) return false;
    arena.each(count, 1, [position](std::uint64_t i) { position[i] = static_cast<std::uint32_t>(i); });
    sort_range({value, position}, {0, count}, scratch, arena);
    return true;
#endif
}

#ifdef __OPTIMIZE_SIZE__
bool sort_labelled(double* value, std::uint32_t* label, std::uint32_t count, Arena& arena) {
    sort_in_place(value, label, count, arena);
    return true;
}
#else
bool sort_labelled(double* value, std::uint32_t* label, std::uint32_t count, Arena& arena) {
    const ArenaScope scope(arena);
    SortScratch scratch;
    if (!scratch.take(count, arena)) return false;
    sort_range({value, label}, {0, count}, scratch, arena);
    return true;
}

template <bool is_signed> bool ValueBuckets<is_signed>::take(const double* value, std::uint32_t count, Arena& arena) {
    end_ = arena.take_high<std::uint32_t>(buckets);
    if (end_ == nullptr) return false;
    for (std::uint32_t d = 0; d < buckets; ++d) end_[d] = 0;
    if constexpr (is_signed) {
        double most = -infinity;
        least_ = infinity;
        arena.each(count, 3, [&](std::uint64_t i) {
            least_ = value[i] < least_ ? value[i] : least_;
            most = value[i] > most && value[i] < infinity ? value[i] : most;
        });
        factor_ = most > least_ ? (buckets - 1) / (most - least_) : 0;
        // In the range of doubles, and with finite products but for infinite values; else all are in one bucket.
        if (!(factor_ > 0x1p-1000 && factor_ < 0x1p1000 && least_ > -infinity)) least_ = factor_ = 0;
        return true;
    }
    std::uint64_t differ = 0;
    arena.each(count, 3, [&](std::uint64_t i) { differ |= bits_of(value[i]) ^ bits_of(value[0]); });
    const int above = 64 - bits;  // where the first digit begins if all bits differ
    shift_ = differ == 0 ? above : static_cast<int>(highest_bit(differ)) + 1 - bits;
    if (shift_ < 0) shift_ = 0;
    return true;
}

template <bool is_signed> void ValueBuckets<is_signed>::begin_places() {
    std::uint32_t sum = 0;
    for (std::uint32_t d = 0; d < buckets; ++d) {
        const std::uint32_t size = end_[d];
        end_[d] = sum;
        sum += size;
    }
}

template <bool is_signed> bool ValueBuckets<is_signed>::sort(double* value, std::uint32_t* label, Arena& arena) const {
    const HighScope scope(arena);
    SortScratch scratch;
    if (!scratch.take(end_[buckets - 1], arena)) return false;
    for (std::uint32_t d = 0, begin = 0; d < buckets; begin = end_[d++])
        sort_range({value, label}, {begin, end_[d]}, scratch, arena);
    return true;
}

template class ValueBuckets<false>;
template class ValueBuckets<true>;
#endif

}  // namespace netmesh
