// Any request for memory refused, any size and content of the block, any moment to cancel: a status, what is held is
// whole and valid, nothing outside the block is touched, and the next run in the same context gives the result of an
// undisturbed one.
//
//   sweep            everything
//   sweep quick      a slice
//   sweep refuse     each request and each poll once, in all dimensions, and no more: for coverage
//   sweep planted    jobs that do what they must not; fails unless each is seen
//
// Names of jobs may follow; then only those run.
#include <cstdio>
#include <cstring>

#include "sweep/harness.hpp"
#include "sweep/jobs.hpp"
#include "vocabulary/dimension.hpp"

Disturbance disturbance;
Place place;
long faults = 0;
Tally total;

namespace netmesh {
bool sweep_refuses() {
    const long now = disturbance.requests++;
    return now >= disturbance.refuse_from && now < disturbance.refuse_to;
}
}  // namespace netmesh

int sweep_poll(void*, const netmesh_progress*) {
    if (disturbance.job != nullptr && netmesh_pause(disturbance.job) != 0) return 1;
    return disturbance.polls++ == disturbance.cancel_at;
}

netmesh_status Slices::run(const std::function<netmesh_status()>& steps, long cancel_at) {
    const auto task = [](void* user) { return (*static_cast<const std::function<netmesh_status()>*>(user))(); };
    netmesh_job* job = nullptr;
    auto* const user = const_cast<std::function<netmesh_status()>*>(&steps);
    if (!require(netmesh_job_init(stack_.base(), bytes_, task, user, &job) == NETMESH_OK, "no job"))
        return NETMESH_INTERNAL;
    disturbance.job = job;
    pauses = 0;
    netmesh_status status = netmesh_resume(job);
    for (; status == NETMESH_PAUSED && pauses != cancel_at; ++pauses) status = netmesh_resume(job);
    if (status == NETMESH_PAUSED) status = netmesh_cancel(job);
    disturbance.job = nullptr;
    require(netmesh_job_ended(job) == 1, "the job has not ended");
    require(stack_.guards_intact(), "wrote outside the job's stack");
    return status;
}

bool require(bool good, const char* what) {
    if (!good && ++faults <= 50)
        std::printf("FAULT %s D%d, %s %lld: %s\n", place.job, place.dim, place.phase, place.where, what);
    return good;
}

namespace {

struct Outcome {
    netmesh_status status;
    std::uint64_t fingerprint, figures, used_bytes;
    bool holds, has_diagram;
    friend bool operator==(const Outcome& a, const Outcome& b) {
        return a.status == b.status && a.fingerprint == b.fingerprint && a.figures == b.figures &&
               a.used_bytes == b.used_bytes && a.holds == b.holds && a.has_diagram == b.has_diagram;
    }
};

netmesh_report whole_report(const netmesh_context* context) {
    auto report = netmesh::sized<netmesh_report>();
    require(netmesh_get_report(context, &report) == NETMESH_OK, "no report");
    return report;
}

// What can be read and is not in the report's fingerprint: cycles and bounds of the bars.
std::uint64_t read_bars(const netmesh_context* context) {
    std::uint64_t hash = 1, count = 0;
    const auto add = [&hash](std::uint64_t x) { hash = (hash ^ x) * 0x100000001B3u + 1; };
    auto simplex = netmesh::sized<netmesh_simplex>();
    auto bounds = netmesh::sized<netmesh_bar_bounds>();
    auto pair = netmesh::sized<netmesh_pair>();
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i) {
        if (netmesh_get_bar_bounds(context, i, &bounds) == NETMESH_OK) {
            require(bounds.birth_low <= pair.birth && pair.birth <= bounds.birth_high, "bounds without their bar");
            add(bounds.certain);
        }
        if (netmesh_get_cycle(context, i, &count) != NETMESH_OK) continue;
        for (std::uint64_t n = 0; n < count; ++n) {
            require(netmesh_get_cycle_simplex(context, i, n, &simplex) == NETMESH_OK, "a simplex is missing");
            for (std::uint32_t k = 0; k <= pair.degree; ++k) add(simplex.vertices[k]);
        }
    }
    return hash;
}

// The triangulation that is held.
void look_at_mesh(Calls& calls, const netmesh_report& report) {
    const netmesh_status checked =
        calls.check(NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY);
    require(checked == NETMESH_OK, calls.detail().message);
    require(whole_report(calls.context).fingerprint == report.fingerprint, "the check changed the result");
    require(calls.vertices().size() == report.mesh.vertices, "a vertex is missing");
}

