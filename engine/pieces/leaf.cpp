// Home: the lowest node that most of a simplex's vertices are from, the first of them, if it has two of them; otherwise
// the node of all its vertices, where it arrives by way of the first of its lowest nodes. A vertex is at home where it
// is. So a simplex with three vertices or more at home in a lowest node has a vertex of that node in each of its
// facets, and all that has to be known of them is known: cells at points of the node are those of all points.
#include "pieces/leaf.hpp"

#include "homology/union_find.hpp"
#include "memory/prefetch.hpp"
#include "numerics/sort.hpp"
#include "numerics/value_order.hpp"
#include "pieces/cancel.hpp"
#include "pieces/leaf_faces.hpp"

namespace netmesh {
namespace {

PieceNode home_of(const PieceNode* leaf, std::uint32_t count) {
    PieceNode best = no_piece, all = leaf[0];
    std::uint32_t most = 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        all = common_piece(all, leaf[i]);
        std::uint32_t alike = 0;
        for (std::uint32_t j = 0; j < count; ++j) alike += leaf[j] == leaf[i];
        if (alike > most || (alike == most && best != no_piece && leaf[i] < best)) {
            most = alike;
            best = leaf[i];
        }
    }
    return best != no_piece ? best : all;
}

class Leaf {
public:
    Leaf(const LeafRequest& request, const Work& work)
        : request_(request), arena_(work.arena), work_(work), node_(request.node) {
        piece_.job = job_of(request.source, request.pieces, request.diagram);
        piece_.node = node_;
    }

    Status run(PieceBytes* out, StarsReport* report) {
        Status status = list_leaf_faces(request_.source, node_, work_, &of_, report);
        if (status == Status::ok) status = find_homes();
        if (status == Status::ok) status = find_mates();
        if (status == Status::ok) status = list();
        if (status == Status::ok) status = cancel_pairs(&piece_, work_);
        if (status == Status::ok) status = name_simplices();
        return status == Status::ok ? write_piece(piece_, work_, out) : status;
    }

private:
    std::uint32_t top() const { return piece_.job.top(); }
    std::uint32_t dim() const { return piece_.job.dim; }
    std::uint32_t face_count(std::uint32_t k) const { return of_.faces.count[k]; }
    const std::uint32_t* facets_of(std::uint32_t k, std::uint64_t f) const {
        return of_.faces.facets_of(static_cast<int>(k), static_cast<std::uint32_t>(f));
    }
    // Not inlined: compilers that do it warn of dimensions that there are not.
    [[gnu::noinline]] void vertices_of(std::uint32_t k, std::uint64_t f, std::uint32_t* vertex) const {
        of_.faces.vertices(static_cast<int>(k), static_cast<std::uint32_t>(f), vertex);
    }

    // Homes and scopes. no_piece: no vertex is the node's own.
    Status find_homes() {
        for (std::uint32_t k = 0; k <= top(); ++k) {
            home_[k] = arena_.take_low<PieceNode>(face_count(k));
            scope_[k] = arena_.take_low<PieceNode>(face_count(k));
            place_[k] = arena_.take_low<std::uint8_t>(face_count(k));
            if (home_[k] == nullptr || scope_[k] == nullptr || place_[k] == nullptr) return Status::out_of_memory;
            arena_.each(face_count(k), 10 * (k + 1), [&](std::uint64_t f) {
                const std::uint32_t face = static_cast<std::uint32_t>(f);
                if (k > 0) {
                    const std::uint32_t* const facet = facets_of(k, face);
                    if (place_[k - 1][facet[0]] == all_own && place_[k - 1][facet[k]] == all_own) {
                        home_[k][f] = scope_[k][f] = node_;
                        place_[k][f] = all_own;
                        return;
                    }
                }
                std::uint32_t vertex[simplex_most];
                PieceNode leaf[simplex_most], least = ~PieceNode{0};
                vertices_of(k, face, vertex);
                bool is_own = false;
                for (std::uint32_t i = 0; i <= k; ++i) {
                    leaf[i] = of_.leaf[vertex[i]];
                    is_own |= leaf[i] == node_;
                    least = leaf[i] < least ? leaf[i] : least;
                }
                home_[k][f] = scope_[k][f] = is_own ? home_of(leaf, k + 1) : no_piece;
                place_[k][f] = k == 0 && is_own ? all_own : least == node_ ? own_first : elsewhere;
            });
        }
        // Rows of boundaries: the homes of all cofaces; every one of these has a vertex of the node, too.
        for (std::uint32_t k = 1; k <= top(); ++k)
            arena_.each(face_count(k), 6 * (k + 1), [&](std::uint64_t f) {
                if (home_[k][f] == no_piece) return;
                const std::uint32_t* const facet = facets_of(k, f);
                for (std::uint32_t i = 0; i <= k; ++i) {
                    PieceNode& below = scope_[k - 1][facet[i]];
                    if (below != home_[k][f] && below != no_piece) below = common_piece(below, home_[k][f]);
                }
            });
        // Rows of coboundaries: the homes of all facets.
        if (piece_.job.has_cells())
            arena_.each(face_count(dim()), 20 * dim(), [&](std::uint64_t c) {
                if (home_[dim()][c] == no_piece || place_[dim()][c] == all_own) return;
                std::uint32_t vertex[simplex_most];
                vertices_of(dim(), c, vertex);
                for (std::uint32_t without = 0; without <= dim(); ++without) {
                    PieceNode leaf[simplex_most];
                    for (std::uint32_t i = 0, n = 0; i <= dim(); ++i)
                        if (i != without) leaf[n++] = of_.leaf[vertex[i]];
                    scope_[dim()][c] = common_piece(scope_[dim()][c], home_of(leaf, dim()));
                }
            });
        return Status::ok;
    }

