#include "tools/opinion/function_cells.hpp"

#include <algorithm>
#include <cmath>

#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr Real share = 1e-9L;  // by which numbers may differ

}  // namespace

FunctionOpinion function_opinion(const MeshFiles& files, const FunctionClaim& claim) {
    const NodeFile& node = files.node;
    const std::uint32_t dim = node.cloud.dim, columns = files.cells.columns;
    const Place centre(node.domain.begin(), node.domain.begin() + dim);
    const Real radius = node.domain[dim];
    const auto is_inside = [&](const Place& x) { return std::sqrt(distance2(x, centre)) <= radius * (1 - share); };
    const auto uncut = [&](const Place& x) -> Real {
        const std::vector<double> at(x.begin(), x.end());
        return std::sqrt(distance2(x, centre)) > radius ? claim.cut : claim.function(at.data());
    };
    FunctionOpinion found;
    std::vector<Place> places;
    const Real cut = claim.cut, floor = cut - claim.lipschitz * radius;
    for (std::size_t v = 0; v < node.cloud.rows(); v++) {
        const double* const x = node.cloud.coordinates.data() + v * dim;
        places.emplace_back(x, x + dim);
        const Real f = std::min(cut, uncut(places.back()));
        for (std::vector<Real>* list : {&found.values, &found.least, &found.most, &found.low, &found.high})
            list->push_back(f);
    }
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        std::vector<Place> points;
        for (std::uint32_t i = 0; i < columns; i++) points.push_back(places[files.cells.entries[c * columns + i]]);
        Sphere ball;
        if (!smallest_circumsphere(points, &ball)) continue;
        const Place corner = ball.centre();
        const Real there = std::min(cut, uncut(corner));
        const bool is_known = !std::isnan(uncut(corner));
        found.places += is_known ? 1 : 0;
        for (std::uint32_t i = 0; i < columns; i++) {
            const std::uint32_t v = files.cells.entries[c * columns + i];
            if (is_known) {
                found.least[v] = std::min(found.least[v], there);
                found.most[v] = std::max(found.most[v], there);
            }
            if (node.markers[v] == 2 || !is_inside(corner) || !is_inside(places[v])) continue;
            const Real f = uncut(places[v]), change = claim.lipschitz * ball.radius;
            found.low[v] = std::min(found.low[v], std::max(floor, f - change));
            found.high[v] = std::max(found.high[v], std::min(cut, f + change));
        }
    }
    return found;
}

std::string error_complaint(const FunctionOpinion& opinion, const FunctionClaim& claim,
                            const std::vector<double>& filter_values, std::size_t* at) {
    for (std::size_t v = 0; v < filter_values.size(); v++) {
        const Real t = filter_values[v], size = std::fabs(t) + std::fabs(claim.cut) + claim.error;
        const Real allowed = claim.error + share * size;
        const Real apart[] = {t - opinion.least[v], opinion.most[v] - t, t - opinion.low[v], opinion.high[v] - t};
        const Real worst = *std::max_element(std::begin(apart), std::end(apart));
        *at = v;
        if (worst > allowed)
            return "the function is or may be " + rounded_text(static_cast<double>(worst), 12) +
                   " from the filter value " + number_text(filter_values[v]) +
                   " on the vertex's cell, more than the error " + number_text(claim.error);
    }
    return {};
}

}  // namespace netmesh::tool
