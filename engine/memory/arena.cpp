#include "memory/arena.hpp"

namespace netmesh {

#ifdef __OPTIMIZE_SIZE__
void Arena::pass(std::uint32_t work) const {
    if (monitor_ != nullptr) monitor_->pass(work);
}

void Arena::tick(std::uint32_t cost) const {
    if (monitor_ != nullptr) monitor_->tick(cost);
}
#endif

}  // namespace netmesh
