#include "tools/pieces/schedule.hpp"

#include <cstdio>

#include "platform/clock.hpp"
#include "platform/interrupt.hpp"
#include "platform/terminal.hpp"
#include "platform/workers.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

// "pieces 12 of 63, 0:07 left" on a terminal.
class TaskBar {
public:
    TaskBar(bool wanted, std::size_t total)
        : active_(wanted && platform::stderr_is_terminal()), total_(total), start_(platform::seconds_now()) {}
    ~TaskBar() {
        if (drawn_) std::fputs("\r\x1b[K", stderr);
    }
    void show(std::size_t done) {
        if (!active_) return;
        drawn_ = true;
        std::string text = "pieces " + std::to_string(done) + " of " + std::to_string(total_);
        if (done > 0) {
            const double left =
                (platform::seconds_now() - start_) / static_cast<double>(done) * static_cast<double>(total_ - done);
            const auto seconds = static_cast<unsigned long>(left);
            char clock[32];
            std::snprintf(clock, sizeof clock, ", %lu:%02lu left", seconds / 60, seconds % 60);
            text += clock;
        }
        std::fprintf(stderr, "\r\x1b[K%s", text.c_str());
        std::fflush(stderr);
    }

private:
    bool active_, drawn_ = false;
    std::size_t total_;
    double start_;
};

// What becomes of the pieces of a job that is left in the middle.
std::string left_behind(const Options& options, const PiecesFolder& folder) {
    if (options.scratch.empty())
        return "; with --scratch DIR the same command would go on with the pieces that are done";
    return "; pieces that are done stay in " + folder.path() + ", and the same command goes on with them";
}

}  // namespace

Outcome run_tasks(const Options& options, const PiecesFolder& folder, const PiecesJob& job, unsigned jobs) {
    const std::uint32_t nodes = 2 * job.pieces;
    std::vector<bool> done(nodes), started(nodes);
    std::size_t left = 0;
    for (std::uint32_t node = 1; node < nodes; node++) {
        done[node] = started[node] = has_piece(folder, job, node);
        left += done[node] ? 0 : 1;
    }
    const std::size_t total = left;
    Options quiet = options;
    quiet.quiet = true;  // a bar for each of several processes is none
    TaskBar bar(!options.quiet, total);
    platform::Reservation block;  // each process of the crew has its own
    platform::Crew crew([&](std::size_t node) {
        const Outcome outcome = piece_task(quiet, folder, job, static_cast<std::uint32_t>(node), &block);
        if (outcome.exit != Exit::cancelled) tell_error(outcome, options.command, false);
        return static_cast<int>(outcome.exit);
    });
    bar.show(0);
    while (left > 0) {
        // The deepest node that can be made; joins before leaves, so that little is waiting.
        while (crew.running() < jobs) {
            std::uint32_t next = 0;
            for (std::uint32_t node = 1; node < nodes && next == 0; node++)
                if (!started[node] && (node >= job.pieces || (done[2 * node] && done[2 * node + 1]))) next = node;
            if (next == 0) break;
            started[next] = true;
            if (!crew.start(next)) return {Exit::memory, "netmesh: the system has no room for a process"};
        }
        std::size_t node = 0;
        int code = 0;
        if (!crew.wait(&node, &code) || code == static_cast<int>(Exit::cancelled))
            return {Exit::cancelled, "netmesh: cancelled" + left_behind(options, folder)};
        if (code < 0)
            return {Exit::internal,
                    "netmesh: the task of node " + std::to_string(node) + " was killed" + left_behind(options, folder)};
        if (code != 0) return {static_cast<Exit>(code), ""};
        done[node] = true;
        bar.show(total - --left);
    }
    return {};
}

std::string makefile_of(const PiecesJob& job) {
    const std::string pieces = std::to_string(job.pieces), last = std::to_string(2 * job.pieces - 1),
                      middle = std::to_string(job.pieces - 1);
    std::string text = std::string(makefile_mark) +
                       " `make -j 8` makes the diagram; NETMESH is the program, MEMORY what each\n"
                       "# task may take. Every task is one command that writes one file, so any scheduler will do:\n"
                       "#   netmesh pieces leaf . NODE    for NODE = " +
                       pieces + " .. " + last +
                       "\n"
                       "#   netmesh pieces join . NODE    for NODE = " +
                       middle +
                       " .. 1, once piece-(2 NODE) and piece-(2 NODE + 1) "
                       "are there\n"
                       "#   netmesh pieces collect . -o diagram.pers\n"
                       "NETMESH = netmesh\n"
                       "MEMORY =\n"
                       "diagram.pers: piece-1\n"
                       "\t$(NETMESH) pieces collect . -o $@\n";
    for (std::uint32_t node = 1; node < job.pieces; node++)
        text += "piece-" + std::to_string(node) + ": piece-" + std::to_string(2 * node) + " piece-" +
                std::to_string(2 * node + 1) + "\n\t$(NETMESH) pieces join . " + std::to_string(node) +
                " --quiet $(if $(MEMORY),--memory $(MEMORY))\n";
    for (std::uint32_t node = job.pieces; node < 2 * job.pieces; node++)
        text += "piece-" + std::to_string(node) + ": points\n\t$(NETMESH) pieces leaf . " + std::to_string(node) +
                " --quiet $(if $(MEMORY),--memory $(MEMORY))\n";
    return text;
}

}  // namespace netmesh::tool
