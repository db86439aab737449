#include "laboratory/pacing.hpp"
#include "numerics/vector.hpp"

namespace netmesh {
namespace {

// A range of the tree to be looked at, all of whose points are at least sqrt(plane2) away.
struct PrunedRange {
    TreeRange range;
    double plane2;
};

// Calls at_item(v) for the items of a range that is not pruned, near ranges first. prune(range, plane2) is asked once a
// range.
template <class Prune, class AtItem>
void search(const AnyStore& store, const AnyInputTree& tree, const double* x, Prune&& prune, AtItem&& at_item) {
    PrunedRange stack[64];
    int depth = 0;
    stack[depth++] = {tree.root(), 0};
    while (depth > 0) {
        const PrunedRange part = stack[--depth];
        if (prune(part.range, part.plane2)) continue;
        if (part.range.is_leaf()) {
            for (std::uint32_t i = part.range.begin; i < part.range.end; ++i) at_item(tree.item(i));
            continue;
        }
        const std::uint32_t middle = part.range.middle(), v = tree.item(middle);
        const int axis = tree.axis(middle);
        at_item(v);
        const double offset = x[axis] - store.point(v)[axis], plane2 = offset * offset;
        const PrunedRange below = {{part.range.begin, middle},
                                   offset > 0 && plane2 > part.plane2 ? plane2 : part.plane2};
        const PrunedRange above = {{middle + 1, part.range.end},
                                   offset < 0 && plane2 > part.plane2 ? plane2 : part.plane2};
        stack[depth++] = offset < 0 ? above : below;
        stack[depth++] = offset < 0 ? below : above;
    }
}

// value[middle] of each range := the least (greatest) of its items by `of`, from the leaves up.
template <class T, class Of, class Better>
T summary(const AnyInputTree& tree, TreeRange range, const T* value, Of&& of, Better&& better) {
    T best = of(tree.item(range.middle()));
    if (range.is_leaf()) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            if (better(of(tree.item(i)), best)) best = of(tree.item(i));
        return best;
    }
    const T below = value[range.below().middle()], above = value[range.above().middle()];
    if (better(below, best)) best = below;
    return better(above, best) ? above : best;
}

// All ranges, parents before children. list has room for count entries.
std::uint32_t list_ranges(const AnyInputTree& tree, const Arena& arena, TreeRange* list) {
    std::uint32_t count = 0;
    list[count++] = tree.root();
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = arena.piece(k, count, 25); k < piece; ++k) {
            const TreeRange range = list[k];
            if (range.is_leaf()) continue;
            list[count++] = range.below();
            list[count++] = range.above();
        }
    return count;
}

// The farthest input from those taken so far.
class FarthestFirst {
public:
    FarthestFirst(const AnyStore& store, const AnyInputTree& tree) : store_(store), tree_(tree) {}

    // For inputs 0..count-1, none taken. False: out of memory.
    bool open(Arena& arena, std::uint32_t count) {
        count_ = count;
        near2_ = arena.take_high<double>(count);
        far2_ = arena.take_high<double>(count);
        visited_ = arena.take_high<TreeRange>(count);
        if (near2_ == nullptr || far2_ == nullptr || visited_ == nullptr) return false;
        for (std::uint32_t v = 0; v < count;)
            for (const std::uint64_t piece = arena.piece(v, count, 5); v < piece; ++v) {
                near2_[v] = far2_[v] = infinity;
            }
        return true;
    }
    // The one farthest from input 0, which is not taken yet.
    std::uint32_t from_input_0() const;
    // Takes an input: the others come nearer to what is taken. How many ranges of the tree were visited.
    std::uint32_t take(std::uint32_t input);
    // Down the tree to a farthest one, the first in the tree's order among equals.
    std::uint32_t from_all_taken() const;

private:
    const AnyStore& store_;
    const AnyInputTree& tree_;
    std::uint32_t count_ = 0;
    // Squared distance to the inputs taken, -1 for those themselves; its maximum over each range.
    double *near2_ = nullptr, *far2_ = nullptr;
    TreeRange* visited_ = nullptr;
};

std::uint32_t FarthestFirst::from_input_0() const {
    std::uint32_t farthest = 0;
    double reach2 = -1;
    for (std::uint32_t v = 0; v < count_;)
        for (const std::uint64_t piece = store_.arena.piece(v, count_, 8 * store_.dim); v < piece; ++v) {
            const double d2 = distance2(store_.dim, store_.point(0), store_.point(v));
            if (!(d2 > reach2)) continue;
            reach2 = d2;
            farthest = v;
        }
    return farthest;
}

