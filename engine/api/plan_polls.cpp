// Polls to plan for. Work is reported in units, and a poll takes up at least Monitor::interval of them, so there are at
// most units / interval polls.
//
// Typical: units are in proportion to planned bytes, as measured on uniform points.
//
// At most, of n points in R^D, with p = floor(D / 2): by the upper bound theorem (McMullen, 1970; of spheres: Stanley,
// 1975) a triangulated (d-1)-sphere of m vertices has no more facets than the cyclic d-polytope, whose number is
// facets_most. The triangulation with infinity is a D-sphere of n + 1 vertices; perturbation keeps it one where points
// are cospherical. The new cells of an insertion are the star of a vertex, whose link is a (D-1)-sphere of the vertices
// before it at most. A k-face is in D + 1 - k cells or more, as its link is a sphere. What these items cost in reports
// is summed below, loop by loop, from what their loops say of themselves.
#include "api/plan.hpp"
#include "api/settle.hpp"
#include "filtration/filters.hpp"
#include "numerics/minors.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {
namespace {

// Units a planned byte, as measured on uniform points: of triangulations, of meshes by tau, of these with their
// diagram, of scales by a ratio. From D = 4 on those of 4.
struct WorkFigures {
    double triangulation, mesh, filtered, scales_by_ratio;
};
constexpr WorkFigures work_figures(std::uint32_t dim) {
    return dim == 2   ? WorkFigures{0.07, 0.23, 0.3, 0.9}
           : dim == 3 ? WorkFigures{0.085, 0.17, 0.22, 0.35}
                      : WorkFigures{0.2, 0.22, 0.33, 0.35};
}
constexpr double alpha_units = 0.27, scales_units = 0.25, cech_units = 0.16, barycentric_units = 0.35,
                 rips_units = 0.08;
// Times what other meshes take: of the cages of the thesis, and VoronoiRefine.
constexpr double thesis_share = 4, refine_share = 1.3;
// By how many units the report that leads to a poll is late in the mean.
constexpr double late_units = 10;

// Facets of a cyclic d-polytope of m vertices, m > d.
[[gnu::cold]] double facets_most(double m, int d) {
    const int p = d / 2;
    double choose = d % 2 == 0 ? m / (m - p) : 2;  // times binomial(q, p), q = m - p or m - p - 1
    const double q = d % 2 == 0 ? m - p : m - p - 1;
    for (int i = 0; i < p; ++i) choose *= (q - i) / (i + 1);
    return choose;
}

// Units of all loops over items of one kind, by the item: a 256th of the instructions that they say they take.
constexpr double linear = 8;
// Of sorting, by the item: levels of splitting, and a heap where these do not get on.
constexpr double sorted = 80;
// Of what pieces report that are not full: four times the instructions of one step in each loop.
constexpr double begun = 3000, begun_each = 2000;  // and by the dimension

[[gnu::cold]] double triangulation_units(double n, int D) {
    const double cells = facets_most(n + 1, D + 1), squares = n * n;
    // The sum of facets_most(m, D) over m up to n: its leading term, of n + 1.
    const double share = ByDimension<double>{{1.0 / 2, 1, 1.0 / 6, 1.0 / 3, 1.0 / 24}}.at(D);
    double made = share;
    for (int i = 0; i <= D / 2; ++i) made *= n + 1;
    // Points of one key are given keys anew until each has another; every time at least one of them gets one, so less
    // than n times.
    const double order = squares * (D / 2.0 + 3) + n * (130 * D + 700);
    // Kernels report making and linking of many cells as well. From R^4 on they report tests that doubles do not
    // decide: of cells in conflict and, once for each of their facets, of those about them.
    const double reports = D == 2 ? 1 : 3, tested = D > 3 ? n * (D + 2) * cells * 2 * D : 0;
    return begun + begun_each * D + order + 2 * n + (D - 1) * reports * made + tested + linear * D * (n + cells);
}

// Listing the complex, values and reduction.
[[gnu::cold]] double filtered_units(double n, int D) {
    const double cells = facets_most(n + 1, D + 1);
    double faces[NETMESH_DIM_MAX + 1], all = 0;
    for (int k = 0; k <= D; ++k) {
        faces[k] = k == 0 ? n : cells * binomial(D + 1, k + 1) / (D + 1 - k);
        all += faces[k];
    }
    double units = n * (8 << D) + (D + 1) * cells + all * linear * D;  // stars, and what is made of them
    units += all * (D + 40 * D) + all * 2 * sorted;                    // values, all exact (circumsphere_settle.hpp)
    units += 2 * all;  // unions of vertices and of cells; between these columns, to which each row adds one at most
    for (int k = 2; k < D; ++k) units += faces[k] * (1 + faces[k - 1] * (1 + faces[k - 1] / 16));
    return units + begun + begun_each * D;
}

// What is known of the work of a request.
struct PlannedWork {
    std::size_t bytes = 0;
    double units_each = 0;  // a byte
    double units_most = 0;  // 0: without bound
};

std::uint64_t whole_polls(double polls) { return polls < 0x1p63 ? static_cast<std::uint64_t>(polls) + 1 : UINT64_MAX; }

[[gnu::cold]] std::uint64_t polls_of(const PlannedWork& work, std::uint64_t* most) {
    const bool is_refused = work.bytes == 0;
    if (most != nullptr)
        *most = is_refused ? 0 : work.units_most > 0 ? whole_polls(work.units_most / Monitor::interval) : UINT64_MAX;
    const double units = static_cast<double>(work.bytes) * work.units_each;
    return is_refused ? 0 : whole_polls(units / (Monitor::interval + late_units));
}

// Of nothing but triangulations and alpha complexes of points.
bool is_bounded(const netmesh_request& r) {
    return r.periods == nullptr && r.bounds == nullptr && r.cycles == nullptr && r.vines == nullptr && r.fit == nullptr;
}

// Diagrams take the same work with and without what stays.
netmesh_request without_mesh(netmesh_request r) {
    r.keep_mesh = 0;
    r.cycles = nullptr;
    return r;
}

[[gnu::cold]] double most_of(const netmesh_request& r, bool with_diagram) {
    if (!is_bounded(r)) return 0;
    const double least = r.points.dim + 2, n = static_cast<double>(r.points.count);
    const int D = static_cast<int>(r.points.dim);
    const double points = n > least ? n : least;  // fewer than make two cells are no exception
    return triangulation_units(points, D) + (with_diagram ? filtered_units(points, D) : 0);
}

[[gnu::cold]] double mesh_units(const netmesh_request& r, double each) {
    const netmesh_method* const method = r.mesh.method;
    if (method == nullptr) return each;
    return each * (method->id == NETMESH_METHOD_THESIS   ? thesis_share
                   : method->id == NETMESH_METHOD_REFINE ? refine_share
                                                         : 1);
}

// Of a request that is settled.
[[gnu::cold]] PlannedWork work_of_diagram(const netmesh_request& r, std::size_t bytes) {
    const WorkFigures figures = work_figures(r.points.dim);
    if (source_of(r) != Source::points) return {bytes, rips_units};
    if (r.filter->id == NETMESH_FILTER_AUTO) return {whole_bytes(plan_of_alpha(without_mesh(r))), alpha_units};
    switch (find_filter(r.filter->id)->source) {
    case FilterSource::delaunay:
        if (r.periods != nullptr) return {bytes, alpha_units};
        return {whole_bytes(plan_of_alpha(without_mesh(r))), alpha_units, most_of(r, true)};
    case FilterSource::points:
        return {bytes, r.filter->id == NETMESH_FILTER_RIPS   ? rips_units
                       : r.filter->id == NETMESH_FILTER_CECH ? cech_units
                                                             : barycentric_units};
    case FilterSource::scales: return {bytes, r.goal.ratio > 0 ? figures.scales_by_ratio : scales_units};
    case FilterSource::mesh: break;
    }
    return {bytes, mesh_units(r, figures.filtered)};
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" [[gnu::cold]] uint64_t netmesh_plan_polls(const netmesh_request* from, uint64_t* most) {
    netmesh_request request;
    const std::size_t bytes = netmesh_plan(from);
    if (bytes == 0 || read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE ||
        settle(Call::persist, 0, &request).text != nullptr)
        return polls_of({}, most);
    return polls_of(work_of_diagram(request, bytes), most);
}

extern "C" [[gnu::cold]] uint64_t netmesh_plan_mesh_polls(const netmesh_request* from, uint64_t* most) {
    netmesh_request request;
    const std::size_t bytes = netmesh_plan_mesh(from);
    if (bytes == 0 || read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE ||
        settle(Call::mesh, 0, &request).text != nullptr)
        return polls_of({}, most);
    const netmesh_method* const method = request.mesh.method != nullptr ? request.mesh.method : request.filter->by_tau;
    const WorkFigures figures = work_figures(request.points.dim);
    if (!method->keeps_few && !method->triangulates())
        return polls_of({bytes, mesh_units(request, figures.mesh)}, most);
    return polls_of({bytes, figures.triangulation, most_of(request, false)}, most);
}
