// Every option of every command, with filters and files of every kind: it changes what comes out, or is refused by
// name.
#include "run.hpp"

#include <doctest/doctest.h>

#include <map>

#include "tools/option_table.hpp"

using namespace netmesh::tool;

namespace {

using Words = std::map<std::string, std::string>;

// A value of each option that none of the commands below takes by default.
const Words values = {{"--least", "1.5"},
                      {"--min-persistence", "1.5"},
                      {"--top", "1"},
                      {"--columns", "2,1"},
                      {"--radii", "2"},
                      {"--weights", "1"},
                      {"--box", "3,3"},
                      {"--cell", "3,0/1,3"},
                      {"--delimiter", "'|'"},
                      {"--skip", "2"},
                      {"-n", "20"},
                      {"--pieces", "2"},
                      {"--jobs", "2"},
                      {"--scratch", "pieces"},
                      {"--dim", "5"},
                      {"--tau", "3.3"},
                      {"--eps", ".3"},
                      {"--cell-size", ".2"},
                      {"--domain", "2"},
                      {"--net", ".5"},
                      {"--pace", "out.pace"},
                      {"--theta", ".05"},
                      {"--weighted-cells", "out.cells"},
                      {"--ratio", "3"},
                      {"--focus", "1.5"},
                      {"--longer-than", "2"},
                      {"--from", ".2"},
                      {"--to", ".7"},
                      {"--axis", "linear"},
                      {"--method", "refine"},
                      {"--cages", "thesis"},
                      {"--audit", "quality"},
                      {"--filter", "alpha"},
                      {"--threshold", ".4"},
                      {"--k", "3"},
                      {"--values", "thesis"},
                      {"--complex", "complex.txt"},
                      {"--function", "x+y"},
                      {"--values-at", "values.txt"},
                      {"--lipschitz", "2"},
                      {"--cut", "-.1"},
                      {"--error", ".5"},
                      {"--max-degree", "0"},
                      {"--representatives", "out.txt"},
                      {"--proof", "out.proof"},
                      {"--memory", "300M"},
                      {"--noise", ".2"},
                      {"--turns", "2,5"},
                      {"--svg", "out.svg"},
                      {"--wasserstein", "2"},
                      {"--points", "p.csv"},
                      {"--mesh", "out.node"}};

std::string output_of(Command command) {
    switch (command) {
    case Command::mesh:
    case Command::delaunay: return "out.node";
    case Command::vineyard: return "out.vines";
    default: return "out.csv";
    }
}

// Without the object behind `key`, which stands on lines of its own.
std::string without(std::string json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\": {");
    if (at != std::string::npos) json.erase(at, json.find('}', at) - at);
    return json;
}

// Without the lines that begin with `mark`.
std::string without_lines(const std::string& text, const std::string& mark, const std::string& but = "-") {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind(mark, 0) != 0 || line.rfind(but, 0) == 0) kept += line + "\n";
    return kept;
}

struct Seen {
    Result result;
    std::string all;  // that came out, without times and what only repeats the options
};

Seen see(const Folder& folder, const std::string& line) {
    for (const std::string& name : folder.names())
        if (name.rfind("out", 0) == 0) std::filesystem::remove(folder.path() + "/" + name);
    Seen seen{folder.run(line), ""};
    seen.all = without(without(seen.result.out, "seconds"), "options") + without_lines(seen.result.err, "time");
    for (const std::string& name : folder.names())
        if (name.rfind("out", 0) == 0) seen.all += name + "\n" + without_lines(folder.read(name), "#", "# scale");
    return seen;
}

// Whether a refusal names an option of the line: the one added, or one that it contradicts.
bool names_one(const Result& result, const std::string& line) {
    std::istringstream words(line);
    for (std::string word; words >> word;)
        if (word[0] == '-' && word.size() > 1 && result.says(word)) return true;
    return result.says("filter ");
}

void fill(const Folder& folder) {
    REQUIRE(folder.run("sample circle -n 14 --noise .1 -o p.csv").exit == 0);
    folder.write("complex.txt", "0 0\n1 0\n2 0\n0 1 1\n1 2 2\n0 2 3\n0 1 2 3\n");
    folder.write("values.txt", "0 0 0 1 2 3 3\n0 1 0 1 2 3 3\n");
    folder.write("distances.txt", "1\n2 1\n3 2 1\n2 3 2 1\n");
    folder.write("a.pers", "0 0 1\n0 0 2.2\n0 0 inf\n1 1 2\n");
    folder.write("b.pers", "0 0 1.25\n0 0 2.1\n0 0 inf\n1 1 2.5\n");
    for (const char* const line :
         {"mesh p.csv -o mesh.node", "persist p.csv --filter knn --k 2 -o knn.pers",
          "persist p.csv --filter rips -o "
          "rips.pers",
          "vineyard p.csv --k 1..3 -o v.vines", "vineyard complex.txt --values values.txt -o c.vines"})
        REQUIRE(folder.run(line).exit == 0);
}

struct Base {
    Command command;
    std::string line;
    Words own;  // values in place of those above; empty: not for this line
};

