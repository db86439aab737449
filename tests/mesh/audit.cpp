// Point location in all D-balls, rounds of range nets, and invariants after every insertion (thesis 4.7 to 4.9).
#include <doctest/doctest.h>

#include <algorithm>

#include "common/dimensions.hpp"
#include "common/hierarchical.hpp"
#include "mesh/audit/quality_audit.hpp"
#include "mesh/input_tree.hpp"
#include "mesh/loop/frame.hpp"
#include "mesh/loop/split.hpp"

using namespace netmesh;

namespace {

template <int D> double sound_worst(Hierarchical<D>& m) {
    const HierarchyQuality q = m.quality();
    CHECK(found(q.encroached) == "");
    return q.worst;
}

// Inputs stored in the balls of the frame's cells, before the first insertion.
template <int D> struct Stored {
    Stored(const inputs::Points& points, std::size_t bytes)
        : count(static_cast<std::uint32_t>(points.size() / D)), block(bytes), store(block.arena, state),
          kernel(store, corner_error_max, VertexCells::kept) {
        Monitor monitor;
        InputReport input;
        std::uint32_t* order;
        REQUIRE(take_input<D>(store, points.data(), count, 1, monitor, &input, &order) == Status::ok);
        REQUIRE(tree.build(store, block.arena, count) == Status::ok);
        CHECK_FALSE(lists.is_open());
        REQUIRE(lists.open(D, block.arena, count) == Status::ok);
        REQUIRE(store.open_cells() == Status::ok);
        smallest_enclosing_ball<D>(store, count, domain);
        std::uint64_t steps = 0;
        REQUIRE(open_frame(store, tree, domain, 8 * domain.enclosing_radius, &steps) == Status::ok);
        REQUIRE(lists.start(store));
        CHECK(lists.load(store) == count);
    }
    Cavity find(VertexId v) {
        Cavity cavity;
        REQUIRE(kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, state.last_cell), &cavity));
        return cavity;
    }
    void insert(VertexId v) {
        const Cavity cavity = find(v);
        REQUIRE(lists.agrees(store, cavity, v));
        lists.detach(store, cavity, v);
        kernel.fill(cavity, v);
        REQUIRE(lists.attach(store, cavity, v));
    }
    // Inputs from `first` on that a cell's ball contains.
    std::vector<std::uint32_t> in_ball(CellId c, std::uint32_t first) {
        std::vector<std::uint32_t> inside;
        for (VertexId v(first); v < count; ++v)
            if (kernel.in_conflict(c, store.point(v), v)) inside.push_back(v);
        return inside;
    }
    std::uint32_t count;
    Block block;
    StoreState state = {};
    Store<D> store;
    InputTree<D> tree;
    BallLists lists;
    Kernel<D> kernel;
    Domain<D> domain;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("inputs stored in all D-balls: loads halve in every round, and the mesh is as good", T,
                          location) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 2000, 200, 30, 8};
    constexpr double taus[] = {0, 0, 2.5, 3, 3, 4};
    const inputs::Points sets[] = {inputs::uniform(D, sizes[D]), inputs::grid(D, D < 4 ? 5 : 2),
                                   inputs::nested(D, 5, sizes[D] / 5, 1e3), inputs::geometric(D, 1e3, 20),
                                   inputs::close_pairs(D, sizes[D] / 4, 1e-12)};
    for (const bool cages : {true, false})
        for (const inputs::Points& points : sets) {
            if (!cages && &points >= sets + 2) break;  // gaps make plain refinement large
            Hierarchical<D> m(points, audited(cages ? by_hierarchy(taus[D]) : by_quality(taus[D]), true, false));
            REQUIRE(m.status == Status::ok);  // each input was in exactly the balls that it was stored in
            CHECK(sound_worst(m) <= taus[D]);
            const LocationAudit& audit = m.result.audit.location;
            REQUIRE(audit.rounds > 0);
            CHECK(audit.load[0] == m.result.input.rows - m.result.input.duplicates);
            for (std::uint32_t k = 0; k + 1 < audit.rounds; ++k) CHECK(audit.load[k + 1] <= audit.load[k] / 2);
            CHECK(audit.load[audit.rounds - 1] > 0);
            CHECK(audit.nets >= audit.rounds);
            CHECK(audit.ply_max >= audit.ply_mean);
            CHECK(audit.ply_mean >= 1);
            CHECK(audit.touches_max >= audit.touches_mean);
            CHECK(audit.tests_mean >= audit.touches_mean);
        }
}
TEST_CASE_TEMPLATE_APPLY(location, Dimensions<2, 5>);

