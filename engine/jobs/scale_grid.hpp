// The certificate as a function of scale of several diagrams that are joined: what holds of all of them, scale by
// scale, on a grid of at most 1024 cells, 16 an octave or fewer, which need no more room for more meshes.
#pragma once
#include <cstdint>

#include "jobs/bar_bounds.hpp"
#include "jobs/join_shift.hpp"

namespace netmesh {

class ScaleGrid {
public:
    static constexpr std::uint32_t cells_max = 1024;

    // From about `least` to `most`, 0 < least <= most; what is below belongs to the first cell, what is above to the
    // last. At the arena's high end. False: out of memory.
    bool open(double least, double most, Arena& arena);

    std::uint32_t count() const { return count_; }
    std::uint32_t cell_of(double scale) const;
    // Scales of cell i: from from(i) to before next(i).
    double from(std::uint32_t i) const { return i == 0 ? first_ : edge(i); }
    double next(std::uint32_t i) const;
    // Of a mesh that says nothing below `scale`.
    void begin_at(double scale) {
        if (scale < first_) first_ = scale;
    }
    // A mesh's step of cell i.
    void add(std::uint32_t i, const ScaleStep& step);

    // The steps, at the arena's low end: what the meshes said, and what the join adds where they say nothing. No ratio
    // is above `ratio`, which holds at all scales. False: out of memory.
    bool finish(const JoinShift& join, double ratio, Arena& arena, ScaleCurve* curve);

private:
    double edge(std::uint32_t i) const;

    ScaleStep* cells_ = nullptr;
    std::uint64_t base_ = 0;
    std::uint32_t count_ = 0;
    int shift_ = 0;
    double first_ = 0;
};

}  // namespace netmesh
