#include "periods/periodic_points.hpp"

#include "delaunay/spatial_order.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/sort.hpp"
#include "numerics/vector.hpp"
#include "periods/grid.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Squares of lengths are far from the ends of the range of doubles.
constexpr double length_most = 0x1p300, length_least = 0x1p-300;
// What is moved farther than this part of the least distance of layers is no lattice any more.
constexpr double moved_most = 0x1p-20;

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

}  // namespace

template <int D>
Status take_periodic_points(const PeriodicInput& input, const Work& work, PeriodicPoints* out, PeriodicReport* report) {
    *report = PeriodicReport{};
    return Taking<D>(input, work, out, report).run();
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
    template bool translations_of<D>(const PeriodicInput&, const GivenTranslations&, const PeriodicPoints&,            \
                                     std::uint32_t, std::int64_t, std::int32_t*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