TEST_CASE("with cages neither rounds nor touches depend on the spread, without them touches do") {
    double least = infinity, most = 0;
    for (const double ratio : {1e2, 1e6}) {
        Hierarchical<2> m(inputs::nested(2, 5, 20, ratio), audited(by_hierarchy(3), true, false));
        REQUIRE(m.status == Status::ok);
        least = std::min(least, m.result.audit.location.touches_mean);
        most = std::max(most, m.result.audit.location.touches_mean);
    }
    CHECK(most < 1.2 * least);
    Hierarchical<2> plain(inputs::nested(2, 5, 20, 1e6), audited(by_quality(3), true, false));
    REQUIRE(plain.status == Status::ok);
    CHECK(plain.result.audit.location.touches_mean > 1.5 * most);
}

// Vertices and cells are the same, to the bit.
template <int D> bool same_mesh(const Hierarchical<D>& a, const Hierarchical<D>& b) {
    if (a.state.vertex_count != b.state.vertex_count || a.state.cell_slots != b.state.cell_slots) return false;
    for (std::uint32_t v = 0; v < a.state.vertex_count; ++v)
        if (!std::equal(a.store.point(v), a.store.point(v) + D, b.store.point(v)) ||
            a.store.vertex(v).marker != b.store.vertex(v).marker ||
            a.store.vertex(v).origin != b.store.vertex(v).origin)
            return false;
    for (std::uint32_t c = 0; c < a.state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i)
            if (a.store.cell(c).vertex[i] != b.store.cell(c).vertex[i]) return false;
    return true;
}

