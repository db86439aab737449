// Bytes of block to plan for, as measured on uniform points: the peaks of triangulations and of alpha complexes; of
// meshes in the plane and in space the vertices, and the bytes that each of them takes; of others how many vertices and
// cells there will be (vocabulary/dimension.hpp), and what one of them takes is the size of what is placed.
#include "api/plan.hpp"

#include "api/plan_figures.hpp"
#include "api/settle.hpp"
#include "complex/triangulation.hpp"
#include "delaunay/store.hpp"
#include "filtration/filters.hpp"
#include "filtration/mesh_filter.hpp"
#include "filtration/scale_partition.hpp"
#include "filtration/tight_filter.hpp"
#include "jobs/alpha_of_points.hpp"
#include "jobs/scale_grid.hpp"
#include "mesh/audit/ball_lists.hpp"
#include "mesh/audit/observers.hpp"
#include "mesh/cages/cage_template.hpp"
#include "mesh/cages/hierarchy.hpp"
#include "numerics/elementary.hpp"

namespace netmesh {
namespace {

// From D = 4 on, and of audits: covers other seeds and small sets.
constexpr double plan_margin = 1.3;
// Of VoronoiRefine's sphere in R^4, on 100 to 300 uniform points at the default tau.
constexpr double boundary_net_vertices = 17000, boundary_net_cells = 17 * boundary_net_vertices;
// Small sets are all boundary: a frame, its ghosts, and the cells that join them to the points.
struct Boundary {
    double vertices, cells;
};
constexpr Boundary whole_boundary = {100, 64};
constexpr double block_overhead = 16384;

// Bytes a simplex, measured with what reductions fill in: gradient and critical columns of a filter on a mesh.
constexpr double gradient_bytes = 8;

// Of bounds: tables of a filter's values or of covers, whichever is more; a bar's claims, its bounds twice, and its
// part in the join. Bars of each degree are as many as points at most, as measured.
constexpr double bounds_vertex_bytes = 48, bounds_bar_bytes = 288;
// Of representatives: a bar twice, and the points of its cycle in the mesh and in the result.
constexpr double chain_bytes = 256;

double power_in_eighths(double x, int k) {
    const double root = square_root(square_root(square_root(x)));
    double p = 1;
    for (int i = 0; i < k; ++i) p *= root;
    return p;
}

// How much of everything there will be.
struct Amounts {
    double points, vertices, cells;
    double boundary_cells = whole_boundary.cells;
};

// What is planned for, besides vertices and cells.
struct Planned {
    bool hierarchy = false;
    bool location = false, quality = false;  // audits
    bool filter = false;                     // values and diagram of a filter on a mesh
    bool scales = false;
    bool bounds = false, representatives = false;  // with scales
};

// Of a mesh of aspect ratio tau; eps: over-refined to that many f_P, 0: not; surroundings: points that a larger domain
// counts for.
template <int D>
Amounts mesh_amounts(double points, double tau, double eps, double surroundings, Boundary boundary = whole_boundary) {
    double vertices = points * (1 + figures<D>.growth / power_in_eighths(tau - 2, figures<D>.growth_eighths));
    vertices += boundary.vertices;
    double fine = eps > 0 ? (points + surroundings) * figures<D>.over_refined : 0;
    for (int k = 0; k < D && eps > 0; ++k) fine /= eps;
    if (fine > vertices) vertices = fine;
    return {points, vertices, vertices * figures<D>.mesh_cells_per_vertex, boundary.cells};
}

// Shells of cages of the thesis, one a point, each of them grown once.
template <int D> Amounts with_thesis_shells(Amounts amounts) {
    if constexpr (D <= thesis_dim_max) {
        const double shells = 2 * amounts.points * CageTemplate<D>::size + RootTemplate<D>::size;
        amounts.vertices += shells;
        amounts.cells += shells * figures<D>.mesh_cells_per_vertex;
    }
    return amounts;
}

// What is not refined around the points when cells are clipped: from D = 4 on a good part of a mesh. Measured on 40 to
// 800 uniform points in R^4: .54 to .82 of the vertices are left.
Amounts without_surroundings(const Amounts& amounts) {
    const double left = 1 - 0.75 / square_root(square_root(amounts.points > 16 ? amounts.points : 16));
    return {amounts.points, amounts.vertices * left, amounts.cells * left, amounts.boundary_cells};
}

// Next to nothing is refined beyond the ball either. Measured on 1 to 320 uniform points, D = 4, 5, 6, five seeds,
// ratios 2.3 to 8: what meshes and scales take is at most .68 of the plan.
template <int D> constexpr Boundary clipped_boundary = D < 4 ? whole_boundary : Boundary{8, 6};

template <int D> double block_bytes(const Amounts& n, const Planned& planned) {
    using Tree = InputTree<D>;
    const double order_bytes = sizeof(std::uint32_t);  // a point's place in the order of insertion
    double bytes = n.vertices * sizeof(Vertex<D>) + n.cells * sizeof(Cell<D>);
    bytes += (order_bytes + Tree::input_bytes) * n.points;
    if (planned.hierarchy || planned.location) bytes += (Hierarchy<D>::input_bytes + Tree::ring_bytes) * n.points;
    if (planned.quality) bytes += AuditScratch::vertex_bytes * n.vertices + AuditScratch::cell_bytes * n.cells;
    if (planned.quality && planned.hierarchy) bytes += Observers::note_bytes * n.points;
    if (planned.location) {
        bytes += BallLists::cell_bytes * n.cells + BallLists::input_bytes * n.points;
        bytes += order_bytes * n.points;  // turns of the inputs, drawn by the lists
        // Lists take their share of what is left of the block.
        const double lists = sizeof(BallLists::Entry) * figures<D>.audit_balls_per_point * n.points;
        if (bytes < 3 * lists) bytes = 3 * lists;
        bytes += bytes / 3;
    }
    const double simplices = n.cells * figures<D>.simplices_per_cell;
    if (planned.filter) {
        // Scratch first takes what the balls of cells leave (delaunay/packed_cells.hpp).
        const double scratch = mesh_filter_vertex_bytes * n.vertices + gradient_bytes * simplices;
        const double balls = (8 * D + 16) * n.cells;
        bytes += sizeof(double) * n.vertices + (scratch > balls ? scratch - balls : 0);
    }
    if (planned.bounds) {
        bytes += (sizeof(Interval) + bounds_vertex_bytes) * n.vertices + bounds_bar_bytes * D * n.points;
        bytes += sizeof(ScaleStep) * 2.0 * ScaleGrid::cells_max / plan_margin;  // the grid, and the steps made of it
    }
    if (planned.representatives) bytes += sizeof(std::uint32_t) * (n.cells + n.vertices) + chain_bytes * D * n.points;
    if (planned.scales) bytes += n.points * (sizeof(Vertex<D>) + ScalePartition::point_bytes + order_bytes);
    return plan_margin * bytes + sizeof(netmesh_context) + block_overhead +
           n.boundary_cells * sizeof(Cell<D>) * figures<D>.mesh_cells_per_vertex;
}

// A few points take more than the figures say, which are for 60 and more.
double alpha_block(const PeakFigures& figures, double points, int D) {
    const double peak = figures.at(points, D), least = D == 2 ? 3700 + 52 * points : D == 3 ? 4000 + 440 * points : 0;
    return least > peak ? least : peak;
}

// With a cycle for each bar of a diagram that takes `bytes` with its triangulation: measured on 12 to 10,000 uniform
// points (D = 2, 3), 3,000, 1,000 and 100 (4, 5, 6), at most .997 of it.
double with_cycles(double bytes, double points, int D) {
    const double more = D == 2 ? 400 + 427 * points : (D == 3 ? 1.2 : D == 4 ? 1.06 : 1) * bytes;
    const double least = D == 2 ? 19000 + 245 * points : D == 3 ? 17500 + 620 * points : 0;
    return least > more ? least : more;
}

// What a mesh is made for.
struct MeshKind {
    double tau = 0, ratio = 0;  // one of them
    double eps = 0;
    bool clipped = false, shell = false, net = false, cages = false, thesis = false;
};

template <int D> double planned_vertices(const MeshKind& kind, double points) {
    constexpr const MeshFigures& f = MeshFiguresOf<D>::value;
    constexpr double root2 = 1.4142135624, taus[3] = {f.tau[0] - 2, f.tau[1] - 2, f.tau[2] - 2};
    double places[ratio_places];
    for (int i = 0; i < ratio_places; ++i) places[i] = ratios[i] - root2;
    const double n = points > 100 ? points : 100, spread = points > f.spread_from ? points : f.spread_from;
    double growth = kind.ratio > 0 ? interpolated(kind.ratio - root2, places, f.by_ratio)
                                   : interpolated(kind.tau - 2, taus, f.by_tau);
    const double shell = kind.shell ? f.shell * square_root(growth) * to_power(n, f.shell_power) : 0;
    if (kind.cages && !kind.thesis) growth *= f.cages_growth;
    double vertices = points * (1 + growth * (1 + f.spread_root / square_root(spread) + f.spread / spread)) + shell;
    if (points < 100) vertices += (D == 3 ? 3.8 : 1) * (100 - points);
    if (kind.net) vertices += f.net_fixed + f.net * to_power(n, f.net_power) + f.net_each * points;
    if constexpr (D <= thesis_dim_max)
        if (kind.thesis) vertices += 1.55 * RootTemplate<D>::size;
    double fine = kind.eps > 0 ? f.sizes : 0;
    for (int k = 0; k < D && kind.eps > 0; ++k) fine /= kind.eps;
    if (fine > 0) fine = points * (f.sizes_each + fine) * (1 + 3.2 / square_root(points));
    return fine > vertices ? fine : vertices;
}

constexpr int mesh_figures_dim_max = 4;
constexpr double mesh_overhead = 6500;

// What scales take besides the largest mesh: the points with their partition; bounds and cycles.
template <int D> double scales_block(double vertices, double points, const Planned& planned) {
    double bytes = points * (sizeof(Vertex<D>) + ScalePartition::point_bytes + sizeof(std::uint32_t));
    constexpr double bars = D < 4 ? 275 : bounds_bar_bytes * D, steps = 16384;
    if (planned.bounds) bytes += (sizeof(Interval) + bounds_vertex_bytes) * vertices + bars * points + steps;
    // Cycles take the place of bounds.
    const double cycles =
        sizeof(std::uint32_t) * (figures<D>.mesh_cells_per_vertex + 1) * vertices + chain_bytes * D * points;
    if (planned.representatives) bytes += planned.bounds && D < 4 ? chain_bytes / 8 * points : cycles;
    return bytes;
}

// The larger of the peaks while it is made and, with `filter`, while it is filtered.
template <int D> double mesh_block(const MeshKind& kind, double points, const Planned& planned) {
    constexpr const MeshFigures& f = MeshFiguresOf<D>::value;
    MeshKind plain = kind;
    plain.cages = false;
    const double vertices = planned_vertices<D>(plain, points), tables = 9 * points + mesh_overhead;
    double bytes = vertices * f.made + tables;
    if (planned.hierarchy) {
        const double caged = planned_vertices<D>(kind, points) * f.with_cages + tables;
        if (!kind.cages) bytes *= 1.03;
        if (caged > bytes || kind.cages) bytes = caged;
    }
    const double each = kind.eps > 0 ? f.fine : kind.clipped ? f.clipped : f.whole;
    const double filtered = vertices * each + f.pairs * points + mesh_overhead;
    return planned.filter && filtered > bytes ? filtered : bytes;
}

// A mesh that certifies a ratio takes no more than one of the aspect ratio that proves it.
double equivalent_tau(double ratio) {
    const double equivalent = ratio * ratio - 2;
    return equivalent > 2.1 ? equivalent : 2.1;
}

}  // namespace

std::size_t whole_bytes(double bytes) {
    if (bytes == 0) return 0;
    if (!(bytes < 0x1p62) || bytes >= static_cast<double>(SIZE_MAX / 2)) return SIZE_MAX;
    return (static_cast<std::size_t>(bytes) + Arena::alignment) & ~(Arena::alignment - 1);
}

double plan_of_triangulation(const netmesh_points& points, bool with_diagram) {
    const DelaunayFigures& f = delaunay_figures_of(points.dim);
    const double n = static_cast<double>(points.count);
    const int D = static_cast<int>(points.dim);
    return with_diagram ? alpha_block(f.filtered, n, D) : f.triangulated.at(n, D);
}

double plan_of_alpha(const netmesh_request& r) {
    const double n = static_cast<double>(r.points.count);
    const int D = static_cast<int>(r.points.dim);
    if (r.cycles != nullptr) return with_cycles(plan_of_triangulation(r.points, true), n, D);
    if (r.keep_mesh != 0) return plan_of_triangulation(r.points, true);
    if (D == 2 && r.weighting == nullptr)
        return alpha_block(r.points.count <= few_points_max ? plane_figures_few : plane_figures, n, D);
    const std::size_t exact = r.weighting != nullptr ? exact_power_bytes * (r.points.dim + 3) : 0;
    return alpha_block(delaunay_figures_of(r.points.dim).diagram, n, D) + static_cast<double>(exact);
}

// With those about them a leaf's points are as many as fit a skin of 1.6 spacings around them (stars.cpp), and all at
// most. What one of them takes, and in R^4 and above what one of the leaf's own takes besides, are so many times what a
// point takes in one block: measured on 1e3 to 5e4 points a leaf in the plane and in space, 375 to 2,000 in R^4, 150 to
// 250 in R^5, 150 in R^6.
double plan_of_leaf(std::uint32_t dim, std::uint64_t points, std::uint32_t pieces) {
    const int D = static_cast<int>(dim);
    const double of_near = D < 4 ? 3 : D == 4 ? 0.8 : 1.3, of_own = D < 4 ? 0 : 4;
    const double all = static_cast<double>(points), own = all / pieces, skin = 1 + 3.2 * to_power(own, -1.0 / D);
    double near = own;
    for (int k = 0; k < D; ++k) near *= skin;
    near = near < all ? near : all;
    return block_overhead + delaunay_figures_of(dim).diagram.at(near, D) * (of_near + of_own * own / near);
}

double plan_of_mesh(const netmesh_request& r, bool with_diagram) {
    ErrorSizes sizes;
    const MeshRequest asked = mesh_request_of(r, r.points.dim, &sizes);
    const bool certifies = asked.method == MeshMethod::certificate, net = asked.method == MeshMethod::reference,
               thesis = asked.cages == CageKind::thesis;
    const double ratio = certifies ? asked.goal.ratio : 0;
    const double tau = certifies ? equivalent_tau(ratio) : asked.tau;
    Planned planned;
    planned.hierarchy = asked.method == MeshMethod::hierarchy;
    planned.location = asked.audit_location;
    planned.quality = asked.audit_quality;
    planned.filter = with_diagram;
    return with_dimension(r.points.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const double points = static_cast<double>(r.points.count);
        const double surroundings = r.goal.eps > 0 ? figures<D>.tight_surroundings : 0;
        const bool clipped = asked.goal.clipped;
        if constexpr (D <= mesh_figures_dim_max) {
            const bool unknown = D > 3 && (net || asked.size.eps > 0 || thesis);
            if (!unknown && !planned.location && !(planned.quality && (planned.hierarchy || D > 3))) {
                MeshKind kind = {tau, ratio, asked.size.eps};
                kind.clipped = clipped;
                kind.shell = r.filter != nullptr && !clipped;
                kind.net = net;
                kind.cages = planned.hierarchy && !asked.finish;
                kind.thesis = thesis;
                return mesh_block<D>(kind, points, planned);
            }
        }
        const Boundary boundary = clipped ? clipped_boundary<D> : whole_boundary;
        Amounts amounts = mesh_amounts<D>(points, tau, asked.size.eps, surroundings, boundary);
        if (thesis) amounts = with_thesis_shells<D>(amounts);
        if (net) {
            amounts.vertices += boundary_net_vertices;
            amounts.cells += boundary_net_cells;
        }
        if (D >= 4 && clipped) amounts = without_surroundings(amounts);
        return block_bytes<D>(amounts, planned);
    });
}

