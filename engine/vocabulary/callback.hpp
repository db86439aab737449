// The caller's function, seen from inside a job. Calls through pointers are made here and in monitor.hpp alone.
#pragma once
#include "include/netmesh.h"

namespace netmesh {

// f at x, once -0.0 has become 0.0.
inline double value_at(const netmesh_function& function, const double* x) {
    return function.evaluate(function.user, x) + 0.0;
}

}  // namespace netmesh
