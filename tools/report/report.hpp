// What a run has to say about itself: as JSON for programs, as a few lines for people.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "netmesh.h"
#include "tools/io/diagram_file.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/options.hpp"
#include "tools/report/progress.hpp"

namespace netmesh::tool {

struct DegreeDistance {
    std::uint32_t degree;
    double value;  // may be infinite
    double lower;  // the distance is not less: the same, but for that of Wasserstein
};

struct RunReport {
    const Options* options = nullptr;
    std::optional<netmesh_analysis> analysis;  // mesh, delaunay: with --analyse
    std::optional<netmesh_report> engine;      // without it, everything the engine would say is null
    double read_seconds = 0, write_seconds = 0, total_seconds = 0;
    std::optional<StageClock> clock;
    const Vines* vines = nullptr;                          // vineyard
    const Bounds* bounds = nullptr;                        // of all bars, --bounds
    const std::vector<Bar>* bars = nullptr;                // diagram.bars, when the data has no other way out
    std::optional<std::uint64_t> plan_bytes;               // size
    std::optional<std::vector<DegreeDistance>> distances;  // distance
    std::optional<std::vector<std::string>> checked;       // check: what was found to hold
};

// Keys that do not apply are null. Nothing in `fingerprint` depends on time, memory or platform.
std::string json_report(const RunReport& run);
std::string text_report(const RunReport& run);

// The object in place of a report where a run fails: the exit code, what is said on stderr, and the place in the input
// that it is about, null where it is about none. `command` may be none.
std::string json_error(Command command, const Outcome& outcome);
// And in place of a help text; without a key, of the version.
std::string json_text(Command command, const char* key, const std::string& text);

}  // namespace netmesh::tool
