// Pieces. Bytes to a cloud of near-degenerate points, cut into 2 to 8 pieces: the diagram of one block, or the status
// of one block. And bytes to changes of a piece whose checksums are then made right: whatever it says, joining and
// collecting it end with a status and touch nothing but what is theirs.
#include <cstring>
#include <map>
#include <vector>

#include "fuzz/decoder.hpp"
#include "numerics/fingerprint.hpp"
#include "pieces/in_memory.hpp"

namespace {

using fuzz::require;
using pieces::Bytes;

void compare_with_one_block(fuzz::Tape& tape) {
    const int dim = 2 + static_cast<int>(tape.below(3));
    pieces::Options options;
    options.pieces = 2u << tape.below(3);
    options.max_degree = tape.below(4);
    options.keep_zero = tape.below(2);
    options.order = 1 + tape.byte();
    inputs::Points points;
    while (!tape.empty() && points.size() < 40u * static_cast<unsigned>(dim))
        points.push_back(fuzz::coordinate(tape.byte()));
    points.resize(points.size() / static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim));
    const pieces::Split split(dim, points, options.pieces);
    if (split.status != NETMESH_OK) return;
    Session whole(dim), session(dim);
    netmesh::Request request = whole.alpha_request(points);
    request.max_degree = options.max_degree;
    request.keep_zero_pairs = options.keep_zero;
    const netmesh_status status = whole.persist_until_it_fits(request);
    std::map<std::uint32_t, Bytes> all;
    require(pieces::run(session, split.source, options, &all) == status);
    if (status == NETMESH_OK) require(session.report().fingerprint == whole.report().fingerprint);
}

// Four pieces of points in space, with their joins.
const std::map<std::uint32_t, Bytes>& job(int dim) {
    static std::map<int, std::map<std::uint32_t, Bytes>> jobs;
    std::map<std::uint32_t, Bytes>& all = jobs[dim];
    if (!all.empty()) return all;
    const pieces::Split split(dim, inputs::uniform(dim, 60, 7), 4);
    Session session(dim);
    require(pieces::run(session, split.source, pieces::Options{}, &all) == NETMESH_OK);
    return all;
}

netmesh_status status_of(const Bytes& bytes, netmesh_piece_info* info) {
    *info = {};
    info->struct_bytes = sizeof *info;
    const netmesh_piece piece = bytes.piece();
    return netmesh_read_piece(&piece, info);
}

// As residual.cpp lays it out: checksums of what follows in the head, and of the body.
void make_checksums_right(Bytes& bytes, std::size_t head) {
    const auto sum = [&bytes](std::size_t begin, std::size_t end) {
        netmesh::Fingerprint sum_of;
        for (std::size_t at = begin; at + 8 <= end; at += 8) {
            std::uint64_t word;
            std::memcpy(&word, bytes.data() + at, 8);
            sum_of.add(word);
        }
        return sum_of.value();
    };
    const std::uint64_t body = sum(head, bytes.count());
    std::memcpy(bytes.data() + 24, &body, 8);
    const std::uint64_t first = sum(24, head);
    std::memcpy(bytes.data() + 16, &first, 8);
}

void forge(fuzz::Tape& tape) {
    const std::map<std::uint32_t, Bytes>& all = job(2 + static_cast<int>(tape.below(3)));
    const std::uint32_t node = 2 + tape.below(6);
    Bytes bad = all.at(node);
    netmesh_piece_info info;
    require(status_of(bad, &info) == NETMESH_OK);
    const std::size_t head = static_cast<std::size_t>(info.head_bytes), body = bad.count() - head;
    do {
        const std::uint32_t how = tape.byte(), place = tape.byte() | tape.byte() << 8u, by = tape.byte();
        std::size_t at = how % 8 == 0   ? 32 + place % (head - 32)
                         : how % 8 == 1 ? 32 + place % 256
                                        : head + place % body;
        if (at >= bad.count()) at = bad.count() - 1;
        std::uint32_t word;
        at = at / 4 * 4;
        std::memcpy(&word, bad.data() + at, 4);
        switch (how / 8 % 4) {
        case 0: word += by - 128; break;
        case 1: word = by; break;
        case 2: word ^= 1u << by % 32; break;
        default: word = 0xFFFFFFFFu; break;
        }
        std::memcpy(bad.data() + at, &word, 4);
    } while (tape.left() >= 4);
    make_checksums_right(bad, head);
    status_of(bad, &info);
    Session session(2);
    Bytes joined;
    const netmesh_status status = make_join(session, bad, all.at(node ^ 1), &joined);
    require(status == NETMESH_OK || status == NETMESH_INVALID_ARGUMENT || status == NETMESH_INTERNAL ||
            status == NETMESH_OUT_OF_MEMORY);
    std::map<std::uint32_t, Bytes> with = all;
    with[node] = bad;
    const netmesh_status collected = pieces::collect(session, with);
    require(collected == NETMESH_OK || collected == NETMESH_INVALID_ARGUMENT);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    tape.byte() % 2 == 0 ? compare_with_one_block(tape) : forge(tape);
    return 0;
}
