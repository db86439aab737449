// Work in processes of its own: copies of this one, which share what it has read.
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace netmesh::platform {

// How many processors this process may use.
unsigned processors();

class Workers {
public:
    // Without processes, where the system has none, work is done at once by start().
    Workers() = default;
    // Ends those that still run.
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    // Begins `work`, whose result becomes the exit code of its process. False: the system has no room for a process.
    bool start(std::size_t task, const std::function<int()>& work);
    std::size_t running() const { return tasks_.size() + done_.size(); }
    // Waits for one to end, or for an interrupt (false). *code: its result, -1 where a signal ended it.
    bool wait(std::size_t* task, int* code);

private:
    std::map<int, std::size_t> tasks_;  // by process
    std::map<std::size_t, int> done_;   // what was done at once
};

// Processes that stay: each does one task after the other, and what one has at hand serves its next task.
class Crew {
public:
    // `work` of a task, in a process of the crew, becomes its code. Without processes it is done at once by start().
    explicit Crew(std::function<int(std::size_t)> work) : work_(std::move(work)) {}
    // Ends those that are at work.
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    // Gives a task to a process that has none, or to a new one. False: the system has no room for a process.
    bool start(std::size_t task);
    std::size_t running() const;  // tasks
    // As Workers::wait; -1 too where a process ended without a word.
    bool wait(std::size_t* task, int* code);

private:
    struct Member {
        int process, line;  // line: a socket, by which tasks come and codes go
        bool busy;
        std::size_t task;
    };
    bool add_member();
    [[noreturn]] void serve(int line) const;
    void dismiss(std::size_t at);  // ends it, unless it has ended

    std::function<int(std::size_t)> work_;
    std::vector<Member> members_;
    std::map<std::size_t, int> done_;  // what was done at once
};

// What a process says on stdout and stderr, kept in files without a name until it is its turn.
class SaidLater {
public:
    SaidLater() = default;
    ~SaidLater();
    SaidLater(const SaidLater&) = delete;
    SaidLater& operator=(const SaidLater&) = delete;

    // Before the process begins. False with a phrase in *why.
    bool open(std::string* why);
    // In the process: from here on it writes there.
    void take_over() const;
    // Says it. False with a phrase in *why, where stdout does not take it.
    bool say(std::string* why) const;

private:
    int files_[2] = {-1, -1};
};

// Whether start() begins processes.
bool has_processes();

}  // namespace netmesh::platform
