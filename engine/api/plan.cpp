// Bytes of block to plan for, as measured on uniform points: the peaks of triangulations and of alpha complexes; of
// meshes in the plane and in space the vertices, and the bytes that each of them takes; of others how many vertices and
// cells there will be (vocabulary/dimension.hpp), and what one of them takes is the size of what is placed.
#include "api/plan.hpp"

#include "api/mesh_rules.hpp"
#include "api/plan_figures.hpp"
#include "complex/triangulation.hpp"
#include "delaunay/store.hpp"
#include "filtration/mesh_filter.hpp"
#include "filtration/scale_partition.hpp"
#include "filtration/tight_filter.hpp"
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

// A diagram of few points has its peak where radii are put in order by a table of 16 KB, with `share` of what else it
// takes.
template <int D> double alpha_block(const PeakFigures& figures, double points, double share) {
    const double peak = figures.at<D>(points);
    const double ordered = block_overhead + sizeof(netmesh_context) + 256 + share * (peak - figures.fixed);
    return ordered > peak ? ordered : peak;
}

// What a mesh is made for.
struct MeshKind {
    double tau = 0, ratio = 0;  // one of them
    double eps = 0;
    bool clipped = false, shell = false, net = false, cages = false, thesis = false;
};

template <int D> double planned_vertices(const MeshKind& kind, double points) {
    constexpr MeshFigures f = MeshFiguresOf<D>::value;
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
    constexpr double bars = D < 4 ? 215 : bounds_bar_bytes * D, steps = 16384;
    if (planned.bounds) bytes += (sizeof(Interval) + bounds_vertex_bytes) * vertices + bars * points + steps;
    // Cycles take the place of bounds.
    const double cycles =
        sizeof(std::uint32_t) * (figures<D>.mesh_cells_per_vertex + 1) * vertices + chain_bytes * D * points;
    if (planned.representatives) bytes += planned.bounds && D < 4 ? chain_bytes / 8 * points : cycles;
    return bytes;
}

// The larger of the peaks while it is made and, with `filter`, while it is filtered.
template <int D> double mesh_block(const MeshKind& kind, double points, const Planned& planned) {
    constexpr MeshFigures f = MeshFiguresOf<D>::value;
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

template <class Request> bool is_plannable(const Request& request) {
    return complaint_about_dim(request.dim).text == nullptr && request.point_count > 0 &&
           request.point_count <= NETMESH_POINTS_MAX && complaint_about_layout(given_rows(request)).text == nullptr;
}

// A mesh that certifies a ratio takes no more than one of the aspect ratio that proves it.
double equivalent_tau(double ratio) {
    const double equivalent = ratio * ratio - 2;
    return equivalent > 2.1 ? equivalent : 2.1;
}

}  // namespace

std::size_t whole_bytes(double bytes) {
    if (!(bytes < 0x1p62) || bytes >= static_cast<double>(SIZE_MAX / 2)) return SIZE_MAX;
    return (static_cast<std::size_t>(bytes) + Arena::alignment) & ~(Arena::alignment - 1);
}

}  // namespace netmesh

using namespace netmesh;

extern "C" {

size_t netmesh_plan_delaunay(const netmesh_delaunay_request* from) {
    netmesh_delaunay_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (!is_plannable(request)) return 0;
    if (!in_range(request.purpose, NETMESH_PURPOSE_MESH, NETMESH_PURPOSE_PERSIST)) return 0;
    const bool alpha = request.purpose == NETMESH_PURPOSE_PERSIST;
    return whole_bytes(with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        constexpr DelaunayFigures f = DelaunayFiguresOf<D>::value;
        const double points = static_cast<double>(request.point_count);
        return alpha ? alpha_block<D>(f.filtered, points, D == 2 ? 0.68 : 0.8) : f.triangulated.at<D>(points);
    }));
}

size_t netmesh_plan_alpha(const netmesh_alpha_request* from) {
    netmesh_alpha_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (!is_plannable(request)) return 0;
    return whole_bytes(with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        constexpr PeakFigures f = DelaunayFiguresOf<D>::value.diagram;
        return alpha_block<D>(f, static_cast<double>(request.point_count), D == 2 ? 0.395 : 0.8);
    }));
}

size_t netmesh_plan_mesh(const netmesh_mesh_request* from) {
    netmesh_mesh_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (!is_plannable(request)) return 0;
    const double ratio = request.certificate.ratio;
    const double tau = ratio > 0 ? equivalent_tau(ratio) : tau_of(request.dim, request.tau);
    if (complaint_about_numbers(request).text != nullptr || !is_valid_tau(tau)) return 0;
    const bool tight = request.purpose == NETMESH_PURPOSE_TIGHT;
    Planned planned;
    planned.hierarchy = request.method == NETMESH_METHOD_HIERARCHY;
    planned.location = (request.audit & NETMESH_AUDIT_LOCATION) != 0;
    planned.quality = (request.audit & NETMESH_AUDIT_QUALITY) != 0;
    planned.filter = request.purpose != NETMESH_PURPOSE_MESH;
    return whole_bytes(with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const double points = static_cast<double>(request.point_count);
        const double surroundings = tight ? figures<D>.tight_surroundings : 0;
        const bool clipped = goal_of(request).clipped, net = request.method == NETMESH_METHOD_REFINE;
        if constexpr (D <= mesh_figures_dim_max) {
            const bool unknown =
                D > 3 && (net || sizes_of(request).eps > 0 || request.cage_kind == NETMESH_CAGES_THESIS);
            if (!unknown && !planned.location && !(planned.quality && (planned.hierarchy || D > 3))) {
                MeshKind kind = {tau, ratio, sizes_of(request).eps};
                kind.clipped = clipped;
                kind.shell = planned.filter && !clipped;
                kind.net = net;
                kind.cages = planned.hierarchy && request.finish == 0;
                kind.thesis = request.cage_kind == NETMESH_CAGES_THESIS;
                return mesh_block<D>(kind, points, planned);
            }
        }
        const Boundary boundary = clipped ? clipped_boundary<D> : whole_boundary;
        Amounts amounts = mesh_amounts<D>(points, tau, sizes_of(request).eps, surroundings, boundary);
        if (request.cage_kind == NETMESH_CAGES_THESIS) amounts = with_thesis_shells<D>(amounts);
        if (net) {
            amounts.vertices += boundary_net_vertices;
            amounts.cells += boundary_net_cells;
        }
        if (D >= 4 && clipped) amounts = without_surroundings(amounts);
        return block_bytes<D>(amounts, planned);
    }));
}

size_t netmesh_plan_scales(const netmesh_scales_request* from) {
    netmesh_scales_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (!is_plannable(request)) return 0;
    const double eps = eps_of(request.eps), theta = theta_of(request.theta), ratio = request.ratio;
    double tau = tau_of(request.dim, request.tau);
    if (!is_valid_tau(tau) || !is_valid_eps(eps) || !is_valid_theta(theta)) return 0;
    if (ratio != 0 && (request.eps != 0 || !is_valid_scales_ratio(ratio, theta))) return 0;
    if (ratio > 0) tau = equivalent_tau(ratio / (1 + 3 * theta));
    Planned planned;
    planned.filter = planned.scales = true;
    planned.bounds = request.bounds != 0;
    planned.representatives = request.representatives != 0;
    return whole_bytes(with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const double points = static_cast<double>(request.point_count);
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
    }));
}

}  // extern "C"
