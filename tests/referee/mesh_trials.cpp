#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "refusals.hpp"
#include "trials.hpp"

namespace referee {
namespace {

struct Method {
    const char* name;
    std::vector<std::string> arguments;  // before the points
    bool is_mesh, has_cages, takes_eps;
};

const std::vector<Method>& methods() {
    static const std::vector<Method> all = {
        {"delaunay", {"delaunay"}, false, false, false},
        {"svr", {"mesh", "--method", "svr"}, true, false, true},
        {"netmesh", {"mesh", "--method", "netmesh"}, true, true, false},
        {"netmesh with cages of the thesis", {"mesh", "--method", "netmesh", "--cages", "thesis"}, true, true, false},
        {"netmesh finished", {"mesh", "--method", "netmesh", "--finish"}, true, false, true},
        {"refine", {"mesh", "--method", "refine"}, true, false, false},
        {"persist", {"persist", "--max-degree", "0"}, true, false, false},
        {"persist with whole cells", {"persist", "--max-degree", "0", "--whole-cells"}, true, false, false},
    };
    return all;
}

// Is the refusal one of those that are documented? Fills in what is wrong otherwise.
bool may_refuse(const Outcome& outcome, const Method& method, const Case& wanted, bool asks_for_size) {
    const Points points = distinct(wanted.points, wanted.dim);
    if (outcome.exit == memory_exit) return true;
    if (!method.is_mesh) return outcome.exit == degenerate_exit && is_flat(points, wanted.dim);
    if (outcome.exit == degenerate_exit)
        return has_close_points(points, wanted.dim, least_units(wanted.tau, wanted.dim));
    if (outcome.exit == data_exit) return is_out_of_range(points, wanted.dim) || asks_for_size;
    return false;
}

void keep_files(const Tool& tool, const Settings& settings, const std::string& name) {
    if (settings.keep.empty()) return;
    std::filesystem::create_directories(settings.keep);
    for (const char* const ending : {".txt", ".node", ".ele", ".neigh"}) {
        std::error_code ignored;
        std::filesystem::copy(tool.path(std::string("trial") + ending), settings.keep + "/" + name + ending,
                              std::filesystem::copy_options::overwrite_existing, ignored);
    }
}

std::string name_of_files(const std::string& title) {
    std::string name = title;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

void run_trial(const Tool& tool, const Settings& settings, const Method& method, Case wanted, const std::string& title,
               Random& random, Account* account) {
    account->trials++;
    const auto fail = [&](const std::string& what) {
        account->failures++;
        std::printf("FAILED %s\n       %s\n", title.c_str(), what.c_str());
        std::fflush(stdout);
        keep_files(tool, settings, name_of_files(title));
    };
    wanted.is_mesh = method.is_mesh;
    wanted.has_cages = method.has_cages;
    wanted.samples = settings.samples;
    wanted.cells_max = wanted.dim > 3 ? settings.cells_max : 10 * settings.cells_max;
    write_points(tool.path("trial.txt"), wanted.points, wanted.dim);
    std::vector<std::string> arguments = method.arguments;
    const bool is_persist = arguments[0] == "persist";
    arguments.insert(arguments.begin() + 1, tool.path("trial.txt"));
    arguments.insert(arguments.end(), {is_persist ? "--mesh" : "-o", tool.path("trial.node"), "--quiet"});
    arguments.insert(arguments.end(), {"--memory", "400M"});
    if (is_persist) arguments.insert(arguments.end(), {"-o", tool.path("trial.pers")});
    if (wanted.tau > 0) arguments.insert(arguments.end(), {"--tau", number_text(wanted.tau)});
    if (wanted.eps > 0) arguments.insert(arguments.end(), {"--eps", number_text(wanted.eps)});
    if (wanted.least_size > 0)
        arguments.insert(arguments.end(),
                         {"--cell-size", number_text(wanted.least_size) + "," + number_text(wanted.growth)});
    if (is_persist) wanted.tau = 0;  // the file says a ratio instead
    if (wanted.net > 0) arguments.insert(arguments.end(), {"--net", number_text(wanted.net)});
    const Outcome outcome = tool.run(arguments, settings.seconds);
    if (outcome.exit == out_of_time || outcome.exit == memory_exit) {
        account->too_large++;
        return;
    }
    if (outcome.exit != done) {
        account->refused++;
        if (!may_refuse(outcome, method, wanted, wanted.eps > 0 || wanted.least_size > 0 || wanted.net > 0))
            fail("exit " + count_text(outcome.exit) + ": " + outcome.message);
        return;
    }
    Mesh mesh;
    const std::string unreadable = read_mesh(tool.path("trial"), &mesh);
    if (!unreadable.empty()) return fail(unreadable);
    account->meshes++;
    const Verdict verdict = judge(mesh, wanted, random);
    if (mesh.ratio == 0 && mesh.has_domain)
        account->worst_sampled = std::max(account->worst_sampled, verdict.sampled_ratio / promised_tau(mesh));
    const Outcome checked =
        tool.run({"check", tool.path("trial.node"), "--points", tool.path("trial.txt"), "--quiet"}, 120);
    if (verdict.good() && checked.exit == out_of_time) {  // no word against the mesh
        account->too_large++;
        return;
    }
    std::string what = faults_text(verdict);
    if (verdict.good() && checked.exit != done) what = "`check` refuses what the referee accepts: " + checked.message;
    if (!verdict.good())
        what += "`check` " + (checked.exit == done ? std::string("accepts it") : "says: " + checked.message);
    if (!what.empty()) fail(count_text(mesh.count()) + " vertices; " + what);
}

}  // namespace

void try_family(const Tool& tool, const Settings& settings, int dim, std::size_t family, std::uint64_t seed,
                Account* account) {
    Random random(seed);
    const Family& made = families()[family];
    Case wanted;
    wanted.dim = dim;
    wanted.points =
        made.make(dim, std::max<std::size_t>(3, settings.size[dim] / 2 + random.below(settings.size[dim])), random);
    const bool is_small = wanted.points.size() <= 5;
    std::size_t pick = random.below(methods().size());
    // Its net alone has thousands of vertices from D = 3 on.
    const bool is_refine = methods()[pick].arguments.back() == "refine";
    if (is_refine && (dim > 3 || (dim == 3 && wanted.points.size() > settings.refined))) pick = 1;
    if (dim > 3 && methods()[pick].arguments.back() == "thesis") pick = 2;
    const Method& method = methods()[pick];
    const bool has_thesis_cages = method.arguments.back() == "thesis";
    if (method.is_mesh && random.below(2) == 0)
        wanted.tau = std::round(100 * random.between(has_thesis_cages ? 3.4 : dim > 3 ? 3 : 2.3, 6)) / 100;
    if (method.takes_eps && is_small && random.below(2) == 0) wanted.eps = dim > 3 ? 1 : 0.5;
    if (method.takes_eps && wanted.eps == 0 && random.below(3) == 0) {
        double width = 0;
        for (const Point& p : wanted.points) width = std::max(width, distance(p, wanted.points[0], dim));
        wanted.least_size = std::stod(number_text((dim == 2 ? 0.1 : dim == 3 ? 0.4 : 1) * width));
        wanted.growth = random.below(2) == 0 ? 0 : 0.3;
    }
    if (method.arguments.back() == "refine" && random.below(2) == 0)
        wanted.net = std::round(100 * random.between(0.1, 3)) / 100;
    const std::string replay = count_text(dim) + ":" + count_text(family) + ":" + count_text(seed);
    std::string title = "D = " + count_text(dim) + ", " + made.name + ", " + count_text(wanted.points.size()) +
                        " points, " + method.name;
    if (wanted.tau > 0) title += ", tau " + number_text(wanted.tau);
    if (wanted.least_size > 0)
        title += ", cell-size " + number_text(wanted.least_size) + "," + number_text(wanted.growth);
    if (wanted.net > 0) title += ", net " + number_text(wanted.net);
    if (wanted.eps > 0) title += ", eps " + number_text(wanted.eps);
    run_trial(tool, settings, method, wanted, title + "  (--trial " + replay + ")", random, account);
}

void try_named(const Tool& tool, const Settings& settings, std::size_t share, int dim_most, Account* account) {
    for (const NamedInput& input : named_inputs(share)) {
        if (input.dim > dim_most) continue;
        Case wanted;
        wanted.points = input.points;
        wanted.dim = input.dim;
        wanted.tau = input.tau;
        for (const std::size_t pick : {1, 2}) {
            Random random(pick);
            const Method& method = methods()[pick];
            run_trial(tool, settings, method, wanted, std::string(input.name) + ", " + method.name, random, account);
        }
    }
}

}  // namespace referee
