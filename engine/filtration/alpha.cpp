// Values go down from the cells: a face meets all of its cofacets before its own turn comes. Until then its entry holds
// the least value of the cofacets met, with the sign bit set once one of them has its apex in the face's sphere.
#include "filtration/alpha.hpp"

#include "filtration/circumsphere_fast.hpp"
#include "filtration/half_distance.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

bool is_marked(double x) { return __builtin_signbit(x) != 0; }
double unmarked(double x) { return is_marked(x) ? -x : x; }

template <int D> struct Points {
    const double* coordinates;
    std::ptrdiff_t stride_bytes;
    const double* operator[](std::uint32_t v) const {
        return reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(coordinates) +
                                               static_cast<std::ptrdiff_t>(v) * stride_bytes);
    }
};

template <int K, int D> Circumsphere circumsphere(const double* const* point) {
    Circumsphere sphere;
    if constexpr (K > 1) {
        if (circumsphere_fast<K, D>(point, &sphere)) return sphere;
        return circumsphere_precise(point, K, D);
    } else {
        return {half_distance<D>(point[1], point[0]), 0};
    }
}

// Gives the K-faces their values and hands them down to their facets.
template <int K, int D>
bool give_values(const Faces<D>& faces, const Points<D>& points, std::uint64_t done, Monitor& monitor,
                 double* const* value) {
    constexpr std::uint32_t chunk = 1024;
    const std::uint32_t count = faces.count[K];
    const std::uint32_t* facet = faces.facets[K];
    for (std::uint32_t f = 0; f < count; ++f, facet += K + 1) {
        std::uint32_t vertex[K + 1];
        const double* point[K + 1];
        faces.vertices(K, f, vertex);
        for (int i = 0; i <= K; ++i) point[i] = points[vertex[i]];
        const Circumsphere sphere = circumsphere<K, D>(point);
        double v = unmarked(value[K][f]);
        if (!is_marked(value[K][f]) && sphere.radius < v) v = sphere.radius;
        value[K][f] = v;
        if constexpr (K > 1) {
            for (int i = 0; i <= K; ++i) {
                double& below = value[K - 1][facet[i]];
                const bool mark = is_marked(below) || (sphere.within >> i & 1u) != 0;
                const double least = unmarked(below) < v ? unmarked(below) : v;
                below = mark ? -least : least;
            }
        }
        if (f % chunk == chunk - 1 && monitor.advance(done + f, chunk * K)) return false;
    }
    return true;
}

template <int K, int D>
bool give_values_from(const Faces<D>& faces, const Points<D>& points, std::uint64_t done, Monitor& monitor,
                      double* const* value) {
    if (!give_values<K, D>(faces, points, done, monitor, value)) return false;
    if constexpr (K > 1) return give_values_from<K - 1, D>(faces, points, done + faces.count[K], monitor, value);
    return true;
}

}  // namespace

template <int D>
Status alpha_values(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes, Monitor& monitor,
                    double* const* value) {
    const Points<D> points = {coordinates, stride_bytes};
    for (std::uint32_t i = 0; i < faces.count[0]; ++i) value[0][i] = 0;
    for (int k = 1; k <= D; ++k)
        for (std::uint32_t i = 0; i < faces.count[k]; ++i) value[k][i] = infinity;
    return give_values_from<D, D>(faces, points, 0, monitor, value) ? Status::ok : Status::cancelled;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_values<D>(const Faces<D>&, const double*, std::ptrdiff_t, Monitor&, double* const*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
