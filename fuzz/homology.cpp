// Arbitrary filtrations of simplices through netmesh_persist against the textbook reduction: bytes to simplices of up
// to eight vertices, with their faces, at values of a few levels (so ties are the rule), in any order of simplices and
// of their vertices.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

#include "fuzz/decoder.hpp"
#include "netmesh.hpp"

namespace {

using fuzz::require;

struct Simplex {
    std::uint32_t mask;  // of vertices
    double value;
};

std::uint32_t size_of(std::uint32_t mask) { return static_cast<std::uint32_t>(__builtin_popcount(mask)); }

// Faces enter no later than what they are faces of. The order is that of the filtration.
std::vector<Simplex> decode_complex(fuzz::Tape& tape) {
    std::map<std::uint32_t, double> value_of;
    const std::uint32_t maximal = 1 + tape.below(10);
    for (std::uint32_t i = 0; i < maximal; ++i) {
        std::uint32_t mask = tape.byte();
        while (size_of(mask) > 5) mask &= mask - 1;
        for (std::uint32_t face = mask; face != 0; face = (face - 1) & mask) value_of[face] = 0;
    }
    for (auto& [mask, value] : value_of) value = tape.empty() ? 0 : fuzz::coordinate(tape.byte());
    std::vector<Simplex> order;
    for (const auto& [mask, value] : value_of) order.push_back({mask, value});
    std::sort(order.begin(), order.end(), [](const Simplex& a, const Simplex& b) {
        return size_of(a.mask) != size_of(b.mask) ? size_of(a.mask) < size_of(b.mask) : a.mask < b.mask;
    });
    for (Simplex& s : order) {  // by size, so faces are done
        for (std::uint32_t v = 0; v < 8; ++v) {
            const std::uint32_t face = s.mask & ~(1u << v);
            if (face != s.mask && face != 0) s.value = std::max(s.value, value_of[face]);
        }
        value_of[s.mask] = s.value;
    }
    std::stable_sort(order.begin(), order.end(), [](const Simplex& a, const Simplex& b) { return a.value < b.value; });
    return order;
}

bool before(const netmesh_pair& a, const netmesh_pair& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
}

using Column = std::vector<std::uint32_t>;

Column boundary(const std::vector<Simplex>& order, std::uint32_t mask) {
    Column column;
    for (std::uint32_t i = 0; i < order.size(); ++i)
        if ((order[i].mask & ~mask) == 0 && size_of(order[i].mask) + 1 == size_of(mask)) column.push_back(i);
    return column;
}

std::vector<netmesh_pair> naive_diagram(const std::vector<Simplex>& order, std::uint32_t max_degree, bool keep_zero) {
    std::vector<Column> with_pivot(order.size());
    std::vector<bool> paired(order.size());
    std::vector<netmesh_pair> pairs;
    const auto add = [&](std::uint32_t birth, double death) {
        const std::uint32_t degree = size_of(order[birth].mask) - 1;
        if (degree <= max_degree && (keep_zero || death != order[birth].value))
            pairs.push_back({sizeof(netmesh_pair), degree, order[birth].value, death});
    };
    for (std::uint32_t j = 0; j < order.size(); ++j) {
        Column column = boundary(order, order[j].mask);
        while (!column.empty() && !with_pivot[column.back()].empty()) {
            Column sum;
            const Column& other = with_pivot[column.back()];
            std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                          std::back_inserter(sum));
            column.swap(sum);
        }
        if (column.empty()) continue;
        paired[column.back()] = paired[j] = true;
        add(column.back(), order[j].value);
        with_pivot[column.back()] = column;
    }
    for (std::uint32_t i = 0; i < order.size(); ++i)
        if (!paired[i]) add(i, std::numeric_limits<double>::infinity());
    std::sort(pairs.begin(), pairs.end(), before);
    return pairs;
}

