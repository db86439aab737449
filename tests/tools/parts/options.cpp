#include "tools/options.hpp"

#include <cstdlib>
#include <limits>

#include <doctest/doctest.h>

#include "tools/closest.hpp"
#include "tools/io/numbers.hpp"
#include "tools/option_table.hpp"
#include "tools/requests.hpp"
#include "tools/session.hpp"

using namespace netmesh::tool;

namespace {

Options good(const std::vector<std::string>& arguments) {
    Options options;
    const Outcome outcome = parse_options(arguments, &options);
    CHECK(outcome.message == "");
    return options;
}

std::string fault(const std::vector<std::string>& arguments) {
    Options options;
    const Outcome outcome = parse_options(arguments, &options);
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    CAPTURE(line);
    CHECK(outcome.exit == Exit::usage);
    CHECK(outcome.message.rfind("netmesh: ", 0) == 0);
    return outcome.message;
}

bool names(const std::string& message, const std::string& argument) {
    return message.find(argument) != std::string::npos;
}

}  // namespace

TEST_CASE("options before and behind positionals, with = and without") {
    for (const auto& line : std::vector<std::vector<std::string>>{
             {"persist", "p.txt", "--tau", "3.08", "-o", "p.pers", "--filter=basic", "--json"},
             {"persist", "--tau=3.08", "--json", "-o", "p.pers", "p.txt", "--filter", "basic"},
             {"--json", "--tau=3.08", "persist", "--filter=basic", "-o", "p.pers", "--", "p.txt"}}) {
        const Options options = good(line);
        CHECK(options.command == Command::persist);
        CHECK(options.positionals == std::vector<std::string>{"p.txt"});
        CHECK(options.request.mesh.tau == 3.08);
        CHECK(options.out == "p.pers");
        CHECK(options.request.filter == &netmesh_filter_basic);
        CHECK(options.json);
        CHECK(options.request.seed == 1);
    }
}

TEST_CASE("stdin and names that look like options") {
    CHECK(good({"mesh", "-"}).positionals[0] == "-");
    CHECK(good({"mesh", "--", "-p.txt"}).positionals[0] == "-p.txt");
    CHECK(good({"persist", "p", "-o", "-"}).out == "");
}

TEST_CASE("the same option name may belong to two commands") {
    CHECK(good({"size", "--dim", "3", "--points", "1000"}).point_count == 1000);
    CHECK(good({"check", "m.node", "--points", "1000"}).points_path == "1000");
    CHECK(good({"persist", "p", "--mesh", "m.node"}).mesh_out == "m.node");
    CHECK(good({"check", "d.pers", "--mesh", "m.node"}).mesh_path == "m.node");
}

// A new option of persist is refused beside --pieces and --proof until somebody lists it, here and in options.cpp.
TEST_CASE("beside --pieces and --proof every option is refused that is not known to go with them") {
    const std::string both =
        " -o --columns --delimiter --skip --drop-missing --filter --max-degree --seed --memory --svg "
        "--axis --json --quiet --jobs ";
    const std::string of_pieces = both + "--pieces --scratch --all --least --min-persistence --top ";
    const std::string of_proof = both + "--proof --bounds --check --distances --sparse --threshold --radii --weights "
                                        "--squares --mesh --representatives ";
    const Options pieces = good({"persist", "p", "q", "--pieces", "2"}),
                  proof = good({"persist", "p", "q", "--proof", "f"});
    std::size_t refused = 0;
    for (const OptionEntry& entry : option_entries()) {
        if ((entry.commands & bit(Command::persist)) == 0) continue;
        CAPTURE(entry.name);
        const std::string word = std::string(" ") + entry.name + " ";
        for (const auto& [base, taken] : {std::pair{&pieces, &of_pieces}, std::pair{&proof, &of_proof}}) {
            Options options = *base;
            options.given.emplace_back(entry.name, "");
            const bool is_taken = taken->find(word) != std::string::npos;
            CHECK(check_together(options).good() == is_taken);
            refused += !is_taken;
        }
    }
    CHECK(refused > 40);
}

