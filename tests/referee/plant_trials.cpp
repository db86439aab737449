#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "trials.hpp"

namespace referee {
namespace {

struct GoodMesh {
    unsigned ground;
    Case wanted;
    Mesh mesh;
    double worst;
};

struct GroundKind {
    unsigned ground;
    const char* name;
    std::vector<std::string> arguments;
};

std::string choose(int dim, const char* two, const char* three, const char* four) {
    return dim == 2 ? two : dim == 3 ? three : four;
}

std::vector<GroundKind> ground_kinds(int dim) {
    const std::string tau = choose(dim, "3.3", "3.3", "4.5");  // above the default
    std::vector<GroundKind> all = {
        {triangulation, "triangulation", {"delaunay"}},
        {plain, "svr", {"mesh", "--tau", tau}},
        {caged, "cages", {"mesh", "--method", "netmesh", "--tau", tau}},
        {sized, "eps", {"mesh", "--tau", tau, "--eps", choose(dim, "0.6", "1", "1.5")}},
        {sized, "cell-size", {"mesh", "--tau", tau, "--cell-size", choose(dim, "0.2,0.3", "0.6,0.3", "1.2,0.3")}},
        {certified, "ratio", {"persist", "--max-degree", "0", "--whole-cells"}},
        {clipped, "clipped ratio", {"persist", "--max-degree", "0"}},
    };
    // Their shells have 120 and 1,000 vertices in R^4.
    if (dim < 4) {
        all.push_back({thesis, "cages of the thesis", {"mesh", "--method", "netmesh", "--cages", "thesis"}});
        all.push_back({netted, "net", {"mesh", "--method", "refine", "--tau", tau}});
        all.push_back({netted, "fine net", {"mesh", "--method", "refine", "--tau", tau, "--net", "0.3"}});
    }
    return all;
}

Points ground_points(unsigned ground, int dim, Random& random) {
    Points points;
    const std::size_t count = dim == 2 ? 14 : dim == 3 ? 10 : 7;
    if (ground == caged || ground == thesis) {  // clusters far apart for their width
        const std::size_t centres = 3;
        for (std::size_t i = 0; i < 3 * centres; i++) {
            Point x = random.direction(dim);
            for (int k = 0; k < dim; k++) x[k] *= 1e-4;
            if (i % centres > 0) x[i % centres - 1] += 1;
            points.push_back(x);
        }
        return points;
    }
    for (std::size_t i = 0; i < count; i++) {
        Point x = random.direction(dim);
        const double length = ground == netted ? 1 : random.between(0.05, 1);
        for (int k = 0; k < dim; k++) x[k] *= length;
        points.push_back(x);
        if (ground == netted && i == 3) break;
    }
    return points;
}

// A mesh of that kind that the referee accepts; empty when there is none in a few tries.
std::vector<GoodMesh> good_mesh(const Tool& tool, const Settings& settings, const GroundKind& kind, int dim,
                                Random& random) {
    const bool is_persist = kind.ground == certified || kind.ground == clipped;
    for (int trial = 0; trial < 12; trial++) {
        GoodMesh made = {kind.ground, {}, {}, 0};
        made.wanted.points = ground_points(kind.ground, dim, random);
        made.wanted.dim = dim;
        made.wanted.is_mesh = kind.ground != triangulation;
        made.wanted.has_cages = kind.ground == caged || kind.ground == thesis;
        made.wanted.samples = 2000;
        write_points(tool.path("ground.txt"), made.wanted.points, dim);
        std::vector<std::string> arguments = kind.arguments;
        arguments.insert(arguments.begin() + 1, tool.path("ground.txt"));
        arguments.insert(arguments.end(), {is_persist ? "--mesh" : "-o", tool.path("ground.node"), "--quiet"});
        if (is_persist) arguments.insert(arguments.end(), {"-o", tool.path("ground.pers")});
        if (tool.run(arguments, settings.seconds).exit != done) continue;
        if (!read_mesh(tool.path("ground"), &made.mesh).empty()) continue;
        if (made.wanted.has_cages && made.mesh.cages.size() < 2) continue;
        if (made.mesh.clipped != (kind.ground == clipped)) continue;
        const Verdict verdict = judge(made.mesh, made.wanted, random);
        if (!verdict.good() || tool.check(made.mesh, &made.wanted.points).exit != done) continue;
        made.worst = verdict.worst_ratio;
        made.wanted.first_fault = true;
        return {made};
    }
    return {};
}

struct Planted {
    bool done = false;
    Mesh mesh;
    std::string refusal;  // of the referee; empty: it saw nothing
};

Planted plant_in(const Tool& tool, const Plant& plant, const GoodMesh& good, Random& random) {
    for (int trial = 0; trial < 24; trial++) {
        Planted planted;
        planted.mesh = good.mesh;
        const Planter planter = {tool, good.mesh, random, good.worst};
        if (!plant.plant(&planted.mesh, planter)) continue;
        planted.done = true;
        const Verdict verdict = judge(planted.mesh, good.wanted, random);
        if (!verdict.good()) planted.refusal = verdict.faults[0].promise + ": " + verdict.faults[0].text;
        if (!verdict.good() || plant.certain) return planted;
    }
    return {};
}

void try_plant(const Tool& tool, const Settings& settings, const Plant& plant, const GroundKind& kind,
               const GoodMesh& good, Random& random, const std::string& replay, Account* account) {
    const Planted planted = plant_in(tool, plant, good, random);
    if (!planted.done) return;
    account->planted[plant.name]++;
    const auto fail = [&](const std::string& what) {
        account->failures++;
        std::printf("FAILED plant: %s; in a mesh by %s, D = %d  (--plants %s)\n       %s\n", plant.name, kind.name,
                    good.wanted.dim, replay.c_str(), what.c_str());
        std::fflush(stdout);
        if (settings.keep.empty()) return;
        std::filesystem::create_directories(settings.keep);
        std::string name = std::string(plant.name) + " " + kind.name + " " + std::to_string(good.wanted.dim);
        for (char& c : name)
            if (c == ' ' || c == ',') c = '_';
        write_mesh(settings.keep + "/" + name, planted.mesh);
        write_points(settings.keep + "/" + name + ".txt", good.wanted.points, good.wanted.dim);
    };
    if (planted.refusal.empty()) return fail("the referee sees nothing");
    const Outcome outcome = tool.check(planted.mesh, &good.wanted.points);
    if (outcome.exit == check_exit || (plant.malformed && outcome.exit == data_exit)) {
        account->seen[plant.name]++;
        return;
    }
    const std::string said =
        outcome.exit == done ? "accepts it" : "exits with " + count_text(outcome.exit) + ": " + outcome.message;
    fail("`check` " + said + "; the referee: " + planted.refusal);
}

}  // namespace

void try_plants(const Tool& tool, const Settings& settings, int dim, std::uint64_t seed, Account* account) {
    const std::string replay = count_text(dim) + ":" + count_text(seed);
    const std::vector<GroundKind> kinds = ground_kinds(dim);
    std::vector<std::vector<GoodMesh>> good;
    Random random(seed);
    for (const GroundKind& kind : kinds) {
        good.push_back(good_mesh(tool, settings, kind, dim, random));
        if (!good.back().empty()) continue;
        account->failures++;
        std::printf("FAILED no good mesh by %s to plant in, D = %d  (--plants %s)\n", kind.name, dim, replay.c_str());
    }
    std::size_t number = 0;
    for (const auto* list : {&cell_plants(), &vertex_plants(), &remark_plants(), &cage_plants()})
        for (const Plant& plant : *list) {
            std::vector<std::size_t> suited;
            for (std::size_t k = 0; k < kinds.size(); k++)
                if ((plant.grounds & kinds[k].ground) != 0 && !good[k].empty()) suited.push_back(k);
            account->planted[plant.name] += 0;
            number++;
            if (suited.empty()) continue;
            const std::size_t only = suited[Random(seed + number).below(suited.size())];
            for (const std::size_t k : suited) {
                Random own(seed ^ (1000 * number + k));
                if (settings.every_ground || k == only)
                    try_plant(tool, settings, plant, kinds[k], good[k][0], own, replay, account);
            }
        }
}

}  // namespace referee