// A representative is a cycle that is complete at its pair's birth.
void check_cycle(const netmesh_context* context, std::uint64_t index, const netmesh_pair& pair) {
    std::uint64_t count;
    require(netmesh_get_cycle(context, index, &count) == NETMESH_OK && count > 0);
    std::map<std::vector<std::uint32_t>, int> faces;
    double last = -std::numeric_limits<double>::infinity();
    for (std::uint64_t i = 0; i < count; ++i) {
        auto s = netmesh::sized<netmesh_simplex>();
        require(netmesh_get_cycle_simplex(context, index, i, &s) == NETMESH_OK);
        require(s.degree == pair.degree);
        last = std::max(last, s.value);
        for (std::uint32_t skip = 0; skip <= pair.degree && pair.degree > 0; ++skip) {
            std::vector<std::uint32_t> face;
            for (std::uint32_t v = 0; v <= pair.degree; ++v)
                if (v != skip) face.push_back(s.vertices[v]);
            ++faces[face];
        }
    }
    for (const auto& [face, times] : faces) require(times % 2 == 0);
    require(last == pair.birth);
}

// There and back: the simplices of each dimension in the opposite order of the list, then as in the request again.
void check_vineyard(netmesh_context* context, const netmesh_simplices& of, std::uint32_t max_degree,
                    const std::vector<netmesh_pair>& expected) {
    const std::size_t n = of.simplex_count;
    std::vector<double> values(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
        const double size = static_cast<double>(of.starts[i + 1] - of.starts[i]);
        values[i] = values[2 * n + i] = of.entries[i];
        values[n + i] = 1e6 * size - static_cast<double>(i);
    }
    netmesh_simplices moving = of;
    moving.entries = values.data();
    moving.step_count = 3;
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &moving;
    request.max_degree = max_degree;
    request.vines = &netmesh_vines;
    require(netmesh_persist(context, &request) == NETMESH_OK);
    std::vector<netmesh_pair> seen[3];
    auto p = netmesh::sized<netmesh_vine_point>();
    for (std::uint64_t i = 0; netmesh_get_vine_point(context, i, &p) == NETMESH_OK; ++i)
        seen[p.k - 1].push_back({sizeof(netmesh_pair), p.degree, p.birth, p.death});
    for (const int step : {0, 2}) {
        std::sort(seen[step].begin(), seen[step].end(), before);
        require(seen[step].size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            require(seen[step][i].degree == expected[i].degree && seen[step][i].birth == expected[i].birth &&
                    seen[step][i].death == expected[i].death);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    const std::uint32_t max_degree = tape.below(6);
    const std::uint32_t keep_zero = tape.byte() & 1, representatives = tape.byte() & 1;
    const std::uint32_t rotation = tape.byte();
    const std::uint32_t labels = tape.byte() & 1 ? 1000000007u : 1u;  // vertices need not be numbered from 0
    const std::vector<Simplex> order = decode_complex(tape);
    if (order.empty()) return 0;

    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> values;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Simplex& s = order[(i * 7919 + rotation) % order.size()];  // a prime: every one once
        for (std::uint32_t j = 0; j < 8; ++j) {
            const std::uint32_t v = (j + rotation) % 8;
            if (s.mask >> v & 1) vertices.push_back(v * labels);
        }
        starts.push_back(vertices.size());
        values.push_back(s.value);
    }
    const std::size_t bytes = std::size_t{1} << 22;
    void* const block = std::malloc(bytes);
    netmesh_context* context;
    require(block != nullptr && netmesh_init(block, bytes, &context) == NETMESH_OK);
    const std::vector<std::uint32_t> v(vertices);  // no spare capacity
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = v.data();
    simplices.starts = starts.data();
    simplices.entries = values.data();
    simplices.simplex_count = order.size();
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    request.max_degree = max_degree;
    request.keep_zero_pairs = keep_zero;
    request.cycles = representatives != 0 ? &netmesh_cycles : nullptr;
    require(netmesh_persist(context, &request) == NETMESH_OK);
    const std::vector<netmesh_pair> expected = naive_diagram(order, max_degree, keep_zero != 0);
    auto pair = netmesh::sized<netmesh_pair>();
    for (std::size_t i = 0; i < expected.size(); ++i) {
        require(netmesh_get_pair(context, i, &pair) == NETMESH_OK);
        require(pair.degree == expected[i].degree && pair.birth == expected[i].birth &&
                pair.death == expected[i].death);
        if (representatives != 0) check_cycle(context, i, pair);
    }
    require(netmesh_get_pair(context, expected.size(), &pair) != NETMESH_OK);
    if (keep_zero == 0) check_vineyard(context, simplices, max_degree, expected);
    std::free(block);
    return 0;
}
