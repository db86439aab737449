#include "jobs/k_vineyard.hpp"

#include "complex/faces.hpp"
#include "homology/vineyard/vineyard.hpp"
#include "memory/arena.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Points on their way, at the arena's low end.
class PointWriter {
public:
    explicit PointWriter(Arena& arena) : arena_(arena) {}
    bool add(const VinePoint& point) {
        VinePoint* const first = count_ == 0 ? arena_.take_low<VinePoint>(1) : points_;
        if (first == nullptr || (count_ > 0 && !arena_.extend_low(sizeof(VinePoint)))) return false;
        points_ = first;
        points_[count_++] = point;
        return true;
    }
    VinePoint* points() const { return points_; }
    std::uint64_t count() const { return count_; }

private:
    Arena& arena_;
    VinePoint* points_ = nullptr;
    std::uint64_t count_ = 0;
};

template <int D> class KVineyard {
public:
    KVineyard(const FilteredMesh<D>& mesh, const VineRequest& request, const Work& work)
        : mesh_(mesh), request_(request), work_(work), arena_(work.arena), writer_(work.arena) {}

    // Fills ratio[k_last - k_first + 1], and leaves the points somewhere above the arena's low mark.
    Status run(double* ratio, VineList* out);

private:
    Status open();
    Status filter(std::uint32_t k, double** value, double* ratio);
    bool note(std::uint32_t k, const double* const* value);
    Status number_vines(VineList* out);

    const FilteredMesh<D>& mesh_;
    const VineRequest& request_;
    const Work& work_;
    Arena& arena_;
    PointWriter writer_;
    Faces<D> faces_;
    ComplexView complex_ = {};
    double* vertex_value_ = nullptr;
    double* value_[2][D + 1] = {};
    Vineyard vineyard_;
};

template <int D> Status KVineyard<D>::open() {
    const int top = static_cast<int>(request_.max_degree) + 1;
    work_.monitor.begin(NETMESH_STAGE_FILTER, 0);
    const Status status = enumerate_faces<D>(mesh_.store.view(), top, work_, &faces_);
    if (status != Status::ok) return status;
    complex_.dimension = static_cast<std::uint32_t>(top);
    for (int k = 0; k <= top; ++k) {
        complex_.count[k] = faces_.count[k];
        complex_.facets[k] = faces_.facets[k];
        value_[0][k] = arena_.take_high<double>(faces_.count[k]);
        value_[1][k] = arena_.take_high<double>(faces_.count[k]);
        if (value_[0][k] == nullptr || value_[1][k] == nullptr) return Status::out_of_memory;
    }
    vertex_value_ = arena_.take_high<double>(mesh_.vertices());
    return vertex_value_ == nullptr ? Status::out_of_memory : Status::ok;
}

// Values of all simplices, as netmesh_persist gives them.
template <int D> Status KVineyard<D>::filter(std::uint32_t k, double** value, double* ratio) {
    Evaluation evaluation = {vertex_value_};
    const Status status = evaluate<D>(mesh_, {request_.filter, request_.values, k}, work_, &evaluation);
    if (status != Status::ok) return status;
    *ratio = evaluation.certificate.ratio;
    for (std::uint32_t f = 0; f < faces_.count[0]; ++f) value[0][f] = vertex_value_[faces_.last_vertex[0][f]];
    for (int dimension = 1; dimension <= faces_.dimension_max; ++dimension)
        for (std::uint32_t f = 0; f < faces_.count[dimension]; ++f) {
            double most = 0;
            for (int i = 0; i <= dimension; ++i) {
                const double below = value[dimension - 1][faces_.facets_of(dimension, f)[i]];
                if (below > most) most = below;
            }
            value[dimension][f] = most;
        }
    for (std::uint32_t f = 0; f < faces_.count[0]; ++f)
        if (faces_.last_vertex[0][f] < evaluation.zero_born) value[0][f] = 0;
    return Status::ok;
}

template <int D> bool KVineyard<D>::note(std::uint32_t k, const double* const* value) {
    bool good = true;
    vineyard_.for_each_pair([&](const Vineyard::VinePair& pair) {
        const double birth = value[pair.degree][pair.birth];
        const double death = pair.death == none ? infinity : value[pair.degree + 1][pair.death];
        if (death > birth) good = good && writer_.add({birth, death, pair.vine, k, pair.degree, 0});
    });
    return good;
}

