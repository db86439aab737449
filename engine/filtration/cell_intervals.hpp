// The intervals of all cells of a mesh that the complete or the basic filter has been evaluated on, each end as narrow
// as somebody needs it.
//
// A wide interval is that of interval.hpp for the whole cell. A narrow one heeds what the ball leaves of the cell
// (clipped_reach.hpp), then all corners and all inputs (tighten_cell_bounds.hpp): it lies in the wide one and costs two
// hundred times as much. Bounds of bars ask for largest and least ends alone. That an end does not matter is proven
// with less, so most ends stop where they no longer matter.
#pragma once
#include "filtration/cell_bounds.hpp"
#include "filtration/tighten_cell_bounds.hpp"
#include "mesh/clip/clipped_reach.hpp"

namespace netmesh {

class CellIntervals {
public:
    // The mesh as clip_cells leaves it.
    CellIntervals(const AnyMesh& mesh, Arena& arena);
    CellIntervals(const CellIntervals&) = delete;
    CellIntervals& operator=(const CellIntervals&) = delete;

    // All wide. Takes at the arena's high end 37 bytes a vertex, 5 an input and 8 D a corner of the largest cell. Uses
    // the marks `queued` of vertices, which must be 0 and are again. out_of_memory.
    Status open(Monitor& monitor);
    const Interval* all() const { return interval_; }
    // Raises lo as far as it goes or to `enough`; lowers hi likewise. What they are then holds of the cell.
    void narrow_low(std::uint32_t v, double enough) {
        if (interval_[v].lo < enough && (state_[v] & low_done) == 0) raise_low(VertexId(v), enough);
    }
    void narrow_high(std::uint32_t v, double enough) {
        if (interval_[v].hi > enough && (state_[v] & high_done) == 0) lower_high(VertexId(v), enough);
    }
    // Narrows the interval as far as it takes to see whether it is at most s or beyond it, where it is either.
    void decide(std::uint32_t v, double s) {
        if (reaches_down_to(v, s))
            narrow_high(v, s);
        else
            narrow_low(v, next_up(s));
    }
    // Is F at most s at the vertex, so that lo is at most s? Elsewhere hi is above s.
    bool reaches_down_to(std::uint32_t v, double s) const { return distance_to_inputs(mesh_.store, VertexId(v)) <= s; }
    // Narrows cells until the largest hi of all with a value up to any b, and the least lo of all with a value from
    // any b on, are those that they would be if all were narrow. order[vertices]: by value.
    void narrow_extremes(const std::uint32_t* order);
    // out_of_memory as soon as there was no room to visit the star of a cell, which stays wide.
    Status status() const { return status_; }

private:
    enum : std::uint8_t { low_done = 1, high_done = 2, is_cut = 4 };  // is_cut: the ball may leave less than all of it

    bool open_cut(VertexId v);
    void tighten(VertexId v, const Interval& enough);
    void raise_low(VertexId v, double enough);
    void lower_high(VertexId v, double enough);

    const AnyMesh& mesh_;
    Arena& arena_;
    CellBounds bounds_;
    CellClipper clipper_;
    AnyInputTree tree_;
    CellTightener tightener_;
    Interval* interval_ = nullptr;   // [vertices]
    std::uint8_t* state_ = nullptr;  // [vertices]
    Status status_ = Status::ok;
};

}  // namespace netmesh
