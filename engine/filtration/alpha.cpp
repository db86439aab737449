// Values go down from the cells, twice. First every face gets its radius, and its facets a mark where its apex is in
// their spheres: those get no value of their own. Then the radii are put into exact order. Then each marked face gets
// the least value of its cofacets.
//
// Why that is the alpha complex when points are cospherical. Let F be a face, c the centre of its smallest
// circumsphere, g_p(c) = |p - c|^2 - radius^2, and let the triangulation be that of lifts raised by infinitely small
// weights (predicates.cpp). The centres of spheres through F that are empty up to weights are { g_v + small >= 0 } for
// the apexes v of F's cofacets, a polyhedron that is not empty as F is a face; the normals of these half-spaces do not
// depend on the weights. If some p is strictly inside, g_p(c) < 0, then g_p + small is >= 0 on the polyhedron, thus at
// least a combination of the g_v + small with factors >= 0, which may be chosen from finitely many; so some g_v(c) < 0:
// looking at apexes of cofacets is enough. An apex on the sphere is marked too. If then nothing is strictly inside, the
// cofacet has the same sphere and nothing inside either, its value is the same radius, and no cofacet has less: the
// value of the face is right, and copied instead of being compared.
#include "filtration/alpha.hpp"

#include "filtration/circumsphere_fast.hpp"
#include "filtration/radius_order.hpp"
#include "numerics/bits.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr std::uint32_t faces_between_polls = 256;

// D may be any_dimension, and so may the K of faces then.
template <int D> class AlphaValues {
public:
    using Table = std::conditional_t<D == any_dimension, FaceTable, Faces<D>>;

    AlphaValues(DimensionOf<D> dim, const Table& faces, const PointRecords& points, const Work& work,
                double* const* value)
        : dim_(dim), faces_(faces), points_(points), work_(work), value_(value) {}

    Status run(double* error) {
        const std::size_t high = work_.arena.high_mark();
        scratch_ = work_.arena.template take_high<std::uint64_t>(ExactSphere::room(static_cast<int>(dim_)));
        if (scratch_ == nullptr) return Status::out_of_memory;
        for (std::uint32_t k = 0; k <= dim_; ++k)
            for (std::uint32_t i = 0; i < faces_.count[k];)
                for (const std::uint64_t piece = work_.arena.piece(i, faces_.count[k], 2); i < piece; ++i) {
                    value_[k][i] = 0;
                }
        Status status = down_to<1>([this](auto k) { return this->find_radii(k); });
        work_.arena.release_high(high);
        bool tied = false;
        if (status == Status::ok) status = order_radii(FaceTable(faces_), points_, work_, value_, &errors_, &tied);
        finish_marked(tied);
        if (status == Status::ok && tied) status = down_to<2>([this](auto k) { return this->hand_down(k); });
        *error = errors_.inner > errors_.outer ? errors_.inner : errors_.outer;
        return status;
    }

private:
    template <int K> Status find_radii(DimensionOf<K> k);
    void finish_marked(bool again);
    template <int K> Status hand_down(DimensionOf<K> k);
    // Calls f(k) for k = D, D - 1, ..., `last`.
    template <int last, int K = D, class F> Status down_to(F&& f) {
        if constexpr (D == any_dimension) {
            Status status = Status::ok;
            for (std::uint32_t k = dim_; k >= last && status == Status::ok; --k) status = f(DimensionOf<D>(k));
            return status;
        } else {
            const Status status = f(DimensionOf<K>());
            if constexpr (K > last) return status == Status::ok ? down_to<last, K - 1>(f) : status;
            return status;
        }
    }
    // place: where each of them is in the vertex list.
    template <int K> void points_of(DimensionOf<K> k, std::uint32_t f, const double** point, std::uint32_t* place) {
        if constexpr (D == any_dimension) {
            faces_.points(points_, static_cast<int>(std::uint32_t{k}), f, point);
            for (std::uint32_t i = 0; i <= k; ++i) place[i] = i;
        } else {
            points_.template of_face<K>(faces_, f, point, place);
        }
    }
    template <int K> bool sphere_of(DimensionOf<K> k, const double* const* point, Circumsphere* out) {
        if constexpr (D == any_dimension || circumsphere_is_shared)
            return circumsphere_fast(k, dim_, point, out);
        else
            return circumsphere_fast<K, D>(point, out);
    }
    double edge2(const double* const* point) const {
        if constexpr (D == any_dimension)
            return distance2(static_cast<int>(dim_), point[0], point[1]);
        else
            return distance2<D>(point[0], point[1]);
    }
    // Any simplex; not in the loop, and not often.
    [[gnu::noinline]] Status evaluate_exactly(const double* const* point, std::uint32_t k, Circumsphere* out) {
        work_.arena.pass(40 * dim_);
        const ExactSphere sphere(point, static_cast<int>(k), static_cast<int>(dim_));
        if (!sphere.in_range()) return Status::out_of_range;
        *out = sphere.evaluate(scratch_);
        if (!(out->radius < infinity)) return Status::check_failed;
        errors_.note(out->radius, exact_radius_error(out->radius));
        return Status::ok;
    }
    bool stop(std::uint32_t f, std::uint32_t k) {
        if (f % faces_between_polls != faces_between_polls - 1) return false;
        done_ += faces_between_polls;
        return work_.monitor.advance(done_, faces_between_polls * k);
    }

    const DimensionOf<D> dim_;
    const Table& faces_;
    const PointRecords points_;
    const Work& work_;
    double* const* value_;
    std::uint64_t* scratch_ = nullptr;
    std::uint64_t done_ = 0;
    RadiusErrors errors_ = {0, 0};
};

