#include "filtration/scale_partition.hpp"

#include "certificate/rounding.hpp"
#include "numerics/sort.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {
namespace {

struct ByOwner {
    bool operator()(const PointLeft& a, const PointLeft& b) const {
        return a.owner != b.owner ? a.owner < b.owner : a.point < b.point;
    }
};

}  // namespace

Status ScalePartition::open(const AnyStore& store, std::uint32_t count, double theta, Arena& arena) {
    store_ = &store;
    theta_ = theta;
    total_ = count - 1;
    done_ = clusters_ = chosen_count_ = 0;
    separation_ = closest_ = infinity;
    widest_ = 0;
    [[maybe_unused]] const std::size_t low = arena.low_mark();
    left_ = arena.take_low<PointLeft>(total_);
    chosen_ = arena.take_low<std::uint32_t>(count);
    if (left_ == nullptr || chosen_ == nullptr) return Status::out_of_memory;
    NETMESH_ASSERT(arena.low_mark() - low <= point_bytes * count + 2 * Arena::alignment);
    for (std::uint32_t i = 0; i < total_;)
        for (const std::uint64_t piece = store_->arena.piece(i, total_, 4); i < piece; ++i) {
            left_[i] = {0, 0, i + 1, 0};
        }
    return Status::ok;
}

double ScalePartition::distance(std::uint32_t a, std::uint32_t b) const {
    return netmesh::distance(store_->dim, store_->point(a), store_->point(b));
}

// The position of the medial point farthest from the chosen ones, `end` if there is none.
std::uint32_t ScalePartition::farthest(std::uint32_t begin, std::uint32_t end) const {
    std::uint32_t best = end;
    for (std::uint32_t i = begin; i < end;)
        for (const std::uint64_t piece = store_->arena.piece(i, end, 15); i < piece; ++i) {
            const PointLeft& left = left_[i];
            if (chosen_count_ > 1 && !(left.near >= theta_ * left.second)) continue;
            if (best == end || left.near > left_[best].near ||
                (left.near == left_[best].near && left.point < left_[best].point))
                best = i;
        }
    return best;
}

void ScalePartition::choose(std::uint32_t point, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t place = chosen_count_++;
    chosen_[place] = point;
    for (std::uint32_t i = begin; i < end;)
        for (const std::uint64_t piece = store_->arena.piece(i, end, 15); i < piece; ++i) {
            PointLeft& left = left_[i];
            const double d = distance(point, left.point);
            if (place == 0 || d < left.near) {
                left.second = place == 0 ? infinity : left.near;
                left.near = d;
                left.owner = place;
            } else if (d < left.second) {
                left.second = d;
            }
        }
}

// Makes clusters of what is left.
void ScalePartition::group(std::uint32_t begin, std::uint32_t end) {
    sort(left_ + begin, end - begin, ByOwner{}, store_->arena);
    for (std::uint32_t i = begin; i < end;) {
        store_->arena.step(i, 40);
        const std::uint32_t place = left_[i].owner, representative = chosen_[place];
        double gap = infinity, radius = 0;
        for (std::uint32_t j = 0; j < chosen_count_;)
            for (const std::uint64_t piece = store_->arena.piece(j, chosen_count_, 10 * store_->dim); j < piece; ++j) {
                const double d = j == place ? infinity : distance(representative, chosen_[j]);
                if (d < gap) gap = d;
            }
        PointLeft& first = left_[i];
        for (; i < end && left_[i].owner == place; ++i) {
            if (left_[i].near > radius) radius = left_[i].near;
            left_[i].owner = representative;
        }
        first.near = radius;  // for when its turn comes
        first.second = gap;
        const double e = gap * down / (2 * radius * up);
        if (e < separation_) separation_ = e;
    }
}

bool ScalePartition::next(Monitor& monitor, bool* stopped) {
    *stopped = false;
    if (done_ == total_ && clusters_ > 0) return false;
    ++clusters_;
    chosen_count_ = 0;
    const std::uint32_t representative = total_ == 0 ? 0 : left_[done_].owner;
    radius_ = total_ == 0 ? 0 : left_[done_].near;
    gap_ = total_ == 0 ? 0 : left_[done_].second;
    std::uint32_t end = done_;
    while (end < total_ && left_[end].owner == representative) ++end;
    choose(representative, done_, end);
    for (;;) {
        const std::uint32_t i = farthest(done_, end);
        if (i == end) break;
        const PointLeft taken = left_[i];
        if (taken.near < closest_) closest_ = taken.near;
        if (taken.near > widest_) widest_ = taken.near;
        left_[i] = left_[done_];
        left_[done_++] = taken;
        choose(taken.point, done_, end);
        if (monitor.advance(done_, 1 + (end - done_) / 8)) {
            *stopped = true;
            return false;
        }
    }
    group(done_, end);
    return true;
}

}  // namespace netmesh
