// Audits of quality: what is found from what a step has changed is what is found by looking at the whole mesh.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/dimensions.hpp"
#include "mesh/loop/aspect_rule.hpp"
#include "mesh/whole_audit.hpp"

using namespace netmesh;

namespace {

// Corners are solved for anew when the whole mesh is looked at.
void check_same(const QualityAudit& changed, const QualityAudit& whole) {
    CHECK(changed.meshes == whole.meshes);
    CHECK(changed.degree_max == whole.degree_max);
    CHECK(changed.worst == doctest::Approx(whole.worst).epsilon(1e-7));
    CHECK(changed.feature == doctest::Approx(whole.feature).epsilon(1e-12));
    CHECK(changed.cage == doctest::Approx(whole.cage).epsilon(1e-12));
    CHECK(changed.steiner == doctest::Approx(whole.steiner).epsilon(1e-12));
    CHECK(changed.input == doctest::Approx(whole.input).epsilon(1e-12));
    CHECK(changed.encroached == whole.encroached);
}

constexpr AuditTerms with_cages = {true, true, true}, without_steiner = {false, true, true};
constexpr AuditTerms all_terms[] = {
    {true, false, true}, {true, true, true}, {false, false, true}, {true, false, false}};

// Quality meshing by a plain rule that audits each step in both ways.
template <int D> class AuditedRule : public AspectRule<D, AuditedRule<D>> {
    using Base = AspectRule<D, AuditedRule<D>>;
    using Base::is_bad;
    using Base::store_;

public:
    AuditedRule(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result) {}

    bool may_be_bad(double corner2, const Vertex<D>& vertex) const { return is_bad(corner2, vertex.nearest2); }
    bool must_yield(const Split<D>& split, const NearestInput& nearest) const {
        return nearest.distance2 < split.empty2;
    }
    void queue_bad(CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (cell.radius2 < infinity && this->domain_.contains(cell.centre))
            this->queue_positions(cell, this->positions_of_bad(cell));
    }
#ifdef NETMESH_VALIDATE
    // It refines by corners inside of the domain alone, so cells may reach farther where they cross its sphere.
    const char* clean_violation() const { return nullptr; }
#endif
    void queue_new(const Cavity&, VertexId) {}
    Verdict judge(VertexId v, Split<D>* split) {
        Corner<D> corner;
        const bool fits = this->kernel_.visit_star(v, [&](CellId c) {
            const Cell<D>& cell = store_.cell(c);
            if (cell.radius2 < infinity && this->domain_.contains(cell.centre))
                corner.offer(cell.centre, distance2<D>(cell.centre, store_.point(v)), c);
        });
        if (!fits) return Verdict::out_of_memory;
        const double nearest2 = store_.vertex(v).nearest2;
        if (!is_bad(corner.distance2, nearest2)) return Verdict::good;
        this->split_towards(v, corner, this->wanted_distance(std::sqrt(nearest2), 1), split);
        return Verdict::bad;
    }
    Status insert_input(VertexId p, CellId from, bool cleaning) {
        step_.vertex = p;
        step_.cleaning = cleaning;
        return Base::insert_input(p, from, cleaning);
    }
    Status after_step() {
        if (step_.vertex == none) step_ = {store_.state.vertex_count - 1, store_.state.vertex_count - 1, true};
        if (step_.first_made == 0) step_.first_made = store_.state.vertex_count;
        WholeMesh<D> mesh(store_, {}, this->inputs_, this->domain_);
        for (std::size_t k = 0; k < 4; ++k) {
            const Status status =
                audit_quality<D>({store_, this->tree_, this->domain_, nullptr, all_terms[k]}, step_, &changed[k]);
            REQUIRE(status == Status::ok);
            mesh.add_to(step_, all_terms[k], &whole[k]);
        }
        bool marked = false;
        for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) marked |= store_.vertex(v).queued > 1;
        REQUIRE_FALSE(marked);
        step_ = {0, none, false};
        return Status::ok;
    }
    static inline QualityAudit changed[4], whole[4];

private:
    AuditStep step_ = {0, none, false};
};