TEST_CASE("sizes of memory") {
    CHECK(good({"mesh", "p", "--memory", "65536"}).memory_bytes == 65536);
    CHECK(good({"mesh", "p", "--memory", "64K"}).memory_bytes == 65536);
    CHECK(good({"mesh", "p", "--memory", "3m"}).memory_bytes == 3u << 20);
    CHECK(good({"mesh", "p", "--memory=1G"}).memory_bytes == std::size_t{1} << 30);
    for (const char* size : {"0", "0G", "", "K", "1.5M", "-1", "12X", "1KB", "99999999999999999999", "99999999999T"}) {
        CHECK(names(fault({"mesh", "p", "--memory", size}), "--memory"));
    }
}

TEST_CASE("numbers out of range name their argument") {
    for (const char* eps : {"0", "-1", "inf", "nan", "x", ""})
        CHECK(names(fault({"mesh", "p", "--eps", eps}), "--eps"));
    // A size of cells, or what a filter promises: each has its own range.
    const std::string above = "must be above 0", half = "in (0, 1/2]";
    CHECK(names(fault({"mesh", "p", "--eps", "0"}), above));
    CHECK(names(fault({"size", "--dim", "3", "--points", "9", "--eps", "0"}), above));
    CHECK(names(fault({"check", "m.node", "--eps", "0"}), above));
    CHECK(names(fault({"persist", "p", "--filter", "tight", "--eps", "0"}), half));
    CHECK(names(fault({"size", "--dim", "3", "--points", "9", "--filter", "tight", "--eps", "0.7"}), "(0, 1/2]"));
    CHECK(good({"mesh", "p", "--eps", "0.75"}).request.mesh.sizes.eps == 0.75);
    CHECK(good({"size", "--dim", "3", "--points", "9", "--eps", "0.75"}).request.mesh.sizes.eps == 0.75);
    CHECK(good({"size", "--dim", "3", "--points", "9", "--eps", "0.5", "--filter", "tight"}).request.goal.eps == 0.5);
    for (const char* size : {"0", "-1", "inf", "1,-1", "1,", ",1", "1,2,3", "x", ""})
        CHECK(names(fault({"mesh", "p", "--cell-size", size}), "--cell-size"));
    for (const char* factor : {"0.9", "8.1", "nan", "x", ""})
        CHECK(names(fault({"mesh", "p", "--domain", factor}), "--domain"));
    for (const char* tau : {"2", "1.9", "-3", "0", "inf", "nan", "1e400", "x", "", "3x"}) {
        CHECK(names(fault({"mesh", "p", "--tau", tau}), "--tau"));
    }
    for (const char* seed : {"-1", "1.5", "x", "", "18446744073709551616"}) {
        CHECK(names(fault({"mesh", "p", "--seed", seed}), "--seed"));
    }
    CHECK(good({"mesh", "p", "--seed", "18446744073709551615"}).request.seed == UINT64_MAX);
    for (const char* degree : {"-1", "x", "1.0", ""}) {
        CHECK(names(fault({"persist", "p", "--max-degree", degree}), "--max-degree"));
    }
    for (const char* dim : {"1", "7", "x", ""}) {
        CHECK(names(fault({"size", "--dim", dim, "--points", "5"}), "--dim"));
    }
    for (const char* count : {"0", "-5", "x", "4294967296"}) {
        CHECK(names(fault({"size", "--dim", "3", "--points", count}), "--points"));
        CHECK(names(fault({"sample", "ball", "-n", count}), "-n"));
    }
    CHECK(names(fault({"sample", "ball", "-n", "5", "--noise", "-1"}), "--noise"));
    for (const char* turns : {"1", "1,", ",1", "1,x", "1 10"}) {
        CHECK(names(fault({"sample", "clifford", "-n", "5", "--turns", turns}), "--turns"));
    }
}