std::vector<Base> bases() {
    std::vector<Base> list;
    const std::string function = " --function 'sqrt(x*x + y*y) - 1' --lipschitz 1 --cut 0";
    for (const netmesh_filter_info& filter : filters()) {
        const std::string name = filter.name;
        Words own = {{"--filter", "knn"}};
        // The only bar of this function tells nothing of choices and values.
        if (filter.needs_function != 0)
            own.insert(
                {{"--cut", "-.05"}, {"--least", ""}, {"--min-persistence", ""}, {"--top", ""}, {"--values", ""}});
        // One scale is all that these points have; tests/tools/binary/accuracy.cpp has more.
        if (filter.has_theta != 0) own["--theta"] = "";
        list.push_back(
            {Command::persist, "persist p.csv --filter " + name + (filter.needs_function != 0 ? function : ""), own});
        list.push_back({Command::size, "size --dim 3 --points 1000 --filter " + name, {{"--points", "999"}}});
    }
    list.push_back({Command::persist, "persist p.csv --method svr", {}});
    list.push_back({Command::persist, "persist p.csv --ratio 2.5", {}});
    list.push_back({Command::persist, "persist p.csv --fit --memory 1M", {}});
    list.push_back({Command::persist, "persist p.csv --ratio 2.5 --focus 1.5 --from .3 --to .6", {}});
    list.push_back({Command::persist, "persist distances.txt --distances", {{"--threshold", ".25"}}});
    list.push_back({Command::persist, "persist p.csv --filter rips --threshold .5", {{"--columns", "1"}}});
    for (const char* const method : {"svr", "netmesh", "refine"})
        list.push_back({Command::mesh, std::string("mesh p.csv --method ") + method, {{"--finish", ""}}});
    list.push_back({Command::delaunay, "delaunay p.csv", {}});
    for (const char* const filter : {"knn", "kdistance", "barycentric-cech", "barycentric-rips"})
        list.push_back({Command::vineyard, std::string("vineyard p.csv --k 1..3 --filter ") + filter, {}});
    list.push_back({Command::vineyard, "vineyard complex.txt --values values.txt", {{"--filter", "knn"}}});
    list.push_back({Command::homology, "homology complex.txt", {}});
    list.push_back({Command::distance, "distance a.pers b.pers", {}});
    // A distance may be better than the error allows.
    list.push_back({Command::distance, "distance a.pers b.pers --wasserstein 1", {{"--error", ""}}});
    for (const char* const shape : {"circle", "grid", "ball", "clifford"})
        list.push_back({Command::sample, std::string("sample ") + shape + " -n 10", {{"--seed", "7"}}});
    list.push_back({Command::size, "size --dim 3 --points 1000", {{"--points", "999"}}});
    for (const char* const file : {"mesh.node", "knn.pers --points p.csv", "knn.pers", "rips.pers --points p.csv",
                                   "v.vines --points p.csv", "v.vines",
                                   "c.vines --complex complex.txt --values "
                                   "values.txt"})
        list.push_back({Command::check, std::string("check ") + file, {{"--mesh", "mesh.node"}}});
    return list;
}

}  // namespace

TEST_CASE("an option changes something or is refused by its name") {
    const Folder folder;
    fill(folder);
    std::size_t pairs = 0, refused = 0;
    for (const Base& base : bases()) {
        const std::string json = base.command == Command::sample ? "" : " --json";
        const Seen plain = see(folder, base.line + json);
        CAPTURE(base.line);
        CAPTURE(plain.result.err);
        // A diagram alone is not checked.
        const std::size_t end = base.line.rfind(".pers");
        const bool is_alone = base.command == Command::check && end != std::string::npos && end + 5 == base.line.size();
        REQUIRE(plain.result.exit == (is_alone ? 7 : 0));
        for (const OptionEntry& option : option_entries()) {
            const std::string name = option.name;
            if ((option.commands & bit(base.command)) == 0) continue;
            // The case below has seeds; --quiet asks for less where there is something, and --json is there.
            if ((name == "--seed" && base.own.count(name) == 0) || name == "--quiet" || name == "--json") continue;
            const bool there = (" " + base.line + " ").find(" " + name + " ") != std::string::npos;
            const auto own = base.own.find(name);
            const auto common = values.find(name);
            if (there || (own != base.own.end() && own->second.empty())) continue;
            std::string value = name == "-o" ? output_of(base.command) : common != values.end() ? common->second : "";
            if (own != base.own.end()) value = own->second;
            REQUIRE((option.value == nullptr || !value.empty()));
            const Seen with = see(folder, base.line + " " + name + (value.empty() ? "" : " " + value) + json);
            CAPTURE(name);
            CAPTURE(with.result.err);
            pairs++;
            const bool changed = with.all != plain.all;
            CHECK(changed);
            if (with.result.exit != 2) continue;
            refused++;
            CHECK(names_one(with.result, base.line + " " + name));
        }
    }
    CHECK(pairs > 900);
    CHECK(refused > 300);
}

TEST_CASE("seeds change what is random, and are refused where nothing is") {
    const Folder folder;
    REQUIRE(folder.run("sample ball --dim 2 -n 400 -o p.csv").exit == 0);
    for (const char* const line :
         {"mesh p.csv", "mesh p.csv --method netmesh", "mesh p.csv --method refine", "delaunay p.csv", "persist p.csv",
          "persist p.csv --filter alpha --mesh m.node", "persist p.csv --ratio 2.5", "vineyard p.csv --k 1..2"}) {
        CAPTURE(line);
        const std::string json = std::string(line) + " --json -q";
        CHECK(see(folder, json + " --seed 7").all != see(folder, json).all);
    }
    for (const char* const line : {"persist p.csv --filter rips --seed 7", "persist p.csv --filter cech --seed 7",
                                   "vineyard p.csv --k 1..2 --filter barycentric-cech --seed 7"}) {
        CAPTURE(line);
        const Result result = folder.run(line);
        CHECK(result.exit == 2);
        CHECK(result.says("--seed 7: of triangulations and meshes that are made; leave it out"));
    }
}