// Inputs, Steiner points and cages put into a mesh by hand, step by step.
template <int D> struct ByHand {
    ByHand(const inputs::Points& points, double domain_factor)
        : count(static_cast<std::uint32_t>(points.size() / D)), block(std::size_t{1} << 24), store(block.arena, state),
          kernel(store, corner_error_max, VertexCells::kept) {
        Monitor monitor;
        InputReport input;
        std::uint32_t* order;
        REQUIRE(hierarchy.open(store, block.arena, count) == Status::ok);
        REQUIRE(take_input<D>(store, points.data(), count, 1, monitor, &input, &order) == Status::ok);
        REQUIRE(input.duplicates == 0);
        REQUIRE(tree.build(store, block.arena, count, true) == Status::ok);
        smallest_enclosing_ball<D>(store, count, domain);
        domain.radius = domain_factor * domain.enclosing_radius;
        REQUIRE(store.open_cells() == Status::ok);
        std::uint64_t steps = 0;
        REQUIRE(open_frame(store, tree, domain, figures<D>.frame_factor * domain.radius, &steps) == Status::ok);
        // take_input may have changed the order.
        by_row.resize(count);
        for (std::uint32_t v = 0; v < count; ++v) by_row[store.vertex(v).origin] = v;
        step = {state.vertex_count, none, false};
    }
    void insert(VertexId v) {
        Cavity cavity;
        REQUIRE(kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, state.last_cell), &cavity));
        REQUIRE(kernel.can_fill(cavity, 0));
        kernel.fill(cavity, v);
    }
    void insert_row(std::uint32_t row, std::uint32_t cage) {
        const VertexId v(by_row[row]);
        hierarchy.set(v, cage);
        insert(v);
        step.vertex = v;
    }
    void insert_steiner(const double* x, std::uint32_t near_row) {
        REQUIRE(store.has_room(0, 1, 0));
        const VertexId v = make_vertex<D>(store, x, by_row[near_row], Marker::steiner);
        insert(v);
        step.vertex = v;
        step.cleaning = true;
    }
    std::uint32_t new_cage(std::uint32_t row, double radius, std::uint32_t parent, inputs::Random& random) {
        const std::uint32_t centre = by_row[row], shell = state.vertex_count;
        const std::uint32_t d = hierarchy.make({VertexId(centre), 0, none}, radius, parent, shell);
        REQUIRE(store.has_room(0, shell_size_of(D), 0));
        hierarchy.set(centre, d);
        for (std::uint32_t i = 0; i < shell_size_of(D); ++i) {
            double x[D];
            for (int k = 0; k < D; ++k) {
                const double axis = k != static_cast<int>(i / 2) ? 0 : i % 2 == 0 ? 1 : -1;
                x[k] =
                    store.point(centre)[k] + shell_factor * radius * (axis + shell_jitter * (2 * random.uniform() - 1));
            }
            insert(make_vertex<D>(store, x, centre, Marker::exempt));
        }
        return d;
    }
    void release(std::uint32_t d) {
        const std::uint32_t shell = hierarchy.cage(d).shell;
        hierarchy.release(d);
        for (std::uint32_t v = shell; v < shell + shell_size_of(D); ++v) store.vertex(v).marker = Marker::steiner;
        note(d);
    }
    // Lets the ball that cells in the cage are clipped to grow.
    void grow(std::uint32_t d, double radii) {
        hierarchy.cage(d).clip = radii * hierarchy.cage(d).radius;
        note(d);
    }
    void note(std::uint32_t d) {
        notes.push_back({none, d});
        step.notes = notes.data();
        step.note_count = static_cast<std::uint32_t>(notes.size());
    }
    Status audit_changed(QualityAudit* audit, const AuditTerms& terms) {
        return audit_quality<D>({store, tree, domain, &hierarchy, terms}, step, audit);
    }
    WholeMesh<D> whole_mesh() {
        const Cage* const cages = hierarchy.cages();
        return {store, {cages, cages + hierarchy.made()}, count, domain};
    }
    void end_step() {
        REQUIRE(audit_changed(&changed, with_cages) == Status::ok);
        REQUIRE(audit_changed(&inputs_changed, without_steiner) == Status::ok);
        WholeMesh<D> mesh = whole_mesh();
        mesh.add_to(step, with_cages, &whole);
        mesh.add_to(step, without_steiner, &inputs_whole);
        exact = std::max(exact, mesh.exact_feature(with_cages));
        for (std::uint32_t d = 0; d < hierarchy.made(); ++d) REQUIRE(hierarchy.cage(d).next == none);
        step = {state.vertex_count, none, false};
        notes.clear();
        check_same(changed, whole);
        check_same(inputs_changed, inputs_whole);
    }
    std::uint32_t count;
    Block block;
    StoreState state = {};
    Store<D> store;
    InputTree<D> tree;
    Kernel<D> kernel;
    Domain<D> domain;
    Hierarchy<D> hierarchy;
    std::vector<std::uint32_t> by_row;
    AuditStep step;
    std::vector<AuditNote> notes;  // of the step
    QualityAudit changed = {}, whole = {}, inputs_changed = {}, inputs_whole = {};
    double exact = 0;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("an audit of what a step has changed finds what one of the whole mesh finds", T, plain) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 25, 8, 4, 3, 3};
    for (const inputs::Points& points :
         {inputs::uniform(D, sizes[D]), inputs::close_pairs(D, 2, D == 2 ? 1e-3 : 0.1), inputs::grid(D, 2)}) {
        Block block(std::size_t{1} << 24);
        StoreState state = {};
        Store<D> store(block.arena, state);
        Monitor monitor;
        MeshResult<D> result;
        const MeshRequest request = by_quality(D < 4 ? 3 : 8);
        for (std::size_t k = 0; k < 4; ++k) AuditedRule<D>::changed[k] = AuditedRule<D>::whole[k] = {};
        REQUIRE(mesh_by_rule<D, AuditedRule<D>>(store, points.data(), points.size() / D, request,
                                                {block.arena, monitor}, &result) == Status::ok);
        for (std::size_t k = 0; k < 4; ++k) {
            check_same(AuditedRule<D>::changed[k], AuditedRule<D>::whole[k]);
            CHECK(AuditedRule<D>::changed[k].meshes >= points.size() / D);
        }
        CHECK(AuditedRule<D>::changed[0].worst > 1);
        CHECK(AuditedRule<D>::changed[0].feature >= 1);
        CHECK(AuditedRule<D>::changed[3].feature == 0);
    }
}
TEST_CASE_TEMPLATE_APPLY(plain, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("with cages too, made, nested and released", T, cages) {
    constexpr int D = T::value;
    constexpr std::uint32_t levels = 3, each = D < 4 ? 6 : 3;
    for (std::uint64_t seed = 1; seed <= (D < 4 ? 6 : 2); ++seed) {
        const double ratio = seed % 2 == 0 ? 1e6 : 300;
        ByHand<D> m(inputs::nested(D, levels, each, ratio, seed), 1.5);
        inputs::Random random(seed);
        const auto place = [&](std::uint32_t row, double radius) {
            double x[D], squared;
            do {
                squared = 0;
                for (int k = 0; k < D; ++k) {
                    const double offset = radius * (2 * random.uniform() - 1);
                    squared += offset * offset;
                    x[k] = m.store.point(m.by_row[row])[k] + offset;
                }
            } while (!(squared < radius * radius) || !m.domain.contains(x));
            m.insert_steiner(x, row);
            m.end_step();
        };
        std::uint32_t cage[levels] = {none, none, none};
        double size = 1;
        for (std::uint32_t level = 0; level < levels; ++level, size /= ratio) {
            const std::uint32_t first = level * each;
            double reach = 0;
            for (std::uint32_t i = 0; i < each; ++i)
                reach =
                    std::max(reach, distance<D>(m.store.point(m.by_row[first]), m.store.point(m.by_row[first + i])));
            for (std::uint32_t i = 0; i < each; ++i) {
                if (level > 0 && i == 1)
                    cage[level] = m.new_cage(first, 1.01 * reach / cage_epsilon, cage[level - 1], random);
                m.insert_row(first + i, cage[level]);
                m.end_step();
            }
            // Points that the cage inside, which is to come, is to keep clear of are left out.
            for (int i = 0; i < 10; ++i) {
                double x[D], squared = 0, inner = 0;
                const double* const c = m.store.point(m.by_row[first]);
                for (int k = 0; k < D; ++k) {
                    x[k] = c[k] + reach * (2 * random.uniform() - 1);
                    squared += (x[k] - c[k]) * (x[k] - c[k]);
                    inner += x[k] * x[k];
                }
                if (!(squared < reach * reach) || inner < 0.09 * size * size || !m.domain.contains(x)) continue;
                m.insert_steiner(x, first);
                m.end_step();
            }
        }
        REQUIRE(m.hierarchy.live() == 2);
        // What is near a cage makes K largest for the cage's centre, in the domain around it.
        const double* const c = m.store.point(m.by_row[each]);
        std::uint32_t row = 0;
        for (std::uint32_t q = 1; q < each; ++q)
            if (distance<D>(c, m.store.point(m.by_row[q])) < distance<D>(c, m.store.point(m.by_row[row]))) row = q;
        const double* const q = m.store.point(m.by_row[row]);
        const double away = 1.2 * cage_clearance * m.hierarchy.cage(cage[1]).radius, before = m.changed.feature;
        double x[D];
        for (int k = 0; k < D; ++k) x[k] = c[k] + (q[k] - c[k]) * away / distance<D>(c, q);
        m.insert_steiner(x, each);
        m.end_step();
        if (ratio == 1e6) CHECK(m.changed.feature > 10 * before);
        CHECK(m.changed.cage > 0);
        CHECK(m.changed.encroached == 0);
        CHECK(m.exact >= m.changed.feature);
        CHECK(m.exact <= 4.0 / 3 * m.changed.feature);
        // A Steiner point beside the input that is farthest from a cage's centre: so near that its cell is worse than
        // all before as soon as it reaches out of the ball.
        const auto close_to_the_farthest = [&](std::uint32_t level) {
            const double* const centre = m.store.point(m.by_row[level * each]);
            std::uint32_t farthest = level * each;
            for (std::uint32_t q = farthest + 1; q < (level + 1) * each; ++q)
                if (distance<D>(centre, m.store.point(m.by_row[q])) >
                    distance<D>(centre, m.store.point(m.by_row[farthest])))
                    farthest = q;
            const double* const p = m.store.point(m.by_row[farthest]);
            for (int k = 0; k < D; ++k) x[k] = p[k] + (centre[k] - p[k]) * 0.03 / m.changed.worst;
            m.insert_steiner(x, farthest);
            m.end_step();
        };
        // The outer cage goes, the inner one stays; then that goes too. Before, their balls grow.
        for (const std::uint32_t level : {1u, 2u}) {
            close_to_the_farthest(level);
            const double less = m.changed.worst;
            for (const double radii : {0.55, 0.65}) {
                m.grow(cage[level], radii);
                m.end_step();
            }
            CHECK(m.changed.worst > less);
            m.release(cage[level]);
            place(level * each, 0.3 / (level == 1 ? ratio : ratio * ratio));
        }
        CHECK(m.hierarchy.live() == 0);
        CHECK(m.changed.worst > 1);
    }
}
// In 4D an input of those drawn lies in a cage that is made about others after it, which the mesher does not let
// happen.
TEST_CASE_TEMPLATE_APPLY(cages, Dimensions<2, 3>);

TEST_CASE_TEMPLATE_DEFINE("quality, feature sizes and insertion radii are bounded after every insertion", T, bounded) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 60, 20, 8};
    for (const inputs::Points& points :
         {inputs::uniform(D, sizes[D]), inputs::nested(D, 4, sizes[D] / 4, 1e3), inputs::geometric(D, 1e3, 10),
          inputs::geometric(D, 5, D == 2 ? 10 : 2), inputs::close_pairs(D, sizes[D] / 4, 1e-12), inputs::grid(D, 2)})
        for (const bool location : {false, true}) {
            Hierarchical<D> m(points, audited(by_hierarchy(3), location, true));
            REQUIRE(m.status == Status::ok);
            const QualityAudit& audit = m.result.audit.quality;
            CHECK(audit.meshes >= points.size() / D);
            CHECK(audit.meshes <= m.state.vertex_count - 2 * D);
            CHECK(audit.encroached == 0);
            const HierarchyQuality quality = m.quality();
            CHECK(found(quality.encroached) == "");
            CHECK(audit.worst >= quality.worst * (1 - 1e-7));
            CHECK(audit.worst < 400);
            CHECK(audit.degree_max >= D + 1);
            CHECK(audit.feature < 6);
            CHECK(audit.feature >= std::max({audit.cage, audit.steiner, audit.input}));
            CHECK(audit.cage <= cage_insertion_bound(D));
            CHECK((m.result.hierarchy.cages_made > 0) == (audit.cage > 0));
            CHECK(audit.input >= 1);
        }
}
TEST_CASE_TEMPLATE_APPLY(bounded, Dimensions<2, 4>);

