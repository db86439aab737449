// Points to mesh to persistence diagram in one static mebibyte, and what it took.
#include "board.hpp"
#include "determinism/slice.hpp"
#include "netmesh.h"

namespace {

alignas(16) unsigned char arena[slice::demo_bytes];

void number(const char* before, std::uint64_t n, const char* after) {
    char digits[24];
    int at = 23;
    digits[at] = 0;
    do digits[--at] = static_cast<char>('0' + n % 10);
    while ((n /= 10) != 0);
    board::write(before);
    board::write(digits + at);
    board::write(after);
}

void line(const char* text) {
    board::write(text);
    board::write("\n");
}

}  // namespace

int run() {
    for (int dim = 2; dim <= 3; ++dim) {
        board::paint_stack();
        const std::uint32_t begin = board::centiseconds();
        netmesh_report report;
        const netmesh_status status = slice::demo(dim, arena, sizeof arena, &report, line);
        const std::uint32_t end = board::centiseconds();
        if (status != NETMESH_OK) return 1;
        number("  points ", report.points, "");
        number(", vertices ", report.vertices, "");
        number(", cells ", report.cells, "");
        number(", simplices ", report.simplices, "");
        number(", arena bytes ", report.peak_bytes, "");
        number(", stack bytes ", board::stack_used(), "");
        number(", centiseconds ", end - begin, "\n");
    }
    return 0;
}