    // Pairs of zero length that need no order to be seen: a face that is the last facet of a coface of equal value,
    // which is the first cofacet of that face (homology/matrix/ball.cpp). The last facet is that without the first
    // vertex, by rows, and the first cofacet that whose vertex beside the face is the first. Where all facets of one
    // and all cofacets of the other are this node's, cancel_pairs() would find them as they stand, so they are found
    // here and need not be sorted.
    Status find_mates() {
        const PieceJob& job = piece_.job;
        Status status = Status::ok;
        if (job.keep_zero != 0) return status;
        for (std::uint32_t k = 2; k <= top() && status == Status::ok; ++k) status = match(k);
        if (status == Status::ok && job.has_cells()) status = lead_beyond();
        return status;
    }
    Status match(std::uint32_t k) {
        std::uint32_t* const mate = mate_[k - 1] = arena_.take_low<std::uint32_t>(face_count(k - 1));
        std::uint8_t* const is_end = is_end_[k] = arena_.take_low<std::uint8_t>(face_count(k));
        const HighScope scope(arena_);
        std::uint32_t* const first = arena_.take_high<std::uint32_t>(face_count(k - 1));
        if (mate == nullptr || is_end == nullptr || first == nullptr) return Status::out_of_memory;
        arena_.each(face_count(k - 1), 2, [=](std::uint64_t f) { mate[f] = first[f] = none; });
        const double *const value = of_.value[k], *const below = of_.value[k - 1];
        // Of facets of equal value: act(facet, row of the vertex that it is without).
        const auto each_alike = [&](std::uint32_t f, auto act) {
            const std::uint32_t* const facet = facets_of(k, f);
            std::uint32_t vertex[simplex_most], alike = 0;
            for (std::uint32_t i = 0; i <= k; ++i) alike += below[facet[i]] == value[f];
            if (alike == 0) return;
            vertices_of(k, f, vertex);
            for (std::uint32_t i = 0; i <= k; ++i)
                if (below[facet[i]] == value[f]) act(facet[i], of_.row[vertex[i]]);
        };
        arena_.each(face_count(k), 10 * (k + 1), [&](std::uint64_t f) {
            each_alike(static_cast<std::uint32_t>(f), [first](std::uint32_t facet, std::uint32_t without) {
                first[facet] = without < first[facet] ? without : first[facet];
            });
        });
        const bool are_cells = k == dim();
        arena_.each(face_count(k), 10 * (k + 1), [&](std::uint64_t f) {
            std::uint32_t last = none, least = none;
            each_alike(static_cast<std::uint32_t>(f), [&](std::uint32_t facet, std::uint32_t without) {
                if (without >= least) return;
                least = without;
                last = facet;
            });
            is_end[f] = 0;
            if (last == none || first[last] != least) return;
            if (are_cells ? home_[k - 1][last] != node_ || scope_[k][f] != node_
                          : home_[k][f] != node_ || scope_[k - 1][last] != node_)
                return;
            is_end[f] = 1;
            mate[last] = static_cast<std::uint32_t>(f);
        });
        return Status::ok;
    }
    // A cell that has a mate belongs to what is beyond that: beyond_[cell], itself for others.
    Status lead_beyond() {
        const std::uint32_t outside = face_count(dim());
        std::uint32_t* const beyond = beyond_ = arena_.take_low<std::uint32_t>(std::size_t{outside} + 1);
        if (beyond == nullptr) return Status::out_of_memory;
        arena_.each(outside, 2, [&](std::uint64_t c) {
            beyond[c] = is_end_[dim()][c] != 0 ? outside : static_cast<std::uint32_t>(c);
        });
        beyond[outside] = outside;
        arena_.each(outside, 6 * (dim() + 1), [&](std::uint64_t c) {
            const std::uint32_t* const facet = facets_of(dim(), c);
            for (std::uint32_t i = 0; i <= dim(); ++i) {
                const std::uint32_t other = mate_[dim() - 1][facet[i]];
                if (other != none && other != c) beyond[other] = static_cast<std::uint32_t>(c);
            }
        });
        return Status::ok;
    }

