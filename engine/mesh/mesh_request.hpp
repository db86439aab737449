// What is asked of a mesher and what comes back, whatever makes a cell bad.
#pragma once
#include <cstdint>

#include "delaunay/triangulate.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/audit/ball_lists.hpp"
#include "mesh/audit/quality_audit.hpp"
#include "mesh/cages/cage.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {

enum class MeshMethod {
    quality,      // Sparse Voronoi Refinement (thesis 4.4): quality_rule.hpp
    hierarchy,    // NetMesh (4.5, 4.7), with cages: hierarchy_rule.hpp
    reference,    // VoronoiRefine (3.2): reference_rule.hpp
    certificate,  // the coarsest mesh that proves a ratio: certificate_rule.hpp
};

// The least ratio that can be asked for. Points have to be 64 / (ratio^2 / 2 - 1) units in the last place apart: 5.3e5
// at this one. No mesh reaches the root of 2.
constexpr double ratio_least = 1.4143;

// For the method certificate. With lo <= F <= hi on the cell of a vertex as in certificate/interval.hpp: hi <= ratio^2
// lo everywhere, and hi <= focus^2 lo in each Steiner cell that matters to scales of interest, those with hi > from
// and lo < to. `clipped`: of cells clipped to the ball of clip_factor enclosing radii (domain.hpp), which is the
// domain.
struct RatioGoal {
    double ratio;          // >= ratio_least
    double focus;          // > 1; 0: there are no scales of interest
    double from, to;       // 0 < from < to
    bool clipped = false;  // of cells clipped to the ball of the domain, a hair larger than the smallest enclosing one
};

struct MeshRequest {
    MeshMethod method = MeshMethod::quality;
    double tau = 0;               // > 2: the bound on clipped aspect ratios; not for the method certificate
    double domain_factor = 1;     // domain radius over that of the smallest enclosing ball, >= 1; quality, hierarchy
    double net_spacing = 1;       // reference: of the boundary net over the enclosing ball's diameter, > 0
    bool certify_filter = false;  // quality: also bring the certified ratio of the complete filter below sqrt(2 + tau)
    SizeRule size = {};           // bring the out-radius of clipped cells down to what it asks for; not for the method
                                  // certificate nor where cages are left
    RatioGoal goal = {};          // certificate
    bool finish = false;          // hierarchy: FinishMesh (4.7.6), release all cages and refine what they kept apart
    CageKind cages = CageKind::compact;  // hierarchy
    double outermost_scale = 1;          // cages of the thesis: radius of the outermost one over the least, >= 1
    bool audit_location = false;         // quality, hierarchy: see observers.hpp
    bool audit_quality = false;          // all but reference
    std::uint64_t seed = 0;
};

// Of a mesh with cages.
struct HierarchyCounts {
    std::uint32_t cages;  // left in the mesh
    std::uint32_t cages_made, cages_released;
};

// What point location has looked at, whoever made it look. Most of it is spent on the distances of inputs, before any
// is inserted, on looking for an input to yield to around each Steiner point and for the vertex nearest to an input:
// with compact cages 38 to 48 / 67 to 76 / 150 to 207 looks an input (D = 2 / 3 / 4) for spreads of 1e3 to 1e30 and up
// to a million inputs. Lists of D-balls come on top of that, not in its place. Audits of quality, which measure, do not
// count.
struct LocationCounts {
    std::uint64_t tree;    // distances to inputs, inserted or not, that searches of the tree have computed
    std::uint64_t lists;   // inputs compared with D-balls by an audit of location, when the lists begin and ever after
    std::uint64_t passed;  // cells and domains on the way to where a point belongs, vertices compared with an input
    std::uint64_t last;    // of `tree`: for the nearest input of each vertex, when the mesh is done and has no cages

    std::uint64_t touches() const { return tree + lists + passed; }
};

// Figures of what was audited, 0 of what was not.
struct MeshAudit {
    LocationAudit location;
    QualityAudit quality;
};

template <int D> struct MeshResult {
    InputReport input;
    Domain<D> domain;
    Cage* cages;  // hierarchy.cages of them at the arena's low end before the cells; null: the method makes none
    HierarchyCounts hierarchy;
    LocationCounts location;
    MeshAudit audit;

    // The same, its dimension a number or not.
    template <int E> MeshResult<E> of_dimension() const {
        return {input, AnyDomain(domain).of_dimension<E>(), cages, hierarchy, location, audit};
    }
};
using AnyMeshResult = MeshResult<any_dimension>;

}  // namespace netmesh