double plan_of_scales(const netmesh_request& r) {
    const double eps = r.goal.eps, theta = r.goal.theta, ratio = r.goal.ratio;
    const double tau = ratio > 0 ? equivalent_tau(ratio / (1 + 3 * theta)) : r.mesh.tau;
    Planned planned;
    planned.filter = planned.scales = true;
    planned.bounds = r.bounds != nullptr;
    planned.representatives = r.cycles != nullptr;
    return with_dimension(r.points.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const double points = static_cast<double>(r.points.count);
        if constexpr (D <= mesh_figures_dim_max)
            if (D < 4 || ratio > 0) {
                MeshKind kind = {tau, ratio > 0 ? ratio / (1 + 3 * theta) : 0, ratio > 0 ? 0 : tight_size(eps)};
                kind.clipped = ratio > 0;
                return mesh_block<D>(kind, points, planned) +
                       scales_block<D>(planned_vertices<D>(kind, points), points, planned);
            }
        if (ratio > 0) {
            const Amounts clipped = mesh_amounts<D>(points, tau, 0, 0, clipped_boundary<D>);
            return block_bytes<D>(D < 4 ? clipped : without_surroundings(clipped), planned);
        }
        return block_bytes<D>(mesh_amounts<D>(points, tau, tight_size(eps), figures<D>.tight_surroundings), planned);
    });
}

