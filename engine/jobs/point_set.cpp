#include "jobs/point_set.hpp"

#include "filtration/filters.hpp"
#include "filtration/point_complexes.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/sort.hpp"

namespace netmesh {
namespace {

// The fourth root of 2, rounded up; and above that by more than the roundings of a radius and of its product add.
constexpr double values_factor = 0x1.306fe0a31b716p0, certified_ratio = 0x1.306fe0a31b718p0;
constexpr double root_of_two = 0x1.6a09e667f3bcdp0;  // rounded up

bool is_approximate(const PointsFilter& filter) { return has_edges(filter.filter) && is_barycentric(filter.filter); }

}  // namespace

Status take_points(const GivenPoints& given, Arena& arena, PointSet* out, std::uint64_t* culprit) {
    const std::uint32_t n = given.count, dim = given.dim;
    const InputRows& points = given.points;
    double* const x = arena.take_low<double>(std::size_t{n} * dim);
    const ArenaScope scope(arena);
    std::uint32_t* const order = arena.take_high<std::uint32_t>(n);
    unsigned char* const repeated = arena.take_high<unsigned char>(n);
    if (x == nullptr || order == nullptr || repeated == nullptr) return Status::out_of_memory;
    Fingerprint f;
    f.add(static_cast<std::uint64_t>(dim));
    for (std::uint32_t i = 0; i < n;)
        for (const std::uint64_t piece = arena.piece(i, n, 20 * dim); i < piece; ++i) {
            double* const row = x + std::size_t{i} * dim;
            *culprit = i;
            arena.pass(dim / 64);
            if (!points.read(i, static_cast<int>(dim), row)) return Status::not_finite;
            for (std::uint32_t d = 0; d < dim; ++d) f.add(row[d]);
            order[i] = i;
            repeated[i] = 0;
        }
    const auto compare = [x, dim](std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t d = 0; d < dim; ++d) {
            const double xa = x[std::size_t{a} * dim + d], xb = x[std::size_t{b} * dim + d];
            if (xa != xb) return xa < xb ? -1 : 1;
        }
        return 0;
    };
    sort(
        order, n,
        [compare](std::uint32_t a, std::uint32_t b) {
            const int c = compare(a, b);
            return c != 0 ? c < 0 : a < b;
        },
        arena);
    for (std::uint32_t i = 1; i < n;)
        for (const std::uint64_t piece = arena.piece(i, n, 30); i < piece; ++i) {
            repeated[order[i]] = compare(order[i - 1], order[i]) == 0;
        }
    out->count = 0;
    for (std::uint32_t i = 0; i < n;)
        for (const std::uint64_t piece = arena.piece(i, n, 20 * dim); i < piece; ++i) {
            if (repeated[i] != 0) continue;
            for (std::uint32_t d = 0; d < dim; ++d) x[std::size_t{out->count} * dim + d] = x[std::size_t{i} * dim + d];
            ++out->count;
        }
    out->coordinates = x;
    out->dim = dim;
    out->fingerprint = f.value();
    return Status::ok;
}

bool is_barycentric(netmesh_filter_id filter) { return find_filter(filter)->has(filter_trait::needs_k); }
bool has_edges(netmesh_filter_id filter) { return find_filter(filter)->has(filter_trait::made_of_edges); }

double factor_of(const PointsFilter& filter) {
    return is_approximate(filter) && filter.values == FilterValues::certified ? values_factor : 1;
}
double ratio_of(const PointsFilter& filter) {
    if (!is_approximate(filter)) return 1;
    return filter.values == FilterValues::certified ? certified_ratio : root_of_two;
}

Status list_sets(const PointSet& set, netmesh_filter_id filter, std::uint32_t dimension, const Work& work,
                 ListedComplex* out) {
    const int dim = static_cast<int>(set.dim);
    const double* const x = set.coordinates;
    if (!has_edges(filter)) return cech_complex(dim, x, set.count, dimension, work, out);
    return full_rips_complex(dim, x, set.count, dimension, work, out);
}

}  // namespace netmesh
