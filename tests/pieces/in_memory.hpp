// A diagram in pieces, everything in memory: what a scheduler does, in a chosen order.
#pragma once
#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/session.hpp"

namespace pieces {

// Bytes at an 8-byte aligned address.
class Bytes {
public:
    Bytes() = default;
    Bytes(const void* from, std::size_t count) : words_((count + 7) / 8), count_(count) {
        if (count > 0) std::memcpy(words_.data(), from, count);
    }
    netmesh_piece piece() const { return {words_.data(), count_}; }
    unsigned char* data() { return reinterpret_cast<unsigned char*>(words_.data()); }
    std::size_t count() const { return count_; }
    bool operator==(const Bytes& b) const {
        return count_ == b.count_ && std::memcmp(words_.data(), b.words_.data(), count_) == 0;
    }

private:
    std::vector<std::uint64_t> words_;
    std::size_t count_ = 0;
};

// Points that have been split, and a source of them.
class Split {
public:
    // pieces: a power of 2
    Split(int dim, const inputs::Points& points, std::uint32_t pieces) : dim_(static_cast<std::size_t>(dim)) {
        Session session(dim);
        netmesh_split_request r = {};
        r.struct_bytes = sizeof r;
        r.pieces = pieces;
        r.points = {points.data(),
                    points.size() / dim_,
                    static_cast<std::uint32_t>(dim),
                    NETMESH_POINTS_FLOAT64,
                    0,
                    nullptr,
                    0};
        status = session.until_it_fits(0, [&] { return netmesh_split(session.context, &r); });
        if (status != NETMESH_OK) return;
        netmesh_split_result result = {};
        result.struct_bytes = sizeof result;
        netmesh_get_split(session.context, &result);
        rows_.assign(result.order, result.order + result.count);
        boxes_.assign(result.boxes, result.boxes + result.box_count * 2 * dim_);
        for (const std::uint32_t row : rows_)
            for (std::size_t k = 0; k < dim_; ++k) points_.push_back(points[row * dim_ + k] + 0.0);
        source.struct_bytes = sizeof source;
        source.dim = result.dim;
        source.count = result.count;
        source.rows = result.rows;
        source.fingerprint = result.fingerprint;
        source.levels = result.levels;
        source.read = read;
        source.box = box;
        source.user = this;
    }
    Split(const Split&) = delete;
    Split& operator=(const Split&) = delete;

    netmesh_status status = NETMESH_OK;
    netmesh_source source = {};
    std::uint64_t reads = 0;

private:
    static netmesh_status read(void* user, std::uint64_t first, std::uint32_t count, double* points,
                               std::uint32_t* rows) {
        Split& s = *static_cast<Split*>(user);
        ++s.reads;
        std::memcpy(points, &s.points_[first * s.dim_], count * s.dim_ * sizeof(double));
        std::memcpy(rows, &s.rows_[first], count * sizeof(std::uint32_t));
        return NETMESH_OK;
    }
    static netmesh_status box(void* user, std::uint32_t node, double* to) {
        const Split& s = *static_cast<const Split*>(user);
        std::memcpy(to, &s.boxes_[(node - 1) * 2 * s.dim_], 2 * s.dim_ * sizeof(double));
        return NETMESH_OK;
    }
    std::size_t dim_;
    std::vector<double> points_, boxes_;
    std::vector<std::uint32_t> rows_;
};

struct Options {
    std::uint32_t pieces = 4, max_degree = 255, keep_zero = 0;
    std::uint64_t order = 0;  // of tasks: 0 leaves first, else a shuffle
};

inline netmesh_status make_leaf(Session& session, const netmesh_source& source, const Options& options,
                                std::uint32_t node, Bytes* out) {
    netmesh_leaf_request r = {};
    r.struct_bytes = sizeof r;
    r.source = &source;
    r.pieces = options.pieces;
    r.node = node;
    r.max_degree = options.max_degree;
    r.keep_zero_pairs = options.keep_zero;
    const netmesh_status status = session.until_it_fits(0, [&] { return netmesh_leaf(session.context, &r); });
    netmesh_piece piece = {};
    if (status == NETMESH_OK && netmesh_get_piece(session.context, &piece) == NETMESH_OK)
        *out = Bytes(piece.bytes, piece.count);
    return status;
}
inline netmesh_status make_join(Session& session, const Bytes& one, const Bytes& other, Bytes* out) {
    netmesh_join_request r = {};
    r.struct_bytes = sizeof r;
    r.one = one.piece();
    r.other = other.piece();
    const netmesh_status status = session.until_it_fits(0, [&] { return netmesh_join(session.context, &r); });
    netmesh_piece piece = {};
    if (status == NETMESH_OK && netmesh_get_piece(session.context, &piece) == NETMESH_OK)
        *out = Bytes(piece.bytes, piece.count);
    return status;
}
inline netmesh_status collect(Session& session, const std::map<std::uint32_t, Bytes>& all) {
    std::vector<netmesh_piece> list;
    for (const auto& [node, bytes] : all) list.push_back(bytes.piece());
    netmesh_collect_request r = {};
    r.struct_bytes = sizeof r;
    r.pieces = list.data();
    r.count = list.size();
    return session.until_it_fits(0, [&] { return netmesh_collect(session.context, &r); });
}

// The session holds the diagram afterwards.
inline netmesh_status run(Session& session, const netmesh_source& source, const Options& options,
                          std::map<std::uint32_t, Bytes>* all) {
    inputs::Random random(options.order);
    std::vector<std::uint32_t> tasks;
    for (std::uint32_t node = 2 * options.pieces - 1; node > 0; --node) tasks.push_back(node);
    for (std::size_t i = tasks.size(); options.order != 0 && i > 1; --i)
        std::swap(tasks[i - 1], tasks[random.below(i)]);
    while (!tasks.empty()) {
        std::vector<std::uint32_t> waiting;
        for (const std::uint32_t node : tasks) {
            netmesh_status status = NETMESH_OK;
            if (node >= options.pieces)
                status = make_leaf(session, source, options, node, &(*all)[node]);
            else if (all->count(2 * node) != 0 && all->count(2 * node + 1) != 0)
                status = node % 2 == 0 ? make_join(session, (*all)[2 * node], (*all)[2 * node + 1], &(*all)[node])
                                       : make_join(session, (*all)[2 * node + 1], (*all)[2 * node], &(*all)[node]);
            else
                waiting.push_back(node);
            if (status != NETMESH_OK) return status;
        }
        tasks.swap(waiting);
    }
    return collect(session, *all);
}

}  // namespace pieces
