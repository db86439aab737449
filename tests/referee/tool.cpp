#include "tool.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace referee {

Tool::Tool(const std::string& binary) : binary_(binary) {
    char name[] = "/tmp/netmesh-referee-XXXXXX";
    if (mkdtemp(name) == nullptr) {
        std::perror("mkdtemp");
        std::exit(2);
    }
    folder_ = name;
}

Tool::~Tool() { std::filesystem::remove_all(folder_); }

Outcome Tool::run(const std::vector<std::string>& arguments, unsigned seconds) const {
    std::vector<char*> words = {const_cast<char*>(binary_.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const std::string said = path("said");
    const pid_t child = fork();
    if (child == 0) {
        const int out = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(out, 1);
        dup2(out, 2);
        alarm(seconds);  // outlives exec
        execv(words[0], words.data());
        _exit(127);
    }
    int status = 0;
    Outcome outcome;
    if (child < 0 || waitpid(child, &status, 0) != child) return outcome;
    std::ifstream file(said);
    std::ostringstream text;
    text << file.rdbuf();
    outcome.message = text.str();
    while (!outcome.message.empty() && outcome.message.back() == '\n') outcome.message.pop_back();
    outcome.exit = WIFEXITED(status)             ? WEXITSTATUS(status)
                   : WTERMSIG(status) == SIGALRM ? static_cast<int>(out_of_time)
                                                 : 128 + WTERMSIG(status);
    return outcome;
}

Outcome Tool::check(const Mesh& mesh, const std::vector<Point>* points) const {
    write_mesh(path("planted"), mesh);
    std::vector<std::string> arguments = {"check", path("planted.node"), "--quiet"};
    if (points != nullptr) {
        write_points(path("planted.txt"), *points, mesh.dim);
        arguments.insert(arguments.end(), {"--points", path("planted.txt")});
    }
    return run(arguments, 120);
}

bool Tool::triangulate(Mesh* mesh) const {
    write_points(path("vertices.txt"), mesh->vertices, mesh->dim);
    if (run({"delaunay", path("vertices.txt"), "-o", path("cells.node"), "--quiet"}, 60).exit != done) return false;
    Mesh made;
    if (!read_mesh(path("cells"), &made).empty() || made.count() != mesh->count()) return false;
    mesh->cells = made.cells;
    mesh->neighbours = made.neighbours;
    return true;
}

}  // namespace referee
