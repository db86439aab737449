// Rips diagrams in processor time and memory, and the same by ripser where one is on the path.
//
//   rips [factor on the numbers of points, 1]
#include <sys/resource.h>

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

// Processor time of ripser on these points, less than 0 without one.
double ripser(int dim, const inputs::Points& points, int max_degree) {
    if (std::system("command -v ripser >/dev/null 2>&1") != 0) return -1;
    std::string command = "ripser --format point-cloud --dim " + std::to_string(max_degree) + " >/dev/null";
    const double start = seconds_of_children();
    std::FILE* const pipe = popen(command.c_str(), "w");
    if (pipe == nullptr) return -1;
    for (std::size_t i = 0; i < points.size(); ++i)
        std::fprintf(pipe, "%.17g%c", points[i], (i + 1) % static_cast<std::size_t>(dim) == 0 ? '\n' : ' ');
    return pclose(pipe) == 0 ? seconds_of_children() - start : -1;
}

void measure(const char* name, int dim, const inputs::Points& points, int max_degree) {
    Session session(dim);
    session.reserve(std::size_t{1} << 34);  // little of that is used, the rest costs nothing
    const double start = seconds();
    const netmesh_status status = session.persist_until_it_fits(
        session.points_request(points, &netmesh_filter_rips, 1, static_cast<std::uint32_t>(max_degree)));
    const double took = seconds() - start;
    std::printf("%-8s %5zu points, degrees to %d: %8.3f s %8.1f MiB (%s)", name,
                points.size() / static_cast<std::size_t>(dim), max_degree, took,
                static_cast<double>(session.report().memory.peak_bytes) / 1048576, netmesh_status_text(status));
    const double theirs = ripser(dim, points, max_degree);
    if (theirs < 0) {
        std::printf("  no ripser on the path\n");
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
    return 0;
}
