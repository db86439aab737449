// A block of memory for tests of inner folders, and an arena of exactly so many bytes over it.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "memory/arena.hpp"

class Block {
public:
    static constexpr int untouched = -1;  // for large blocks, of which the system gives what is used

    explicit Block(std::size_t bytes, int fill = 0x55)
        : memory_(std::aligned_alloc(netmesh::Arena::alignment, rounded(bytes > 0 ? bytes : 1))) {
        if (memory_ == nullptr) std::abort();
        if (fill != untouched) std::memset(memory_, fill, bytes);
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
