// Vineyards of the caller's own values: each diagram against a textbook reduction, vines against what the straight-line
// homotopy allows, by a reduction between each two times at which values meet.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "common/session.hpp"
#include "refusals.hpp"

namespace {

using Simplex = std::vector<std::uint32_t>;  // ascending
using Vector = std::vector<double>;

// A complex as it is listed: in any order.
struct Complex {
    std::vector<Simplex> simplices;
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<std::vector<std::size_t>> facets;  // places in the list

    void add(const Simplex& s, bool turned = false) {
        simplices.push_back(s);
        if (turned) vertices.insert(vertices.end(), s.rbegin(), s.rend());
        if (!turned) vertices.insert(vertices.end(), s.begin(), s.end());
        starts.push_back(vertices.size());
    }
    void link() {
        std::map<Simplex, std::size_t> place;
        for (std::size_t i = 0; i < simplices.size(); ++i) place[simplices[i]] = i;
        facets.assign(simplices.size(), {});
        for (std::size_t i = 0; i < simplices.size(); ++i)
            for (std::size_t skip = 0; simplices[i].size() > 1 && skip < simplices[i].size(); ++skip) {
                Simplex face = simplices[i];
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(skip));
                facets[i].push_back(place.at(face));
            }
    }
    std::size_t vertex_count() const {
        return static_cast<std::size_t>(
            std::count_if(simplices.begin(), simplices.end(), [](const Simplex& s) { return s.size() == 1; }));
    }
    // Any numbers made a filtration.
    template <class Draw> Vector values(Draw draw) const {
        Vector v(simplices.size());
        for (double& x : v) x = draw();
        for (std::size_t size = 2; size <= 8; ++size)
            for (std::size_t i = 0; i < v.size(); ++i)
                if (simplices[i].size() == size)
                    for (const std::size_t f : facets[i]) v[i] = std::max(v[i], v[f]);
        return v;
    }
    // Any numbers, each above those of its faces: few values are equal.
    template <class Draw> Vector rising(Draw draw) const {
        Vector v(simplices.size());
        for (std::size_t size = 1; size <= 8; ++size)
            for (std::size_t i = 0; i < v.size(); ++i)
                if (simplices[i].size() == size) {
                    for (const std::size_t f : facets[i]) v[i] = std::max(v[i], v[f]);
                    v[i] += 1 + draw();
                }
        return v;
    }
    netmesh_simplices with(const Vector& all) const {
        auto s = netmesh::sized<netmesh_simplices>();
        s.vertices = vertices.data();
        s.starts = starts.data();
        s.entries = all.data();
        s.simplex_count = simplices.size();
        s.vertex_count = vertices.size();
        s.step_count = all.size() / simplices.size();
        return s;
    }
};

netmesh::Request vines_of(netmesh_simplices&&) = delete;  // requests point to their simplices
netmesh::Request vines_of(const netmesh_simplices& simplices) {
    netmesh::Request r(&netmesh_filter_simplices);
    r.simplices = &simplices;
    r.vines = &netmesh_vines;
    return r;
}
netmesh_status persist(const Session& session, const netmesh_simplices& simplices) {
    const netmesh::Request r = vines_of(simplices);
    return netmesh_persist(session.context, &r);
}

Complex random_complex(std::mt19937& random, std::uint32_t vertices, int maximal) {
    std::set<Simplex> all;
    for (std::uint32_t v = 0; v < vertices; ++v) all.insert({v * 7});
    for (int i = 0; i < maximal; ++i) {
        std::set<std::uint32_t> s;
        for (std::uint32_t size = 1 + random() % std::min(vertices, 4u); s.size() < size;)
            s.insert(random() % vertices * 7);
        const Simplex whole(s.begin(), s.end());
        for (std::uint32_t mask = 1; mask < 1u << whole.size(); ++mask) {
            Simplex face;
            for (std::size_t b = 0; b < whole.size(); ++b)
                if ((mask >> b & 1) != 0) face.push_back(whole[b]);
            all.insert(face);
        }
    }
    std::vector<Simplex> list(all.begin(), all.end());
    std::shuffle(list.begin(), list.end(), random);
    Complex c;
    for (const Simplex& s : list) c.add(s, random() % 2 == 0);
    c.link();
    return c;
}