void look_at_pairs(const netmesh_context* context, const netmesh_report& report) {
    std::uint64_t counted = 0;
    const std::vector<netmesh_pair> pairs = read_all(context, netmesh_get_pair);
    for (const netmesh_pair& pair : pairs)
        require(pair.birth <= pair.death && pair.degree <= report.diagram.max_degree, "a pair is not one");
    for (const std::uint64_t n : report.diagram.pairs) counted += n;
    require(pairs.size() == counted && pairs.empty() == (report.diagram.present == 0), "pairs and report differ");
}

// Runs the job, in slices when some are given, and looks at what it leaves behind, disturbed or not.
Outcome run(const Job& job, netmesh_context* context, Slices* slices = nullptr, long cancel_at = -1) {
    Run calls(job, context);
    figures_of_run = 0;
    Outcome outcome = {};
    outcome.status = slices != nullptr ? slices->run([&] { return job.steps(calls); }, cancel_at) : job.steps(calls);
    const bool disturbed = outcome.status == NETMESH_OUT_OF_MEMORY || outcome.status == NETMESH_CANCELLED;
    require(outcome.status == NETMESH_OK || disturbed, netmesh_status_text(outcome.status));
    const netmesh_detail detail = calls.detail();
    require(detail.status == outcome.status && (outcome.status == NETMESH_OK) == (detail.message[0] == 0),
            "the detail does not fit");

    const Disturbance before = disturbance;
    disturbance.refuse_from = disturbance.refuse_to;
    calls.request.monitor = {};
    const netmesh_report report = whole_report(context);
    outcome.fingerprint = report.fingerprint;
    outcome.used_bytes = report.memory.used_bytes;
    outcome.has_diagram = report.diagram.present != 0;
    outcome.holds = report.mesh.present != 0 || outcome.has_diagram || report.vineyard.present != 0;
    require((report.mesh.present != 0) == (report.mesh.cells != 0), "a mesh without cells");
    if (report.mesh.present != 0) look_at_mesh(calls, report);
    look_at_pairs(context, report);
    require(outcome.holds || (report.mesh.vertices == 0 && report.simplicial_complex.present == 0),
            "an empty context holds something");
    // A refused or cancelled step takes its own diagram away, never the mesh.
    require(!disturbed || !outcome.has_diagram || job.keeps_diagram, "a partial diagram is held");
    outcome.figures = figures_of_run ^ read_bars(context);
    disturbance = before;
    return outcome;
}

std::size_t enough(const Job& job) { return job.block > 0 ? job.block : std::size_t{4} << 20; }

netmesh_context* fresh(Block* block, std::size_t bytes) {
    netmesh_context* context = nullptr;
    require(netmesh_init(block->base(), bytes, &context) == NETMESH_OK, "the block is not accepted");
    return context;
}

struct Undisturbed {
    Outcome outcome;
    long requests, polls;
    std::size_t bytes, own_bytes;  // all that it used, and without what an empty context does
};

Undisturbed undisturbed(const Job& job) {
    Block block(enough(job), 0, false);
    netmesh_context* const context = fresh(&block, enough(job));
    const std::uint64_t empty = whole_report(context).memory.used_bytes;
    run(job, context);  // inputs that a job makes for itself are made now
    disturbance = {};
    Undisturbed u;
    u.outcome = run(job, context);
    u.requests = disturbance.requests;
    u.polls = disturbance.polls;
    u.bytes = static_cast<std::size_t>(whole_report(context).memory.peak_bytes);
    u.own_bytes = u.bytes - static_cast<std::size_t>(empty);
    require(u.outcome.status == NETMESH_OK, "the undisturbed run fails");
    return u;
}

enum class Mode { all, quick, refuse };

// Of `count` chances every so-manieth is taken.
long step_of(const Job& job, Mode mode, long count) {
    const long tries = mode == Mode::quick ? 12
                       : mode == Mode::all ? job.tries_max
                       : job.tries_max > 0 ? 4 * job.tries_max
                                           : 400;
    return tries > 0 && count > tries ? (count + tries - 1) / tries : 1;
}

