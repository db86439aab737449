// Rips diagrams against ripser, where one is on the path. It prints six digits.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/bottleneck.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/session.hpp"

namespace {

using Diagram = std::vector<netmesh_pair>;

bool has_ripser() { return std::system("command -v ripser >/dev/null 2>&1") == 0; }

// Bars of positive length, values halved to radii.
Diagram ripser(const std::string& input, const std::string& options) {
    char name[] = "/tmp/netmesh-ripser-XXXXXX";
    const int file = mkstemp(name);
    REQUIRE(file >= 0);
    std::FILE* const out = fdopen(file, "w");
    std::fputs(input.c_str(), out);
    std::fclose(out);
    const std::string command = "ripser " + options + ' ' + name;
    std::FILE* const in = popen(command.c_str(), "r");
    REQUIRE(in != nullptr);
    Diagram bars;
    std::uint32_t degree = 0;
    char line[256];
    while (std::fgets(line, sizeof line, in) != nullptr) {
        double birth, death;
        std::sscanf(line, "persistence intervals in dim %u", &degree);
        const int read = std::sscanf(line, " [%lf,%lf", &birth, &death);
        if (read >= 1) bars.push_back(bar(degree, birth / 2, read == 2 ? death / 2 : HUGE_VAL));
    }
    CHECK(pclose(in) == 0);
    std::remove(name);
    return bars;
}

std::string text_of(double x, char behind) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g%c", x, behind);
    return text;
}

Diagram ripser(int dim, const inputs::Points& points, int max_degree) {
    std::string input;
    for (std::size_t i = 0; i < points.size(); ++i)
        input += text_of(points[i], (i + 1) % static_cast<std::size_t>(dim) == 0 ? '\n' : ' ');
    return ripser(input, "--format point-cloud --dim " + std::to_string(max_degree));
}

// Random numbers, no metric; threshold: a radius.
void compare_distances(std::uint32_t n, std::uint32_t max_degree, double threshold) {
    CAPTURE(n);
    CAPTURE(threshold);
    std::vector<double> lower;
    std::string input;
    std::uint64_t seed = n;
    for (std::uint32_t i = 1; i < n; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            lower.push_back(1 + static_cast<double>(seed >> 40) / 0x1p24);
            input += text_of(lower.back(), j + 1 < i ? ',' : '\n');
        }
    }
    auto distances = netmesh::sized<netmesh_distances>();
    distances.layout = NETMESH_DISTANCES_LOWER;
    distances.numbers = lower.data();
    distances.count = n;
    netmesh::Request request(&netmesh_filter_rips);
    request.distances = &distances;
    request.max_degree = max_degree;
    std::string options = "--format lower-distance --dim " + std::to_string(max_degree);
    if (threshold < HUGE_VAL) options += " --threshold " + text_of(2 * threshold, ' ');
    request.threshold = threshold;
    Session session(2);
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    const Diagram theirs = ripser(input, options);
    CHECK(theirs.size() >= n);
    const Distance d = bottleneck(session.pairs(), theirs);
    REQUIRE(d.status == NETMESH_OK);
    CHECK(d.value <= 1e-5);
}

void compare(int dim, const inputs::Points& points, int max_degree) {
    if (dimensions({dim}).empty()) return;
    CAPTURE(dim);
    CAPTURE(max_degree);
    Session session(dim);
    const std::size_t n = points.size() / static_cast<std::size_t>(dim);
    const std::uint32_t degree = static_cast<std::uint32_t>(max_degree);
    REQUIRE(session.persist_until_it_fits(session.points_request(points, &netmesh_filter_rips, 1, degree)) ==
            NETMESH_OK);
    const Diagram ours = session.pairs(), theirs = ripser(dim, points, max_degree);
    CHECK(theirs.size() >= n);
    const Distance d = bottleneck(ours, theirs);
    REQUIRE(d.status == NETMESH_OK);
    CHECK(d.value <= 1e-5);
}

}  // namespace

TEST_CASE("Rips diagrams are ripser's") {
    if (!has_ripser()) {
        MESSAGE("there is no ripser on the path: the comparison with it is left out");
        return;
    }
    compare(2, inputs::circle(60), 2);
    compare(2, inputs::uniform(2, 300), 1);
    compare(3, inputs::torus(150, 1), 2);
    compare(3, inputs::shell(3, 120, 1, 1, 2), 2);
    compare(4, inputs::clifford(100), 1);
    compare(6, inputs::uniform(6, 30), 4);
    compare_distances(60, 1, HUGE_VAL);
    compare_distances(40, 2, HUGE_VAL);
    compare_distances(60, 2, 0.7);
}
