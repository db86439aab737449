#include "jobs/points_vineyard.hpp"

#include "diagram/induced_matching.hpp"
#include "filtration/point_complexes.hpp"
#include "homology/matrix/image.hpp"
#include "numerics/real.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {
namespace {

constexpr std::uint32_t steps_max = points_degree_max;  // k is at most that

// The chains for all k in one complex. Homology of degree p at one k is that of the sets of k to k + p + 1 points, with
// any larger ones or without: a set of m points closes a cone over the chains of the smaller ones, a wedge of spheres
// of dimension m - k - 1, which is more than p. The map from k + 1 to k needs no larger sets than k does: those of k +
// p + 2 points would close spheres of dimension p for k + 1, so without them k + 1 has only more classes, with the same
// image.
class Levels {
public:
    Levels(const PointsVineyardRequest& request, const Work& work)
        : filter_(request.filter), k_last_(request.k_last), work_(work) {}

    // Lists the chains at the arena's low end.
    Status open(const PointSet& set);
    // The diagrams and the images of the maps, at the low end.
    Status reduce();
    // Leaves the vines above them.
    Status follow(VineList* out);

private:
    Status list_sizes(const ListedComplex& sets);
    bool choose(std::uint32_t least, std::uint32_t most, SimplexSet* out);
    Status persist(std::uint32_t step);
    Status find_image(std::uint32_t step);
    std::uint32_t steps() const { return k_last_ - filter_.k + 1; }

    const PointsFilter& filter_;
    std::uint32_t k_last_;
    const Work& work_;
    ListedComplex complex_;
    struct Sizes {
        std::uint8_t least, most;  // points of the smallest and the largest set of a chain
    };
    Sizes* sizes_[ListedComplex::dimension_max + 1];
    PairList diagram_[steps_max], image_[steps_max];  // image_[i]: of the map from step i + 1 to step i
};

Status Levels::open(const PointSet& set) {
    const std::uint32_t top = k_last_ + filter_.max_degree, degree = filter_.max_degree;
    ListedComplex sets;
    Status status = list_sets(set, filter_.filter, top < set.count ? top : set.count - 1, work_, &sets);
    if (status == Status::ok) status = barycentric_complex(sets, filter_.k, degree + 1, degree + 1, work_, &complex_);
    if (status == Status::ok) status = order_by_value(complex_, work_.arena);
    if (status != Status::ok) return status;
    const double factor = factor_of(filter_);
    for (std::uint32_t m = 0; m <= complex_.dimension; ++m)
        for (std::uint32_t i = 0; i < complex_.count[m];)
            for (const std::uint64_t piece = work_.arena.piece(i, complex_.count[m], 30); i < piece; ++i) {
                complex_.value[m][i] *= factor;
            }
    return list_sizes(sets);
}

// A chain has the sizes of its facets.
Status Levels::list_sizes(const ListedComplex& sets) {
    for (std::uint32_t m = 0; m <= complex_.dimension; ++m) {
        Sizes* const sizes = sizes_[m] = work_.arena.take_low<Sizes>(complex_.count[m]);
        if (sizes == nullptr) return Status::out_of_memory;
        for (std::uint32_t i = 0; i < complex_.count[m];)
            for (const std::uint64_t piece = work_.arena.piece(i, complex_.count[m], 30); i < piece; ++i) {
                if (m == 0) {
                    const std::uint32_t size = set_size(sets, filter_.k, complex_.rows[0][i]);
                    sizes[i] = {static_cast<std::uint8_t>(size), static_cast<std::uint8_t>(size)};
                    continue;
                }
                const std::uint32_t* const facets = complex_.rows[m] + std::size_t{i} * (m + 1);
                sizes[i] = sizes_[m - 1][facets[0]];
                for (std::uint32_t f = 1; f <= m; ++f) {
                    const Sizes other = sizes_[m - 1][facets[f]];
                    if (other.least < sizes[i].least) sizes[i].least = other.least;
                    if (other.most > sizes[i].most) sizes[i].most = other.most;
                }
            }
    }
    return Status::ok;
}

// The chains of sets of `least` to `most` points. False: out of memory.
bool Levels::choose(std::uint32_t least, std::uint32_t most, SimplexSet* out) {
    for (std::uint32_t m = 0; m <= complex_.dimension; ++m) {
        const std::uint32_t count = complex_.count[m];
        std::uint64_t* const words = work_.arena.take_high<std::uint64_t>(BitSet::words_needed(count));
        if (words == nullptr) return false;
        out->of[m].adopt(words, count);
        for (std::uint32_t i = 0; i < count;)
            for (const std::uint64_t piece = work_.arena.piece(i, count, 10); i < piece; ++i) {
                if (sizes_[m][i].least >= least && sizes_[m][i].most <= most) out->of[m].insert(i);
            }
    }
    return true;
}

Status Levels::persist(std::uint32_t step) {
    const HighScope scope(work_.arena);
    const std::uint32_t k = filter_.k + step;
    SimplexSet all;
    if (!choose(k, k + filter_.max_degree + 1, &all)) return Status::out_of_memory;
    return persist_image(complex_.filtered(), all, all, {filter_.max_degree}, work_, &diagram_[step]);
}

Status Levels::find_image(std::uint32_t step) {
    const HighScope scope(work_.arena);
    const std::uint32_t k = filter_.k + step, most = k + filter_.max_degree + 1;
    SimplexSet whole, part;
    if (!choose(k, most, &whole) || !choose(k + 1, most, &part)) return Status::out_of_memory;
    return persist_image(complex_.filtered(), whole, part, {filter_.max_degree}, work_, &image_[step]);
}

Status Levels::reduce() {
    Status status = Status::ok;
    for (std::uint32_t step = 0; step < steps() && status == Status::ok; ++step) {
        status = persist(step);
        if (status == Status::ok && step + 1 < steps()) status = find_image(step);
    }
    return status;
}

Status Levels::follow(VineList* out) {
    const HighScope scope(work_.arena);
    std::uint64_t total = 0;
    for (std::uint32_t step = 0; step < steps(); ++step) total += diagram_[step].count;
    VinePoint* const points =
        total <= none ? work_.arena.take_low<VinePoint>(static_cast<std::size_t>(total)) : nullptr;
    std::uint32_t* vine[steps_max] = {};
    if (points == nullptr) return Status::out_of_memory;
    std::uint32_t raw_count = 0;
    VinePoint* point = points;
    for (std::uint32_t step = 0; step < steps(); ++step) {
        const PairList& here = diagram_[step];
        std::uint32_t* const vines = vine[step] =
            work_.arena.take_high<std::uint32_t>(static_cast<std::size_t>(here.count));
        if (vines == nullptr) return Status::out_of_memory;
        for (std::uint64_t i = 0; i < here.count;)
            for (const std::uint64_t piece = work_.arena.piece(i, here.count, 20); i < piece; ++i) {
                vines[i] = none;
            }
        if (step > 0) {
            const MappedDiagrams mapped = {here, image_[step - 1], diagram_[step - 1]};
            const Status status = match_induced(mapped, work_.arena, vines);
            if (status != Status::ok) return status;
        }
        for (std::uint64_t i = 0; i < here.count;)
            for (const std::uint64_t piece = work_.arena.piece(i, here.count, 20); i < piece; ++i) {
                vines[i] = vines[i] == none ? raw_count++ : vine[step - 1][vines[i]];
                const Pair& pair = here.pairs[i];
                *point++ = {pair.birth, pair.death, vines[i], filter_.k + step, pair.degree, 0};
            }
    }
    const Status status = number_vines(points, total, raw_count, work_.arena, out);
    out->simplices = out->transpositions = 0;
    for (std::uint32_t m = 0; m <= complex_.dimension; ++m) out->simplices += complex_.count[m];
    return status;
}

}  // namespace

