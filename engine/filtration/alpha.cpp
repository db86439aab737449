// Values go down from the cells. Of each simplex that is not marked the radius is found, and all faces in its interval
// are marked: those that lack none but vertices that lie in or on the sphere of the facet opposite. A marked face has
// no radius of its own, and the value of what marked it, as its negative. What has it in its interval besides has the
// same radius, and so the same double.
//
// Intervals. Let S be a simplex whose smallest circumsphere, with centre c, has no point inside; beta the barycentric
// coordinates of c; F a face that lacks vertices of beta <= 0 alone. Then c is the sum of the beta_v v and so the
// nearest of the centres of empty spheres through F: the value of F is that of S. If some of these beta are negative,
// one of the vertices is inside the sphere of F: with m the centre of that, |c - m|^2 is the sum over them of
// beta_v (v - m) . (c - m), and v is inside exactly where (v - m) . (c - m) < 0. If all are 0 it is the sphere of S.
// So F is marked rightly. And every face F with a point in or on its sphere is marked: among the points on the least
// empty sphere through F, those with weights infinitely small, there is an S with F in its interval (Bauer,
// Edelsbrunner: The Morse theory of Cech and Delaunay complexes, 2017), and if S is marked, by T, without being of
// another sphere than T, then F is in the interval of T. What is marked needs no sphere: about a half of the simplices
// between cells and edges.
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
//
// With weights read power for squared distance, and for the sphere of a face with centre m and power a at it: a point v
// is inside where its power at m is less than a. Then |v - m|^2 - w_v - a is 2 (v - m) . (c - m), and all of the above
// holds, of vertices as well, which are marked too. As values may be negative, what is not marked is no number instead.
#include "filtration/alpha.hpp"

#include "filtration/point_records.hpp"
#include "geometry/circumsphere_exact.hpp"
#include "geometry/circumsphere_fast.hpp"
#include "geometry/circumsphere_settle.hpp"
#include "geometry/half_distance.hpp"
#include "geometry/power_sphere_exact.hpp"
#include "numerics/bits.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr std::uint32_t faces_between_polls = 16;

// What values are made of: PowerValues with weights.
struct RadiusValues : NoWeights {};

// What is the same for all dimensions.
template <class W> class MarkedValues {
protected:
    MarkedValues(const FaceTable& table, const PointRecords& points, const W& weights, const Work& work,
                 double* const* value)
        : table_(table), points_(points), weights_(weights), work_(work), value_(value) {}

    static double unmarked() { return W::has ? __builtin_nan("") : 0; }
    static bool is_marked(double value) { return W::has ? value == value : value < 0; }

    // Marks the faces of a k-face that lack some of the vertices `within` and no other.
    [[gnu::noinline]] void mark_interval(std::uint32_t k, std::uint32_t f, std::uint32_t within, double radius);
    // What is not certain of a simplex. Not often, but on lattices.
    [[gnu::noinline]] Status evaluate_exactly(const double* const* point, std::uint32_t k, bool within, bool radius,
                                              Circumsphere* out);
    // Marked faces get their values.
    void finish();
    bool stop(std::uint32_t f, std::uint32_t k) {
        if (f % faces_between_polls != faces_between_polls - 1) return false;
        done_ += faces_between_polls;
        return work_.monitor.advance(done_, faces_between_polls * k);
    }

    const FaceTable table_;
    const PointRecords points_;
    const W weights_;
    const Work& work_;
    double* const* value_;
    std::uint64_t* scratch_ = nullptr;
    std::uint64_t done_ = 0;
};

template <class W>
void MarkedValues<W>::mark_interval(std::uint32_t k, std::uint32_t f, std::uint32_t within, double radius) {
    table_.template each_without<W::has ? 0 : 1>(k, f, within, [this, radius](std::uint32_t below, std::uint32_t face) {
        value_[below][face] = W::has ? radius : -radius;
    });
}

template <class W> void MarkedValues<W>::finish() {
    for (int k = 1; k < table_.dim; ++k)
        work_.arena.each(table_.count[k], 2,
                         [value = value_[k]](std::uint64_t i) { value[i] = __builtin_fabs(value[i]); });
}

template <class W>
Status MarkedValues<W>::evaluate_exactly(const double* const* point, std::uint32_t k, bool within, bool radius,
                                         Circumsphere* out) {
    if constexpr (W::has) {
        work_.arena.pass(40 * static_cast<std::uint32_t>(table_.dim));
        const ExactPowerSphere sphere(point, static_cast<int>(k), table_.dim, weights_.are_radii);
        if (!sphere.in_range()) return Status::out_of_range;
        if (within && !sphere.find_within(scratch_, &out->within)) return Status::check_failed;
        const bool found = !radius || sphere.find_power(scratch_, weights_.squares, &out->radius);
        return found ? Status::ok : Status::out_of_range;
    }
    return settle_circumsphere(point, k, table_.dim, within, radius, work_.arena, out);
}

