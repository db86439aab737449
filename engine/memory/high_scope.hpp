// Scratch at the arena's high end while the low end goes on growing.
#pragma once
#include <cstddef>

#include "memory/arena.hpp"

namespace netmesh {

// Gives what was taken at the high end since its construction back.
class HighScope {
public:
    explicit HighScope(Arena& arena) : arena_(arena), high_(arena.high_mark()) {}
    ~HighScope() { arena_.release_high(high_); }
    HighScope(const HighScope&) = delete;
    HighScope& operator=(const HighScope&) = delete;

private:
    Arena& arena_;
    std::size_t high_;
};

}  // namespace netmesh
