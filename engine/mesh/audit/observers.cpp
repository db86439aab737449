#include "mesh/audit/observers.hpp"

#include "vocabulary/features.hpp"

namespace netmesh {

// Long cells of Steiner vertices are no fault of a mesh made for a certificate.
Status Observers::open(int dim, Arena& arena, std::uint32_t inputs) {
    notes_ = &growth_;
    notes_max_ = 1;
    if (built::audits && measures_ && kind_ == CageKind::thesis) {
        notes_ = arena.take_low<AuditNote>(std::size_t{notes_per_input} * inputs);
        if (notes_ == nullptr) return Status::out_of_memory;
        notes_max_ = notes_per_input * inputs;
    }
    return built::audits && locates_ ? lists_.open(dim, arena, inputs) : Status::ok;
}

Status Observers::start(const AnyStore& mesh) {
    first_new_ = VertexId(mesh.state.vertex_count);
    return built::audits && locates_ && !lists_.start(mesh) ? Status::out_of_memory : Status::ok;
}

bool Observers::before_fill(const AnyStore& mesh, const Cavity& cavity, VertexId v) {
    if (mesh.vertex(v).marker == Marker::input && !lists_.agrees(mesh, cavity, v)) return false;
    lists_.detach(mesh, cavity, v);
    return true;
}

bool Observers::after_fill(const AnyStore& mesh, const Cavity& cavity, VertexId v) {
    full_ = !lists_.attach(mesh, cavity, v);
    return !full_;
}

void Observers::note(const AuditNote& note) {
    if (!measures_) return;
    NETMESH_ASSERT(note_count_ < notes_max_);
    notes_[note_count_++] = note;
}

Status Observers::measure(const AnyAuditedMesh& mesh, double bound, VertexId v, bool cleaning) {
    const AuditStep step = {first_new_, v, cleaning, notes_, note_count_};
    const Status status = audit_quality(mesh, step, &quality_);
    note_count_ = 0;
    first_new_ = VertexId(mesh.store.state.vertex_count);
    if (status != Status::ok) return status;
    return quality_.encroached > 0 || quality_.cage > bound ? Status::internal : status;
}

void Observers::report(MeshAudit* audit) const {
    if (locates()) lists_.report(&audit->location);
    if (built::audits) audit->quality = quality_;
}

}  // namespace netmesh
