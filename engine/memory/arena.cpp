#include "memory/arena.hpp"

namespace netmesh {

void Arena::pass(std::uint32_t work) const {
    if (monitor_ != nullptr) monitor_->pass(work);
}

#ifdef __OPTIMIZE_SIZE__
void Arena::tick(std::uint32_t cost) const {
    if (monitor_ != nullptr) monitor_->tick(cost);
}
#endif

}  // namespace netmesh
