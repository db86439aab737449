// The certified ratio by scale against the truth, GUDHI's exact alpha complexes: on random and nasty sets no bar of a
// diagram is farther from the truth than the curve allows at the scales of its birth and death. NETMESH_SCALE_SETS sets
// (40), each by one of the filters and kinds of mesh in turn; and as many for which fits choose scales of interest.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <set>
#include <string>

#include "common/session.hpp"
#include "oracle/log_distance.hpp"

namespace {

Diagram truth_of(int dim, const inputs::Points& points) {
    Diagram truth;
    for (const GudhiAlpha::Bar& bar : GudhiAlpha(dim, points).bars)
        if (bar.birth < bar.death) truth[static_cast<std::uint32_t>(bar.degree)].push_back({bar.birth, bar.death});
    return truth;
}

// What 0.1.0 said, sqrt(psi(phi(a)) / a), in steps that begin at every birth and death too.
Curve old_curve(const Session& session, const Diagram& truth) {
    Curve old;
    std::set<double> scales;
    const Curve now = curve(session);
    for (const netmesh_scale_step& step : now.steps) scales.insert(step.from);
    for (const Diagram& bars : {diagram(session), truth})
        for (const auto& [degree, list] : bars)
            for (const auto& [birth, death] : list) scales.insert({birth, death});
    for (const double a : scales) {
        netmesh_scale_step step = {0, a, 0, HUGE_VAL, 0, 1, 0};
        for (std::size_t i = 0; i < now.steps.size() && now.steps[i].from <= a && a > 0; ++i)
            step.ratio = std::sqrt(std::max(now.steps[i].reach, a) / a);
        if (a > 0 && a < HUGE_VAL) old.steps.push_back(step);
    }
    return old;
}

struct Way {
    double tau = 0, ratio = 0;  // of the mesh; 0: the default, none
    const netmesh_filter* filter = &netmesh_filter_complete;
    netmesh_values values = NETMESH_VALUES_CERTIFIED;
};

void make(Session& session, const inputs::Points& points, const Way& way) {
    session.bounds = true;
    session.request.mesh.tau = way.tau;
    session.request.goal.ratio = way.ratio;
    session.request.goal.eps = way.filter == &netmesh_filter_tight ? 0.5 : 0;
    REQUIRE(session.mesh_and_persist(points, persist_by(way.filter, 0, way.values),
                                     way.filter == &netmesh_filter_tight ? &netmesh_filter_tight
                                                                         : &netmesh_filter_complete) == NETMESH_OK);
}

// The steps' ratios are never above the diagram's, where that holds.
void check_steps(const Session& session) {
    const netmesh_diagram_report diagram = session.report().diagram;
    const std::vector<netmesh_scale_step> steps = curve(session).steps;
    for (const netmesh_scale_step& step : steps)
        if (step.from >= diagram.certified_from) CHECK(step.ratio <= diagram.certified_ratio);
}

void moves_within_curve(int dim, const inputs::Points& points, const Way& way) {
    Session session(dim);
    make(session, points, way);
    check_steps(session);
    CHECK(moves_within(curve(session), diagram(session), truth_of(dim, points)));
}

// Positions on a line, in no special direction.
inputs::Points collinear(int dim, std::size_t n, inputs::Random& random) {
    inputs::Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const double at = random.uniform();
        for (int a = 0; a < dim; ++a) p.push_back(std::ldexp(std::floor(at * 0x1p40), -40) * (a + 1) + a);
    }
    return p;
}

inputs::Points polygon(int dim, std::size_t n, double height) {
    inputs::Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = inputs::turn(i, n);
        p.insert(p.end(), {c, s});
        if (dim == 3) p.push_back(i % 2 == 0 ? 0 : height);
    }
    return p;
}

constexpr int kinds = 12;

