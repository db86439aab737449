// Values of the caller's function. Calls through pointers are made here and in monitor.hpp, nowhere else.
#pragma once
#include <cstddef>
#include <cstdint>

#include "include/netmesh/job.h"
#include "include/netmesh/pieces.h"
#include "include/netmesh/request.h"

namespace netmesh {

// A function of the caller's, which does not throw: where exceptions are on, nothing is made for the case that it does.
template <class Result, class... Arguments> auto never_throwing(Result (*function)(Arguments...)) {
    return reinterpret_cast<Result (*)(Arguments...) noexcept>(function);
}

// The function's value at x; -0.0 becomes 0.0, so that equal values have equal bits.
inline double value_at(const netmesh_function& function, const double* x) {
    return never_throwing(function.evaluate)(function.user, x) + 0.0;
}

// The caller's distance of i and j.
inline double distance_at(netmesh_distance_function evaluate, void* user, std::uint32_t i, std::uint32_t j) {
    return never_throwing(evaluate)(user, i, j);
}

// Points and boxes of pieces, as netmesh/pieces.h says.
inline netmesh_status read_rows(const netmesh_source& source, std::uint64_t first, std::uint32_t count, double* points,
                                std::uint32_t* rows) {
    return never_throwing(source.read)(source.user, first, count, points, rows);
}
inline netmesh_status read_node(const netmesh_source& source, std::uint32_t node, double* box) {
    return never_throwing(source.box)(source.user, node, box);
}
inline netmesh_status open_piece(netmesh_open_piece open, void* user, std::size_t i, netmesh_piece* piece) {
    return never_throwing(open)(user, i, piece);
}

inline netmesh_status run_task(netmesh_task task, void* user) { return never_throwing(task)(user); }

}  // namespace netmesh
