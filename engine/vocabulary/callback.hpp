// Values of the caller's function. Calls through pointers are made here and in monitor.hpp, nowhere else.
#pragma once
#include "include/netmesh.h"

namespace netmesh {

// The function's value at x; -0.0 becomes 0.0, so that equal values have equal bits.
inline double value_at(const netmesh_function& function, const double* x) {
    return function.evaluate(function.user, x) + 0.0;
}

}  // namespace netmesh
