#include "mesh/input_tree.hpp"

#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {
namespace {

constexpr auto is_nearer = [](const Neighbour& a, const Neighbour& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.input < b.input);
};

}  // namespace

// Puts the median along the widest axis into the middle of the range (Hoare's selection; equal keys split evenly).
void AnyInputTree::split(std::uint32_t begin, std::uint32_t end) {
    int axis = 0;
    double widest = -1;
    for (int k = 0; k < dim_; ++k) {
        double low = infinity, high = -infinity;
        for (std::uint32_t i = begin; i < end;)
            for (const std::uint64_t piece = arena_->piece(i, end, 12); i < piece; ++i) {
                const double x = point(items_[i])[k];
                if (x < low) low = x;
                if (x > high) high = x;
            }
        if (high - low > widest) {
            widest = high - low;
            axis = k;
        }
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    axis_[middle] = static_cast<std::uint8_t>(axis);
    std::int64_t low = begin, high = static_cast<std::int64_t>(end) - 1;
    while (low < high) {
        const double pivot = point(items_[low + (high - low) / 2])[axis];
        std::int64_t i = low, j = high;
        while (i <= j) {
            while (point(items_[i])[axis] < pivot) ++i;
            while (point(items_[j])[axis] > pivot) --j;
            if (i > j) break;
            arena_->step(i, 30);
            const std::uint32_t t = items_[i];
            items_[i++] = items_[j];
            items_[j--] = t;
        }
        if (middle <= j)
            high = j;
        else if (middle >= i)
            low = i;
        else
            break;
    }
}

Status AnyInputTree::build(const AnyStore& store, Arena& arena, std::uint32_t count, bool rings,
                           const std::uint32_t* chosen) {
    [[maybe_unused]] const std::size_t low = arena.low_mark();
    items_ = arena.take_low<std::uint32_t>(count);
    axis_ = arena.take_low<std::uint8_t>(count);
    reach_ = rings ? arena.take_low<double>(count) : nullptr;
    if (items_ == nullptr || axis_ == nullptr || (rings && reach_ == nullptr)) return Status::out_of_memory;
    NETMESH_ASSERT(arena.low_mark() - low <= (input_bytes + (rings ? ring_bytes : 0)) * count + 3 * Arena::alignment);
    dim_ = store.dim;
    first_point_ = store.first_point();
    stride_ = store.point_stride();
    arena_ = &store.arena;
    count_ = count;
    touches_ = 0;
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 5); i < piece; ++i) {
            items_[i] = chosen != nullptr ? chosen[i] : i;
        }
    TreeRange stack[40];
    int depth = 0;
    stack[depth++] = {0, count};
    while (depth > 0) {
        const TreeRange range = stack[--depth];
        if (range.is_leaf()) continue;
        split(range.begin, range.end);
        arena.pass(2);
        const std::uint32_t middle = range.middle();
        stack[depth++] = range.below();
        stack[depth++] = range.above();
        if (!rings) continue;
        double reach2 = 0;
        for (std::uint32_t i = range.begin; i < range.end;)
            for (const std::uint64_t piece = arena.piece(i, range.end, 10 + 5 * dim_); i < piece; ++i) {
                const double d2 = squared_distance(point(items_[middle]), items_[i]);
                if (d2 > reach2) reach2 = d2;
            }
        reach_[middle] = square_root(reach2) * (1 + 8 * unit_roundoff);
    }
    touches_ = 0;
    return Status::ok;
}

template <int W, class Consider, class Bound>
void AnyInputTree::visit(const double* x, Consider&& consider, Bound&& bound2) const {
    std::uint64_t reported = touches_;
    TreePart<W> stack[40];
    int depth = 0;
    stack[depth++] = {{0, count_}, 0, {}};
    while (depth > 0) {
        const TreePart<W> from = stack[--depth];
        if (from.least2 > bound2()) continue;
        report(&reported);
        TreeRange range = from.range;
        while (!range.is_leaf()) {
            const std::uint32_t middle = range.middle();
            const int axis = axis_[middle];
            const double offset = x[axis] - point(items_[middle])[axis];
            if (offset * offset > bound2()) {  // nor is the item nearer, or any beyond
                ++touches_;
                range = offset < 0 ? range.below() : range.above();
                continue;
            }
            const double d2 = consider(items_[middle]);
            if (reach_ != nullptr) {
                // Clusters far smaller than their distance lie on both sides of planes that say nothing about it.
                const double far = (square_root(bound2()) + reach_[middle]) * (1 + 8 * unit_roundoff);
                if (d2 > far * far) {
                    range.end = range.begin;
                    break;
                }
            }
            stack[depth] = from.beyond(axis, offset, offset < 0 ? range.above() : range.below());
            if (!(stack[depth].least2 > bound2())) ++depth;
            range = offset < 0 ? range.below() : range.above();
        }
        for (std::uint32_t i = range.begin; i < range.end; ++i) consider(items_[i]);
    }
}

