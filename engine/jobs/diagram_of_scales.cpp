#include "jobs/diagram_of_scales.hpp"

#include "filtration/filters.hpp"
#include "filtration/scale_partition.hpp"
#include "filtration/tight_filter.hpp"
#include "filtration/tighten_cell_bounds.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "jobs/certified_bars.hpp"
#include "jobs/diagram_of_packed.hpp"
#include "jobs/join_shift.hpp"
#include "jobs/joined_bars.hpp"
#include "jobs/mesh_filtration.hpp"
#include "jobs/scale_grid.hpp"
#include "mesh/mesh_points.hpp"
#include "numerics/double_double.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Appends the bars of a cluster, without the essential one but for the first cluster. They stand somewhere above `low`,
// where the ones before them end. False: out of memory.
bool join_pairs(const PairList& list, bool is_first, std::size_t low, Arena& arena, PairList* joined) {
    std::uint64_t kept = 0;
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena.piece(i, list.count, 10); i < piece; ++i) {
            if (is_first || list.pairs[i].death < infinity) list.pairs[kept++] = list.pairs[i];
        }
    arena.release_low(low);
    Pair* to = joined->pairs + joined->count;
    if (joined->count == 0) {
        to = joined->pairs = arena.take_low<Pair>(static_cast<std::size_t>(kept));  // not above where they are
        if (to == nullptr) return false;
    } else if (!arena.extend_low(static_cast<std::size_t>(kept) * sizeof(Pair))) {
        return false;
    }
    move_bytes(to, list.pairs, static_cast<std::size_t>(kept) * sizeof(Pair), arena);
    joined->count += kept;
    return true;
}

