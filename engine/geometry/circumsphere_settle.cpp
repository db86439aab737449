#include "geometry/circumsphere_settle.hpp"

#include "geometry/circumsphere_close.hpp"
#include "geometry/circumsphere_exact.hpp"
#include "numerics/product_sum.hpp"

namespace netmesh {
namespace {

// Of a triangle, a flat one as well: a vertex is inside or on the smallest sphere of the edge opposite it where its
// angle is not acute, so where the product of the two edges there is not positive. On lattices most triangles have a
// right angle.
[[gnu::noinline]] std::uint32_t angles_not_acute(const double* const* point, int dim) {
    std::uint32_t within = 0;
    for (int i = 0; i < 3; ++i) {
        const double *const v = point[i], *const a = point[(i + 1) % 3], *const b = point[(i + 2) % 3];
        ProductSum product;
        for (int c = 0; c < dim; ++c) {
            product.add(a[c], b[c]);
            product.subtract(a[c], v[c]);
            product.subtract(v[c], b[c]);
            product.add(v[c], v[c]);
        }
        if (product.sign() <= 0) within |= 1u << i;
    }
    return within;
}

}  // namespace

Status settle_circumsphere(const double* const* point, std::uint32_t k, int dim, bool within, bool radius, Arena& arena,
                           Circumsphere* out) {
    arena.pass(40 * static_cast<std::uint32_t>(dim));
    if constexpr (has_close_look) {
        Circumsphere close;
        const Certainty certain = look_closely(k, static_cast<std::uint32_t>(dim), point, &close);
        if (certain.within != 0) out->within = close.within;
        if (certain.radius != 0) out->radius = close.radius;
        within = within && certain.within == 0;
        radius = radius && certain.radius == 0;
        if (!within && !radius) return Status::ok;
    }
    if (k == 2 && !radius) {
        out->within = angles_not_acute(point, dim);
        return Status::ok;
    }
    const ExactSphere sphere(point, static_cast<int>(k), dim);
    if (!sphere.in_range()) return Status::out_of_range;
    const HighScope scope(arena);
    std::uint64_t* const scratch = arena.take_high<std::uint64_t>(sphere.words());
    if (scratch == nullptr) return Status::out_of_memory;
    if (within && !sphere.find_within(scratch, &out->within)) return Status::check_failed;
    return !radius || sphere.find_radius(scratch, &out->radius) ? Status::ok : Status::out_of_range;
}

}  // namespace netmesh