constexpr std::size_t never = SIZE_MAX;
using Pairing = std::vector<std::pair<std::size_t, std::size_t>>;  // places: birth, death or never

// By a plain reduction of the whole boundary matrix. Values of any ordered type; ties by dimension, then place.
template <class Value> Pairing pairing(const Complex& c, const std::vector<Value>& value) {
    std::vector<std::size_t> order(c.simplices.size()), position(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (value[a] != value[b]) return value[a] < value[b];
        const std::size_t ka = c.simplices[a].size(), kb = c.simplices[b].size();
        return ka != kb ? ka < kb : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) position[order[i]] = i;
    std::vector<std::set<std::size_t>> with_pivot(order.size());
    std::vector<std::size_t> partner(order.size(), never);
    std::vector<bool> dies(order.size());
    for (std::size_t j = 0; j < order.size(); ++j) {
        std::set<std::size_t> column;
        for (const std::size_t f : c.facets[order[j]]) column.insert(position[f]);
        while (!column.empty() && !with_pivot[*column.rbegin()].empty())
            for (const std::size_t row : std::set<std::size_t>(with_pivot[*column.rbegin()]))
                if (!column.insert(row).second) column.erase(row);
        if (column.empty()) continue;
        partner[*column.rbegin()] = j;
        dies[j] = true;
        with_pivot[*column.rbegin()] = column;
    }
    Pairing pairs;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (!dies[i]) pairs.emplace_back(order[i], partner[i] == never ? never : order[partner[i]]);
    return pairs;
}

using Bar = std::tuple<std::uint32_t, double, double>;  // degree, birth, death

std::uint32_t degree_of(const Complex& c, std::size_t birth) {
    return static_cast<std::uint32_t>(c.simplices[birth].size() - 1);
}
template <class Value> Value death_of(const std::vector<Value>& value, std::size_t death, Value forever) {
    return death == never ? forever : value[death];
}

std::vector<Bar> diagram(const Complex& c, const Vector& value, std::uint32_t max_degree) {
    std::vector<Bar> bars;
    for (const auto& [b, d] : pairing(c, value)) {
        const double death = death_of(value, d, std::numeric_limits<double>::infinity());
        if (death > value[b] && degree_of(c, b) <= max_degree) bars.emplace_back(degree_of(c, b), value[b], death);
    }
    std::sort(bars.begin(), bars.end());
    return bars;
}

