// Address space for the engine's block: pages become real when they are first written.
#pragma once
#include <cstddef>

namespace netmesh::platform {

// A block of virtual memory, page-aligned, zero when first read, given back by the destructor.
class Reservation {
public:
    Reservation() = default;
    ~Reservation() { release(); }
    Reservation(const Reservation&) = delete;
    Reservation& operator=(const Reservation&) = delete;

    // Exactly `bytes` (at least 1) without committing a page, in place of what was held; a block of that size is kept,
    // with what is in it. False when the system refuses; then nothing is held.
    bool reserve(std::size_t bytes);
    void release();

    void* base() const { return base_; }
    std::size_t bytes() const { return bytes_; }

private:
    void* base_ = nullptr;
    std::size_t bytes_ = 0;
};

// Gives the whole pages of [begin, begin + bytes) back to the system, where it takes them: what stood there is lost,
// and the memory stays the caller's.
void forget_pages(void* begin, std::size_t bytes);

// The most that this process has had in memory at a time; 0 where the system does not say.
std::size_t peak_process_bytes();
// The same of the processes that it has started and that have ended, the largest one.
std::size_t peak_worker_bytes();

// Memory that this process can hope to use: the machine's, or the control group's limit where that is lower.
std::size_t physical_memory_bytes();

}  // namespace netmesh::platform
