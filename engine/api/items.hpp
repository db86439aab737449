// The mesh of a context that is only read.
#pragma once
#include "api/call.hpp"
#include "jobs/decide.hpp"

namespace netmesh {

// The store of the mesh where the block is now. The context stays as it is.
template <int D> class KeptStore {
public:
    explicit KeptStore(const netmesh_context* context)
        : arena_(context->arena), state_(context->mesh.store), store_(arena_, state_) {
        arena_.rebase(const_cast<netmesh_context*>(context));
    }
    KeptStore(const KeptStore&) = delete;
    KeptStore& operator=(const KeptStore&) = delete;

    const Store<D>& store() const { return store_; }
    std::uint32_t vertex_count() const { return state_.vertex_count; }
    std::uint32_t cell_count() const { return state_.cell_slots; }

private:
    Arena arena_;
    StoreState state_;
    Store<D> store_;
};

// The bounds of a fit that decides bars.
inline DecisionView decision_of(const netmesh_context* context) {
    const KeptBounds& kept = context->bounds;
    return {kept.bars.in(context), kept.bars.count, kept.steps.in(context), kept.steps.count, kept.longer_than};
}

}  // namespace netmesh