// Counts the mesh of a cluster of `points`.
void count_mesh(std::uint32_t points, std::uint32_t vertices, std::uint64_t simplices, const Certificate& certificate,
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

class ScalesJoin {
public:
    ScalesJoin(const AnyStore& points, const ScalesRequest& request, const Work& work, ScalesResult* result)
        : points_(points), request_(request), arena_(work.arena), monitor_(work.monitor), result_(result) {}

    // Leaves the joined pairs somewhere above the arena's low mark, with what was taken on the way; where more than
    // pairs is asked for, all but the chains at the high end.
    Status run(std::uint32_t count);
    // All of the result at the low end.
    Status finish();

private:
    Status divide(std::uint32_t count);
    Status add_cluster();
    MeshRequest mesh_request() const;
    // Neither stands on the stack while the other runs.
    [[gnu::noinline]] Status make_mesh(const double* x, std::uint32_t n, StoreState* state, AnyDomain* domain);
    [[gnu::noinline]] Status persist_mesh(const AnyMesh& whole, MeshBars* bars);
    Status bound_mesh(const AnyMesh& mesh, const FilterRequest& which, const Evaluation& filter, const MeshBars& bars);
    Status find_chains(const AnyMesh& mesh, const double* value, MeshBars* bars);
    bool has_more() const { return request_.bounds || request_.representatives; }
    void copy_points(double* x) const;

    const AnyStore& points_;
    const ScalesRequest& request_;
    Arena& arena_;
    Monitor& monitor_;
    ScalesResult* result_;
    ScalePartition partition_;
    double goal_ = 0;  // ratio of each mesh; 0: eps says
    JoinShift shift_;
    ScaleGrid grid_;
    JoinedBars bars_;
};

// The chosen points: from the first of them where all differences are exact, else as they are.
void ScalesJoin::copy_points(double* x) const {
    const std::uint32_t n = partition_.chosen_count();
    const std::size_t dim = static_cast<std::size_t>(points_.dim);
    const double* const first = points_.point(partition_.chosen()[0]);
    bool exact = true;
    for (std::uint32_t i = 0; i < n;)
        for (const std::uint64_t piece = arena_.piece(i, n, 12 * points_.dim); i < piece; ++i) {
            for (std::size_t k = 0; k < dim; ++k) {
                const DoubleDouble d = exact_difference(points_.point(partition_.chosen()[i])[k], first[k]);
                exact = exact && d.low == 0;
                x[i * dim + k] = d.high;
            }
        }
    if (exact) return;
    for (std::uint32_t i = 0; i < n;)
        for (const std::uint64_t piece = arena_.piece(i, n, 12 * points_.dim); i < piece; ++i) {
            for (std::size_t k = 0; k < dim; ++k) x[i * dim + k] = points_.point(partition_.chosen()[i])[k];
        }
}

MeshRequest ScalesJoin::mesh_request() const {
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

// The true bars are those of all points; where they are among those of this scale's, the join has its part in.
Status ScalesJoin::bound_mesh(const AnyMesh& mesh, const FilterRequest& which, const Evaluation& filter,
                              const MeshBars& bars) {
    const Work work = {arena_, monitor_};
    const BarList list = {bars.list.pairs, bars.list.count};
    const FilterBounds cells = {filter.value, filter.interval, mesh.vertices()};
    Status status = Status::ok;
    if (find_filter(which.filter)->has(filter_trait::has_tighter_cells))
        status = tighten_cell_bounds(mesh, work, filter.interval);
    if (status == Status::ok) status = bound_in_join(cells, list, shift_, arena_, bars.bounds, &grid_);
    if (status == Status::ok)
        status = find_certified_bars({mesh.store.view(), cells, mesh.inputs, list, mesh.filtered_part(), {}, &shift_},
                                     work, bars.bounds);
    if (status == Status::ok) move_lows(shift_, bars);
    return status;
}

Status ScalesJoin::find_chains(const AnyMesh& mesh, const double* value, MeshBars* bars) {
    Representatives found = {};
    const Status status = lower_star_cycles(mesh_filtration(mesh, value, mesh.inputs), request_.max_degree,
                                            count_long(bars->list), {arena_, monitor_}, &found);
    if (status != Status::ok) return status;
    std::uint32_t* const name = arena_.take_high<std::uint32_t>(mesh.vertices());
    if (name == nullptr) return Status::out_of_memory;
    for (std::uint32_t v = 0; v < mesh.vertices();)
        for (const std::uint64_t piece = arena_.piece(v, mesh.vertices(), 15); v < piece; ++v) {
            name[v] = partition_.chosen()[mesh.store.vertex(nearest_input(mesh.store, VertexId(v))).origin];
        }
    return write_images(found, name, arena_, bars);
}

Status ScalesJoin::make_mesh(const double* x, std::uint32_t n, StoreState* state, AnyDomain* domain) {
    AnyStore store(points_.dim, arena_, *state);
    AnyMeshResult mesh;
    const Work work = {arena_, monitor_};
    const Status status = goal_ > 0 ? mesh_for_certificate(store, x, n, mesh_request(), work, &mesh)
                                    : mesh_of_quality(store, x, n, mesh_request(), work, &mesh);
    const InputReport& input = mesh.input;
    if (status == Status::out_of_range || status == Status::too_close || status == Status::invalid_argument) {
        const std::uint64_t a = points_.vertex(partition_.chosen()[input.row_a]).origin;
        const std::uint64_t b = points_.vertex(partition_.chosen()[input.row_b]).origin;
        const bool are_two = input.row_b > input.row_a;
        result_->row_a = are_two && b < a ? b : a;
        result_->row_b = !are_two ? 0 : a < b ? b : a;
    }
    *domain = mesh.domain;
    return status;
}

Status ScalesJoin::persist_mesh(const AnyMesh& whole, MeshBars* bars) {
    const std::uint32_t n = whole.inputs, vertices = whole.vertices();
    const std::size_t behind = arena_.low_mark();
    double* const value = arena_.take_low<double>(vertices);
    if (value == nullptr) return Status::out_of_memory;
    const Work work = {arena_, monitor_};
    Evaluation filter = {value};
    if (request_.bounds) {
        filter.interval = arena_.take_high<Interval>(vertices);
        if (filter.interval == nullptr) return Status::out_of_memory;
    }
    const FilterRequest which = {goal_ > 0 ? NETMESH_FILTER_COMPLETE : NETMESH_FILTER_TIGHT,
                                 goal_ > 0 ? &complete_on_mesh : &tight_on_mesh, request_.values};
    AnyMesh mesh = whole;
    Status status = clip_cells(which, work, &mesh);
    if (status == Status::ok) status = evaluate(mesh, which, work, &filter);
    CountedPairs found = {};
    if (status == Status::ok)
        status = diagram_of_packed<false>(mesh.store, {behind, arena_.high_mark()}, mesh_filtration(mesh, value, n),
                                          {request_.max_degree, request_.keep_zero}, work, &found);
    if (status != Status::ok) return status;
    bars->list = found.pairs;
    count_mesh(n, vertices, found.simplices, filter.certificate, result_);
    if (!has_more()) return Status::ok;
    bars->bounds = arena_.take_low<BarBounds>(static_cast<std::size_t>(found.pairs.count));
    if (bars->bounds == nullptr) return Status::out_of_memory;
    for (std::uint64_t i = 0; i < found.pairs.count;)
        for (const std::uint64_t piece = arena_.piece(i, found.pairs.count, 10); i < piece; ++i) {
            bars->bounds[i] = {};
        }
    if (request_.bounds) status = bound_mesh(mesh, which, filter, *bars);
    return status == Status::ok && request_.representatives ? find_chains(mesh, value, bars) : status;
}

Status ScalesJoin::add_cluster() {
    const std::size_t low = arena_.low_mark(), high = arena_.high_mark();
    const std::uint32_t n = partition_.chosen_count();
    double* const x = arena_.take_high<double>(n * static_cast<std::size_t>(points_.dim));
    if (x == nullptr) return Status::out_of_memory;
    copy_points(x);
    MeshBars bars = {};
    const bool is_first = partition_.clusters() == 1;
    StoreState state = {};
    AnyDomain domain = {};
    Status status = make_mesh(x, n, &state, &domain);
    if (status == Status::ok)
        status = persist_mesh(AnyMesh(AnyStore(points_.dim, arena_, state), domain, n, goal_ > 0), &bars);
    arena_.release_high(high);
    if (status != Status::ok) return status;
    const bool room =
        has_more() ? bars_.add(bars, is_first, arena_) : join_pairs(bars.list, is_first, low, arena_, &result_->pairs);
    return room ? Status::ok : Status::out_of_memory;
}

// Sets the ratio of each mesh: what the join leaves, with its roundings; and what bounds have to know of the clusters.
Status ScalesJoin::divide(std::uint32_t count) {
    const std::size_t low = arena_.low_mark();
    Status status = partition_.open(points_, count, request_.theta, arena_);
    bool stopped = false;
    while (status == Status::ok && partition_.next(monitor_, &stopped)) {
        if (request_.bounds && partition_.clusters() > 1 && !shift_.add(partition_.radius(), partition_.gap(), arena_))
            status = Status::out_of_memory;
    }
    arena_.release_low(low);
    if (status != Status::ok || stopped) return status == Status::ok ? Status::cancelled : status;
    if (request_.ratio > 0)
        goal_ = request_.ratio / join_factor(partition_.clusters(), partition_.separation()) / (up * up);
    if (!request_.bounds) return Status::ok;
    shift_.close();
    // The values of a mesh are half of what is between two of its points, but for what refinement adds to that, or
    // more, and no more than the radius of a ball around the points. None is lost beyond.
    const double closest = partition_.closest(), widest = partition_.widest();
    const bool is_one = !(closest < infinity);
    if (!grid_.open(is_one ? 1 : 0.125 * closest, is_one ? 1 : 2 * widest, arena_)) return Status::out_of_memory;
    return Status::ok;
}

Status ScalesJoin::finish() {
    const bool room =
        bars_.finish(arena_, &result_->cycles, &result_->pairs, request_.bounds ? &result_->bounds : nullptr) &&
        (!request_.bounds || grid_.finish(shift_, result_->ratio, arena_, &result_->curve));
    return room ? Status::ok : Status::out_of_memory;
}

Status ScalesJoin::run(std::uint32_t count) {
    Status status = request_.ratio > 0 || request_.bounds ? divide(count) : Status::ok;
    if (status == Status::ok) status = partition_.open(points_, count, request_.theta, arena_);
    bars_.open(arena_);
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

// What it takes of the stack is not there while meshes are made.
[[gnu::noinline]] void put_in_order(const PairList& list, const Arena& arena) {
    sort(list.pairs, list.count, CanonicalOrder{}, arena);
}

}  // namespace

Status diagram_of_scales(const AnyStore& points, std::uint32_t count, const ScalesRequest& request, const Work& work,
                         ScalesResult* result) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *result = ScalesResult{};
    result->ratio = result->ratio_best = 1;
    work.monitor.begin(NETMESH_STAGE_SORT, count);
    ScalesJoin join(points, request, work, result);
    Status status = join.run(count);
    work.arena.release_low(low);
    const bool has_more = request.bounds || request.representatives;
    if (status == Status::ok) status = has_more ? join.finish() : move_pairs_down(low, work.arena, &result->pairs);
    work.arena.release_high(high);
    if (status != Status::ok) {
        work.arena.release_low(low);
        return status;
    }
    if (!has_more) put_in_order(result->pairs, work.arena);
    return Status::ok;
}

}  // namespace netmesh
