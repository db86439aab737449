// Which domain a vertex is in while a hierarchical mesh grows.
#pragma once
#include <cstdint>

#include "mesh/cages/cage.hpp"

namespace netmesh {

// Of an input p that is to be inserted, Omega being its domain.
struct NearestInDomain {
    VertexId vertex = none;     // its nearest neighbour u in M_Omega
    double nearest2 = 0;        // squared distance from u to the nearest vertex of M_Omega
    std::uint32_t cage = none;  // the cage in Omega that has u for its centre, if one does
};

// The cages, and which domain each input is in, whatever the dimension is.
class CageForest {
public:
    Cage& cage(std::uint32_t d) {
        NETMESH_ASSERT(d < made_);
        return cages_[d];
    }
    Cage* cages() const { return cages_; }
    std::uint32_t made() const { return made_; }
    std::uint32_t live() const { return live_; }
    bool is_live(std::uint32_t d) const { return cages_[d].shell != none; }

    // A cage about near.vertex and, if there is one, the cage that it is the centre of. Each cage is made for the
    // insertion of an input, so there is room for all.
    std::uint32_t make(const NearestInDomain& near, double radius, std::uint32_t parent, std::uint32_t shell) {
        const std::uint32_t d = made_++;
        cages_[d] = {near.vertex, parent, shell, none, radius, near.nearest2, cage_epsilon * radius};
        ++live_;
        (near.cage != none ? cages_[near.cage].parent : domain_[near.vertex]) = d;
        return d;
    }
    void release(std::uint32_t d) {
        cages_[d].shell = none;
        --live_;
    }

    // The domain around domain d, and d itself or what has taken its place.
    std::uint32_t parent(std::uint32_t d) { return cages_[d].parent = present(cages_[d].parent); }
    std::uint32_t present(std::uint32_t d) const {
        while (d != none && !is_live(d)) d = cages_[d].parent;
        return d;
    }
    // That of an input, inserted or not, as far as it is known.
    std::uint32_t of_input(std::uint32_t input) const { return present(domain_[input]); }
    void set(std::uint32_t input, std::uint32_t d) { domain_[input] = d; }
    // That of an inserted vertex of the store.
    template <int D> std::uint32_t of_vertex(const Store<D>& store, std::uint32_t v) {
        if (live_ == 0) return none;
        const Vertex<D>& vertex = store.vertex(v);
        std::uint32_t& near = domain_[vertex.marker == Marker::input ? v : vertex.origin];
        std::uint32_t d = near = present(near);
        while (d != none && !is_inside(store, cages_[d], vertex.x)) d = parent(d);
        return d;
    }

    // Moves the cages that are left to the front; parents are named by their new places. Their number.
    std::uint32_t keep_live(const Arena& arena) {
        std::uint32_t kept = 0, out = 0;
        for (std::uint32_t d = 0; d < made_;)
            for (const std::uint64_t piece = arena.piece(d, made_, 15); d < piece; ++d) {
                if (!is_live(d)) continue;
                parent(d);
                cages_[d].next = kept++;
            }
        for (std::uint32_t d = 0; d < made_;)
            for (const std::uint64_t piece = arena.piece(d, made_, 15); d < piece; ++d) {
                if (is_live(d) && cages_[d].parent != none) cages_[d].parent = cages_[cages_[d].parent].next;
            }
        for (std::uint32_t d = 0; out < kept; ++d) {
            arena.step(d, 20);
            if (!is_live(d)) continue;
            cages_[out] = cages_[d];
            cages_[out++].next = none;
        }
        return kept;
    }

protected:
    Cage* cages_;
    std::uint32_t* domain_;  // of each input; of one not inserted yet the innermost known
    std::uint32_t made_ = 0, live_ = 0;
};

// Nothing but inputs remembers its domain: that of any other vertex is found from its nearest input, whose domains
// from the innermost outwards contain it from some one on.
template <int D> class Hierarchy : public CageForest {
public:
    static constexpr std::size_t input_bytes = sizeof(Cage) + sizeof(std::uint32_t);  // what open places for each input

    // For meshes of up to `inputs` inputs, at the arena's low end, the cages first. out_of_memory.
    Status open(const Store<D>& store, Arena& arena, std::uint32_t inputs) {
        [[maybe_unused]] const std::size_t low = arena.low_mark();
        store_ = &store;
        cages_ = arena.take_low<Cage>(inputs);
        domain_ = arena.take_low<std::uint32_t>(inputs);
        if (cages_ == nullptr || domain_ == nullptr) return Status::out_of_memory;
        NETMESH_ASSERT(arena.low_mark() - low <= input_bytes * inputs + 2 * Arena::alignment);
        for (std::uint32_t v = 0; v < inputs; ++v) domain_[v] = none;
        return Status::ok;
    }

    bool contains(std::uint32_t d, const double* x) const { return d == none || is_inside(*store_, cages_[d], x); }

    // The domain of an inserted vertex.
    std::uint32_t of(std::uint32_t v) { return of_vertex(*store_, v); }
    // Sets the domain of input p, `nearest` being the vertex nearest to it. `passed` counts the cages on the way out.
    NearestInDomain locate(VertexId p, VertexId nearest, std::uint64_t* passed) {
        NearestInDomain near = {nearest, store_->vertex(nearest).nearest2, none};
        std::uint32_t d = of(nearest);
        for (; !contains(d, store_->point(p)); d = parent(d), ++*passed) near.cage = d;
        domain_[p] = d;
        if (near.cage == none) return near;
        return {VertexId(cages_[near.cage].centre), cages_[near.cage].nearest2, near.cage};
    }

private:
    const Store<D>* store_;
};

}  // namespace netmesh