// For whole numbers below 2^30: the pairs, zero-length ones too, that each pair of the first filtration may have become
// in the second, going on only to pairs of the same point where the pairing changes.
std::map<std::size_t, std::set<std::pair<std::size_t, std::size_t>>> reachable(const Complex& c, const Vector& from,
                                                                               const Vector& to) {
    using Time = std::pair<std::int64_t, std::int64_t>;  // a / b in [0, 1]
    const auto earlier = [](const Time& s, const Time& t) { return s.first * t.second < t.first * s.second; };
    std::set<Time, decltype(earlier)> times(earlier);
    times.insert({0, 1});
    times.insert({1, 1});
    for (std::size_t i = 0; i < from.size(); ++i)
        for (std::size_t j = 0; j < from.size(); ++j) {
            const auto p = static_cast<std::int64_t>(from[j] - from[i]), q = static_cast<std::int64_t>(to[i] - to[j]);
            if (p > 0 && q > 0 && c.simplices[i].size() == c.simplices[j].size()) times.insert({p, p + q});
        }
    const auto values_at = [&](const Time& t) {
        std::vector<std::int64_t> v;
        for (std::size_t i = 0; i < from.size(); ++i)
            v.push_back((t.second - t.first) * static_cast<std::int64_t>(from[i]) +
                        t.first * static_cast<std::int64_t>(to[i]));
        return v;
    };
    constexpr std::int64_t forever = INT64_MAX;
    Pairing now = pairing(c, from);
    std::vector<std::set<std::size_t>> reach(now.size());  // from the pairs of the first to numbers in `now`
    for (std::size_t i = 0; i < now.size(); ++i) reach[i] = {i};
    const Pairing first = now;
    const auto go_on = [&](const Pairing& next, const Time& at) {
        const std::vector<std::int64_t> v = values_at(at);
        const auto point = [&](const std::pair<std::size_t, std::size_t>& p) {
            return std::make_tuple(degree_of(c, p.first), v[p.first], death_of(v, p.second, forever));
        };
        std::multimap<std::tuple<std::uint32_t, std::int64_t, std::int64_t>, std::size_t> there;
        for (std::size_t i = 0; i < next.size(); ++i) there.emplace(point(next[i]), i);
        for (auto& set : reach) {
            std::set<std::size_t> after;
            for (const std::size_t i : set) {
                const auto range = there.equal_range(point(now[i]));
                for (auto it = range.first; it != range.second; ++it) after.insert(it->second);
            }
            set = after;
        }
        now = next;
    };
    Time last = {0, 1};
    for (auto it = std::next(times.begin()); it != times.end(); ++it) {
        const Time middle = {last.first + it->first, last.second + it->second};  // the mediant lies between
        go_on(pairing(c, values_at(middle)), last);
        last = *it;
    }
    go_on(pairing(c, to), last);
    std::map<std::size_t, std::set<std::pair<std::size_t, std::size_t>>> result;
    for (std::size_t i = 0; i < first.size(); ++i)
        for (const std::size_t j : reach[i]) result[first[i].first].insert(now[j]);
    return result;
}

struct Seen {
    std::vector<std::vector<Bar>> diagrams;
    std::map<std::uint32_t, std::map<std::uint32_t, Bar>> vines;  // vine, step
};

Seen read(const Session& session, std::size_t steps) {
    Seen seen;
    seen.diagrams.resize(steps);
    for (const netmesh_vine_point& p : read_all(session.context, netmesh_get_vine_point)) {
        REQUIRE(p.k >= 1);
        REQUIRE(p.k <= steps);
        seen.diagrams[p.k - 1].emplace_back(p.degree, p.birth, p.death);
        CHECK(seen.vines[p.vine].emplace(p.k, Bar(p.degree, p.birth, p.death)).second);
    }
    for (auto& d : seen.diagrams) std::sort(d.begin(), d.end());
    return seen;
}

Vector joined(const std::vector<Vector>& steps) {
    Vector all;
    for (const Vector& v : steps) all.insert(all.end(), v.begin(), v.end());
    return all;
}

// Each diagram; returns what was seen.
Seen check_diagrams(const Complex& c, const std::vector<Vector>& steps, std::uint32_t max_degree) {
    Session session(2);
    session.reserve(std::size_t{1} << 24);
    const Vector all = joined(steps);
    const netmesh_simplices simplices = c.with(all);
    netmesh::Request request = vines_of(simplices);
    request.max_degree = max_degree;
    REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
    const Seen seen = read(session, steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        CAPTURE(i);
        CHECK(seen.diagrams[i] == diagram(c, steps[i], max_degree));
    }
    const netmesh_report report = session.report();
    CHECK(report.vineyard.present == 1);
    CHECK(report.vineyard.filter == NETMESH_FILTER_NONE);
    CHECK(report.vineyard.k_first == 1);
    CHECK(report.vineyard.k_last == steps.size());
    CHECK(report.vineyard.vines == seen.vines.size());
    CHECK(report.vineyard.certified_ratio == 1);
    CHECK(report.simplicial_complex.vertices == c.vertex_count());
    CHECK(report.diagram.present == 0);
    return seen;
}

