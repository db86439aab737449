#include "delaunay/spatial_order.hpp"

#include "numerics/radix_sort.hpp"
#include "numerics/random.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

#ifdef __OPTIMIZE_SIZE__
#define NETMESH_UNROLL
#else
#define NETMESH_UNROLL _Pragma("GCC unroll 6")  // so that coordinates are in registers
#endif

namespace netmesh {
namespace {

// How the plane's curve runs in a square: with exchanged axes, and with both reflected.
struct PlanarState {
    unsigned exchange = 0, reflect = 0;

    // Position of quarter (x, y) of the square along the curve; goes on with that quarter.
    constexpr unsigned step(unsigned x, unsigned y) {
        x ^= reflect;
        y ^= reflect;
        const unsigned t = (x ^ y) & exchange;
        x ^= t;
        y ^= t;
        exchange ^= y ^ 1;
        reflect ^= x & (y ^ 1);
        return x << 1 | (x ^ y);
    }
};

#ifndef __OPTIMIZE_SIZE__
// Three levels of the plane's curve at once. state: bit 1 exchanges the axes, bit 0 reflects both. step[64 * state +
// six interleaved bits, x first] is 4 * (their position along the curve) + the next state.
struct PlanarCurve {
    std::uint8_t step[256];
    constexpr PlanarCurve() : step{} {
        for (unsigned start = 0; start < 4; ++start)
            for (unsigned bits = 0; bits < 64; ++bits) {
                PlanarState state{start >> 1, start & 1};
                unsigned position = 0;
                for (int level = 4; level >= 0; level -= 2)
                    position = position << 2 | state.step(bits >> (level + 1) & 1, bits >> level & 1);
                step[start << 6 | bits] =
                    static_cast<std::uint8_t>(position << 2 | state.exchange << 1 | state.reflect);
            }
    }
};
constexpr PlanarCurve planar_curve;

// Bit k of x goes to bit 2 k.
inline std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 16) & 0x0000FFFF0000FFFFu;
    x = (x | x << 8) & 0x00FF00FF00FF00FFu;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Fu;
    x = (x | x << 2) & 0x3333333333333333u;
    return (x | x << 1) & 0x5555555555555555u;
}
#endif

template <int D> struct Curve {
    const DimensionOf<D> dim;

    int bits_max() const { return dim > 2 ? static_cast<int>(60 / dim) : 30; }

    // Bits a coordinate for `count` points: a few more than would tell evenly spread points apart.
    int bits_for(std::size_t count) const {
        int bits = 3;
        for (std::size_t left = count; left > 1; left >>= dim) ++bits;
        if (dim == 2) bits -= bits % 3;
        return bits < bits_max() ? bits : bits_max();
    }

    // Position along the Hilbert curve of the grid point x, each x[i] < 2^bits.
    std::uint64_t position(const std::uint32_t* x, int bits) const {
        if constexpr (D == 2)
            return planar_position(x, bits);
        else
            return D == any_dimension && dim == 2 ? planar_position(x, bits) : general_position(x, bits);
    }

private:
    // In any dimension (J. Skilling, Programming the Hilbert curve, 2004): undo the rotations bit plane by bit plane,
    // then Gray decode and interleave.
    std::uint64_t general_position(const std::uint32_t* point, int bits) const {
        const std::uint32_t axes = dim;  // what a loop that is unrolled can be bounded by
        std::uint32_t x[DimensionOf<D>::most];
        for (std::uint32_t i = 0; i < axes; ++i) x[i] = point[i];
        for (std::uint32_t q = std::uint32_t{1} << (bits - 1); q > 1; q >>= 1) {
            const std::uint32_t p = q - 1;
            NETMESH_UNROLL
            for (std::uint32_t i = 0; i < axes; ++i) {
                const std::uint32_t on = 0u - static_cast<std::uint32_t>((x[i] & q) != 0);
                const std::uint32_t t = (x[0] ^ x[i]) & p & ~on;
                x[0] ^= t | (p & on);
                x[i] ^= t;
            }
        }
        for (std::uint32_t i = 1; i < axes; ++i) x[i] ^= x[i - 1];
        std::uint32_t t = x[axes - 1] >> 1;  // bit by bit the parity of the bits above
        for (int shift = 1; shift < bits_max(); shift *= 2) t ^= t >> shift;
        std::uint64_t key = 0;
        for (std::uint32_t i = 0; i < axes; ++i) x[i] ^= t;
        for (int b = bits - 1; b >= 0; --b) NETMESH_UNROLL
        for (std::uint32_t i = 0; i < axes; ++i) key = (key << 1) | ((x[i] >> b) & 1u);
        return key;
    }
    static std::uint64_t planar_position(const std::uint32_t* x, int bits) {
        std::uint64_t key = 0;
#ifdef __OPTIMIZE_SIZE__
        PlanarState state;
        for (int level = bits - 1; level >= 0; --level)
            key = key << 2 | state.step(x[0] >> level & 1, x[1] >> level & 1);
#else
        const std::uint64_t both = spread(x[0]) << 1 | spread(x[1]);
        unsigned state = 0;
        for (int shift = 2 * bits - 6; shift >= 0; shift -= 6) {
            const unsigned step = planar_curve.step[state << 6 | (both >> shift & 63u)];
            key = key << 6 | step >> 2;
            state = step & 3u;
        }
#endif
        return key;
    }
};