template <int D>
[[gnu::noinline]] std::uint32_t AnyInputTree::nearest_of(const double* x, std::uint32_t start, std::uint32_t except,
                                                         double* distance2) const {
    std::uint32_t best = none;
    double best2 = infinity;
    const auto consider = [&](std::uint32_t v) -> double {
        if (v == except) return 0;
        const double d2 = squared_distance<D>(x, v);
        if (d2 < best2 || (d2 == best2 && v < best)) {
            best2 = d2;
            best = v;
        }
        return d2;
    };
    if (start != none) consider(start);
    visit<DimensionOf<D>::most>(x, consider, [&] { return best2; });
    *distance2 = best2;
    return best;
}

template <int D> std::uint32_t AnyInputTree::within_of(const double* x, double bound2, double* distance2) const {
    std::uint32_t best = none;
    *distance2 = bound2;
    const auto consider = [&](std::uint32_t v) -> double {
        const double d2 = squared_distance<D>(x, v);
        if (d2 < *distance2 || (d2 == *distance2 && best != none && v < best)) {
            *distance2 = d2;
            best = v;
        }
        return d2;
    };
    visit<DimensionOf<D>::most>(x, consider, [&] { return *distance2; });
    return best;
}

// The best so far are a heap with the worst of them on top.
void AnyInputTree::nearest_k(const double* x, std::uint32_t k, Neighbour* neighbours) const {
    std::uint32_t found = 0;
    const auto consider = [&](std::uint32_t v) {
        const Neighbour one = {squared_distance(x, v), v, 0};
        if (found < k) {
            std::uint32_t hole = found++;
            for (; hole > 0 && is_nearer(neighbours[(hole - 1) / 2], one); hole = (hole - 1) / 2)
                neighbours[hole] = neighbours[(hole - 1) / 2];
            neighbours[hole] = one;
            return one.distance2;
        }
        if (!is_nearer(one, neighbours[0])) return one.distance2;
        std::uint32_t hole = 0;
        for (std::uint32_t child; (child = 2 * hole + 1) < k; hole = child) {
            if (child + 1 < k && is_nearer(neighbours[child], neighbours[child + 1])) ++child;
            if (!is_nearer(one, neighbours[child])) break;
            neighbours[hole] = neighbours[child];
        }
        neighbours[hole] = one;
        return one.distance2;
    };
    visit<dimension_max>(x, consider, [&] { return found < k ? infinity : neighbours[0].distance2; });
    sort_alike(neighbours, k, is_nearer);
}

std::uint32_t AnyInputTree::farthest_in_ring(const double* x, double inner, double outer, double* distance2) const {
    std::uint32_t best = none;
    double best1 = inner, best2 = inner * inner;
    std::uint64_t reported = touches_;
    const auto consider = [&](std::uint32_t v) {
        const double d2 = squared_distance(x, v);
        if (d2 <= outer * outer && (d2 > best2 || (d2 == best2 && v < best && best != none))) {
            best = v;
            best2 = d2;
            best1 = square_root(d2);
        }
        return d2;
    };
    TreePart<dimension_max> stack[40];
    int depth = 0;
    stack[depth++] = {{0, count_}, 0, {}};
    while (depth > 0) {
        const TreePart<dimension_max> from = stack[--depth];
        const TreeRange range = from.range;
        report(&reported);
        if (range.is_leaf()) {
            for (std::uint32_t i = range.begin; i < range.end; ++i) consider(items_[i]);
            continue;
        }
        const std::uint32_t middle = range.middle();
        const double d = square_root(consider(items_[middle])), reach = reach_[middle];
        if ((d + reach) * (1 + 8 * unit_roundoff) < best1 || (d - reach) * (1 - 8 * unit_roundoff) > outer) continue;
        const double offset = x[axis_[middle]] - point(items_[middle])[axis_[middle]];
        stack[depth] = from;
        stack[depth++].range = offset < 0 ? range.below() : range.above();
        stack[depth] = from.beyond(axis_[middle], offset, offset < 0 ? range.above() : range.below());
        if (!(stack[depth].least2 > outer * outer)) ++depth;
    }
    *distance2 = best2;
    return best;
}

std::uint32_t AnyInputTree::nearest(const double* x, std::uint32_t start, std::uint32_t except,
                                    double* distance2) const {
    return with_dimension(static_cast<std::uint32_t>(dim_), [&](auto dimension) {
        return nearest_of<shared_dimension<decltype(dimension)::value>>(x, start, except, distance2);
    });
}

// In the one-file build those that shared_dimension leaves no use for are no mistake.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
template <int D>
std::uint32_t InputTree<D>::nearest(const double* x, std::uint32_t start, std::uint32_t except,
                                    double* distance2) const {
    return this->template nearest_of<shared_dimension<D>>(x, start, except, distance2);
}
template <int D> std::uint32_t InputTree<D>::nearest_within(const double* x, double bound2, double* distance2) const {
    return this->template within_of<shared_dimension<D>>(x, bound2, distance2);
}
#pragma GCC diagnostic pop

template class InputTree<any_dimension>;
#define NETMESH_INSTANTIATE(D) template class InputTree<D>;
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
