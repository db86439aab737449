// What is measured of the cells that one step of the mesher has changed.
#pragma once
#include "mesh/audit/quality_audit.hpp"
#include "mesh/cages/any_cage.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// The two inputs nearest to a vertex, or, when that is an input itself, it and the nearest other one.
struct TwoNearest {
    std::uint32_t first = none, second = none;
    double first2 = infinity, second2 = infinity;

    explicit TwoNearest(std::uint32_t itself) : first(itself), first2(itself == none ? infinity : 0) {}

    void offer(std::uint32_t input, double d2) {
        if (!(d2 < second2) || input == first || input == second) return;
        const bool is_first = d2 < first2;
        second = is_first ? first : input;
        second2 = is_first ? first2 : d2;
        if (!is_first) return;
        first = input;
        first2 = d2;
    }
};

// TreePart of input_tree.hpp.
struct AnyTreePart {
    TreeRange range;
    double least2, offset[dimension_max];

    AnyTreePart beyond(int dim, int axis, double distance, TreeRange other) const {
        AnyTreePart part = {other, 0, {}};
        for (int k = 0; k < dim; ++k) {
            part.offset[k] = k == axis ? distance : offset[k];
            part.least2 += part.offset[k] * part.offset[k];
        }
        return part;
    }
};

class StepAudit {
public:
    StepAudit(const AnyAuditedMesh& mesh, const AuditStep& step, QualityAudit* audit)
        : dim(mesh.store.dim), store_(mesh.store), tree_(mesh.tree), outermost_(mesh.outermost), terms_(mesh.terms),
          hierarchy_(mesh.hierarchy != nullptr && mesh.hierarchy->live() > 0 ? mesh.hierarchy : nullptr),
          made_(mesh.hierarchy), kind_(mesh.kind), step_(step), audit_(*audit), frame_(mesh.tree.root().end) {}

    Status run();

private:
    template <class Visit> bool visit_changed(Visit&& visit);
    bool has_outermost_features();
    bool list_changed();
    void list_cages(CellId c);
    bool measure_listed();
    bool measure_vertex(VertexId v);
    bool measure_ratio(VertexId v, std::uint32_t cells, double nearest2, const AnyDomain& ball);
    bool measure_cage(std::uint32_t d);
    double reach_of_cage(const Cage& cage, const CellId* boundary, std::uint32_t cells, double bound2) const;
    void look_from_outside(const Cage& cage, std::uint32_t w);
    void look_at_step();
    void look_at_shells();
    void raise_feature(const double* x, std::uint32_t domain, double mesh2, TwoNearest* inputs, double* kind);
    void find_second(const double* x, std::uint32_t domain, double enough2, TwoNearest* inputs);
    bool offer_member(const double* x, std::uint32_t domain, std::uint32_t input, double reach, TwoNearest* inputs);

    std::uint32_t domain_in_hierarchy(std::uint32_t v) const { return hierarchy_->of_vertex(store_, v); }
    // Cells are whole then.
    bool is_thesis() const { return dim <= thesis_dim_max && kind_ == CageKind::thesis; }
    // Is input v in the place of a vertex of the shell of its domain? With cages of the thesis alone.
    bool has_yielded(std::uint32_t v) const {
        return is_thesis() && hierarchy_ != nullptr &&
               has_yielded_to(store_, hierarchy_->cages(), domain_in_hierarchy(v), v);
    }
    bool is_noted(std::uint32_t v) const {
        for (std::uint32_t k = 0; k < step_.note_count; ++k)
            if (step_.notes[k].vertex == v) return true;
        return false;
    }
    bool is_new(std::uint32_t v) const { return v >= step_.first_made || v == step_.vertex; }
    bool is_frame(std::uint32_t v) const { return v >= frame_ && v < frame_ + 2 * static_cast<std::uint32_t>(dim); }
    std::uint32_t domain_of(std::uint32_t v) const { return hierarchy_ == nullptr ? none : domain_in_hierarchy(v); }
    std::uint32_t member(std::uint32_t v, std::uint32_t domain, std::uint32_t* within) const;
    // K' of those that the step has inserted.
    double* kind_of(std::uint32_t v) const {
        if (v == step_.vertex) return step_.cleaning ? &audit_.steiner : &audit_.input;
        const bool is_of_shell = v >= step_.first_made || (v < frame_ && is_noted(v) && has_yielded(v));
        return is_of_shell ? &audit_.cage : nullptr;
    }

    const int dim;
    const AnyStore& store_;
    const AnyInputTree& tree_;
    const AnyDomain& outermost_;
    const AuditTerms terms_;
    CageForest *const hierarchy_, *const made_;  // null: no cages now; none ever
    const CageKind kind_;
    const AuditStep step_;
    QualityAudit& audit_;
    const std::uint32_t frame_;  // the first vertex of the frame
    std::uint32_t* list_ = nullptr;
    std::uint32_t count_ = 0;
    std::uint32_t cages_ = none;  // whose cells have changed: a list as that of AuditStep
    bool encroached_ = false;
    bool all_features_rise_ = false;  // f_P has just become finite in the outermost domain
};

}  // namespace netmesh
