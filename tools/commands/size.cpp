#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

Outcome run_size(const Options& options) {
    if (options.dim == 0) return usage_error("size needs --dim D");
    if (options.point_count == 0) return usage_error("size needs --points N");
    const double start = platform::seconds_now();
    const std::size_t bytes = plan_for_size(options);
    if (bytes == 0) return {Exit::internal, "netmesh: internal error: no plan for these options"};
    if (bytes == SIZE_MAX) return {Exit::memory, "netmesh: more bytes than this machine can address"};
    RunReport run;
    run.options = &options;
    run.plan_bytes = bytes;
    run.total_seconds = platform::seconds_now() - start;
    const std::string text = options.json ? json_report(run) : std::to_string(bytes) + "\n";
    return write_files({{"", [&](TextWriter& out) { out << text; }}});
}

}  // namespace netmesh::tool
