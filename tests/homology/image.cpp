// Images of subcomplexes in homology: ranks by linear algebra on all chains, diagrams where the part is the whole.
#include "homology/matrix/image.hpp"

#include <doctest/doctest.h>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "map_ranks.hpp"
#include "oracle.hpp"

using namespace netmesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A filtered complex, a subcomplex of it, and one of that.
struct Nested {
    oracle::Filtered filtered;
    std::vector<int> level;  // of each simplex: 2 in the part, 1 in the whole alone, 0 in neither
};

// Faces of random simplices, with whole numbers for values, so that many are equal. A face's level is at least that of
// what it is a face of, its value at most.
Nested random_complex(inputs::Random& random, std::uint32_t vertices, std::uint32_t largest) {
    std::map<oracle::Simplex, std::pair<double, int>> all;
    for (std::uint64_t left = 4 + random.below(10); left > 0; --left) {
        oracle::Simplex s;
        for (std::uint64_t size = 1 + random.below(largest); s.size() < size;) {
            const auto v = static_cast<std::uint32_t>(random.below(vertices));
            if (std::find(s.begin(), s.end(), v) == s.end()) s.push_back(v);
        }
        const double value = static_cast<double>(random.below(6));
        const int level = static_cast<int>(random.below(3));
        for (const oracle::Simplex& face : oracle::all_faces({s})) {
            const double own =
                face.size() == s.size() ? value : std::max(0.0, value - static_cast<double>(random.below(2)));
            auto [at, is_new] = all.insert({face, {own, level}});
            if (!is_new) at->second = {std::min(at->second.first, own), std::max(at->second.second, level)};
        }
    }
    for (bool again = true; again;) {
        again = false;
        for (auto& [s, entry] : all)
            for (const oracle::Simplex& face : oracle::all_faces({s})) {
                if (all.at(face).first <= entry.first) continue;
                entry.first = all.at(face).first;
                again = true;
            }
    }
    Nested made;
    std::vector<oracle::Simplex> simplices;
    for (const auto& [s, entry] : all) simplices.push_back(s);
    made.filtered = oracle::filter(simplices, [&](const oracle::Simplex& s) { return all.at(s).first; });
    for (const oracle::Simplex& s : made.filtered.simplices) made.level.push_back(all.at(s).second);
    return made;
}

struct Sets {
    std::vector<std::vector<std::uint64_t>> words;
    SimplexSet set;

    Sets(const Nested& nested, const FilteredComplex& complex, int least) {
        for (std::uint32_t k = 0; k <= complex.dimension; ++k) {
            words.emplace_back(BitSet::words_needed(complex.of[k].count));
            set.of[k].adopt(words.back().data(), complex.of[k].count);
        }
        std::vector<std::uint32_t> next(complex.dimension + 1);
        for (std::size_t i = 0; i < nested.level.size(); ++i) {
            const std::size_t k = nested.filtered.simplices[i].size() - 1;
            if (nested.level[i] >= least) set.of[k].insert(next[k]);
            ++next[k];
        }
    }
};

std::vector<Pair> image_of(const FilteredComplex& complex, const SimplexSet& whole, const SimplexSet& part,
                           DiagramRequest request, std::size_t bytes = 1 << 16, Status* status = nullptr) {
    Block block(bytes);
    Monitor monitor;
    PairList out = {};
    const Status got = persist_image(complex, whole, part, request, {block.arena, monitor}, &out);
    CHECK(block.arena.high_mark() == block.arena.bytes());
    if (status != nullptr) *status = got;
    if (got != Status::ok) CHECK(block.arena.low_mark() == 0);
    if (status == nullptr) REQUIRE(got == Status::ok);
    return got == Status::ok ? std::vector<Pair>(out.pairs, out.pairs + out.count) : std::vector<Pair>();
}

}  // namespace

TEST_CASE("images have the ranks of the maps, and are diagrams where the part is the whole") {
    inputs::Random random(7);
    int essential = 0, finite = 0, smaller = 0;
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        const Nested nested = random_complex(random, 7, 4);
        const oracle::Explicit complex(nested.filtered);
        const Sets all(nested, complex.complex, 0), whole(nested, complex.complex, 1), part(nested, complex.complex, 2);
        for (std::uint32_t degree = 0; degree <= 3; ++degree)
            for (const bool zero : {false, true}) {
                const std::vector<Pair> due = oracle::diagram(nested.filtered, degree, zero);
                std::vector<Pair> have = image_of(complex.complex, all.set, all.set, {degree, zero});
                CHECK(oracle::same(due, {have.data(), have.size()}));
            }
        const std::vector<Pair> bars = image_of(complex.complex, whole.set, part.set, {3});
        CHECK(std::is_sorted(bars.begin(), bars.end(), CanonicalOrder{}));
        std::vector<oracle::PartSimplex> simplices;
        for (std::size_t i = 0; i < nested.level.size(); ++i)
            if (nested.level[i] > 0)
                simplices.push_back({nested.filtered.simplices[i], nested.filtered.values[i], nested.level[i] == 2});
        const std::vector<double> scales = {0, 1, 2, 3, 4, 5};
        for (std::uint32_t p = 0; p <= 3; ++p) {
            CAPTURE(p);
            const std::vector<std::vector<int>> due = oracle::map_ranks(simplices, p, scales);
            for (std::size_t a = 0; a < scales.size(); ++a)
                for (std::size_t b = a; b < scales.size(); ++b) {
                    int have = 0;
                    for (const Pair& bar : bars)
                        have += bar.degree == p && bar.birth <= scales[a] && bar.death > scales[b];
                    CHECK(have == due[a][b]);
                }
        }
        for (const Pair& bar : bars) ++(bar.death == infinity ? essential : finite);
        smaller += bars.size() < image_of(complex.complex, part.set, part.set, {3}).size();
    }
    CHECK(essential > 100);
    CHECK(finite > 100);
    CHECK(smaller > 50);
}

TEST_CASE("an image in any block, or none") {
    inputs::Random random(3);
    const Nested nested = random_complex(random, 9, 4);
    const oracle::Explicit complex(nested.filtered);
    const Sets whole(nested, complex.complex, 1), part(nested, complex.complex, 2);
    const std::vector<Pair> due = image_of(complex.complex, whole.set, part.set, {2, true});
    int refused = 0, good = 0;
    for (std::size_t bytes = 16; bytes < 4096; bytes += 16) {
        Status status;
        const std::vector<Pair> have = image_of(complex.complex, whole.set, part.set, {2, true}, bytes, &status);
        if (status == Status::out_of_memory) {
            CHECK(good == 0);
            ++refused;
        } else {
            REQUIRE(status == Status::ok);
            ++good;
            REQUIRE(have.size() == due.size());
            for (std::size_t i = 0; i < due.size(); ++i) CHECK(have[i].death == due[i].death);
        }
    }
    CHECK(refused > 5);
    CHECK(good > 5);
    Block block(1 << 12);
    Monitor monitor;
    PairList out = {};
    FilteredComplex high = {};
    high.dimension = FilteredComplex::dimension_max + 1;
    CHECK(persist_image(high, whole.set, part.set, {1}, {block.arena, monitor}, &out) == Status::invalid_argument);
}
