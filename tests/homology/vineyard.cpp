// Vineyards: each diagram against the textbook reduction, vines against what continuity says.
#include "homology/vineyard/vineyard.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "complexes.hpp"
#include "disturbed.hpp"
#include "oracle.hpp"

using namespace netmesh;
using oracle::Simplex;

namespace {

// Values by dimension, as the vineyard takes them.
struct Values {
    std::vector<std::vector<double>> of;
    std::vector<const double*> pointers() const {
        std::vector<const double*> p;
        for (const auto& v : of) p.push_back(v.data());
        return p;
    }
};

// A complex whose simplices of a dimension are numbered in lexicographic order.
struct Complex {
    std::vector<std::vector<Simplex>> of;
    std::vector<std::vector<std::uint32_t>> facets;
    ComplexView view = {};

    explicit Complex(const std::vector<Simplex>& maximal) {
        std::map<Simplex, std::uint32_t> number;
        for (const Simplex& s : oracle::all_faces(maximal)) {
            if (of.size() < s.size()) of.resize(s.size());
            number[s] = static_cast<std::uint32_t>(of[s.size() - 1].size());
            of[s.size() - 1].push_back(s);
        }
        facets.resize(of.size());
        for (std::size_t k = 1; k < of.size(); ++k)
            for (const Simplex& s : of[k])
                for (std::size_t i = 0; i <= k; ++i) {
                    Simplex face = s;
                    face.erase(face.begin() + static_cast<std::ptrdiff_t>(k - i));
                    facets[k].push_back(number.at(face));
                }
        view.dimension = static_cast<std::uint32_t>(of.size() - 1);
        for (std::size_t k = 0; k < of.size(); ++k) {
            view.count[k] = static_cast<std::uint32_t>(of[k].size());
            view.facets[k] = facets[k].data();
        }
    }
    // Any numbers made a filtration: no simplex before its faces.
    template <class Draw> Values values(Draw draw) const {
        Values v;
        v.of.resize(of.size());
        for (std::size_t k = 0; k < of.size(); ++k)
            for (std::size_t i = 0; i < of[k].size(); ++i) {
                double t = draw();
                for (std::size_t j = 0; k > 0 && j <= k; ++j) t = std::max(t, v.of[k - 1][facets[k][(k + 1) * i + j]]);
                v.of[k].push_back(t);
            }
        return v;
    }
    std::vector<Pair> fresh(const Values& v, std::uint32_t max_degree) const {
        std::vector<Simplex> all;
        std::map<Simplex, double> value;
        for (std::size_t k = 0; k < of.size(); ++k)
            for (std::size_t i = 0; i < of[k].size(); ++i) {
                all.push_back(of[k][i]);
                value[of[k][i]] = v.of[k][i];
            }
        return oracle::diagram(oracle::filter(all, [&](const Simplex& s) { return value.at(s); }), max_degree, true);
    }
};

struct Vine {
    Pair pair;
    std::uint32_t number;
};

std::vector<Vine> vines_of(const Vineyard& vineyard, const Values& v) {
    std::vector<Vine> vines;
    vineyard.for_each_pair([&](const Vineyard::VinePair& p) {
        vines.push_back(
            {{v.of[p.degree][p.birth], p.death == none ? HUGE_VAL : v.of[p.degree + 1][p.death], p.degree, 0}, p.vine});
    });
    return vines;
}

bool same(const std::vector<Vine>& vines, const std::vector<Pair>& pairs) {
    std::vector<Pair> ours;
    for (const Vine& v : vines) ours.push_back(v.pair);
    std::sort(ours.begin(), ours.end(), CanonicalOrder{});
    if (ours.size() != pairs.size()) return false;
    for (std::size_t i = 0; i < ours.size(); ++i)
        if (ours[i].degree != pairs[i].degree || ours[i].birth != pairs[i].birth || ours[i].death != pairs[i].death)
            return false;
    return true;
}

std::vector<Simplex> random_complex(std::mt19937& random, std::uint32_t vertices, int count) {
    std::vector<Simplex> maximal;
    for (int i = 0; i < count; ++i) {
        Simplex s;
        for (std::uint32_t size = 1 + random() % 4; s.size() < size;) {
            const std::uint32_t v = random() % vertices;
            if (std::find(s.begin(), s.end(), v) == s.end()) s.push_back(v);
        }
        std::sort(s.begin(), s.end());
        maximal.push_back(s);
    }
    for (std::uint32_t v = 0; v < vertices; ++v) maximal.push_back({v});
    return maximal;
}

}  // namespace

