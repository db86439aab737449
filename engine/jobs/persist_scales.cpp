#include "jobs/persist_scales.hpp"

#include "filtration/filters.hpp"
#include "filtration/scale_partition.hpp"
#include "filtration/tight_filter.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "mesh/mesh_points.hpp"
#include "numerics/double_double.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Appends the bars of a cluster, without the essential one but for the first cluster. They stand somewhere above `low`,
// where the ones before them end. False: out of memory.
bool add_pairs(const PairList& list, bool is_first, std::size_t low, Arena& arena, PairList* joined) {
    std::uint64_t kept = 0;
    for (std::uint64_t i = 0; i < list.count; ++i)
        if (is_first || list.pairs[i].death < infinity) list.pairs[kept++] = list.pairs[i];
    arena.release_low(low);
    Pair* to = joined->pairs + joined->count;
    if (joined->count == 0) {
        to = joined->pairs = arena.take_low<Pair>(static_cast<std::size_t>(kept));  // not above where they are
        if (to == nullptr) return false;
    } else if (!arena.extend_low(static_cast<std::size_t>(kept) * sizeof(Pair))) {
        return false;
    }
    __builtin_memmove(to, list.pairs, static_cast<std::size_t>(kept) * sizeof(Pair));
    joined->count += kept;
    return true;
}

// Counts the mesh of a cluster of `points`.
void add_mesh(std::uint32_t points, std::uint32_t vertices, std::uint64_t simplices, const Certificate& certificate,
              ScalesResult* result) {
    result->simplices += simplices;
    result->vertices += vertices;
    if (points > result->most_points) result->most_points = points;
    if (vertices > result->most_vertices) result->most_vertices = vertices;
    if (!(certificate.ratio <= result->ratio)) result->ratio = certificate.ratio;
    if (!(certificate.ratio_best <= result->ratio_best)) result->ratio_best = certificate.ratio_best;
}

// The factor between the distance to all points and that to those of each scale: E / (E - 1), at least.
double join_factor(std::uint32_t clusters, double separation) {
    if (clusters == 1) return 1;
    return separation >= 2 ? separation / (separation - 1) * up : infinity;
}

template <int D> class ScalesJoin {
public:
    ScalesJoin(const Store<D>& points, const ScalesRequest& request, const Work& work, ScalesResult* result)
        : points_(points), request_(request), arena_(work.arena), monitor_(work.monitor), result_(result) {}

    // Leaves the joined pairs somewhere above the arena's low mark, with what was taken on the way.
    Status run(std::uint32_t count);

private:
    Status divide(std::uint32_t count);
    Status add_cluster();
    MeshRequest mesh_request() const;
    Status persist_mesh(const double* x, std::uint32_t n, PairList* list);
    void copy_points(double* x) const;

    const Store<D>& points_;
    const ScalesRequest& request_;
    Arena& arena_;
    Monitor& monitor_;
    ScalesResult* result_;
    ScalePartition<D> partition_;
    double goal_ = 0;  // ratio of each mesh; 0: eps says
};

// The chosen points: from the first of them where all differences are exact, else as they are.
template <int D> void ScalesJoin<D>::copy_points(double* x) const {
    const std::uint32_t n = partition_.chosen_count();
    const double* const first = points_.point(partition_.chosen()[0]);
    bool exact = true;
    for (std::uint32_t i = 0; i < n; ++i)
        for (int k = 0; k < D; ++k) {
            const DoubleDouble d = two_difference(points_.point(partition_.chosen()[i])[k], first[k]);
            exact = exact && d.low == 0;
            x[std::size_t{i} * D + static_cast<std::size_t>(k)] = d.high;
        }
    if (exact) return;
    for (std::uint32_t i = 0; i < n; ++i)
        for (int k = 0; k < D; ++k)
            x[std::size_t{i} * D + static_cast<std::size_t>(k)] = points_.point(partition_.chosen()[i])[k];
}

template <int D> MeshRequest ScalesJoin<D>::mesh_request() const {
    MeshRequest request;
    request.tau = request_.tau;
    request.seed = request_.seed;
    if (goal_ > 0) {
        request.method = MeshMethod::certificate;
        request.certify_filter = true;
        request.goal = {goal_, 0, 0, 0, true};
    } else {
        request.domain_factor = tight_domain_factor(request_.eps);
        request.size.eps = tight_size(request_.eps);
    }
    return request;
}

