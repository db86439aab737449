#include "mesh/thesis_cages.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class ThesisRule : public ThesisCages<D, ThesisRule<D>> {
public:
    using ThesisCages<D, ThesisRule<D>>::ThesisCages;
};

}  // namespace

Status mesh_by_thesis_cages(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                            const Work& work, AnyMeshResult* result) {
    if (store.dim > thesis_dim_max) return Status::invalid_argument;
    return mesh_by_rule<any_dimension, ThesisRule<any_dimension>>(store, points, n, request, work, result);
}

}  // namespace netmesh
