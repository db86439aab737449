#include "platform/memory.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>

namespace netmesh::platform {

bool Reservation::reserve(std::size_t bytes) {
    if (base_ != nullptr && bytes_ == bytes) return true;
    release();
    void* base = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (base == MAP_FAILED) return false;
#ifdef MADV_HUGEPAGE
    // Cells are visited in no order of memory: with small pages a tenth of the time goes by in looking up addresses.
    // Not at the two ends, of which a small job would take a huge page each.
    constexpr std::size_t end_bytes = std::size_t{2} << 20;
    if (bytes > 2 * end_bytes) madvise(static_cast<char*>(base) + end_bytes, bytes - 2 * end_bytes, MADV_HUGEPAGE);
#endif
    base_ = base;
    bytes_ = bytes;
    return true;
}

void Reservation::release() {
    if (base_ != nullptr) munmap(base_, bytes_);
    base_ = nullptr;
    bytes_ = 0;
}

void forget_pages(void* begin, std::size_t bytes) {
#ifdef MADV_DONTNEED
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)), at = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t skipped = (page - at % page) % page, end = at + bytes;
    if (skipped >= bytes || end - end % page <= at + skipped) return;
    madvise(static_cast<char*>(begin) + skipped, end - end % page - (at + skipped), MADV_DONTNEED);
#endif
}

namespace {

// The number in a control-group file, or `otherwise` when there is none ("max" means no limit).
unsigned long long number_in(const char* path, unsigned long long otherwise) {
    std::FILE* file = std::fopen(path, "r");
    if (file == nullptr) return otherwise;
    unsigned long long value = 0;
    const bool found = std::fscanf(file, "%llu", &value) == 1;
    std::fclose(file);
    return found ? value : otherwise;
}

std::size_t peak_of(int whose) {
    rusage usage;
    if (getrusage(whose, &usage) != 0 || usage.ru_maxrss <= 0) return 0;
#ifdef __APPLE__
    return static_cast<std::size_t>(usage.ru_maxrss);
#else
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

}  // namespace

std::size_t peak_process_bytes() { return peak_of(RUSAGE_SELF); }
std::size_t peak_worker_bytes() { return peak_of(RUSAGE_CHILDREN); }

std::size_t physical_memory_bytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), page_bytes = sysconf(_SC_PAGESIZE);
    unsigned long long bytes = SIZE_MAX / 2;
    if (pages > 0 && page_bytes > 0) {
        bytes = static_cast<unsigned long long>(pages) * static_cast<unsigned long long>(page_bytes);
    }
    const unsigned long long limit = number_in("/sys/fs/cgroup/memory.max", bytes);
    if (limit < bytes) bytes = limit;
    const unsigned long long most = SIZE_MAX / 2;
    return static_cast<std::size_t>(bytes < most ? bytes : most);
}

}  // namespace netmesh::platform
