#include "pieces/collect.hpp"

#include "homology/bit_set.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/callback.hpp"

namespace netmesh {
namespace {

// Its head.
Status read_head(const netmesh_collect_request& pieces, std::size_t i, Piece* out, const char** fault) {
    netmesh_piece piece = {};
    if (pieces.pieces != nullptr) {
        piece = pieces.pieces[i];
    } else {
        const netmesh_status status = open_piece(pieces.open, pieces.user, i, &piece);
        if (status != NETMESH_OK) return static_cast<Status>(status);
    }
    PieceSize size;
    *fault = is_piece_aligned(piece) ? read_piece_head(piece.bytes, piece.count, out, &size) : piece_not_aligned;
    return *fault == nullptr ? Status::ok : Status::invalid_argument;
}

// Bars of all pieces in the short form: they are opened twice, first to count, so that each bar has its place at once.
class Collecting {
public:
    Collecting(const netmesh_collect_request& pieces, const Work& work, PieceJob* job, CountedPairs* out,
               const char** fault, std::size_t* at)
        : pieces_(pieces), arena_(work.arena), monitor_(work.monitor), job_(*job), out_(*out), fault_(*fault),
          at_(*at) {}

    Status run() {
        monitor_.begin(NETMESH_STAGE_REDUCE, 2 * pieces_.count);
        std::uint64_t* const counts = arena_.take_low<std::uint64_t>(BarList::counts);
        if (counts == nullptr) return Status::out_of_memory;
        for (std::size_t degree = 0; degree < BarList::counts; ++degree) counts[degree] = 0;
        Status status = each_piece([counts](const Pair& bar) { ++counts[bar.degree]; });
        if (status != Status::ok) return status;
        if (pieces_.count != 2 * std::size_t{job_.pieces} - 1) return refused("pieces of some nodes are missing");
        std::uint64_t all = 0, place[BarList::counts];
        for (std::size_t degree = 0; degree < BarList::counts; ++degree) {
            place[degree] = all;
            all += counts[degree];
        }
        Bar* const bars = all < SIZE_MAX ? arena_.take_low<Bar>(static_cast<std::size_t>(all)) : nullptr;
        if (bars == nullptr) return Status::out_of_memory;
        // What is opened again may have changed.
        std::uint64_t had[BarList::counts] = {};
        status = each_piece([&](const Pair& bar) {
            if (had[bar.degree]++ < counts[bar.degree]) bars[place[bar.degree]++] = {bar.birth, bar.death};
        });
        if (status != Status::ok) return status;
        for (std::size_t degree = 0; degree < BarList::counts; ++degree) {
            if (had[degree] != counts[degree]) return refused("a piece is not the one that was counted");
            sort(bars + (place[degree] - counts[degree]), counts[degree], Before{}, arena_);
        }
        out_.pairs = {reinterpret_cast<Pair*>(bars), all};
        return Status::ok;
    }

private:
    struct Bar {
        double birth, death;
    };
    struct Before {
        bool operator()(const Bar& a, const Bar& b) const {
            return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
        }
    };

    Status refused(const char* fault) {
        fault_ = fault;
        return Status::invalid_argument;
    }
    // Visits the bars of all pieces, and looks whether these go together.
    template <class Visit> Status each_piece(Visit&& visit) {
        const HighScope scope(arena_);
        BitSet seen;
        for (at_ = 0; at_ < pieces_.count; ++at_) {
            Piece piece;
            const Status status = read_head(pieces_, at_, &piece, &fault_);
            if (status != Status::ok) return status;
            if (at_ == 0) {
                if (job_.pieces == 0) job_ = piece.job;
                std::uint64_t* const words = arena_.take_high<std::uint64_t>(BitSet::words_needed(2 * job_.pieces));
                if (words == nullptr) return Status::out_of_memory;
                seen.adopt(words, 2 * job_.pieces);
            }
            if (!(piece.job == job_)) return refused("the piece is of another job than the first one");
            if (seen.has(piece.node)) return refused("the piece is of a node that was there before");
            seen.insert(piece.node);
            for (std::uint64_t i = 0; i < piece.bar_count; ++i) {
                const Pair bar = piece.bars[i];
                if (!(bar.birth <= bar.death) || bar.degree > job_.max_degree || bar.degree >= BarList::counts)
                    return refused("the piece has a bar that is none");
                visit(Pair{bar.birth + 0.0, bar.death + 0.0, bar.degree, 0});  // no negative zeros
                arena_.step(i, 10);
            }
            if (piece.node == root_piece) out_.simplices = piece.simplices;
            if (monitor_.advance(at_, 10)) return Status::cancelled;
        }
        return Status::ok;
    }

    const netmesh_collect_request& pieces_;
    Arena& arena_;
    Monitor& monitor_;
    PieceJob& job_;
    CountedPairs& out_;
    const char*& fault_;
    std::size_t& at_;
};

}  // namespace

Status collect_pieces(const netmesh_collect_request& pieces, const Work& work, PieceJob* job, CountedPairs* out,
                      const char** fault, std::size_t* at) {
    ArenaScope scope(work.arena);
    *out = CountedPairs{};
    *fault = nullptr;
    *at = 0;
    const Status status = Collecting(pieces, work, job, out, fault, at).run();
    if (status == Status::ok) scope.keep_low_from_now();
    return status;
}

}  // namespace netmesh
