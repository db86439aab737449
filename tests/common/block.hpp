// A block of memory for tests of inner rooms.
#pragma once
#include <cstdint>
#include <cstdlib>

#include "memory/arena.hpp"

class Block {
public:
    explicit Block(std::size_t bytes, int fill = 0x55) : bytes_((bytes + 15) / 16 * 16) {
        memory_ = static_cast<unsigned char*>(std::aligned_alloc(16, bytes_ > 0 ? bytes_ : 16));
        for (std::size_t i = 0; i < bytes_; ++i) memory_[i] = static_cast<unsigned char>(fill);
        arena.adopt(memory_, bytes_);
    }
    ~Block() { std::free(memory_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

    netmesh::Arena arena;

private:
    std::size_t bytes_;
    unsigned char* memory_;
};
