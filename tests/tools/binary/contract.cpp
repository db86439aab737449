// What programs and shells may count on: JSON whatever happens, help, completion, sizes of memory for people.
#include "run.hpp"

#include <doctest/doctest.h>

#include "tools/option_table.hpp"

using namespace netmesh::tool;

namespace {

// The places in JSON text that a reader would stumble over: none in what this tool writes.
bool is_object(const std::string& text) {
    std::string open;
    bool quoted = false;
    std::size_t objects = 0;
    for (std::size_t i = 0; i < text.size(); i++) {
        const char c = text[i];
        if (quoted && c == '\\') {
            i++;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (quoted && static_cast<unsigned char>(c) < 0x20) {
            return false;
        } else if (!quoted && (c == '{' || c == '[')) {
            objects += open.empty() ? 1 : 0;
            open += c;
        } else if (!quoted && (c == '}' || c == ']')) {
            if (open.empty() || open.back() != (c == '}' ? '{' : '[')) return false;
            open.pop_back();
        }
    }
    return open.empty() && !quoted && objects == 1 && text.front() == '{' && text.back() == '\n';
}

bool holds(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

}  // namespace

TEST_CASE("with --json there is an object on stdout however a run ends") {
    const Folder folder;
    REQUIRE(folder.run("sample ball --dim 2 -n 300 -o p.csv").exit == 0);
    REQUIRE(folder.run("mesh p.csv -o m.node").exit == 0);
    folder.write("bad.csv", "1,2\n3,x\n");
    folder.write("latin.csv", "1,2\n3,\xE4\n");
    folder.write("line.csv", "0,0\n1,1\n2,2\n");
    folder.write("empty.csv", "");
    folder.write("distances.txt", "0 1\n1 -1\n");
    folder.write("wrong.pers", "0 0 1\n");
    const struct {
        const char* line;
        int exit;
        const char* place;  // file, line, field
    } runs[] = {{"--json", 2, "null,null,null"},
                {"--json frob", 2, "null,null,null"},
                {"frob --json", 2, "null,null,null"},
                {"persist --json", 2, "null,null,null"},
                {"persist p.csv --json --frob", 2, "null,null,null"},
                {"persist p.csv --frob --json", 2, "null,null,null"},
                {"persist p.csv --tau 1 --json", 2, "null,null,null"},
                {"sample ball -n 3 --json", 2, "null,null,null"},
                {"help frob --json", 2, "null,null,null"},
                {"persist p.csv --filter alpha --tau 3 --json", 2, "null,null,null"},
                {"persist bad.csv --json", 3, "\"bad.csv\",2,2"},
                {"persist latin.csv --json", 3, "\"latin.csv\",2,2"},
                {"persist none.csv --json", 3, "\"none.csv\",null,null"},
                {"persist - --json", 3, "\"<stdin>\",1,null"},
                {"persist empty.csv --json", 3, "\"empty.csv\",1,null"},
                {"persist p.csv -o none/d.pers --json", 3, "\"none/d.pers\",null,null"},
                {"persist distances.txt --distances --json", 3, "\"distances.txt\",2,2"},
                {"homology bad.csv --json", 3, "\"bad.csv\",2,null"},
                {"distance wrong.pers none.pers --json", 3, "\"none.pers\",null,null"},
                {"persist p.csv --memory 20K --json", 4, "null,null,null"},
                {"delaunay line.csv --json", 5, "\"line.csv\",null,null"},
                {"check m.node --points line.csv --json", 7, "null,null,null"},
                {"check wrong.pers --json", 7, "\"wrong.pers\",1,null"}};
    for (const auto& run : runs) {
        CAPTURE(run.line);
        const Result result = folder.run(run.line);
        CAPTURE(result.out);
        CHECK(result.exit == run.exit);
        CHECK(is_object(result.out));
        CHECK(number_in(result.out, "code") == run.exit);
        CHECK(!text_in(result.out, "message").empty());
        std::string place;
        for (const char* const key : {"file", "line", "field"}) {
            const std::size_t at = result.out.find(std::string("\"") + key + "\": ") + std::string(key).size() + 4;
            place += (place.empty() ? "" : ",") + result.out.substr(at, result.out.find_first_of(",\n", at) - at);
        }
        CHECK(place == run.place);
        CHECK(!result.err.empty());
    }
    for (const char* const line : {"--help --json", "help mesh --json", "persist --help --json", "--version --json",
                                   "persist p.csv --json", "size --dim 2 --points 5 --json"}) {
        CAPTURE(line);
        const Result result = folder.run(line);
        CHECK(result.exit == 0);
        CHECK(is_object(result.out));
        CHECK(holds(result.out, "\"error\": null"));
    }
    CHECK(holds(folder.run("persist latin.csv --json").out, "\xEF\xBF\xBD"));
    CHECK(!is_object("{\"a\": 1\n"));
    CHECK(!is_object("{}\n{}\n"));
}

TEST_CASE("of several inputs each has an object, failed ones too") {
    const Folder folder;
    folder.write("a.csv", "0,0\n1,0\n0,1\n");
    folder.write("b.csv", "0,0\n1,x\n");
    const Result result = folder.run("persist a.csv b.csv a.csv --json");
    CHECK(result.exit == 3);
    std::size_t objects = 0;
    for (std::size_t at = result.out.find("\"schema\""); at != std::string::npos;
         at = result.out.find("\"schema\"", at + 1))
        objects++;
    CHECK(objects == 3);
    CHECK(holds(result.out, "\"file\": \"b.csv\""));
}

TEST_CASE("help by its command, in 100 columns, with examples that run") {
    const Folder folder;
    const Result program = folder.run("help");
    CHECK(program.out == folder.run("--help").out);
    CHECK(folder.run("-V").out == folder.run("--version").out);
    CHECK(folder.run("help frob").says("unknown command 'frob'"));
    CHECK(folder.run("help mesh persist").exit == 2);
    folder.write("distances.txt", "1\n2 1\n3 2 1\n");
    folder.write("complex.txt", "0 0\n1 0\n2 0\n0 1 1\n1 2 2\n0 2 3\n");
    folder.write("values.txt", "0 0 0 1 2 3\n0 1 0 1 2 3\n");
    folder.write("a.pers", "0 0 1\n0 0 inf\n");
    folder.write("b.pers", "0 0 2\n0 0 inf\n");
    std::string texts = program.out;
    std::size_t examples = 0;
    for (const CommandEntry& command : command_entries()) {
        const Result result = folder.run(std::string("help ") + command.name);
        CHECK(result.out == folder.run(std::string(command.name) + " -h").out);
        CHECK(holds(result.out, "\nexamples:\n  netmesh "));
        texts += result.out;
    }
    std::istringstream lines(texts);
    bool in_examples = false;
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        CHECK(line.size() <= 100);
        in_examples = line == "examples:" || (in_examples && !line.empty());
        if (!in_examples || line == "examples:") continue;
        examples++;
        CHECK(folder.run(line.substr(std::string("  netmesh ").size())).exit == 0);
    }
    CHECK(examples >= 20);
}

TEST_CASE("what was meant is said") {
    const Folder folder;
    const char* const lines[][2] = {{"perist p.csv", "did you mean persist?"},
                                    {"del p.csv", "did you mean delaunay?"},
                                    {"mesh p.csv --tua 3", "did you mean --tau?"},
                                    {"persist p.csv --max-dgree 1", "did you mean --max-degree?"},
                                    {"persist p.csv --filter alhpa", "did you mean alpha?"},
                                    {"mesh p.csv --method nemesh", "did you mean netmesh?"},
                                    {"persist p.csv --values certifed", "did you mean certified?"},
                                    {"sample sphre -n 5", "did you mean sphere?"}};
    for (const auto& line : lines) {
        CAPTURE(line[0]);
        const Result result = folder.run(line[0]);
        CHECK(result.exit == 2);
        CHECK(result.says(line[1]));
    }
    for (const char* const line : {"frobnicate p.csv", "mesh p.csv --zzzzzz 3", "persist p.csv --filter xyz"})
        CHECK(!folder.run(line).says("did you mean"));
    CHECK(folder.run("distance a b --wasserstein 2.5").says("must be a whole number"));
}

TEST_CASE("messages of memory: KiB to GiB, what to plan for, what would fit") {
    const Folder folder;
    REQUIRE(folder.run("sample ball --dim 2 -n 500 -o p.csv").exit == 0);
    Result result = folder.run("persist p.csv --memory 64K");
    CHECK(result.says("64.0 KiB of memory are too few"));
    CHECK(result.says("--fit finds the best ratio that fits"));
    CHECK(result.says("a --ratio above 2.121 takes less"));
    const std::size_t at = result.err.find("--memory ") + 9;
    const std::string planned = result.err.substr(at, result.err.find_first_of(";\n", at) - at);
    CHECK(folder.run("persist p.csv -q --memory " + planned).exit == 0);
    CHECK(folder.run("persist p.csv -q --memory 150K").exit == 4);
    CHECK(folder.run("persist p.csv -q --memory 150K --fit").exit == 0);
    CHECK(folder.run("persist p.csv --filter tight --memory 300K").says("--filter alpha is exact: plan for "));
    CHECK(folder.run("persist p.csv --filter alpha -q --memory 300K").exit == 0);
    CHECK(folder.run("persist p.csv --filter cech --memory 8M").says("--max-degree 0 fits: plan for "));
    CHECK(folder.run("persist p.csv --filter cech --memory 8M --max-degree 0 -q").exit == 0);
    CHECK(folder.run("persist p.csv --filter alpha --memory 30K").says("--filter complete --fit"));
    CHECK(folder.run("mesh p.csv --memory 100K").says("a --tau above 2.5 takes less"));
    CHECK(folder.run("mesh p.csv --memory 1").says("1 byte of memory"));
    result = folder.run("mesh p.csv -o m.node");
    CHECK(!result.says("reserved"));
    CHECK(result.says("memory   peak "));
    result = folder.run("mesh - -o m.node", "0 0\n");
    CHECK(result.says("input    1 point in R^2"));
}

TEST_CASE("messages have colours on a terminal alone") {
    const Folder folder;
    CHECK(!folder.run("mesh none.csv").says("\x1b"));
    if (std::system("command -v script >/dev/null 2>&1") != 0) {
        MESSAGE("skipped: no program `script`, which makes a terminal");
        return;
    }
    if (std::system("script -qec true /dev/null >/dev/null 2>&1 </dev/null") != 0) {
        MESSAGE("skipped: `script` makes no terminal here, as in a container without devices");
        return;
    }
    const auto terminal = [&](const std::string& before) {
        const std::string command = "cd '" + folder.path() + "' && TERM=xterm " + before + " script -qec \"'" +
                                    NETMESH_BINARY + "' mesh none.csv\" /dev/null >shown 2>&1 </dev/null";
        return std::system(command.c_str()) != -1 ? folder.read("shown") : "";
    };
    CHECK(holds(terminal(""), "\x1b[31mnone.csv: no such file"));
    const std::string plain = terminal("NO_COLOR=1");
    CHECK(holds(plain, "none.csv: no such file"));
    CHECK(!holds(plain, "\x1b["));
}

TEST_CASE("completion knows all commands, options and words") {
    const Folder folder;
    CHECK(folder.run("--completion fish").exit == 2);
    const std::string bash = folder.run("--completion bash").out, zsh = folder.run("--completion zsh").out;
    CHECK(zsh.rfind("#compdef netmesh\n", 0) == 0);
    for (const CommandEntry& command : command_entries()) CHECK(holds(zsh, std::string("\n    ") + command.name + ")"));
    for (const OptionEntry& option : option_entries()) {
        CHECK(holds(bash, option.name));
        CHECK(holds(zsh, std::string("'") + option.name + "["));
    }
    folder.write("netmesh.bash", bash);
    folder.write("netmesh.zsh", zsh);
    folder.write("points.csv", "");
    const auto completed = [&](const std::string& words, int at) {
        const std::string command = "cd '" + folder.path() + "' && bash -c '. ./netmesh.bash; COMP_WORDS=(" + words +
                                    "); COMP_CWORD=" + std::to_string(at) +
                                    "; _netmesh; echo \"${COMPREPLY[@]}\"' >completed 2>&1";
        return std::system(command.c_str()) == 0 ? folder.read("completed") : "bash fails\n";
    };
    if (std::system("command -v bash >/dev/null 2>&1") == 0) {
        CHECK(completed("netmesh per", 1) == "persist\n");
        CHECK(completed("netmesh persist --filter ba", 3) == "basic barycentric-cech barycentric-rips\n");
        CHECK(completed("netmesh mesh --ta", 2) == "--tau\n");
        CHECK(completed("netmesh mesh --wass", 2) == "\n");
        CHECK(completed("netmesh mesh poi", 2) == "points.csv\n");
        CHECK(completed("netmesh help vi", 2) == "vineyard\n");
    } else {
        MESSAGE("skipped: no bash");
    }
    if (std::system("command -v zsh >/dev/null 2>&1") == 0) {
        CHECK(std::system(("zsh -n '" + folder.path() + "/netmesh.zsh'").c_str()) == 0);
    } else {
        MESSAGE("skipped: no zsh");
    }
}