// Of two steps: each vine ends where the homotopy allows. How many pairs there are whose end is no choice.
int check_vines(const Complex& c, const Vector& from, const Vector& to) {
    const std::uint32_t max_degree = 7;
    const Seen seen = check_diagrams(c, {from, to}, max_degree);
    const auto may = reachable(c, from, to);
    const double forever = std::numeric_limits<double>::infinity();
    std::map<Bar, std::set<Bar>> ends;  // of points with a length or without
    int unique = 0;
    const Pairing first = pairing(c, from);
    for (const auto& [b, d] : first) {
        const Bar at(degree_of(c, b), from[b], death_of(from, d, forever));
        unique += may.at(b).size() == 1;
        for (const auto& [b2, d2] : may.at(b)) ends[at].emplace(degree_of(c, b2), to[b2], death_of(to, d2, forever));
    }
    const auto is_point = [](const Bar& bar) { return std::get<1>(bar) == std::get<2>(bar); };
    for (const auto& [vine, points] : seen.vines) {
        CAPTURE(vine);
        bool found = false;
        if (points.count(1) != 0 && points.count(2) != 0) {
            found = ends.at(points.at(1)).count(points.at(2)) != 0;
        } else if (points.count(1) != 0) {
            for (const Bar& end : ends.at(points.at(1))) found = found || is_point(end);
        } else {
            for (const auto& [begin, end] : ends) found = found || (is_point(begin) && end.count(points.at(2)) != 0);
        }
        CHECK(found);
    }
    return unique;
}

}  // namespace

TEST_CASE("the diagram of each step is that of its values alone") {
    std::mt19937 random(31);
    for (int run = 0; run < 40; ++run) {
        CAPTURE(run);
        const Complex c = random_complex(random, 3 + random() % 7, 3 + static_cast<int>(random() % 12));
        const std::uint32_t levels[] = {1, 2, 4, 50, 1u << 31};
        std::vector<Vector> steps;
        for (std::uint32_t i = 0, n = 1 + random() % 6; i < n; ++i) {
            const std::uint32_t level = levels[random() % 5];
            const double sign = random() % 3 == 0 ? -1 : 1;
            steps.push_back(c.values([&] { return sign * (random() % level) - (random() % 2 == 0 ? 0.0 : 1.0); }));
        }
        check_diagrams(c, steps, random() % 5);
        // The opposite order, and back.
        Vector falling = steps[0];
        for (std::size_t i = 0; i < falling.size(); ++i) falling[i] = double(c.simplices[i].size() * 100) - double(i);
        check_diagrams(c, {steps[0], falling, steps[0], falling}, 3);
    }
}

TEST_CASE("vines are those of the straight-line homotopy") {
    std::mt19937 random(32);
    for (const std::uint32_t levels : {1u << 18, 1000u, 12u, 3u}) {
        int unique = 0;
        for (int run = 0; run < 40; ++run) {
            CAPTURE(levels);
            CAPTURE(run);
            const Complex c = random_complex(random, 4 + random() % 3, 4 + static_cast<int>(random() % 4));
            const auto draw = [&] { return double(random() % levels); };
            const Vector from = run % 2 == 0 ? c.rising(draw) : c.values(draw), to = c.rising(draw);
            unique += check_vines(c, from, to);
        }
        CHECK(unique > (levels > 100 ? 250 : 40));
    }
}

// Two values of a dimension meet near 1 / 2, all within 2^-23 of each other and some within 2^-58.
TEST_CASE("vines where values meet at times that doubles do not tell apart") {
    std::mt19937 random(36);
    for (int run = 0; run < 150; ++run) {
        CAPTURE(run);
        const Complex c = random_complex(random, 5 + random() % 2, 6 + static_cast<int>(random() % 4));
        Vector from, to;
        for (const Simplex& s : c.simplices) {
            const std::uint32_t place = random() % 8, top = 0x10000000u * static_cast<std::uint32_t>(s.size() - 1);
            from.push_back(double(top + 0x2000000u * place + random() % 4));
            to.push_back(double(top + 0x2000000u * (7 - place) + random() % 4));
        }
        check_vines(c, from, to);
    }
}

