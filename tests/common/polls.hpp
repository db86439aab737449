// Counts the polls of a run, and answers one of them with the wish to stop.
#pragma once
#include "include/netmesh.h"

struct Polls {
    long made = 0, stop_at = -1;  // the poll that stops, counted from 0; -1: none
    static int answer(void* polls, const netmesh_progress*) {
        Polls& p = *static_cast<Polls*>(polls);
        return static_cast<int>(p.made++ == p.stop_at);
    }
    // For requests; these polls must outlive them.
    netmesh_monitor monitor() { return {answer, this}; }
};
