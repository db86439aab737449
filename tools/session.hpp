// A run of the engine: its block of memory, progress, cancelling, and what its statuses mean to the user.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "netmesh.hpp"
#include "platform/memory.hpp"
#include "tools/asked_function.hpp"
#include "tools/io/points.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/report/progress.hpp"

namespace netmesh::tool {

class Session {
public:
    // block: where it is kept for the next session; null: the session's own. Options and block must outlive it.
    Session(const Options& options, std::uint32_t dim, platform::Reservation* block = nullptr);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Makes a context and runs `work` on it. With --memory the block has exactly that size. Otherwise it is reserved
    // lazily, by the bytes to plan for or as large as one that is there, and when that was too little the whole work is
    // done again in a larger one. `cloud` gives messages their lines.
    using Work = std::function<netmesh_status(Session&)>;
    Outcome run(std::size_t plan, const PointCloud& cloud, const Work& work);

    // One call of the engine inside `work`; `stage` gets its time when it is too short to poll.
    netmesh_status call(netmesh_stage stage, const std::function<netmesh_status()>& engine_call);

    Engine& engine() { return engine_; }
    const Engine& engine() const { return engine_; }
    // The engine's report of its last call: made once, as it has a fingerprint of all that there is.
    const netmesh_report& report() const;
    // What the options ask of the engine, settled.
    const netmesh_request& request() const { return request_; }
    // What meshes of this session are checked against: what was asked for, until a command knows better.
    void set_promise(const netmesh_request& promise) { promise_ = promise; }
    netmesh_request promise() const;

    // The request, with the session's progress bar and cancelling.
    template <class Request> Request watched(Request request) {
        request.monitor = {poll, this};
        return request;
    }
    AskedFunction& function() { return function_; }
    const StageClock& clock() const { return clock_; }

private:
    static int poll(void* self, const netmesh_progress* progress);
    netmesh_status attempt(std::size_t bytes, const Work& work);
    Outcome explain(netmesh_status status, const PointCloud& cloud, std::size_t plan) const;
    Outcome explain_argument(const netmesh_detail& detail, const PointCloud& cloud, const std::string& said) const;
    std::string memory_message(const PointCloud& cloud, std::size_t plan) const;

    const Options& options_;
    const std::uint32_t dim_;
    platform::Reservation own_block_, &block_;
    Engine engine_{nullptr, 0};
    mutable std::optional<netmesh_report> report_;  // none since the last call
    AskedFunction function_;
    netmesh_request request_, promise_;
    StageClock clock_;
    ProgressBar bar_;
    netmesh_progress last_ = {};
};

// Bytes to reserve at first when the user names none: 64 times the plan, between 1 GiB and what the machine has.
std::size_t lazy_bytes(std::size_t plan, std::size_t physical);

}  // namespace netmesh::tool
