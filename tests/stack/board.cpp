// Runs the jobs whose stack is documented (netmesh/job.h) on clouds of every kind, each call on a stack of exactly the
// documented size with a guard below, all of it painted before. Compiled for one DIM, and PROMISE, the largest
// dimension of the library; CLOUDS for each job, from SEED
// on; PERCENT of the documented sizes are given: less than 100 plants a fault that has to be seen. It prints what each
// cloud leads to; ON_HOST it does this alone, on any machine: the results that a board has to have.
#include "board.hpp"
#ifdef ON_HOST
#include <cstdio>
#endif
#include "determinism/text.hpp"
#include "netmesh.h"

namespace {

constexpr std::uint32_t paint = 0xC3A55A3Cu;
constexpr std::size_t guard_bytes = 16 << 10, stack_most = NETMESH_STACK_BYTES(DIM), points_max = 64;

enum Job { delaunay, alpha, certified, rips, job_count };
const char* const job_name[] = {"delaunay", "alpha", "certified", "rips"};
constexpr std::size_t documented[] = {NETMESH_STACK_BYTES_DELAUNAY(PROMISE), NETMESH_STACK_BYTES_ALPHA(PROMISE),
                                      NETMESH_STACK_BYTES_CERTIFIED(PROMISE), NETMESH_STACK_BYTES_RIPS(PROMISE)};
// What is refused may be refused by all clouds of a kind, and seven of nine kinds are accepted by every job.
constexpr std::uint32_t refused_percent_max = 40;

#ifdef ON_HOST
alignas(16) unsigned char block[8 << 20];  // pointers are longer
#else
alignas(16) unsigned char block[2 << 20];
#endif
alignas(16) std::uint32_t area[(guard_bytes + stack_most + NETMESH_STACK_BYTES_JOB) / sizeof(std::uint32_t)];
double points[points_max * DIM];
std::size_t count;
netmesh_context* context;
netmesh_request request, persist;
netmesh_report report;
netmesh_pair pair;
netmesh_cell cell;
netmesh_job* slices;

struct Random {
    std::uint64_t state;
    std::uint32_t below(std::uint32_t n) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>((state >> 33) % n);
    }
    double unit() { return below(1u << 30) / 1073741824.0; }
};

// Clouds
// ---------------------------------------------------------------------------------------------------------------

enum Kind { uniform, integers, tenths, rounded, circle, moved, line, wide, few, kind_count };
const char* const kind_name[] = {"uniform", "integers", "tenths", "rounded", "circle", "moved", "line", "wide", "few"};

double up_by(double x, std::uint32_t last_places) {
    std::uint64_t bits;
    __builtin_memcpy(&bits, &x, sizeof bits);
    if (x != 0) bits += last_places;
    __builtin_memcpy(&x, &bits, sizeof bits);
    return x;
}

// As users compute them: i / 10 and i * 0.1 differ in some last places.
void draw_grid(Random& random, double unit, bool divides) {
    const std::uint32_t side = DIM == 2 ? 2 + random.below(6) : DIM == 3 ? 2 + random.below(2) : 2;
    const std::int32_t from = static_cast<std::int32_t>(random.below(40)) - 20;
    count = 0;
    for (std::uint32_t k = 0; count < points_max; ++k) {
        std::uint32_t rest = k;
        for (int c = 0; c < DIM; ++c) {
            const std::uint32_t steps = c + 1 < DIM ? rest % side : rest;
            const double i = from + static_cast<std::int32_t>(steps);
            if (c + 1 == DIM && steps > side) return;
            points[count * DIM + c] = divides ? i / unit : i * unit;
            rest /= side;
        }
        ++count;
    }
}

// On a sphere of some radius, as doubles have it: stereographic projection.
void draw_sphere(Random& random) {
    const double radius = 0.1 * (1 + random.below(100)), shift = random.below(2) != 0 ? 0.3 : 0;
    for (std::size_t i = 0; i < count; ++i) {
        double t[DIM] = {}, norm2 = 0;
        for (int c = 0; c + 1 < DIM; ++c) {
            t[c] = 0.125 * random.below(33) - 2;
            norm2 += t[c] * t[c];
        }
        double* const x = points + i * DIM;
        for (int c = 0; c + 1 < DIM; ++c) x[c] = radius * (2 * t[c] / (1 + norm2)) + shift;
        x[DIM - 1] = radius * ((1 - norm2) / (1 + norm2));
    }
}

