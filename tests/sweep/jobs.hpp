// The jobs of the sweep: every call of netmesh.h that takes memory or polls, on small inputs.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "netmesh.h"

struct Job {
    const char* name;
    int dim;
    std::size_t points;
    // Runs the steps of the job on a context until one fails.
    netmesh_status (*run)(const Job& job, netmesh_context* context, netmesh_options* options);
    bool large = false;  // left out of the quick slice
};

const std::vector<Job>& all_jobs();
