// What every job works with: the memory it takes from and the monitor that it reports to and asks whether to stop.
#pragma once
#include "memory/arena.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// Two references, handed on by value or by reference to const; `{arena, monitor}` makes one on the spot.
struct Work {
    Arena& arena;
    Monitor& monitor;
};

}  // namespace netmesh
