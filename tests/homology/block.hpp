// An arena of exactly so many bytes.
#pragma once
#include <cstdint>
#include <vector>

#include "memory/arena.hpp"

struct Block {
    explicit Block(std::size_t bytes) : words(bytes / 8 + 2) {
        const auto begin = reinterpret_cast<std::uintptr_t>(words.data());
        arena.adopt(reinterpret_cast<void*>((begin + 15) & ~std::uintptr_t{15}), bytes);
    }
    std::vector<std::uint64_t> words;
    netmesh::Arena arena;
};
