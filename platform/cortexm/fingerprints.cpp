// The slice of tests/determinism on the bare board, and how deep the stack was in each dimension.
#include "board.hpp"
#include "determinism/slice.hpp"
#include "determinism/text.hpp"
#include "netmesh.h"

namespace {

alignas(16) unsigned char block[slice::block_bytes];

void line(const char* text) {
    board::write(text);
    board::write("\n");
}

}  // namespace

int run() {
    int too_deep = 0;
    for (int dim = NETMESH_DIM_MIN; dim <= NETMESH_DIM_MAX; ++dim) {
        board::paint_stack();
        slice::run(block, sizeof block, dim, dim, line);
        const std::size_t used = board::stack_used(), limit = dim <= 4 ? 16384 : 32768;
        Text text;
        text.words("  stack of all jobs at D = ")
            .number(static_cast<std::uint64_t>(dim))
            .words(": ")
            .number(used)
            .words(" bytes");
        line(text.words());
        too_deep += used > limit;
    }
    return too_deep == 0 ? 0 : 4;
}
