#include "mesh/thesis_cages.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class ThesisRule : public ThesisCages<D, ThesisRule<D>> {
public:
    using ThesisCages<D, ThesisRule<D>>::ThesisCages;
};

}  // namespace

template <int D>
Status mesh_by_thesis_cages(Store<D>& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                            const Work& work, MeshResult<D>* result) {
    if constexpr (D <= thesis_dim_max)
        return mesh_by_rule<D, ThesisRule<D>>(store, points, n, request, work, result);
    else
        return Status::invalid_argument;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_by_thesis_cages<D>(Store<D>&, const InputRows&, std::size_t, const MeshRequest&, const Work&, \
                                            MeshResult<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
