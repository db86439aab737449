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

template <int D> class AlphaValues {
public:
    AlphaValues(const Faces<D>& faces, const PointRecords& points, const Work& work, double* const* value)
        : faces_(faces), points_(points), work_(work), value_(value) {}

    Status run(double* error) {
        const std::size_t high = work_.arena.high_mark();
        scratch_ = work_.arena.template take_high<std::uint64_t>(ExactSphere::room(D));
        if (scratch_ == nullptr) return Status::out_of_memory;
        for (std::uint32_t i = 0; i < faces_.count[0];)
            for (const std::uint64_t piece = work_.arena.piece(i, faces_.count[0], 2); i < piece; ++i) {
                value_[0][i] = 0;
            }
        for (int k = 1; k <= D; ++k)
            for (std::uint32_t i = 0; i < faces_.count[k];)
                for (const std::uint64_t piece = work_.arena.piece(i, faces_.count[k], 2); i < piece; ++i) {
                    value_[k][i] = 0;
                }
        Status status = find_radii_from<D>();
        work_.arena.release_high(high);
        if (status == Status::ok) status = order_radii(faces_, points_, work_, value_, &errors_);
        if (status == Status::ok) status = hand_down_from<D>();
        *error = errors_.inner > errors_.outer ? errors_.inner : errors_.outer;
        return status;
    }

private:
    template <int K> Status find_radii();
    template <int K> Status hand_down();
    template <int K> Status find_radii_from() {
        const Status status = find_radii<K>();
        if constexpr (K > 1) return status == Status::ok ? find_radii_from<K - 1>() : status;
        return status;
    }
    template <int K> Status hand_down_from() {
        const Status status = hand_down<K>();
        if constexpr (K > 2) return status == Status::ok ? hand_down_from<K - 1>() : status;
        return status;
    }
    // Any simplex; not in the loop, and not often.
    [[gnu::noinline]] Status evaluate_exactly(const double* const* point, int k, Circumsphere* out) {
        work_.arena.pass(40 * D);
        const ExactSphere sphere(point, k, D);
        if (!sphere.in_range()) return Status::out_of_range;
        *out = sphere.evaluate(scratch_);
        if (!(out->radius < infinity)) return Status::check_failed;
        errors_.note(out->radius, exact_radius_error(out->radius));
        return Status::ok;
    }
    bool stop(std::uint32_t f, int k) {
        if (f % faces_between_polls != faces_between_polls - 1) return false;
        done_ += faces_between_polls;
        return work_.monitor.advance(done_, faces_between_polls * static_cast<std::uint32_t>(k));
    }

    const Faces<D>& faces_;
    const PointRecords points_;
    const Work& work_;
    double* const* value_;
    std::uint64_t* scratch_ = nullptr;
    std::uint64_t done_ = 0;
    RadiusErrors errors_ = {0, 0};
};

// The radii of the K-faces that are not marked, and marks for their facets: the least double.
template <int D> template <int K> Status AlphaValues<D>::find_radii() {
    const std::uint32_t count = faces_.count[K];
    double volume = 1;
    for (std::uint32_t f = 0; f < count; ++f) {
        double& value = value_[K][f];
        const double* point[K + 1];
        if constexpr (K > 1) {
            std::uint32_t facet[K + 1];
            points_.template of_face<K>(faces_, f, point, facet);
            Circumsphere sphere;
            if (circumsphere_fast<K, D>(point, &sphere)) {
                if (sphere.volume < volume) volume = sphere.volume;
            } else {
                const Status status = evaluate_exactly(point, K, &sphere);
                if (status != Status::ok) return status;
            }
            if (!(value < 0)) value = sphere.radius;
            for (int i = 0; i <= K; ++i)
                if ((sphere.within >> i & 1u) != 0) value_[K - 1][facet[i]] = -infinity;
        } else if (!(value < 0)) {
            points_.template of_face<K>(faces_, f, point, nullptr);
            Radius edge;
            if (edge_radius<D>(point, &edge)) {
                errors_.note(edge.value, edge.error);
                value = edge.value;
            } else {
                Circumsphere sphere;
                const Status status = evaluate_exactly(point, K, &sphere);
                if (status != Status::ok) return status;
                value = sphere.radius;
            }
        }
        if (stop(f, K)) return Status::cancelled;
    }
    if constexpr (K > 1) errors_.note(1, radius_error<K, D>(volume));
    return Status::ok;
}

// A marked face holds the negative of the least value met.
template <int D> template <int K> Status AlphaValues<D>::hand_down() {
    const std::uint32_t count = faces_.count[K];
    const std::uint32_t* facet = faces_.facets[K];
    for (std::uint32_t f = 0; f < count; ++f, facet += K + 1) {
        const double value = absolute(value_[K][f]);
        value_[K][f] = value;
        for (int i = 0; i <= K; ++i) {
            double& below = value_[K - 1][facet[i]];
            if (below < -value) below = -value;
        }
        if (stop(f, 1)) return Status::cancelled;
    }
    if constexpr (K == 2)
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
    return AlphaValues<D>(faces, {coordinates, stride_bytes}, work, value).run(error);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_values<D>(const Faces<D>&, const double*, std::ptrdiff_t, const Work&, double* const*,       \
                                    double*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
