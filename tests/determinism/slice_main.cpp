// Prints the fingerprints of the slice (slice.hpp): what the matrix of builds compares with tests/golden/slice.txt.
#include <cstdio>

#include "determinism/slice.hpp"
#include "netmesh.h"

namespace {
alignas(16) unsigned char block[slice::block_bytes];
}

int main() {
    const auto print = [](const char* line) { std::puts(line); };
    slice::run(block, sizeof block, NETMESH_DIM_MIN, NETMESH_DIM_MAX, print);
    netmesh_report report;
    for (int dim = 2; dim <= 3; ++dim)
        if (slice::demo(dim, block, slice::demo_bytes, &report, print) != NETMESH_OK) return 1;
}
