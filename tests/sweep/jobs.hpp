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
    bool large = false;          // left out of the quick slice
    long tries_max = 0;          // of requests, polls and block sizes, evenly spread; 0: all
    bool keeps_diagram = false;  // the last step, when it fails, leaves the diagram of an earlier one
    // When above 0 the job uses a block up, and its result goes by the size: a block of this many bytes.
    std::size_t block = 0;
};

// What the last run of a job got by other ways than the context: a hash, 0 when there is nothing.
extern std::uint64_t figures_of_run;

void add_diagram_jobs(std::vector<Job>* jobs);
const std::vector<Job>& all_jobs();