// Numbers the vines that have points, and sorts.
template <int D> Status KVineyard<D>::number_vines(VineList* out) {
    const HighScope scope(arena_);
    VinePoint* const points = writer_.points();
    const std::uint64_t count = writer_.count();
    const std::uint32_t raw_count = vineyard_.vine_count();
    std::uint32_t* const number = arena_.take_high<std::uint32_t>(raw_count);
    VinePoint* const first = arena_.take_high<VinePoint>(raw_count);
    if (number == nullptr || first == nullptr || count >= none) return Status::out_of_memory;
    std::uint32_t vines = 0;
    for (std::uint32_t v = 0; v < raw_count; ++v) number[v] = none;
    for (std::uint64_t i = 0; i < count; ++i) {  // in the order of k
        if (number[points[i].vine] != none) continue;
        number[points[i].vine] = 0;
        first[vines++] = points[i];
    }
    sort(first, vines, [](const VinePoint& a, const VinePoint& b) {
        if (a.degree != b.degree) return a.degree < b.degree;
        if (a.k != b.k) return a.k < b.k;
        if (a.birth != b.birth) return a.birth < b.birth;
        if (a.death != b.death) return a.death < b.death;
        return a.vine < b.vine;
    });
    for (std::uint32_t v = 0; v < vines; ++v) number[first[v].vine] = v;
    for (std::uint64_t i = 0; i < count; ++i) points[i].vine = number[points[i].vine];
    sort(points, count,
         [](const VinePoint& a, const VinePoint& b) { return a.vine != b.vine ? a.vine < b.vine : a.k < b.k; });
    out->points = points;
    out->count = count;
    out->vine_count = vines;
    return Status::ok;
}

template <int D> Status KVineyard<D>::run(double* ratio, VineList* out) {
    Status status = open();
    if (status == Status::ok) status = filter(request_.k_first, value_[0], ratio);
    if (status == Status::ok) status = vineyard_.open(complex_, request_.max_degree, value_[0], work_);
    int now = 0;
    if (status == Status::ok && !note(request_.k_first, value_[now])) status = Status::out_of_memory;
    for (std::uint32_t k = request_.k_first + 1; k <= request_.k_last && status == Status::ok; ++k, now = 1 - now) {
        status = filter(k, value_[1 - now], ratio + (k - request_.k_first));
        if (status == Status::ok) status = vineyard_.advance(value_[now], value_[1 - now], work_.monitor);
        if (status == Status::ok && !note(k, value_[1 - now])) status = Status::out_of_memory;
    }
    if (status == Status::ok) status = number_vines(out);
    if (status != Status::ok) return status;
    out->simplices = 0;
    for (std::uint32_t k = 0; k <= complex_.dimension; ++k) out->simplices += complex_.count[k];
    out->transpositions = vineyard_.transpositions();
    return Status::ok;
}

}  // namespace

template <int D>
Status k_vineyard(const FilteredMesh<D>& mesh, const VineRequest& request, const Work& work, VineList* out) {
    ArenaScope scope(work.arena);
    const std::uint32_t steps = request.k_last - request.k_first + 1;
    double* const ratio = work.arena.take_low<double>(steps);
    const std::size_t low = work.arena.low_mark();
    if (ratio == nullptr) return Status::out_of_memory;
    KVineyard<D> vineyard(mesh, request, work);
    const Status status = vineyard.run(ratio, out);
    if (status != Status::ok) return status;
    work.arena.release_low(low);
    // Where the old ones are or below.
    VinePoint* const points = work.arena.take_low<VinePoint>(static_cast<std::size_t>(out->count));
    if (points == nullptr) return Status::out_of_memory;
    __builtin_memmove(points, out->points, sizeof(VinePoint) * static_cast<std::size_t>(out->count));
    out->ratio = ratio;
    out->points = points;
    scope.keep_low_from_now();
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status k_vineyard<D>(const FilteredMesh<D>&, const VineRequest&, const Work&, VineList*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