double power_of_two(int e) {
    double p = 1;
    for (; e > 0; --e) p *= 2;
    for (; e < 0; ++e) p /= 2;
    return p;
}

void draw(Kind kind, Random& random) {
    const std::size_t most = DIM == 2 ? 28 : DIM == 3 ? 14 : 5;
    count = DIM + 2 + random.below(static_cast<std::uint32_t>(most));
    if (kind == few) count = 1 + random.below(DIM + 2);
    for (std::size_t i = 0; i < count * DIM; ++i) points[i] = random.unit();
    switch (kind) {
    case integers: draw_grid(random, 1, true); break;
    case tenths: draw_grid(random, random.below(2) != 0 ? 10 : 0.1, false); break;
    case rounded:
        for (std::size_t i = 0; i < count * DIM; ++i) points[i] = static_cast<std::int32_t>(points[i] * 100) / 100.0;
        break;
    case circle: draw_sphere(random); break;
    case moved:
        if (random.below(2) != 0)
            draw_grid(random, 10, true);
        else
            draw_sphere(random);
        for (std::size_t i = 0; i < count * DIM; ++i) points[i] = up_by(points[i], random.below(4));
        break;
    case line:
        for (std::size_t i = 0; i < count; ++i)
            for (int c = 0; c < DIM; ++c) points[i * DIM + c] = (c + 1) * 0.1 * static_cast<double>(random.below(1000));
        for (std::size_t i = 0; i < count; ++i)
            for (int c = 1; c < DIM; ++c) points[i * DIM + c] = points[i * DIM] * (c + 0.7);
        break;
    case wide: {
        const int exponent = static_cast<int>(random.below(5)) * 200 + 50;
        for (std::size_t i = 0; i < count; ++i) {
            const double scale = power_of_two(static_cast<int>(random.below(exponent)) - exponent / 2);
            for (int c = 0; c < DIM; ++c) points[i * DIM + c] *= scale;
        }
        break;
    }
    default: break;
    }
}

// Calls
// ------------------------------------------------------------------------------------------------------------------

// One call of the library, which returns a status and is given the context and one pointer.
struct Call {
    const void* function;
    const void *first, *second;
};

#ifdef ON_HOST
netmesh_status call_on(std::uint32_t*, const void* function, const void* first, const void* second) {
    return reinterpret_cast<netmesh_status (*)(const void*, const void*)>(const_cast<void*>(function))(first, second);
}
#else
// function(first, second) on the stack that ends at `top`: nothing else is on it.
__attribute__((naked)) netmesh_status call_on(std::uint32_t*, const void*, const void*, const void*) {
    asm volatile(
        "push {r4, lr}\n mov r4, sp\n mov sp, r0\n mov r12, r1\n mov r0, r2\n mov r1, r3\n blx r12\n mov sp, r4\n"
        "pop {r4, pc}");
}
#endif

template <class Function> const void* address(Function* function) { return reinterpret_cast<const void*>(function); }

netmesh_status init(void* into, const void* bytes) {
    return netmesh_init(into, *static_cast<const std::size_t*>(bytes), &context);
}
netmesh_status read_pairs(const void*, const void*) {
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK;) ++i;
    return NETMESH_OK;
}
netmesh_status read_cells(const void*, const void*) {
    for (std::uint64_t i = 0; netmesh_get_cell(context, i, &cell) == NETMESH_OK;) ++i;
    return NETMESH_OK;
}