TEST_CASE("each diagram equals a fresh computation") {
    std::mt19937 random(5);
    for (int run = 0; run < 60; ++run) {
        const Complex complex(random_complex(random, 4 + random() % 9, 4 + static_cast<int>(random() % 20)));
        const std::uint32_t max_degree = random() % 4, ties = run % 2 == 0 ? 4 : 1000000;
        CAPTURE(run);
        Block block(std::size_t{1} << 22);
        Monitor monitor;
        Vineyard vineyard;
        Values now = complex.values([&] { return double(random() % ties); });
        REQUIRE(vineyard.open(complex.view, max_degree, now.pointers().data(), {block.arena, monitor}) == Status::ok);
        CHECK(same(vines_of(vineyard, now), complex.fresh(now, max_degree)));
        for (int step = 0; step < 8; ++step) {
            const Values next = complex.values([&] { return double(random() % ties); });
            REQUIRE(vineyard.advance(now.pointers().data(), next.pointers().data(), monitor) == Status::ok);
            CHECK(same(vines_of(vineyard, next), complex.fresh(next, max_degree)));
            now = next;
        }
    }
}

TEST_CASE("vines are continuous, and the same however finely their way is cut") {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int run = 0; run < 12; ++run) {
        const Complex complex(random_complex(random, 8, 18));
        const std::uint32_t max_degree = complex.view.dimension;
        const Values from = complex.values([&] { return uniform(random); });
        const Values to = complex.values([&] { return uniform(random); });
        Block whole_block(std::size_t{1} << 22), cut_block(std::size_t{1} << 22);
        Monitor monitor;
        Vineyard whole, cut;
        REQUIRE(whole.open(complex.view, max_degree, from.pointers().data(), {whole_block.arena, monitor}) ==
                Status::ok);
        REQUIRE(whole.advance(from.pointers().data(), to.pointers().data(), monitor) == Status::ok);
        REQUIRE(cut.open(complex.view, max_degree, from.pointers().data(), {cut_block.arena, monitor}) == Status::ok);
        const int pieces = 100;
        Values now = from;
        std::map<std::uint32_t, Pair> last;
        for (const Vine& v : vines_of(cut, now)) last[v.number] = v.pair;
        for (int piece = 1; piece <= pieces; ++piece) {
            Values next = from;
            double change = 0;
            for (std::size_t k = 0; k < from.of.size(); ++k)
                for (std::size_t i = 0; i < from.of[k].size(); ++i) {
                    next.of[k][i] =
                        piece == pieces ? to.of[k][i] : from.of[k][i] + (to.of[k][i] - from.of[k][i]) * piece / pieces;
                    change = std::max(change, std::fabs(next.of[k][i] - now.of[k][i]));
                }
            REQUIRE(cut.advance(now.pointers().data(), next.pointers().data(), monitor) == Status::ok);
            for (const Vine& v : vines_of(cut, next)) {
                const Pair before = last.at(v.number);
                CHECK(before.degree == v.pair.degree);
                CHECK(std::fabs(before.birth - v.pair.birth) <= change + 1e-12);
                CHECK((before.death == v.pair.death || std::fabs(before.death - v.pair.death) <= change + 1e-12));
                last[v.number] = v.pair;
            }
            now = next;
        }
        for (const Vine& v : vines_of(whole, to)) {
            CHECK(last.at(v.number).birth == v.pair.birth);
            CHECK(last.at(v.number).death == v.pair.death);
        }
    }
}

// A path 0 - 1 - 2 whose ends at 1 and 2 exchange their ages: the pairs meet at birth 1.5 and change partners there,
// so that no vine's birth jumps.
TEST_CASE("two vines that meet change partners") {
    const Complex path({{0, 1}, {1, 2}});
    const Values from = {{{0, 1, 2}, {5, 3}}}, to = {{{0, 2, 1}, {5, 3}}};
    Block block(1 << 16);
    Monitor monitor;
    Vineyard vineyard;
    REQUIRE(vineyard.open(path.view, 0, from.pointers().data(), {block.arena, monitor}) == Status::ok);
    const std::vector<Vine> first = vines_of(vineyard, from);
    REQUIRE(first.size() == 3);
    REQUIRE(vineyard.advance(from.pointers().data(), to.pointers().data(), monitor) == Status::ok);
    CHECK(vineyard.transpositions() == 1);
    int seen = 0;
    for (const Vine& before : first)
        for (const Vine& after : vines_of(vineyard, to)) {
            if (before.number != after.number) continue;
            ++seen;
            CHECK(before.pair.birth == after.pair.birth);
            CHECK(before.pair.death == after.pair.death);
        }
    CHECK(seen == 3);
}