// D may be any_dimension, and so may the K of faces then.
template <int D, class W> class AlphaValues : MarkedValues<W> {
    using Base = MarkedValues<W>;
    using Base::table_, Base::points_, Base::weights_, Base::work_, Base::value_, Base::scratch_;

public:
    using Table = std::conditional_t<D == any_dimension, FaceTable, Faces<D>>;

    AlphaValues(DimensionOf<D> dim, const Table& faces, const PointRecords& points, const W& weights, const Work& work,
                double* const* value)
        : Base(FaceTable(faces), points, weights, work, value), dim_(dim), faces_(faces) {}

    Status run() {
        const std::size_t high = work_.arena.high_mark();
        if constexpr (W::has) {
            scratch_ = work_.arena.template take_high<std::uint64_t>(ExactSphere::room(static_cast<int>(dim_)));
            if (scratch_ == nullptr) return Status::out_of_memory;
        }
        for (std::uint32_t k = 0; k <= dim_; ++k)
            for (std::uint32_t i = 0; i < faces_.count[k];)
                for (const std::uint64_t piece = work_.arena.piece(i, faces_.count[k], 2); i < piece; ++i) {
                    value_[k][i] = Base::unmarked();
                }
        const Status status = find_down();
        work_.arena.release_high(high);
        if (status != Status::ok) return status;
        if constexpr (W::has) return find_vertices();
        Base::finish();
        return Status::ok;
    }

private:
    // Simplices whose spheres are found at the same time.
    using Lanes = std::conditional_t<D == any_dimension || circumsphere_is_shared, double, DoublePair>;
    static constexpr std::uint32_t batch_size = lane_count<Lanes>;
    template <int K> struct Batch {
        std::uint32_t count = 0;
        std::uint32_t face[batch_size];
        const double* point[batch_size][DimensionOf<K>::most + 1];
        std::uint32_t place[batch_size][DimensionOf<K>::most + 1];  // as points_of says
    };

    // find_radii for k = D, D - 1, ..., 1.
    template <int K = D> Status find_down() {
        if constexpr (D == any_dimension) {
            Status status = Status::ok;
            for (std::uint32_t k = dim_; k >= 1 && status == Status::ok; --k) status = find_radii(DimensionOf<D>(k));
            return status;
        } else {
            const Status status = find_radii(DimensionOf<K>());
            if constexpr (K > 1) return status == Status::ok ? find_down<K - 1>() : status;
            return status;
        }
    }
    // Of vertices that are not marked. No value is below that of a vertex: out_of_range, where that is no double.
    Status find_vertices() {
        bool in_range = true;
        if constexpr (W::has)
            work_.arena.each(table_.count[0], 6, [this, &in_range](std::uint64_t f) {
                double& value = value_[0][f];
                if (!Base::is_marked(value)) value = own_value(static_cast<std::uint32_t>(f));
                in_range = in_range && value != -infinity;
            });
        return in_range ? Status::ok : Status::out_of_range;
    }
    double own_value(std::uint32_t vertex) const {
        const double* point;
        table_.points(points_, 0, vertex, &point);
        const double number = point[table_.dim], root = square_root(__builtin_fabs(number));
        const double size = weights_.are_radii ? weights_.squares ? number * number : number
                            : weights_.squares ? number
                            : number < 0       ? -root
                                               : root;
        return 0.0 - size;
    }
    template <int K> Status find_radii(DimensionOf<K> k);
    // Asks for what points_of reads of faces that come soon.
    template <int K> __attribute__((always_inline)) void fetch(std::uint32_t f) const {
        constexpr std::uint32_t far = 12, near = 6;
        if (f + far >= faces_.count[K]) return;
        const std::uint32_t *const all = faces_.facets_of(K, f + far), *const soon = faces_.facets_of(K, f + near);
        prefetch(faces_.facets_of(K - 1, all[0]));
        prefetch(faces_.facets_of(K - 1, all[K]));
        prefetch(faces_.facets_of(K - 2, faces_.facets_of(K - 1, soon[0])[0]));
        prefetch(faces_.facets_of(K - 2, faces_.facets_of(K - 1, soon[K])[K - 1]));
    }
    template <int K> Status find_batch(DimensionOf<K> k, Batch<K>& batch);
    // place: where each of them is in the vertex list, which ascends if D is any_dimension.
    template <int K> void points_of(DimensionOf<K> k, std::uint32_t f, const double** point, std::uint32_t* place) {
        if constexpr (D == any_dimension) {
            faces_.points(points_, static_cast<int>(std::uint32_t{k}), f, point);
            static_cast<void>(place);
        } else {
            points_.template of_face<K>(faces_, f, point, place);
        }
    }
    template <int K> Certainty spheres_of(DimensionOf<K> k, Batch<K>& batch, Circumsphere* out) {
        const double* const* point[batch_size];
        for (std::uint32_t i = 0; i < batch_size; ++i) point[i] = batch.point[i < batch.count ? i : 0];
        if constexpr (W::has)
            return circumspheres_fast<Lanes, K, D, W>(k, dim_, point, out, weights_, weights_.squares);
        if (k != 1) return circumspheres_fast<Lanes, K, D>(k, dim_, point, out);
        const auto difference = [&](std::uint32_t d) {
            Lanes from = {}, to = {};
            for (int i = 0; i < lane_count<Lanes>; ++i) {
                set_lane(from, i, point[i][0][d]);
                set_lane(to, i, point[i][1][d]);
            }
            return exact_difference(to, from);
        };
        double half[batch_size];
        Certainty certain = {~0u, half_distances_fast<Lanes>(dim_, difference, half)};
        for (std::uint32_t i = 0; i < batch.count; ++i) {
            if ((certain.radius >> i & 1u) == 0)
                half[i] = exact_half_distance(static_cast<int>(std::uint32_t{dim_}), point[i][0], point[i][1]);
            out[i] = {half[i], 0};
        }
        certain.radius = ~0u;
        return certain;
    }

    const DimensionOf<D> dim_;
    const Table& faces_;
};

