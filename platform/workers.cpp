#include "platform/workers.hpp"

#include <sys/types.h>
#include <unistd.h>
#ifndef __EMSCRIPTEN__
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#endif

#include <algorithm>
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

Crew::~Crew() = default;
bool Crew::start(std::size_t task) {
    done_[task] = work_(task);
    return true;
}
std::size_t Crew::running() const { return done_.size(); }
bool Crew::wait(std::size_t* task, int* code) {
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

namespace {

#ifdef MSG_NOSIGNAL
constexpr int no_signal = MSG_NOSIGNAL;
#else
constexpr int no_signal = 0;
#endif

// A line to a process that has ended is an error of send(), not the end of this one.
bool make_line(int* ends) {
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return false;
#ifdef SO_NOSIGPIPE
    const int on = 1;
    for (int i = 0; i < 2; i++) setsockopt(ends[i], SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
#endif
    return true;
}

template <class T> bool send_whole(int line, const T& item) {
    const char* at = reinterpret_cast<const char*>(&item);
    for (std::size_t left = sizeof item; left > 0;) {
        const ssize_t sent = send(line, at, left, no_signal);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += sent;
        left -= static_cast<std::size_t>(sent);
    }
    return true;
}

// Interrupts are looked at by who is at work; the other end closes the line of who waits.
template <class T> bool receive_whole(int line, T* item) {
    char* at = reinterpret_cast<char*>(item);
    for (std::size_t left = sizeof *item; left > 0;) {
        const ssize_t got = recv(line, at, left, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        left -= static_cast<std::size_t>(got);
    }
    return true;
}

}  // namespace

Crew::~Crew() {
    for (const Member& member : members_)
        if (member.busy) kill(member.process, SIGTERM);
    while (!members_.empty()) dismiss(members_.size() - 1);
}

std::size_t Crew::running() const {
    return static_cast<std::size_t>(
        std::count_if(members_.begin(), members_.end(), [](const Member& member) { return member.busy; }));
}

void Crew::dismiss(std::size_t at) {
    const Member member = members_[at];
    members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(at));
    close(member.line);
    while (waitpid(member.process, nullptr, 0) < 0 && errno == EINTR) kill(member.process, SIGKILL);
}

void Crew::serve(int line) const {
    // Or who waits would not see that this process is gone.
    for (const Member& member : members_) close(member.line);
    int code = 0;
    for (std::size_t task; !interrupted() && receive_whole(line, &task);) {
        code = 1;
        try {
            code = work_(task);
        } catch (...) {
        }
        std::fflush(nullptr);
        if (!send_whole(line, code)) break;
    }
    _exit(code);
}

bool Crew::add_member() {
    int ends[2];
    if (!make_line(ends)) return false;
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process == 0) {
        close(ends[0]);
        serve(ends[1]);
    }
    close(ends[1]);
    if (process < 0) {
        close(ends[0]);
        return false;
    }
    members_.push_back({process, ends[0], false, 0});
    return true;
}

bool Crew::start(std::size_t task) {
    for (;;) {
        auto idle = std::find_if(members_.begin(), members_.end(), [](const Member& member) { return !member.busy; });
        if (idle == members_.end()) {
            if (!add_member()) return false;
            idle = members_.end() - 1;
        }
        idle->task = task;
        idle->busy = send_whole(idle->line, task);
        if (idle->busy) return true;
        dismiss(static_cast<std::size_t>(idle - members_.begin()));  // it was ended while it had no task
    }
}

bool Crew::wait(std::size_t* task, int* code) {
    for (;;) {
        std::vector<pollfd> lines;
        for (const Member& member : members_)
            lines.push_back({member.line, static_cast<short>(member.busy ? POLLIN : 0), 0});
        if (poll(lines.data(), static_cast<nfds_t>(lines.size()), -1) < 0 && (errno != EINTR || interrupted()))
            return false;
        for (std::size_t i = 0; i < lines.size(); i++) {
            if (!members_[i].busy || lines[i].revents == 0) continue;
            *task = members_[i].task;
            members_[i].busy = false;
            if (!receive_whole(members_[i].line, code)) {  // it ended without a word, so its task is not done
                dismiss(i);
                *code = -1;
            }
            return true;
        }
        // Those that have ended while they had no task would be seen again and again.
        for (std::size_t i = lines.size(); i-- > 0;)
            if (lines[i].revents != 0) dismiss(i);
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
