// Values that may be near another, against all pairs.
#include "numerics/close_values.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "numerics/real.hpp"

using namespace netmesh;

namespace {

// Values that may be close: found[i], and how often a stretch was met again.
std::vector<bool> search(const std::vector<double>& values, double spread, std::size_t* again) {
    Block block(std::size_t{1} << 22);
    CloseValues close;
    REQUIRE(close.take(values.size(), spread, block.arena));
    *again = 0;
    for (const double x : values) *again += close.add(x);
    std::vector<bool> found;
    for (const double x : values) found.push_back(close.found(x));
    return found;
}

}  // namespace

TEST_CASE("no value that has another within the spread is left out") {
    inputs::Random random(5);
    for (const double spread : {0x1p-51, 0x1p-40, 0x1p-33, 0x1p-21}) {
        for (const double size : {1.0, 0x1p-1070, 0x1p1020}) {
            CAPTURE(spread);
            CAPTURE(size);
            // Some across a power of two, all with a partner at a bit less than twice the spread.
            std::vector<double> values;
            for (int i = 0; i < 200; ++i) {
                const double x = size * (i % 4 == 0 ? 1 - random.uniform() * spread : 1 + random.uniform());
                values.push_back(x);
                values.push_back(x * (1 + spread * (i % 3)) * (1 + spread * (i % 2) * 0.99));
            }
            std::size_t again;
            const std::vector<bool> found = search(values, spread, &again);
            std::size_t missed = 0, count = 0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                bool close = false;
                for (std::size_t j = 0; j < values.size() && !close; ++j)
                    close = i != j && values[i] * (1 - spread) <= values[j] * (1 + spread) &&
                            values[j] * (1 - spread) <= values[i] * (1 + spread);
                missed += close && !found[i];
                count += found[i];
            }
            CHECK(missed == 0);
            CHECK(count <= 2 * again);
            CHECK(count > 100);
        }
    }
}

TEST_CASE("few values that are far from all others are taken for close ones") {
    inputs::Random random(6);
    std::vector<double> values;
    for (int i = 0; i < 20000; ++i) values.push_back(1 + random.uniform());
    std::size_t again, count = 0;
    for (const bool found : search(values, 0x1p-45, &again)) count += found;
    CHECK(count < 20000 / 5);
    CHECK(count > 0);
}

TEST_CASE("the table asks for room") {
    Block block(1000);
    CloseValues close;
    CHECK(!close.take(1000, 0x1p-40, block.arena));
    CHECK(close.take(10, 0x1p-40, block.arena));
    CHECK(close.add(1.3) == 0);
    CHECK(!close.found(1.3));
    CHECK(close.add(1.3) == 1);
    CHECK(close.found(1.3));
}