std::uint32_t FarthestFirst::take(std::uint32_t input) {
    const double* const x = store_.point(input);
    near2_[input] = -1;
    std::uint32_t visits = 0;
    search(
        store_, tree_, x,
        [&](TreeRange range, double plane2) {
            // The range that holds the input itself is always visited: its plane is at most 0 away.
            if (plane2 > far2_[range.middle()]) return true;
            visited_[visits++] = range;
            return false;
        },
        [&](std::uint32_t v) {
            store_.arena.step(v, 60);
            const double d2 = distance2(store_.dim, x, store_.point(v));
            if (d2 < near2_[v]) near2_[v] = d2;
        });
    for (std::uint32_t k = visits; k-- > 0;) {
        store_.arena.step(k + 1, 60);
        far2_[visited_[k].middle()] = summary(
            tree_, visited_[k], far2_, [&](std::uint32_t v) { return near2_[v]; },
            [](double a, double b) { return a > b; });
    }
    return visits;
}

std::uint32_t FarthestFirst::from_all_taken() const {
    for (TreeRange range = tree_.root();;) {
        const double most = far2_[range.middle()];
        std::uint32_t farthest = tree_.item(range.middle());
        if (range.is_leaf()) {
            for (std::uint32_t k = range.end; k-- > range.begin;)
                if (near2_[tree_.item(k)] == most) farthest = tree_.item(k);
            return farthest;
        }
        if (far2_[range.below().middle()] == most)
            range = range.below();
        else if (far2_[range.above().middle()] == most)
            range = range.above();
        else
            return farthest;
    }
}

}  // namespace

Status pace(const AnyStore& store, const AnyInputTree& tree, const std::uint32_t* order, std::uint32_t count,
            const Work& work, double* theta) {
    ArenaScope scope(work.arena);
    std::uint32_t* const rank = work.arena.take_high<std::uint32_t>(count);
    std::uint32_t* const least = work.arena.take_high<std::uint32_t>(count);
    if (rank == nullptr || least == nullptr) return Status::out_of_memory;
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = work.arena.piece(i, count, 5); i < piece; ++i) {
            rank[order[i]] = i;
        }
    {
        ArenaScope inner(work.arena);
        TreeRange* const ranges = work.arena.take_high<TreeRange>(count);
        if (ranges == nullptr) return Status::out_of_memory;
        for (std::uint32_t k = list_ranges(tree, work.arena, ranges); k-- > 0;) {
            work.arena.step(k, 60);
            least[ranges[k].middle()] = summary(
                tree, ranges[k], least, [&](std::uint32_t v) { return rank[v]; },
                [](std::uint32_t a, std::uint32_t b) { return a < b; });
        }
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        theta[i] = 1;
        if (i < 2) continue;
        const double* const x = store.point(order[i]);
        double first2 = infinity, second2 = infinity;
        search(
            store, tree, x,
            [&](TreeRange range, double plane2) { return plane2 > second2 || least[range.middle()] >= i; },
            [&](std::uint32_t v) {
                if (rank[v] >= i) return;
                const double d2 = distance2(store.dim, x, store.point(v));
                if (d2 < first2) {
                    second2 = first2;
                    first2 = d2;
                } else if (d2 < second2) {
                    second2 = d2;
                }
            });
        theta[i] = square_root(first2) / square_root(second2);
        if (work.monitor.advance(i, 8)) return Status::cancelled;
    }
    return Status::ok;
}

Status farthest_first_order(const AnyStore& store, const AnyInputTree& tree, std::uint32_t count, const Work& work,
                            std::uint32_t* order) {
    ArenaScope scope(work.arena);
    FarthestFirst farthest(store, tree);
    if (!farthest.open(work.arena, count)) return Status::out_of_memory;
    std::uint32_t next = farthest.from_input_0();
    for (std::uint32_t i = 0; i < count; ++i) {
        order[i] = next;
        const std::uint32_t visits = farthest.take(next);
        next = farthest.from_all_taken();
        if (work.monitor.advance(i, 1 + visits)) return Status::cancelled;
    }
    return Status::ok;
}

}  // namespace netmesh
