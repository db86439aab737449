#include "platform/workers.hpp"

#include <sys/types.h>
#include <unistd.h>
#ifndef __EMSCRIPTEN__
#include <sys/wait.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <vector>

#include "platform/folders.hpp"
#include "platform/interrupt.hpp"

namespace netmesh::platform {

unsigned processors() {
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 0 ? static_cast<unsigned>(count) : 1;
}

#if defined(__EMSCRIPTEN__) || defined(__wasi__)

bool has_processes() { return false; }
Workers::~Workers() = default;
bool Workers::start(std::size_t task, const std::function<int()>& work) {
    done_[task] = work();
    return true;
}
bool Workers::wait(std::size_t* task, int* code) {
    *task = done_.begin()->first;
    *code = done_.begin()->second;
    done_.erase(done_.begin());
    return true;
}

#else

bool has_processes() { return true; }

Workers::~Workers() {
    for (const auto& [process, task] : tasks_) kill(process, SIGTERM);
    for (const auto& [process, task] : tasks_)
        while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) kill(process, SIGKILL);
}

bool Workers::start(std::size_t task, const std::function<int()>& work) {
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process < 0) return false;
    if (process == 0) {
        int code = 1;
        try {
            code = work();
        } catch (...) {
        }
        std::fflush(nullptr);
        _exit(code);
    }
    tasks_[process] = task;
    return true;
}

bool Workers::wait(std::size_t* task, int* code) {
    for (;;) {
        int status = 0;
        const pid_t process = waitpid(-1, &status, 0);
        if (process < 0) {
            if (errno == EINTR && !interrupted()) continue;
            return false;
        }
        const auto found = tasks_.find(process);
        if (found == tasks_.end()) continue;
        *task = found->second;
        *code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        tasks_.erase(found);
        return true;
    }
}

#endif

SaidLater::~SaidLater() {
    for (const int file : files_)
        if (file >= 0) close(file);
}

bool SaidLater::open(std::string* why) {
    for (int& file : files_) {
        file = open_unnamed(system_folder(), why);
        if (file < 0) return false;
    }
    return true;
}

void SaidLater::take_over() const {
    for (int i = 0; i < 2; i++) dup2(files_[i], 1 + i);
}

namespace {

// False with a phrase in *why, where `to` does not take all of the file.
bool copy_all(int file, int to, std::string* why) {
    std::vector<char> some(std::size_t{1} << 16);
    lseek(file, 0, SEEK_SET);
    for (;;) {
        const ssize_t got = read(file, some.data(), some.size());
        if (got == 0) return true;
        for (ssize_t done = 0; done < got;) {
            const ssize_t put = write(to, some.data() + done, static_cast<std::size_t>(got - done));
            if (put < 0 && errno != EINTR) {
                *why = std::strerror(errno);
                return false;
            }
            done += put > 0 ? put : 0;
        }
        if (got < 0 && errno != EINTR) {
            *why = std::strerror(errno);
            return false;
        }
    }
}

}  // namespace

bool SaidLater::say(std::string* why) const {
    std::fflush(nullptr);
    std::string ignored;  // nobody misses what stderr does not take
    copy_all(files_[1], 2, &ignored);
    return copy_all(files_[0], 1, why);
}

}  // namespace netmesh::platform