TEST_CASE("values of vertices: lower stars") {
    std::mt19937 random(33);
    for (int run = 0; run < 20; ++run) {
        const Complex c = random_complex(random, 3 + random() % 6, 4 + static_cast<int>(random() % 10));
        std::vector<Vector> whole;
        Vector all;
        const std::uint32_t levels = run % 2 == 0 ? 5 : 1000000;
        for (int step = 0; step < 4; ++step) {
            std::map<std::uint32_t, double> of;
            for (const Simplex& s : c.simplices)
                if (s.size() == 1) all.push_back(of[s[0]] = double(random() % levels) - 2);
            Vector values;
            for (const Simplex& s : c.simplices) {
                double most = of.at(s[0]);
                for (const std::uint32_t v : s) most = std::max(most, of.at(v));
                values.push_back(most);
            }
            whole.push_back(values);
        }
        Session session(2);
        netmesh_simplices of_vertices = c.with(all);
        of_vertices.by_vertex = 1;
        of_vertices.step_count = 4;
        REQUIRE(persist(session, of_vertices) == NETMESH_OK);
        const std::vector<netmesh_vine_point> ours = read_all(session.context, netmesh_get_vine_point);
        const Seen seen = check_diagrams(c, whole, NETMESH_DEGREE_MAX);
        Session other(2);
        const Vector spelt = joined(whole);
        REQUIRE(persist(other, c.with(spelt)) == NETMESH_OK);
        const std::vector<netmesh_vine_point> theirs = read_all(other.context, netmesh_get_vine_point);
        REQUIRE(ours.size() == theirs.size());
        for (std::size_t i = 0; i < ours.size(); ++i) {
            CHECK(ours[i].vine == theirs[i].vine);
            CHECK(ours[i].k == theirs[i].k);
            CHECK(ours[i].birth == theirs[i].birth);
            CHECK(ours[i].death == theirs[i].death);
        }
    }
}

TEST_CASE("small vineyards by hand") {
    Complex point;
    point.add({7});
    point.link();
    const Seen one = check_diagrams(point, {{3}, {-2}, {-2}}, 0);
    REQUIRE(one.vines.size() == 1);
    CHECK(one.vines.at(0).size() == 3);
    CHECK(check_diagrams(point, {{5}}, 31).vines.size() == 1);
    // The largest doubles, whose differences overflow, and the least.
    const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    Complex path;
    for (const Simplex& s : {Simplex{0}, Simplex{1}, Simplex{2}, Simplex{0, 1}, Simplex{1, 2}}) path.add(s);
    path.link();
    check_diagrams(path, {{-most, -most, 0, most, least}, {0, most, -most, most, most}, {least, 0, 0, least, least}},
                   1);
    // 0 - 1 - 2: ends at 1 and 2 exchange their ages; the two vines meet at birth 1.5 and change partners there.
    const Seen met = check_diagrams(path, {{0, 1, 2, 5, 3}, {0, 2, 1, 5, 3}}, 0);
    REQUIRE(met.vines.size() == 3);
    CHECK(met.vines.at(1) == std::map<std::uint32_t, Bar>{{1, {0, 1, 5}}, {2, {0, 1, 5}}});
    CHECK(met.vines.at(2) == std::map<std::uint32_t, Bar>{{1, {0, 2, 3}}, {2, {0, 2, 3}}});
    // A triangle's cycle has no length at step 2, and the same vine goes on at step 3.
    Complex triangle;
    for (const Simplex& s :
         {Simplex{0}, Simplex{1}, Simplex{2}, Simplex{0, 1}, Simplex{0, 2}, Simplex{1, 2}, Simplex{0, 1, 2}})
        triangle.add(s);
    triangle.link();
    const Seen gone =
        check_diagrams(triangle, {{0, 0, 0, 1, 1, 1, 2}, {0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 1, 1, 1, 4}}, 1);
    REQUIRE(gone.vines.size() == 4);
    CHECK(gone.vines.at(3) == std::map<std::uint32_t, Bar>{{1, {1, 1, 2}}, {3, {1, 1, 4}}});
}