inputs::Points nasty(int dim, int kind, std::uint64_t seed) {
    inputs::Random random(seed);
    const std::size_t n = 2 + random.below(dim == 2 ? 40 : 24);
    switch (kind) {
    case 0: return inputs::uniform(dim, n, seed);
    case 1: return polygon(dim, 3 + n / 2, random.uniform());
    case 2: return inputs::clusters(dim, n, seed);
    case 3: return collinear(dim, n, random);
    case 4: return inputs::repeated(dim, inputs::uniform(dim, 1 + n / 3, seed), 3, seed);
    case 5: return inputs::shell(dim, n, 1, 1 + 0.2 * random.uniform(), seed);
    case 6: return inputs::grid(dim, 2 + static_cast<int>(random.below(dim == 2 ? 5 : 2)));
    case 7: return inputs::jittered(dim, 2 + static_cast<int>(random.below(dim == 2 ? 5 : 2)), 0x1p-20, seed);
    case 8: return inputs::close_pairs(dim, 1 + n / 2, std::ldexp(1.0, -static_cast<int>(random.below(20))), seed);
    case 9: return inputs::geometric(dim, 1.5 + 3 * random.uniform(), 1 + n / 2, seed);
    case 10: return inputs::cospherical(dim, dim == 2 ? 65 : 9);
    default: return inputs::nested(dim, 3, 1 + n / 3, 4 + 60 * random.uniform(), seed);
    }
}

Way way_of(std::uint64_t seed) {
    inputs::Random random(seed + 77);
    Way way;
    const double taus[] = {0, 4, 3.08, 2.5, 2.2};
    way.tau = taus[random.below(5)];
    if (random.below(3) == 0) way.values = NETMESH_VALUES_THESIS;
    const std::uint64_t filter = random.below(8);
    if (filter == 0) way.filter = &netmesh_filter_basic;
    if (filter == 1 && way.values == NETMESH_VALUES_CERTIFIED) {
        way.tau = 0;
        way.ratio = 2 + 1.5 * random.uniform();
    }
    return way;
}

int sets() {
    const char* const asked = std::getenv("NETMESH_SCALE_SETS");
    return asked == nullptr ? 40 : std::atoi(asked);
}

const inputs::Points square = {0, 0, 1, 0, 1, 1, 0, 1};

}  // namespace

TEST_CASE("corners of regular polygons") {
    for (const double tau : {0.0, 4.0}) {
        for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
            moves_within_curve(2, square, {tau, 0, &netmesh_filter_complete, values});
            for (const std::size_t n : {3, 5, 6, 7, 8, 9, 12, 30, 100})
                moves_within_curve(2, inputs::circle(n), {tau, 0, &netmesh_filter_complete, values});
        }
    }
    moves_within_curve(2, square, {0, 0, &netmesh_filter_tight});
    moves_within_curve(2, inputs::circle(9), {0, 0, &netmesh_filter_tight});
}

TEST_CASE("what 0.1.0 said is refused") {
    const auto refused = [](const std::string& name, const inputs::Points& points, const Way& way) {
        CAPTURE(name);
        Session session(2);
        make(session, points, way);
        const Diagram truth = truth_of(2, points), ours = diagram(session);
        const Curve old = old_curve(session, truth);
        const auto larger = [](const netmesh_scale_step& a, const netmesh_scale_step& b) { return a.ratio < b.ratio; };
        MESSAGE(name << ": said to be within " << std::max_element(old.steps.begin(), old.steps.end(), larger)->ratio
                     << " or less, true ratio " << std::exp(log_distance(ours, truth, 2)));
        return !moves_within(old, ours, truth);
    };
    CHECK(refused("square", square, {}));
    CHECK(refused("9-gon", inputs::circle(9), {}));
    CHECK(refused("9-gon, tau 4", inputs::circle(9), {4}));
    int circles = 0;  // on some the values of the thesis happen to be nearer to the truth
    for (const std::size_t n : {17, 30, 101, 200})
        circles += refused("circle, thesis, tau 4", inputs::circle(n),
                           {4, 0, &netmesh_filter_complete, NETMESH_VALUES_THESIS});
    CHECK(circles >= 2);
}

