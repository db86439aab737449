// Too little memory, files that cannot be written, signals: the right exit code, and never a partial file.
#include "run.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>

using Names = std::vector<std::string>;

// The address sanitizer reserves terabytes of its own and cannot live with a limit.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

TEST_CASE("memory too small: exit 4, saying how much it takes, no file") {
    const Folder folder;
    CHECK(folder.run("sample ball -n 500 --dim 2 -o p.txt").exit == 0);
    for (const char* memory : {"1", "1000", "4K", "16K", "32K", "64K", "100000"}) {
        const Result result = folder.run(std::string("persist p.txt -o d.pers --svg d.svg --json --memory ") + memory);
        CAPTURE(memory);
        CHECK(result.exit == 4);
        CHECK((result.says("iB of memory are too few") || result.says(" byte")));
        CHECK(result.says("plan for "));
        CHECK(number_in(result.out, "code") == 4);
    }
    CHECK(folder.names() == Names{"p.txt"});
}

TEST_CASE("without --memory a limit on address space only makes the reservation smaller" * doctest::skip(sanitized)) {
    const Folder folder;
    CHECK(folder.run("sample ball -n 500 --dim 2 -o p.txt").exit == 0);
    CHECK(folder.run("persist p.txt -o d.pers", "", "ulimit -v 300000 &&").exit == 0);
}

TEST_CASE("files that cannot be written: exit 3, and what was there stays") {
    const Folder folder;
    CHECK(folder.run("sample ball -n 2000 -o p.txt").exit == 0);
    Result result = folder.run("mesh p.txt -o nowhere/m.node");
    CHECK(result.exit == 3);
    CHECK(result.says("nowhere/m.node: cannot write: no such file or folder"));
    std::filesystem::create_directory(folder.path() + "/dir.pers");
    CHECK(folder.run("persist p.txt -o dir.pers").exit == 3);
    // A limit on file sizes stands for a full disk: some files of the three could be written, none appears.
    folder.write("m.node", "old");
    result = folder.run("delaunay p.txt -o m.node", "", "ulimit -f 200 &&");
    CHECK(result.exit == 3);
    CHECK(result.says("cannot write"));
    CHECK(folder.read("m.node") == "old");
    CHECK(folder.names() == Names{"dir.pers", "m.node", "p.txt"});
    CHECK(folder.run("sample ball -n 100000", "", "", ">/dev/full").exit == 3);
}

TEST_CASE("a file is replaced as a whole, through symbolic links, with its permissions") {
    const Folder folder;
    folder.write("old.txt", "old");
    chmod((folder.path() + "/old.txt").c_str(), 0640);
    std::filesystem::create_symlink("old.txt", folder.path() + "/link.txt");
    CHECK(folder.run("sample grid --dim 2 -n 4 -o link.txt").exit == 0);
    CHECK(folder.read("old.txt") == "0 0\n0 1\n1 0\n1 1\n");
    CHECK(std::filesystem::is_symlink(folder.path() + "/link.txt"));
    struct stat about = {};
    REQUIRE(stat((folder.path() + "/old.txt").c_str(), &about) == 0);
    CHECK((about.st_mode & 0777) == 0640);
    CHECK(folder.names() == Names{"link.txt", "old.txt"});
}

TEST_CASE("devices are written, not replaced") {
    const Folder folder;
    REQUIRE(mkfifo((folder.path() + "/pipe.off").c_str(), 0600) == 0);
    const std::string copy = "& cat '" + folder.path() + "/pipe.off' >'" + folder.path() + "/copy.off'; wait $!";
    const Result result = folder.run("delaunay - -o pipe.off --quiet", "0 0\n1 0\n0 1\n", "", copy);
    CHECK(result.exit == 0);
    CHECK(folder.read("copy.off").rfind("nOFF\n", 0) == 0);
    CHECK(std::filesystem::is_fifo(folder.path() + "/pipe.off"));
}