// Each of 11 inputs is an eighth to a fifth as far from the last as the one before: cages about some of them are made,
// encroached and released, with the others beside their balls. Where cells reached out to the shell at once the ratio
// was 2e6.
TEST_CASE("the ball of a cage grows before the cage is released") {
    const inputs::Points chain = {-0.5205475671850174,  -0.8594094010434395, -0.4603595647169575,  -0.773499074751813,
                                  -0.43773134553132703, -0.7569505196917573, -0.44018396357075085, -0.754181723793028,
                                  -0.4399942210207192,  -0.7535637468249605, -0.44000267813584515, -0.7534418148681816,
                                  -0.43999850692401393, -0.7534229395780669, -0.4399965617362301,  -0.7534213659188822,
                                  -0.4399962416103239,  -0.7534214798081856, -0.43999622112675596, -0.7534213814930997,
                                  -0.43999620776506165, -0.7534213738562425, -0.45852830888515717, 0.8886798017007689,
                                  0.36351032150116147,  0.9315901707092675,  -0.2899077191546476,  0.9570546036536003};
    const Hierarchical<2> m(chain, audited(by_hierarchy(2.5), false, true));
    REQUIRE(m.status == Status::ok);
    CHECK(m.result.hierarchy.cages_released > 0);
    // Those after insertions are fewer: shells have none of their own.
    CHECK(m.result.audit.quality.meshes > m.state.vertex_count - 4 - 4 * m.result.hierarchy.cages_made);
    CHECK(m.result.audit.quality.worst < 400);
    CHECK(m.result.audit.quality.degree_max < 50);
}

