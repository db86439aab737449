// Runs a job of footprint.c on the board mps2-an385, with its 16 MiB of further memory for the block. Prints the peak
// bytes of the block, those of the stack from its top, and the instructions executed: qemu -icount shift=0 gives each
// of them 1 ns of the clock of 25 MHz that a timer counts, so a tick is 40.
#include "board.hpp"
#include "determinism/text.hpp"

extern "C" void footprint_draw();
extern "C" std::uint64_t footprint_job(void* block, std::size_t block_bytes);

int run() {
    struct Timer {
        std::uint32_t control, value, reload;
    };
    footprint_draw();
    volatile Timer& timer = *reinterpret_cast<volatile Timer*>(0x40000000u);
    timer.reload = 0xFFFFFFFFu;
    timer.value = 0xFFFFFFFFu;
    timer.control = 1;
    const std::uint32_t begin = timer.value;
    const std::uint64_t peak = footprint_job(reinterpret_cast<void*>(0x21000000u), 16u << 20);
    const std::uint32_t ticks = begin - timer.value;
    Text text;
    text.number(peak).words(" ").number(board::stack_used()).words(" ").number(std::uint64_t{40} * ticks).words("\n");
    board::write(text.words());
    return peak == 0;
}
