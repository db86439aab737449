#include "mesh/quality_audit.hpp"

#include "mesh/hierarchy_quality.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

void raise(double value, double* most) {
    if (value > *most) *most = value;
}

// The vertices of M_Omega for every domain Omega, centres of the cages directly inside included, domain by domain.
template <int D> class Members {
public:
    Members(const Store<D>& store, const Cage* cages, std::uint32_t count, const std::uint32_t* domains)
        : store_(store), cages_(cages), count_(count), domains_(domains) {}

    Status open(Arena& arena) {
        starts_ = arena.take_low<std::uint32_t>(std::size_t{count_} + 2);
        items_ = arena.take_low<std::uint32_t>(std::size_t{store_.state.vertex_count} + count_);
        if (starts_ == nullptr || items_ == nullptr) return Status::out_of_memory;
        for (std::uint32_t d = 0; d < count_ + 2; ++d) starts_[d] = 0;
        visit([&](std::uint32_t slot, std::uint32_t) { ++starts_[slot + 1]; });
        for (std::uint32_t d = 0; d <= count_; ++d) starts_[d + 1] += starts_[d];
        visit([&](std::uint32_t slot, std::uint32_t v) { items_[starts_[slot]++] = v; });
        for (std::uint32_t d = count_ + 1; d > 0; --d) starts_[d] = starts_[d - 1];
        starts_[0] = 0;
        return Status::ok;
    }
    // Domains 0..count, the outermost one last.
    std::uint32_t size(std::uint32_t slot) const { return starts_[slot + 1] - starts_[slot]; }
    std::uint32_t item(std::uint32_t slot, std::uint32_t i) const { return items_[starts_[slot] + i]; }

private:
    template <class Visit> void visit(Visit&& visit) const {
        for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) {
            const bool frame = domains_[v] == none && store_.vertex(v).marker == Marker::exempt;
            if (store_.vertex(v).cell != none && !frame) visit(slot_of(domains_[v]), v);
        }
        for (std::uint32_t d = 0; d < count_; ++d) visit(slot_of(cages_[d].parent), cages_[d].centre);
    }
    std::uint32_t slot_of(std::uint32_t domain) const { return domain == none ? count_ : domain; }

    const Store<D>& store_;
    const Cage* const cages_;
    const std::uint32_t count_;
    const std::uint32_t* const domains_;
    std::uint32_t *starts_, *items_;
};

// Squared f_P and f_M of the i-th member of a domain.
struct Features {
    double input2 = infinity, mesh2 = infinity;
};
template <int D>
Features features_of(const Store<D>& store, const Members<D>& members, std::uint32_t slot, std::uint32_t i) {
    Features f;
    const std::uint32_t v = members.item(slot, i);
    double first2 = store.vertex(v).marker == Marker::input ? 0 : infinity;
    for (std::uint32_t j = 0; j < members.size(slot); ++j) {
        if (i == j) continue;
        const std::uint32_t w = members.item(slot, j);
        const double d2 = distance2<D>(store.point(v), store.point(w));
        if (d2 < f.mesh2) f.mesh2 = d2;
        if (store.vertex(w).marker != Marker::input || !(d2 < f.input2)) continue;
        f.input2 = d2 < first2 ? first2 : d2;
        if (d2 < first2) first2 = d2;
    }
    return f;
}

template <int D>
void raise_features(const Store<D>& store, const Members<D>& members, std::uint32_t slot, const AuditStep& step,
                    QualityAudit* audit) {
    for (std::uint32_t i = 0; i < members.size(slot); ++i) {
        const Features f = features_of<D>(store, members, slot, i);
        if (!(f.input2 < infinity)) continue;
        const double ratio = square_root(f.input2 / f.mesh2);
        raise(ratio, &audit->feature);
        const std::uint32_t v = members.item(slot, i);
        if (v == step.vertex)
            raise(ratio, step.cleaning ? &audit->steiner : &audit->input);
        else if (v >= step.first_made)
            raise(ratio, &audit->cage);
    }
}

}  // namespace

template <int D> double cage_insertion_bound() {
    // No shell vertex is nearer to another than to the inputs: corners are sqrt(2) apart.
    const double off = shell_jitter * square_root(D), inner = shell_factor * (1 - shell_jitter);
    return (shell_factor * (1 + off) + cage_epsilon) / (inner - cage_epsilon);
}

template <int D>
Status audit_quality(Store<D>& store, const Cage* cages, std::uint32_t made, const Domain<D>& outermost, Arena& arena,
                     const AuditStep& step, QualityAudit* audit) {
    ArenaScope scope(arena);
    const std::uint32_t vertices = store.state.vertex_count;
    Cage* const live = arena.take_low<Cage>(made);
    double* const ratios = arena.take_low<double>(vertices);
    std::uint32_t* const domains = arena.take_low<std::uint32_t>(vertices);
    if (live == nullptr || ratios == nullptr || domains == nullptr) return Status::out_of_memory;
    std::uint32_t count = 0;
    for (std::uint32_t d = 0; d < made; ++d)
        if (cages[d].shell != none) live[count++] = cages[d];
    HierarchyQuality quality;
    Status status = measure_hierarchy<D>(store, {live, count, outermost, ratios, domains}, arena, &quality);
    if (status != Status::ok) return status;
    ++audit->meshes;
    if (quality.encroached.violation != nullptr) ++audit->encroached;
    if (!quality.is_hierarchy) return Status::ok;
    raise(quality.worst, &audit->worst);
    Members<D> members(store, live, count, domains);
    status = members.open(arena);
    for (std::uint32_t slot = 0; slot <= count && status == Status::ok; ++slot)
        raise_features<D>(store, members, slot, step, audit);
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template double cage_insertion_bound<D>();                                                                         \
    template Status audit_quality<D>(Store<D>&, const Cage*, std::uint32_t, const Domain<D>&, Arena&,                  \
                                     const AuditStep&, QualityAudit*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
