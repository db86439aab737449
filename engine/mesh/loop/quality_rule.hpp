// Sparse Voronoi Refinement (thesis 4.4): from points to a quality mesh.
#pragma once
#include <cstddef>

#include "memory/work.hpp"
#include "mesh/mesh_request.hpp"

namespace netmesh {

// For the methods quality and reference (reference_rule.hpp says what that one does otherwise). Afterwards the domain
// is the ball in which each vertex that is not exempt has a clipped Voronoi cell of aspect ratio at most tau;
// vertex.nearest2 and vertex.origin (nearest input) are final.
//
// Each Steiner point x lies in the cell of some vertex v, at a distance l of at least (tau/2) times the distance from
// v to its nearest neighbour, which is all that the size and termination proof of 3.3 asks for (every vertex stays in
// the domain, so 3.6's packing argument applies with Omega the domain). Inputs that are not inserted yet count as
// inserted first in that proof, so they must not be nearer to x than l either, or still no nearer than f_P(x) / (K -
// 1), K = 2 tau / (tau - 2): x yields to an input for which neither holds, and f_P <= K f_M on all vertices for every
// tau > 2. The frame of 2 D exempt vertices at four or more times the domain's radius is farther from every input than
// any other input, as 3.3.2 requires.
//
// While inputs are missing cells are held to the dimension's waiting_tau, at most 2 * mediality (tau if that is more),
// so that space waits for the inputs that come there; then all are held to tau, scale by scale. The proof is one for
// both: by waiting_tau a Steiner point is only farther from v than tau/2 times the distance to its nearest neighbour,
// and K is that of tau.
//
// An input enters when it is medial: the clipped cell of its nearest vertex u reaches no farther than `mediality` times
// its distance from u. Before that u's cell is split at its farthest corner, yielding to other inputs, and the mesh is
// cleaned. So no input that has its turn makes a ratio above 2 * mediality at u. An input that a Steiner point yields
// to is not asked for that: it is at a tenth or more of the empty ball's radius from every vertex. Neither depends on
// the spread (4.4).
//
// The point x that u's cell is split at does not yield to p. With d = |u - p| and l = |u - x| > 16 d still
// f_P(x) <= (K - 1) |x - p|: by the bounds above f_P(u) <= (K - 1) d, so f_P(x) <= l + (K - 1) d and
// |x - p| >= l - d, and l + (K - 1) d <= (K - 1) (l - d) when l >= (tau/2 + 1) d, that is for tau <= 30. By a larger
// tau p may enter instead: then l < (tau/2 + 1) d, so that the ratio at u is below tau + 2. A point that the mesh is
// cleaned with before p is in yields to p as to any other input.
//
// With certify_filter a cell is also bad when the bounds lo and hi of mesh_filter.hpp on the whole of it (corners
// outside the domain too) say hi > (2 + tau) lo or hi > tau s, s the thesis's filter value: half of nn(v) for an
// input, else d_P(v). Either means that its unclipped aspect ratio exceeds tau, so a Steiner point towards its
// farthest corner is as good for the proof as any other. Such a cell has d_P(v) < 2 rho / (2 + tau), so everything
// stays within 1 + (2 + 1.15 tau) / (2 + tau) < 2.2 enclosing radii, a compact set; only a thin layer around the
// domain is refined, only as far as the certificate needs.
//
// With a size rule (3.7) there is a second run, when all inputs are in: a cell is then also bad when its clipped
// out-radius is above f(v), and its farthest corner, or a point of the domain's sphere at f(v) from v, is inserted. So
// it ends as soon as f is bounded away from 0 on the domain, and 3.7.1 holds when f is Lipschitz.
template <int D>
Status mesh_by_quality(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                       const Work& work, AnyMeshResult* result);

}  // namespace netmesh