// Request k refused, alone or with all that follow; poll k answered with a wish to stop.
void refuse_and_cancel(const Job& job, const Undisturbed& u, Mode mode) {
    Block block(enough(job), 0xAA, false);
    netmesh_context* context = fresh(&block, enough(job));
    const auto once = [&](const char* name, long k, Disturbance by, bool must_end) {
        place.phase = name;
        place.where = k;
        disturbance = by;
        const Outcome o = run(job, context);
        total.count(o.status, o.holds);
        require(!must_end || o.status != NETMESH_OK, "went on as if nothing had happened");
        require(!o.has_diagram || o.fingerprint == u.outcome.fingerprint || job.block > 0,
                "a diagram is held, but not the whole one");
        require(block.guards_intact(), "wrote outside the block");
        disturbance = {};
        if (mode != Mode::refuse) require(run(job, context) == u.outcome, "the next run is another one");
    };
    const long all = u.requests * 100 + 1000;
    for (long k = 0; k < u.requests; k += step_of(job, mode, u.requests)) {
        once("request refused", k, {k, k + 1, -1, 0, 0, nullptr}, false);
        if (mode != Mode::refuse) once("requests refused from", k, {k, all, -1, 0, 0, nullptr}, true);
    }
    for (long k = 0; k < u.polls; k += step_of(job, mode, u.polls)) once("poll", k, {-1, -1, k, 0, 0, nullptr}, true);
}

// Paused at every poll, and ended at pause k: what the undivided run gives, and the one that is cancelled at poll k.
void slice(const Job& job, const Undisturbed& u, Mode mode) {
    Block block(enough(job), 0xAA, false);
    netmesh_context* const context = fresh(&block, enough(job));
    Slices slices(std::size_t{1} << 20);
    place.phase = "paused at each poll";
    place.where = 0;
    disturbance = {};
    require(run(job, context, &slices) == u.outcome, "in slices it ends differently");
    require(slices.pauses == u.polls, "it did not pause at each poll");
    total.pauses += slices.pauses;
    place.phase = "ended at pause";
    for (long k = 0; k < u.polls; k += step_of(job, mode, u.polls)) {
        place.where = k;
        disturbance = {};
        const Outcome ended = run(job, context, &slices, k);
        disturbance = {-1, -1, k, 0, 0, nullptr};
        require(ended == run(job, context), "ends differently from a run that is cancelled there");
        total.pauses += slices.pauses + 1;
    }
    disturbance = {};
    require(run(job, context) == u.outcome, "the next run is another one");
    require(block.guards_intact(), "wrote outside the block");
}

// One block size: two contents before, between guards and tight.
bool size(const Job& job, const Undisturbed& u, std::size_t bytes) {
    place.phase = "block of bytes";
    place.where = static_cast<long long>(bytes);
    Outcome outcome[2];
    for (int i = 0; i < 2; ++i) {
        disturbance = {};
        Block block(bytes, i == 0 ? 0xAA : 0x55, i == 1);
        netmesh_context* context = nullptr;
        const netmesh_status made = netmesh_init(block.base(), bytes, &context);
        require(made == NETMESH_OK || (made == NETMESH_OUT_OF_MEMORY && context == nullptr), "init");
        outcome[i] = made == NETMESH_OK ? run(job, context) : Outcome{made, 0, 0, 0, false, false};
        total.count(outcome[i].status, outcome[i].holds);
        require(block.guards_intact(), "wrote outside the block");
        if (made == NETMESH_OK && outcome[i].status == NETMESH_OUT_OF_MEMORY) {
            disturbance = {};
            require(run(job, context) == outcome[i], "a second run in a block that is too small ends differently");
        }
    }
    require(outcome[0] == outcome[1], "the content of the block before matters");
    if (outcome[0].status != NETMESH_OK) return false;
    require(outcome[0].fingerprint == u.outcome.fingerprint || job.block > 0,
            "another fingerprint than in a large block");
    return true;
}

void sizes(const Job& job, const Undisturbed& u, std::size_t step, double growth) {
    const std::size_t last = u.bytes + u.bytes / 8 + 1024;
    bool fits = false;
    for (std::size_t bytes = 0; bytes <= last;) {
        const bool now = size(job, u, bytes);
        require(now || !fits, "fits in a smaller block but not in this one");
        fits = now;
        const std::size_t grown = static_cast<std::size_t>(static_cast<double>(bytes) * growth);
        const std::size_t next = grown > bytes + step ? grown : bytes + step;
        bytes = bytes < last && next > last ? last : next;
    }
    place.phase = "largest block";
    require(fits, "does not fit in a block of what it used and an eighth more");
}

void misaligned() {
    place = {"init", 2, "misaligned by", 0};
    for (std::size_t where = 1; where < 16; ++where) {
        place.where = static_cast<long long>(where);
        Block block(8192, 0xAA, false);
        netmesh_context* context = nullptr;
        require(netmesh_init(block.base() + where, 8192 - where, &context) == NETMESH_INVALID_ARGUMENT,
                "a misaligned block is accepted");
        require(netmesh_adopt(block.base() + where, &context) == NETMESH_INVALID_ARGUMENT,
                "a misaligned block is adopted");
        for (std::size_t i = 0; i < 8192; ++i) require(block.base()[i] == 0xAA, "a refused block was written to");
        require(block.guards_intact(), "wrote outside the block");
        ++total.refused;
    }
}

