// A mesh is filtered in the memory of its balls: the same bars, and the same mesh afterwards.
#include "jobs/diagram_of_packed.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"

using namespace netmesh;

namespace {

template <int D> std::vector<Cell<D>> cells_of(const Store<D>& store) {
    std::vector<Cell<D>> cells(&store.cell(0), &store.cell(0) + store.state.cell_slots);
    for (Cell<D>& cell : cells) cell.mark = 0;
    return cells;
}
template <int D> bool are_same(const std::vector<Cell<D>>& a, const std::vector<Cell<D>>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Cell<D>)) == 0;
}

std::vector<Pair> pairs_of(const PairList& list) { return {list.pairs, list.pairs + list.count}; }
std::vector<Pair> pairs_of(const BarList& bars) {
    std::vector<Pair> pairs;
    for (std::uint64_t i = 0; i < bars.count; ++i) pairs.push_back(bars[i]);
    return pairs;
}
bool are_same(const std::vector<Pair>& a, const std::vector<Pair>& b) {
    bool same = a.size() == b.size();
    for (std::size_t i = 0; same && i < a.size(); ++i)
        same = a[i].birth == b[i].birth && a[i].death == b[i].death && a[i].degree == b[i].degree;
    return same;
}

void set_values(double* value, std::uint32_t count) {
    inputs::Random random(5);
    for (std::uint32_t v = 0; v < count; ++v) value[v] = random.uniform();
}
template <int D> double* add_values(Meshed<D>& m) {
    double* const value = m.block.arena.template take_low<double>(m.state.vertex_count);
    REQUIRE(value != nullptr);
    set_values(value, m.state.vertex_count);
    return value;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("diagram_of_packed: bars as of the mesh as it stands, which is the same afterwards", Dim,
                          persist_packed_all) {
    constexpr int D = Dim::value;
    const inputs::Points points = inputs::uniform(D, D == 4 ? 20 : 60);
    MeshRequest requests[4];
    for (MeshRequest& request : requests) request.tau = D == 2 ? 2.5 : 3.5;
    requests[1].method = MeshMethod::hierarchy;
    requests[1].finish = true;
    requests[2].method = MeshMethod::certificate;
    requests[2].goal.ratio = 2.25;
    requests[3].size.eps = 0.8;
    for (const MeshRequest& request : requests) {
        Meshed<D> m(points, request);
        REQUIRE(m.status == Status::ok);
        const std::vector<Cell<D>> cells = cells_of(m.store);
        const std::size_t behind = m.block.arena.low_mark();
        const double* const value = add_values(m);
        const std::size_t low = m.block.arena.low_mark(), high = m.block.arena.high_mark();
        const LowerStarFiltration<D> filtration = {m.store.view(), value, m.inputs()};
        const Work work = {m.block.arena, m.monitor};
        CountedPairs plain = {}, packed = {}, shorter = {};
        REQUIRE(persist_lower_star<D>(filtration, {D - 1}, work, &plain) == Status::ok);
        const std::vector<Pair> bars = pairs_of(plain.pairs);
        m.block.arena.release_low(low);
        const auto persist = [&](CountedPairs* found, bool is_short) {
            return (is_short ? diagram_of_packed<true>
                             : diagram_of_packed<false>)(m.store, {behind, high},
                                                         filtration.template of_dimension<any_dimension>(D).get(),
                                                         {D - 1}, work, found);
        };
        REQUIRE(persist(&shorter, true) == Status::ok);
        const BarList short_bars = {shorter.pairs.pairs, shorter.pairs.count, true};
        CHECK(are_same(bars, pairs_of(short_bars)));
        CHECK(m.block.arena.low_mark() == m.block.arena.offset_of(short_bars.first) + 16 * bars.size());
        CHECK(shorter.simplices == plain.simplices);
        CHECK(are_same<D>(cells, cells_of(m.store)));
        m.block.arena.release_low(low);
        REQUIRE(m.block.arena.template take_high<double>(10) != nullptr);  // given back
        REQUIRE(persist(&packed, false) == Status::ok);
        CHECK(are_same(bars, pairs_of(packed.pairs)));
        CHECK(packed.simplices == plain.simplices);
        CHECK(are_same<D>(cells, cells_of(m.store)));
        CHECK(m.block.arena.offset_of(packed.pairs.pairs) >= low);
        CHECK(m.block.arena.high_mark() == high);
        inputs::Random random(5);
        bool kept = true;
        for (std::uint32_t v = 0; v < m.state.vertex_count; ++v) kept &= value[v] == random.uniform();
        CHECK(kept);
    }
}
TEST_CASE_TEMPLATE_APPLY(persist_packed_all, Dimensions<2, 4>);

// With less and less memory: the bars, or out_of_memory; the mesh as it was in any case.
TEST_CASE_TEMPLATE_DEFINE("diagram_of_packed: any gap leaves the mesh whole", Dim, persist_packed_gaps) {
    constexpr int D = Dim::value;
    MeshRequest request;
    request.tau = 3.5;
    Meshed<D> m(inputs::uniform(D, 30), request);
    REQUIRE(m.status == Status::ok);
    const std::vector<Cell<D>> cells = cells_of(m.store);
    const std::size_t behind = m.block.arena.low_mark();
    double* const value = add_values(m);
    const std::size_t low = m.block.arena.low_mark(), high = m.block.arena.high_mark();
    const Work work = {m.block.arena, m.monitor};
    std::vector<Pair> bars;
    unsigned made = 0, refused = 0;
    for (std::size_t gap = high - low; gap >= 64; gap = gap / 16 * 15 / 16 * 16) {
        m.block.arena.release_high(low + gap);
        CountedPairs found = {};
        const Status status = diagram_of_packed<false>(
            m.store, {behind, low + gap}, {AnyStore(m.store).view(), value, m.inputs()}, {D - 1}, work, &found);
        REQUIRE((status == Status::ok || status == Status::out_of_memory));
        (status == Status::ok ? made : refused)++;
        if (status == Status::ok && bars.empty()) bars = pairs_of(found.pairs);
        if (status == Status::ok) REQUIRE(are_same(bars, pairs_of(found.pairs)));
        REQUIRE(are_same<D>(cells, cells_of(m.store)));
        REQUIRE(m.block.arena.high_mark() == low + gap);
        m.block.arena.release_low(low);
        set_values(value, m.state.vertex_count);  // without ok they may be gone
    }
    CHECK(made > 20);
    CHECK(refused > 20);
}
TEST_CASE_TEMPLATE_APPLY(persist_packed_gaps, Dimensions<2, 3>);
