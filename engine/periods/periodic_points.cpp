// Where copies are no doubles, points and vectors are moved first, to multiples of a power of two for each coordinate:
// 2^-53 of what copies reach, so that each copy has at most 53 bits. Vectors are those of the reduced basis, found in
// 106 bits, so that a skew basis costs no digits; a point is first taken near the origin, in as many. Where points
// stand at halves, quarters or eighths of vectors, these are moved to multiples of 8 units, with thirds, sixths, .. of
// 24, and all points with them as if the space were stretched: so they stay where they are, and symmetries of a crystal
// stay ties.
#include "periods/periodic_points.hpp"

#include "delaunay/spatial_order.hpp"
#include "numerics/double_double.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/sort.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Squares of lengths are far from the ends of the range of doubles.
constexpr double length_most = 0x1p300, length_least = 0x1p-300;
// So many periods away a point may be, in each direction.
constexpr double periods_most = 0x1p50;
// What is moved farther than this part of the least distance of layers is no lattice any more.
constexpr double moved_most = 0x1p-20;

std::int64_t floor_of(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return static_cast<double>(whole) > x ? whole - 1 : whole;
}

void note_moved(double difference, double* most) {
    if (absolute(difference) > *most) *most = absolute(difference);
}

// The place is [-edge, 1 - edge) in each direction.
constexpr double edge = 0x1p-20;

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
                const double place = lattice.place(j, high) + edge;
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