TEST_CASE("methods, filters and values that this version has not") {
    good({"mesh", "p", "--method", "svr"});
    good({"mesh", "p", "--method", "refine"});
    good({"mesh", "p", "--method", "netmesh", "--finish"});
    CHECK(names(fault({"mesh", "p", "--finish"}), "--finish: this method does not read it"));
    CHECK(names(fault({"persist", "p", "--method", "netmesh"}), "--finish"));
    for (const char* const size : {"--eps", "--cell-size"}) {
        CHECK(names(fault({"mesh", "p", "--method", "netmesh", size, ".4"}),
                    std::string(size) + " .4: a mesh with cages is not over-refined; set finish"));
        good({"mesh", "p", "--method", "netmesh", "--finish", size, ".4"});
    }
    CHECK(good({"mesh", "p", "--method", "netmesh"}).request.mesh.method == &netmesh_method_netmesh);
    CHECK(good({"mesh", "p", "--method", "netmesh", "--cages", "compact"}).request.mesh.method ==
          &netmesh_method_netmesh);
    CHECK(good({"mesh", "p", "--method", "netmesh", "--cages", "thesis", "--tau", "3.4", "--finish"})
              .request.mesh.method == &netmesh_method_thesis);
    good({"size", "--dim", "4", "--points", "5", "--method", "netmesh", "--cages", "thesis"});
    const auto thesis_fault = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"mesh", "p", "--method", "netmesh", "--cages", "thesis"});
        return fault(more);
    };
    CHECK(names(thesis_fault({"--tau", "3.3"}), "--tau 3.3: cages of the thesis need a tau of at least 3.4"));
    for (const char* const located : {"location", "all"})
        CHECK(names(thesis_fault({"--audit", located}),
                    std::string("--audit ") + located + ": an audit of location is for meshes of svr and netmesh"));
    good({"mesh", "p", "--method", "netmesh", "--cages", "thesis", "--audit", "quality"});
    CHECK(names(thesis_fault({"--finish", "--eps", ".4"}), "--eps .4: this method does not read it"));
    CHECK(names(fault({"mesh", "p", "--cages", "thesis"}), "--cages goes with --method netmesh"));
    CHECK(names(fault({"mesh", "p", "--method", "netmesh", "--cages", "large"}), "there are compact and thesis"));
    CHECK(names(fault({"persist", "p", "--method", "netmesh", "--finish", "--cages", "thesis"}), "--cages"));
    CHECK(names(fault({"size", "--dim", "5", "--points", "5", "--method", "netmesh", "--cages", "thesis"}),
                "--cages thesis: there are cages of the thesis up to D = 4"));
    for (const char* spacing : {"0", "0.015", "8.1", "nan", "x", ""})
        CHECK(names(fault({"mesh", "p", "--method", "refine", "--net", spacing}), "--net"));
    for (const char* theta : {"0", "1.1", "-1", "x", ""})
        CHECK(names(fault({"mesh", "p", "--pace", "f", "--theta", theta}), "--theta"));
    CHECK(names(fault({"delaunay", "p", "--theta", ".5"}), "--theta goes with --pace"));
    CHECK(names(fault({"mesh", "p", "--weighted-cells", "f"}), "--weighted-cells goes with --method netmesh"));
    CHECK(names(fault({"mesh", "p", "--method", "netmesh", "--finish", "--weighted-cells", "f"}), "--weighted-cells"));
    CHECK(names(fault({"mesh", "p", "--net", "1"}), "--net 1: this method does not read it"));
    CHECK(
        names(fault({"mesh", "p", "--method", "refine", "--domain", "2"}), "--domain 2: this method does not read it"));
    CHECK(names(fault({"mesh", "p", "--method", "frob"}), "--method frob"));
    for (const char* filter : {"frob", "cechs"}) {
        CHECK(names(fault({"persist", "p", "--filter", filter}), "complete, basic, alpha"));
    }
    CHECK(names(fault({"persist", "p", "--values", "frob"}), "--values frob"));
}

TEST_CASE("filters are those of the library's table") {
    std::size_t offered = 0;
    netmesh::for_each_filter([&](const netmesh_filter_info& info) {
        CAPTURE(info.name);
        offered++;
        std::vector<std::string> line = {"persist", "p", "--filter", info.name};
        if (info.needs_function != 0) line.insert(line.end(), {"--function", "x", "--lipschitz", "1", "--cut", "0"});
        CHECK(good(line).request.filter == info.filter);
        CHECK(std::string(filter_name(info.id)) == info.name);
        CHECK(names(help_text(Command::persist), std::string(info.name)));
    });
    CHECK(offered == 12);
    CHECK(filter_name(NETMESH_FILTER_NONE) == std::string("none"));
    CHECK(names(help_text(Command::vineyard), "knn (default), kdistance, barycentric-cech or barycentric-rips\n"));
    CHECK(choice_text({NETMESH_FILTER_KNN, NETMESH_VALUES_THESIS}) == "filter knn, thesis values");
    CHECK(choice_text({NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED}) == "filter alpha");
}

