// The jobs of the sweep: every call of netmesh.h that takes memory or polls, on small inputs.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/calls.hpp"

struct Job;

// One run of a job: calls on its context, watched by the sweep.
struct Run : Calls {
    Run(const Job& of, netmesh_context* context);
    // As many uniform points as the job has.
    const inputs::Points& points() const;
    const Job& job;
};

struct Job {
    const char* name;
    int dim;
    std::size_t points;
    // Runs the steps of the job until one fails.
    std::function<netmesh_status(Run& run)> steps;

    bool is_large = false;       // left out of the quick slice
    long tries_max = 0;          // of requests, polls and block sizes, evenly spread; 0: all
    bool keeps_diagram = false;  // the last step, when it fails, leaves the diagram of an earlier one
    // When above 0 the job uses a block up, and its result goes by the size: a block of this many bytes.
    std::size_t block = 0;

    Job large(bool yes = true) const { return with(&Job::is_large, yes); }
    Job tries(long most) const { return with(&Job::tries_max, most); }
    Job keeping_diagram() const { return with(&Job::keeps_diagram, true); }
    Job using_up(std::size_t bytes) const { return with(&Job::block, bytes); }

private:
    template <class Member> Job with(Member Job::*member, Member value) const {
        Job job = *this;
        job.*member = value;
        return job;
    }
};

// What the last run of a job got by other ways than the context: a hash, 0 when there is nothing.
extern std::uint64_t figures_of_run;

void add_mesh_jobs(std::vector<Job>* jobs);
void add_diagram_jobs(std::vector<Job>* jobs);
void add_figure(std::uint64_t figure);