// Refinement to 2.5 comes near to a cage whose own cell has a ratio of 43: the shell's cells came to 968 when it was
// released as it was.
TEST_CASE("the cell of a cage is good before the cage is released") {
    const inputs::Points points = {0.0,
                                   0.0,
                                   -0.42314245066450296,
                                   0.9060631691254416,
                                   0.6118379954399902,
                                   0.12078203966561352,
                                   -0.017972955552749564,
                                   -0.052261447052946816,
                                   -0.009545265200018785,
                                   -0.049232147350400365,
                                   -0.06699444110807351,
                                   -0.061381533630454,
                                   -0.0017854672251412615,
                                   -0.002491638516023474,
                                   -0.0004483411259562641,
                                   5.20864005043218e-05};
    const Hierarchical<2> m(points, audited(by_hierarchy(2.5), false, true));
    REQUIRE(m.status == Status::ok);
    CHECK(m.result.hierarchy.cages_released == 1);
    CHECK(m.result.audit.quality.worst < 400);
}

// When a cage is released its shell stays, and may be nearer to a neighbouring cage than what that lets come: all have
// been released that it encroaches on before the next vertex is inserted.
TEST_CASE_TEMPLATE_DEFINE("what was in a cage encroaches on others when it is released", T, heeded) {
    constexpr int D = T::value;
    std::uint32_t released = 0;
    for (std::uint64_t seed = 1; seed <= (D == 2 ? 40 : 4); ++seed) {
        const Hierarchical<D> m(inputs::close_pairs(D, D == 2 ? 30 : 15, D == 2 ? 0.008 : 0.02, seed),
                                audited(by_hierarchy(2.5), false, true));
        CHECK(m.status == Status::ok);
        CHECK(m.result.audit.quality.encroached == 0);
        CHECK(m.result.audit.quality.worst < 400);
        released += m.result.hierarchy.cages_released;
    }
    CHECK(released > 10);
}
TEST_CASE_TEMPLATE_APPLY(heeded, Dimensions<2, 3>);

