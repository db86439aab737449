// Matchings of one diagram's points into another's by Hopcroft-Karp, whose edges are those within a limit: listed while
// they are few, found by the k-d tree when they are many (then few phases are left to do).
#pragma once
#include <cstddef>
#include <cstdint>

#include "diagram/point_tree.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

constexpr std::uint32_t edges_per_point = 64;  // listed on average; more are searched for

// Arrays that matchings may share, for the larger of two diagrams.
struct MatchingScratch {
    std::uint32_t* queue;   // [count]
    std::uint32_t* level;   // [count], of points on the right
    std::uint32_t* path;    // [2 count]
    std::uint32_t* start;   // [count + 1]
    std::uint32_t* cursor;  // [count]
    std::uint32_t* edge;    // [edges_per_point * count]
    std::uint32_t edge_max;
};

constexpr std::uint32_t removed = none - 1;  // level of a point that augmenting has done with

// The edges of a limit in a list. Every edge is looked at once in a search and once in the augmentations behind it.
template <class Scale> class ListedEdges {
public:
    ListedEdges(const PointTree& left, const PointTree& right, const MatchingScratch& scratch)
        : left_(left), right_(right), scratch_(scratch) {}

    // False when there are too many. Only points on the left beyond `limit` of the diagonal have edges.
    bool list(std::uint64_t limit) {
        std::uint32_t end = 0;
        bool fits = true;
        for (std::uint32_t i = 0; i < left_.count() && fits; ++i) {
            scratch_.start[i] = end;
            if (left_[i].diagonal <= limit) continue;
            right_.visit_within<Scale>(left_[i], limit, [&](std::uint32_t j) {
                fits = end < scratch_.edge_max;
                if (fits) scratch_.edge[end++] = j;
                return fits;
            });
            left_.pass(8 + (end - scratch_.start[i]) / 8);
        }
        scratch_.start[left_.count()] = end;
        return fits;
    }
    void begin_search() {
        rewind();
        for (std::uint32_t j = 0; j < right_.count();)
            for (const std::uint64_t piece = left_.piece(j, right_.count(), 3); j < piece; ++j) {
                scratch_.level[j] = none;
            }
    }
    void begin_augment() { rewind(); }
    std::uint32_t next(std::uint32_t i, std::uint32_t level) {
        while (scratch_.cursor[i] < scratch_.start[i + 1]) {
            const std::uint32_t j = scratch_.edge[scratch_.cursor[i]++];
            if (scratch_.level[j] == level) return j;
        }
        return none;
    }
    void place(std::uint32_t j, std::uint32_t level) { scratch_.level[j] = level; }

private:
    void rewind() {
        for (std::uint32_t i = 0; i < left_.count();)
            for (const std::uint64_t piece = left_.piece(i, left_.count(), 4); i < piece; ++i) {
                scratch_.cursor[i] = scratch_.start[i];
            }
    }
    const PointTree &left_, &right_;
    const MatchingScratch& scratch_;
};

// The same edges without a list. Points bear the mark of their level in the tree.
template <class Scale> class SearchedEdges {
public:
    SearchedEdges(const PointTree& left, PointTree& right, const MatchingScratch& scratch, std::uint64_t limit)
        : left_(left), right_(right), scratch_(scratch), limit_(limit) {}

    void begin_search() {
        right_.mark_all(mark_of(none));
        for (std::uint32_t j = 0; j < right_.count();)
            for (const std::uint64_t piece = left_.piece(j, right_.count(), 3); j < piece; ++j) {
                scratch_.level[j] = none;
            }
    }
    void begin_augment() {}
    std::uint32_t next(std::uint32_t i, std::uint32_t level) const {
        left_.pass(12);
        const std::uint32_t* const level_of = scratch_.level;
        return right_.find<Scale>(left_[i], limit_, mark_of(level),
                                  [level_of, level](std::uint32_t j) { return level_of[j] == level; });
    }
    void place(std::uint32_t j, std::uint32_t level) {
        scratch_.level[j] = level;
        right_.mark(j, level == removed ? 0 : mark_of(level));
    }

private:
    static std::uint64_t mark_of(std::uint32_t level) {
        return level == none ? std::uint64_t{1} << 63 : std::uint64_t{1} << level % 63;
    }
    const PointTree& left_;
    PointTree& right_;
    const MatchingScratch& scratch_;
    std::uint64_t limit_;
};

