// Alpha diagrams of 1 to 8 points that repeat in boxes and in skew cells of the plane and of space, and of few in four
// dimensions, with weights or without, against a cover:
// GUDHI makes the exact alpha complex of all copies near enough, and here its simplices at the points of the middle are
// taken modulo translations and reduced. NETMESH_COVER_CELLS=500: 500 cells; without it a few.
//
// A power cell is within that of its point among this point's own copies, so within the covering radius of the lattice.
// So all neighbours of a point are within twice that, which is the root of the sum of squares of h, the lengths of the
// orthogonalised vectors.
//
// Where points are on one empty sphere the peer breaks ties as it likes. Then a simplex is not there from each of its
// vertices, or not with one value; such cells are left to tests/periods and counted here.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

#include "common/inputs.hpp"
#include "common/read.hpp"
#include "netmesh.hpp"
#include "oracle/bars.hpp"
#include "oracle/peers/gudhi_tree.hpp"

namespace {

using oracle::Bar;
using oracle::Bars;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Cell {
    int dim;
    inputs::Points vectors, points, weights;  // no weights: empty
    std::size_t width() const { return static_cast<std::size_t>(dim); }
    std::size_t count() const { return points.size() / width(); }
};

// Multiples of 2^-30, so that copies are doubles. Vectors below one another, as molecular dynamics has them.
Cell make_cell(inputs::Random& random, int dim, bool is_box) {
    const auto on_grid = [](double x) { return std::floor(x * 0x1p30) * 0x1p-30; };
    Cell cell = {dim, {}, {}, {}};
    const std::size_t d = cell.width();
    cell.vectors.assign(d * d, 0.0);
    for (std::size_t j = 0; j < d; ++j) {
        cell.vectors[j * d + j] = on_grid(0.6 + random.uniform());
        for (std::size_t k = 0; k < j && !is_box; ++k)
            cell.vectors[j * d + k] = on_grid((random.uniform() - 0.5) * cell.vectors[k * d + k]);
    }
    const std::size_t n = 1 + random.below(dim < 4 ? 8 : 2);
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> x(d, 0.0);
        for (std::size_t j = 0; j < d; ++j) {
            const double part = random.uniform();
            for (std::size_t k = 0; k < d; ++k) x[k] += part * cell.vectors[j * d + k];
        }
        for (const double c : x) cell.points.push_back(on_grid(c));
    }
    if (random.below(3) == 0) {
        const double size = std::pow(10.0, 2 * random.uniform() - 2), low = random.below(2) == 0 ? 0 : -1;
        for (std::size_t i = 0; i < n; ++i) cell.weights.push_back(size * (low + (1 - low) * random.uniform()));
    }
    return cell;
}

Bars bars_of_engine(const Cell& cell, std::uint64_t* hidden) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(static_cast<std::uint32_t>(cell.dim), cell.points).set_lattice(cell.vectors);
    if (!cell.weights.empty()) {
        request.set_weights(&netmesh_weights, cell.weights);
        request.squares = 1;
    }
    std::vector<long double> memory((std::size_t(1) << 26) / sizeof(long double));
    netmesh::Engine engine(memory.data(), memory.size() * sizeof(long double));
    REQUIRE(engine.persist(request) == NETMESH_OK);
    auto report = netmesh::sized<netmesh_report>();
    netmesh_get_report(engine.context(), &report);
    CHECK(report.input.moved == 0);
    *hidden += report.input.hidden;
    Bars bars;
    const auto power = [&](double r) { return cell.weights.empty() ? r * r : r; };
    for (const netmesh_pair& pair : engine.pairs())
        bars.push_back({static_cast<int>(pair.degree), power(pair.birth), power(pair.death)});
    return bars;
}

// A point and the multiples of the vectors.
using Copy = std::array<int, 5>;
// Ascending; the first has multiples 0.
using Simplex = std::vector<Copy>;

void settle(Simplex* simplex) {
    std::sort(simplex->begin(), simplex->end());
    const Copy first = simplex->front();
    for (Copy& copy : *simplex)
        for (std::size_t j = 1; j < copy.size(); ++j) copy[j] -= first[j];
}

struct Cover {
    std::vector<Copy> copies;
    inputs::Points points, weights;
};

Cover make_cover(const Cell& cell) {
    const std::size_t d = cell.width();
    double reach2 = 0;
    for (std::size_t j = 0; j < d; ++j) reach2 += cell.vectors[j * d + j] * cell.vectors[j * d + j];
    reach2 *= 1 + 1e-9;
    Cover cover;
    const int most = d < 4 ? 7 : 5;
    for (std::size_t i = 0; i < cell.count(); ++i) {
        Copy copy = {static_cast<int>(i)};
        for (std::size_t j = 1; j <= d; ++j) copy[j] = -most;
        for (;;) {
            std::vector<double> x(&cell.points[i * d], &cell.points[i * d] + d);
            for (std::size_t j = 0; j < d; ++j)
                for (std::size_t k = 0; k < d; ++k) x[k] += copy[j + 1] * cell.vectors[j * d + k];
            bool is_near = false;
            for (std::size_t p = 0; p < cell.count() && !is_near; ++p) {
                double away2 = 0;
                for (std::size_t k = 0; k < d; ++k)
                    away2 += (x[k] - cell.points[p * d + k]) * (x[k] - cell.points[p * d + k]);
                is_near = away2 <= reach2;
            }
            if (is_near) {
                cover.copies.push_back(copy);
                cover.points.insert(cover.points.end(), x.begin(), x.end());
                if (!cell.weights.empty()) cover.weights.push_back(cell.weights[i]);
            }
            std::size_t j = 1;
            while (j <= d && copy[j] == most) copy[j++] = -most;
            if (j > d) break;
            ++copy[j];
        }
    }
    return cover;
}

