#include "geometry/circumsphere_settle.hpp"

#include "geometry/circumsphere_close.hpp"
#include "geometry/circumsphere_exact.hpp"

namespace netmesh {

Status settle_circumsphere(const double* const* point, std::uint32_t k, int dim, bool within, bool radius,
                           Arena& arena, Circumsphere* out) {
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
    const ExactSphere sphere(point, static_cast<int>(k), dim);
    if (!sphere.in_range()) return Status::out_of_range;
    const HighScope scope(arena);
    std::uint64_t* const scratch = arena.take_high<std::uint64_t>(sphere.words());
    if (scratch == nullptr) return Status::out_of_memory;
    if (within && !sphere.find_within(scratch, &out->within)) return Status::check_failed;
    return !radius || sphere.find_radius(scratch, &out->radius) ? Status::ok : Status::out_of_range;
}

}  // namespace netmesh
