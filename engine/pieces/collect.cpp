#include "pieces/collect.hpp"

#include "homology/bit_set.hpp"
#include "homology/pair_writer.hpp"
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

Status gather(const netmesh_collect_request& pieces, const Work& work, PieceJob* job, CountedPairs* out,
              const char** fault, std::size_t* at) {
    Arena& arena = work.arena;
    Piece piece;
    *at = 0;
    Status status = read_head(pieces, 0, &piece, fault);
    if (status != Status::ok) return status;
    *job = piece.job;
    const std::size_t nodes = 2 * std::size_t{job->pieces} - 1;
    BitSet seen;
    std::uint64_t* const words = arena.take_high<std::uint64_t>(BitSet::words_needed(2 * job->pieces));
    if (words == nullptr) return Status::out_of_memory;
    seen.adopt(words, 2 * job->pieces);
    PairWriter writer(arena, {job->max_degree, job->keep_zero != 0});
    work.monitor.begin(NETMESH_STAGE_REDUCE, pieces.count);
    for (;;) {
        if (!(piece.job == *job)) *fault = "the piece is of another job than the first one";
        if (*fault == nullptr && seen.has(piece.node)) *fault = "the piece is of a node that was there before";
        if (*fault != nullptr) return Status::invalid_argument;
        seen.insert(piece.node);
        for (std::uint64_t i = 0; i < piece.bar_count; ++i) {
            const Pair bar = piece.bars[i];
            if (!(bar.birth <= bar.death) || bar.degree > job->max_degree) {
                *fault = "the piece has a bar that is none";
                return Status::invalid_argument;
            }
            if (!writer.add(bar.birth, bar.death, bar.degree)) return Status::out_of_memory;
            arena.step(i, 10);
        }
        if (piece.node == root_piece) out->simplices = piece.simplices;
        if (work.monitor.advance(*at, 10)) return Status::cancelled;
        if (++*at == pieces.count) break;
        status = read_head(pieces, *at, &piece, fault);
        if (status != Status::ok) return status;
    }
    if (pieces.count != nodes) {
        *fault = "pieces of some nodes are missing";
        return Status::invalid_argument;
    }
    out->pairs = writer.finish_without_cycles();
    return Status::ok;
}

}  // namespace

Status collect_pieces(const netmesh_collect_request& pieces, const Work& work, PieceJob* job, CountedPairs* out,
                      const char** fault, std::size_t* at) {
    ArenaScope scope(work.arena);
    *out = CountedPairs{};
    *fault = nullptr;
    const Status status = gather(pieces, work, job, out, fault, at);
    if (status == Status::ok) scope.keep_low_from_now();
    return status;
}

}  // namespace netmesh
