// Points to mesh to persistence diagram in one static mebibyte, and what it took.
#include "board.hpp"
#include "determinism/slice.hpp"
#include "determinism/text.hpp"
#include "netmesh.h"

namespace {

alignas(16) unsigned char arena[slice::demo_bytes];
netmesh_report report;  // two kilobytes that need not be on the stack

void line(const char* text) {
    board::write(text);
    board::write("\n");
}

}  // namespace

int run() {
    for (int dim = 2; dim <= 3; ++dim) {
        board::paint_stack();
        const std::uint32_t begin = board::centiseconds();
        const netmesh_status status = slice::demo(dim, arena, sizeof arena, &report, line);
        const std::uint32_t end = board::centiseconds();
        if (status != NETMESH_OK) return 1;
        Text text;
        text.words("  points ").number(report.input.points).words(", vertices ").number(report.mesh.vertices);
        text.words(", cells ").number(report.mesh.cells).words(", simplices ").number(report.diagram.simplices);
        text.words(", arena bytes ")
            .number(report.memory.peak_bytes)
            .words(", stack bytes ")
            .number(board::stack_used());
        text.words(", centiseconds ").number(end - begin);
        line(text.words());
    }
    return 0;
}
