#include "mesh/loop/input_order.hpp"

#include "vocabulary/features.hpp"

namespace netmesh {

VertexId InputOrder::next() {
    for (;;) {
        while (at_ < count_) {
            const VertexId input = VertexId(order_[at_++]);
            if (store_.vertex(input).cell == none) return input;
        }
        if (!built::audits || !lists_.is_open() || !select_round()) return none;
    }
}

// Another net of this round, or the first one of the next. False when all inputs are in.
bool InputOrder::select_round() {
    const std::uint32_t load = lists_.load(store_);
    if (load <= wanted_) {
        if (load == 0) return false;
        audit_.load[audit_.rounds++] = load;
        wanted_ = load / 2;
        nets_ = 0;
    }
    count_ = lists_.draw_nets(store_, wanted_, seed_ + audit_.nets++, order_);
    at_ = 0;
    if (++nets_ > audit_.nets_max) audit_.nets_max = nets_;
    return true;
}

}  // namespace netmesh
