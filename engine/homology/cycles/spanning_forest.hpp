// A spanning forest with the ways between its vertices.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

class SpanningForest {
public:
    // Takes 28 bytes a vertex from the arena's high end. False: out of memory.
    bool reserve(std::uint32_t vertices, Arena& arena) {
        arena_ = &arena;
        vertices_ = vertices;
        parent_ = arena.take_high<std::uint32_t>(vertices);
        parent_edge_ = arena.take_high<std::uint32_t>(vertices);
        depth_ = arena.take_high<std::uint32_t>(vertices);
        queue_ = arena.take_high<std::uint32_t>(vertices);
        start_ = arena.take_high<std::uint32_t>(std::size_t{vertices} + 1);
        incident_ = arena.take_high<std::uint32_t>(2 * std::size_t{vertices});
        return parent_ != nullptr && parent_edge_ != nullptr && depth_ != nullptr && queue_ != nullptr &&
               start_ != nullptr && incident_ != nullptr;
    }

    // The edges e with is_tree(e), which make no circle. ends: [edges][2]. O(vertices + edges).
    template <class IsTree> void grow(const std::uint32_t* ends, std::uint32_t edges, IsTree is_tree) {
        for (std::uint32_t v = 0; v <= vertices_; ++v) {
            arena_->step(v, 5);
            start_[v] = 0;
        }
        for (std::uint32_t e = 0; e < edges;)
            for (const std::uint64_t piece = arena_->piece(e, edges, 20); e < piece; ++e) {
                for (int i = 0; i < 2 && is_tree(e); ++i) ++start_[ends[2 * std::size_t{e} + i]];
            }
        std::uint32_t sum = 0;
        for (std::uint32_t v = 0; v <= vertices_; ++v) {
            arena_->step(v, 5);
            sum += start_[v];
            start_[v] = sum;
        }
        for (std::uint32_t e = 0; e < edges;)
            for (const std::uint64_t piece = arena_->piece(e, edges, 20); e < piece; ++e) {
                for (int i = 0; i < 2 && is_tree(e); ++i) incident_[--start_[ends[2 * std::size_t{e} + i]]] = e;
            }
        for (std::uint32_t v = 0; v < vertices_;)
            for (const std::uint64_t piece = arena_->piece(v, vertices_, 3); v < piece; ++v) {
                parent_[v] = none;
            }
        for (std::uint32_t root = 0; root < vertices_;)
            for (const std::uint64_t piece = arena_->piece(root, vertices_, 5); root < piece; ++root) {
                if (parent_[root] == none) visit(ends, root);
            }
    }

    // Calls f(e) for the edges between two vertices of one tree. O(edges called).
    template <class F> void path(std::uint32_t a, std::uint32_t b, F f) const {
        while (a != b) {
            std::uint32_t& lower = depth_[a] >= depth_[b] ? a : b;
            f(parent_edge_[lower]);
            lower = parent_[lower];
        }
    }

private:
    void visit(const std::uint32_t* ends, std::uint32_t root) {
        std::uint32_t end = 0;
        queue_[end++] = root;
        parent_[root] = root;
        depth_[root] = 0;
        for (std::uint32_t at = 0; at < end;)
            for (const std::uint64_t piece = arena_->piece(at, end, 60); at < piece; ++at) {
                const std::uint32_t v = queue_[at];
                for (std::uint32_t i = start_[v]; i < start_[v + 1]; ++i) {
                    const std::uint32_t* const edge = ends + 2 * std::size_t{incident_[i]};
                    const std::uint32_t u = edge[0] == v ? edge[1] : edge[0];
                    if (parent_[u] != none) continue;
                    parent_[u] = v;
                    parent_edge_[u] = incident_[i];
                    depth_[u] = depth_[v] + 1;
                    queue_[end++] = u;
                }
            }
    }

    const Arena* arena_ = nullptr;
    std::uint32_t vertices_ = 0;
    std::uint32_t *parent_ = nullptr, *parent_edge_ = nullptr, *depth_ = nullptr, *queue_ = nullptr;
    std::uint32_t *start_ = nullptr, *incident_ = nullptr;
};

}  // namespace netmesh
