// The slice of tests/determinism on the bare board.
#include "board.hpp"
#include "determinism/slice.hpp"
#include "netmesh.h"

namespace {

alignas(16) unsigned char block[slice::block_bytes];

void line(const char* text) {
    board::write(text);
    board::write("\n");
}

}  // namespace

int run() {
    slice::run(block, sizeof block, NETMESH_DIM_MIN, NETMESH_DIM_MAX, line);
    return 0;
}
