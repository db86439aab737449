// In which order inputs have their turns.
#pragma once
#include <cstdint>

#include "mesh/audit/ball_lists.hpp"

namespace netmesh {

// The order given; or, where inputs are stored in D-balls, the rounds of SelectRound (4.7.5): a net is a sample of
// every ball that holds more than half of the largest load, drawn again until the largest load has halved.
class InputOrder {
public:
    // order[inputs]: scratch with lists. lists that are not open: none.
    InputOrder(const AnyStore& store, BallLists& lists, std::uint32_t* order, std::uint32_t inputs, std::uint64_t seed,
               LocationAudit* audit)
        : store_(store), lists_(lists), order_(order), count_(lists.is_open() ? 0 : inputs), seed_(seed),
          audit_(*audit) {}

    // The next input that is not inserted yet; none at the end.
    VertexId next();

private:
    bool select_round();

    const AnyStore store_;
    BallLists& lists_;
    std::uint32_t* const order_;
    std::uint32_t count_, at_ = 0;
    std::uint32_t wanted_ = none;  // the largest load at which the round at hand ends
    std::uint32_t nets_ = 0;       // drawn in it
    const std::uint64_t seed_;
    LocationAudit& audit_;
};

}  // namespace netmesh
