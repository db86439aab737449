// Searches in a tree of points against looking at all of them: coordinates of few values, so that many points are
// exactly at the limit.
#include "diagram/point_tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "vocabulary/ids.hpp"

using namespace netmesh;

namespace {

template <class Scale> void check_searches(std::uint32_t count, std::uint32_t values, std::mt19937& random) {
    const auto draw = [&] {
        DiagramPoint p = {};
        p.coordinate[0] = double(1 + random() % values);
        p.coordinate[1] = p.coordinate[0] + double(1 + random() % values);
        return p;
    };
    std::vector<DiagramPoint> points;
    for (std::uint32_t i = 0; i < count; ++i) points.push_back(draw());
    std::vector<std::uint64_t> mark(count), below(count);
    PointTree tree;
    tree.build(points.data(), mark.data(), below.data(), count);
    tree.mark_all(1);
    std::vector<std::uint64_t> marks(count, 1);
    for (int turn = 0; turn < 60; ++turn) {
        const std::uint32_t changed = std::uint32_t(random() % count);
        marks[changed] = 1 + random() % 3;
        tree.mark(changed, marks[changed]);
        const DiagramPoint from = draw();
        const auto to = [&](std::uint32_t i) {
            return std::max(Scale::between(from.coordinate[0], tree[i].coordinate[0]),
                            Scale::between(from.coordinate[1], tree[i].coordinate[1]));
        };
        const std::uint64_t limit = to(std::uint32_t(random() % count)), wanted = 1 + random() % 3;
        std::uint64_t nearest = limit;
        std::vector<std::uint32_t> within, seen, marked;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (to(i) <= limit) within.push_back(i);
            if ((marks[i] & wanted) == 0) continue;
            if (to(i) <= limit) marked.push_back(i);
            nearest = std::min(nearest, to(i));
        }
        tree.visit_within<Scale>(from, limit, [&](std::uint32_t i) {
            seen.push_back(i);
            return true;
        });
        std::sort(seen.begin(), seen.end());
        CHECK(seen == within);
        CHECK(tree.nearest<Scale>(from, limit, wanted) == nearest);
        // Found one by one: each that is refused is not the last.
        seen.clear();
        CHECK(tree.find<Scale>(from, limit, wanted, [&](std::uint32_t i) {
            seen.push_back(i);
            return false;
        }) == none);
        std::sort(seen.begin(), seen.end());
        CHECK(seen == marked);
        const std::uint32_t first = tree.find<Scale>(from, limit, wanted, [](std::uint32_t) { return true; });
        CHECK((first == none) == marked.empty());
        if (first != none) CHECK(std::find(marked.begin(), marked.end(), first) != marked.end());
    }
}

}  // namespace

TEST_CASE("a tree of points finds all within a limit, those at the limit too") {
    std::mt19937 random(91);
    for (const std::uint32_t count : {1u, 2u, 3u, 10u, 100u, 400u})
        for (const std::uint32_t values : {3u, 20u, 1000u}) {
            CAPTURE(count);
            CAPTURE(values);
            check_searches<PlainScale>(count, values, random);
            check_searches<LogScale>(count, values, random);
        }
}
