// Values of the caller's function. Calls through pointers are made here and in monitor.hpp, nowhere else.
#pragma once
#include <cstdint>

#include "include/netmesh.h"

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

inline netmesh_status run_task(netmesh_task task, void* user) { return never_throwing(task)(user); }

}  // namespace netmesh
