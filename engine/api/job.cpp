// Jobs on stacks of their own.
#include <cstddef>
#include <cstdint>

#include "include/netmesh.h"
#include "memory/stack_switch.hpp"
#include "vocabulary/callback.hpp"

// At the high end of the stack's memory, which is painted before the job begins:
//
//   | guard |  paint  <-- the stack | netmesh_job |
//   ^ low                           ^ this
struct netmesh_job {
    enum State { fresh, running, paused, ended };
    std::uint64_t magic;
    State state;
    netmesh_status status;
    int is_to_end;
    netmesh_task task;
    void* user;
    std::uint64_t* low;
    void *own, *resumer;  // where each of the two stacks goes on
    // AddressSanitizer's: what it keeps of each stack, and where the resumer's is.
    void *kept_of_own, *kept_of_resumer;
    const void* resumer_low;
    std::size_t resumer_bytes;

    std::size_t stack_bytes() const { return static_cast<std::size_t>(top() - reinterpret_cast<std::uintptr_t>(low)); }
    std::uintptr_t top() const { return reinterpret_cast<std::uintptr_t>(this); }
};

namespace netmesh {
namespace {

constexpr std::uint64_t job_magic = 0x6E65746D65736A01u, paint = 0xA5C3A5C3A5C3A5C3u;
constexpr std::size_t guard_words = 2, stack_alignment = 16;
// tests/archive/check.py takes as much of NETMESH_STACK_BYTES_JOB for granted; the rest is for frames.
static_assert(sizeof(netmesh_job) + guard_words * sizeof paint + 2 * stack_alignment <= 192,
              "a job's record has grown");

bool is_job(const netmesh_job* job) { return job != nullptr && job->magic == job_magic; }

// The job's own side: the first function on its stack.
void run_job(void* argument) {
    netmesh_job* const job = static_cast<netmesh_job*>(argument);
    arrive_on_stack(nullptr, &job->resumer_low, &job->resumer_bytes);
    job->status = run_task(job->task, job->user);
    job->state = netmesh_job::ended;
    leave_stack(nullptr, job->resumer_low, job->resumer_bytes);
    netmesh_switch_stack(&job->own, job->resumer);
    __builtin_unreachable();
}

// The resumer's side.
netmesh_status go_on(netmesh_job* job) {
    const bool begins = job->state == netmesh_job::fresh;
    job->state = netmesh_job::running;
    leave_stack(&job->kept_of_resumer, job->low, job->stack_bytes());
    if (begins)
        netmesh_enter_stack(&job->resumer, job, run_job, job);
    else
        netmesh_switch_stack(&job->resumer, job->own);
    arrive_on_stack(job->kept_of_resumer, nullptr, nullptr);
    for (std::size_t i = 0; i < guard_words; ++i)
        if (job->low[i] != paint) {
            job->state = netmesh_job::ended;
            return NETMESH_STACK_OVERFLOW;
        }
    return job->state == netmesh_job::paused ? NETMESH_PAUSED : job->status;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_job_init(void* stack, size_t stack_bytes, netmesh_task task, void* user, netmesh_job** job) {
    if (job == nullptr) return NETMESH_INVALID_ARGUMENT;
    *job = nullptr;
    if (stack == nullptr || task == nullptr) return NETMESH_INVALID_ARGUMENT;
    if (stack_bytes < NETMESH_STACK_BYTES_MIN) return NETMESH_OUT_OF_MEMORY;
    if (!can_switch_stacks()) return NETMESH_NOT_BUILT;
    char* const begin = static_cast<char*>(stack);
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(begin), mask = ~std::uintptr_t{stack_alignment - 1};
    const std::uintptr_t low = (address + stack_alignment - 1) & mask;
    const std::uintptr_t top = (address + stack_bytes - sizeof(netmesh_job)) & mask;
    netmesh_job* const made = reinterpret_cast<netmesh_job*>(begin + (top - address));
    __builtin_memset(made, 0, sizeof *made);
    made->low = reinterpret_cast<std::uint64_t*>(begin + (low - address));
    for (std::size_t i = 0; i < made->stack_bytes() / sizeof paint; ++i) made->low[i] = paint;
    made->magic = job_magic;
    made->task = task;
    made->user = user;
    *job = made;
    return NETMESH_OK;
}

netmesh_status netmesh_resume(netmesh_job* job) {
    if (!is_job(job) || (job->state != netmesh_job::fresh && job->state != netmesh_job::paused))
        return NETMESH_INVALID_ARGUMENT;
    return go_on(job);
}

netmesh_status netmesh_cancel(netmesh_job* job) {
    if (is_job(job) && job->state == netmesh_job::fresh) {
        job->state = netmesh_job::ended;
        return NETMESH_CANCELLED;
    }
    if (!is_job(job) || job->state != netmesh_job::paused) return NETMESH_INVALID_ARGUMENT;
    job->is_to_end = 1;
    return go_on(job);
}

int netmesh_pause(netmesh_job* job) {
    const auto frame = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    if (!is_job(job) || job->state != netmesh_job::running) return 0;
    if (frame < reinterpret_cast<std::uintptr_t>(job->low) || frame >= job->top()) return 0;
    if (job->is_to_end != 0) return 1;
    job->state = netmesh_job::paused;
    leave_stack(&job->kept_of_own, job->resumer_low, job->resumer_bytes);
    netmesh_switch_stack(&job->own, job->resumer);
    arrive_on_stack(job->kept_of_own, &job->resumer_low, &job->resumer_bytes);
    return job->is_to_end;
}

int netmesh_poll_pause(void* job, const netmesh_progress*) { return netmesh_pause(static_cast<netmesh_job*>(job)); }

int netmesh_job_ended(const netmesh_job* job) { return is_job(job) && job->state == netmesh_job::ended; }

size_t netmesh_stack_used(const netmesh_job* job) {
    if (!is_job(job)) return 0;
    std::size_t free = 0;
    while (free < job->stack_bytes() && job->low[free / sizeof paint] == paint) free += sizeof paint;
    return job->stack_bytes() - free;
}

}  // extern "C"
