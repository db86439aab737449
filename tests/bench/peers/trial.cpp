#include "trial.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace bench {
namespace {

double cpu_seconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// A line like "VmHWM:   123 kB" of /proc/self/status, in bytes; 0 when there is none.
double status_bytes(const char* key) {
    double bytes = 0.0;
    if (FILE* f = std::fopen("/proc/self/status", "r")) {
        char line[256];
        const std::size_t length = std::strlen(key);
        while (std::fgets(line, sizeof line, f))
            if (std::strncmp(line, key, length) == 0 && line[length] == ':')
                bytes = 1024.0 * std::atof(line + length + 1);
        std::fclose(f);
    }
    return bytes;
}

// Starts the high-water mark of the resident set anew, where the kernel allows it.
void forget_peak() {
    if (FILE* f = std::fopen("/proc/self/clear_refs", "w")) {
        std::fputs("5", f);
        std::fclose(f);
    }
}

double peak_bytes() {
    const double peak = status_bytes("VmHWM");
    if (peak > 0.0) return peak;
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

bool write_all(int fd, const void* data, std::size_t bytes) {
    const char* p = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t k = write(fd, p, bytes);
        if (k <= 0) return false;
        p += k;
        bytes -= static_cast<std::size_t>(k);
    }
    return true;
}

bool read_all(int fd, void* data, std::size_t bytes) {
    char* p = static_cast<char*>(data);
    while (bytes > 0) {
        const ssize_t k = read(fd, p, bytes);
        if (k <= 0) return false;
        p += k;
        bytes -= static_cast<std::size_t>(k);
    }
    return true;
}

struct Message {
    double seconds, bytes;
    std::array<double, figure_count> figures;
    std::size_t pairs;
};

}  // namespace

void Trial::start() {
    resident_ = resident_bytes();  // what was freed earlier is given back first, so that its reuse counts
    forget_peak();
    cpu_ = cpu_seconds();
}

void Trial::stop() {
    outcome.seconds = cpu_seconds() - cpu_;
    outcome.bytes = peak_bytes() - resident_;
}

double resident_bytes() {
    malloc_trim(0);
    return status_bytes("VmRSS");
}

Outcome run(const Contestant& contestant) {
    int ends[2];
    Outcome outcome;
    if (pipe(ends) != 0) return outcome;
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        Trial trial;
        contestant(trial);
        const Outcome& o = trial.outcome;
        const Message message = {o.seconds, o.bytes, o.figures, o.diagram.size()};
        const bool sent = write_all(ends[1], &message, sizeof message) &&
                          write_all(ends[1], o.diagram.data(), o.diagram.size() * sizeof(netmesh_pair));
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    Message message;
    if (child > 0 && read_all(ends[0], &message, sizeof message)) {
        outcome.seconds = message.seconds;
        outcome.bytes = message.bytes;
        outcome.figures = message.figures;
        outcome.diagram.resize(message.pairs);
        outcome.finished = read_all(ends[0], outcome.diagram.data(), message.pairs * sizeof(netmesh_pair));
    }
    close(ends[0]);
    int status = 0;
    if (child > 0) waitpid(child, &status, 0);
    outcome.finished = outcome.finished && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return outcome;
}

void measure_aspect(Trial& trial, const std::vector<double>& points,
                    const std::vector<std::array<std::uint32_t, 4>>& tets, const double* ball) {
    const std::size_t n = points.size() / 3;
    std::vector<double> far(n, 0.0), near(n, INFINITY);
    std::vector<bool> skip(n, false);
    const auto squared = [](const double* a, const double* b) {
        return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]);
    };
    std::vector<std::array<std::uint32_t, 3>> facets;
    for (const auto& t : tets) {
        const double* p[4] = {&points[3 * t[0]], &points[3 * t[1]], &points[3 * t[2]], &points[3 * t[3]]};
        double e[3][3], lift[3];
        for (int i = 0; i < 3; ++i) {
            for (int a = 0; a < 3; ++a) e[i][a] = p[i + 1][a] - p[0][a];
            lift[i] = 0.5 * (e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2]);
        }
        const auto minor = [&](int i, int j, int a, int b) { return e[i][a] * e[j][b] - e[i][b] * e[j][a]; };
        const double det = e[0][0] * minor(1, 2, 1, 2) - e[0][1] * minor(1, 2, 0, 2) + e[0][2] * minor(1, 2, 0, 1);
        double centre[3];
        for (int a = 0; a < 3; ++a) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            centre[a] = p[0][a] +
                        (lift[0] * minor(1, 2, b, c) + lift[1] * minor(2, 0, b, c) + lift[2] * minor(0, 1, b, c)) / det;
        }
        const bool outside = ball != nullptr && !(squared(centre, ball) <= ball[3] * ball[3]);
        for (int i = 0; i < 4; ++i) {
            if (outside) skip[t[i]] = true;
            far[t[i]] = std::max(far[t[i]], squared(p[i], centre));
            std::array<std::uint32_t, 3> f = {t[(i + 1) & 3], t[(i + 2) & 3], t[(i + 3) & 3]};
            std::sort(f.begin(), f.end());
            facets.push_back(f);
            for (int j = 0; j < 4; ++j)
                if (j != i) near[t[i]] = std::min(near[t[i]], squared(p[i], p[j]));
        }
    }
    std::sort(facets.begin(), facets.end());
    for (std::size_t i = 0; i < facets.size();) {
        const bool shared = i + 1 < facets.size() && facets[i] == facets[i + 1];
        if (!shared)
            for (std::uint32_t v : facets[i]) skip[v] = true;
        i += shared ? 2 : 1;
    }
    double worst = 0.0, sum = 0.0, count = 0.0;
    for (std::size_t v = 0; v < n; ++v) {
        if (skip[v] || far[v] == 0.0) continue;
        const double ratio = std::sqrt(far[v]) / (0.5 * std::sqrt(near[v]));
        worst = std::max(worst, ratio);
        sum += ratio;
        count += 1.0;
    }
    trial.figure(aspect_worst, worst);
    trial.figure(aspect_mean, count > 0.0 ? sum / count : 0.0);
}

}  // namespace bench