// Of far apart points a mesh in space is too large for the block, unless they are few.
void prepare(Job job, Kind kind, Random& random, const netmesh_monitor& monitor) {
    const std::size_t meshed_max = DIM == 2 ? points_max : kind == wide ? 6 : 12;
    report.struct_bytes = sizeof report;
    pair.struct_bytes = sizeof pair;
    cell.struct_bytes = sizeof cell;
    persist = netmesh_default_request();  // of the mesh that the context holds
    persist.filter = &netmesh_filter_complete;
    persist.monitor = monitor;
    request = netmesh_default_request();
    request.monitor = monitor;
    switch (job) {
    case delaunay:
        request.mesh.method =
            DIM == 2 && random.below(2) == 0 ? &netmesh_method_delaunay_small : &netmesh_method_delaunay;
        break;
    case alpha: request.filter = random.below(2) == 0 ? &netmesh_filter_alpha_small : &netmesh_filter_alpha; break;
    case rips:
        request.filter = random.below(4) == 0 ? &netmesh_filter_cech : &netmesh_filter_rips;
        if (count > 24) count = 24;
        break;
    default:
        if (count > meshed_max) count = meshed_max;
        if (random.below(4) == 0) {
            request.mesh.method = &netmesh_method_netmesh;
            request.mesh.finish = 1;
        } else {
            request.filter = &netmesh_filter_complete;
            if (random.below(2) != 0)
                request.goal.ratio = 2.25;
            else
                request.mesh.method = &netmesh_method_svr;
        }
        break;
    }
    request.points = {points, count, DIM, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
}

// The calls of a job one after the other; `make` makes each of them.
template <class Make> netmesh_status run_job(Job job, Make&& make) {
    static const std::size_t bytes = sizeof block;
    const netmesh_status begun = make(Call{address(init), block, &bytes});
    if (begun != NETMESH_OK) return begun;
    const void* const first[] = {address(netmesh_mesh), address(netmesh_persist), address(netmesh_mesh),
                                 address(netmesh_persist)};
    netmesh_status done = make(Call{first[job], context, &request});
    if (done == NETMESH_OK && job == certified) done = make(Call{address(netmesh_persist), context, &persist});
    make(Call{job == delaunay ? address(read_cells) : address(read_pairs), nullptr, nullptr});
    make(Call{address(netmesh_get_report), context, &report});
    return done;
}

// The same in slices: a task that does it all.
Job sliced_job;
netmesh_status task(void*) {
    return run_job(sliced_job, [](const Call& call) {
        return reinterpret_cast<netmesh_status (*)(const void*, const void*)>(const_cast<void*>(call.function))(
            call.first, call.second);
    });
}

struct Used {
    std::size_t bytes;
    bool fits;
};

// How deep the stack of `bytes` at the end of the area was.
Used used(std::size_t bytes) {
    std::size_t first = 0;
    while (first < sizeof area / sizeof area[0] && area[first] == paint) ++first;
    const std::size_t deep = sizeof area - first * sizeof area[0];
    return {deep, deep <= bytes};
}
void paint_area() {
    for (std::uint32_t& word : area) word = paint;
}

std::uint32_t faults;
std::uint32_t* const top = area + sizeof area / sizeof area[0];

void fault(const char* what, const char* kind, std::uint64_t number, std::size_t bytes) {
    ++faults;
    Text text;
    text.words("FAULT ").words(what).words(", cloud ").number(number).words(" (").words(kind).words("), bytes ");
    text.number(bytes).words("\n");
    board::write(text.words());
}

// A line that starts with = : job, cloud, points, status, fingerprint of what the context holds.
void tell_result(Job job, std::uint64_t number, netmesh_status done) {
    Text text;
    text.words("= ").words(job_name[job]).words(" ").number(number).words(" ").number(count).words(" ");
    text.number(static_cast<std::uint64_t>(done)).words(" ").hex(done == NETMESH_OK ? report.fingerprint : 0);
    board::write(text.words("\n").words());
}

// The deepest that the calls of a job went on a stack of `given` bytes, as a whole and in slices.
struct Depths {
    std::size_t given, whole, in_slices;
    const char* kind;
    std::uint32_t refused, pauses;
};

// What is drawn of one cloud: its kind, and where its choices begin.
struct Cloud {
    std::uint64_t number;
    Kind kind;
    Random choices;
};

netmesh_status run_on_stack(Job job) {
    return run_job(job, [](const Call& call) { return call_on(top, call.function, call.first, call.second); });
}

// A mesh of points at many sizes may be too large for the board: fewer of them, down to two.
netmesh_status run_until_it_fits(Job job) {
    netmesh_status done = run_on_stack(job);
    while (done == NETMESH_OUT_OF_MEMORY && count > 2) {
        request.points.count = count -= count / 4 + 1;
        done = run_on_stack(job);
    }
    return done;
}

Cloud draw_cloud(Job job, std::uint32_t i) {
    Cloud cloud = {SEED + i, static_cast<Kind>(i % kind_count), {}};
    cloud.choices.state = cloud.number * 0x9E3779B97F4A7C15u + job;
    draw(cloud.kind, cloud.choices);
    Random choices = cloud.choices;
    prepare(job, cloud.kind, choices, {});
    return cloud;
}

#ifdef ON_HOST
void run_clouds(Job job) {
    for (std::uint32_t i = 0; i < CLOUDS; ++i) {
        const Cloud cloud = draw_cloud(job, i);
        tell_result(job, cloud.number, run_until_it_fits(job));
    }
}
#else
// In slices the guard has to be whole, too; the job's own record stands at the stack's end.
void check_in_slices(Job job, const Cloud& cloud, netmesh_status due, Depths& depths) {
    paint_area();
    const std::size_t bytes = depths.given + NETMESH_STACK_BYTES_JOB;
    sliced_job = job;
    if (netmesh_job_init(reinterpret_cast<unsigned char*>(top) - bytes, bytes, task, nullptr, &slices) != NETMESH_OK)
        return;  // ARMv6-M
    Random choices = cloud.choices;
    prepare(job, cloud.kind, choices, {netmesh_poll_pause, slices});
    netmesh_status sliced;
    std::uint64_t pauses = 0, most = UINT64_MAX;
    while ((sliced = netmesh_resume(slices)) == NETMESH_PAUSED) ++pauses;
    depths.pauses += static_cast<std::uint32_t>(pauses);
    if (job == delaunay) netmesh_plan_mesh_polls(&request, &most);
    if (job == alpha) netmesh_plan_polls(&request, &most);
    if (pauses > most) fault("more slices than planned", kind_name[cloud.kind], cloud.number, most);
    const std::size_t taken = netmesh_stack_used(slices);
    if (taken > depths.in_slices) depths.in_slices = taken;
    bool whole = true;
    for (const std::uint32_t* word = area; word < top - bytes / sizeof area[0]; ++word) whole &= *word == paint;
    if (sliced != due || !whole) fault("in slices", kind_name[cloud.kind], cloud.number, taken);
}

void check_cloud(Job job, const Cloud& cloud, bool is_sliced, Depths& depths) {
    paint_area();
    const netmesh_status done = run_until_it_fits(job);
    const Used plain = used(depths.given);
    tell_result(job, cloud.number, done);
    depths.refused += done != NETMESH_OK;
    if (plain.bytes > depths.whole) depths.whole = plain.bytes, depths.kind = kind_name[cloud.kind];
    if (!plain.fits) fault(job_name[job], kind_name[cloud.kind], cloud.number, plain.bytes);
    if (done == NETMESH_INTERNAL || done == NETMESH_OUT_OF_MEMORY)
        fault(netmesh_status_text(done), kind_name[cloud.kind], cloud.number, plain.bytes);
    if (is_sliced) check_in_slices(job, cloud, done, depths);
}

void run_clouds(Job job) {
    Depths depths = {documented[job] * PERCENT / 100 & ~std::size_t{7}, 0, 0, "", 0, 0};
    for (std::uint32_t i = 0; i < CLOUDS; ++i) check_cloud(job, draw_cloud(job, i), i % 4 == 0, depths);
    if (depths.refused * 100 > CLOUDS * refused_percent_max)
        fault("too many refused of", job_name[job], depths.refused, 0);
    Text text;
    text.words(job_name[job]).words(" ").number(DIM).words(": ").number(CLOUDS).words(" clouds, ");
    text.number(depths.refused).words(" refused, deepest ").number(depths.whole).words(" (").words(depths.kind);
    text.words(") of ").number(depths.given).words(", in ").number(depths.pauses).words(" slices ");
    text.number(depths.in_slices).words("\n");
    board::write(text.words());
}
#endif

}  // namespace

#ifdef ON_HOST
void board::write(const char* text) { std::fputs(text, stdout); }
int main() {
    for (int job = 0; job < job_count; ++job) run_clouds(static_cast<Job>(job));
    return 0;
}
#else
int run() {
    for (int job = 0; job < job_count; ++job) run_clouds(static_cast<Job>(job));
    return faults != 0;
}
#endif
