// Audits of quality with cages of the thesis: after each step their figures are those that plain loops over the whole
// mesh find, and faults of a mesh or of what keeps it are seen.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"
#include "mesh/cage_lemmas.hpp"
#include "mesh/cages/any_cage.hpp"
#include "mesh/loop/thesis_cages.hpp"
#include "mesh/loop/thesis_shells.hpp"
#include "numerics/random.hpp"

using namespace netmesh;

namespace {

MeshRequest asked(double tau, bool finish, std::uint64_t seed = 1) {
    MeshRequest request = audited(by_hierarchy(tau, finish, seed), false, true);
    request.cages = CageKind::thesis;
    return request;
}

// The rule, judged after each step; what its audit says by then is looked at when the next step ends.
template <int D> class Judged : public ThesisCages<D, Judged<D>> {
    using Base = ThesisCages<D, Judged<D>>;

public:
    static inline lemmas::Figures whole;
    static inline std::uint32_t meshes, largest_cage_step, yielded;

    Judged(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result) {
        whole = {};
        meshes = yielded = 0;
    }
    Status begin() {
        own_ = none;
        first_ = this->store_.state.vertex_count;
        return Base::begin();
    }
    Status insert_input(VertexId p, CellId from, bool cleaning) {
        own_ = p;
        cleaning_ = cleaning;
        return Base::insert_input(p, from, cleaning);
    }
    void note_steiner(VertexId v, const NearestInput&) {
        own_ = v;
        cleaning_ = true;
    }
    Status after_step() {
        check_last();
        const Status status = Base::after_step();
        if (status == Status::ok) look();
        own_ = none;
        return status;
    }
    static void check(const QualityAudit& audit) {
        CHECK(audit.meshes == meshes);
        CHECK(audit.encroached == 0);
        CHECK(!whole.encroached);
        CHECK(audit.degree_max == whole.degree);
        CHECK(audit.worst == doctest::Approx(whole.worst).epsilon(1e-6));
        CHECK(audit.feature == doctest::Approx(whole.feature).epsilon(1e-9));
        CHECK(audit.cage == doctest::Approx(whole.cage).epsilon(1e-9));
        CHECK(audit.steiner == doctest::Approx(whole.steiner).epsilon(1e-9));
        CHECK(audit.input == doctest::Approx(whole.input).epsilon(1e-9));
    }

private:
    void check_last() {
        if (meshes == 0) return;
        MeshAudit audit;
        this->observers_.report(&audit);
        INFO("after step " << meshes);
        check(audit.quality);
    }
    void look() {
        ++meshes;
        std::vector<std::uint32_t> fresh;
        seen_.resize(this->inputs_);
        for (std::uint32_t p = 0; p < this->inputs_; ++p) {
            if (this->store_.vertex(p).cell == none || seen_[p]) continue;
            seen_[p] = true;
            fresh.push_back(p);
            yielded += p != own_ && meshes > 1;
        }
        for (; first_ < this->store_.state.vertex_count; ++first_) fresh.push_back(first_);
        std::vector<lemmas::Ball> cages;
        for (std::uint32_t d = 0; d < this->hierarchy_.made(); ++d)
            if (this->hierarchy_.is_live(d))
                cages.push_back({this->hierarchy_.cage(d).centre, this->hierarchy_.cage(d).radius});
        lemmas::Table table;
        lemmas::Judge<D> judge(this->store_, cages, this->request_.tau, false, &table);
        const lemmas::Figures figures = judge.figures(fresh, own_, cleaning_);
        whole.join(figures);
        whole.encroached |= figures.encroached;
    }
    std::uint32_t own_ = none, first_ = 0;
    bool cleaning_ = false;
    std::vector<bool> seen_;
};

template <int D, class Rule> struct Audited {
    Audited(const inputs::Points& points, const MeshRequest& request)
        : block(std::size_t{1} << 26), store(block.arena, state) {
        status =
            mesh_by_rule<D, Rule>(store, points.data(), points.size() / D, request, {block.arena, monitor}, &result);
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Monitor monitor;
    MeshResult<D> result = {};
    Status status;
};

// Three points each, of which the third stands where a shell vertex of the cage of the other two has its place.
inputs::Points shells_yield() {
    inputs::Points points;
    for (int turn = 0; turn < 8; ++turn) {
        const double near = turn % 2 == 0 ? 1e-4 : -1e-4, away = 0.64 * 1.125 / 0.3 * 1.02 * 1e-4;
        const double far = turn / 2 % 2 == 0 ? away : -away, x = 3 * (turn % 3), y = 3 * (turn / 3);
        const bool upright = turn >= 4;
        for (const double c : {x, y, x + (upright ? 0 : near), y + (upright ? near : 0), x + (upright ? far : 0),
                               y + (upright ? 0 : far)})
            points.push_back(c);
    }
    return points;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("audits with cages of the thesis find what looking at the whole mesh finds", T, whole_mesh) {
    constexpr int D = T::value;
    std::uint32_t released = 0, most_cages = 0;
    std::vector<inputs::Points> families;
    const char* const asked_for = std::getenv("NETMESH_AUDIT_SEEDS");  // by hand: how many
    for (std::uint64_t seed = 1; seed <= (asked_for != nullptr ? std::strtoull(asked_for, nullptr, 10) : 1); ++seed) {
        std::vector<inputs::Points> more;
        if (D == 2)
            more = {inputs::uniform(D, 30, seed),
                    inputs::nested(D, 3, 5, 100, seed),
                    inputs::geometric(D, 1e3, 4, seed),
                    inputs::geometric(D, 30, 8, seed),
                    inputs::close_pairs(D, 4, 1e-3, seed),
                    inputs::clusters(D, 20, seed),
                    inputs::nested(D, 2, 4, 1e5, 30 + seed),
                    inputs::grid(D, 3)};
        else if (D == 3)
            more = {inputs::uniform(D, 6, seed), inputs::geometric(D, 40, 3, seed),
                    inputs::close_pairs(D, 2, 1e-2, seed)};
        else
            more = {inputs::close_pairs(D, 1, 1, seed)};
        families.insert(families.end(), more.begin(), more.end());
    }
    for (const inputs::Points& points : families)
        for (const bool finish : {false, true}) {
            if (finish && D == 4) continue;
            Audited<D, Judged<D>> mesh(points, asked(D == 2 ? 5 : 7, finish));
            REQUIRE(mesh.status == Status::ok);
            Judged<D>::check(mesh.result.audit.quality);
            CHECK(mesh.result.audit.quality.meshes >= points.size() / D);
            CHECK(mesh.result.audit.quality.cage <= cage_insertion_bound(D, CageKind::thesis));
            released += mesh.result.hierarchy.cages_released;
            most_cages = std::max(most_cages, mesh.result.hierarchy.cages_made);
            // What it watches it does not change.
            MeshRequest request = asked(D == 2 ? 5 : 7, finish);
            request.audit_quality = false;
            const Meshed<D> plain(points, request);
            REQUIRE(plain.status == Status::ok);
            REQUIRE(plain.state.vertex_count == mesh.state.vertex_count);
            bool same = true;
            for (std::uint32_t v = 0; v < plain.state.vertex_count; ++v)
                for (int k = 0; k < D; ++k) same &= plain.store.point(v)[k] == mesh.store.point(v)[k];
            CHECK(same);
        }
    if (D < 4) CHECK(released > 0);
    if (D < 4) CHECK(most_cages > 2);
}
TEST_CASE_TEMPLATE_APPLY(whole_mesh, Dimensions<2, 4>);

TEST_CASE("inputs that shells yield to are audited as vertices of the shell") {
    std::uint32_t yielded = 0;
    for (std::uint64_t seed = 0; seed < 3; ++seed)
        for (const bool finish : {false, true}) {
            Audited<2, Judged<2>> mesh(shells_yield(), asked(6, finish, seed));
            REQUIRE(mesh.status == Status::ok);
            Judged<2>::check(mesh.result.audit.quality);
            yielded += Judged<2>::yielded;
        }
    CHECK(yielded > 0);
}

namespace {

constexpr double shell_of_pair = ThesisCage::shell_factor * ThesisCage::slack / ThesisCage::epsilon;

std::array<double, 2> ring_place(std::uint32_t k) {
    std::array<double, 2> x;
    CageTemplate<2>::point(k, x.data());
    return x;
}
// A pair 1 apart about 0, so that a cage is made there and its shell is shell_of_pair away, and inputs that keep the
// outermost cage away. `ring`: what stands near places of that shell. In another order each turn.
inputs::Points pair_with(const std::vector<std::array<double, 2>>& ring, std::uint64_t turn) {
    std::vector<std::array<double, 2>> all = {{0, 0}, {0, 0}, {1000, 0}, {-1000, 0}, {0, 1000}, {0, -1000}};
    const std::array<double, 2> axis = ring_place(turn % 16);
    all[1] = axis;
    for (const auto& x : ring)
        all.push_back(
            {shell_of_pair * (axis[0] * x[0] - axis[1] * x[1]), shell_of_pair * (axis[1] * x[0] + axis[0] * x[1])});
    for (std::size_t i = all.size(); i-- > 1;) std::swap(all[i], all[mix64(turn << 8 | i) % (i + 1)]);
    inputs::Points points;
    for (const auto& x : all) points.insert(points.end(), x.begin(), x.end());
    return points;
}
// In how many orders the pair comes before the ring, which the shell then yields to.
int audit_yielding(const std::vector<std::array<double, 2>>& ring, std::uint64_t turns) {
    int found = 0;
    for (std::uint64_t turn = 0; turn < turns; ++turn) {
        Audited<2, Judged<2>> mesh(pair_with(ring, turn), asked(6, false, turn));
        REQUIRE(mesh.status == Status::ok);
        Judged<2>::check(mesh.result.audit.quality);
        found += Judged<2>::yielded >= ring.size();
    }
    return found;
}

}  // namespace

// Of all that is inserted as a shell, the second of these inputs has its second input the farthest away for its nearest
// neighbour: that is why it is not in its place.
TEST_CASE("the worst vertex of a shell may be an input that it yields to") {
    std::array<double, 2> moved = ring_place(5);
    const std::array<double, 2> out = moved;
    moved[0] += 0.053 * out[1] + 0.015 * out[0];
    moved[1] += -0.053 * out[0] + 0.015 * out[1];
    CHECK(audit_yielding({ring_place(8), moved}, 40) > 0);
}

namespace {

// When a cage is released, two vertices of its inside, neither of which is beside its shell or anything new, come close
// to one another behind the mesher's back.
template <int D> class Secret : public ThesisCages<D, Secret<D>> {
    using Base = ThesisCages<D, Secret<D>>;

public:
    static inline double before, after;  // worst aspect ratio, before that and in the audit after it
    static inline bool is_done;

    Secret(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result) {
        before = after = 0;
        is_done = false;
    }
    Status after_step() {
        MeshAudit audit;
        this->observers_.report(&audit);
        after = audit.quality.worst;
        if (is_done) return Status::cancelled;
        const Status status = Base::after_step();
        if (status != Status::ok) return status;
        before = after;
        for (std::uint32_t d = 1; d < live_.size() && !is_done; ++d)
            if (live_[d] && !this->hierarchy_.is_live(d)) is_done = bring_together(this->hierarchy_.cage(d));
        live_.assign(this->hierarchy_.made(), false);
        for (std::uint32_t d = 0; d < live_.size(); ++d) live_[d] = this->hierarchy_.is_live(d);
        first_ = this->store_.state.vertex_count;
        return status;
    }

private:
    bool bring_together(const Cage& cage) {
        const Store<D>& store = this->store_;
        // Inside of it, and with a ball about it that has no place for a shell or what is beyond.
        const auto is_hidden = [&](std::uint32_t v) {
            if (!is_inside<D>(store, cage, store.point(v))) return false;
            for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
                const Cell<D>& cell = store.cell(c);
                if (!store.is_live(c) ||
                    std::find(cell.vertex, cell.vertex + D + 1, VertexId(v)) == cell.vertex + D + 1)
                    continue;
                for (const VertexId w : cell.vertex)
                    if (w == none || w >= first_ || is_by_shell(AnyStore(store), cage, w) ||
                        !is_inside<D>(store, cage, store.point(w)))
                        return false;
            }
            return true;
        };
        for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
            const VertexId v = store.cell(c).vertex[0], w = store.cell(c).vertex[1];
            if (!store.is_live(c) || v == cage.centre || v == none || w == none ||
                store.vertex(v).marker == Marker::exempt || store.vertex(w).marker == Marker::exempt || !is_hidden(v) ||
                !is_hidden(w))
                continue;
            double* const x = this->store_.vertex(v).x;
            for (int k = 0; k < D; ++k) x[k] = store.point(w)[k] + 1e-6 * (x[k] - store.point(w)[k]);
            return true;
        }
        return false;
    }
    std::vector<bool> live_;
    std::uint32_t first_ = 0;
};

}  // namespace

#ifndef NETMESH_VALIDATE  // which stops the program when it sees the fault
TEST_CASE("audits look at all that is in a cage when it is released") {
    int planted = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        for (const double ratio : {100.0, 1e4}) {
            Audited<2, Secret<2>> mesh(inputs::nested(2, 3, 5, ratio, seed), asked(5, true));
            if (!Secret<2>::is_done) continue;
            planted++;
            CHECK(mesh.status != Status::ok);
            CHECK(Secret<2>::before < 1e4);
            CHECK(Secret<2>::after > 1e5);
        }
    CHECK(planted > 0);
}
#endif

namespace {

// It sees no encroachment from outside, so nothing is ever released.
template <int D> class Blind : public ThesisCages<D, Blind<D>> {
public:
    using ThesisCages<D, Blind<D>>::ThesisCages;
    void update_distances(const Cavity& cavity, VertexId v) { this->update_nearest(cavity, v); }
};
// The second vertex of each shell is elsewhere.
template <int D> class Crooked : public ThesisCages<D, Crooked<D>> {
    using Base = ThesisCages<D, Crooked<D>>;

public:
    using Base::Base;
    Status after_step() {
        const Status status = Base::after_step();
        const std::uint32_t made = this->hierarchy_.made();
        if (status != Status::ok || made < 2 || is_done_) return status;
        is_done_ = true;
        const std::uint32_t v = this->hierarchy_.cage(made - 1).shell + 1;
        const double* const centre = this->store_.point(this->hierarchy_.cage(made - 1).centre);
        for (int k = 0; k < D; ++k) this->store_.vertex(v).x[k] += 0.3 * (centre[k] - this->store_.point(v)[k]);
        return status;
    }

private:
    bool is_done_ = false;
};

// A mesh with cages, and what an audit needs besides.
template <int D> struct Planted : Meshed<D> {
    static constexpr double tau = 5;
    Planted() {
        MeshRequest request = asked(tau, false);
        REQUIRE(this->mesh(inputs::nested(D, 3, D == 2 ? 10 : 12, 1e4), request) == Status::ok);
        const std::uint32_t count = this->result.hierarchy.cages, vertices = this->state.vertex_count;
        REQUIRE(count > 2);
        REQUIRE(tree.build(this->store, this->block.arena, this->inputs(), true) == Status::ok);
        REQUIRE(hierarchy.open(this->store, this->block.arena, this->inputs()) == Status::ok);
        for (std::uint32_t d = 0; d < count; ++d) {
            const Cage& cage = this->result.cages[d];
            hierarchy.make({VertexId(cage.centre), cage.nearest2, none}, cage.radius, cage.parent, cage.shell);
        }
        for (std::uint32_t v = 0; v < vertices; ++v) {
            std::uint32_t within = none;
            for (std::uint32_t d = 0; d < count; ++d)
                if (is_inside<D>(this->store, this->result.cages[d], this->store.point(v)) &&
                    (within == none || this->result.cages[d].radius < this->result.cages[within].radius))
                    within = d;
            domains.push_back(within);
            if (v < this->inputs()) hierarchy.set(v, within);
        }
    }
    Status audit(const AuditStep& step, QualityAudit* found) {
        return audit_quality<D>(
            {this->store, tree, this->result.domain, &hierarchy, {true, true, true}, CageKind::thesis}, step, found);
    }
    QualityAudit after(const AuditStep& step) {
        QualityAudit found = {};
        found.outermost_features = true;  // or everything is looked at
        REQUIRE(audit(step, &found) == Status::ok);
        return found;
    }
    // Everything behind the frame counts as new, and so does the step's own vertex.
    AuditStep whole_mesh(std::uint32_t vertex = none) { return {this->inputs() + 2 * D, vertex, true}; }
    std::uint32_t last() { return hierarchy.made() - 1; }
    Cage& last_cage() { return hierarchy.cage(last()); }
    // A neighbour v of w with these markers and this relation.
    template <class Fits> std::pair<std::uint32_t, std::uint32_t> neighbours(Marker v, Marker w, Fits&& fits) const {
        for (std::uint32_t c = 0; c < this->state.cell_slots; ++c)
            for (const VertexId a : this->store.cell(c).vertex)
                for (const VertexId b : this->store.cell(c).vertex)
                    if (this->store.vertex(a).marker == v && this->store.vertex(b).marker == w && fits(a, b))
                        return {a, b};
        REQUIRE(false);
        return {};
    }
    void move(std::uint32_t v, const double* to, double share) {
        double* const x = this->store.vertex(v).x;
        for (int k = 0; k < D; ++k) x[k] = to[k] + share * (x[k] - to[k]);
    }
    InputTree<D> tree;
    Hierarchy<D> hierarchy;
    std::vector<std::uint32_t> domains;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("a mesher that makes faults with cages of the thesis is stopped by its audit", T, stopped) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::close_pairs(D, D == 2 ? 6 : 10, 1e-4);
    CHECK(Meshed<D>(points, asked(7, true)).status == Status::ok);
    CHECK(Audited<D, Blind<D>>(points, asked(7, true)).status == Status::internal);
    CHECK(Audited<D, Crooked<D>>(points, asked(7, false)).status == Status::internal);
}
TEST_CASE_TEMPLATE_APPLY(stopped, Dimensions<2, 3>);

TEST_CASE_TEMPLATE_DEFINE("planted violations of whole cells and cages of the thesis are found", T, planted_thesis) {
    constexpr int D = T::value;
    Planted<D> m;
    const double bound = cage_insertion_bound(D, CageKind::thesis);
    Cage& cage = m.last_cage();
    const QualityAudit sound = m.after(m.whole_mesh());
    REQUIRE(sound.encroached == 0);
    REQUIRE(sound.worst <= m.tau * (1 + 1e-6));
    REQUIRE(sound.worst > 2);
    REQUIRE(sound.feature < 40);
    SUBCASE("a vertex in the clearance of a cage") {
        const auto [v, w] = m.neighbours(Marker::steiner, Marker::exempt, [&](std::uint32_t a, std::uint32_t b) {
            return m.domains[b] != none && m.domains[b] != 0 && m.domains[a] == m.hierarchy.cage(m.domains[b]).parent;
        });
        const Cage& around = m.hierarchy.cage(m.domains[w]);
        const double* const centre = m.store.point(around.centre);
        const double radii = distance<D>(m.store.point(v), centre) / around.radius;
        CHECK(radii > ThesisCage::clearance);
        m.move(v, centre, 1.001 * ThesisCage::clearance / radii);
        CHECK(m.after(m.whole_mesh(v)).encroached == 0);
        m.move(v, centre, 0.998);
        CHECK(m.after(m.whole_mesh(v)).encroached == 1);
    }
    SUBCASE("a vertex of another shell in the clearance of a cage") {
        const auto [v, w] = m.neighbours(Marker::steiner, Marker::exempt, [&](std::uint32_t a, std::uint32_t b) {
            return m.domains[b] != none && m.domains[b] != 0 && m.domains[a] == m.hierarchy.cage(m.domains[b]).parent;
        });
        const Cage& around = m.hierarchy.cage(m.domains[w]);
        const double* const centre = m.store.point(around.centre);
        m.store.vertex(v).marker = Marker::exempt;
        const AuditStep step = {m.state.vertex_count, v, true};
        m.move(v, centre, 1.001 * ThesisCage::clearance * around.radius / distance<D>(m.store.point(v), centre));
        CHECK(m.after(step).encroached == 0);
        m.move(v, centre, 0.998);
        CHECK(m.after(step).encroached == 1);
    }
    SUBCASE("the ball of a domain does not cut cells") {
        std::uint32_t judged = 0;
        for (std::uint32_t v = m.inputs() + 2 * D; v < m.state.vertex_count; ++v) {
            const std::uint32_t d = m.domains[v];
            if (d == none || m.store.vertex(v).marker != Marker::steiner) continue;
            Cage& own = m.hierarchy.cage(d);
            const double* const centre = m.store.point(own.centre);
            double far = 0, out = 0, near = infinity;  // corners from the centre of the domain and from v, neighbours
            bool bounded = true;
            for (std::uint32_t c = 0; c < m.state.cell_slots; ++c) {
                const Cell<D>& cell = m.store.cell(c);
                if (std::find(cell.vertex, cell.vertex + D + 1, VertexId(v)) == cell.vertex + D + 1) continue;
                bounded &= !m.store.is_ghost(c) && cell.radius2 < infinity;
                const double corner = distance<D>(cell.centre, m.store.point(v));
                if (corner > out) out = corner, far = distance<D>(cell.centre, centre);
                for (const VertexId u : cell.vertex)
                    if (u != none && u != v) near = std::min(near, distance<D>(m.store.point(u), m.store.point(v)));
            }
            const double radius = own.radius, least = distance<D>(m.store.point(v), centre);
            if (!bounded || !(far > 1.01 * least)) continue;
            judged++;
            own.radius = 0.5 * (far + least);  // v is inside, its farthest corner is not
            CHECK(m.after({m.state.vertex_count, v, true}).worst >= 2 * out / near * (1 - 1e-9));
            own.radius = radius;
        }
        CHECK(judged > 10);
    }
    SUBCASE("a Steiner point too close to an input") {
        const auto [v, w] = m.neighbours(Marker::steiner, Marker::input, [&](std::uint32_t a, std::uint32_t b) {
            return m.domains[a] == m.domains[b];
        });
        m.move(v, m.store.point(w), 1e-4);
        const QualityAudit audit = m.after(m.whole_mesh(v));
        CHECK(audit.steiner > 40);
        CHECK(audit.feature > 40);
        CHECK(audit.worst > 100);
    }
    SUBCASE("a shell vertex that is not where it belongs") {
        for (int k = 0; k < D; ++k) m.store.vertex(cage.shell).x[k] += 0.5 * cage.radius;
        CHECK(m.after(m.whole_mesh()).encroached == 1);
    }
    SUBCASE("two vertices of a shell are next to one another") {
        for (int k = 0; k < D; ++k) {
            const double y = m.store.point(cage.shell)[k];
            m.store.vertex(cage.shell + 1).x[k] = y + 1e-2 * (m.store.point(cage.shell + 1)[k] - y);
        }
        CHECK(m.after(m.whole_mesh()).cage > bound);
    }
    SUBCASE("a cage without its clearance") {
        cage.radius = square_root(cage.nearest2) / (0.98 * ThesisCage::clearance);
        CHECK(m.after(m.whole_mesh()).encroached == 1);
    }
    SUBCASE("an input between e r and r that stands in for no shell vertex") {
        std::uint32_t p = 0;
        while (p == cage.centre || m.domains[p] != m.last()) ++p;
        REQUIRE(p < m.inputs());
        cage.radius = distance<D>(m.store.point(p), m.store.point(cage.centre)) / 0.45;
        CHECK(m.after({m.state.vertex_count, p, false}).encroached == 1);
    }
    SUBCASE("a cage that sticks out of the one around it") {
        Cage& around = m.hierarchy.cage(cage.parent);
        around.radius = 0.9 * distance<D>(m.store.point(around.centre), m.store.point(cage.centre)) + cage.radius;
        if (around.centre != cage.centre) CHECK(m.after(m.whole_mesh()).encroached == 1);
    }
    SUBCASE("a shell that is released has cells like others") {
        for (std::uint32_t k = 0; k < CageTemplate<D>::size; ++k)
            m.store.vertex(cage.shell + k).marker = Marker::steiner;
        const AuditNote note = {none, m.last()};
        const AuditStep nothing = {m.state.vertex_count, none, false};
        AuditStep step = nothing;
        step.notes = &note;
        step.note_count = 1;
        CHECK(m.after(nothing).worst == 0);
        const double worst = m.after(step).worst;
        CHECK(worst > 2);
        m.hierarchy.release(m.last());
        CHECK(m.after(step).worst >= worst);
    }
    SUBCASE("any gap: the same figures, or none") {
        const std::size_t low = m.block.arena.low_mark(), top = m.block.arena.high_mark();
        bool fits = false;
        for (double bytes = 16; bytes < static_cast<double>(top - low) && !fits; bytes *= 1.2) {
            m.block.arena.release_low(top - static_cast<std::size_t>(bytes) / 16 * 16);
            QualityAudit audit = {};
            audit.outermost_features = true;
            const Status status = m.audit(m.whole_mesh(), &audit);
            m.block.arena.release_low(low);
            REQUIRE((status == Status::ok || status == Status::out_of_memory));
            bool marked = false;
            for (std::uint32_t v = 0; v < m.state.vertex_count; ++v) marked |= m.store.vertex(v).queued != 0;
            REQUIRE_FALSE(marked);
            for (std::uint32_t d = 0; d < m.hierarchy.made(); ++d) REQUIRE(m.hierarchy.cage(d).next == none);
            fits = status == Status::ok;
            if (fits) CHECK(audit.worst == sound.worst);
            if (fits) CHECK(audit.feature == sound.feature);
        }
        CHECK(fits);
    }
}
TEST_CASE_TEMPLATE_APPLY(planted_thesis, Dimensions<2, 3>);