TEST_CASE("the options of a function") {
    const Options options = good({"persist", "p", "--filter", "function", "--function", "x*y - 1", "--lipschitz", "2",
                                  "--cut", "-.5", "--error", ".25"});
    CHECK(options.function->text() == "x*y - 1");
    CHECK(options.lipschitz == 2);
    CHECK(options.cut == -0.5);
    CHECK(options.request.goal.error == 0.25);
    CHECK(settled(options, 2).request.values == NETMESH_VALUES_THESIS);
    CHECK(names(fault({"persist", "p", "--function", "x +"}), "--function x +: column 4: "));
    for (const char* text : {"-1", "inf", "nan", "x", ""})
        CHECK(names(fault({"persist", "p", "--lipschitz", text}), "--lipschitz"));
    for (const char* text : {"inf", "nan", "x", ""}) CHECK(names(fault({"persist", "p", "--cut", text}), "--cut"));
    for (const char* text : {"0", "-1", "inf", "x", ""})
        CHECK(names(fault({"persist", "p", "--error", text}), "--error"));
}

TEST_CASE("the function that a certified ratio is about") {
    netmesh_report report = netmesh::sized<netmesh_report>();
    CHECK(reference_name(report) == "filtered complex");
    report.input.dim = 3;
    report.diagram.k = 5;
    report.diagram.filter = NETMESH_FILTER_ALPHA;
    CHECK(reference_name(report) == "closed offsets of the points in R^3");
    report.diagram.filter = NETMESH_FILTER_KNN;
    CHECK(reference_name(report) == "sublevel sets of d_5 in R^3");
    report.diagram.filter = NETMESH_FILTER_KDISTANCE;
    CHECK(reference_name(report) == "sublevel sets of the k-distance, k = 5, in R^3");
}

TEST_CASE("the option that a field of a request comes from, as it was written") {
    const Options options = good({"persist", "p", "--k=3", "--filter", "knn", "--k", "15"});
    CHECK(option_of(options, NETMESH_FIELD_K) == "--k 15");
    CHECK(option_of(options, NETMESH_FIELD_FILTER) == "--filter knn");
    CHECK(option_of(options, NETMESH_FIELD_TAU) == "--tau");
    CHECK(option_of(options, NETMESH_FIELD_POINTS) == "");
    CHECK(option_of(good({"vineyard", "p", "--k", "2..9"}), NETMESH_FIELD_K_LAST) == "--k 2..9");
}

TEST_CASE("commands, options and arguments that are not") {
    CHECK(names(fault({}), "no command"));
    CHECK(names(fault({"frob"}), "'frob'"));
    CHECK(names(fault({"frob", "mesh"}), "'frob'"));
    CHECK(names(fault({"--frob"}), "--frob"));
    CHECK(names(fault({"mesh"}), "POINTS"));
    CHECK(names(fault({"mesh", ""}), "POINTS"));
    CHECK(names(fault({"homology", "p", "q"}), "q"));
    CHECK(names(fault({"vineyard", "p", "q", "--k", "1..2"}), "q"));
    CHECK(names(fault({"mesh", "p", ""}), "empty name"));
    CHECK(good({"mesh", "p", "q"}).positionals.size() == 2);
    CHECK(names(fault({"mesh", "p", "--frob"}), "--frob"));
    CHECK(names(fault({"mesh", "p", "-x"}), "-x"));
    CHECK(names(fault({"mesh", "p", "--tau"}), "--tau needs a value"));
    CHECK(names(fault({"mesh", "p", "--json=1"}), "--json takes no value"));
    CHECK(names(fault({"mesh", "p", "--filter", "alpha"}), "--filter does not apply to mesh"));
    CHECK(names(fault({"mesh", "p", "-o", ""}), "-o"));
    CHECK(names(fault({"size", "3"}), "3"));
}

