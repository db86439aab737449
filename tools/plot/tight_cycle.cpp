#include "tools/plot/tight_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace netmesh::tool {

namespace {

using Vertex = std::uint32_t;
using Edges = std::vector<std::vector<Vertex>>;
using Loop = std::vector<Vertex>;  // of its vertices, the last one beside the first

// The square of a cell's circumscribed radius, by a linear system; infinite where that is singular.
double radius2(const double* const* corners, std::uint32_t dim) {
    double rows[3][4] = {};
    for (std::uint32_t i = 0; i < dim; i++) {
        for (std::uint32_t k = 0; k < dim; k++) {
            rows[i][k] = corners[i + 1][k] - corners[0][k];
            rows[i][dim] += rows[i][k] * rows[i][k] / 2;
        }
    }
    for (std::uint32_t i = 0; i < dim; i++) {
        std::uint32_t pivot = i;
        for (std::uint32_t r = i + 1; r < dim; r++)
            if (std::abs(rows[r][i]) > std::abs(rows[pivot][i])) pivot = r;
        if (rows[pivot][i] == 0) return HUGE_VAL;
        std::swap(rows[i], rows[pivot]);
        for (std::uint32_t r = 0; r < dim; r++) {
            if (r == i) continue;
            const double factor = rows[r][i] / rows[i][i];
            for (std::uint32_t k = i; k <= dim; k++) rows[r][k] -= factor * rows[i][k];
        }
    }
    double sum = 0;
    for (std::uint32_t i = 0; i < dim; i++) sum += (rows[i][dim] / rows[i][i]) * (rows[i][dim] / rows[i][i]);
    return std::isfinite(sum) ? sum : HUGE_VAL;
}

class Tightener {
public:
    Tightener(const CyclePlaces& places, double radius) : places_(places) {
        constexpr double inside = 1 - 1e-9;  // more than roundings are
        const std::size_t corners = places.dim + 1;
        const double* at[4];
        for (std::size_t c = 0; c + corners <= places.cells.size(); c += corners) {
            const Vertex* const cell = &places.cells[c];
            for (std::size_t i = 0; i < corners; i++) at[i] = place(cell[i]);
            if (!(radius2(at, places.dim) < radius * radius * inside)) continue;
            for (std::size_t v = 0; v < corners; v++)
                for (std::size_t i = 0; i < corners; i++)
                    for (std::size_t j = 0; j < i; j++)
                        if (i != v && j != v) links_[cell[v]].insert(std::minmax(cell[i], cell[j]));
        }
    }

    // From one vertex after the other the shortest way around that is near, until none is shorter.
    void pull(Loop* loop) const {
        constexpr std::size_t rounds_most = 200;
        std::size_t still = 0;
        for (std::size_t round = 0; round < rounds_most && still < 3 && loop->size() > 2; round++) {
            const double before = length_of(*loop);
            *loop = without_spurs(shortest_near(*loop));
            still = length_of(*loop) < before * (1 - 1e-12) ? 0 : still + 1;
            if (loop->size() > 2)
                std::rotate(loop->begin(), loop->begin() + static_cast<std::ptrdiff_t>(1 + loop->size() / 3),
                            loop->end());
        }
        if (loop->size() < 3) loop->clear();
    }

private:
    using State = std::pair<std::size_t, Vertex>;  // the vertex of the way whose link this is in, and where
    struct Reached {
        double length;
        State from;
    };

    const double* place(Vertex v) const { return &places_.coordinates[std::size_t{v} * places_.dim]; }
    double distance(Vertex a, Vertex b) const {
        double sum = 0;
        for (std::uint32_t k = 0; k < places_.dim; k++)
            sum += (place(a)[k] - place(b)[k]) * (place(a)[k] - place(b)[k]);
        return std::sqrt(sum);
    }
    double length_of(const Loop& loop) const {
        double sum = 0;
        for (std::size_t i = 0; i < loop.size(); i++) sum += distance(loop[i], loop[(i + 1) % loop.size()]);
        return sum;
    }

