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
        if (status == Status::ok) status = order_radii(FaceTable(faces_), points_, work_, value_, &errors_);
        if (status == Status::ok) status = down_to<2>([this](auto k) { return this->hand_down(k); });
        *error = errors_.inner > errors_.outer ? errors_.inner : errors_.outer;
        return status;
    }

private:
    template <int K> Status find_radii(DimensionOf<K> k);
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
    template <int K> void points_of(DimensionOf<K> k, std::uint32_t f, const double** point, std::uint32_t* facet) {
        if constexpr (D == any_dimension) {
            faces_.points(points_, static_cast<int>(std::uint32_t{k}), f, point);
            const std::uint32_t* const all = faces_.facets_of(static_cast<int>(std::uint32_t{k}), f);
            for (std::uint32_t i = 0; i <= k; ++i) facet[i] = all[i];
        } else {
            points_.template of_face<K>(faces_, f, point, facet);
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

// The radii of the k-faces that are not marked, and marks for their facets: the least double.
template <int D> template <int K> Status AlphaValues<D>::find_radii(DimensionOf<K> k) {
    const std::uint32_t count = faces_.count[k];
    double volume = 1;
    for (std::uint32_t f = 0; f < count; ++f) {
        double& value = value_[k][f];
        const double* point[DimensionOf<K>::most + 1];
        std::uint32_t facet[DimensionOf<K>::most + 1];
        if (k > 1) {
            points_of(k, f, point, facet);
            Circumsphere sphere;
            if (sphere_of(k, point, &sphere)) {
                if (sphere.volume < volume) volume = sphere.volume;
            } else {
                const Status status = evaluate_exactly(point, k, &sphere);
                if (status != Status::ok) return status;
            }
            if (!(value < 0)) value = sphere.radius;
            for (std::uint32_t i = 0; i <= k; ++i)
                if ((sphere.within >> i & 1u) != 0) value_[k - 1][facet[i]] = -infinity;
        } else if (!(value < 0)) {
            points_of(k, f, point, facet);
            Radius edge;
            if (edge_radius(edge2(point), dim_, &edge)) {
                errors_.note(edge.value, edge.error);
                value = edge.value;
            } else {
                Circumsphere sphere;
                const Status status = evaluate_exactly(point, k, &sphere);
                if (status != Status::ok) return status;
                value = sphere.radius;
            }
        }
        if (stop(f, k)) return Status::cancelled;
    }
    if (k > 1) errors_.note(1, radius_error(k, dim_, volume));
    return Status::ok;
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
