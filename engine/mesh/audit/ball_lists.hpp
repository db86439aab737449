// Point location as in the thesis (4.7.2): every input that is not inserted yet is stored in all D-balls that contain
// it.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "delaunay/kernel.hpp"

namespace netmesh {

// What point location has cost, input by input.
struct LocationAudit {
    static constexpr int rounds_max = 32;  // loads halve, and there are at most 2^28 inputs
    std::uint32_t rounds;
    std::uint32_t
        load[rounds_max];          // most inputs in one D-ball when each round begins; what is left after the last is 0
    std::uint32_t nets, nets_max;  // samples drawn, in all and in one round, until the load had halved
    std::uint32_t ply_max;         // most D-balls that one input was stored in
    double ply_mean;               // D-balls that an input was stored in when its turn came
    std::uint32_t touches_max;     // most insertions that moved one input or looked whether to move it (4.13)
    double touches_mean;
    double tests_mean;  // the same counted once for each new D-ball
};

class BallLists {
public:
    // Takes, at the low end, up to a quarter of what is free for the lists and 8 bytes for each cell that will fit:
    // before the store's cells are opened. out_of_memory.
    Status open(int dim, Arena& arena, std::uint32_t inputs);
    bool is_open() const { return entries_ != nullptr; }
    // Stores all inputs in the balls of the cells that there are. Whether the lists sufficed.
    bool start(const AnyStore& mesh);

    // Around each insertion, of vertex v into this cavity. Between them inputs out of balls that are gone wait; then
    // each is looked at for every new ball, and so is what the ball behind the new one's outer facet holds, as the two
    // old balls at a facet cover the new one. v is inside the hull, so neither the cavity nor what fills it has
    // infinite cells. False when the lists do not suffice; they are of no use then.
    void detach(const AnyStore& mesh, const Cavity& cavity, std::uint32_t v);
    bool attach(const AnyStore& mesh, const Cavity& cavity, std::uint32_t v);

    // A cell whose ball contains the input, which is not inserted yet.
    CellId ball_of(VertexId input) const { return entries_[first_of_input_[input]].cell; }
    // Is this input stored in exactly the balls of this cavity, which is its own?
    bool agrees(const AnyStore& mesh, const Cavity& cavity, std::uint32_t input) const;

    // Largest number of inputs in a ball. O(cells).
    std::uint32_t load(const AnyStore& mesh) const;
    // A sample of every ball with more than `most` inputs, 4 D of them or all; what was drawn for one ball counts
    // for the others. chosen[]: room for all inputs. Returns how many. O(cells + entries).
    std::uint32_t draw_nets(const AnyStore& mesh, std::uint32_t most, std::uint64_t seed, std::uint32_t* chosen);

    // How often an input has been compared with a D-ball, also before the first insertion.
    std::uint64_t looks() const { return starting_ + tests_; }
    void report(LocationAudit* audit) const;

    // What open places for each input and cell, and for each input in a ball.
    static constexpr std::size_t input_bytes = 5 * sizeof(std::uint32_t), cell_bytes = 2 * sizeof(std::uint32_t);
    struct Entry {
        CellId cell;
        std::uint32_t input, next_of_cell, next_of_input;
    };

private:
    bool open_ball(CellId cell);
    bool store(CellId cell, std::uint32_t input);
    bool consider(const AnyStore& mesh, CellId cell, std::uint32_t input);
    void unlink_from_input(std::uint32_t entry);
    void touch(std::uint32_t input, std::uint32_t stamp);

    int dim_ = 0;
    Arena* arena_ = nullptr;
    Entry* entries_ = nullptr;
    std::uint32_t *first_of_cell_, *load_of_cell_;
    std::uint32_t *first_of_input_, *ply_, *waiting_next_, *stamp_, *touches_;  // [inputs]
    std::uint32_t inputs_, cells_max_, entries_max_, entries_used_ = 0, free_ = none, now_ = 0, waiting_ = none;
    std::uint32_t ply_max_ = 0, located_ = 0;
    std::uint64_t ply_sum_ = 0, starting_ = 0, tests_ = 0;
};

}  // namespace netmesh