    // The way v_0, v_1, .., v_n = v_0 swept over the stars of v_1, .., v_(n-1), one after the other: in the link of v_j
    // it goes along edges that span allowed triangles with v_j; from that link to the next one at a corner of an
    // allowed triangle on v_j and v_(j+1), or at a vertex of the old way. All ways of this kind are homotopic to the
    // old one, which is among them; this is the shortest.
    Loop shortest_near(const Loop& loop) const {
        const std::size_t n = loop.size();
        const auto old = [&](std::size_t j) { return loop[j % n]; };
        static const std::set<std::pair<Vertex, Vertex>> none;
        const auto link = [&](std::size_t j) -> const std::set<std::pair<Vertex, Vertex>>& {
            const auto found = links_.find(old(j));
            return found == links_.end() ? none : found->second;
        };
        std::map<State, Reached> reached;
        using Entry = std::pair<double, State>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
        const auto reach = [&](const State& from, const State& to, double length) {
            const auto [at, added] = reached.insert({to, {length, from}});
            if (!added && !(length < at->second.length)) return;
            at->second = {length, from};
            queue.push({length, to});
        };
        const State start = {1, old(0)}, end = {n + 1, old(n)};  // at v_j of the old way: in the link of v_(j+1)
        reach(start, start, 0);
        while (!queue.empty()) {
            const auto [length, state] = queue.top();
            queue.pop();
            const auto [j, u] = state;
            if (length > reached.at(state).length) continue;
            if (state == end) break;
            if (u == old(j - 1)) reach(state, {j + 1, old(j)}, length + distance(u, old(j)));
            if (j >= n) continue;
            if (u == old(j + 1)) reach(state, {j + 2, u}, length);
            for (const auto& [a, b] : link(j)) {
                if (a == u || b == u) reach(state, {j, a == u ? b : a}, length + distance(a, b));
                if (j + 1 < n && std::minmax(u, old(j + 1)) == std::minmax(a, b)) reach(state, {j + 1, u}, length);
            }
        }
        Loop way;
        for (State state = end; state != start; state = reached.at(state).from)
            if (way.empty() || way.back() != state.second) way.push_back(state.second);
        while (way.size() > 1 && way.back() == way.front()) way.pop_back();
        return way;
    }

    static Loop without_spurs(const Loop& loop) {
        Loop kept;
        for (const Vertex v : loop) {
            if (kept.size() > 1 && kept[kept.size() - 2] == v) {
                kept.pop_back();
            } else if (kept.empty() || kept.back() != v) {
                kept.push_back(v);
            }
        }
        while (kept.size() > 2 && (kept[kept.size() - 2] == kept[0] || kept.back() == kept[1])) {
            if (kept.back() == kept[1]) kept.erase(kept.begin());
            kept.pop_back();
        }
        if (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
        return kept;
    }

    const CyclePlaces& places_;
    std::map<Vertex, std::set<std::pair<Vertex, Vertex>>> links_;  // of each vertex in allowed cells
};

// A cycle over Z/2 as closed ways.
std::vector<Loop> loops_of(const Edges& cycle) {
    std::map<Vertex, std::set<Vertex>> left;
    for (const std::vector<Vertex>& edge : cycle) {
        left[edge[0]].insert(edge[1]);
        left[edge[1]].insert(edge[0]);
    }
    std::vector<Loop> loops;
    for (auto& [start, others] : left) {
        while (!others.empty()) {
            Loop loop;
            Vertex at = start;
            do {
                loop.push_back(at);
                const auto way = left.find(at);
                if (way->second.empty()) return {};  // no cycle
                const Vertex next = *way->second.begin();
                way->second.erase(next);
                left.find(next)->second.erase(at);
                at = next;
            } while (at != start);
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

}  // namespace

Edges tightened(const Edges& cycle, double radius, const CyclePlaces& places) {
    const bool are_edges = !cycle.empty() && cycle[0].size() == 2;
    if (!are_edges || places.cells.empty() || places.dim > 3) return cycle;
    const Tightener tightener(places, radius);
    std::set<std::pair<Vertex, Vertex>> kept;  // over Z/2
    for (Loop& loop : loops_of(cycle)) {
        tightener.pull(&loop);
        for (std::size_t i = 0; i < loop.size(); i++) {
            const auto ends = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            const auto [place, added] = kept.insert({ends.first, ends.second});
            if (!added) kept.erase(place);
        }
    }
    if (kept.empty()) return cycle;
    Edges edges;
    for (const auto& [a, b] : kept) edges.push_back({a, b});
    return edges;
}

}  // namespace netmesh::tool
