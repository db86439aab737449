#include "platform/clock.hpp"

#include <chrono>

namespace netmesh::platform {

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace netmesh::platform