// Points of `left` whose distance to the diagonal exceeds a limit must be matched to points of `right` within it; the
// others stay free. The matching is kept from limit to limit.
class Matching {
public:
    // left_mate[left.count()], right_mate[right.count()]. Marks in `right` are used.
    void begin(const PointTree& left, PointTree& right, std::uint32_t* left_mate, std::uint32_t* right_mate,
               const MatchingScratch& scratch, Monitor& monitor) {
        monitor_ = &monitor;
        left_ = &left;
        right_ = &right;
        left_mate_ = left_mate;
        right_mate_ = right_mate;
        scratch_ = scratch;
        for (std::uint32_t i = 0; i < left.count();)
            for (const std::uint64_t piece = left.piece(i, left.count(), 3); i < piece; ++i) {
                left_mate_[i] = none;
            }
        for (std::uint32_t i = 0; i < right.count();)
            for (const std::uint64_t piece = left.piece(i, right.count(), 3); i < piece; ++i) {
                right_mate_[i] = none;
            }
    }

    // Whether every left point beyond `limit` of the diagonal can be matched. If so, *next is the largest distance that
    // the matching, or a point left to the diagonal, uses: at most the limit. If not, *next is a lower bound, greater
    // than the limit, of the limits for which it can. Neither means anything once it was cancelled().
    template <class Scale> bool cover(std::uint64_t limit, std::uint64_t* next) {
        *next = drop_beyond<Scale>(limit);
        ListedEdges<Scale> listed(*left_, *right_, scratch_);
        SearchedEdges<Scale> searched(*left_, *right_, scratch_, limit);
        const std::uint32_t reached = listed.list(limit) ? match(listed, limit) : match(searched, limit);
        if (reached > 0) {
            *next = next_limit<Scale>(reached);
            return false;
        }
        for (std::uint32_t i = 0; i < left_->count();)
            for (const std::uint64_t piece = left_->piece(i, left_->count(), 12); i < piece; ++i) {
                if (left_mate_[i] == none) continue;
                const std::uint64_t used = distance<Scale>(i, left_mate_[i]);
                if (used > *next) *next = used;
            }
        return true;
    }
    bool cancelled() const { return cancelled_; }

private:
    bool is_free(std::uint32_t i, std::uint64_t limit) const {
        return left_mate_[i] == none && (*left_)[i].diagonal > limit;
    }
    template <class Scale> std::uint64_t distance(std::uint32_t i, std::uint32_t j) const {
        const DiagramPoint &a = (*left_)[i], &b = (*right_)[j];
        const std::uint64_t x = Scale::between(a.coordinate[0], b.coordinate[0]);
        const std::uint64_t y = Scale::between(a.coordinate[1], b.coordinate[1]);
        return x > y ? x : y;
    }

    // Unmatches what the limit does not allow or does not ask for; the largest distance to the diagonal within it.
    template <class Scale> std::uint64_t drop_beyond(std::uint64_t limit) {
        std::uint64_t largest = 0;
        for (std::uint32_t i = 0; i < left_->count();)
            for (const std::uint64_t piece = left_->piece(i, left_->count(), 12); i < piece; ++i) {
                const std::uint64_t diagonal = (*left_)[i].diagonal;
                if (diagonal <= limit && diagonal > largest) largest = diagonal;
                const std::uint32_t j = left_mate_[i];
                if (j == none || (diagonal > limit && distance<Scale>(i, j) <= limit)) continue;
                left_mate_[i] = right_mate_[j] = none;
            }
        return largest;
    }

