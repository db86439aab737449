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

// Numbers the vines that have points and sorts the points, which stand in the order of steps. Vines are below
// raw_count. Scratch: 36 bytes a vine. out_of_memory.
Status number_vines(VinePoint* points, std::uint64_t count, std::uint32_t raw_count, Arena& arena, VineList* out);

// The diagrams of one filtration after the other, and the vines between them.
class VineFollower {
public:
    VineFollower(const ComplexView& complex, std::uint32_t max_degree, const Work& work)
        : complex_(complex), max_degree_(max_degree), work_(work) {}

    // Room for the values of two filtrations.
    Status open();
    // value(i)[k][complex.count[k]] is to be filled with the i-th filtration, from 0 on, before it is taken.
    double* const* value(std::uint32_t i) const { return value_[i % 2]; }
    // Leaves the points of this step somewhere above the arena's low mark.
    Status take(std::uint32_t i, std::uint32_t step);
    Status finish(VineList* out);

private:
    bool add(const VinePoint& point);
    bool note(std::uint32_t step, const double* const* value);

    const ComplexView& complex_;
    std::uint32_t max_degree_;
    const Work& work_;
    VinePoint* points_ = nullptr;  // on their way, at the arena's low end
    std::uint64_t count_ = 0;
    double* value_[2][ComplexView::dimension_max + 1] = {};
    Vineyard vineyard_;
};

// Room for the result at the arena's low end, below the complex.
class VineRoom {
public:
    explicit VineRoom(Arena& arena) : scope_(arena), arena_(arena) {}
    // steps >= 1. out_of_memory.
    Status open(std::uint32_t steps);
    double* ratios() const { return ratio_; }  // [steps], to be filled
    // Follows the vines of degrees 0..max_degree through all steps, numbered from `first` on. fill(step, value, ratio)
    // sets the values of a filtration, and its ratio (1 on entry). `out` is put at the arena's low end, and everything
    // else that was taken since the room was made is given back; without ok nothing stays. Memory: 84 bytes a simplex
    // of dimension up to max_degree + 1, the columns, and sizeof(VinePoint) for each pair of positive length of each
    // step. out_of_memory, cancelled, what fill says.
    template <class Fill>
    Status follow(const ComplexView& complex, std::uint32_t max_degree, std::uint32_t first, Fill&& fill,
                  const Work& work, VineList* out) {
        VineFollower follower(complex, max_degree, work);
        Status status = follower.open();
        for (std::uint32_t i = 0; i < count_ && status == Status::ok; ++i) {
            ratio_[i] = 1;
            status = fill(first + i, follower.value(i), ratio_ + i);
            if (status == Status::ok) status = follower.take(i, first + i);
        }
        if (status == Status::ok) status = follower.finish(out);
        return status == Status::ok ? keep(out) : status;
    }
    // Moves the points down to the ratios and gives back everything else. out_of_memory.
    Status keep(VineList* out);

private:
    ArenaScope scope_;
    Arena& arena_;
    std::uint32_t count_ = 0;
    double* ratio_ = nullptr;
    std::size_t low_ = 0;
};

// Of a lower-star filtration: gives all simplices above the vertices the largest value of their vertices.
void raise_to_vertices(const ComplexView& complex, double* const* value, const Arena& arena);

}  // namespace netmesh
