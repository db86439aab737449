#include "vocabulary/monitor.hpp"

#include "vocabulary/callback.hpp"

namespace netmesh {

bool Monitor::report() {
    if (!stopped_ && poll_ != nullptr) stopped_ = never_throwing(poll_)(user_, &progress_) != 0;
    countdown_ = stopped_ ? 0 : interval;
    return stopped_;
}

}  // namespace netmesh
