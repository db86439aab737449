// Vineyards (thesis 6.3): a sequence of filtrations of one complex, their diagrams, and the path of each bar from one
// to the next. What the complex is and where its values come from is for the caller to say; knows no dimension.
#pragma once
#include <cstdint>

#include "homology/vineyard/vineyard.hpp"
#include "memory/work.hpp"

namespace netmesh {

// A pair of the diagram of one step: where a vine is there. Vines are numbered from 0 by degree, the first step at
// which they have a length, and birth and death there; a vine is listed for the steps at which it has a length only.
struct VinePoint {
    double birth, death;
    std::uint32_t vine, k, degree, unused;  // k: the step
};

struct VineList {
    const double* ratio;      // [steps], certified ratios, at the arena's low end, then the points
    const VinePoint* points;  // [count], by vine, then step
    std::uint64_t count;
    std::uint32_t vine_count;
    std::uint64_t simplices, transpositions;
};

// The filtrations, by number from `first` on.
struct VineSteps {
    std::uint32_t first;
    // Fills value[k][complex.count[k]] with one of them, and its ratio (1 on entry).
    Status (*fill)(void* user, std::uint32_t step, double* const* value, double* ratio);
    void* user;
};

// Room for the result at the arena's low end, below the complex.
class VineRoom {
public:
    explicit VineRoom(Arena& arena) : scope_(arena), arena_(arena) {}
    // steps >= 1. out_of_memory.
    Status open(std::uint32_t steps);
    // Follows the vines of degrees 0..max_degree through all steps. `out` is put at the arena's low end, and everything
    // else that was taken since the room was made is given back; without ok nothing stays. Memory: 84 bytes a simplex
    // of dimension up to max_degree + 1, the columns, and sizeof(VinePoint) for each pair of positive length of each
    // step. out_of_memory, cancelled, what fill says.
    Status follow(const ComplexView& complex, std::uint32_t max_degree, const VineSteps& steps, const Work& work,
                  VineList* out);

private:
    ArenaScope scope_;
    Arena& arena_;
    std::uint32_t count_ = 0;
    double* ratio_ = nullptr;
    std::size_t low_ = 0;
};

// Of a lower-star filtration: gives all simplices above the vertices the largest value of their vertices.
void raise_to_vertices(const ComplexView& complex, double* const* value);

}  // namespace netmesh
