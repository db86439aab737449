// Progress of an engine call: a bar for people, and the seconds that each stage took.
#pragma once
#include <cstdint>
#include <string>

#include "netmesh.h"

namespace netmesh::tool {

// Names of the stages as they stand in the JSON report.
const char* stage_name(netmesh_stage stage);

// Time between two polls belongs to the stage that the later one names: it did the work.
class StageClock {
public:
    StageClock();
    // The work since the last call was `stage`.
    void pass(netmesh_stage stage);
    // A call that never polled was `stage`; one that did ends in the stage seen last.
    void end_call(netmesh_stage unless_seen);
    // A new call starts now; what lies between two calls belongs to none.
    void begin_call();
    double seconds(netmesh_stage stage) const { return seconds_[stage]; }

private:
    double seconds_[NETMESH_STAGE_COUNT] = {};
    double last_;
    netmesh_stage seen_ = NETMESH_STAGE_NONE;
};

// One line on stderr: redrawn at most ten times a second on a terminal, else a line of a log every `log_seconds`.
class ProgressBar {
public:
    // Writes nothing when not `wanted`.
    explicit ProgressBar(bool wanted, double log_seconds = 60);
    ~ProgressBar() { clear(); }
    void show(const netmesh_progress& progress);
    void clear();

private:
    const bool active_, on_terminal_;
    const double log_seconds_;
    bool drawn_ = false;
    netmesh_stage stage_ = NETMESH_STAGE_NONE;
    double stage_start_ = 0, next_ = 0;
};

// The bar's text without control characters, for `columns` columns; elapsed is in seconds since the stage began.
std::string progress_line(const netmesh_progress& progress, double elapsed, int columns);

}  // namespace netmesh::tool
