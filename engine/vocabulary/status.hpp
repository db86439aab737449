// How engine calls end. The numbers are those of netmesh_status in netmesh/context.h.
#pragma once
#include "vocabulary/ids.hpp"

namespace netmesh {

enum class Status : int {
    ok = 0,
    invalid_argument = 1,
    out_of_memory = 2,
    cancelled = 3,
    not_finite = 4,
    out_of_range = 5,
    flat = 6,
    too_close = 7,
    no_result = 8,
    check_failed = 9,
    floating_point = 10,
    internal = 11,
    not_a_complex = 12,
    not_built = 13,
};

}  // namespace netmesh