struct Entry {
    double value;
    std::size_t times;
};
using Entries = std::map<Simplex, Entry>;

// Simplices at points of the middle, modulo translations. False: not all are there from each of their vertices.
bool take_simplices(const Cell& cell, double slack, Entries* entries) {
    const Cover cover = make_cover(cell);
    Gudhi::Simplex_tree<> tree;
    make_gudhi_tree(cell.dim, cover.points, cover.weights, &tree);
    bool is_whole = true;
    for (auto handle : tree.complex_simplex_range()) {
        Simplex simplex;
        bool is_in_middle = false;
        for (auto v : tree.simplex_vertex_range(handle)) {
            const Copy& copy = cover.copies[static_cast<std::size_t>(v)];
            simplex.push_back(copy);
            is_in_middle |= copy == Copy{copy[0]};
        }
        if (!is_in_middle) continue;
        settle(&simplex);
        const double value = tree.filtration(handle);
        const auto [at, is_new] = entries->emplace(simplex, Entry{value, 0});
        std::size_t in_middle = 0;
        for (auto v : tree.simplex_vertex_range(handle)) {
            const Copy& copy = cover.copies[static_cast<std::size_t>(v)];
            in_middle += copy == Copy{copy[0]};
        }
        at->second.times += in_middle;
        is_whole &= std::fabs(at->second.value - value) <= slack;
    }
    for (const auto& [simplex, entry] : *entries) is_whole &= entry.times == simplex.size();
    return is_whole;
}

// Persistence as textbooks have it. Equal facets cancel.
Bars reduce(Entries entries) {
    std::vector<std::vector<const Simplex*>> facets_of;
    std::vector<Entries::iterator> order;
    for (auto at = entries.begin(); at != entries.end(); ++at) order.push_back(at);
    const auto facets = [&](const Simplex& simplex) {
        std::vector<Entries::iterator> all;
        for (std::size_t i = 0; i < simplex.size() && simplex.size() > 1; ++i) {
            Simplex facet = simplex;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            settle(&facet);
            all.push_back(entries.find(facet));
            REQUIRE(all.back() != entries.end());
        }
        return all;
    };
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a->first.size() < b->first.size(); });
    for (const auto& at : order)  // values that roundings put below those of facets
        for (const auto& facet : facets(at->first)) at->second.value = std::max(at->second.value, facet->second.value);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a->second.value < b->second.value; });
    std::map<const Simplex*, std::size_t> place;
    for (std::size_t j = 0; j < order.size(); ++j) place[&order[j]->first] = j;
    std::vector<std::vector<bool>> column(order.size(), std::vector<bool>(order.size(), false));
    std::vector<std::size_t> owner(order.size(), SIZE_MAX);
    std::vector<bool> is_death(order.size(), false);
    Bars bars;
    for (std::size_t j = 0; j < order.size(); ++j) {
        for (const auto& facet : facets(order[j]->first)) column[j][place[&facet->first]].flip();
        std::size_t low = order.size();
        while (low-- > 0) {
            if (!column[j][low]) continue;
            if (owner[low] == SIZE_MAX) break;
            for (std::size_t i = 0; i <= low; ++i)
                if (column[owner[low]][i]) column[j][i].flip();
        }
        if (low == SIZE_MAX) continue;
        owner[low] = j;
        is_death[j] = true;
        bars.push_back(
            {static_cast<int>(order[low]->first.size()) - 1, order[low]->second.value, order[j]->second.value});
    }
    for (std::size_t j = 0; j < order.size(); ++j)
        if (!is_death[j] && owner[j] == SIZE_MAX)
            bars.push_back({static_cast<int>(order[j]->first.size()) - 1, order[j]->second.value, infinity});
    return bars;
}

}  // namespace

TEST_CASE("diagrams of cells with periods are those of a cover modulo translations") {
    const char* const asked = std::getenv("NETMESH_COVER_CELLS");
    const int cells = asked != nullptr ? std::atoi(asked) : 24;
    std::uint64_t hidden = 0;
    std::size_t compared = 0, boxes = 0, skew = 0, tied = 0, simplices = 0;
    for (int i = 0; i < cells; ++i) {
        inputs::Random random(static_cast<std::uint64_t>(i) + 1);
        const bool is_box = i / 2 % 2 == 0;
        const int dim = i % 12 == 11 ? 4 : 2 + i % 2;
        if (!plans_for(dim)) continue;
        const Cell cell = make_cell(random, dim, is_box);
        INFO("cell " << i << ", " << cell.dim << "D, " << cell.count() << " points, weights: " << cell.weights.size());
        const double slack = 1e-12;
        Entries entries;
        if (!take_simplices(cell, slack, &entries)) {
            ++tied;
            CHECK(is_box);
            continue;
        }
        const Bars ours = oracle::long_ones(bars_of_engine(cell, &hidden), slack);
        const Bars theirs = oracle::long_ones(reduce(entries), slack);
        REQUIRE(ours.size() == theirs.size());
        CHECK(oracle::count_unlike(ours, theirs, slack) == 0);
        compared += ours.size();
        simplices += entries.size();
        is_box ? ++boxes : ++skew;
    }
    CHECK(boxes > 0);
    CHECK(skew > 0);
    MESSAGE(boxes << " boxes and " << skew << " skew cells, " << compared << " bars of " << simplices << " simplices, "
                  << hidden << " hidden points; " << tied << " boxes left out, as the peer breaks ties");
}
