// Sparse Voronoi Refinement (thesis 4.4): from points to a quality mesh.
#pragma once
#include <cstdint>

#include "vocabulary/dimension.hpp"
#include "delaunay/triangulate.hpp"
#include "mesh/domain.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {

// An uninserted input is inserted in place of a Steiner point when it is nearer than this times the radius of the empty
// ball (thesis 4.4). Larger values give smaller meshes, but from about .95 on refinement runs along curves from input to input without a
// Steiner point: 1 makes meshes of curves smaller by a fifth, and takes time that grows with the square of their number.
constexpr double yield_radius = 0.9;
// A Steiner point is not put farther from its vertex than this times the distance that makes a corner bad, by D: the cell then
// loses no more than it must, and meshes get smaller than with whole corners. 1 is the limit of 3.3's proof. Smaller values make
// more layers of vertices, larger ones more vertices a layer.
//
// What else was tried for smaller meshes, by tests/bench/sizes: a Voronoi edge's point at that distance, which is as near to D - 1
// other vertices, gives 1% fewer vertices in 2D, as many in 3D and 4D, and cavities a fifth larger; the point whose half-space
// contains all bad corners and is farthest from v, up to 12% more; half-spaces that contain as many as possible, 1 to 15% more;
// whole corners up to 1.5 or 2 times as far, 3 and 13% more; a queue four times as fine, or the same vertex again until
// its cell is good, as many within 1%; a coarser queue or last in, first out, 1 to 16% more; all inputs first, 2% fewer.
template <int D> constexpr double pull_back = figures<D>.pull_back;
// Refinement stops a hair before tau: more than the error of the corners that it sees, so the true ratios keep the bound.
constexpr double tau_margin = 0x1p-20;

struct RefineOptions {
    double tau;            // > 2
    double domain_factor;  // domain radius over the radius of the smallest enclosing ball, >= 1
    bool certify;          // also bring the certified ratio of filtration/mesh_filter.hpp below sqrt(2 + tau)
    std::uint64_t seed;
    SizeRule size = {};  // also bring the out-radius of every clipped cell down to what it asks for
    // VoronoiRefine (3.2) in the bounding domain and with the boundary net of 3.5 instead, the reference for everything else:
    // all inputs first, then farthest corners, whole. domain_factor and certify do not matter. With rho the radius of the
    // smallest enclosing ball and delta = 2 rho >= diameter(P), the domain has the ball's centre and radius
    // (K sqrt 2 + 2) delta, K = 2 tau / (tau - 2); a delta-net of exempt vertices on its sphere takes the frame's place. It has about
    // (radius / delta)^(D-1) vertices, too many to be of use in D = 5 and 6.
    bool reference = false;
};

// Meshes points[n][D]. Afterwards the store is compact; vertices are the inputs (input order), then Steiner and exempt
// vertices as they came; `domain` is the ball in which each vertex that is not exempt has a clipped Voronoi cell of
// aspect ratio at most tau; vertex.nearest2 and vertex.origin (nearest input) are final.
//
// What is refined is the corner of a clipped cell: a Voronoi corner inside the domain, or a point where a Voronoi edge
// crosses its sphere. Each Steiner point x lies in the cell of some vertex v, at a distance l of at least (tau/2) times
// the distance from v to its nearest neighbour, which is all that the size and termination proof of 3.3 asks for
// (every vertex stays in the domain, so 3.6's packing argument applies with Omega the domain). Inputs that are not inserted
// yet count as inserted first in that proof, so they must not be nearer to x than l either, or still no nearer than f_P(x) / (K - 1),
// K = 2 tau / (tau - 2): x yields to an input for which neither holds, and f_P <= K f_M on all vertices for every tau > 2. The frame of 2
// D exempt vertices at four or more times the domain's radius is farther from every input than any other input, as 3.3.2 requires.
//
// With `certify` a cell is also bad when the bounds lo and hi of mesh_filter.hpp on the whole of it (corners outside the
// domain too) say hi > (2 + tau) lo or hi > tau s, s the thesis's filter value: half of nn(v) for an input, else d_P(v). Either
// means that its unclipped aspect ratio exceeds tau, so a Steiner point towards its farthest corner is as good for the
// proof as any other. Such a cell has d_P(v) < 2 rho / (2 + tau), so everything stays within 1 + (2 + 1.15 tau) / (2 + tau) < 2.2
// enclosing radii, a compact set; only a thin shell around the domain is refined, only as far as the certificate needs.
//
// With a size rule (3.7) there is a second run, when all inputs are in: a cell is then also bad when its clipped out-radius
// is above f(v), and its farthest corner (pole, where it has none), at a distance above f(v) from every vertex, is
// inserted. So it ends as soon as f is bounded away from 0 on the domain, and 3.7.1 holds when f is Lipschitz.
//
// ok, out_of_memory, cancelled (both: a Delaunay mesh of what was inserted, tau not promised), out_of_range and too_close
// (rows in *input), invalid_argument (the size asked for at some vertex, row_a the nearest input, is not positive or not
// resolved by its coordinates: below 64 units in the last place), and what take_input says.
template <int D>
Status refine(Store<D>& store, const double* points, std::size_t n, const RefineOptions& options, Monitor& monitor,
              InputReport* input, Domain<D>* domain);

}  // namespace netmesh
