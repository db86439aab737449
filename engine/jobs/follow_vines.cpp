#include "jobs/follow_vines.hpp"

#include "numerics/real.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

Status number_vines(VinePoint* points, std::uint64_t count, std::uint32_t raw_count, Arena& arena, VineList* out) {
    const HighScope scope(arena);
    std::uint32_t* const number = arena.take_high<std::uint32_t>(raw_count);
    VinePoint* const first = arena.take_high<VinePoint>(raw_count);
    if (number == nullptr || first == nullptr || count >= none) return Status::out_of_memory;
    std::uint32_t vines = 0;
    for (std::uint32_t v = 0; v < raw_count;)
        for (const std::uint64_t piece = arena.piece(v, raw_count, 3); v < piece; ++v) {
            number[v] = none;
        }
    for (std::uint64_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 15); i < piece; ++i) {  // in the order of steps
            if (number[points[i].vine] != none) continue;
            number[points[i].vine] = 0;
            first[vines++] = points[i];
        }
    sort(
        first, vines,
        [](const VinePoint& a, const VinePoint& b) {
            if (a.degree != b.degree) return a.degree < b.degree;
            if (a.k != b.k) return a.k < b.k;
            if (a.birth != b.birth) return a.birth < b.birth;
            if (a.death != b.death) return a.death < b.death;
            return a.vine < b.vine;
        },
        arena);
    for (std::uint32_t v = 0; v < vines;)
        for (const std::uint64_t piece = arena.piece(v, vines, 6); v < piece; ++v) {
            number[first[v].vine] = v;
        }
    for (std::uint64_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 15); i < piece; ++i) {
            points[i].vine = number[points[i].vine];
        }
    sort(
        points, count,
        [](const VinePoint& a, const VinePoint& b) { return a.vine != b.vine ? a.vine < b.vine : a.k < b.k; }, arena);
    out->points = points;
    out->count = count;
    out->vine_count = vines;
    return Status::ok;
}

Status VineFollower::open() {
    for (std::uint32_t k = 0; k <= complex_.dimension; ++k) {
        value_[0][k] = work_.arena.take_high<double>(complex_.count[k]);
        value_[1][k] = work_.arena.take_high<double>(complex_.count[k]);
        if (value_[0][k] == nullptr || value_[1][k] == nullptr) return Status::out_of_memory;
    }
    return Status::ok;
}

bool VineFollower::add(const VinePoint& point) {
    if (count_ == 0) points_ = work_.arena.take_low<VinePoint>(1);
    if (points_ == nullptr || (count_ > 0 && !work_.arena.extend_low(sizeof(VinePoint)))) return false;
    points_[count_++] = point;
    return true;
}

bool VineFollower::note(std::uint32_t step, const double* const* value) {
    bool good = true;
    vineyard_.for_each_pair([&](const Vineyard::VinePair& pair) {
        work_.arena.step(pair.birth, 60);
        const double birth = value[pair.degree][pair.birth];
        const double death = pair.death == none ? infinity : value[pair.degree + 1][pair.death];
        if (death > birth) good = good && add({birth, death, pair.vine, step, pair.degree, 0});
    });
    return good;
}

Status VineFollower::take(std::uint32_t i, std::uint32_t step) {
    const Status status = i == 0 ? vineyard_.open(complex_, max_degree_, value(i), work_)
                                 : vineyard_.advance(value(i - 1), value(i), work_.monitor);
    return status == Status::ok && !note(step, value(i)) ? Status::out_of_memory : status;
}

Status VineFollower::finish(VineList* out) {
    const Status status = number_vines(points_, count_, vineyard_.vine_count(), work_.arena, out);
    if (status != Status::ok) return status;
    out->simplices = 0;
    for (std::uint32_t k = 0; k <= complex_.dimension; ++k) out->simplices += complex_.count[k];
    out->transpositions = vineyard_.transpositions();
    return Status::ok;
}

Status VineRoom::open(std::uint32_t steps) {
    count_ = steps;
    ratio_ = arena_.take_low<double>(steps);
    low_ = arena_.low_mark();
    return ratio_ == nullptr ? Status::out_of_memory : Status::ok;
}

Status VineRoom::keep(VineList* out) {
    arena_.release_low(low_);
    // Where the old ones are or below.
    VinePoint* const points = arena_.take_low<VinePoint>(static_cast<std::size_t>(out->count));
    if (points == nullptr) return Status::out_of_memory;
    move_bytes(points, out->points, sizeof(VinePoint) * static_cast<std::size_t>(out->count), arena_);
    out->ratio = ratio_;
    out->points = points;
    scope_.keep_low_from_now();
    return Status::ok;
}

void raise_to_vertices(const ComplexView& complex, double* const* value, const Arena& arena) {
    for (std::uint32_t k = 1; k <= complex.dimension; ++k)
        for (std::uint32_t i = 0; i < complex.count[k];)
            for (const std::uint64_t piece = arena.piece(i, complex.count[k], 8 + 4 * k); i < piece; ++i) {
                const std::uint32_t* const facets = complex.facets[k] + std::size_t{i} * (k + 1);
                double most = value[k - 1][facets[0]];
                for (std::uint32_t j = 1; j <= k; ++j)
                    if (value[k - 1][facets[j]] > most) most = value[k - 1][facets[j]];
                value[k][i] = most;
            }
}

}  // namespace netmesh