// The radii of the k-faces that are not marked, and marks for the faces below that they have in their spheres.
template <int D> template <int K> Status AlphaValues<D>::find_radii(DimensionOf<K> k) {
    const FaceTable table(faces_);
    const std::uint32_t count = faces_.count[k];
    double volume = 1;
    for (std::uint32_t f = 0; f < count; ++f) {
        if (stop(f, k)) return Status::cancelled;
        if (value_[k][f] < 0) continue;
        const double* point[DimensionOf<K>::most + 1];
        std::uint32_t place[DimensionOf<K>::most + 1];
        points_of(k, f, point, place);
        Circumsphere sphere = {0, 0, 1};
        Radius edge;
        bool known;
        if (k > 1) {
            known = sphere_of(k, point, &sphere);
            if (known && sphere.volume < volume) volume = sphere.volume;
        } else {
            known = edge_radius(edge2(point), dim_, &edge);
            if (known) errors_.note(edge.value, edge.error);
            sphere.radius = edge.value;
        }
        if (!known) {
            const Status status = evaluate_exactly(point, k, &sphere);
            if (status != Status::ok) return status;
        }
        value_[k][f] = sphere.radius;
        if (k == 1 || sphere.within == 0) continue;
        std::uint32_t within = 0;
        for (std::uint32_t i = 0; i <= k; ++i) within |= (sphere.within >> i & 1u) << place[i];
        table.each_without(k, f, within, [&](std::uint32_t below, std::uint32_t face) {
            double& mark = value_[below][face];
            if (!(mark < 0) || mark < -sphere.radius) mark = -sphere.radius;
        });
    }
    if (k > 1) errors_.note(1, radius_error(k, dim_, volume));
    return Status::ok;
}

// Marked faces have their values, unless these are to be found again.
template <int D> void AlphaValues<D>::finish_marked(bool again) {
    for (std::uint32_t k = 1; k < dim_; ++k)
        work_.arena.each(faces_.count[k], 4, [this, k, again](std::uint64_t i) {
            double& value = value_[k][i];
            value = !again ? absolute(value) : value < 0 ? -infinity : value;
        });
}

// A marked face holds the negative of the least value met.
template <int D> template <int K> Status AlphaValues<D>::hand_down(DimensionOf<K> k) {
    const std::uint32_t count = faces_.count[k];
    const std::uint32_t* facet = faces_.facets[k];
    for (std::uint32_t f = 0; f < count; ++f, facet += k + 1) {
        const double value = absolute(value_[k][f]);
        value_[k][f] = value;
        for (std::uint32_t i = 0; i <= k; ++i) {
            double& below = value_[k - 1][facet[i]];
            if (below < -value) below = -value;
        }
        if (stop(f, 1)) return Status::cancelled;
    }
    if (k == 2)
        for (std::uint32_t f = 0; f < faces_.count[1];)
            for (const std::uint64_t piece = work_.arena.piece(f, faces_.count[1], 5); f < piece; ++f) {
                value_[1][f] = absolute(value_[1][f]);
            }
    return Status::ok;
}

}  // namespace

template <int D>
Status alpha_values(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes, const Work& work,
                    double* const* value, double* error) {
    const PointRecords points = {coordinates, stride_bytes};
    if constexpr (shared_dimension<D> == D)
        return AlphaValues<D>(D, faces, points, work, value).run(error);
    else
        return AlphaValues<any_dimension>(D, FaceTable(faces), points, work, value).run(error);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_values<D>(const Faces<D>&, const double*, std::ptrdiff_t, const Work&, double* const*,       \
                                    double*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