    std::uint32_t root_of(std::uint32_t c) const { return beyond_ == nullptr ? c : find_root(beyond_, c); }
    // Begins a class of zero length.
    bool is_begin(std::uint32_t k, std::uint32_t f) const { return mate_[k] != nullptr && mate_[k][f] != none; }
    // In such a pair, and not listed: all but rows of boundaries, which other columns may have.
    bool is_gone(std::uint32_t k, std::uint32_t f) const {
        return (is_end_[k] != nullptr && is_end_[k][f] != 0) || (piece_.job.has_sides(k) && is_begin(k, f));
    }
    // A boundary that columns are reduced by here.
    bool is_column(std::uint32_t k, std::uint32_t f) const { return home_[k][f] == node_ && !is_begin(k, f); }

    // Listed by this node as what will be a column, here or at a join above.
    bool is_original(std::uint32_t k, std::uint32_t f) const {
        const PieceNode home = home_[k][f];
        return home == node_ || (home != no_piece && depth_of(home) < depth_of(node_) && place_[k][f] == own_first);
    }

    Status list() {
        const PieceJob& job = piece_.job;
        std::uint8_t* listed[simplex_most] = {};
        for (std::uint32_t k = 0; k <= top(); ++k) {
            listed[k] = arena_.take_low<std::uint8_t>(face_count(k));
            number_[k] = arena_.take_low<std::uint32_t>(face_count(k));
            if (listed[k] == nullptr || number_[k] == nullptr) return Status::out_of_memory;
            arena_.each(face_count(k), 4, [&](std::uint64_t f) {
                const bool original = is_original(k, static_cast<std::uint32_t>(f));
                listed[k][f] = original && !is_gone(k, static_cast<std::uint32_t>(f));
                piece_.simplices += original;
            });
        }
        // Rows that are at home elsewhere.
        for (std::uint32_t k = 1; k <= top(); ++k) {
            if (job.is_middle(k))
                arena_.each(face_count(k), 6, [&](std::uint64_t f) {
                    if (!is_column(k, static_cast<std::uint32_t>(f))) return;
                    const std::uint32_t* const facet = facets_of(k, f);
                    for (std::uint32_t i = 0; i <= k; ++i)
                        if (!is_gone(k - 1, facet[i])) listed[k - 1][facet[i]] = 1;
                });
            if (k == dim())
                arena_.each(face_count(k), 6, [&](std::uint64_t c) {
                    const std::uint32_t* const facet = facets_of(k, c);
                    for (std::uint32_t i = 0; i <= k; ++i) {
                        if (!is_original(k - 1, facet[i]) || is_gone(k - 1, facet[i])) continue;
                        const std::uint32_t root = root_of(static_cast<std::uint32_t>(c));
                        if (root != face_count(k)) listed[k][root] = 1;
                    }
                });
        }
        for (std::uint32_t k = 0; k <= top(); ++k) {
            const Status status = put_in_order(k, listed[k]);
            if (status != Status::ok) return status;
        }
        for (std::uint32_t k = 1; k <= top(); ++k) {
            const Status status = make_columns(k);
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }

    Status put_in_order(std::uint32_t k, const std::uint8_t* listed) {
        std::uint32_t count = 0;
        for (std::uint32_t f = 0; f < face_count(k); ++f) count += listed[f];
        PieceSimplices& s = piece_.of[k];
        s.count = count;
        s.value = arena_.take_low<double>(count);
        face_[k] = arena_.take_low<std::uint32_t>(count);
        s.home = arena_.take_low<PieceNode>(count);
        s.scope = arena_.take_low<PieceNode>(count);
        s.state = arena_.take_low<std::uint8_t>(count);
        std::uint32_t* const face = face_[k];
        if (s.value == nullptr || s.home == nullptr || s.scope == nullptr || s.state == nullptr || face == nullptr)
            return Status::out_of_memory;
        const auto is_listed = [listed](std::uint32_t f) { return listed[f] != 0; };
        if (!sort_listed(of_.value[k], face_count(k), is_listed, s.value, face, arena_)) return Status::out_of_memory;
        order_alike(k, s.value, face, count);
        arena_.each(face_count(k), 1, [&](std::uint64_t f) { number_[k][f] = none; });
        arena_.each(count, 30, [&](std::uint64_t i) {
            constexpr std::uint64_t far = 24;
            if (jumps_matter && i + far < count) {
                const std::uint32_t later = face[i + far];
                prefetch(number_[k] + later);
                prefetch(home_[k] + later);
                prefetch(scope_[k] + later);
            }
            const std::uint32_t f = face[i];
            number_[k][f] = static_cast<std::uint32_t>(i);
            s.home[i] = home_[k][f];
            s.scope[i] = scope_[k][f];
            s.state[i] = state_of(k, f);
        });
        return Status::ok;
    }
    // Vertices of what stays, by which other pieces know it.
    Status name_simplices() {
        for (std::uint32_t k = 0; k <= top(); ++k) {
            PieceSimplices& s = piece_.of[k];
            s.vertices = arena_.take_low<std::uint32_t>(std::size_t{s.count} * (k + 1));
            if (s.vertices == nullptr) return Status::out_of_memory;
            arena_.each(s.count, 6, [&](std::uint64_t i) {
                if ((s.state[i] & (piece_state::column | piece_state::row)) != 0)
                    rows_of(k, face_[k][i], s.vertices + i * (k + 1));
            });
        }
        return Status::ok;
    }
    std::uint8_t state_of(std::uint32_t k, std::uint32_t f) const {
        if (!is_original(k, f)) return piece_state::row;
        return static_cast<std::uint8_t>(piece_state::original | (k > 0 && !is_begin(k, f) ? piece_state::column : 0) |
                                         (k < top() ? piece_state::row : 0));
    }
    // The rows of a face's vertices, ascending.
    void rows_of(std::uint32_t k, std::uint32_t f, std::uint32_t* row) const {
        vertices_of(k, f, row);
        for (std::uint32_t i = 0; i <= k; ++i) row[i] = of_.row[row[i]];
        insertion_sort(row, k + 1, Ascending{});
    }
    // Puts faces of equal value in the order of their vertices.
    void order_alike(std::uint32_t k, const double* value, std::uint32_t* face, std::uint32_t count) {
        for (std::uint32_t begin = 0, end; begin < count; begin = end) {
            end = begin + 1;
            while (end < count && value[end] == value[begin]) arena_.step(++end, 2);
            if (end - begin == 1) continue;
            sort(
                face + begin, end - begin,
                [&](std::uint32_t a, std::uint32_t b) {
                    std::uint32_t of_a[simplex_most], of_b[simplex_most];
                    rows_of(k, a, of_a);
                    rows_of(k, b, of_b);
                    return compare_vertices(of_a, of_b, k + 1) < 0;
                },
                arena_);
        }
    }

    Status make_columns(std::uint32_t k) {
        const PieceJob& job = piece_.job;
        PieceSimplices& s = piece_.of[k];
        if (job.has_ends(k)) {
            s.ends = arena_.take_low<PieceSides>(s.count);
            if (s.ends == nullptr) return Status::out_of_memory;
            each_listed(k, [&](std::uint32_t i, std::uint32_t f) {
                const std::uint32_t* const facet = facets_of(1, f);
                s.ends[i] = {{number_[0][facet[0]], number_[0][facet[1]]}};
            });
        }
        if (job.has_sides(k)) {
            s.sides = arena_.take_low<PieceSides>(s.count);
            if (s.sides == nullptr) return Status::out_of_memory;
            arena_.each(s.count, 1, [&](std::uint64_t i) { s.sides[i] = {{none, none}}; });
            arena_.each(face_count(k + 1), 8 * (k + 1), [&](std::uint64_t index) {
                const auto c = static_cast<std::uint32_t>(index);
                const std::uint32_t root = root_of(c);
                const std::uint32_t number = root == face_count(k + 1) ? std::uint32_t{none} : number_[k + 1][root];
                const std::uint32_t* const facet = facets_of(k + 1, c);
                for (std::uint32_t j = 0; j <= k + 1 && number != none; ++j) {
                    const std::uint32_t i = number_[k][facet[j]];
                    if (i == none) continue;
                    s.sides[i].of[s.sides[i].of[0] == none ? 0 : 1] = number;
                }
            });
        }
        return job.is_middle(k) ? make_boundaries(k) : Status::ok;
    }
    Status make_boundaries(std::uint32_t k) {
        PieceSimplices& s = piece_.of[k];
        std::uint32_t matched = 0;
        if (is_end_[k] != nullptr) arena_.each(face_count(k), 1, [&](std::uint64_t f) { matched += is_end_[k][f]; });
        const std::size_t count = std::size_t{s.count} + matched;
        s.columns = arena_.take_low<PieceColumn>(count);
        s.matched = arena_.take_low<std::uint32_t>(matched);
        std::uint32_t* rows = arena_.take_low<std::uint32_t>(count * (k + 1));
        if (s.columns == nullptr || s.matched == nullptr || rows == nullptr) return Status::out_of_memory;
        s.matched_count = matched;
        const auto put = [&](std::uint32_t i, std::uint32_t f) {
            const std::uint32_t* const facet = facets_of(k, f);
            s.columns[i] = {rows, 0};
            for (std::uint32_t j = 0; j <= k && is_column(k, f); ++j)
                if (number_[k - 1][facet[j]] != none) rows[s.columns[i].count++] = number_[k - 1][facet[j]];
            rows += s.columns[i].count;
        };
        each_listed(k, put);
        if (matched == 0) return Status::ok;
        std::uint32_t next = 0;
        arena_.each(face_count(k - 1), 4, [&](std::uint64_t f) {
            if (mate_[k - 1][f] == none) return;
            s.matched[next] = number_[k - 1][f];
            put(s.count + next++, mate_[k - 1][f]);
        });
        return Status::ok;
    }
    // act(number, face)
    template <class Act> void each_listed(std::uint32_t k, Act act) {
        arena_.each(face_count(k), 8 * (k + 1), [&](std::uint64_t f) {
            if (number_[k][f] != none) act(number_[k][f], static_cast<std::uint32_t>(f));
        });
    }

    const LeafRequest& request_;
    Arena& arena_;
    const Work& work_;
    const PieceNode node_;
    Piece piece_ = {};
    LeafFaces of_ = {};
    PieceNode *home_[simplex_most] = {}, *scope_[simplex_most] = {};
    // Of faces: all vertices are the node's own; some are, and no other is of a node before it; else.
    enum Place : std::uint8_t { elsewhere, own_first, all_own };
    std::uint8_t* place_[simplex_most] = {};
    std::uint32_t* face_[simplex_most] = {};    // of those that are listed
    std::uint32_t* number_[simplex_most] = {};  // of faces among those that are listed
    // Of pairs of zero length: the coface that a face is paired with; whether a face is such a coface; cells.
    std::uint32_t *mate_[simplex_most] = {}, *beyond_ = nullptr;
    std::uint8_t* is_end_[simplex_most] = {};
};

}  // namespace

Status make_leaf(const LeafRequest& request, const Work& work, PieceBytes* out, StarsReport* report) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    const Status status = Leaf(request, work).run(out, report);
    work.arena.release_high(high);
    work.arena.release_low(low);
    return status == Status::ok ? move_piece_down(work.arena, out) : status;
}

}  // namespace netmesh
