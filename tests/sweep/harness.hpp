// What disturbs the engine in the sweep, the blocks it works in, and what is counted.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>

#include "netmesh.h"
#include "netmesh/job.h"

// Requests for memory refuse_from .. refuse_to - 1 are refused, poll cancel_at is answered with a stop; all are counted
// from 0. With a job each poll pauses it before it answers.
struct Disturbance {
    long refuse_from = -1, refuse_to = -1, cancel_at = -1;
    long requests = 0, polls = 0;  // made so far
    netmesh_job* job = nullptr;
};
extern Disturbance disturbance;

int sweep_poll(void*, const netmesh_progress*);

// Exactly `bytes` bytes at an aligned address: between guards, or (tight) as an allocation of its own, whose end a
// sanitizer watches.
class Block {
public:
    Block(std::size_t bytes, unsigned char fill, bool tight) : bytes_(bytes), margin_(tight ? 0 : guard_bytes) {
        void* memory = nullptr;
        if (posix_memalign(&memory, 16, bytes + 2 * margin_ + (bytes + 2 * margin_ == 0)) != 0) std::abort();
        memory_ = static_cast<unsigned char*>(memory);
        std::memset(memory_, guard, bytes + 2 * margin_);
        std::memset(base(), fill, bytes);
    }
    ~Block() { std::free(memory_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    unsigned char* base() { return memory_ + margin_; }
    bool guards_intact() const {
        for (std::size_t i = 0; i < margin_; ++i)
            if (memory_[i] != guard || memory_[margin_ + bytes_ + i] != guard) return false;
        return true;
    }

private:
    static constexpr std::size_t guard_bytes = 64;
    static constexpr unsigned char guard = 0xC3;
    std::size_t bytes_, margin_;
    unsigned char* memory_;
};

// Which job in which phase, for the message about a fault.
struct Place {
    const char* job = "";
    int dim = 0;
    const char* phase = "";
    long long where = 0;
};
extern Place place;
extern long faults;
bool require(bool good, const char* what);

// Runs a function in a job that pauses at every poll, and ends the job at pause `cancel_at` (-1: never).
class Slices {
public:
    explicit Slices(std::size_t stack_bytes) : stack_(stack_bytes, 0, false), bytes_(stack_bytes) {}
    netmesh_status run(const std::function<netmesh_status()>& steps, long cancel_at);
    long pauses = 0;

private:
    Block stack_;
    std::size_t bytes_;
};

struct Tally {
    long refused = 0, cancelled = 0, whole = 0, partial = 0, pauses = 0;
    void count(netmesh_status status, bool holds) {
        refused += status == NETMESH_OUT_OF_MEMORY;
        cancelled += status == NETMESH_CANCELLED;
        whole += status == NETMESH_OK;
        partial += status != NETMESH_OK && holds;
    }
};
extern Tally total;

// The sweep of netmesh_bottleneck, whose memory is not a context's.
void sweep_distances();
