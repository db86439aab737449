// What every job is given: the memory that it takes from, and the monitor that it reports to.
#pragma once
#include "memory/arena.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// Two references. Functions take it as `const Work&`; a caller may write `{arena, monitor}`.
struct Work {
    Arena& arena;
    Monitor& monitor;
};

}  // namespace netmesh
