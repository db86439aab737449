#include "platform/program.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/auxv.h>
#endif
#if !defined(__EMSCRIPTEN__) && !defined(__wasi__)
#include <spawn.h>
#include <sys/wait.h>
#endif

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "platform/folders.hpp"
#include "platform/interrupt.hpp"

namespace netmesh::platform {

#if defined(__EMSCRIPTEN__) || defined(__wasi__)

std::string find_program(const std::string&) { return {}; }
bool run_program(const std::vector<std::string>&, ProgramEnd*, std::string* why) {
    *why = "the system has no processes";
    return false;
}

#else

namespace {

bool is_program(const std::string& path) {
    struct stat about = {};
    return stat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode) && access(path.c_str(), X_OK) == 0;
}

// With a slash at its end; empty where the system does not say. A container may have no /proc.
std::string own_folder() {
    char path[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    std::string name(path, length > 0 ? static_cast<std::size_t>(length) : 0);
#ifdef __linux__
    const auto* const started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    if (name.empty() && started != nullptr && realpath(started, path) != nullptr) name = path;
#endif
    return name.substr(0, name.rfind('/') + 1);
}

// What was written to a file without a name.
std::string content_of(int file) {
    std::string text;
    char some[4096];
    lseek(file, 0, SEEK_SET);
    for (ssize_t got = 1; got != 0;) {
        got = read(file, some, sizeof some);
        if (got < 0 && errno != EINTR) break;
        if (got > 0) text.append(some, static_cast<std::size_t>(got));
    }
    return text;
}

struct Streams {
    int out = -1, err = -1;
    ~Streams() {
        if (out >= 0) close(out);
        if (err >= 0) close(err);
    }
};

}  // namespace

std::string find_program(const std::string& name) {
    const std::string own = own_folder();
    if (!own.empty() && is_program(own + name)) return own + name;
    const char* const named = std::getenv("PATH");
    const std::string path = named != nullptr ? named : "";
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        const std::string found = path.substr(begin, end - begin) + "/" + name;
        if (end > begin && is_program(found)) return found;
        begin = end + 1;
    }
    return {};
}

bool run_program(const std::vector<std::string>& words, ProgramEnd* end, std::string* why) {
    Streams streams;
    streams.out = open_unnamed(system_folder(), why);
    if (streams.out < 0) return false;
    streams.err = open_unnamed(system_folder(), why);
    if (streams.err < 0) return false;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // left as they are
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, streams.out, 1);
    posix_spawn_file_actions_adddup2(&actions, streams.err, 2);
    pid_t process = 0;
    const int failed = posix_spawn(&process, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) {
        *why = std::strerror(failed);
        return false;
    }
    int status = 0;
    bool ended_by_us = false;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
        if (interrupted() && !ended_by_us) ended_by_us = kill(process, SIGTERM) == 0;
    }
    if (ended_by_us) {
        *why = "interrupted";
        return false;
    }
    end->code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    end->out = content_of(streams.out);
    end->err = content_of(streams.err);
    return true;
}

#endif

}  // namespace netmesh::platform
