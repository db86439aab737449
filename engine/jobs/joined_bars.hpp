// Bars of several diagrams that are joined, with what is known of each: where its true bar is, and a cycle.
//
// Cycles of different meshes have no vertices in common, and none of those meshes is kept. So a cycle is given by the
// points. Let n_v be the point that is nearest to the vertex v, of those that the mesh was made of. The nerve of the
// cover at b, in which the bar's cycle is, goes to the Cech complex of the points by v -> n_v: if cells (or the balls
// of inputs before) meet in x, then |x - n_v| <= hi_v <= c t_v <= c b for each of them, as hi_v bounds the distance
// from v's cell to n_v; where hi_v is cut at rho, the Cech complex at c t_v >= rho has all simplices. Each set of the
// cover lies in the ball of radius c b about n_v, so that the map of the nerves is that of the spaces: it is the
// inclusion of the cover in the offset at c b, on homology. With c the certified ratio of the joined diagram, the chain
// of a bar (b, d)
//
//     is a cycle of the Cech complex at c b, no boundary there before d / c, and a boundary from c d on.
//
// For were it a boundary at a < d / c, then the bar's class would be 0 in the offset of all points at a, and in the
// cover at c a < d. A chain may be empty where d <= c^2 b. In degree 0 it is one point, or two for a bar that dies.
#pragma once
#include <cstdint>

#include "diagram/pair.hpp"
#include "homology/cycles/cycle_writer.hpp"
#include "homology/cycles/cycles.hpp"
#include "jobs/bar_bounds.hpp"
#include "jobs/join_shift.hpp"

namespace netmesh {

// The image of a chain, simplices of degree + 1 vertices, under v -> name[v]: simplices with two equal names and those
// that come twice drop out. *handle: of the writer, in whose arena nobody else takes low memory. False: out of memory.
bool write_image(const Cycle& chain, std::uint32_t degree, const std::uint32_t* name, Arena& arena, CycleWriter* writer,
                 std::uint32_t* handle);

// What a mesh has found: its bars, and of each what is known. All of it stands below the arena's low mark.
struct MeshBars {
    PairList list;
    BarBounds* bounds;          // [list.count]; `unused`: the chain, 0 without one
    std::size_t chains, steps;  // where they are, and their number of 16 bytes
};

// How many bars have some length.
std::uint64_t count_long(const PairList& list);
// Chains of these, in their order, which is that of the pairs of lower_star_cycles. 36 bytes of scratch a simplex.
// out_of_memory, internal (other pairs).
Status write_images(const Representatives& found, const std::uint32_t* name, Arena& arena, MeshBars* bars);
// Births and deaths of a scale's points become those of all points.
void move_lows(const JoinShift& join, const MeshBars& bars);

class JoinedBars {
public:
    // Bars stand one after the other down from the arena's high end, chains up from its low end.
    void open(const Arena& arena);
    // All of a mesh's bars, or those that are not essential. The arena's low end goes back to behind the chains, its
    // high end is where the last bars left it. False: out of memory.
    bool add(const MeshBars& mesh, bool with_essential, Arena& arena);
    // At the arena's low end, which is free: chains, bars in the canonical order and, unless null, their bounds. The
    // high end stays. False: out of memory.
    bool finish(Arena& arena, CycleStore* chains, PairList* list, BarBounds** bounds) const;

private:
    struct Bar {
        Pair pair;
        BarBounds bounds;
    };
    Bar* at(std::uint32_t i, const Arena& arena) const {
        return reinterpret_cast<Bar*>(arena.at(top_)) - (std::size_t{i} + 1);
    }

    std::size_t top_ = 0, begin_ = 0;
    std::uint32_t count_ = 0, steps_ = 0;
};

}  // namespace netmesh
