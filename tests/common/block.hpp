// A block of memory for tests of inner folders, and an arena of exactly so many bytes over it. It is filled, so that
// what nobody has written shows; a large one at both its ends alone, from where an arena takes.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "memory/arena.hpp"

class Block {
public:
    static constexpr int untouched = -1;  // for large blocks, of which the system gives what is used
    static constexpr std::size_t filled_end = std::size_t{1} << 22;

    explicit Block(std::size_t bytes, int fill = 0x55)
        : memory_(std::aligned_alloc(netmesh::Arena::alignment, rounded(bytes > 0 ? bytes : 1))) {
        if (memory_ == nullptr) std::abort();
        if (fill != untouched) {
            const std::size_t filled = std::min(bytes, filled_end);
            std::memset(memory_, fill, filled);
            std::memset(static_cast<char*>(memory_) + (bytes - filled), fill, filled);
        }
        arena.adopt(memory_, bytes);
    }
    ~Block() { std::free(memory_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

    netmesh::Arena arena;

private:
    static std::size_t rounded(std::size_t bytes) {
        return (bytes + netmesh::Arena::alignment - 1) & ~(netmesh::Arena::alignment - 1);
    }
    void* const memory_;
};