TEST_CASE("random and nasty sets") {
    int refused = 0;
    for (int i = 0; i < sets(); ++i) {
        const int kind = i % kinds, dim = 2 + i / kinds % 2;
        const std::uint64_t seed = 1000 + static_cast<std::uint64_t>(i);
        const Way way = way_of(seed);
        CAPTURE(i);
        CAPTURE(kind);
        CAPTURE(dim);
        CAPTURE(way.filter);
        CAPTURE(way.tau);
        const inputs::Points points = nasty(dim, kind, seed);
        Session session(dim);
        make(session, points, way);
        check_steps(session);
        const Diagram truth = truth_of(dim, points);
        CHECK(moves_within(curve(session), diagram(session), truth));
        refused += !moves_within(old_curve(session, truth), diagram(session), truth);
    }
    MESSAGE(sets() << " sets; what 0.1.0 said is refused on " << refused);
    CHECK(refused > 0);
}

// Fits that refine where bars are undecided.
TEST_CASE("what a fit decides is so") {
    const double longer_thans[] = {1.1, 1.5, 2.5};
    std::size_t real = 0, due_in_all = 0, focused = 0;
    for (int i = 0; i < sets(); ++i) {
        const int kind = i % kinds, dim = 2 + i / kinds % 2;
        const std::uint64_t seed = 3000 + static_cast<std::uint64_t>(i);
        CAPTURE(i);
        CAPTURE(kind);
        CAPTURE(dim);
        // Every other set is a shell, with a class of degree dim - 1 that is long and many that are not.
        const auto n = static_cast<std::size_t>(30 + 5 * (i % 9));
        const inputs::Points points = i % 2 == 0 ? nasty(dim, kind, seed) : inputs::shell(dim, n, 1, 1.3, seed);
        Session session(dim);
        session.reserve(std::size_t{1} << (19 + i % 4));
        netmesh::Request asked = session.fit_request(points);
        asked.goal.longer_than = longer_thans[i % 3];
        asked.goal.ratio = i % 4 == 0 ? 4 : 2;
        asked.bounds = &netmesh_bounds;
        REQUIRE(session.persist(asked) == NETMESH_OK);
        const netmesh_report report = session.report();
        focused += report.mesh.goal.focus_ratio > 0;
        const Diagram truth = truth_of(dim, points);
        const Curve by_scale = curve(session);
        CHECK(moves_within(by_scale, diagram(session), truth));
        std::size_t certain = 0;
        CHECK(bounds_hold(session, truth, &certain));
        real += certain;
        // Each true class that is long and dies late has a bar of its own that is said to exist.
        std::map<std::uint32_t, Bars> ours, due;
        const std::vector<netmesh_pair> pairs = session.pairs();
        const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
        for (std::size_t bar = 0; bar < pairs.size(); ++bar)
            if (bounds[bar].certain == 1) ours[pairs[bar].degree].push_back({pairs[bar].birth, pairs[bar].death});
        for (const auto& [degree, bars] : truth)
            for (const auto& bar : bars)
                if (bar.second > asked.goal.longer_than * bar.first * (1 + 1e-9) &&
                    bar.second > report.decision.decided_from * (1 + 1e-9))
                    due[degree].push_back(bar);
        for (const auto& [degree, bars] : due) {
            CAPTURE(degree);
            const Bars& of_degree = ours[degree];
            const auto fits = [&, &bars = bars](std::size_t j, std::size_t k) {
                const Range birth = by_scale.at(of_degree[k].first), death = by_scale.at(of_degree[k].second);
                const double slack = 1 + 1e-9;
                return birth.low <= bars[j].first * slack && bars[j].first <= birth.high * slack &&
                       death.low <= bars[j].second * slack && bars[j].second <= death.high * slack;
            };
            CHECK(all_matched(bars.size(), of_degree.size(), fits));
            if (degree > 0) due_in_all += bars.size();
        }
    }
    MESSAGE(sets() << " sets, " << focused << " refined, " << real << " bars certified to exist, " << due_in_all
                   << " classes above degree 0 that had to be among them");
    CHECK(focused >= static_cast<std::size_t>(sets()) / 4);
    CHECK(due_in_all > 0);
}
