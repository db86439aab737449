// Aspect ratios, degrees and the invariants of 4.8 and 4.9 on every intermediate mesh.
//
// An insertion changes the Voronoi cells of the new vertex and of its Delaunay neighbours and no others: where all
// neighbours of a cell are old ones, it is what it was. So an audit looks at what a step has inserted and at the
// neighbours that this has at the end of the step. Of an old vertex the cell has become smaller, and so has the
// distance to the second nearest input, if anything: aspect ratio and K can have risen only where something new is the
// nearest neighbour. The cells of a cage that grows or is released are clipped to a larger ball: all of its vertices
// and their neighbours are looked at. What cannot be worse than the worst so far is not computed to the end.
//
// With cages of the thesis (cage_template.hpp) cells are whole. Then releases change no cell, but which domain vertices
// are in, and whose cells are measured: a shell's are not, its own vertices' and those of inputs that these have
// yielded to, until its cage grows or is released. So vertices that stop being of a shell are looked at with their
// neighbours, and so are inputs that shells yield to, which a step inserts besides its own vertex.
#pragma once
#include <cstdint>

#include "mesh/any_domain.hpp"
#include "mesh/cages/cage_template.hpp"
#include "mesh/cages/hierarchy.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

// Worst of all intermediate meshes, one for each vertex inserted (with the cage that is made for it, if one is) and one
// for each time that the ball of a compact cage grows, or that a cage is released after it has grown.
//
// f_P(v) is the distance to the second nearest point of P in M_Omega, v itself included, f_M(v) the smallest to a
// Delaunay neighbour of v, where the centre of a cage directly inside of Omega stands for the vertices in it. That is
// the thesis's f_M without cages, and at most a third more with them: on the way from v to the nearest vertex y of
// M_Omega, L away, only a cell of such a cage can be next to v's, that of a vertex z with |v - z| <= L (the way leaves
// v's cell at its middle or before). The cage, of radius r, has 3 r <= |v - z| as nobody encroaches on it, so its
// centre is at most L + r <= 4/3 L away.
struct QualityAudit {
    std::uint32_t meshes;
    std::uint32_t
        encroached;  // meshes with an encroached cage (condition 3 of definition 4.5); the engine stops at one
    std::uint32_t degree_max;  // most Delaunay neighbours of a vertex, those of the frame left out
    double worst;    // aspect ratio of a vertex's or a cage's cell (conditions 1 and 2): the quality invariant's tau'
    double feature;  // K of the feature size invariant: f_P(v) / f_M(v) over all v in M_Omega and all Omega
    double cage, steiner,
        input;  // K' of the insertion radius invariant: f_P(v) / lambda_v of shell vertices, of what cleaning
                // inserts (inputs that it yields to included), of inputs whose turn it is
    bool outermost_features;  // has the outermost domain had two inputs? Until then K is of the others alone
};

// What is asked of a method's meshes.
//
// P with cages (4.9): the inputs that are in the mesh. A domain holds nothing that is not graded towards these. Without
// cages it is all inputs: one that is not medial yet waits while Steiner points are inserted for its sake, and next to
// two inputs with gap g, one of them waiting, f_M comes down to about g where the inserted ones are 1 apart: their K is
// 1 / g. Over all inputs f_P <= K f_M holds, by the proofs of quality_rule.hpp (inputs that wait count as inserted
// first) and certificate_rule.hpp (a Steiner point x keeps a constant times d_P(x) from all vertices, that is one times
// f_P of its nearest input, and f_P(x) <= f_P(p) + |x - p|).
struct AuditTerms {
    bool steiner_ratios;   // have the cells of Steiner vertices a bounded aspect ratio, too?
    bool inserted_inputs;  // is P what of the inputs is in the mesh, or all of them?
    bool features;         // are there bounds for K and K'?
};

// What `cage` cannot exceed: in radii, a shell vertex is at most shell_factor (1 + jitter) + e from the second input
// of its domain, and an input (within e of the centre) or another shell vertex is the nearest neighbour that it is
// given. For cages of the thesis K'_C of engine/decisions/cages-of-the-thesis.md.
double cage_insertion_bound(int dim, CageKind kind = CageKind::compact);

// What a step has changed besides what it has inserted in its own name. One of the two.
struct AuditNote {
    std::uint32_t vertex;  // an input that a shell has yielded to, with cages of the thesis
    std::uint32_t cage;  // one that was released, or has grown: the cells in it are clipped to a larger ball, or, with
                         // cages of the thesis, what was of its shell is so no more
};

// What the last step has done.
struct AuditStep {
    // Inserted `vertex`, an input or not, and before it, of the vertices from first_made on, the shell of a cage if one
    // was made. vertex none: nothing.
    std::uint32_t first_made, vertex;
    bool cleaning;
    const AuditNote* notes = nullptr;  // [note_count]
    std::uint32_t note_count = 0;
};

template <int D> struct AuditedMesh {
    Store<D>& store;
    const InputTree<D>& tree;
    const Domain<D>& outermost;
    Hierarchy<D>* hierarchy;  // null: there are no cages
    AuditTerms terms;
    CageKind kind = CageKind::compact;
};

// What audit_quality places at most, when a step releases a cage that holds everything.
struct AuditScratch {
    static constexpr std::size_t vertex_bytes = sizeof(std::uint32_t);
    static constexpr std::size_t cell_bytes = sizeof(CellId);
};

// Adds the mesh after one step to *audit. Cells are clipped to the ball of their domain (clipped_cell.hpp), or whole
// with cages of the thesis. Works on a store in use as on a compact one. Cost: the stars of the vertices whose cells
// have changed, and the boundaries of the cages that are among them. Scratch: lists of these. out_of_memory.
struct AnyAuditedMesh {
    AnyStore store;
    const AnyInputTree& tree;
    AnyDomain outermost;
    CageForest* hierarchy;
    AuditTerms terms;
    CageKind kind;
};
Status audit_quality(const AnyAuditedMesh& mesh, const AuditStep& step, QualityAudit* audit);
template <int D> Status audit_quality(const AuditedMesh<D>& mesh, const AuditStep& step, QualityAudit* audit) {
    return audit_quality(AnyAuditedMesh{mesh.store, mesh.tree, mesh.outermost, mesh.hierarchy, mesh.terms, mesh.kind},
                         step, audit);
}

}  // namespace netmesh