    // Phases until nothing is free, which is 0, or until free points have no alternating path to a free partner: the
    // number of left points that they reach, which are in the queue.
    template <class Edges> std::uint32_t match(Edges& edges, std::uint64_t limit) {
        for (;;) {
            std::uint32_t found = none;
            const std::uint32_t reached = search(edges, limit, &found);
            if (found == none) return reached;
            cancelled_ = monitor_->advance(0, reached);
            if (cancelled_) return 0;
            edges.begin_augment();
            for (std::uint32_t i = 0; i < left_->count(); ++i) {
                left_->step(i, 100);
                if (is_free(i, limit)) augment(edges, i, found);
            }
        }
    }

    // Layers of alternating paths from the free points on the left, up to the first that has a free point on the right:
    // *found is that layer's number. Returns the number of left points reached.
    template <class Edges> std::uint32_t search(Edges& edges, std::uint64_t limit, std::uint32_t* found) {
        std::uint32_t end = 0;
        for (std::uint32_t i = 0; i < left_->count(); ++i) {
            left_->step(i, 12);
            if (is_free(i, limit)) scratch_.queue[end++] = i;
        }
        if (end == 0) return 0;
        edges.begin_search();
        std::uint32_t level = 0, level_end = end;
        for (std::uint32_t at = 0; at < end; ++at) {
            left_->step(at, 600);
            if (at == level_end) {
                if (*found != none) break;
                ++level;
                level_end = end;
            }
            for (std::uint32_t j; (j = edges.next(scratch_.queue[at], none)) != none;) {
                edges.place(j, level);
                if (right_mate_[j] == none) {
                    *found = level;
                } else {
                    scratch_.queue[end++] = right_mate_[j];
                }
            }
        }
        return end;
    }

    // Depth first from the free point `root` through the layers; each point on the right is entered once.
    template <class Edges> void augment(Edges& edges, std::uint32_t root, std::uint32_t last) {
        std::uint32_t* const path = scratch_.path;  // left and right points in turns
        std::size_t level = 0;
        path[0] = root;
        for (;;) {
            const std::uint32_t j = edges.next(path[2 * level], static_cast<std::uint32_t>(level));
            if (j == none) {
                if (level-- == 0) return;
                continue;
            }
            edges.place(j, removed);
            path[2 * level + 1] = j;
            if (right_mate_[j] == none) break;
            if (level < last) path[2 * ++level] = right_mate_[j];
        }
        for (std::size_t l = 0; l <= level; ++l) {
            left_mate_[path[2 * l]] = path[2 * l + 1];
            right_mate_[path[2 * l + 1]] = path[2 * l];
        }
    }

    // The points in queue[0, reached) compete for too few partners. That ends when one of them may go to the diagonal
    // or gets an edge to a partner that none of them had.
    template <class Scale> std::uint64_t next_limit(std::uint32_t reached) const {
        right_->mark_all(1);
        for (std::uint32_t j = 0; j < right_->count();)
            for (const std::uint64_t piece = left_->piece(j, right_->count(), 300); j < piece; ++j) {
                if (scratch_.level[j] != none) right_->mark(j, 0);
            }
        std::uint64_t next = key_of_infinity;
        for (std::uint32_t at = 0; at < reached;)
            for (const std::uint64_t piece = left_->piece(at, reached, 3000); at < piece; ++at) {
                const DiagramPoint& from = (*left_)[scratch_.queue[at]];
                if (from.diagonal < next) next = from.diagonal;
                next = right_->nearest<Scale>(from, next, 1);
            }
        return next;
    }

    const PointTree* left_ = nullptr;
    PointTree* right_ = nullptr;
    std::uint32_t *left_mate_ = nullptr, *right_mate_ = nullptr;
    MatchingScratch scratch_ = {};
    Monitor* monitor_ = nullptr;
    bool cancelled_ = false;
};

}  // namespace netmesh