TEST_CASE_TEMPLATE_DEFINE("all methods are audited, whatever they are for", T, methods) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, D == 2 ? 50 : D == 3 ? 20 : 8);
    const double tau = D < 4 ? 3 : 5;
    MeshRequest sized = by_quality(tau);
    sized.size.eps = 0.4;
    for (const MeshRequest& request :
         {by_quality(tau), by_quality(tau, 1, true), sized, by_hierarchy(tau), by_certificate({2.2, 0, 0, 0})}) {
        const Hierarchical<D> m(points, audited(request, false, true));
        REQUIRE(m.status == Status::ok);
        const QualityAudit& audit = m.result.audit.quality;
        CHECK(audit.meshes == m.state.vertex_count - 2 * D);  // no cages
        CHECK(audit.worst > 1);
        CHECK(audit.degree_max > D);
        CHECK(audit.feature >= std::max(audit.steiner, audit.input));
        CHECK(audit.steiner > 0);
        // Over-refinement goes below any share of the feature size.
        CHECK(audit.feature < 2 * tau / (tau - 2));
    }
}
TEST_CASE_TEMPLATE_APPLY(methods, Dimensions<2, 4>);

namespace {

// A finished mesh with cages, and what an audit needs besides.
template <int D> struct Planted : Hierarchical<D> {
    static constexpr double tau = D < 5 ? 3 : 8;
    Planted()
        : Hierarchical<D>(D < 5 ? inputs::nested(D, 3, D < 4 ? 12 : 4, 1e3) : inputs::close_pairs(D, 3, 0.03, 1),
                          by_hierarchy(tau)) {
        REQUIRE(this->status == Status::ok);
        const std::uint32_t count = this->result.hierarchy.cages, vertices = this->state.vertex_count;
        REQUIRE(count > 0);
        REQUIRE(tree.build(this->store, this->block.arena, this->inputs(), true) == Status::ok);
        REQUIRE(hierarchy.open(this->store, this->block.arena, this->inputs()) == Status::ok);
        domains.resize(vertices);
        std::vector<double> ratios(vertices);
        HierarchyQuality quality;
        REQUIRE(measure_hierarchy(this->store,
                                  {this->result.cages, count, this->result.domain, ratios.data(), domains.data()},
                                  this->block.arena, &quality) == Status::ok);
        for (std::uint32_t d = 0; d < count; ++d) {
            const Cage& cage = this->result.cages[d];
            hierarchy.make({VertexId(cage.centre), cage.nearest2, none}, cage.radius, cage.parent, cage.shell);
        }
        for (std::uint32_t p = 0; p < this->inputs(); ++p) hierarchy.set(p, domains[p]);
    }
    Status audit(const AuditStep& step, QualityAudit* found) {
        return audit_quality<D>({this->store, tree, this->result.domain, &hierarchy, with_cages}, step, found);
    }
    QualityAudit after(const AuditStep& step) {
        QualityAudit found = {};
        REQUIRE(audit(step, &found) == Status::ok);
        return found;
    }
    Cage& last_cage() { return hierarchy.cage(hierarchy.made() - 1); }
    void move_to(std::uint32_t v, const double* x, double offset) {
        for (int k = 0; k < D; ++k) this->store.vertex(v).x[k] = x[k] + offset;
    }
    InputTree<D> tree;
    Hierarchy<D> hierarchy;
    std::vector<std::uint32_t> domains;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("planted violations of the invariants are found", T, planted) {
    constexpr int D = T::value;
    Planted<D> m;
    const std::uint32_t all = m.state.vertex_count;
    Cage& cage = m.last_cage();
    const AuditStep at_shell = {all, cage.shell, true}, whole_shell = {cage.shell, none, false};
    {
        const QualityAudit sound = m.after(whole_shell);
        REQUIRE(sound.encroached == 0);
        REQUIRE(sound.worst <= m.tau);
        REQUIRE(sound.cage <= cage_insertion_bound(D));
        REQUIRE(sound.feature < 10);
        REQUIRE(m.after(at_shell).encroached == 0);
    }
    SUBCASE("a Steiner point too close to an input") {
        const auto neighbour_input = [&](VertexId v) {
            VertexId input = none;
            visit_star(m.store, v, [&](CellId c) {
                for (const VertexId w : m.store.cell(c).vertex)
                    if (m.store.vertex(w).marker == Marker::input && m.domains[w] == none) input = w;
            });
            return input;
        };
        VertexId v(m.inputs() + 2 * D), input = none;
        for (; v < all && input == none; ++v)
            if (m.store.vertex(v).marker == Marker::steiner && m.domains[v] == none) input = neighbour_input(v);
        CHECK((input != none || D >= 4));
        if (input != none) {
            --v.index;
            m.move_to(v, m.store.point(input), 1e-4);
            const QualityAudit audit = m.after({all, v, true});
            CHECK(audit.feature > 20);
            CHECK(audit.steiner > 20);
            CHECK(audit.worst > 20);
        }
    }
    SUBCASE("a shell that is not where it belongs") {
        VertexId inside = none;
        visit_star(m.store, VertexId(cage.shell), [&](CellId c) {
            for (const VertexId w : m.store.cell(c).vertex)
                if (m.store.vertex(w).marker != Marker::exempt && m.domains[w] == m.hierarchy.made() - 1) inside = w;
        });
        REQUIRE(inside != none);
        m.move_to(cage.shell, m.store.point(inside), 1e-3 * cage.radius);
        const QualityAudit audit = m.after(whole_shell);
        CHECK(audit.cage > cage_insertion_bound(D));
        CHECK(audit.encroached == 1);
    }
    SUBCASE("a cage without its clearance") {
        cage.radius = square_root(cage.nearest2) / (0.9 * cage_clearance);
        CHECK(m.after(at_shell).encroached == 1);
    }
    SUBCASE("a new cage that sticks out of the one around it") {
        if (cage.parent != none) {
            // All else about it is right.
            Cage& around = m.hierarchy.cage(cage.parent);
            around.radius = 0.9 * distance<D>(m.store.point(around.centre), m.store.point(cage.centre)) + cage.radius;
            CHECK(m.after(whole_shell).encroached == 1);
        }
    }
    SUBCASE("an input in the gap within a cage") {
        std::uint32_t p = 0;
        while (p == cage.centre || m.domains[p] != m.hierarchy.made() - 1) ++p;
        REQUIRE(p < m.inputs());
        cage.radius = distance<D>(m.store.point(p), m.store.point(cage.centre)) / 0.7;
        CHECK(m.after({all, p, false}).encroached == 1);
    }
    SUBCASE("a cage that was released counts no more") {
        const std::uint32_t last = m.hierarchy.made() - 1;
        for (std::uint32_t v = cage.shell; v < cage.shell + shell_size_of(D); ++v)
            m.store.vertex(v).marker = Marker::steiner;
        m.hierarchy.release(last);
        const AuditNote note = {none, last};
        const QualityAudit audit = m.after({all, none, false, &note, 1});
        CHECK(audit.worst > m.tau);  // its shell is not where the domain around wants vertices
        CHECK(audit.encroached == 0);
    }
    SUBCASE("any gap: the same figures, or none") {
        const QualityAudit expected = m.after(whole_shell);
        const std::size_t low = m.block.arena.low_mark(), top = m.block.arena.high_mark();
        bool fits = false;
        for (double bytes = 16; bytes < static_cast<double>(top - low); bytes *= 1.1) {
            m.block.arena.release_low(top - static_cast<std::size_t>(bytes) / 16 * 16);
            QualityAudit audit = {};
            const Status status = m.audit(whole_shell, &audit);
            m.block.arena.release_low(low);
            REQUIRE((status == Status::ok || (status == Status::out_of_memory && !fits)));
            bool marked = false;
            for (std::uint32_t v = 0; v < all; ++v) marked |= m.store.vertex(v).queued != 0;
            REQUIRE_FALSE(marked);
            for (std::uint32_t d = 0; d < m.hierarchy.made(); ++d) REQUIRE(m.hierarchy.cage(d).next == none);
            if (status != Status::ok) continue;
            fits = true;
            CHECK(audit.worst == expected.worst);
            CHECK(audit.feature == expected.feature);
            CHECK(audit.degree_max == expected.degree_max);
            if (bytes > 4e5) break;  // enough
        }
        CHECK(fits);
    }
}
TEST_CASE_TEMPLATE_APPLY(planted, Dimensions<2, 3>);
