// What a reduction tells the monitor.
#pragma once
#include <cstdint>

#include "vocabulary/monitor.hpp"

namespace netmesh {

struct Progress {
    Monitor& monitor;
    std::uint64_t done = 0;  // columns, rows or edges
    // True when the caller wants to stop; `work` as in Monitor::advance.
    bool stop(std::uint32_t work) { return monitor.advance(done, work); }
};

}  // namespace netmesh