bool is_multiple(double high, double low, double quantum) {
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
            const double t = lattice_.place(j, x) + edge;
            if (!(t > 0.5 * edge && t < 1 - 0.5 * edge)) return true;
        }
        return false;
    }
    bool is_in_place(const double* x) const {
        for (int j = 0; j < lattice_.count; ++j) {
            const double t = lattice_.place(j, x) + edge;
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

template <int D> class Taking {
public:
    Taking(const PeriodicInput& input, const Work& work, PeriodicPoints* out, PeriodicReport* report)
        : input_(input), arena_(work.arena), monitor_(work.monitor), out_(*out), report_(*report) {}

    Status run() {
        if (input_.count == 0 || input_.count > std::size_t{1} << 28) return Status::invalid_argument;
        monitor_.begin(NETMESH_STAGE_SORT, input_.count);
        Status status = take_lattice();
        if (status == Status::ok) status = place_all();
        if (status == Status::ok) status = sort_all();
        return status == Status::ok && arena_.has_stopped() ? Status::cancelled : status;
    }

private:
    static constexpr int numbers = D + 1;

    Status take_lattice() {
        const double* const vectors = input_.vectors;
        for (int j = 0; j < input_.vector_count; ++j) {
            double most = 0;
            for (int k = 0; k < D; ++k) {
                const double x = absolute(vectors[j * D + k]);
                report_.culprit = j;
                report_.has_bad_lattice = !is_finite(x);
                if (report_.has_bad_lattice) return Status::invalid_argument;
                most = x > most ? x : most;
            }
            if (most != 0 && !(most > length_least && most < length_most)) return Status::out_of_range;
        }
        report_.has_bad_lattice = !out_.lattice.open(vectors, input_.vector_count, D, &report_.culprit);
        return report_.has_bad_lattice ? Status::invalid_argument : Status::ok;
    }
    // How far points reach beside the lattice, and the fingerprint of what was given.
    Status look_through() {
        const Lattice& lattice = out_.lattice;
        Fingerprint fingerprint;
        fingerprint.add(std::uint64_t{D});
        fingerprint.add(static_cast<std::uint64_t>(lattice.count));
        for (int i = 0; i < lattice.count * D; ++i) fingerprint.add(input_.vectors[i]);
        if (input_.weights != nullptr) fingerprint.add(std::uint64_t{1} + input_.weights->are_radii);
        for (std::size_t i = 0; i < input_.count; ++i) {
            arena_.step(i, 60 * D);
            double x[D];
            report_.input.row_a = i;
            if (!input_.points.read(i, D, x)) return Status::not_finite;
            for (const double c : x) fingerprint.add(c);
            if (input_.weights != nullptr) {
                double number;
                report_.has_weight = !input_.weights->rows.read(i, 1, &number);
                if (report_.has_weight) return Status::not_finite;
                report_.has_negative = input_.weights->are_radii && number < 0;
                if (report_.has_negative) return Status::invalid_argument;
                fingerprint.add(number);
            }
            if (!near_[i].take(lattice, x)) return Status::out_of_range;
            if (lattice.count < D) measure_beside(i, near_[i].high);
        }
        report_.input.rows = input_.count;
        report_.input.fingerprint = fingerprint.value();
        return Status::ok;
    }
    void measure_beside(std::size_t row, const double* x) {
        double rest[D];
        copy<D>(x, rest);
        for (int j = 0; j < out_.lattice.count; ++j) {
            const double along = dot<D>(out_.lattice.e[j], x);
            for (int k = 0; k < D; ++k) rest[k] -= along * out_.lattice.e[j][k];
        }
        for (int k = 0; k < D; ++k) {
            if (!(absolute(rest[k]) > beside_[k])) continue;
            beside_[k] = absolute(rest[k]);
            farthest_ = row;
        }
    }
    // Into how many parts of vectors points fall: 24, 8, or 1 where they stand anywhere.
    double parts_of_vectors() const {
        double parts = 1;
        for (std::size_t i = 0; i < input_.count && parts < 24; ++i) {
            arena_.step(i, 12 * D);
            double part[Lattice::most];
            out_.lattice.split(near_[i].high, part);
            for (int j = 0; j < out_.lattice.count; ++j) {
                const auto is_whole = [&](double times) __attribute__((always_inline)) {
                    return absolute(times * part[j] - nearest_integer(times * part[j])) < 0x1p-44;
                };
                if (!is_whole(24) || is_whole(1)) continue;
                parts = is_whole(8) && parts < 24 ? 8 : 24;
            }
        }
        return parts;
    }
    // A unit, and vectors that are multiples of it.
    Status settle_grid(Lattice* moved) {
        double parts = 0;
        for (int coarser = 0; coarser < 16; ++coarser) {
            report_.moved = 0;
            grid_.open(out_.lattice, beside_, coarser);
            bool moves = !grid_.has_vectors();
            for (std::size_t i = 0; i < input_.count && !moves; ++i) {
                arena_.step(i, 4 * D);
                moves = !grid_.has(near_[i]);
            }
            if (moves && parts == 0) parts = parts_of_vectors();
            if (!grid_.settle(moves, parts, moved, &report_.moved)) break;
            if (grid_.fits(beside_)) return Status::ok;
        }
        report_.input.row_a = farthest_;
        return Status::out_of_range;
    }
    Status place_all() {
        const HighScope scope(arena_);
        near_ = arena_.take_high<NearPoint<D>>(input_.count);
        if (near_ == nullptr) return Status::out_of_memory;
        Status status = look_through();
        Lattice moved;
        if (status == Status::ok) status = settle_grid(&moved);
        if (status != Status::ok) return status;
        out_.count = static_cast<std::uint32_t>(input_.count);
        out_.x = arena_.take_low<double>(input_.count * numbers);
        out_.row = arena_.take_low<std::uint32_t>(input_.count);
        if (out_.x == nullptr || out_.row == nullptr) return Status::out_of_memory;
        for (std::uint32_t i = 0; i < out_.count; ++i) {
            arena_.step(i, 20 * D);
            double* const x = out_.x + std::size_t{i} * numbers;
            x[D] = 0;
            if (input_.weights != nullptr) input_.weights->rows.read(i, 1, x + D);
            grid_.place(near_[i], x, &report_.moved);
            for (int k = 0; k < D; ++k) x[k] += 0.0;
            out_.row[i] = i;
        }
        out_.lattice = moved;
        moved.find_far(out_.far);
        double least = infinity;
        for (int j = 0; j < moved.count; ++j) least = moved.h[j] < least ? moved.h[j] : least;
        report_.input.row_a = farthest_;
        if (!(report_.moved <= moved_most * least)) return Status::out_of_range;
        report_.input.row_a = 0;
        return Status::ok;
    }
    // Along a curve; of equal points the first of those with the largest weight stays.
    Status sort_all() {
        const HighScope scope(arena_);
        std::uint32_t* const order = arena_.take_high<std::uint32_t>(out_.count);
        if (order == nullptr) return Status::out_of_memory;
        bool repeats;
        const Status status = spatial_order<D>(reinterpret_cast<const unsigned char*>(out_.x),
                                               static_cast<std::ptrdiff_t>(sizeof(double) * numbers), out_.count, 0,
                                               arena_, order, &repeats, false);
        if (status != Status::ok) return status;
        double* const sorted = arena_.take_high<double>(std::size_t{out_.count} * numbers);
        if (sorted == nullptr) return Status::out_of_memory;
        std::uint32_t kept = 0;
        arena_.each(out_.count, 20 * D, [&](std::uint64_t i) {
            const double* const x = out_.x + std::size_t{order[i]} * numbers;
            double* const last = sorted + std::size_t{kept} * numbers - numbers;
            bool is_equal = kept > 0;
            for (int k = 0; k < D && is_equal; ++k) is_equal = x[k] == last[k];
            if (is_equal && !(x[D] > last[D])) return;
            copy<numbers>(x, is_equal ? last : last + numbers);
            if (!is_equal) ++kept;
            order[kept - 1] = order[i];
        });
        for (int j = 0; j < out_.lattice.count; ++j) {
            out_.low[j] = infinity;
            out_.high[j] = -infinity;
        }
        arena_.each(kept, 20 * D, [&](std::uint64_t i) {
            const double* const x = sorted + i * numbers;
            copy<numbers>(x, out_.x + i * numbers);
            out_.row[i] = order[i];
            for (int j = 0; j < out_.lattice.count; ++j) {
                const double y = dot<D>(out_.lattice.e[j], x);
                out_.low[j] = y < out_.low[j] ? y : out_.low[j];
                out_.high[j] = y > out_.high[j] ? y : out_.high[j];
            }
        });
        report_.input.duplicates = out_.count - kept;
        out_.count = kept;
        return Status::ok;
    }

    const PeriodicInput& input_;
    Arena& arena_;
    Monitor& monitor_;
    PeriodicPoints& out_;
    PeriodicReport& report_;
    Grid<D> grid_;
    NearPoint<D>* near_ = nullptr;  // [rows]
    double beside_[D] = {};
    std::size_t farthest_ = 0;  // a row
};

// Calls visit(times, v) for each translation, sum of times[j] b[j] = v, that takes the box of the points to where it
// meets the box with its margin; not for 0. False as soon as visit says so.
template <int D, class Visit> bool each_translation(const PeriodicPoints& points, const double* margin, Visit&& visit) {
    const Lattice& lattice = points.lattice;
    int most[Lattice::most], times[Lattice::most];
    for (int j = lattice.count - 1; j >= 0; --j) {
        double reach = (margin[j] + points.high[j] - points.low[j]) * (1 + 0x1p-20) / lattice.h[j];
        for (int i = j + 1; i < lattice.count; ++i) reach += absolute(lattice.place(j, lattice.b[i])) * most[i];
        if (!(reach < 500)) return false;
        most[j] = static_cast<int>(reach) + 1;
        times[j] = -most[j];
    }
    for (;;) {
        double v[D] = {};
        bool meets = true, is_zero = true;
        for (int j = 0; j < lattice.count; ++j) {
            is_zero &= times[j] == 0;
            for (int k = 0; k < D; ++k) v[k] += times[j] * lattice.b[j][k];
        }
        for (int j = 0; j < lattice.count; ++j)
            meets &= absolute(dot<D>(lattice.e[j], v)) <= (points.high[j] - points.low[j] + margin[j]) * (1 + 0x1p-20);
        if (meets && !is_zero && !visit(times, v)) return false;
        int j = 0;
        while (j < lattice.count && times[j] == most[j]) {
            times[j] = -most[j];
            ++j;
        }
        if (j == lattice.count) return true;
        ++times[j];
    }
}

}  // namespace

template <int D>
Status take_periodic_points(const PeriodicInput& input, const Work& work, PeriodicPoints* out, PeriodicReport* report) {
    *report = PeriodicReport{};
    return Taking<D>(input, work, out, report).run();
}

template <int D> Status make_copies(const PeriodicPoints& points, const double* margin, const Work& work, Copies* out) {
    constexpr int numbers = D + 1;
    const Lattice& lattice = points.lattice;
    Arena& arena = work.arena;
    // Points that have a copy near enough: of a translation the last part that is not 0 takes them at least a layer
    // along, and the others not at all.
    const HighScope scope(arena);
    std::uint32_t* const outer = arena.take_high<std::uint32_t>(points.count);
    if (outer == nullptr) return Status::out_of_memory;
    std::uint32_t outers = 0;
    arena.each(points.count, 4 * D, [&](std::uint64_t i) {
        outer[outers] = static_cast<std::uint32_t>(i);
        bool is_outer = false;
        for (int j = 0; j < lattice.count; ++j) {
            const double y = dot<D>(lattice.e[j], points.x + i * numbers), more = margin[j] * (1 + 0x1p-19);
            const double layer = lattice.h[j] * (1 - 0x1p-20);
            is_outer |= y + layer <= points.high[j] + more || y - layer >= points.low[j] - more;
        }
        outers += is_outer;
    });
    // Calls act(i, place, times) for each copy, of point i.
    const auto each_copy = [&](auto&& act) {
        return each_translation<D>(points, margin, [&](const int* times, const double* v) {
            double low[Lattice::most], high[Lattice::most];
            for (int j = 0; j < lattice.count; ++j) {
                const double along = dot<D>(lattice.e[j], v), more = margin[j] * (1 + 0x1p-20);
                low[j] = points.low[j] - more - along;
                high[j] = points.high[j] + more - along;
            }
            arena.each(outers, 12 * static_cast<std::uint32_t>(lattice.count), [&](std::uint64_t at) {
                const std::uint32_t i = outer[at];
                const double* const x = points.x + std::size_t{i} * numbers;
                for (int j = 0; j < lattice.count; ++j) {
                    const double y = dot<D>(lattice.e[j], x);
                    if (!(y >= low[j] && y <= high[j])) return;
                }
                act(i, v, times);
            });
            return !arena.has_stopped();
        });
    };
    std::uint64_t copies = 0;
    if (!each_copy([&](std::uint32_t, const double*, const int*) { ++copies; }))
        return arena.has_stopped() ? Status::cancelled : Status::out_of_range;
    const std::uint64_t count = copies + points.count;
    if (count > std::uint64_t{1} << 28) return Status::out_of_memory;
    out->count = static_cast<std::uint32_t>(count);
    out->x = arena.take_low<double>(static_cast<std::size_t>(count) * numbers);
    out->index = arena.take_low<std::uint32_t>(static_cast<std::size_t>(count));
    out->own = arena.take_low<std::uint32_t>(static_cast<std::size_t>(copies));
    out->shift = arena.take_low<std::int64_t>(static_cast<std::size_t>(copies));
    if (out->x == nullptr || out->index == nullptr || out->own == nullptr || out->shift == nullptr)
        return Status::out_of_memory;
    move_bytes(out->x, points.x, sizeof(double) * numbers * points.count, arena);
    move_bytes(out->index, points.row, sizeof(std::uint32_t) * points.count, arena);
    std::uint32_t at = 0;
    each_copy([&](std::uint32_t i, const double* v, const int* times) {
        const double* const from = points.x + std::size_t{i} * numbers;
        double* const to = out->x + std::size_t{points.count + at} * numbers;
        for (int k = 0; k < D; ++k) to[k] = from[k] + v[k] + 0.0;
        to[D] = from[D];
        out->index[points.count + at] = points.row[i];
        out->own[at] = i;
        std::int64_t shift = 0;
        for (int j = lattice.count; j-- > 0;) shift = shift * 1024 + times[j];
        out->shift[at++] = shift;
    });
    return arena.has_stopped() ? Status::cancelled : Status::ok;
}

void find_given(const PeriodicInput& input, int dimension, GivenTranslations* out) {
    int culprit;
    out->lattice.open(input.vectors, input.vector_count, dimension, &culprit, out->of_given);
}

template <int D>
bool translations_of(const PeriodicInput& input, const GivenTranslations& given, const PeriodicPoints& points,
                     std::uint32_t i, std::int64_t shift, std::int32_t* times) {
    constexpr double most = 0x1p30;
    const int count = given.lattice.count;
    double x[D], left[D], whole[Lattice::most];
    NearPoint<D> point;
    input.points.read(points.row[i], D, x);
    point.take(given.lattice, x, whole);
    const double* const placed = points.x + std::size_t{i} * (D + 1);
    for (int k = 0; k < D; ++k) left[k] = (placed[k] - point.high[k]) - point.low[k];
    for (int j = count - 1; j >= 0; --j) {
        const double more = nearest_integer(points.lattice.place(j, left));
        for (int k = 0; k < D; ++k) left[k] -= more * points.lattice.b[j][k];
        whole[j] = more - whole[j];
    }
    // The last of ten bits each, with a sign, are those of b[0].
    for (int j = 0; j < count; ++j) {
        std::int64_t last = shift & 1023;
        if (last >= 512) last -= 1024;
        shift = (shift - last) / 1024;
        whole[j] += static_cast<double>(last);
    }
    for (int k = 0; k < count; ++k) {
        double sum = 0, size = 0;
        for (int j = 0; j < count; ++j) {
            sum += whole[j] * given.of_given[j][k];
            size += absolute(whole[j]) * absolute(given.of_given[j][k]);
            if (absolute(given.of_given[j][k]) >= 0x1p52) return false;
        }
        if (size >= 0x1p52 || absolute(sum) >= most) return false;
        times[k] = static_cast<std::int32_t>(sum);
    }
    return true;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status take_periodic_points<D>(const PeriodicInput&, const Work&, PeriodicPoints*, PeriodicReport*);      \
    template Status make_copies<D>(const PeriodicPoints&, const double*, const Work&, Copies*);                        \
    template bool translations_of<D>(const PeriodicInput&, const GivenTranslations&, const PeriodicPoints&,            \
                                     std::uint32_t, std::int64_t, std::int32_t*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