TEST_CASE_TEMPLATE_DEFINE("an audit of quality is of the mesh that is made without, one of location of another order",
                          T, same) {
    constexpr int D = T::value;
    // From tau 6 on Steiner points often yield to inputs farther away than nine tenths of their empty balls.
    for (const double tau : {D < 4 ? 3.0 : 5.0, 12.0}) {
        for (const inputs::Points& points : {inputs::uniform(D, D == 2   ? 60
                                                                : D == 3 ? 20
                                                                         : 6),
                                             inputs::close_pairs(D, 3, 0.1)})
            for (const MeshRequest& request : {by_quality(tau), by_hierarchy(tau), by_hierarchy(tau, true)}) {
                const Hierarchical<D> plain(points, request), with(points, audited(request, false, true));
                REQUIRE(plain.status == Status::ok);
                REQUIRE(with.status == Status::ok);
                CHECK(with.result.audit.quality.meshes > 0);
                CHECK(plain.result.audit.quality.meshes == 0);
                CHECK(same_mesh<D>(plain, with));
            }
        const inputs::Points points = inputs::uniform(D, D < 4 ? 60 : 20);
        const Hierarchical<D> plain(points, by_quality(tau)), rounds(points, audited(by_quality(tau), true, false));
        CHECK_FALSE(same_mesh<D>(plain, rounds));
    }
}
TEST_CASE_TEMPLATE_APPLY(same, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("lists count each input that they compare with a ball", T, list_looks) {
    constexpr int D = T::value;
    constexpr std::uint32_t n = D < 4 ? 60 : 30;
    Stored<D> s(inputs::uniform(D, n), std::size_t{1} << 24);
    std::uint64_t looks = 0;
    for (CellId c(0); c < s.state.cell_slots; ++c)
        if (s.store.is_live(c) && !s.store.is_ghost(c)) looks += n;
    CHECK(s.lists.looks() == looks);
    for (VertexId v(0); v < n; ++v) {
        // In balls that go: by looking at all inputs that are left.
        std::vector<bool> waits(n, false);
        Cavity cavity = s.find(v);
        std::vector<CellId> gone;
        for (std::uint32_t k = 0; k < cavity.cells; ++k) gone.push_back(s.kernel.cavity_cell(k));
        for (const CellId c : gone)
            for (const std::uint32_t p : s.in_ball(c, v.index + 1)) waits[p] = true;
        s.insert(v);
        // A new ball is compared with those and with what the ball behind the facet opposite to v holds.
        std::vector<CellId> star;
        REQUIRE(s.kernel.visit_star(v, [&](CellId c) { star.push_back(c); }));
        for (const CellId c : star) {
            std::vector<bool> seen = waits;
            const Cell<D>& cell = s.store.cell(c);
            for (int i = 0; i <= D; ++i) {
                if (cell.vertex[i] != v || s.store.is_ghost(cell.neighbour[i].cell())) continue;
                for (const std::uint32_t p : s.in_ball(cell.neighbour[i].cell(), v.index + 1)) seen[p] = true;
            }
            looks += static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), true));
        }
        CHECK(s.lists.looks() == looks);
    }
}
TEST_CASE_TEMPLATE_APPLY(list_looks, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("touches of whole meshes: all looks of both ways, by any method that locates", T, touches) {
    constexpr int D = T::value;
    // The tree is one leaf: each search looks at all inputs, and once more where it has one to start with.
    constexpr std::uint64_t n = 7;
    const inputs::Points points = inputs::geometric(D, 100, n);
    for (const bool lists : {false, true})
        for (const MeshRequest& request : {by_quality(4), by_hierarchy(4), by_hierarchy(4, true)}) {
            const Hierarchical<D> m(points, audited(request, lists, false));
            REQUIRE(m.status == Status::ok);
            const LocationCounts& location = m.result.location;
            const bool cages = request.method == MeshMethod::hierarchy;
            std::uint64_t split = 0, shells = 2 * D * m.result.hierarchy.cages_made;
            for (std::uint32_t v = n; v < m.state.vertex_count; ++v)
                split += m.store.vertex(VertexId(v)).marker == Marker::steiner;
            if (request.finish) split -= shells;
            // Nearest inputs for the separation, of the frame's vertices, and around each Steiner point: by SVR for
            // all of them, besides f_P of some; with cages as long as inputs are missing.
            std::uint64_t least = n * n + 2 * D * n, most = n * n + 2 * D * (n + 1);
            if (cages) {
                most += (split + n) * n + n * n * 700;
                if (request.finish) least += (split + shells) * (n + 1);
                if (request.finish) most += (2 * D + split + shells) * (n + 1);
            } else {
                least += split * (n + 1);
                most += (split + n) * 2 * n;
            }
            INFO("lists " << lists << " cages " << cages << " finish " << request.finish << " least " << least
                          << " tree " << location.tree << " most " << most);
            CHECK(location.tree >= least);
            CHECK(location.tree <= most);
            CHECK((location.lists > 0) == lists);
            if (lists) CHECK(location.lists > n * m.result.audit.location.tests_mean);
            CHECK(location.passed >= n);
            CHECK(location.touches() == location.tree + location.lists + location.passed);
        }
}
TEST_CASE_TEMPLATE_APPLY(touches, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("lists that miss an insertion disagree with the balls", T, missed) {
    constexpr int D = T::value;
    constexpr std::uint32_t n = D < 4 ? 200 : D < 6 ? 60 : 80, half = n / 2;
    Stored<D> s(inputs::uniform(D, n), std::size_t{1} << 24);
    for (VertexId v(0); v < half; ++v) s.insert(v);
    // One input's lists are not another's, though as many.
    std::uint32_t as_many = 0;
    for (VertexId v(half); v < n; ++v)
        for (VertexId w(half); w < n; ++w) {
            const std::uint32_t own = s.find(v).cells;
            const Cavity other = s.find(w);
            if (v == w) CHECK(s.lists.agrees(s.store, other, v));
            if (own != other.cells) CHECK_FALSE(s.lists.agrees(s.store, other, v));
            as_many += own == other.cells && !s.lists.agrees(s.store, other, v);
        }
    CHECK(as_many > 2);
    for (VertexId v(half); v < half + 10; ++v) s.kernel.fill(s.find(v), v);
    std::uint32_t disagree = 0;
    for (VertexId v(half + 10); v < n; ++v) disagree += !s.lists.agrees(s.store, s.find(v), v);
    CHECK(disagree > 5);
    CHECK(disagree < (D < 4 ? half - 10 : half));
}
TEST_CASE_TEMPLATE_APPLY(missed, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("nets reach every ball that is too full, and no ball is drawn from twice for the same inputs",
                          T, nets) {
    constexpr int D = T::value;
    constexpr std::uint32_t n = D < 5 ? 500 : 150, first = 20;
    Stored<D> s(inputs::uniform(D, n), std::size_t{1} << 24);
    std::vector<std::uint32_t> chosen(n);
    // All of the frame's balls hold all inputs.
    CHECK(s.lists.draw_nets(s.store, n / 2, 1, chosen.data()) == 4 * D);
    std::sort(chosen.begin(), chosen.begin() + 4 * D);
    CHECK(std::adjacent_find(chosen.begin(), chosen.begin() + 4 * D) == chosen.begin() + 4 * D);
    CHECK(s.lists.draw_nets(s.store, n, 1, chosen.data()) == 0);
    // After some insertions each ball has as many in the net as are asked for, or all it holds.
    for (VertexId v(0); v < first; ++v) s.insert(v);
    for (const std::uint32_t most : {s.lists.load(s.store) / 2, std::uint32_t{4}, std::uint32_t{0}}) {
        const std::uint32_t drawn = s.lists.draw_nets(s.store, most, 7, chosen.data());
        std::sort(chosen.begin(), chosen.begin() + drawn);
        CHECK(std::adjacent_find(chosen.begin(), chosen.begin() + drawn) == chosen.begin() + drawn);
        std::size_t lacking = 0, load = 0;
        for (CellId c(0); c < s.state.cell_slots; ++c) {
            if (!s.store.is_live(c) || s.store.is_ghost(c)) continue;
            const std::vector<std::uint32_t> inside = s.in_ball(c, first);
            load = std::max(load, inside.size());
            if (inside.size() <= most) continue;
            std::size_t in_net = 0;
            for (const std::uint32_t v : inside)
                in_net += std::binary_search(chosen.begin(), chosen.begin() + drawn, v);
            lacking += in_net < std::min<std::size_t>(4 * D, inside.size());
        }
        CHECK(lacking == 0);
        CHECK(load == s.lists.load(s.store));
    }
}
TEST_CASE_TEMPLATE_APPLY(nets, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("lists are refused where they do not fit", T, refused_lists) {
    constexpr int D = T::value;
    Block block(std::size_t{1} << 16);
    StoreState state = {};
    Store<D> store(block.arena, state);
    REQUIRE(store.open_vertices(20) == Status::ok);
    const std::size_t low = block.arena.low_mark(), top = block.arena.high_mark();
    bool fits = false;
    for (std::size_t bytes = 0; bytes < 4000; bytes += 16) {
        block.arena.release_low(top - bytes);
        BallLists lists;
        const Status status = lists.open(D, block.arena, 20);
        REQUIRE((status == Status::ok || (status == Status::out_of_memory && !fits)));
        CHECK(lists.is_open() == (status == Status::ok));
        fits = status == Status::ok;
        block.arena.release_low(low);
    }
    CHECK(fits);
}
TEST_CASE_TEMPLATE_APPLY(refused_lists, Dimensions<>);

TEST_CASE("ratios of unfinished meshes do not depend on how near inputs are to each other") {
    for (const double gap : {1e-1, 1e-3, 1e-6}) {
        const Hierarchical<2> m(inputs::close_pairs(2, 2, gap), audited(by_quality(3), false, true));
        REQUIRE(m.status == Status::ok);
        CHECK(m.result.audit.quality.worst <= 2 * mediality);
    }
}
TEST_CASE("any arena size leaves a whole mesh of what was inserted, with lists and without") {
    const inputs::Points points = inputs::nested(2, 3, 8, 1e3);
    std::uint32_t partial = 0, whole = 0;
    for (std::size_t bytes = 0; bytes < 120000; bytes += 464) {
        Hierarchical<2> m(points, audited(by_hierarchy(2.5), true, bytes % 928 == 0), bytes);
        REQUIRE((m.status == Status::ok || m.status == Status::out_of_memory));
        if (m.status == Status::ok) CHECK(sound_worst(m) <= 2.5);
        if (m.state.cell_slots > 0) ++(m.status == Status::ok ? whole : partial);
    }
    CHECK(partial > 20);
    CHECK(whole > 20);
}

TEST_CASE_TEMPLATE_DEFINE("lists that run out end the job with a whole mesh of what was inserted", T, full_lists) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 150);
    std::uint32_t partial = 0;
    for (double bytes = 30000; bytes < (D < 5 ? 400000 : 2000000); bytes *= 1.1) {
        Hierarchical<D> m(points, audited(by_hierarchy(3), true, false), static_cast<std::size_t>(bytes));
        REQUIRE((m.status == Status::ok || m.status == Status::out_of_memory));
        if (m.status == Status::ok) break;
        if (m.state.cell_slots == 0) continue;
        CHECK(delaunay_violation<D>(m.store) == "");
        CHECK(m.block.arena.bytes_wanted() > 0);
        ++partial;
    }
    CHECK(partial > 3);
}
TEST_CASE_TEMPLATE_APPLY(full_lists, Dimensions<>);
