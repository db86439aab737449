// What watches a mesh grow without having a say in it: point location in all D-balls, and quality after every
// insertion.
#pragma once
#include <cstdint>

#include "mesh/audit/ball_lists.hpp"
#include "mesh/audit/quality_audit.hpp"
#include "mesh/domain.hpp"
#include "mesh/mesh_request.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

// Location: inputs are stored in all D-balls that contain them. They also have their turns in another order then, that
// of rounds of range nets (input_order.hpp), as definition 4.7.5 is about that order: so an audit of location is of
// another mesh, as good. Quality: what each insertion changes is measured (quality_audit.hpp), until FinishMesh begins,
// which releases all cages at once, or with cages of the thesis, which FinishMesh grows, to the end; K and K' until
// over-refinement begins, which is to break them. The mesh is byte for byte the one that is made without.
// VoronoiRefine, which inserts all inputs first, has no quality to be audited.
class Observers {
public:
    explicit Observers(const MeshRequest& request)
        : terms_{request.method != MeshMethod::certificate, request.method == MeshMethod::hierarchy, true},
          locates_(built::audits && request.audit_location), measures_(built::audits && request.audit_quality),
          kind_(request.cages) {}

    // Memory for the lists, before the store's cells are opened; later the frame is there. out_of_memory.
    Status open(int dim, Arena& arena, std::uint32_t inputs);
    Status start(const AnyStore& mesh);

    // Around each insertion into a cavity, where inputs are located. Before: false when an input is stored in other
    // balls than those of its cavity. After: false when the lists do not suffice; the mesh is whole all the same.
    bool locates() const { return built::audits && lists_.is_open(); }
    bool before_fill(const AnyStore& mesh, const Cavity& cavity, VertexId v);
    bool after_fill(const AnyStore& mesh, const Cavity& cavity, VertexId v);
    bool lists_are_full() const { return full_; }
    // Where the search for an input that is not inserted starts.
    CellId start_for(const StoreState& state, VertexId input) const {
        return locates() ? lists_.ball_of(input) : state.last_cell;
    }
    BallLists& lists() { return lists_; }
    std::uint64_t list_looks() const { return locates() ? lists_.looks() : 0; }

    // After each step: vertex v has been inserted, and the shell of a cage before, if one was made. `cleaning`: not
    // because an input had its turn. hierarchy: null where there are no cages. out_of_memory, internal (a cage is
    // encroached).
    bool measures() const { return built::audits && measures_; }
    template <int D>
    Status measure(Store<D>& store, const InputTree<D>& tree, Hierarchy<D>* hierarchy, const Domain<D>& domain,
                   VertexId v, bool cleaning) {
        const AnyAuditedMesh mesh = {store, tree, domain, hierarchy, terms_, kind_};
        return measure(mesh, cage_insertion_bound(store.dim, kind_), v, cleaning);
    }
    // What an AuditNote is for. The growth or release of a compact cage is a step of its own that inserts nothing: it
    // has one note.
    void note(const AuditNote& note);
    // Cage d has grown, and `shell` was of it. A shell of the step's own is looked at in any case.
    void note_grown(VertexId shell, std::uint32_t d) {
        if (shell < first_new_) note({none, d});
    }
    // What open places for each input, for notes. In a step each input is yielded to at most once; each cage, of which
    // there are fewer than inputs, is released at most once, and its first growth is noted; later ones are where all of
    // the shell before was inputs, yielded to in the same step.
    static constexpr std::size_t notes_per_input = 4, note_bytes = notes_per_input * sizeof(AuditNote);
    void stop_measuring() { measures_ = false; }
    void stop_measuring_features() { terms_.features = false; }

    void report(MeshAudit* audit) const;

private:
    Status measure(const AnyAuditedMesh& mesh, double bound, VertexId v, bool cleaning);

    BallLists lists_;
    QualityAudit quality_ = {};
    AuditTerms terms_;
    VertexId first_new_ = none;  // of the step at hand
    bool locates_, measures_, full_ = false;
    CageKind kind_;
    AuditNote* notes_ = nullptr;
    AuditNote growth_;  // of a compact cage
    std::uint32_t note_count_ = 0, notes_max_ = 0;
};

}  // namespace netmesh