TEST_CASE("what is no filtration is refused, with the step and the simplices at fault") {
    std::mt19937 random(34);
    for (int run = 0; run < 100; ++run) {
        const Complex c = random_complex(random, 5, 8);
        std::vector<Vector> steps;
        for (int i = 0; i < 5; ++i) steps.push_back(c.values([&] { return double(random() % 1000); }));
        const std::size_t step = random() % 5, at = random() % c.simplices.size();
        const bool is_finite = run % 2 == 0;
        if (is_finite && c.simplices[at].size() == 1) continue;
        if (is_finite) steps[step][at] = -1;
        if (!is_finite) steps[step][at] = run % 4 == 1 ? HUGE_VAL : std::nan("");
        Session session(2);
        const Vector all = joined(steps);
        const netmesh_status status = persist(session, c.with(all));
        const netmesh_detail detail = session.detail();
        CHECK(detail.step == step + 1);
        CHECK(detail.index_a == at);
        CHECK(status == (is_finite ? NETMESH_NOT_A_COMPLEX : NETMESH_NOT_FINITE));
        if (is_finite) {
            CHECK(detail.fault == NETMESH_FAULT_FACE_LATER);
            CHECK(std::count(c.facets[at].begin(), c.facets[at].end(), detail.index_b) == 1);
        }
        CHECK(session.report().vineyard.present == 0);
        CHECK(session.report().input.present == 0);
    }
    // Each facet of a simplex, where it alone enters later.
    for (const Simplex& whole : {Simplex{0, 1}, Simplex{0, 1, 2}, Simplex{0, 1, 2, 3}}) {
        Complex c;
        for (std::uint32_t mask = 1; mask < 1u << whole.size(); ++mask) {
            Simplex face;
            for (const std::uint32_t v : whole)
                if ((mask >> v & 1) != 0) face.push_back(v);
            c.add(face);
        }
        c.link();
        Vector good;
        for (const Simplex& s : c.simplices) good.push_back(double(s.size()));
        const std::size_t top = c.simplices.size() - 1;
        for (const std::size_t facet : c.facets[top]) {
            CAPTURE(facet);
            Vector bad = good;
            bad[facet] = good[top] + 1;
            Session session(2);
            const Vector all = joined({good, bad});
            CHECK(persist(session, c.with(all)) == NETMESH_NOT_A_COMPLEX);
            CHECK(session.detail().fault == NETMESH_FAULT_FACE_LATER);
            CHECK(session.detail().step == 2);
            CHECK(session.detail().index_a == top);
            CHECK(session.detail().index_b == facet);
        }
    }
    // What is wrong with the complex has no step.
    Complex open;
    for (const Simplex& s : {Simplex{0}, Simplex{0, 1}}) open.add(s);
    const Vector values = {0, 1, 0, 1};
    Session session(2);
    CHECK(persist(session, open.with(values)) == NETMESH_NOT_A_COMPLEX);
    CHECK(session.detail().fault == NETMESH_FAULT_FACE_MISSING);
    CHECK(session.detail().index_a == 1);
    CHECK(session.detail().step == 0);
    // Of values of vertices the vertex is told by its place among all simplices.
    Complex edge;
    for (const Simplex& s : {Simplex{0, 1}, Simplex{1}, Simplex{0}}) edge.add(s);
    const Vector at_vertices = {0, 1, 2, std::nan("")};
    netmesh_simplices by_vertex = edge.with(at_vertices);
    by_vertex.by_vertex = 1;
    by_vertex.step_count = 2;
    CHECK(persist(session, by_vertex) == NETMESH_NOT_FINITE);
    CHECK(session.detail().index_a == 2);
    CHECK(session.detail().step == 2);
}

TEST_CASE("every size of memory: a status and an empty context, or the same vineyard") {
    std::mt19937 random(35);
    const Complex c = random_complex(random, 7, 12);
    std::vector<Vector> steps;
    for (int i = 0; i < 4; ++i) steps.push_back(c.values([&] { return double(random() % 100); }));
    const Vector all = joined(steps);
    const netmesh_simplices simplices = c.with(all);
    const netmesh::Request request = vines_of(simplices);
    Session session(2);
    REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
    const std::uint64_t print = session.report().fingerprint, peak = session.report().memory.peak_bytes;
    CHECK(netmesh_plan(&request) >= peak);
    int refused = 0;
    for (std::size_t bytes = 8192; bytes < 2 * peak; bytes += 208) {
        Session small(2);
        small.reserve(bytes);
        const netmesh_status status = netmesh_persist(small.context, &request);
        if (status == NETMESH_OK) {
            CHECK(small.report().fingerprint == print);
            CHECK(bytes + 512 >= peak);
        } else {
            ++refused;
            CHECK(status == NETMESH_OUT_OF_MEMORY);
            CHECK(small.report().vineyard.present == 0);
            CHECK(small.report().input.present == 0);
        }
    }
    CHECK(refused > 0);
}

