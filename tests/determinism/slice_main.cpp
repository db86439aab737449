// Prints the fingerprints of the slice (slice.hpp): what the matrix of builds compares with tests/golden/slice.txt.
#include <cstdio>
#include <cstdlib>

#include "common/read.hpp"
#include "determinism/slice.hpp"

#ifdef __has_feature
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define NETMESH_FORGET(block, bytes) __msan_allocated_memory(block, bytes)
#endif
#endif
#ifndef NETMESH_FORGET
#define NETMESH_FORGET(block, bytes) static_cast<void>(block)
#endif

namespace {

// Fresh for each dimension, and never written to here: checkers of uninitialised memory look on (tests/memory).
unsigned char* block = nullptr;

void print(const char* line) { std::puts(line); }
// After the last call on a context.
void print_and_forget(const char* line) {
    print(line);
    NETMESH_FORGET(block, slice::block_bytes);
}

void new_block() {
    std::free(block);
    void* memory = nullptr;
    if (posix_memalign(&memory, 16, slice::block_bytes) != 0) std::abort();
    block = static_cast<unsigned char*>(memory);
}

}  // namespace

int main() {
    for (int dim = NETMESH_DIM_MIN; dim <= NETMESH_DIM_MAX; ++dim) {
        if (!plans_for(dim)) continue;
        new_block();
        slice::run(block, slice::block_bytes, dim, dim, print_and_forget);
    }
    netmesh_report report;
    for (int dim = 2; dim <= 3; ++dim) {
        if (!plans_for(dim)) continue;
        new_block();
        if (slice::demo(dim, block, slice::demo_bytes, &report, print) != NETMESH_OK) return 1;
    }
    std::free(block);
}
