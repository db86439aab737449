#include "mesh/check/check_weighted_cells.hpp"

namespace netmesh {
namespace {

constexpr double rounding = 1 + 0x1p-40;

void lower(double* least, double length) {
    if (length < *least) *least = length;
}

class WeightedCellCheck {
public:
    WeightedCellCheck(const HierarchyView& mesh, CageFigures* figures) : mesh_(mesh), figures_(figures) {}

    CheckResult run() {
        for (std::uint32_t d = 0; d < mesh_.cage_count;)
            for (const std::uint64_t piece = mesh_.arena.piece(d, mesh_.cage_count, 20); d < piece; ++d) {
                figures_[d] = {0, infinity, infinity, infinity};
            }
        for (std::uint32_t v = 0; v < mesh_.vertex_count;)
            for (const std::uint64_t piece = mesh_.arena.piece(v, mesh_.vertex_count, 40); v < piece; ++v) {
                const std::uint32_t d = mesh_.domains[v];
                if (d == none || !mesh_.is_exempt(v)) continue;
                const double length = mesh_.distance(centre(d), mesh_.point(v));
                lower(&figures_[d].nearest, length);
                if (length > figures_[d].farthest) figures_[d].farthest = length;
            }
        for (std::uint32_t c = 0; c < mesh_.cell_count;)
            for (const std::uint64_t piece = mesh_.arena.piece(c, mesh_.cell_count, 400); c < piece; ++c) {
                for (std::uint32_t i = 0; i <= mesh_.dim; ++i)
                    for (std::uint32_t j = 0; j < i; ++j)
                        if (!may_be_neighbours(mesh_.cell(c)[i], mesh_.cell(c)[j]))
                            return {"two cages, or a cage and a vertex, are too near for the weights of 4.6.1",
                                    mesh_.cell(c)[i]};
            }
        for (std::uint32_t d = 0; d < mesh_.cage_count;)
            for (const std::uint64_t piece = mesh_.arena.piece(d, mesh_.cage_count, 20); d < piece; ++d) {
                const CageFigures& f = figures_[d];
                const double in_radius = 0.5 * (f.outside + f.nearest);
                if (!(f.outside < infinity)) continue;
                if (!(in_radius <= f.member * rounding && f.member <= 3 * in_radius * rounding))
                    return {"a cage's in-radius and feature size are not those of 4.6.2", mesh_.cages[d].centre};
            }
        return {nullptr, none};
    }

private:
    const double* centre(std::uint32_t d) const { return mesh_.point(mesh_.cages[d].centre); }

    bool may_be_neighbours(std::uint32_t v, std::uint32_t w) {
        std::uint32_t a = mesh_.domains[v], b = mesh_.domains[w], cage_a = none, cage_b = none;
        while (a != b) {
            const bool smaller = b == none || (a != none && mesh_.cages[a].radius < mesh_.cages[b].radius);
            std::uint32_t& inner = smaller ? a : b;
            (smaller ? cage_a : cage_b) = inner;
            inner = mesh_.cages[inner].parent;
        }
        if (cage_a == none && cage_b == none) return true;
        const double* const x = cage_a == none ? mesh_.point(v) : centre(cage_a);
        const double* const y = cage_b == none ? mesh_.point(w) : centre(cage_b);
        const double length = mesh_.distance(x, y);
        if (cage_a != none) {
            lower(&figures_[cage_a].member, length);
            lower(&figures_[cage_a].outside, mesh_.distance(x, mesh_.point(w)));
        }
        if (cage_b != none) {
            lower(&figures_[cage_b].member, length);
            lower(&figures_[cage_b].outside, mesh_.distance(y, mesh_.point(v)));
        }
        const double weight_a = cage_a == none ? 0 : figures_[cage_a].farthest;
        const double weight_b = cage_b == none ? 0 : figures_[cage_b].farthest;
        return 3 * weight_a <= (length - weight_b) * rounding && 3 * weight_b <= (length - weight_a) * rounding;
    }

    const HierarchyView& mesh_;
    CageFigures* const figures_;
};

}  // namespace

[[gnu::cold]] CheckResult check_weighted_cells(const HierarchyView& mesh, CageFigures* figures) {
    return WeightedCellCheck(mesh, figures).run();
}

}  // namespace netmesh