TEST_CASE("arguments of vineyards of values") {
    Fixture f(2);
    const std::uint32_t v[] = {0, 1, 0, 1};
    const std::uint64_t starts[] = {0, 1, 2, 4};
    const double t[] = {0, 0, 1, 1, 0, 1};
    auto good = netmesh::sized<netmesh_simplices>();
    good.vertices = v;
    good.starts = starts;
    good.entries = t;
    good.simplex_count = 3;
    good.vertex_count = 4;
    good.step_count = 2;
    const auto refused = [&](auto change, netmesh_field field) {
        netmesh_simplices bad = good;
        change(bad);
        f.refused(persist(f.session, bad), field);
    };
    f.needs_request<netmesh_request>(netmesh_persist, vines_of(good));
    refused([](auto& r) { r.struct_bytes = 0; }, NETMESH_FIELD_STRUCT_BYTES);
    refused([](auto& r) { r.vertices = nullptr; }, NETMESH_FIELD_VERTICES);
    refused([](auto& r) { r.starts = nullptr; }, NETMESH_FIELD_STARTS);
    refused([](auto& r) { r.entries = nullptr; }, NETMESH_FIELD_ENTRIES);
    refused([](auto& r) { r.simplex_count = 0; }, NETMESH_FIELD_SIMPLEX_COUNT);
    refused([](auto& r) { r.vertex_count = 3; }, NETMESH_FIELD_VERTEX_COUNT);
    refused([](auto& r) { r.step_count = 0; }, NETMESH_FIELD_STEP_COUNT);
    refused([](auto& r) { r.step_count = UINT32_MAX; }, NETMESH_FIELD_STEP_COUNT);
    const auto plan = [&](std::uint64_t simplices, std::uint64_t vertices, std::uint64_t steps) {
        netmesh_simplices s = good;
        s.simplex_count = simplices;
        s.vertex_count = vertices;
        s.step_count = steps;
        const netmesh::Request r = vines_of(s);
        return netmesh_plan(&r);
    };
    CHECK(plan(0, 0, 1) == 0);
    CHECK(plan(5, 4, 1) == 0);
    CHECK(plan(3, 4, 0) == 0);
    CHECK(plan(3, 4, UINT32_MAX) == 0);
    CHECK(plan(1, UINT64_MAX, 1) == 0);
    CHECK(plan(3, 4, 1) > 16384);
    CHECK(plan(3000, 6000, 100) > plan(3000, 6000, 1));
    CHECK(netmesh_plan(nullptr) == 0);
    CHECK(persist(f.session, good) == NETMESH_OK);
    CHECK(f.session.report().vineyard.k_last == 2);
    const auto ratio = [&](std::uint32_t k) {
        double at;
        return netmesh_get_vine_ratio(f.c, k, &at);
    };
    CHECK(ratio(1) == NETMESH_OK);
    CHECK(ratio(2) == NETMESH_OK);
    CHECK(ratio(0) == NETMESH_INVALID_ARGUMENT);
    CHECK(ratio(3) == NETMESH_INVALID_ARGUMENT);
    // More degrees than there are dimensions.
    netmesh::Request request = vines_of(good);
    for (const std::uint32_t degree : {2u, NETMESH_DEGREE_MAX + 1u, UINT32_MAX}) {
        request.max_degree = degree;
        CHECK(netmesh_persist(f.c, &request) == NETMESH_OK);
        CHECK(f.session.report().vineyard.max_degree == 1);
    }
}