template <int D> Status ScalesJoin<D>::persist_mesh(const double* x, std::uint32_t n, PairList* list) {
    StoreState state = {};
    Store<D> store(arena_, state);
    MeshResult<D> mesh;
    Status status = mesh_points<D>(store, x, n, mesh_request(), {arena_, monitor_}, &mesh);
    const InputReport& input = mesh.input;
    if (status == Status::out_of_range || status == Status::too_close || status == Status::invalid_argument) {
        const std::uint64_t a = points_.vertex(partition_.chosen()[input.row_a]).origin;
        const std::uint64_t b = points_.vertex(partition_.chosen()[input.row_b]).origin;
        const bool are_two = input.row_b > input.row_a;
        result_->row_a = are_two && b < a ? b : a;
        result_->row_b = !are_two ? 0 : a < b ? b : a;
    }
    if (status != Status::ok) return status;
    double* const value = arena_.take_low<double>(state.vertex_count);
    if (value == nullptr) return Status::out_of_memory;
    const Work work = {arena_, monitor_};
    Evaluation filter = {value};
    const FilterRequest which = {goal_ > 0 ? NETMESH_FILTER_COMPLETE : NETMESH_FILTER_TIGHT, request_.values};
    const FilteredMesh<D> whole = {store, mesh.domain, n, goal_ > 0};
    ClippedCells<D> cells;
    status = clip_cells<D>(whole, which, work, &cells);
    const FilteredMesh<D> filtered = cells.of(whole);
    if (status == Status::ok) status = evaluate<D>(filtered, which, work, &filter);
    CountedPairs found = {};
    if (status == Status::ok)
        status = persist_lower_star<D>({store.view(), value, n, filtered.part},
                                       {request_.max_degree, request_.keep_zero}, work, &found);
    if (status != Status::ok) return status;
    *list = found.pairs;
    add_mesh(n, state.vertex_count, found.simplices, filter.certificate, result_);
    return Status::ok;
}

template <int D> Status ScalesJoin<D>::add_cluster() {
    const std::size_t low = arena_.low_mark(), high = arena_.high_mark();
    const std::uint32_t n = partition_.chosen_count();
    double* const x = arena_.take_high<double>(std::size_t{n} * D);
    if (x == nullptr) return Status::out_of_memory;
    copy_points(x);
    PairList list = {};
    const Status status = persist_mesh(x, n, &list);
    arena_.release_high(high);
    if (status != Status::ok) return status;
    return add_pairs(list, partition_.clusters() == 1, low, arena_, &result_->pairs) ? Status::ok
                                                                                     : Status::out_of_memory;
}

// Sets the ratio of each mesh: what the join leaves, with its roundings.
template <int D> Status ScalesJoin<D>::divide(std::uint32_t count) {
    const std::size_t low = arena_.low_mark();
    const Status status = partition_.open(points_, count, request_.theta, arena_);
    bool stopped = false;
    while (status == Status::ok && partition_.next(monitor_, &stopped)) {
    }
    arena_.release_low(low);
    goal_ = request_.ratio / join_factor(partition_.clusters(), partition_.separation()) / (up * up);
    return status == Status::ok && stopped ? Status::cancelled : status;
}

template <int D> Status ScalesJoin<D>::run(std::uint32_t count) {
    Status status = request_.ratio > 0 ? divide(count) : Status::ok;
    if (status == Status::ok) status = partition_.open(points_, count, request_.theta, arena_);
    bool stopped = false;
    while (status == Status::ok && partition_.next(monitor_, &stopped)) status = add_cluster();
    if (status == Status::ok && stopped) status = Status::cancelled;
    if (status != Status::ok) return status;
    result_->clusters = partition_.clusters();
    result_->separation = partition_.separation();
    if (result_->clusters == 1) return Status::ok;
    const double join = join_factor(result_->clusters, result_->separation) * up;
    result_->ratio *= join;
    result_->ratio_best *= join;
    return Status::ok;
}

}  // namespace

template <int D>
Status persist_scales(const Store<D>& points, std::uint32_t count, const ScalesRequest& request, const Work& work,
                      ScalesResult* result) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *result = ScalesResult{};
    result->ratio = result->ratio_best = 1;
    work.monitor.begin(NETMESH_STAGE_SORT, count);
    ScalesJoin<D> join(points, request, work, result);
    Status status = join.run(count);
    work.arena.release_low(low);
    work.arena.release_high(high);
    if (status == Status::ok) status = move_pairs_down(low, work.arena, &result->pairs);
    if (status != Status::ok) return status;
    sort(result->pairs.pairs, result->pairs.count, CanonicalOrder{});
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status persist_scales<D>(const Store<D>&, std::uint32_t, const ScalesRequest&, const Work&, ScalesResult*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