TEST_CASE("every size of memory: a status, or the whole vineyard") {
    std::mt19937 random(7);
    const Complex complex(random_complex(random, 9, 16));
    const Values from = complex.values([&] { return double(random() % 50); });
    const Values to = complex.values([&] { return double(random() % 50); });
    bool enough = false;
    for (std::size_t bytes = 64; !enough; bytes += 192) {
        Block block(bytes);
        Monitor monitor;
        Vineyard vineyard;
        Status status = vineyard.open(complex.view, 2, from.pointers().data(), {block.arena, monitor});
        if (status == Status::ok) status = vineyard.advance(from.pointers().data(), to.pointers().data(), monitor);
        enough = status == Status::ok;
        if (!enough) CHECK(status == Status::out_of_memory);
        if (enough) CHECK(same(vines_of(vineyard, to), complex.fresh(to, 2)));
    }
}

namespace {

// A vineyard through several filtrations, checked at each.
struct Way {
    const Complex& complex;
    std::uint32_t max_degree;
    std::vector<Values> through;
    std::vector<std::vector<Pair>> expected;

    Way(const Complex& c, std::uint32_t degree, const std::vector<Values>& values)
        : complex(c), max_degree(degree), through(values) {
        for (const Values& v : values) expected.push_back(c.fresh(v, degree));
    }
    // Leaves the arena as it was, which is for its owner to do.
    Status go(const Work& work) const {
        const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
        Vineyard vineyard;
        Status status = vineyard.open(complex.view, max_degree, through[0].pointers().data(), work);
        for (std::size_t i = 0; status == Status::ok; ++i) {
            REQUIRE(same(vines_of(vineyard, through[i]), expected[i]));
            if (i + 1 == through.size()) break;
            status = vineyard.advance(through[i].pointers().data(), through[i + 1].pointers().data(), work.monitor);
        }
        work.arena.release_low(low);
        work.arena.release_high(high);
        return status;
    }
};

}  // namespace

// Random values need long columns: the pool grows beyond what is needed in passing to order the simplices.
TEST_CASE("columns of a vineyard in blocks of all sizes") {
    std::mt19937 random(8);
    for (int round = 0; round < 24; ++round) {
        const Complex complex(round % 2 == 0 ? glued_square(4 + std::uint32_t(round) % 3 / 2, round % 4 == 0)
                                             : random_complex(random, 8 + random() % 8, 30 + int(random() % 40)));
        std::vector<Values> through;
        for (int i = 0; i < 10; ++i) through.push_back(complex.values([&] { return double(random() % 1000); }));
        const Way way(complex, 1 + round % 3, through);
        disturbed::by_size(std::size_t{1} << 20, 1600, [&](const Work& work) { return way.go(work); });
    }
}

TEST_CASE("a vineyard stopped at any poll") {
    std::mt19937 random(9);
    const Complex complex(random_complex(random, 18, 900));
    const Values from = complex.values([&] { return double(random()); });
    const Values to = complex.values([&] { return double(random()); });
    const Way way(complex, 2, {from, to});
    CHECK(disturbed::at_polls(std::size_t{8} << 20, [&](const Work& work) { return way.go(work); }) > 0);
}

TEST_CASE("complexes without transpositions, and zeros of both signs") {
    const Complex point(std::vector<Simplex>{Simplex{0}});
    Block block(1 << 16);
    Monitor monitor;
    REQUIRE(Way(point, 0, {{{{1}}}, {{{2}}}}).go({block.arena, monitor}) == Status::ok);
    Complex points({{0}, {1}, {2}});
    points.view.dimension = 1;  // without edges
    REQUIRE(Way(points, 1, {{{{1, 2, 3}}}, {{{2, 1, 0}}}}).go({block.arena, monitor}) == Status::ok);
    std::mt19937 random(10);
    const Complex complex(random_complex(random, 8, 20));
    std::vector<Values> through;
    const double levels[] = {0.0, -0.0, 1, 0.0};
    for (int i = 0; i < 20; ++i) through.push_back(complex.values([&] { return levels[random() % 4]; }));
    REQUIRE(Way(complex, 2, through).go({block.arena, monitor}) == Status::ok);
}
