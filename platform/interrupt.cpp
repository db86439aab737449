#include "platform/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstring>
#include <initializer_list>

namespace netmesh::platform {

namespace {

constexpr int slots = 8;
constexpr std::size_t path_bytes = 4096;
// A slot is armed only while its name is complete, so the handler never sees half a name.
char names[slots][path_bytes];
volatile sig_atomic_t armed[slots];
volatile sig_atomic_t signals_seen = 0;

// Only calls that are safe inside a handler.
void on_signal(int number) {
    if (signals_seen == 0) {
        signals_seen = 1;
        return;
    }
    for (int i = 0; i < slots; i++) {
        if (armed[i]) unlink(names[i]);
    }
    signal(number, SIG_DFL);
    raise(number);
}

}  // namespace

void catch_interrupts() {
    struct sigaction action = {};
    action.sa_handler = on_signal;  // no SA_RESTART: a read that waits for a person must return
    sigemptyset(&action.sa_mask);
    for (int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before = {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // nohup stays nohup
    }
    signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is then an error of write()
}

bool interrupted() { return signals_seen != 0; }

void take_interrupt() { signals_seen = 0; }

int remove_when_killed(const char* path) {
    const std::size_t bytes = std::strlen(path) + 1;
    if (bytes > path_bytes) return -1;
    for (int i = 0; i < slots; i++) {
        if (armed[i]) continue;
        std::memcpy(names[i], path, bytes);
        armed[i] = 1;
        return i;
    }
    return -1;
}

void forget(int handle) {
    if (handle >= 0 && handle < slots) armed[handle] = 0;
}

}  // namespace netmesh::platform