namespace {

// The binary with a pipe as its stdin, so that signals can be sent while it reads.
struct Process {
    pid_t id;
    int input;
};

// out: where stdout goes, if not to the test's own.
Process start(const Folder& folder, const std::vector<std::string>& arguments, const char* out = nullptr) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t id = fork();
    if (id == 0) {
        dup2(ends[0], 0);
        close(ends[0]);
        close(ends[1]);
        if (chdir(folder.path().c_str()) != 0) _exit(99);
        const int err = open("err", O_WRONLY | O_CREAT, 0600);
        dup2(err, 2);
        if (out != nullptr) dup2(open(out, O_WRONLY | O_CREAT, 0600), 1);
        signal(SIGINT, SIG_DFL);
        std::vector<char*> pointers = {const_cast<char*>(NETMESH_BINARY)};
        for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
        pointers.push_back(nullptr);
        execv(NETMESH_BINARY, pointers.data());
        _exit(99);
    }
    close(ends[0]);
    return {id, ends[1]};
}

int exit_of(const Process& process) {
    int status = 0;
    waitpid(process.id, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// More than a pipe holds, so that the other side has begun to read when this returns.
void feed(const Process& process) {
    std::string text;
    for (int i = 0; i < 40000; i++) text += std::to_string(i % 200) + " " + std::to_string(i / 200) + "\n";
    std::size_t at = 0;
    while (at < text.size()) {
        const ssize_t put = write(process.input, text.data() + at, text.size() - at);
        if (put <= 0) break;
        at += static_cast<std::size_t>(put);
    }
}

}  // namespace

TEST_CASE("Ctrl-C, wherever it comes: exit 6, no file") {
    for (const int number : {SIGINT, SIGTERM}) {
        const Folder folder;
        const Process process = start(folder, {"mesh", "-", "-o", "m.node", "--svg", "m.svg"});
        feed(process);
        kill(process.id, number);
        close(process.input);
        CHECK(exit_of(process) == 6);
        CHECK(folder.read("err").find("cancelled") != std::string::npos);
        CHECK(folder.names() == Names{"err"});
    }
}

TEST_CASE("Ctrl-C with --json: an object on stdout") {
    const Folder folder;
    const Process process = start(folder, {"mesh", "-", "-o", "m.node", "--json"}, "out");
    feed(process);
    kill(process.id, SIGINT);
    close(process.input);
    CHECK(exit_of(process) == 6);
    CHECK(folder.read("out").find("\"code\": 6") != std::string::npos);
}

TEST_CASE("no output is written over an input or another output") {
    const Folder folder;
    folder.write("p.csv", "0,0\n1,0\n0,1\n2,2\n1,3\n");
    folder.write("cx.txt", "0 0\n0 1\n1 0 1\n");
    folder.write("d.txt", "1,\n2,1,\n3,4,5,\n");
    const std::string points = folder.read("p.csv");
    for (const char* const command :
         {"persist p.csv -o p.csv", "persist p.csv -o ./p.csv", "persist p.csv p.csv -o {}.csv",
          "persist p.csv -o {}.csv", "mesh p.csv -o m.node --pace m.ele",
          "persist p.csv --filter complete --mesh q.obj --representatives q.obj -o q.pers",
          "persist d.txt --distances -o d.txt", "homology cx.txt -o cx.txt"}) {
        CAPTURE(command);
        const Result refused = folder.run(command);
        CHECK(refused.exit == 2);
        CHECK((refused.says("would be written over the input") || refused.says("would be written to")));
    }
    CHECK(folder.read("p.csv") == points);
    CHECK(folder.names() == Names{"cx.txt", "d.txt", "p.csv"});
    CHECK(folder.run("persist p.csv -q --svg - -o o.pers").exit == 0);
    CHECK(folder.run("persist d.txt --distances -q -o d.pers").exit == 0);  // rows end in commas, as ripser's own do
}
