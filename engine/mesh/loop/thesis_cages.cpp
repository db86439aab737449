#include "mesh/loop/thesis_cages.hpp"
#include "mesh/loop/thesis_shells.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class ThesisRule : public ThesisCages<D, ThesisRule<D>> {
public:
    using ThesisCages<D, ThesisRule<D>>::ThesisCages;
};

// A mesh that ends with a cell that is left is made anew, with an outermost cage that much larger, so many times.
constexpr double outermost_growth = 1.25;
constexpr int retries_max = 6;

Status mesh_once(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request, const Work& work,
                 AnyMeshResult* result) {
    return with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        if constexpr (D <= thesis_dim_max)
            return mesh_by < D, ThesisRule,
                   serves_one_dimension ? D : any_dimension > (store, points, n, request, work, result);
        else
            return Status::invalid_argument;
    });
}

}  // namespace

Status mesh_by_thesis_cages(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                            const Work& work, AnyMeshResult* result) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    const StoreState empty = store.state;
    MeshRequest asked = request;
    for (int retries = 0;; ++retries) {
        const Status status = mesh_once(store, points, n, asked, work, result);
        if (status != Status::check_failed || retries == retries_max) return status;
        work.arena.release_low(low);
        work.arena.release_high(high);
        store.state = empty;
        store.locate_arrays();
        asked.outermost_scale *= outermost_growth;
    }
}

}  // namespace netmesh
