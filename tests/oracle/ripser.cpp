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
Diagram ripser(int dim, const inputs::Points& points, int max_degree) {
    char name[] = "/tmp/netmesh-ripser-XXXXXX";
    const int file = mkstemp(name);
    REQUIRE(file >= 0);
    std::FILE* const out = fdopen(file, "w");
    for (std::size_t i = 0; i < points.size(); ++i)
        std::fprintf(out, "%.17g%c", points[i], (i + 1) % static_cast<std::size_t>(dim) == 0 ? '\n' : ' ');
    std::fclose(out);
    const std::string command =
        std::string("ripser --format point-cloud --dim ") + std::to_string(max_degree) + ' ' + name;
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

void compare(int dim, const inputs::Points& points, int max_degree) {
    if (dimensions({dim}).empty()) return;
    CAPTURE(dim);
    CAPTURE(max_degree);
    Session session(dim);
    const std::size_t n = points.size() / static_cast<std::size_t>(dim);
    const std::uint32_t degree = static_cast<std::uint32_t>(max_degree);
    REQUIRE(session.points(session.points_request(points, NETMESH_FILTER_RIPS, 1, degree)) == NETMESH_OK);
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
}
