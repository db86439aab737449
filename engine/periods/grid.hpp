// Where copies are no doubles, points and vectors are moved first, to multiples of a power of two for each coordinate:
// 2^-53 of what copies reach, so that each copy has at most 53 bits. Vectors are those of the reduced basis, found in
// 106 bits, so that a skew basis costs no digits; a point is first taken near the origin, in as many. Where points
// stand at halves, quarters or eighths of vectors, these are moved to multiples of 8 units, with thirds, sixths, .. of
// 24, and all points with them as if the space were stretched: so they stay where they are, and symmetries of a crystal
// stay ties.
#pragma once
#include <cstdint>

#include "numerics/double_double.hpp"
#include "numerics/vector.hpp"
#include "periods/lattice.hpp"

namespace netmesh {

// So many periods away a point may be, in each direction.
constexpr double periods_most = 0x1p50;

inline std::int64_t floor_of(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return static_cast<double>(whole) > x ? whole - 1 : whole;
}

inline void note_moved(double difference, double* most) {
    if (absolute(difference) > *most) *most = absolute(difference);
}

// The place is [-place_edge, 1 - place_edge) in each direction.
constexpr double place_edge = 0x1p-20;

// A point near the origin, before anything is moved: in about 106 bits.
template <int D> struct NearPoint {
    double high[D], low[D];

    // False: too far away. gone, if any: how many of each vector were subtracted.
    bool take(const Lattice& lattice, const double* p, double* gone = nullptr) {
        for (int k = 0; k < D; ++k) {
            high[k] = p[k];
            low[k] = 0;
        }
        for (int j = 0; gone != nullptr && j < lattice.count; ++j) gone[j] = 0;
        // Again, as numbers are large in the beginning.
        bool has_gone = true;
        for (int turn = 0; turn < 4 && has_gone; ++turn) {
            has_gone = false;
            for (int j = lattice.count - 1; j >= 0; --j) {
                const double place = lattice.place(j, high) + place_edge;
                if (!(absolute(place) < periods_most)) return false;
                const double times = static_cast<double>(floor_of(place));
                if (times == 0) continue;
                has_gone = true;
                lattice.subtract(times, j, high, low);
                if (gone != nullptr) gone[j] += times;
            }
        }
        return true;
    }
};

inline bool is_multiple(double high, double low, double quantum) {
    return quantum == 0 || (low == 0 && quantum_of(high) >= exponent_of(quantum));
}

// Moves points into one place.
template <int D> class Grid {
public:
    // far_beside[k]: how far points reach in coordinate k beside the lattice. coarser: by so many bits than is thought
    // to do.
    void open(const Lattice& given, const double* far_beside, int coarser) {
        given_ = given;
        for (int k = 0; k < D; ++k) {
            const double reach = reach_of(given, far_beside, k);
            quantum_[k] = reach > 0 ? power_of_two(exponent_of(reach) + 1 - 53 + coarser) : 0;
        }
    }
    // Whether nothing of them need be moved.
    bool has_vectors() const {
        bool all = true;
        for (int j = 0; j < given_.count; ++j)
            for (int k = 0; k < D; ++k) all &= is_multiple(given_.b[j][k], given_.rest[j][k], quantum_[k]);
        return all;
    }
    bool has(const NearPoint<D>& point) const {
        bool all = true;
        for (int k = 0; k < D; ++k) all &= is_multiple(point.high[k], point.low[k], quantum_[k]);
        return all;
    }
    // The lattice from here on, its vectors moved or not: to multiples of so many units, parts. False: it is none any
    // more.
    bool settle(bool moves, double parts, Lattice* lattice, double* moved_by) {
        *lattice = given_;
        for (int j = 0; j < given_.count; ++j)
            for (int k = 0; k < D; ++k) {
                const double x = given_.b[j][k], unit = parts * quantum_[k];
                double& to = lattice->b[j][k];
                lattice->rest[j][k] = 0;
                if (moves && quantum_[k] != 0) to = nearest_integer(x / unit) * unit;
                stretch_[j][k] = (to - x) - given_.rest[j][k];
                note_moved(stretch_[j][k], moved_by);
            }
        moves_ = moves;
        if (!lattice->orthogonalise()) return false;
        lattice_ = *lattice;
        for (int j = 0; j < lattice->count; ++j)
            for (int k = 0; k < D; ++k)
                multiple_[j][k] = quantum_[k] == 0 ? 0 : static_cast<std::int64_t>(lattice->b[j][k] / quantum_[k]);
        return true;
    }
    // Whether copies are doubles indeed.
    bool fits(const double* far_beside) const {
        bool does = true;
        for (int k = 0; k < D; ++k)
            does &= quantum_[k] == 0 || reach_of(lattice_, far_beside, k) <= 0x1p53 * quantum_[k];
        return does;
    }

    // The copy of a point that stands for it: the same for all copies.
    void place(NearPoint<D> point, double* x, double* moved_by) const {
        const NearPoint<D> was = point;
        std::int64_t n[D];
        if (moves_) stretch(&point);
        for (int k = 0; k < D; ++k) {
            n[k] = 0;
            x[k] = point.high[k];
            const double q = quantum_[k];
            if (q == 0) continue;
            double times = nearest_integer(point.high[k] / q);
            const double left = (point.high[k] - times * q) + point.low[k];
            times += left > 0.5 * q ? 1 : left < -0.5 * q ? -1 : 0;
            n[k] = static_cast<std::int64_t>(times);
            x[k] = times * q;
            note_moved((x[k] - was.high[k]) - was.low[k], moved_by);
        }
        if (is_near_edge(x)) choose(n, x);
    }

private:
    // Edges of the place go to and fro with roundings. So of a point near an edge all copies are looked at that are in
    // a place larger by 2^-40, which depends on the copies alone, and the least is taken.
    static constexpr double slack = 0x1p-40;

    // How far copies reach in coordinate k, those within a margin, and one vector more. 0: no vector has it, and it is
    // left as it is.
    double reach_of(const Lattice& reduced, const double* far_beside, int k) const {
        double far[Lattice::most], longest = 0, reach = far_beside[k];
        reduced.find_far(far);
        for (int j = 0; j < given_.count; ++j) {
            const double one = absolute(reduced.b[j][k]);
            longest = one > longest ? one : longest;
            reach += 1.01 * (reduced.h[j] + far[j]) * absolute(reduced.e[j][k]);
        }
        return longest == 0 ? 0 : reach + longest;
    }
    void stretch(NearPoint<D>* point) const {
        double part[Lattice::most];
        given_.split(point->high, part);
        for (int j = 0; j < given_.count; ++j)
            for (int k = 0; k < D; ++k) {
                const DoubleDouble sum =
                    DoubleDouble{point->high[k], point->low[k]} + DoubleDouble{part[j] * stretch_[j][k], 0};
                point->high[k] = sum.high;
                point->low[k] = sum.low;
            }
    }
    void add(int j, std::int64_t times, std::int64_t* n, double* x) const {
        if (times == 0) return;
        for (int k = 0; k < D; ++k) {
            if (quantum_[k] == 0) continue;
            // Sums are small, whatever is on the way.
            n[k] = static_cast<std::int64_t>(static_cast<std::uint64_t>(n[k]) +
                                             static_cast<std::uint64_t>(times) *
                                                 static_cast<std::uint64_t>(multiple_[j][k]));
            x[k] = static_cast<double>(n[k]) * quantum_[k];
        }
    }
    bool is_near_edge(const double* x) const {
        for (int j = 0; j < lattice_.count; ++j) {
            const double t = lattice_.place(j, x) + place_edge;
            if (!(t > 0.5 * place_edge && t < 1 - 0.5 * place_edge)) return true;
        }
        return false;
    }
    bool is_in_place(const double* x) const {
        for (int j = 0; j < lattice_.count; ++j) {
            const double t = lattice_.place(j, x) + place_edge;
            if (!(t >= -slack && t < 1 + slack)) return false;
        }
        return true;
    }
    void choose(const std::int64_t* n, double* x) const {
        int all = 1;
        for (int j = 0; j < lattice_.count; ++j) all *= 3;
        double best[D];
        copy<D>(x, best);
        bool is_found = false;
        for (int i = 0; i < all; ++i) {
            std::int64_t m[D];
            double y[D];
            for (int k = 0; k < D; ++k) m[k] = n[k];
            copy<D>(x, y);
            for (int j = 0, rest = i; j < lattice_.count; ++j, rest /= 3) add(j, rest % 3 - 1, m, y);
            if (!is_in_place(y) || (is_found && !is_before(y, best))) continue;
            copy<D>(y, best);
            is_found = true;
        }
        copy<D>(best, x);
    }
    static bool is_before(const double* a, const double* b) {
        for (int k = 0; k < D; ++k)
            if (a[k] != b[k]) return a[k] < b[k];
        return false;
    }

    Lattice given_, lattice_;
    double quantum_[D];
    double stretch_[Lattice::most][D];  // what was added to vectors
    std::int64_t multiple_[Lattice::most][D];
    bool moves_ = false;
};

}  // namespace netmesh
