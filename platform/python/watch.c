#define _POSIX_C_SOURCE 199309L
#include "watch.h"

#include <time.h>

static int64_t now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}

int netmesh_python_poll(void* user, const netmesh_progress* progress) {
    netmesh_python_watch* const watch = user;
    const int64_t time = now();
    const int shows = watch->call != NULL && time >= watch->progress_next;
    int stop = watch->stop;
    if (stop != 0) return 1;
    if (!shows && time < watch->signals_next) return 0;
    {
        const int state = watch->ensure();
        watch->signals_next = time + watch->signals_every;
        if (watch->check_signals() != 0) {
            watch->fetch(&watch->error_type, &watch->error_value, &watch->error_traceback);
            stop = 1;
        } else if (shows) {
            watch->progress_next = time + watch->progress_every;
            watch->answer = 0;
            watch->call(progress);
            stop = watch->answer != 1; /* 0: an exception has left the function */
        }
        watch->release(state);
    }
    return stop;
}
