// Reports progress to the caller's poll function and asks it whether to stop.
#pragma once
#include <cstdint>

#include "include/netmesh.h"

namespace netmesh {

class Monitor {
public:
    // A poll comes when so many units of work are done.
#ifdef NETMESH_SWEEP
    static constexpr std::uint32_t interval = 1;  // tests/sweep cancels wherever it is possible
#elif defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
    static constexpr std::uint32_t interval = 20;  // a Cortex-M takes fifty times as long, so that slices are short
#elif defined(__OPTIMIZE_SIZE__)
    static constexpr std::uint32_t interval = 800;  // small code is slower
#else
    static constexpr std::uint32_t interval = 1000;  // about every tenth of a millisecond
#endif

    Monitor() = default;
    Monitor(netmesh_poll poll, void* user) : poll_(poll), user_(user) {}

    void begin(netmesh_stage stage, std::uint64_t total) {
        progress_.stage = stage;
        progress_.done = 0;
        progress_.total = total;
    }
    void mesh_size(std::uint64_t vertices, std::uint64_t cells) {
        progress_.vertices = vertices;
        progress_.cells = cells;
    }
    // Reports that `done` units are done; `work` is what they cost since the last call, in units of roughly 100 ns.
    // True when the caller wants to stop.
    bool advance(std::uint64_t done, std::uint32_t work = 1) {
        if (!is_due(work)) return false;
        progress_.done = done;
        return report();
    }
    // The same in the middle of what cannot be left half done. A wish to stop is remembered: whoever asks next, by
    // advance or by has_stopped at the end of the phase, is told. The caller is not polled again.
    void pass(std::uint32_t work) {
        if (is_due(work)) report();
    }
    // The same for a short step: cost is in instructions, or so.
    void tick(std::uint32_t cost) {
        ticks_ += cost;
        if (ticks_ < 1u << 16) return;
        pass(ticks_ >> 8);
        ticks_ = 0;
    }
    // Has the caller said that it wants to stop?
    bool has_stopped() const { return stopped_; }

private:
    bool is_due(std::uint32_t work) {
        if (countdown_ <= work) return true;
        countdown_ -= work;
        return false;
    }
    bool report();  // one piece of code for all sources

    netmesh_poll poll_ = nullptr;
    void* user_ = nullptr;
    netmesh_progress progress_ = {};
    std::uint32_t countdown_ = interval;
    std::uint32_t ticks_ = 0;
    bool stopped_ = false;
};

}  // namespace netmesh