// ---- planted faults

netmesh_status delaunay_of(Run& run, std::size_t n) {
    static const inputs::Points points = {0, 0, 4, 0, 1, 3, 5, 5, 2, 7, 6, 2, 3, 3, 7, 7};
    return run.delaunay_in_block(inputs::Points(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(2 * n)));
}

unsigned char* end_of(const Run& run) {
    return reinterpret_cast<unsigned char*>(run.context) + run.report().memory.block_bytes;
}

const Job planted_jobs[] = {
    {"goes on", 2, 8,
     [](Run& run) {
         delaunay_of(run, run.job.points);
         return NETMESH_OK;
     }},
    {"overruns", 2, 8,
     [](Run& run) {
         const netmesh_status status = delaunay_of(run, run.job.points);
         if (status != NETMESH_OK) *end_of(run) = 0;
         return status;
     }},
    {"looks", 2, 8, [](Run& run) { return delaunay_of(run, run.job.points - (end_of(run)[-1] == 0x55)); }},
    {"pauses", 2, 8, [](Run& run) { return delaunay_of(run, run.job.points - (disturbance.job != nullptr)); }},
};

// The number of planted jobs in which no fault is found.
int unseen() {
    int missed = 0;
    for (const Job& job : planted_jobs) {
        place = {job.name, job.dim, "undisturbed", 0};
        faults = 0;
        const Undisturbed u = undisturbed(job);
        refuse_and_cancel(job, u, Mode::all);
        slice(job, u, Mode::all);
        for (std::size_t bytes = 4096; bytes < u.bytes + 4096; bytes += 256)
            if (std::strcmp(job.name, "overruns") != 0) size(job, u, bytes);
        std::printf("planted job \"%s\": %ld faults seen\n", job.name, faults);
        missed += faults == 0;
    }
    return missed;
}

std::vector<Job> jobs_of(Mode mode, int names, char** name) {
    std::vector<Job> all, wanted;
    add_mesh_jobs(&all);
    add_diagram_jobs(&all);
    for (const Job& job : all) {
        bool named = names == 0;
        for (int i = 0; i < names; ++i) named = named || std::strcmp(name[i], job.name) == 0;
        const bool left_out = (mode == Mode::quick && job.is_large) || (mode != Mode::refuse && job.dim > 4) ||
                              !netmesh::serves_dimension(static_cast<std::uint32_t>(job.dim));
        if (named && !left_out) wanted.push_back(job);
    }
    return wanted;
}

void sweep(const Job& job, Mode mode) {
    place = {job.name, job.dim, "undisturbed", 0};
    const Tally before = total;
    const Undisturbed u = undisturbed(job);
    refuse_and_cancel(job, u, mode);
    if (mode != Mode::refuse) slice(job, u, mode);
    const double growth = mode == Mode::quick ? 1.1 : job.tries_max > 0 ? 1.1 : 1.005;
    if (mode != Mode::refuse) sizes(job, u, mode == Mode::quick ? 256 : 16, growth);
    // Every single byte of the way, where it is short: by what the job takes, so that a larger context leaves none out.
    const bool every_byte = mode == Mode::all && job.dim == 2 && u.own_bytes < 8000;
    if (every_byte) sizes(job, u, 1, 1);
    std::printf("%-16s D%d: %5ld requests, %5ld polls, %7zu bytes; %6ld refused, %5ld cancelled, %5ld of them with "
                "a partial mesh, %6ld whole, %6ld pauses%s\n",
                job.name, job.dim, u.requests, u.polls, u.bytes, total.refused - before.refused,
                total.cancelled - before.cancelled, total.partial - before.partial, total.whole - before.whole,
                total.pauses - before.pauses, every_byte ? ", at every byte" : "");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "planted") == 0) return unseen() == 0 ? 0 : 1;
    Mode mode = Mode::all;
    if (argc > 1 && std::strcmp(argv[1], "quick") == 0) mode = Mode::quick;
    if (argc > 1 && std::strcmp(argv[1], "refuse") == 0) mode = Mode::refuse;
    const int first_name = mode == Mode::all ? 1 : 2;
    misaligned();
    sweep_distances();
    for (const Job& job : jobs_of(mode, argc > first_name ? argc - first_name : 0, argv + first_name)) sweep(job, mode);
    std::printf("%ld points of failure, %ld pauses, %ld faults\n", total.refused + total.cancelled, total.pauses,
                faults);
    return faults == 0 ? 0 : 1;
}
