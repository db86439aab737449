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
#include "predicates/predicates.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {
namespace {

// Units of 1,000 planned bytes, as measured on uniform points: of triangulations, of meshes by tau, of these with their
// diagram, of scales by a ratio. From D = 4 on those of 4.
struct WorkFigures {
    int triangulation, mesh, filtered, scales_by_ratio;
};
constexpr WorkFigures work_figures(std::uint32_t dim) {
    return dim == 2   ? WorkFigures{70, 230, 300, 900}
           : dim == 3 ? WorkFigures{85, 170, 220, 350}
                      : WorkFigures{200, 220, 330, 350};
}
// few: of triangulations in short words (delaunay_small).
constexpr int few_units = 165, alpha_units = 270, scales_units = 250, cech_units = 160, barycentric_units = 350,
              rips_units = 80;
// Tenths of what other meshes take: of the cages of the thesis, and VoronoiRefine.
constexpr int thesis_share = 40, refine_share = 13;
// By how many units the report that leads to a poll is late in the mean.
constexpr int late_units = 10;

// Facets of a cyclic d-polytope of m vertices, m > d.
[[gnu::cold]] double facets_most(double m, int d) {
    const int p = d / 2;
    double choose = d % 2 == 0 ? m / (m - p) : 2;  // times binomial(q, p), q = m - p or m - p - 1
    const double q = d % 2 == 0 ? m - p : m - p - 1;
    for (int i = 0; i < p; ++i) choose *= (q - i) / (i + 1);
    return choose;
}

// Units of all loops over items of one kind, by the item: a 256th of the instructions that they say they take.
constexpr int linear = 8;
// Of sorting, by the item: levels of splitting, and a heap where these do not get on.
constexpr int sorted = 80;
// Of what pieces report that are not full: four times the instructions of one step in each loop.
constexpr int begun = 3000, begun_each = 2000;  // and by the dimension

// with_diagram: the complex is listed, filtered and reduced as well.
[[gnu::cold]] double units_most(double n, int D, bool with_diagram) {
    const double cells = facets_most(n + 1, D + 1);
    // The sum of facets_most(m, D) over m up to n: its leading term, of n + 1.
    double made = 1.0 / ByDimension<int>{{2, 1, 6, 3, 24}}.at(D);
    for (int i = 0; i <= D / 2; ++i) made *= n + 1;
    // Runs of points of one key are given keys anew, each of which splits the run: less than n times, of n^2 / 2 points
    // in all (delaunay/spatial_order.cpp). A point takes D / 2 + 4 units, most of them to be sorted.
    double units = n * n * (D + 7) / 2 + n * (130 * D + 700);
    // Kernels report making and linking of many cells as well.
    units += 2 * n + (D - 1) * (D == 2 ? 1 : 3) * made;
    // Tests that doubles do not decide: a few as a point is located, and of cells in conflict and, once for each of
    // their facets, of those about them. No more cells come in conflict than are made. In the plane there are as many
    // facets about them as cells are made.
    units += undecided_units * (3 * n + (D == 2 ? 2 : D + 2) * made);
    // A walk comes to no cell twice. One by exact signs may follow one by doubles.
    units += n * cells * (5.0 * D / 32 + exact_step_units);
    units += begun + begun_each * D + linear * D * (n + cells);
    if (!with_diagram) return units;

    double below = n;  // faces of one dimension less
    units += begun + begun_each * D + n * (8 << D) + (D + 1) * cells;
    for (int k = 0; k <= D; ++k) {
        const double faces = k == 0 ? n : cells * binomial(D + 1, k + 1) / (D + 1 - k);
        // Lists; values, all exact (circumsphere_settle.hpp); sorted, and once more as pairs; in unions.
        units += faces * (linear * D + D + 40 * D + 2 * sorted + 2);
        // Between the unions of vertices and of cells columns, to which each row adds one at most.
        if (k >= 2 && k < D) units += faces * (1 + below * (1 + below / 16));
        below = faces;
    }
    return units;
}

std::uint64_t whole_polls(double polls) { return polls < 0x1p63 ? static_cast<std::uint64_t>(polls) + 1 : UINT64_MAX; }

// Of nothing but triangulations and alpha complexes of points.
bool is_bounded(const netmesh_request& r) {
    return r.periods == nullptr && r.bounds == nullptr && r.cycles == nullptr && r.vines == nullptr && r.fit == nullptr;
}

// Units of 1,000 planned bytes of a diagram. Of the alpha complex without a triangulation that is kept, as its bytes
// are no more work.
[[gnu::cold]] int units_each(const netmesh_request& r, const WorkFigures& figures) {
    if (source_of(r) != Source::points || r.filter->id == NETMESH_FILTER_RIPS) return rips_units;
    if (r.filter->id == NETMESH_FILTER_AUTO) return alpha_units;
    switch (find_filter(r.filter->id)->source) {
    case FilterSource::delaunay: return alpha_units;
    case FilterSource::points: return r.filter->id == NETMESH_FILTER_CECH ? cech_units : barycentric_units;
    case FilterSource::scales: return r.goal.ratio > 0 ? figures.scales_by_ratio : scales_units;
    case FilterSource::mesh: break;
    }
    return figures.filtered;
}

[[gnu::cold]] std::uint64_t polls_of(const netmesh_request* from, Call call, std::uint64_t* most) {
    netmesh_request r;
    if (most != nullptr) *most = 0;
    if (read_struct(from, &r, sizeof r) != NETMESH_FIELD_NONE || settle(call, 0, &r).text != nullptr) return 0;
    const bool has_diagram = call == Call::persist;
    std::size_t bytes = has_diagram ? bytes_of_diagram(r) : bytes_of_cells(r);
    if (bytes == 0) return 0;
    const WorkFigures figures = work_figures(r.points.dim);
    const netmesh_method* const method =
        r.mesh.method != nullptr || r.filter == nullptr ? r.mesh.method : r.filter->by_tau;
    int each = has_diagram ? units_each(r, figures) : figures.mesh, tenths = 10;
    bool has_bound = is_bounded(r);
    if (each == alpha_units && r.periods == nullptr) {
        has_bound = has_bound && r.filter->id != NETMESH_FILTER_AUTO;
        r.keep_mesh = 0;
        bytes = whole_bytes(plan_of_alpha(r));
    } else if (!has_diagram && (method->keeps_few || method->triangulates())) {
        each = method->keeps_few ? few_units : figures.triangulation;
    } else {
        has_bound = false;
        if (method != nullptr && method->id == NETMESH_METHOD_THESIS) tenths = thesis_share;
        if (method != nullptr && method->id == NETMESH_METHOD_REFINE) tenths = refine_share;
    }
    if (most != nullptr) *most = UINT64_MAX;
    if (most != nullptr && has_bound) {
        const double n = static_cast<double>(r.points.count), least = r.points.dim + 2;
        const double units = units_most(n > least ? n : least, static_cast<int>(r.points.dim), has_diagram);
        *most = whole_polls(units / Monitor::interval);
    }
    return whole_polls(static_cast<double>(bytes) * (each * tenths) / (10'000.0 * (Monitor::interval + late_units)));
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" uint64_t netmesh_plan_polls(const netmesh_request* request, uint64_t* most) {
    return polls_of(request, Call::persist, most);
}

extern "C" uint64_t netmesh_plan_mesh_polls(const netmesh_request* request, uint64_t* most) {
    return polls_of(request, Call::mesh, most);
}
