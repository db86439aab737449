// The filter auto against either filter on sets of all kinds: how much dearer what it takes is than the other one,
// and what share of it was given up. Processor time, the three in turn, medians. Exits 1 when the filter taken is more
// than twice as dear as the other or more than a quarter was given up.
//
//   bench_auto [repetitions, 5] [kinds whose name begins with.., all] [dimension, all] [points, as listed]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "common/dimensions.hpp"
#include "common/kinds.hpp"
#include "common/session.hpp"

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 33;  // what is not touched costs nothing
constexpr double patience = 20;                            // seconds of processor time for one set, then no more rounds

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

// When a job last polled while it triangulated.
int note_triangulation(void* last, const netmesh_progress* progress) {
    if (progress->stage == NETMESH_STAGE_DELAUNAY) *static_cast<double*>(last) = seconds();
    return 0;
}

struct Trial {
    double seconds, tried;  // tried: of them before the triangulation was whole or given up
    netmesh_status status;
    netmesh_report report;
};

template <class Job> Trial timed(int dim, Job job) {
    Session session(dim);
    session.reserve(block_bytes);
    double last = 0;
    session.request.monitor = {note_triangulation, &last};
    const double start = seconds();
    const netmesh_status status = job(session);
    return {seconds() - start, last > start ? last - start : 0, status, session.report()};
}

Trial alpha(int dim, const inputs::Points& points) {
    return timed(dim, [&](Session& s) {
        netmesh::Request request = s.alpha_request(points);
        request.keep_mesh = 1;
        return s.persist(request);
    });
}

Trial complete(int dim, const inputs::Points& points) {
    return timed(dim, [&](Session& s) { return s.persist(on(points, s.plain(&netmesh_filter_complete))); });
}

Trial chosen(int dim, const inputs::Points& points) {
    return timed(dim, [&](Session& s) { return s.persist(s.auto_request(points)); });
}

// Whether all is well.
bool compare(const kinds::Kind& kind, std::size_t count, std::size_t rounds) {
    const inputs::Points points = kind.make(count);
    std::vector<double> of_alpha, of_complete, of_auto, tried;
    Trial trial = {};
    const double start = seconds();
    while (of_auto.empty() || (of_auto.size() < rounds && seconds() - start < patience)) {
        const Trial exact = alpha(kind.dim, points), meshed = complete(kind.dim, points);
        trial = chosen(kind.dim, points);
        of_alpha.push_back(exact.status == NETMESH_OK ? exact.seconds : INFINITY);
        of_complete.push_back(meshed.status == NETMESH_OK ? meshed.seconds : INFINITY);
        of_auto.push_back(trial.seconds);
        tried.push_back(trial.tried);
    }
    const netmesh_diagram_report& diagram = trial.report.diagram;
    const bool is_alpha = diagram.filter == NETMESH_FILTER_ALPHA;
    const double exact = median(of_alpha), meshed = median(of_complete);
    const double dearer = is_alpha ? exact / meshed : meshed / exact;
    const double wasted = is_alpha ? 0 : median(tried) / median(of_auto);
    const bool is_well = trial.status == NETMESH_OK && dearer <= 2 && wasted <= 0.25;
    std::printf("%-18s %dD %6zu %9.4f %9.4f %9.4f  %-8s %6.2f %6.3f  %6.1f cells a point of %zu%s\n", kind.name,
                kind.dim, static_cast<std::size_t>(trial.report.input.distinct), exact, meshed, median(of_auto),
                is_alpha ? "alpha" : "complete", dearer, wasted,
                static_cast<double>(diagram.tried_cells) / static_cast<double>(diagram.tried_points),
                static_cast<std::size_t>(diagram.tried_points), is_well ? "" : "  <-- not as promised");
    std::fflush(stdout);
    return is_well;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t rounds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 5;
    const char* const name = argc > 2 ? argv[2] : "";
    const int dim = argc > 3 ? std::atoi(argv[3]) : 0;
    const std::size_t count = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 0;
    std::printf("%-18s %2s %6s %9s %9s %9s  %-8s %6s %6s  %s\n", "", "D", "points", "alpha", "complete", "auto",
                "takes", "dearer", "wasted", "tried");
    bool is_well = true;
    for (const kinds::Kind& kind : kinds::all()) {
        if (std::strncmp(kind.name, name, std::strlen(name)) != 0 || (dim != 0 && kind.dim != dim)) continue;
        if (netmesh::serves_dimension(static_cast<std::uint32_t>(kind.dim)))
            is_well = compare(kind, count > 0 ? count : kind.count, rounds) && is_well;
    }
    return is_well ? 0 : 1;
}