// Positions take the bits below, rounds those from there on.
constexpr int round_shift = 60;
constexpr std::uint64_t new_run = std::uint64_t{1} << round_shift;

template <int D> struct Sorter {
    const DimensionOf<D> dim;
    const Arena& arena;
    const unsigned char* coordinates;
    std::ptrdiff_t stride;
    std::uint64_t* keys;
    std::uint32_t* order;
#ifndef __OPTIMIZE_SIZE__
    std::uint64_t* spare_keys;
    std::uint32_t* spare_items;
#endif

    bool has_tables() const {
#ifndef __OPTIMIZE_SIZE__
        if (spare_keys == nullptr || spare_items == nullptr) return false;
#endif
        return keys != nullptr;
    }
    const double* point(std::uint32_t i) const {
        return reinterpret_cast<const double*>(coordinates + static_cast<std::ptrdiff_t>(i) * stride);
    }
    bool same(std::uint32_t a, std::uint32_t b) const {
        for (std::uint32_t i = 0; i < dim; ++i)
            if (point(a)[i] != point(b)[i]) return false;
        return true;
    }
    std::uint64_t hash(std::uint32_t i) const {
        std::uint64_t h = 0;
        for (std::uint32_t k = 0; k < dim; ++k) h = mix64(h ^ bits_of(point(i)[k]));
        return h;
    }

    // Keys of order[begin, end) on a grid that covers just these points; differences are taken in halves, as the range
    // of finite doubles does not fit a double.
    void key_range(std::size_t begin, std::size_t end) {
        double low[DimensionOf<D>::most], high[DimensionOf<D>::most], scale[DimensionOf<D>::most];
        for (std::uint32_t k = 0; k < dim; ++k) low[k] = high[k] = point(order[begin])[k];
        for (std::size_t i = begin; i < end; ++i) {
            arena.step(i, 9 * dim);  // not in pieces, as ranges are short but for the first one
            const double* const x = point(order[i]);
            for (std::uint32_t k = 0; k < dim; ++k) {
                low[k] = x[k] < low[k] ? x[k] : low[k];
                high[k] = x[k] > high[k] ? x[k] : high[k];
            }
        }
        for (std::uint32_t k = 0; k < dim; ++k) {
            low[k] *= 0.5;
            scale[k] = high[k] * 0.5 - low[k];
        }
        double widest = 0;
        for (std::uint32_t k = 0; k < dim; ++k)
            if (scale[k] > widest) widest = scale[k];
        const Curve<D> curve = {dim};
        const int bits = curve.bits_for(end - begin);
        const double cells = static_cast<double>((std::uint32_t{1} << bits) - 1);
        for (std::size_t i = begin; i < end; ++i) {
            arena.step(i, 120 * dim);
            const double* x = point(order[i]);
            std::uint32_t g[DimensionOf<D>::most];
            for (std::uint32_t k = 0; k < dim; ++k)
                g[k] = widest > 0 ? static_cast<std::uint32_t>((x[k] * 0.5 - low[k]) / widest * cells) : 0;
            keys[i] = curve.position(g, bits);
        }
    }
    void sort_range(std::size_t begin, std::size_t end) {
#ifdef __OPTIMIZE_SIZE__
        sort_keys(keys + begin, order + begin, end - begin, arena);  // items of equal keys ascend
#else
        radix_sort(keys + begin, order + begin, spare_keys, spare_items, end - begin, arena);
#endif
    }
    bool split_equal_keys(std::size_t count);
};

