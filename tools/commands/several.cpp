#include "tools/commands/several.hpp"

#include <map>
#include <memory>

#include "platform/workers.hpp"
#include "tools/commands/output.hpp"

namespace netmesh::tool {

namespace {

// Inputs that have ended, but not those before them.
constexpr std::size_t ahead_most = 64;

struct Ended {
    std::unique_ptr<platform::SaidLater> said;
    int code = 0;
    bool done = false;
};

bool ends_all(Exit exit) { return exit == Exit::usage || exit == Exit::cancelled; }

}  // namespace

Outcome run_one_by_one(const Options& options, const RunInput& run) {
    Outcome ended;
    for (const std::string& path : options.positionals) {
        const Outcome outcome = without_exceptions([&] { return run(path); });
        if (ends_all(outcome.exit)) return outcome;
        tell_error(outcome, options.command, options.json);
        if (ended.good()) ended.exit = outcome.exit;
    }
    return ended;
}

Outcome run_side_by_side(const Options& options, const RunInput& run) {
    const std::vector<std::string>& paths = options.positionals;
    std::map<std::size_t, Ended> inputs;
    platform::Workers workers;
    std::string why;
    Outcome ended;
    std::size_t next = 0;
    for (std::size_t turn = 0; turn < paths.size();) {
        for (; next < paths.size() && next < turn + options.jobs + ahead_most && workers.running() < options.jobs;
             next++) {
            Ended& input = inputs[next];
            input.said = std::make_unique<platform::SaidLater>();
            if (!input.said->open(&why)) return data_error("netmesh: " + why);
            const auto work = [&, at = next] {
                inputs[at].said->take_over();
                const Outcome outcome = without_exceptions([&] { return run(paths[at]); });
                tell_error(outcome, options.command, options.json);
                return static_cast<int>(outcome.exit);
            };
            if (!workers.start(next, work)) return {Exit::memory, "netmesh: the system has no room for a process"};
        }
        std::size_t at = 0;
        int code = 0;
        if (!workers.wait(&at, &code)) return {Exit::cancelled, "netmesh: cancelled"};
        inputs[at].code = code;
        inputs[at].done = true;
        for (; turn < next && inputs[turn].done; turn++) {
            const Ended input = std::move(inputs[turn]);
            inputs.erase(turn);
            if (!input.said->say(&why)) return file_error("<stdout>", "cannot write: " + why);
            Outcome outcome = {static_cast<Exit>(input.code), ""};
            if (input.code < 0) outcome = file_error(paths[turn], "its process was killed", Exit::internal);
            if (ends_all(outcome.exit)) return outcome;
            tell_error(outcome, options.command, options.json);
            if (ended.good()) ended.exit = outcome.exit;
        }
    }
    return ended;
}

}  // namespace netmesh::tool