Status points_vineyard(const PointsVineyardRequest& request, const Work& work, PointsVineyard* out) {
    *out = {};
    const PointsFilter& filter = request.filter;
    const std::uint32_t count = request.k_last - filter.k + 1;
    VineRoom room(work.arena);
    PointSet set = {};
    Status status = room.open(count);
    if (status == Status::ok) status = take_points(request.given, work.arena, &set, &out->culprit);
    if (status != Status::ok) return status;
    if (request.k_last > set.count) return Status::invalid_argument;
    Levels levels(request, work);
    status = levels.open(set);
    if (status == Status::ok) status = levels.reduce();
    if (status == Status::ok) status = levels.follow(&out->vines);
    if (status != Status::ok) return status;
    for (std::uint32_t i = 0; i < count; ++i) room.ratios()[i] = ratio_of(filter);
    out->distinct = set.count;
    out->input_fingerprint = set.fingerprint;
    return room.keep(&out->vines);
}

double points_vineyard_bytes(const PointsFilter& filter, std::uint32_t k_last, std::uint64_t n, std::uint32_t dim) {
    const std::uint32_t degree = filter.max_degree, top = k_last + degree + 1;
    const std::uint32_t most = n < top ? static_cast<std::uint32_t>(n) : top;  // points of a set
    // Chains by their smallest set: those of at least k points without those of at least k + 1.
    double chains = 0, pairs = 0;
    for (std::uint32_t k = filter.k; k <= most; ++k) {
        const std::uint32_t largest = k + degree + 1 < most ? k + degree + 1 : most;
        chains += barycentric_count(n, k, largest, degree + 1);
        if (k < largest) chains -= barycentric_count(n, k + 1, largest, degree + 1);
        if (k <= k_last) pairs += barycentric_pairs(n, k, degree);
    }
    // A simplex of `width` vertices: facets, value; then tables, orders, sizes and columns.
    const auto bytes = [](double count, std::uint32_t width) { return count * (4.0 * width + 8 + 24); };
    const double listed = bytes(skeleton_count(n, most - 1), most) + bytes(chains, degree + 2);
    return 1.1 * listed + pairs * (2 * sizeof(Pair) + sizeof(VinePoint)) + static_cast<double>(n) * (8.0 * dim + 5);
}

}  // namespace netmesh
