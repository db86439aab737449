// Rips diagrams in processor time and memory, and the same by ripser where one is on the path.
//
//   rips [factor on the numbers of points, 1]
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "common/inputs.hpp"
#include "common/session.hpp"

namespace {

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double seconds_of_children() {
    rusage used;
    getrusage(RUSAGE_CHILDREN, &used);
    return static_cast<double>(used.ru_utime.tv_sec) + static_cast<double>(used.ru_utime.tv_usec) / 1e6;
}

// Processor time of ripser on these points, less than 0 without one. Its thresholds are diameters. All distances of so
// many points do not fit.
double ripser(int dim, const inputs::Points& points, int max_degree, double threshold) {
    if (points.size() / static_cast<std::size_t>(dim) > 20000) return -1;
    if (std::system("command -v ripser >/dev/null 2>&1") != 0) return -1;
    std::string command = "ripser --format point-cloud --dim " + std::to_string(max_degree);
    if (threshold < HUGE_VAL) command += " --threshold " + std::to_string(2 * threshold);
    command += " >/dev/null";
    const double start = seconds_of_children();
    std::FILE* const pipe = popen(command.c_str(), "w");
    if (pipe == nullptr) return -1;
    for (std::size_t i = 0; i < points.size(); ++i)
        std::fprintf(pipe, "%.17g%c", points[i], (i + 1) % static_cast<std::size_t>(dim) == 0 ? '\n' : ' ');
    return pclose(pipe) == 0 ? seconds_of_children() - start : -1;
}

void measure(const char* name, int dim, const inputs::Points& points, int max_degree, double threshold = HUGE_VAL) {
    Session session(dim);
    session.reserve(std::size_t{1} << 32);  // little of that is used, the rest costs nothing
    const double start = seconds();
    netmesh::Request request =
        session.points_request(points, &netmesh_filter_rips, 1, static_cast<std::uint32_t>(max_degree));
    request.threshold = threshold;
    const netmesh_status status = netmesh_persist(session.context, &request);
    const double took = seconds() - start;
    std::printf("%-8s %7zu points, threshold %-5g degrees to %d: %8.3f s %8.1f MiB (%s)", name,
                points.size() / static_cast<std::size_t>(dim), threshold, max_degree, took,
                static_cast<double>(session.report().memory.peak_bytes) / 1048576, netmesh_status_text(status));
    const double theirs = ripser(dim, points, max_degree, threshold);
    if (theirs < 0) {
        std::printf("  no ripser\n");
    } else {
        std::printf("  ripser %8.3f s\n", theirs);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const double factor = argc > 1 ? std::atof(argv[1]) : 1;
    const auto n = [&](int count) { return static_cast<std::size_t>(factor * count); };
    measure("sphere", 3, inputs::shell(3, n(200), 1, 1, 2), 2);
    measure("torus", 3, inputs::torus(n(200), 1), 2);
    measure("torus", 3, inputs::torus(n(500), 1), 2);
    measure("cube", 3, inputs::uniform(3, n(1000)), 1);
    measure("cube", 3, inputs::uniform(3, n(2000)), 1);
    measure("clifford", 4, inputs::clifford(n(300)), 1);
    measure("cube", 6, inputs::uniform(6, n(50)), 5);
    measure("cube", 3, inputs::uniform(3, n(4000)), 2, 0.05);
    measure("cube", 4, inputs::uniform(4, n(4000)), 1, 0.1);
    measure("square", 2, inputs::uniform(2, n(10000)), 1);
    measure("square", 2, inputs::uniform(2, n(100000)), 1);
    measure("cube", 3, inputs::uniform(3, n(100000)), 1);
    measure("square", 2, inputs::uniform(2, n(1000000)), 1);
    return 0;
}