// Every run of equal keys that holds different points is keyed again on its own bounding box until none is left. The
// two ends of the widest axis get different keys, so each pass splits the run. Runs only ever split, so there are less
// passes than points: new keys differ from that of the run behind them by a bit that they have not themselves. Below
// half the smallest normal number halves round, and such points are told apart by insertion on their coordinates. True
// when there may be equal points.
template <int D> bool Sorter<D>::split_equal_keys(std::size_t count) {
    bool repeats = false;
    std::size_t begin = 0;
    while (begin < count) {
        arena.step(begin, 20);
        std::size_t end = begin + 1;
        bool mixed = false;
        for (; end < count && keys[end] == keys[begin]; ++end) {
            arena.step(end, 20);
            mixed |= !same(order[begin], order[end]);
        }
        if (!mixed) {
            repeats |= end - begin > 1;
            begin = end;
            continue;
        }
        key_range(begin, end);
        sort_range(begin, end);
        if (keys[begin] != keys[end - 1]) {
            const std::uint64_t mark = end < count ? ~keys[end] & new_run : 0;
            for (std::size_t i = begin; i < end; ++i) keys[i] |= mark;
            continue;
        }
        for (std::size_t i = begin + 1; i < end; ++i) {
            const std::uint32_t item = order[i];
            const double* x = point(item);
            std::size_t j = i;
            for (; j > begin; --j) {
                arena.step(j, 15);
                const double* y = point(order[j - 1]);
                std::uint32_t k = 0;
                while (k < dim - 1 && x[k] == y[k]) ++k;
                if (!(x[k] < y[k])) break;
                order[j] = order[j - 1];
            }
            order[j] = item;
        }
        repeats = true;
        begin = end;
    }
    return repeats;
}

template <int D>
Status order_of(DimensionOf<D> dim, const unsigned char* coordinates, std::ptrdiff_t stride_bytes, std::uint32_t count,
                std::uint64_t seed, Arena& arena, std::uint32_t* order, bool* repeats, bool in_rounds) {
    *repeats = false;
    if (count == 0) return Status::ok;
    ArenaScope scope(arena);
    Sorter<D> s = {dim,
                   arena,
                   coordinates,
                   stride_bytes,
                   arena.take_low<std::uint64_t>(count),
                   order,
#ifndef __OPTIMIZE_SIZE__
                   arena.take_low<std::uint64_t>(count),
                   arena.take_low<std::uint32_t>(count)
#endif
    };
    if (!s.has_tables()) return Status::out_of_memory;

    arena.each(count, 1, [order](std::uint64_t i) { order[i] = static_cast<std::uint32_t>(i); });
    s.key_range(0, count);
    // A point is in the last round with probability 3/4, else in the one before with 3/4, and so on; equal points
    // fall into the same round. Small sets need few rounds.
    std::uint32_t rounds_max = 0;
    for (std::uint32_t left = in_rounds ? count : 0; left > 64 && rounds_max < 15; left /= 4) ++rounds_max;
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 20 + 10 * dim); i < piece; ++i) {
            std::uint64_t h = mix64(s.hash(i) ^ seed);
            std::uint32_t round = rounds_max;
            for (; round > 0 && (h & 3u) == 0; h >>= 2) --round;
            s.keys[i] |= static_cast<std::uint64_t>(round) << round_shift;
        }
    s.sort_range(0, count);
    *repeats = s.split_equal_keys(count);
    return Status::ok;
}

}  // namespace

template <int D>
Status spatial_order(const unsigned char* coordinates, std::ptrdiff_t stride_bytes, std::uint32_t count,
                     std::uint64_t seed, Arena& arena, std::uint32_t* order, bool* repeats, bool in_rounds) {
    return order_of<shared_dimension<D>>(D, coordinates, stride_bytes, count, seed, arena, order, repeats, in_rounds);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status spatial_order<D>(const unsigned char*, std::ptrdiff_t, std::uint32_t, std::uint64_t, Arena&,       \
                                     std::uint32_t*, bool*, bool);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE
#undef NETMESH_UNROLL

}  // namespace netmesh
