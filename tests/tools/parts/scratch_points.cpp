// Points that are put in order on disk: what the engine makes of all of them in memory.
#include "tools/pieces/scratch_points.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "netmesh.hpp"
#include <doctest/doctest.h>

namespace netmesh::tool {
namespace {

using Rows = std::vector<double>;

struct Cut {
    std::vector<std::uint32_t> order;
    Rows boxes, points;
    std::uint64_t fingerprint = 0;
    std::uint32_t levels = 0;
    bool good = false;
};

class Block {
public:
    // NETMESH_OK, or what the engine says.
    netmesh_status split(const double* first, std::size_t count, std::uint32_t dim, std::size_t stride,
                         std::uint32_t pieces, netmesh_split_result* made) {
        memory_.assign(std::size_t{1} << 17, 0);
        engine_ = Engine(memory_.data(), memory_.size() * 8);
        netmesh_split_request r = sized<netmesh_split_request>();
        r.pieces = pieces;
        r.points = {first, count, dim, NETMESH_POINTS_FLOAT64, stride};
        *made = sized<netmesh_split_result>();
        const netmesh_status status = netmesh_split(engine_.context(), &r);
        return status == NETMESH_OK ? netmesh_get_split(engine_.context(), made) : status;
    }

private:
    std::vector<double> memory_;
    Engine engine_{nullptr, 0};
};

Cut in_memory(const Rows& rows, std::uint32_t dim, std::uint32_t pieces) {
    Block block;
    Cut cut;
    netmesh_split_result made;
    cut.good = block.split(rows.data(), rows.size() / dim, dim, 0, pieces, &made) == NETMESH_OK;
    if (!cut.good) return cut;
    cut.order.assign(made.order, made.order + made.count);
    cut.boxes.assign(made.boxes, made.boxes + made.box_count * 2 * dim);
    for (const std::uint32_t row : cut.order)
        cut.points.insert(cut.points.end(), &rows[std::size_t{row} * dim], &rows[std::size_t{row} * dim] + dim);
    cut.fingerprint = made.fingerprint;
    cut.levels = made.levels;
    return cut;
}

Cut on_disk(const std::string& folder, const Rows& rows, std::uint32_t dim, std::uint32_t pieces, std::uint64_t most) {
    ScratchPoints points;
    Block block;
    Cut cut;
    REQUIRE(points.open(folder, dim, most).good());
    const std::size_t half = rows.size() / dim / 2 * dim;
    REQUIRE(points.add(Rows(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(half))).good());
    REQUIRE(points.add(Rows(rows.begin() + static_cast<std::ptrdiff_t>(half), rows.end())).good());
    REQUIRE(points.end().good());
    const SplitNode split = [&](const Records& records, std::uint32_t parts, netmesh_split_result* made) {
        const std::size_t words = std::size_t{dim} + 1;
        const netmesh_status status = block.split(records.data(), records.size() / words, dim, 8 * words, parts, made);
        if (status != NETMESH_OK) *made = {};
        return status == NETMESH_OK || status == NETMESH_INVALID_ARGUMENT ? Outcome{} : data_error("engine");
    };
    PiecesJob job = {};
    job.pieces = pieces;
    const Outcome outcome = points.write(folder + "/points", "a.csv", split, &job);
    cut.good = outcome.good();
    if (!cut.good) {
        CHECK(outcome.exit == Exit::usage);
        CHECK(!std::filesystem::exists(folder + "/points"));
        return cut;
    }
    PointsFile file;
    REQUIRE(file.open(folder + "/points").good());
    const netmesh_source source = file.source();
    cut.levels = source.levels;
    cut.fingerprint = source.fingerprint;
    CHECK(source.rows == rows.size() / dim);
    cut.points.resize(source.count * dim);
    cut.order.resize(source.count);
    for (std::uint64_t at = 0; at < source.count; at += 16) {
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(16, source.count - at));
        REQUIRE(source.read(source.user, at, count, &cut.points[at * dim], &cut.order[at]) == NETMESH_OK);
    }
    const std::uint32_t nodes = (2u << source.levels) - 1;
    cut.boxes.resize(std::size_t{nodes} * 2 * dim);
    for (std::uint32_t node = 1; node <= nodes; node++)
        REQUIRE(source.box(source.user, node, &cut.boxes[std::size_t{node - 1} * 2 * dim]) == NETMESH_OK);
    std::filesystem::remove(folder + "/points");
    CHECK(std::filesystem::is_empty(folder));
    return cut;
}

// A cloud of a kind by number.
Rows cloud(unsigned kind, std::size_t count, std::uint32_t dim, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    Rows rows;
    for (std::size_t i = 0; i < count; i++) {
        const double scale = std::ldexp(1.0, static_cast<int>(random() % 1200) - 600);
        for (std::uint32_t k = 0; k < dim; k++) {
            const double x = uniform(random);
            const double kinds[] = {x,
                                    std::floor(6 * x) + 0.0,
                                    1,
                                    k == 0 ? x : 0.25,
                                    k + 1 == dim ? std::floor(2 * x) + 0.0 : x,
                                    x * scale,
                                    i % 3 == 0 ? 0.5 : x,
                                    std::floor(64 * x) / 64 + 0.0};
            rows.push_back(kinds[kind % std::size(kinds)]);
        }
    }
    return rows;
}

TEST_CASE("scratch points: the order and the boxes that the engine makes in memory") {
    char name[] = "/tmp/netmesh-test-XXXXXX";
    const std::string folder = mkdtemp(name);
    std::mt19937_64 random(7);
    unsigned cuts = 0;
    for (unsigned trial = 0; trial < 400; trial++) {
        const std::uint32_t dim = 2 + trial / 8 % 2, pieces = 1u << random() % 6;
        const std::size_t count = 1 + random() % (trial % 3 == 0 ? 40 : 3000);
        const Rows rows = cloud(trial, count, dim, random);
        CAPTURE(trial);
        CAPTURE(count);
        const Cut due = in_memory(rows, dim, pieces);
        const Cut made = on_disk(folder, rows, dim, pieces, 64 + random() % 200);
        REQUIRE(made.good == due.good);
        if (!due.good) continue;
        cuts++;
        CHECK(made.levels == due.levels);
        CHECK(made.fingerprint == due.fingerprint);
        CHECK(made.order == due.order);
        CHECK(made.points == due.points);
        CHECK(made.boxes == due.boxes);
    }
    CHECK(cuts > 300);
    std::filesystem::remove_all(folder);
}

TEST_CASE("scratch points: more records than are read at once") {
    char name[] = "/tmp/netmesh-test-XXXXXX";
    const std::string folder = mkdtemp(name);
    std::mt19937_64 random(3);
    for (const unsigned kind : {0u, 1u, 6u}) {
        Rows rows = cloud(kind, 60000, 2, random);
        std::string files[2];
        for (int i = 0; i < 2; i++) {
            ScratchPoints points;
            REQUIRE(points.open(folder, 2, i == 0 ? 3000 : 100000).good());
            REQUIRE(points.add(rows).good());
            REQUIRE(points.end().good());
            std::vector<double> memory(std::size_t{1} << 20);
            Engine engine(nullptr, 0);
            const SplitNode split = [&](const Records& records, std::uint32_t parts, netmesh_split_result* made) {
                engine = Engine(memory.data(), memory.size() * 8);
                netmesh_split_request r = sized<netmesh_split_request>();
                r.pieces = parts;
                r.points = {records.data(), records.size() / 3, 2, NETMESH_POINTS_FLOAT64, 24};
                *made = sized<netmesh_split_result>();
                const bool good = netmesh_split(engine.context(), &r) == NETMESH_OK &&
                                  netmesh_get_split(engine.context(), made) == NETMESH_OK;
                if (!good) *made = {};
                return Outcome{};
            };
            PiecesJob job = {};
            job.pieces = 8;
            REQUIRE(points.write(folder + "/points", "a", split, &job).good());
            std::string why;
            REQUIRE(platform::read_file(folder + "/points", &files[i], &why));
        }
        CHECK(files[0] == files[1]);
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace netmesh::tool
