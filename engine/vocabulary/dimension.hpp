// The dimensions that this build of the engine serves, and every figure that was measured or chosen for each of them.
//
// NETMESH_EACH_DIMENSION of netmesh_config.h is the only list of dimensions in the engine. Calls that ask for one that
// is left out return NETMESH_NOT_BUILT. A new one needs its Figures below and a larger NETMESH_DIM_MAX in
// netmesh/context.h, which sizes the structs of the interface.
#pragma once
#include <cstdint>
#include <type_traits>

#include "vocabulary/netmesh_config.h"

// The dimensions that a source makes its templates for: all, but where the build compiles it twice, for low ones to be
// fast and for high ones to be small (engine/archive.cmake).
#ifndef NETMESH_EACH_INSTANCE
#define NETMESH_EACH_INSTANCE(DO) NETMESH_EACH_DIMENSION(DO)
#endif

namespace netmesh {

template <int D> using Dimension = std::integral_constant<int, D>;

// Whether this build serves dimension dim.
constexpr bool serves_dimension(std::uint32_t dim) {
#define NETMESH_IS_DIMENSION(D) dim == D ||
    return NETMESH_EACH_DIMENSION(NETMESH_IS_DIMENSION) false;
#undef NETMESH_IS_DIMENSION
}

// The largest dimension that this build serves.
constexpr int dimension_most() {
    int most = 0;
#define NETMESH_RAISE(D) most = D > most ? D : most;
    NETMESH_EACH_DIMENSION(NETMESH_RAISE)
#undef NETMESH_RAISE
    return most;
}

// Whether there is no other.
#define NETMESH_COUNT(D) +1
constexpr bool serves_one_dimension = 0 NETMESH_EACH_DIMENSION(NETMESH_COUNT) == 1;
#undef NETMESH_COUNT

// A template made for D = any_dimension has its dimension as a number: it is in the program once, for all dimensions.
// DimensionOf<D> is what such a template keeps, and no more than the constant D where it is made for one.
constexpr int any_dimension = 0;
template <int D> struct DimensionOf {
    static constexpr int most = D;  // for the bounds of arrays
    constexpr DimensionOf(std::uint32_t = D) {}
    constexpr operator std::uint32_t() const { return D; }
};
template <> struct DimensionOf<any_dimension> {
    static constexpr int most = dimension_most();
    constexpr DimensionOf(std::uint32_t dim = 0) : value(dim) {}
    constexpr operator std::uint32_t() const { return value; }
    std::uint32_t value;
};
// A dimension as a number, which the compiler knows where the build serves no other.
class AnyDimension {
public:
    AnyDimension() = default;
    constexpr AnyDimension(int value) : value_(value) {}
    constexpr operator int() const { return serves_one_dimension ? dimension_most() : value_; }

private:
    int value_;
};
// D, or any_dimension where size counts more than time does and D is not the only one: for templates that jobs spend
// their time in. Size counts beyond D = 4, and everywhere at -Os.
#ifdef __OPTIMIZE_SIZE__
constexpr int fast_dimension_max = 0;
#else
constexpr int fast_dimension_max = 4;
#endif
#define NETMESH_COUNT(D) +(D > fast_dimension_max)
template <int D>
constexpr int shared_dimension = D > fast_dimension_max && 0 NETMESH_EACH_DIMENSION(NETMESH_COUNT) > 1 ? any_dimension
                                                                                                       : D;
#undef NETMESH_COUNT

// Figures that depend on the dimension and come from measuring or choosing, not from a formula.
struct Figures {
    // Meshing
    double tau_default;  // bound on aspect ratios when the caller names none
    double pull_back;    // see mesh/loop/aspect_rule.hpp
    double waiting_tau;  // what cells are held to while inputs are missing, see mesh/loop/aspect_rule.hpp
    // Distance of the frame over the domain's radius: its hull, a cross-polytope, must contain the ball of 2.2 radii in
    // which everything stays (mesh/loop/quality_rule.hpp), so more than 2.2 sqrt(D), and 4 at least for a coarse mesh
    // between domain and frame.
    double frame_factor;
    // Analysis
    double integral_tolerance;             // wanted upper / lower - 1 of integrals when the caller names none
    double coarsest_box;                   // half diagonal over f_P of a box that is never split
    std::uint32_t ply_expected;            // cells looked at for a point's ply, on quality meshes
    std::uint32_t intersections_expected;  // the same for a ball's intersections
    // Planning memory: measured on uniform points
    double mesh_cells_per_vertex, simplices_per_cell;
    double growth;  // vertices a point: 1 + growth / (tau - 2)^(growth_eighths / 8)
    int growth_eighths;
    double over_refined;        // vertices a point of an over-refined mesh, times eps^D
    double tight_surroundings;  // points that the larger domain of the tight filter counts for
    double audit_balls_per_point;
    // Choosing between the exact alpha complex and a mesh (api/auto.cpp)
    double affordable_work;  // cells a point that a Delaunay triangulation makes where alpha complexes are affordable
};

// One number each for D = 2, 3, 4, 5, 6.
template <class Number> struct ByDimension {
    Number of[5];
    constexpr Number at(int dim) const { return of[dim - 2]; }
};
constexpr Figures figures_in(int dim) {
    using Real = ByDimension<double>;
    using Count = ByDimension<std::uint32_t>;
    Figures f = {};
    f.tau_default = Real{{2.5, 2.5, 3.08, 4, 4}}.at(dim);
    f.pull_back = Real{{1.25, 1.1, 1.05, 1, 1}}.at(dim);
    f.waiting_tau = Real{{32, 24, 20, 20, 20}}.at(dim);
    f.frame_factor = Real{{4, 4, 4.6, 5.2, 5.7}}.at(dim);
    f.integral_tolerance = Real{{0.1, 0.25, 1, 4, 16}}.at(dim);
    f.coarsest_box = Real{{0.5, 0.5, 0.5, 0.6, 0.7}}.at(dim);
    f.ply_expected = Count{{4, 20, 120, 700, 4000}}.at(dim);
    f.intersections_expected = Count{{24, 240, 3000, 40000, 400000}}.at(dim);
    f.mesh_cells_per_vertex = Real{{2.05, 6.5, 28, 140, 600}}.at(dim);
    f.simplices_per_cell = Real{{3.0, 4.35, 6.3, 9.1, 13.3}}.at(dim);
    f.growth = Real{{2.1, 4.1, 8.5, 12, 15}}.at(dim);
    f.growth_eighths = ByDimension<int>{{7, 10, 12, 13, 14}}.at(dim);
    f.over_refined = Real{{6, 15, 21, 26, 36}}.at(dim);
    f.tight_surroundings = Real{{16, 32, 64, 128, 256}}.at(dim);
    f.audit_balls_per_point = Real{{8, 24, 96, 480, 2400}}.at(dim);
    f.affordable_work = Real{{40, 150, 250, 1500, 8000}}.at(dim);
    return f;
}
template <int D> struct FiguresOf { static constexpr Figures value = figures_in(D); };
template <int D> constexpr const Figures& figures = FiguresOf<D>::value;

namespace detail {
constexpr int first_dimension(int dim) {
    return serves_dimension(static_cast<std::uint32_t>(dim)) ? dim : first_dimension(dim + 1);
}
}  // namespace detail

// Calls f(Dimension<D>{}) for D = dim, one of the dimensions served: check serves_dimension before.
template <class F> auto with_dimension(std::uint32_t dim, F&& f) {
    switch (dim) {
#define NETMESH_CASE(D)                                                                                                \
    case D: return f(Dimension<D>{});
        NETMESH_EACH_DIMENSION(NETMESH_CASE)
#undef NETMESH_CASE
    default: break;
    }
    using Result = decltype(f(Dimension<detail::first_dimension(2)>{}));
    if constexpr (!std::is_void_v<Result>) return Result{};
}

// Those of dimension dim, which is D unless that is any_dimension.
template <int D> constexpr const Figures& figures_of(int dim) {
    if constexpr (D == any_dimension)
        return *with_dimension(static_cast<std::uint32_t>(dim), [](auto of) { return &figures<decltype(of)::value>; });
    else
        return figures<D>;
}

}  // namespace netmesh
