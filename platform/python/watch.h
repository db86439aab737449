/* What jobs that Python starts call back: in C where Python would be too slow.
 * A job runs without the interpreter's lock. Now and then its poll asks for the lock, lets Python handle its signals,
 * and calls Python's own function for progress. */
#ifndef NETMESH_PYTHON_WATCH_H
#define NETMESH_PYTHON_WATCH_H

#include "netmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The functions are those of Python's stable interface, whose header is not needed for them. */
typedef struct netmesh_python_watch {
    int (*ensure)(void);                                     /* PyGILState_Ensure */
    void (*release)(int state);                              /* PyGILState_Release */
    int (*check_signals)(void);                              /* PyErr_CheckSignals */
    void (*fetch)(void* type, void* value, void* traceback); /* PyErr_Fetch; each a PyObject** */
    int (*call)(const netmesh_progress* progress);           /* sets `answer`: 1 goes on, 2 stops; null: no progress */
    int64_t signals_every, progress_every;                   /* nanoseconds */
    int64_t signals_next, progress_next;                     /* when; 0 at first */
    void* error_type;                                        /* what a signal's handler raised, else null */
    void* error_value;
    void* error_traceback;
    int32_t answer;
    int32_t stop; /* 1: the next poll cancels */
} netmesh_python_watch;

/* A netmesh_poll; user is a netmesh_python_watch. */
int netmesh_python_poll(void* user, const netmesh_progress* progress);

#ifdef __cplusplus
}
#endif
#endif
