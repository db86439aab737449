// A run of the engine: its block of memory, its options, progress, cancelling, and what its statuses mean to the user.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "netmesh.h"
#include "platform/memory.hpp"
#include "tools/io/points.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/report/progress.hpp"

namespace netmesh::tool {

class Session {
public:
    // tau, eps and seed come from the command line.
    Session(const Options& options, std::uint32_t dim);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Makes a context and runs `work` on it. With --memory the block has exactly that size. Otherwise it is reserved
    // lazily, by the plan of `job` for `points`, and when that was too little the whole work is done again in a larger
    // one. `cloud` gives messages their lines.
    using Work = std::function<netmesh_status(Session&)>;
    Outcome run(netmesh_job job, const PointCloud& cloud, const Work& work);
    // The same with the bytes to plan for.
    Outcome run_planned(std::size_t plan, const PointCloud& cloud, const Work& work);

    // One call of the engine inside `work`; `stage` gets its time when it is too short to poll.
    netmesh_status call(netmesh_stage stage, const std::function<netmesh_status()>& engine_call);

    netmesh_context* context() const { return context_; }
    const netmesh_options& engine_options() const { return engine_options_; }
    void set_tau(double tau) { engine_options_.tau = tau; }
    // Of a mesh refined by the certificate; 0: a mesh of aspect ratio tau.
    void set_goal(double ratio, double focus, double from, double to);
    void set_eps(double eps) { engine_options_.over_refine_eps = eps; }
    netmesh_report report() const;
    const StageClock& clock() const { return clock_; }

    double default_ratio() const;  // what a mesh of aspect ratio tau certifies

private:
    static int poll(void* self, const netmesh_progress* progress);
    netmesh_status attempt(std::size_t bytes, const Work& work);
    Outcome explain(netmesh_status status, const PointCloud& cloud, std::size_t plan) const;
    std::string memory_message(std::size_t plan) const;

    platform::Reservation block_;
    netmesh_context* context_ = nullptr;
    netmesh_options engine_options_ = {};
    std::size_t memory_bytes_;  // of --memory; 0 when not given
    std::uint32_t dim_;
    StageClock clock_;
    ProgressBar bar_;
    netmesh_progress last_ = {};
};

// Bytes to reserve at first when the user names none: 64 times the plan, between 1 GiB and what the machine has.
std::size_t lazy_bytes(std::size_t plan, std::size_t physical);

}  // namespace netmesh::tool
