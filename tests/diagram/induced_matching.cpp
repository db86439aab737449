// Induced matchings: on diagrams by hand, and of random ones against all ways to choose.
#include "diagram/induced_matching.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "vocabulary/ids.hpp"

using namespace netmesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Pairs = std::vector<Pair>;
using Places = std::vector<std::uint32_t>;
constexpr std::uint32_t nothing = none;

Status match(Pairs source, Pairs image, Pairs target, Places* to, std::size_t bytes = 1 << 12) {
    Block block(bytes);
    to->assign(source.size(), 77);
    const MappedDiagrams diagrams = {
        {source.data(), source.size()}, {image.data(), image.size()}, {target.data(), target.size()}};
    const Status status = match_induced(diagrams, block.arena, to->data());
    CHECK(block.arena.bytes_used() == 0);
    return status;
}

Pair pair(double birth, double death, std::uint32_t degree = 0) { return {birth, death, degree, 0}; }

}  // namespace

TEST_CASE("induced matchings by hand") {
    Places to;
    CHECK(match({}, {}, {}, &to) == Status::ok);
    CHECK(match({pair(1, 2)}, {}, {pair(0, 3)}, &to) == Status::ok);
    CHECK(to == Places{nothing});
    // Of two that are born together the longer one goes on; of two that die together the older one is met.
    CHECK(match({pair(2, 4), pair(2, 9)}, {pair(2, 3)}, {pair(0, 3), pair(1, 3)}, &to) == Status::ok);
    CHECK(to == Places{nothing, 0});
    // Degrees are apart, infinity is a death.
    CHECK(match({pair(1, infinity), pair(1, 5, 1), pair(2, 5, 1)}, {pair(1, infinity), pair(2, 4, 1)},
                {pair(0, infinity), pair(1, 4), pair(1, 4, 1)}, &to) == Status::ok);
    CHECK(to == Places{0, nothing, 2});
    // Longest with longest, in both.
    CHECK(match({pair(1, 5), pair(1, 6), pair(1, 7)}, {pair(1, 3), pair(1, 4)}, {pair(0, 3), pair(0, 4)}, &to) ==
          Status::ok);
    CHECK(to == Places{nothing, 0, 1});
}

TEST_CASE("what is no image") {
    Places to;
    // Nothing is born then in the source; nothing dies then in the target; the image outlasts, or precedes; too many.
    CHECK(match({pair(1, 5)}, {pair(2, 3)}, {pair(0, 3)}, &to) == Status::internal);
    CHECK(match({pair(2, 5)}, {pair(2, 3)}, {pair(0, 4)}, &to) == Status::internal);
    CHECK(match({pair(2, 3)}, {pair(2, 4)}, {pair(0, 4)}, &to) == Status::internal);
    CHECK(match({pair(2, 4)}, {pair(2, 4)}, {pair(3, 4)}, &to) == Status::internal);
    CHECK(match({pair(2, 4)}, {pair(2, 3), pair(2, 4)}, {pair(0, 3), pair(0, 4)}, &to) == Status::internal);
    CHECK(match({pair(1, 4), pair(2, 4)}, {pair(1, 4), pair(2, 4)}, {pair(0, 4)}, &to) == Status::internal);
    CHECK(match({pair(2, 4, 1)}, {pair(2, 4, 1)}, {pair(2, 4)}, &to) == Status::internal);
    CHECK(match({pair(2, 4)}, {pair(2, 4, 1)}, {pair(2, 4, 1)}, &to) == Status::internal);
    CHECK(match({pair(2, 4)}, {pair(2, 4)}, {pair(2, 4)}, &to, 32) == Status::out_of_memory);
}

// Image bars first, each inside of one bar of both sides; then bars that the map sends to nothing or does not reach.
TEST_CASE("matchings of random images: every bar of the image has its birth from one side, its death from the other") {
    inputs::Random random(11);
    const auto number = [&random](std::uint64_t n) { return static_cast<double>(random.below(n)); };
    for (int round = 0; round < 500; ++round) {
        Pairs source, image, target;
        for (std::uint64_t i = random.below(9); i > 0; --i) {
            const auto degree = static_cast<std::uint32_t>(random.below(2));
            const double birth = 4 + number(4), death = birth + 1 + number(4);
            image.push_back(pair(birth, death, degree));
            source.push_back(pair(birth, random.below(3) == 0 ? infinity : death + number(3), degree));
            target.push_back(pair(birth - number(3), death, degree));
        }
        for (Pairs* const list : {&source, &target})
            for (std::uint64_t i = random.below(4); i > 0; --i)
                list->push_back(pair(number(9), 9 + number(4), static_cast<std::uint32_t>(random.below(2))));
        for (Pairs* const list : {&source, &image, &target}) std::sort(list->begin(), list->end(), CanonicalOrder{});
        Places to;
        REQUIRE(match(source, image, target, &to) == Status::ok);
        Pairs made;
        std::vector<int> met(target.size());
        for (std::size_t s = 0; s < source.size(); ++s) {
            if (to[s] == nothing) continue;
            REQUIRE(to[s] < target.size());
            CHECK(met[to[s]]++ == 0);
            const Pair &from = source[s], &end = target[to[s]];
            CHECK(from.degree == end.degree);
            CHECK(end.birth <= from.birth);
            CHECK(end.death <= from.death);
            made.push_back(pair(from.birth, end.death, from.degree));
        }
        std::sort(made.begin(), made.end(), CanonicalOrder{});
        REQUIRE(made.size() == image.size());
        for (std::size_t i = 0; i < made.size(); ++i) {
            CHECK(made[i].degree == image[i].degree);
            CHECK(made[i].birth == image[i].birth);
            CHECK(made[i].death == image[i].death);
        }
        // No shorter one is taken where a longer one is left.
        for (std::size_t s = 1; s < source.size(); ++s)
            if (source[s - 1].degree == source[s].degree && source[s - 1].birth == source[s].birth)
                CHECK((to[s] != nothing || to[s - 1] == nothing));
        for (std::size_t t = 0; t < target.size(); ++t)
            for (std::size_t u = 0; u < target.size(); ++u)
                if (target[t].degree == target[u].degree && target[t].death == target[u].death &&
                    target[t].birth < target[u].birth)
                    CHECK((met[t] == 1 || met[u] == 0));
    }
}
