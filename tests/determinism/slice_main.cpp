// Prints the fingerprints of the slice (slice.hpp): what the matrix of builds compares with tests/golden/slice.txt.
#include <cstdio>

#include "determinism/slice.hpp"
#include "netmesh.h"

namespace {
alignas(16) unsigned char block[slice::block_bytes];
}

int main() {
    slice::run(block, sizeof block, NETMESH_DIM_MIN, NETMESH_DIM_MAX, [](const char* line) { std::puts(line); });
}