double plan_of_diagram(const netmesh_request& r) {
    if (r.periods != nullptr) return plan_with_periods(r);
    if (source_of(r) == Source::distances) return plan_of_distances(r);
    if (source_of(r) == Source::simplices) return plan_of_simplices(r);
    // Uniform points have few cells: auto takes the alpha complex of them, and keeps the triangulation.
    if (r.filter->id == NETMESH_FILTER_AUTO) return plan_of_triangulation(r.points, true) + weight_bytes(r);
    switch (find_filter(r.filter->id)->source) {
    case FilterSource::delaunay: return plan_of_alpha(r) + weight_bytes(r);
    case FilterSource::points: return plan_of_points(r);
    case FilterSource::scales: return plan_of_scales(r);
    case FilterSource::mesh: break;
    }
    return plan_of_mesh(r, true);
}

std::size_t bytes_of_diagram(const netmesh_request& r) {
    return source_of(r) == Source::context ? 0 : whole_bytes(plan_of_diagram(r));
}

std::size_t bytes_of_cells(const netmesh_request& r) {
    const netmesh_method* const method = r.mesh.method != nullptr ? r.mesh.method : r.filter->by_tau;
    if (method->keeps_few) return whole_bytes(few_cells_figures.at(static_cast<double>(r.points.count), 2));
    return whole_bytes(method->triangulates() ? plan_of_triangulation(r.points, false) + weight_bytes(r)
                                              : plan_of_mesh(r, false));
}

}  // namespace netmesh

using namespace netmesh;

extern "C" size_t netmesh_plan_mesh(const netmesh_request* from) {
    netmesh_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    return settle(Call::mesh, 0, &request).text != nullptr ? 0 : bytes_of_cells(request);
}
