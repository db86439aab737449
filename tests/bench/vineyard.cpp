// Vineyards of the distance to the k-th nearest point, k = 1, 2, ..: processor time and what a transposition takes, and
// whether each diagram is the one that is computed for its k alone.
//
//   vineyard [points, 40] [filtrations, 20] [D, 3]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "common/inputs.hpp"
#include "common/session.hpp"

namespace {

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

bool before(const netmesh_pair& a, const netmesh_pair& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
}

// How many of the diagrams are those of netmesh_persist.
std::uint32_t equal_diagrams(Session& session, std::vector<std::vector<netmesh_pair>> diagrams, double* took) {
    std::uint32_t equal = 0;
    const double start = seconds();
    for (std::uint32_t k = 1; k < diagrams.size(); ++k) {
        if (session.persist(persist_by(&netmesh_filter_knn, k)) != NETMESH_OK) continue;
        const std::vector<netmesh_pair> fresh = session.pairs();
        std::sort(diagrams[k].begin(), diagrams[k].end(), before);
        const auto same = [](const netmesh_pair& a, const netmesh_pair& b) {
            return a.degree == b.degree && a.birth == b.birth && a.death == b.death;
        };
        equal += std::equal(fresh.begin(), fresh.end(), diagrams[k].begin(), diagrams[k].end(), same) ? 1 : 0;
    }
    *took = seconds() - start;
    return equal;
}

}  // namespace

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const auto points = static_cast<std::size_t>(argument(1, 40));
    const auto filtrations = static_cast<std::uint32_t>(argument(2, 20));
    const int dim = argument(3, 3);
    Session session(dim);
    session.reserve(std::size_t{1} << 34);  // little of that is used, the rest costs nothing
    if (session.mesh(inputs::uniform(dim, points), &netmesh_filter_complete) != NETMESH_OK) return 1;
    const double start = seconds();
    const netmesh_status status = session.vineyard(&netmesh_filter_knn, 1, filtrations);
    const double took = seconds() - start;
    const netmesh_report report = session.report();
    const netmesh_vineyard_report& made = report.vineyard;
    std::vector<std::vector<netmesh_pair>> diagrams(filtrations + 1);
    for (const netmesh_vine_point& p : read_all(session.context, netmesh_get_vine_point))
        diagrams[p.k].push_back(bar(p.degree, p.birth, p.death));
    double fresh;
    const std::uint32_t equal = equal_diagrams(session, diagrams, &fresh);
    std::printf("%u filtrations of %llu simplices in D = %d: %s, %.2f s, %llu transpositions at %.0f ns, %.1f MiB; "
                "%llu vines; %u diagrams are those of fresh computations, which take %.2f s\n",
                filtrations, static_cast<unsigned long long>(made.simplices), dim, netmesh_status_text(status), took,
                static_cast<unsigned long long>(made.transpositions), took / double(made.transpositions) * 1e9,
                double(report.memory.peak_bytes) / 1048576, static_cast<unsigned long long>(made.vines), equal, fresh);
    return status == NETMESH_OK && equal == filtrations ? 0 : 1;
}
