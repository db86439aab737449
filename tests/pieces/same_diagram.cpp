// Diagrams in pieces are those of one block: reports with their fingerprints, on small clouds of all families.
#include <cstdlib>
#include <doctest/doctest.h>

#include "common/kinds.hpp"
#include "exact/families.hpp"
#include "pieces/in_memory.hpp"

namespace {

// What differs between the diagram of one block and that in pieces; empty: nothing.
std::string difference(int dim, const inputs::Points& points, pieces::Options options) {
    Session whole(dim), part(dim);
    netmesh::Request r = whole.alpha_request(points);
    r.max_degree = options.max_degree;
    r.keep_zero_pairs = options.keep_zero;
    const netmesh_status wanted = whole.persist_until_it_fits(r);
    for (pieces::Split fewer(dim, points, options.pieces); fewer.status == NETMESH_INVALID_ARGUMENT;) {
        options.pieces /= 2;  // more than different points
        if (pieces::Split(dim, points, options.pieces).status != NETMESH_INVALID_ARGUMENT) break;
    }
    const pieces::Split split(dim, points, options.pieces);
    if (split.status != NETMESH_OK) return wanted == split.status ? "" : "split says " + std::to_string(split.status);
    std::map<std::uint32_t, pieces::Bytes> all;
    const netmesh_status got = pieces::run(part, split.source, options, &all);
    if (got != wanted) return "status " + std::to_string(got) + " in place of " + std::to_string(wanted);
    if (wanted != NETMESH_OK) return "";
    const netmesh_report a = whole.report(), b = part.report();
    for (std::uint32_t k = 0; k <= a.diagram.max_degree; ++k)
        if (a.diagram.pairs[k] != b.diagram.pairs[k])
            return "bars of degree " + std::to_string(k) + ": " + std::to_string(b.diagram.pairs[k]) + " in place of " +
                   std::to_string(a.diagram.pairs[k]);
    if (a.diagram.simplices != b.diagram.simplices)
        return "simplices: " + std::to_string(b.diagram.simplices) + " in place of " +
               std::to_string(a.diagram.simplices);
    return a.fingerprint == b.fingerprint ? "" : "the fingerprint";
}

}  // namespace

TEST_CASE("small clouds of all families, in 1 to 32 pieces") {
    const char* const more = std::getenv("NETMESH_PIECES_CLOUDS");
    const int clouds = more != nullptr ? std::atoi(more) : 12;
    families::Random random(more != nullptr ? 77 : 7);
    int done = 0;
    for (int cloud = 0; cloud < clouds; ++cloud)
        for (const families::Family& family : families::all()) {
            const int dim = random.whole(2, 5);
            const std::size_t most = dim < 4 ? 120 : dim == 4 ? 40 : 20;
            const std::size_t n = static_cast<std::size_t>(random.whole(1, static_cast<int>(most)));
            inputs::Points points = family.make(random, dim, n);
            if (random.one_in(2)) families::move_units(random, random.whole(0, 3), &points);
            pieces::Options options;
            options.pieces = 1u << random.whole(0, 5);
            const std::size_t rows = points.size() / static_cast<std::size_t>(dim);
            while (options.pieces > rows) options.pieces /= 2;
            options.order = random.bits();
            if (random.one_in(4)) options.max_degree = static_cast<std::uint32_t>(random.whole(0, dim - 1));
            options.keep_zero = random.one_in(4);
            const std::string what = difference(dim, points, options);
            INFO("family ", std::string(family.name), ", cloud ", cloud, ", D = ", dim, ", ", rows, " rows, ",
                 options.pieces, " pieces, degree ", options.max_degree, ", zero ", options.keep_zero);
            CHECK(what == "");
            ++done;
        }
    MESSAGE(done, " clouds");
}
