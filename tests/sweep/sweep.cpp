// Any request for memory refused, any size and content of the block, any moment to cancel: a status, what is held is
// whole and valid, nothing outside the block is touched, and the next run in the same context gives the result of an
// undisturbed one.
//
//   sweep            everything
//   sweep quick      a slice
//   sweep planted    jobs that do what they must not; fails unless each is seen
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "sweep/jobs.hpp"

namespace {

// ---- what the engine asks

long refuse_from = -1, refuse_to = -1;  // requests that are refused, counted from 0
long requests = 0;

}  // namespace

namespace netmesh {
bool sweep_refuses() {
    const long now = requests++;
    return now >= refuse_from && now < refuse_to;
}
}  // namespace netmesh

namespace {

long cancel_at = -1, polls = 0;

int poll(void*, const netmesh_progress*) { return polls++ == cancel_at; }

void disturb_nothing() {
    refuse_from = refuse_to = cancel_at = -1;
    requests = polls = 0;
}

// ---- the block

constexpr std::size_t guard_bytes = 64;
constexpr unsigned char guard = 0xC3;

// Exactly `bytes` bytes at an aligned address: between guards, or (tight) as an allocation of its own, whose end a
// sanitizer watches.
class Block {
public:
    Block(std::size_t bytes, unsigned char fill, bool tight) : bytes_(bytes), margin_(tight ? 0 : guard_bytes) {
        void* memory = nullptr;
        if (posix_memalign(&memory, 16, bytes + 2 * margin_ + (bytes + 2 * margin_ == 0)) != 0) std::abort();
        memory_ = static_cast<unsigned char*>(memory);
        std::memset(memory_, guard, bytes + 2 * margin_);
        std::memset(base(), fill, bytes);
    }
    ~Block() { std::free(memory_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    unsigned char* base() { return memory_ + margin_; }
    bool guards_intact() const {
        for (std::size_t i = 0; i < margin_; ++i)
            if (memory_[i] != guard || memory_[margin_ + bytes_ + i] != guard) return false;
        return true;
    }

private:
    std::size_t bytes_, margin_;
    unsigned char* memory_;
};

// ---- what must hold

long faults = 0;
const Job* current = nullptr;
const char* phase = "";
long long where = 0;

bool require(bool good, const char* what) {
    if (!good && ++faults <= 50)
        std::printf("FAULT %s D%d, %s %lld: %s\n", current->name, current->dim, phase, where, what);
    return good;
}

struct Outcome {
    netmesh_status status;
    std::uint64_t fingerprint, used_bytes;
    bool holds;
    friend bool operator==(const Outcome& a, const Outcome& b) {
        return a.status == b.status && a.fingerprint == b.fingerprint && a.used_bytes == b.used_bytes &&
               a.holds == b.holds;
    }
};

netmesh_report report_of(const netmesh_context* context) {
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    require(netmesh_get_report(context, &report) == NETMESH_OK, "no report");
    return report;
}

// Runs the job and looks at what it leaves behind, disturbed or not.
Outcome run(const Job& job, netmesh_context* context) {
    netmesh_options options;
    netmesh_options_init(&options, static_cast<std::uint32_t>(job.dim));
    options.poll = poll;
    Outcome outcome = {};
    outcome.status = job.run(job, context, &options);
    const bool disturbed = outcome.status == NETMESH_OUT_OF_MEMORY || outcome.status == NETMESH_CANCELLED;
    require(outcome.status == NETMESH_OK || disturbed, netmesh_status_text(outcome.status));
    const netmesh_detail detail = netmesh_get_detail(context);
    require(detail.status == outcome.status && (outcome.status == NETMESH_OK) == (detail.message[0] == 0),
            "the detail does not fit");

    const long from = refuse_from;
    refuse_from = refuse_to;
    options.poll = nullptr;
    const netmesh_report report = report_of(context);
    outcome.fingerprint = report.fingerprint;
    outcome.used_bytes = report.used_bytes;
    outcome.holds = report.dim != 0;
    if (outcome.holds) {
        const netmesh_status checked = netmesh_check(
            context, NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY, &options);
        require(checked == NETMESH_OK, netmesh_get_detail(context).message);
        require(report_of(context).fingerprint == outcome.fingerprint, "the check changed the result");
        netmesh_vertex vertex;
        for (std::uint64_t i = 0; i < report.vertices; ++i)
            require(netmesh_get_vertex(context, i, &vertex) == NETMESH_OK, "a vertex is missing");
        std::uint64_t pairs = 0, counted = 0;
        for (netmesh_pair pair; netmesh_get_pair(context, pairs, &pair) == NETMESH_OK; ++pairs)
            require(pair.birth <= pair.death && pair.degree < report.dim, "a pair is not one");
        for (std::uint64_t n : report.pairs) counted += n;
        require(pairs == counted && (pairs > 0) == (report.has_diagram != 0), "pairs and report differ");
        // A refused or cancelled persist takes the diagram away, never the mesh; cycles and bounds leave the diagram before them.
        const bool may_hold = std::strcmp(job.name, "check") == 0 || std::strcmp(job.name, "cycles") == 0 ||
                              std::strcmp(job.name, "bounds") == 0;
        require(!disturbed || !report.has_diagram || may_hold, "a partial diagram is held");
    } else {
        require(report.vertices == 0 && report.cells == 0 && !report.has_diagram, "an empty context holds something");
    }
    refuse_from = from;
    return outcome;
}

struct Tally {
    long refused = 0, cancelled = 0, whole = 0, partial = 0;
    void count(const Outcome& o) {
        refused += o.status == NETMESH_OUT_OF_MEMORY;
        cancelled += o.status == NETMESH_CANCELLED;
        whole += o.status == NETMESH_OK;
        partial += o.status != NETMESH_OK && o.holds;
    }
} total;

constexpr std::size_t enough = std::size_t{4} << 20;

netmesh_context* fresh(Block* block, std::size_t bytes) {
    netmesh_context* context = nullptr;
    require(netmesh_init(block->base(), bytes, &context) == NETMESH_OK, "the block is not accepted");
    return context;
}

struct Undisturbed {
    Outcome outcome;
    long requests, polls;
    std::size_t bytes;
};

Undisturbed undisturbed(const Job& job) {
    Block block(enough, 0, false);
    netmesh_context* const context = fresh(&block, enough);
    run(job, context);  // inputs that a job makes for itself are made now
    disturb_nothing();
    Undisturbed u;
    u.outcome = run(job, context);
    u.requests = requests;
    u.polls = polls;
    u.bytes = static_cast<std::size_t>(report_of(context).peak_bytes);
    require(u.outcome.status == NETMESH_OK, "the undisturbed run fails");
    return u;
}

// Request k refused, alone or with all that follow; poll k answered with a wish to stop.
void refuse_and_cancel(const Job& job, const Undisturbed& u, long step) {
    Block block(enough, 0xAA, false);
    netmesh_context* context = fresh(&block, enough);
    const auto once = [&](const char* name, long k, bool must_end) {
        phase = name;
        where = k;
        const Outcome o = run(job, context);
        total.count(o);
        require(!must_end || o.status != NETMESH_OK, "went on as if nothing had happened");
        require(block.guards_intact(), "wrote outside the block");
        disturb_nothing();
        require(run(job, context) == u.outcome, "the next run is another one");
    };
    for (long k = 0; k < u.requests; k += step) {
        disturb_nothing();
        refuse_from = k;
        refuse_to = k + 1;
        once("request refused", k, false);
        disturb_nothing();
        refuse_from = k;
        refuse_to = u.requests * 100 + 1000;
        once("requests refused from", k, true);
    }
    for (long k = 0; k < u.polls; k += step) {
        disturb_nothing();
        cancel_at = k;
        once("poll", k, true);
    }
}

// One block size: two contents before, between guards and tight.
bool size(const Job& job, const Undisturbed& u, std::size_t bytes) {
    phase = "block of bytes";
    where = static_cast<long long>(bytes);
    Outcome outcome[2];
    for (int i = 0; i < 2; ++i) {
        disturb_nothing();
        Block block(bytes, i == 0 ? 0xAA : 0x55, i == 1);
        netmesh_context* context = nullptr;
        const netmesh_status made = netmesh_init(block.base(), bytes, &context);
        require(made == NETMESH_OK || (made == NETMESH_OUT_OF_MEMORY && context == nullptr), "init");
        outcome[i] = made == NETMESH_OK ? run(job, context) : Outcome{made, 0, 0, false};
        total.count(outcome[i]);
        require(block.guards_intact(), "wrote outside the block");
        if (made == NETMESH_OK && outcome[i].status == NETMESH_OUT_OF_MEMORY) {
            disturb_nothing();
            require(run(job, context) == outcome[i], "a second run in a block that is too small ends differently");
        }
    }
    require(outcome[0] == outcome[1], "the content of the block before matters");
    if (outcome[0].status != NETMESH_OK) return false;
    require(outcome[0].fingerprint == u.outcome.fingerprint, "another fingerprint than in a large block");
    return true;
}

void sizes(const Job& job, const Undisturbed& u, std::size_t step, double growth) {
    const std::size_t last = u.bytes + u.bytes / 8 + 1024;
    bool fits = false;
    for (std::size_t bytes = 0; bytes <= last;) {
        const bool now = size(job, u, bytes);
        require(now || !fits, "fits in a smaller block but not in this one");
        fits = now;
        const std::size_t next = static_cast<std::size_t>(static_cast<double>(bytes) * growth);
        bytes = next > bytes + step ? next : bytes + step;
    }
    phase = "largest block";
    require(fits, "does not fit in a block of what it used and an eighth more");
}

void misaligned() {
    static const Job any = {"init", 2, 0, nullptr};
    current = &any;
    phase = "misaligned by";
    for (where = 1; where < 16; ++where) {
        Block block(8192, 0xAA, false);
        netmesh_context* context = nullptr;
        require(netmesh_init(block.base() + where, 8192 - static_cast<std::size_t>(where), &context) ==
                    NETMESH_INVALID_ARGUMENT,
                "a misaligned block is accepted");
        require(netmesh_adopt(block.base() + where, &context) == NETMESH_INVALID_ARGUMENT,
                "a misaligned block is adopted");
        for (std::size_t i = 0; i < 8192; ++i) require(block.base()[i] == 0xAA, "a refused block was written to");
        require(block.guards_intact(), "wrote outside the block");
        ++total.refused;
    }
}

// ---- planted faults

netmesh_status delaunay_of(netmesh_context* context, std::size_t n, netmesh_options* options) {
    static const double points[] = {0, 0, 4, 0, 1, 3, 5, 5, 2, 7, 6, 2, 3, 3, 7, 7};
    return netmesh_delaunay(context, points, n, options);
}

unsigned char* end_of(netmesh_context* context) {
    return reinterpret_cast<unsigned char*>(context) + report_of(context).block_bytes;
}

const Job planted_jobs[] = {
    {"goes on", 2, 8,
     [](const Job& job, netmesh_context* context, netmesh_options* options) {
         delaunay_of(context, job.points, options);
         return NETMESH_OK;
     }},
    {"overruns", 2, 8,
     [](const Job& job, netmesh_context* context, netmesh_options* options) {
         const netmesh_status status = delaunay_of(context, job.points, options);
         if (status != NETMESH_OK) *end_of(context) = 0;
         return status;
     }},
    {"looks", 2, 8,
     [](const Job& job, netmesh_context* context, netmesh_options* options) {
         return delaunay_of(context, job.points - (end_of(context)[-1] == 0x55), options);
     }},
};

// The number of planted jobs in which no fault is found.
int unseen() {
    int missed = 0;
    for (const Job& job : planted_jobs) {
        current = &job;
        faults = 0;
        disturb_nothing();
        const Undisturbed u = undisturbed(job);
        refuse_and_cancel(job, u, 1);
        for (std::size_t bytes = 4096; bytes < u.bytes + 4096; bytes += 256)
            if (std::strcmp(job.name, "overruns") != 0) size(job, u, bytes);
        std::printf("planted job \"%s\": %ld faults seen\n", job.name, faults);
        missed += faults == 0;
    }
    return missed;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "planted") == 0) return unseen() == 0 ? 0 : 1;
    const bool quick = argc > 1 && std::strcmp(argv[1], "quick") == 0;
    misaligned();
    for (const Job& job : all_jobs()) {
        if (quick && job.large) continue;
        current = &job;
        phase = "undisturbed";
        const Tally before = total;
        disturb_nothing();
        const Undisturbed u = undisturbed(job);
        refuse_and_cancel(job, u, quick ? 7 : 1);
        sizes(job, u, quick ? 256 : 16, quick ? 1.05 : 1.005);
        // Every single byte of the way, where it is short.
        if (!quick && job.dim == 2 && u.bytes < 9000) sizes(job, u, 1, 1);
        std::printf("%-9s D%d: %5ld requests, %4ld polls, %7zu bytes; %6ld refused, %4ld cancelled, %5ld of them with "
                    "a partial mesh, %6ld whole\n",
                    job.name, job.dim, u.requests, u.polls, u.bytes, total.refused - before.refused,
                    total.cancelled - before.cancelled, total.partial - before.partial, total.whole - before.whole);
        std::fflush(stdout);
    }
    std::printf("%ld points of failure, %ld faults\n", total.refused + total.cancelled, faults);
    return faults == 0 ? 0 : 1;
}
