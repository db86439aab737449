// Components of sublevel sets of vertices, and of superlevel sets of the closed sphere (triangulated_ball.hpp), from
// one link vertex for each piece of a lower or upper link: degree 0 and, by duality, degree D-1.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/cycles/cycle_writer.hpp"
#include "homology/pair_writer.hpp"
#include "homology/union_find.hpp"
#include "memory/arena.hpp"
#include "memory/prefetch.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

// One join for each piece of a link beyond the first: the vertex of that rank is joined to a vertex of the piece,
// which is never `outside`, since the piece that holds it counts as the first of the upper link. Grows at the arena's
// high end, where nothing else may be taken as long as it grows.
class JoinList {
public:
    struct Join {
        std::uint32_t vertex, rank;
        std::uint64_t key() const { return std::uint64_t{rank} << 32 | vertex; }
    };
    explicit JoinList(Arena& arena) : arena_(arena), top_(arena.high_mark()) {}

    bool add(std::uint32_t rank, std::uint32_t vertex) {
        if (count_ % 2 == 0 && arena_.take_high<Join>(2) == nullptr) return false;
        ++count_;
        *first() = Join{vertex, rank};
        return true;
    }
    void sort_by_rank() {
        sort_alike(
            first(), count_, [](const Join& a, const Join& b) { return a.key() < b.key(); }, arena_);
    }
    std::size_t count() const { return count_; }
    const Join& operator[](std::size_t i) const { return first()[i]; }

private:
    Join* first() const { return reinterpret_cast<Join*>(arena_.at(top_ - count_ * sizeof(Join))); }

    Arena& arena_;
    std::size_t top_, count_ = 0;
};

// Order of vertices and the births of those that enter before their lower star.
struct VertexOrder {
    const double* value;
    const std::uint32_t* order;
    std::uint32_t count;
    std::uint32_t zero_born_count;
    double birth(std::uint32_t v) const { return v < zero_born_count ? 0.0 : value[v]; }
};

// Notes a pair of degree 0 and the vertices of its cycle, if cycles are wanted. False: out of memory.
inline bool note_component(double birth, double death, std::uint32_t vertex, std::uint32_t older, PairWriter& writer,
                           CycleWriter* cycles) {
    std::uint32_t cycle = 0;
    if (cycles != nullptr && writer.keeps(birth, death, 0)) {
        std::uint32_t* const vertices = cycles->append(older == none ? 1 : 2, 0, &cycle);
        if (vertices == nullptr) return false;
        vertices[0] = vertex;
        if (older != none) vertices[1] = older;
    }
    return writer.add(birth, death, 0, cycle);
}

// Degree 0. below[v]: a lower link vertex of v, none if there is none, vertices.count if v is absent, which is no
// vertex at all then; becomes the union-find. joins: sorted by rank; those to lower vertices count. cycles: null when
// none are wanted. False: out of memory.
inline bool join_sublevel(const VertexOrder& vertices, std::uint32_t* below, const JoinList* const* joins, int lists,
                          const std::uint32_t* rank, PairWriter& writer, CycleWriter* cycles = nullptr) {
    constexpr std::uint32_t ahead = 16;
    std::size_t next[2] = {0, 0};
    const auto join = [&](std::uint32_t older, std::uint32_t younger, double time) {
        const auto is_older = [&](std::uint32_t x, std::uint32_t y) {
            const double tx = vertices.birth(x), ty = vertices.birth(y);
            return tx < ty || (tx == ty && x < y);
        };
        if (!unite(below, older, younger, is_older)) return true;
        return note_component(vertices.birth(younger), time, younger, older, writer, cycles);
    };
    for (std::uint32_t r = 0; r < vertices.count; ++r) {
        writer.arena().step(r, 60);
        if (vertices.count - r > ahead) {
            prefetch(below + vertices.order[r + ahead]);
            prefetch(vertices.value + vertices.order[r + ahead]);
        }
        const std::uint32_t v = vertices.order[r], u = below[v];
        const double time = vertices.value[v];
        if (u == vertices.count) continue;
        if (u == none) {
            below[v] = v;
        } else if (v < vertices.zero_born_count) {
            below[v] = v;
            if (!join(v, u, time)) return false;
        } else if (!writer.add(time, time, 0)) {
            return false;
        }
        for (int l = 0; l < lists; ++l) {
            for (; next[l] < joins[l]->count() && (*joins[l])[next[l]].rank == r; ++next[l]) {
                const std::uint32_t u2 = (*joins[l])[next[l]].vertex;
                if (rank[u2] < r && !join(v, u2, time)) return false;
            }
        }
    }
    for (std::uint32_t v = 0; v < vertices.count; ++v) {
        writer.arena().step(v, 10);
        if (below[v] == v && !note_component(vertices.birth(v), __builtin_inf(), v, none, writer, cycles)) return false;
    }
    return true;
}

// Degree D-1, where every piece of every upper link has its join: above[v] and joins to higher vertices, downwards.
// outside == vertices.count is above all; above[outside] == outside.
inline bool join_superlevel(const VertexOrder& vertices, const std::uint32_t* rank, std::uint32_t* above,
                            const JoinList& joins, std::uint32_t degree, PairWriter& writer) {
    const std::uint32_t outside = vertices.count;
    const auto is_older = [&](std::uint32_t x, std::uint32_t y) {
        return y != outside && (x == outside || rank[x] > rank[y]);
    };
    std::size_t next = joins.count();
    for (std::uint32_t r = vertices.count; r-- > 0;) {
        writer.arena().step(r, 60);
        for (; next > 0 && joins[next - 1].rank == r; --next) {
            const std::uint32_t u = joins[next - 1].vertex;
            if (rank[u] < r) continue;
            std::uint32_t older = vertices.order[r], younger = u;
            if (!unite(above, older, younger, is_older)) continue;
            if (!writer.add(vertices.value[vertices.order[r]], vertices.value[younger], degree)) return false;
        }
    }
    return true;
}

}  // namespace netmesh
