#include "tools/report/progress.hpp"

#include <cstdio>

#include "platform/clock.hpp"
#include "platform/terminal.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

const char* stage_name(netmesh_stage stage) {
    switch (stage) {
    case NETMESH_STAGE_SORT: return "sort";
    case NETMESH_STAGE_DELAUNAY: return "delaunay";
    case NETMESH_STAGE_REFINE: return "refine";
    case NETMESH_STAGE_CERTIFY: return "certify";
    case NETMESH_STAGE_FILTER: return "filter";
    case NETMESH_STAGE_GRADIENT: return "gradient";
    case NETMESH_STAGE_REDUCE: return "reduce";
    case NETMESH_STAGE_CHECK: return "check";
    case NETMESH_STAGE_ANALYSE: return "analyse";
    default: return "start";
    }
}

StageClock::StageClock() : last_(platform::seconds_now()) {}

void StageClock::begin_call() {
    last_ = platform::seconds_now();
    seen_ = NETMESH_STAGE_NONE;
}

void StageClock::pass(netmesh_stage stage) {
    const double now = platform::seconds_now();
    seconds_[stage] += now - last_;
    last_ = now;
    seen_ = stage;
}

void StageClock::end_call(netmesh_stage unless_seen) { pass(seen_ == NETMESH_STAGE_NONE ? unless_seen : seen_); }

namespace {

std::string clock_text(double seconds) {
    if (seconds > 359999) seconds = 359999;
    const unsigned whole = static_cast<unsigned>(seconds + 0.5);
    char text[32];
    if (whole >= 3600) {
        std::snprintf(text, sizeof text, "%u:%02u:%02u", whole / 3600, whole / 60 % 60, whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%u:%02u", whole / 60, whole % 60);
    }
    return text;
}

}  // namespace

std::string progress_line(const netmesh_progress& progress, double elapsed, int columns) {
    std::string name = stage_name(progress.stage);
    name.resize(9, ' ');
    std::string numbers = grouped_text(progress.done);
    double share = -1;
    if (progress.total > 0) {
        share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        if (share > 1) share = 1;
        numbers += " of " + grouped_text(progress.total);
        char percent[16];
        std::snprintf(percent, sizeof percent, "  %3.0f%%", 100 * share);
        numbers += percent;
    }
    if (progress.vertices > 0) numbers += "  " + counted(progress.vertices, "vertex", "vertices");
    numbers += share > 0.01 && elapsed > 0.5 ? "  " + clock_text(elapsed * (1 - share) / share) + " left"
                                             : "  " + clock_text(elapsed);
    std::string line = name;
    const int room = columns - 1 - static_cast<int>(name.size() + numbers.size()) - 4;
    if (share >= 0 && room >= 10) {
        const int width = room < 40 ? room : 40;
        const int filled = static_cast<int>(share * width + 0.5);
        line += "[" + std::string(static_cast<std::size_t>(filled), '#') +
                std::string(static_cast<std::size_t>(width - filled), '.') + "] ";
    }
    line += numbers;
    if (columns > 1 && line.size() > static_cast<std::size_t>(columns - 1)) {
        line.resize(static_cast<std::size_t>(columns - 1));
    }
    return line;
}

ProgressBar::ProgressBar(bool wanted, double log_seconds)
    : active_(wanted), on_terminal_(wanted && platform::stderr_is_terminal()), log_seconds_(log_seconds) {
    if (active_ && !on_terminal_) next_ = platform::seconds_now() + log_seconds_;
}

void ProgressBar::show(const netmesh_progress& progress) {
    if (!active_) return;
    const double now = platform::seconds_now();
    if (progress.stage != stage_) {
        stage_ = progress.stage;
        stage_start_ = now;
    }
    if (now < next_) return;
    if (!on_terminal_) {
        next_ = now + log_seconds_;
        std::fprintf(stderr, "%s\n", progress_line(progress, now - stage_start_, 0).c_str());
        return;
    }
    next_ = now + 0.1;
    const std::string line = progress_line(progress, now - stage_start_, platform::stderr_columns());
    std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressBar::clear() {
    if (!drawn_) return;
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
    drawn_ = false;
}

}  // namespace netmesh::tool
