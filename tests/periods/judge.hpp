// What the engine says of a cloud that repeats, beside the truth.
#pragma once
#include <netmesh.h>

#include <algorithm>
#include <string>

#include "periods/cycles.hpp"
#include "periods/lattices.hpp"
#include "weights/judge.hpp"

namespace periods {

using weights::Block;
using weights::text_of;

struct Answer {
    netmesh_status status;
    Bars bars;
    std::size_t duplicates = 0, periods = 0, copies = 0, distinct = 0;
    double moved = 0;
    std::vector<std::size_t> hidden;  // rows
    std::vector<CycleOfBar> cycles;
};

struct Wish {
    bool squares = false, cycles = false;
    std::uint32_t degree = NETMESH_DIM_MAX;  // the highest; more counts as dim
};

inline std::vector<CycleOfBar> cycles_of(const netmesh_context* context, const Cloud& cloud, const Bars& bars) {
    std::vector<CycleOfBar> cycles;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        cycles.push_back({bars[i], {}});
        std::uint64_t count = 0;
        netmesh_get_cycle(context, i, &count);
        for (std::uint64_t s = 0; s < count; ++s) {
            netmesh_simplex simplex = {};
            simplex.struct_bytes = sizeof simplex;
            if (netmesh_get_cycle_simplex(context, i, s, &simplex) != NETMESH_OK) std::abort();
            CycleSimplex own{{}, simplex.value};
            for (std::uint32_t v = 0; v <= simplex.degree; ++v)
                own.corners.push_back(
                    {simplex.vertices[v], {simplex.translations[v], simplex.translations[v] + cloud.periods()}});
            cycles.back().simplices.push_back(own);
        }
    }
    return cycles;
}

inline Answer ask(const Block& block, const Cloud& cloud, const Wish& wish = Wish()) {
    netmesh_request request = netmesh_default_request();
    request.points.coordinates = cloud.x.data();
    request.points.count = cloud.count();
    request.points.dim = static_cast<std::uint32_t>(cloud.dim);
    request.points.lattice = cloud.lattice.data();
    request.points.lattice_count = static_cast<std::uint32_t>(cloud.periods());
    request.periods = &netmesh_periodic;
    if (!cloud.numbers.empty()) {
        request.points.weights = cloud.numbers.data();
        request.weighting = cloud.are_radii ? &netmesh_radii : &netmesh_weights;
    }
    request.filter = &netmesh_filter_alpha;
    request.max_degree = std::min(wish.degree, request.points.dim);
    request.squares = wish.squares;
    request.cycles = wish.cycles ? &netmesh_cycles : nullptr;
    netmesh_context* const context = block.fresh();
    Answer answer;
    answer.status = netmesh_persist(context, &request);
    if (answer.status != NETMESH_OK) return answer;
    netmesh_pair pair;
    pair.struct_bytes = sizeof pair;
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i)
        answer.bars.push_back({pair.degree, pair.birth, pair.death});
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    answer.duplicates = static_cast<std::size_t>(report.input.duplicates);
    answer.periods = report.input.periods;
    answer.copies = static_cast<std::size_t>(report.input.copies);
    answer.moved = report.input.moved;
    answer.distinct = static_cast<std::size_t>(report.input.distinct);
    std::uint64_t row;
    for (std::uint64_t i = 0; netmesh_get_hidden(context, i, &row) == NETMESH_OK; ++i)
        answer.hidden.push_back(static_cast<std::size_t>(row));
    if (report.input.hidden != answer.hidden.size()) answer.hidden.push_back(SIZE_MAX);
    if (wish.cycles) answer.cycles = cycles_of(context, cloud, answer.bars);
    return answer;
}

// What is asked for, and what has to come.
struct Truth {
    Bars bars;
    std::size_t duplicates = 0, periods = 0;
};
inline Truth truth_of(const Cloud& cloud, const Bars& bars) { return {bars, count_duplicates(cloud), cloud.periods()}; }

inline std::string compare(const std::string& what, const Answer& answer, const Truth& truth) {
    const std::string of = what + ": ";
    if (answer.status != NETMESH_OK) return of + netmesh_status_text(answer.status);
    if (answer.duplicates != truth.duplicates) return of + std::to_string(answer.duplicates) + " duplicates";
    if (answer.periods != truth.periods) return of + "another number of periods";
    if (answer.moved != 0) return of + "numbers were moved, and there is no need to";
    if (answer.bars == truth.bars) return "";
    return of + "other bars\n  came\n" + text_of(answer.bars) + "  truth\n" + text_of(truth.bars);
}

// Rows of hidden points. extents: as values_of_cells finds them; a cell without an inside is a tie, which an index
// breaks.
inline std::string compare_hidden(const Answer& answer, const Cloud& cloud, const std::vector<Extent>& extents) {
    const std::vector<bool> stay = those_that_stay(cloud);
    std::vector<bool> is_hidden(cloud.count(), false);
    std::size_t before = 0;
    for (const std::size_t row : answer.hidden) {
        if (row >= cloud.count() || (row < before)) return "rows of hidden points are in no order, or none";
        is_hidden[row] = true;
        before = row + 1;
    }
    for (std::size_t i = 0; i < cloud.count(); ++i) {
        const std::string which = " point " + std::to_string(i) + " ";
        if (is_hidden[i] && !stay[i]) return which + "is a duplicate, and said to be hidden";
        if (is_hidden[i] && extents[i] == Extent::inside) return which + "is said to be hidden, and has a cell";
        if (!is_hidden[i] && stay[i] && extents[i] == Extent::nothing) return which + "is hidden, and not listed";
    }
    if (answer.distinct + answer.duplicates + answer.hidden.size() == cloud.count()) return "";
    return "points are lost, or counted twice";
}

}  // namespace periods
