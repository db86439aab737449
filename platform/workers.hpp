// Work in processes of its own: copies of this one, which share what it has read.
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <string>

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