// The radii of the k-faces that are not marked, and marks for the faces below that they have in their spheres.
template <int D, class W> template <int K> Status AlphaValues<D, W>::find_radii(DimensionOf<K> k) {
    const std::uint32_t count = faces_.count[k];
    Batch<K> batch;
    for (std::uint32_t f = 0; f < count; ++f) {
        if constexpr (K > 3) fetch<K>(f);
        if (!Base::is_marked(value_[k][f])) {
            batch.face[batch.count] = f;
            points_of(k, f, batch.point[batch.count], batch.place[batch.count]);
            ++batch.count;
        }
        if (batch.count == batch_size || (f + 1 == count && batch.count > 0)) {
            const Status status = find_batch(k, batch);
            if (status != Status::ok) return status;
            batch.count = 0;
        }
        if (Base::stop(f, k)) return Status::cancelled;
    }
    return Status::ok;
}

template <int D, class W>
template <int K>
inline Status AlphaValues<D, W>::find_batch(DimensionOf<K> k, Batch<K>& batch) {
    Circumsphere sphere[batch_size];
    const Certainty certain = spheres_of(k, batch, sphere);
    for (std::uint32_t i = 0; i < batch.count; ++i) {
        const std::uint32_t f = batch.face[i];
        if ((certain.within & certain.radius & 1u << i) == 0) {
            const Status status = Base::evaluate_exactly(batch.point[i], k, (certain.within >> i & 1u) == 0,
                                                         (certain.radius >> i & 1u) == 0, &sphere[i]);
            if (status != Status::ok) return status;
        }
        const double radius = sphere[i].radius;
        value_[k][f] = radius;
        if ((!W::has && k == 1) || sphere[i].within == 0) continue;
        std::uint32_t within = sphere[i].within;
        if (D != any_dimension) {
            within = 0;
            for (std::uint32_t j = 0; j <= k; ++j) within |= (sphere[i].within >> j & 1u) << batch.place[i][j];
        }
        Base::mark_interval(k, f, within, radius);
    }
    return Status::ok;
}

}  // namespace

template <int D, class W>
static Status values_by(const Faces<D>& faces, const PointRecords& points, const W& weights, const Work& work,
                        double* const* value) {
    if constexpr (shared_dimension<D> == D && !circumsphere_is_shared)
        return AlphaValues<D, W>(D, faces, points, weights, work, value).run();
    else
        return AlphaValues<any_dimension, W>(D, FaceTable(faces), points, weights, work, value).run();
}

template <int D>
Status alpha_values(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes, const Work& work,
                    double* const* value) {
    return values_by<D>(faces, {coordinates, stride_bytes}, RadiusValues{}, work, value);
}

template <int D>
Status alpha_values_weighted(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes,
                             const PowerValues& powers, const Work& work, double* const* value) {
    return values_by<D>(faces, {coordinates, stride_bytes}, powers, work, value);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_values<D>(const Faces<D>&, const double*, std::ptrdiff_t, const Work&, double* const*);      \
    template Status alpha_values_weighted<D>(const Faces<D>&, const double*, std::ptrdiff_t, const PowerValues&,       \
                                             const Work&, double* const*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
