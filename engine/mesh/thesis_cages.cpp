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
    return with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        if constexpr (D <= thesis_dim_max)
            return mesh_by < D, ThesisRule,
                   serves_one_dimension ? D : any_dimension > (store, points, n, request, work, result);
        else
            return Status::invalid_argument;
    });
}

}  // namespace netmesh
