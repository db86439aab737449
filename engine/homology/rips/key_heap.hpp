// Sums of columns over Z/2 as a heap of keys in which equal ones cancel.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// Smallest key first. Lies at the arena's low end, where nobody else may take memory until it is closed.
class KeyHeap {
public:
    explicit KeyHeap(Arena& arena) : arena_(arena) {}

    void open() {
        mark_ = arena_.low_mark();
        keys_ = nullptr;
        size_ = capacity_ = 0;
    }
    void close() { arena_.release_low(mark_); }
    // False: out of memory.
    bool push(std::uint64_t key) {
        if (size_ == capacity_ && !grow()) return false;
        std::size_t hole = size_++;
        while (hole > 0 && key < keys_[(hole - 1) / width]) {
            keys_[hole] = keys_[(hole - 1) / width];
            hole = (hole - 1) / width;
        }
        keys_[hole] = key;
        return true;
    }
    // The smallest key of the sum, which is taken out; all ones when the sum is empty.
    std::uint64_t pop_pivot() {
        while (size_ > 0) {
            const std::uint64_t key = pop();
            if (size_ == 0 || keys_[0] != key) return key;
            pop();
        }
        return ~std::uint64_t{0};
    }

private:
    // Children of a key: many more keys are put in than taken out.
    static constexpr std::size_t width = 4;

    std::uint64_t pop() {
        const std::uint64_t first = keys_[0], key = keys_[--size_];
        std::size_t hole = 0;
        for (std::size_t child; (child = width * hole + 1) < size_; hole = child) {
            const std::size_t end = size_ - child < width ? size_ : child + width;
            for (std::size_t other = child + 1; other < end; ++other)
                child = keys_[other] < keys_[child] ? other : child;
            if (key <= keys_[child]) break;
            keys_[hole] = keys_[child];
        }
        if (size_ > 0) keys_[hole] = key;
        return first;
    }
    bool grow() {
        if (keys_ == nullptr) {
            keys_ = arena_.take_low<std::uint64_t>(2);
            capacity_ = keys_ == nullptr ? 0 : 2;
            return keys_ != nullptr;
        }
        if (!arena_.extend_low(sizeof(std::uint64_t))) return false;
        ++capacity_;
        return true;
    }

    Arena& arena_;
    std::uint64_t* keys_ = nullptr;
    std::size_t mark_ = 0, size_ = 0, capacity_ = 0;
};

}  // namespace netmesh