TEST_CASE("help and version") {
    CHECK(good({"--version"}).version);
    CHECK(good({"--help"}).help);
    CHECK(good({"mesh", "--help"}).command == Command::mesh);
    CHECK(good({"mesh", "p", "-h"}).help);
    CHECK(names(fault({"frob", "--help"}), "'frob'"));
    for (const Command command : {Command::none, Command::mesh, Command::delaunay, Command::persist, Command::size,
                                  Command::check, Command::sample}) {
        CHECK(help_text(command).find("netmesh") != std::string::npos);
    }
    CHECK(good({"-V"}).version);
    CHECK(good({"help", "mesh"}).command == Command::mesh);
    CHECK(good({"help"}).help);
    CHECK(good({"mesh", "p", "-q"}).quiet);
    CHECK(good({"--completion", "zsh"}).completion == "zsh");
    CHECK(good({"--manual"}).manual);
    CHECK(good({"--manual", "mesh"}).command == Command::mesh);
    CHECK(names(fault({"--manual", "mash"}), "did you mean mesh?"));
    CHECK(names(fault({"help", "mash"}), "did you mean mesh?"));
    CHECK(help_text(Command::persist).find("--filter F") != std::string::npos);
    CHECK(help_text(Command::mesh).find("--filter") == std::string::npos);
    CHECK(help_text(Command::sample).find("clifford") != std::string::npos);
    CHECK(version_text() == std::string("netmesh ") + netmesh_version_text() + "\n");
}

TEST_CASE("edits between words, and which word is meant") {
    CHECK(edits_between("", "") == 0);
    CHECK(edits_between("abc", "abc") == 0);
    CHECK(edits_between("abc", "") == 3);
    CHECK(edits_between("alhpa", "alpha") == 1);
    CHECK(edits_between("kitten", "sitting") == 3);
    const std::vector<std::string> names = {"mesh", "persist", "size", "sample"};
    CHECK(did_you_mean("mehs", names) == "; did you mean mesh?");
    CHECK(did_you_mean("pers", names) == "; did you mean persist?");
    CHECK(did_you_mean("s", names) == "");
    CHECK(did_you_mean("quux", names) == "");
    CHECK(did_you_mean("", names) == "");
}

TEST_CASE("--json counts also where the rest cannot be parsed") {
    CHECK(asks_for_json({"mesh", "--frob", "--json"}));
    CHECK(!asks_for_json({"mesh", "--", "--json"}));
    CHECK(!asks_for_json({"mesh", "p"}));
}

TEST_CASE("sizes of memory as people and --memory have them") {
    CHECK(bound_text(2.0000168450663947, 5) == "2.0001");
    CHECK(bound_text(1.3779428362644583, 6) == "1.37795");
    CHECK(bound_text(0.49999952, 5) == "0.5");
    CHECK(bound_text(9.99999999, 5) == "10");
    CHECK(bound_text(1.8, 5) == "1.8");
    CHECK(bound_text(0, 5) == "0");
    CHECK(bound_text(std::numeric_limits<double>::infinity(), 5) == "inf");
    for (double x = 1e-310, most = 1e308; x < most; x *= 1.37)
        for (int digits = 1; digits <= 17; ++digits) {
            CHECK(std::strtod(bound_text(x, digits).c_str(), nullptr) >= x);
            CHECK(bound_text(-x, digits).size() > 0);
        }
    CHECK(bytes_text_up(1) == "1 byte");
    CHECK(bytes_text_up(1023) == "1023 bytes");
    CHECK(bytes_text_up(1025) == "1.1 KiB");
    CHECK(bytes_text(1025) == "1.0 KiB");
    CHECK(memory_option_text(8191) == "8191");
    CHECK(memory_option_text(8193) == "9K");
    CHECK(memory_option_text(std::uint64_t{9} << 20) == "9M");
    for (std::uint64_t bytes = 1; bytes < (std::uint64_t{1} << 44); bytes = bytes * 5 / 2 + 1)
        CHECK(good({"mesh", "p", "--memory", memory_option_text(bytes)}).memory_bytes >= bytes);
    CHECK(counted(1, "point", "points") == "1 point");
    CHECK(counted(1200, "point", "points") == "1,200 points");
}

TEST_CASE("memory to reserve when none is named") {
    constexpr std::size_t gib = std::size_t{1} << 30;
    CHECK(lazy_bytes(1000, 8 * gib) == gib);
    CHECK(lazy_bytes(gib / 32, 8 * gib) == 2 * gib);
    CHECK(lazy_bytes(gib, 8 * gib) == 8 * gib);
    CHECK(lazy_bytes(SIZE_MAX, 8 * gib) == 8 * gib);
}
