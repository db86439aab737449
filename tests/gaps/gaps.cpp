// The longest stretch of work between two polls of every call that has a monitor, from the call's begin to its end, in
// instructions of x86-64 as g++ makes them. Fails when one is above the limit.
//
//   gaps [short] [where] [D]... [GROUP]...
//   gaps growth                                of jobs on ten times as many points, see growth.cpp
//
// short: few points, a few seconds. where: what was at work in the middle of stretches above the limit, from samples.
// Groups: see `groups` below; without one all run, without a dimension all that are served, up to 4.
#include <sys/time.h>
#include <ucontext.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/session.hpp"
#include "common/wasserstein.hpp"
#include "gaps/counted.hpp"

namespace {

constexpr std::uint64_t limit = 5000000;

// ---- samples of what is at work

struct Sample {
    std::uint64_t at, frames[8];
};
constexpr std::size_t samples_max = 1 << 16;
Sample samples[samples_max];
volatile std::size_t sample_count = 0;
bool sampling = false;

extern "C" char __executable_start, etext;
extern "C" void* __libc_stack_end;

void take_sample(int, siginfo_t*, void* where) {
    const greg_t* const registers = static_cast<ucontext_t*>(where)->uc_mcontext.gregs;
    if (sample_count >= samples_max) return;
    Sample& sample = samples[sample_count];
    sample.at = static_cast<std::uint64_t>(registers[REG_R15]);
    sample.frames[0] = static_cast<std::uint64_t>(registers[REG_RIP]);
    // What looks like a return address further up.
    std::size_t n = 1;
    const auto* stack = reinterpret_cast<const std::uint64_t*>(registers[REG_RSP]);
    for (int i = 0; i < 2000 && n < 8 && stack + i < __libc_stack_end; ++i) {
        const std::uint64_t word = stack[i];
        if (word <= reinterpret_cast<std::uint64_t>(&__executable_start) + 4096 ||
            word >= reinterpret_cast<std::uint64_t>(&etext))
            continue;
        const auto* code = reinterpret_cast<const unsigned char*>(word);
        if (code[-5] == 0xE8) sample.frames[n++] = word;
    }
    for (; n < 8; ++n) sample.frames[n] = 0;
    sample_count = sample_count + 1;
}

void start_sampling() {
    sampling = true;
    struct sigaction action = {};
    action.sa_sigaction = take_sample;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    const itimerval every = {{0, 200}, {0, 200}};
    setitimer(ITIMER_REAL, &every, nullptr);
}

std::string name_of(std::uint64_t address) {
    static std::map<std::uint64_t, std::string> names;
    if (names.empty()) {
        const std::string command = "nm -C --defined-only " + std::string(program_invocation_name);
        FILE* const list = popen(command.c_str(), "r");
        char line[4096];
        while (list != nullptr && std::fgets(line, sizeof line, list) != nullptr) {
            char* rest = nullptr;
            const std::uint64_t at = std::strtoull(line, &rest, 16);
            if (std::strchr("tTwW", rest[1]) != nullptr) names[at] = std::string(rest + 3).substr(0, 90);
        }
        if (list != nullptr) pclose(list);
    }
    const auto after = names.upper_bound(address);
    std::string name = after == names.begin() ? "?" : std::prev(after)->second;
    name.erase(std::remove(name.begin(), name.end(), '\n'), name.end());
    const std::string unnamed = "(anonymous namespace)::";
    for (std::size_t at; (at = name.find(unnamed)) != std::string::npos;) name.erase(at, unnamed.size());
    return name.substr(0, name.find('('));
}

// ---- gaps

struct Place {
    int stage;
    std::uint64_t done;
};
struct Watch {
    std::uint64_t start, last, polls, longest, above;
    Place from, longest_from, longest_to;
    std::map<std::string, std::uint64_t>* culprits;
};
Watch watch;

void note(Place to) {
    const std::uint64_t now = counted(), gap = now - watch.last;
    if (gap > watch.longest) {
        watch.longest = gap;
        watch.longest_from = watch.from;
        watch.longest_to = to;
    }
    if (gap > limit) {
        ++watch.above;
        if (sampling && watch.culprits != nullptr) {
            std::map<std::string, std::uint64_t> seen;
            for (std::size_t i = 0; i < sample_count; ++i) {
                std::string chain;
                for (int k = 0; k < 5 && samples[i].frames[k] != 0; ++k)
                    chain += (k > 0 ? " < " : "") + name_of(samples[i].frames[k]);
                ++seen[chain];
            }
            std::string most = "?";
            std::uint64_t times = 0;
            for (const auto& [chain, count] : seen)
                if (count > times) most = chain, times = count;
            std::uint64_t& worst = (*watch.culprits)[std::to_string(to.stage) + " " + most];
            worst = std::max(worst, gap);
        }
    }
    sample_count = 0;
    watch.from = to;
    watch.last = counted();
}

int poll(void*, const netmesh_progress* progress) {
    ++watch.polls;
    note({progress->stage, progress->done});
    return 0;
}

const char* const stages[] = {"none",     "sort",   "delaunay", "refine",  "certify", "filter",
                              "gradient", "reduce", "check",    "analyse", "begin",   "end"};
std::string text(const Place& place) {
    return stages[place.stage] + (place.stage < NETMESH_STAGE_COUNT ? " " + std::to_string(place.done) : "");
}

int above = 0, failed = 0, measured = 0;

// One call, which has to succeed.
template <class Call> void measure(const char* name, int dim, std::size_t size, Call call) {
    std::map<std::string, std::uint64_t> culprits;
    watch = {};
    watch.culprits = &culprits;
    watch.from = {NETMESH_STAGE_COUNT, 0};
    sample_count = 0;
    watch.start = watch.last = counted();
    const netmesh_status status = call();
    note({NETMESH_STAGE_COUNT + 1, 0});
    watch.culprits = nullptr;
    const std::uint64_t all = watch.last - watch.start;
    std::printf("%-24s D%d %7zu %8llu %9.1f %9.3f  %4llu  %s .. %s%s%s\n", name, dim, size,
                static_cast<unsigned long long>(watch.polls), static_cast<double>(all) / 1e6,
                static_cast<double>(watch.longest) / 1e6, static_cast<unsigned long long>(watch.above),
                text(watch.longest_from).c_str(), text(watch.longest_to).c_str(),
                status == NETMESH_OK ? "" : "  FAILED: ", status == NETMESH_OK ? "" : netmesh_status_text(status));
    std::vector<std::pair<std::uint64_t, std::string>> sorted;
    for (const auto& [chain, worst] : culprits) sorted.emplace_back(worst, chain);
    std::sort(sorted.rbegin(), sorted.rend());
    for (std::size_t i = 0; i < sorted.size() && i < 12; ++i)
        std::printf("    %9.3f  %s\n", static_cast<double>(sorted[i].first) / 1e6, sorted[i].second.c_str());
    std::fflush(stdout);
    ++measured;
    above += watch.longest > limit ? 1 : 0;
    failed += status != NETMESH_OK ? 1 : 0;
}

// ---- the calls

bool is_short = false;
// Points for a job that takes `full` in the long form.
std::size_t some(std::size_t full, std::size_t few) { return is_short ? few : full; }

struct Room : Calls {
    explicit Room(int d, std::size_t block = std::size_t{14} << 30) : Calls(d), dim(d) {
        memory = std::aligned_alloc(16, block);
        if (memory == nullptr || netmesh_init(memory, block, &context) != NETMESH_OK) std::abort();
        request.monitor.poll = poll;
    }
    ~Room() { std::free(memory); }
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    int dim;
    void* memory;
};

double planes(void*, const double* x) { return (x[0] < 0 ? -x[0] : x[0]) + (x[1] < 0 ? -x[1] : x[1]); }
netmesh_function function_of_planes() {
    auto function = netmesh::sized<netmesh_function>();
    function.evaluate = planes;
    function.lipschitz = 1.5;
    function.cut = 1;
    return function;
}

std::size_t points_of(int dim) { return dim == 4 ? some(4000, 300) : some(100000, 3000); }

void delaunay(int dim) {
    const std::size_t n = points_of(dim);
    const inputs::Points points = inputs::repeated(dim, inputs::uniform(dim, n), 2);
    Room room(dim);
    measure("delaunay", dim, n, [&] { return room.delaunay_in_block(points); });
    measure("check", dim, n, [&] { return room.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS); });
    measure("check bounds", dim, n, [&] { return room.check(NETMESH_CHECK_BOUNDS); });
    netmesh_analysis analysis;
    measure("analyse", dim, n,
            [&] { return room.analyse(&analysis, NETMESH_ANALYSE_STRUCTURE | NETMESH_ANALYSE_FATNESS); });
    measure("persist alpha", dim, n, [&] { return room.persist(&netmesh_filter_alpha); });
    measure("bound alpha", dim, n, [&] { return room.bound_bars(); });
    measure("represent alpha", dim, n, [&] { return room.represent(); });
    Arrays arrays(room);
    arrays.domain.clear();
    measure("load delaunay", dim, n, [&] { return arrays.load(room); });
    measure("alpha of points", dim, n, [&] { return room.persist(room.alpha_request(points)); });
    const netmesh::Request either = room.auto_request(points);
    measure("auto", dim, n, [&] { return netmesh_persist(room.context, &either); });
}

void grids(int dim) {
    const int side = dim == 2 ? 300 : dim == 3 ? 45 : 8;
    const inputs::Points points = inputs::grid(dim, is_short ? (dim == 2 ? 50 : dim == 3 ? 12 : 4) : side);
    const std::size_t n = points.size() / static_cast<std::size_t>(dim);
    Room room(dim);
    const netmesh::Request either = room.auto_request(points);
    measure("auto grid", dim, n, [&] { return netmesh_persist(room.context, &either); });
    measure("delaunay grid", dim, n, [&] { return room.delaunay_in_block(points); });
    measure("persist alpha grid", dim, n, [&] { return room.persist(&netmesh_filter_alpha); });
}

void mesh(int dim) {
    const std::size_t n = dim == 4 ? some(1000, 40) : some(100000, 1000);
    const inputs::Points points = inputs::uniform(dim, n);
    Room room(dim);
    measure("mesh", dim, n, [&] { return room.mesh_in_block(points, &netmesh_filter_complete); });
    measure("check mesh", dim, n, [&] { return room.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS); });
    measure("persist basic", dim, n, [&] { return room.persist(&netmesh_filter_basic); });
    measure("bound basic", dim, n, [&] { return room.bound_bars(); });
    measure("persist knn", dim, n, [&] { return room.persist(persist_by(&netmesh_filter_knn, 2)); });
    measure("persist kdistance", dim, n, [&] { return room.persist(persist_by(&netmesh_filter_kdistance, 5)); });
    measure("persist tight", dim, n, [&] { return room.persist(&netmesh_filter_tight); });
    const netmesh_function function = function_of_planes();
    measure("persist function", dim, n, [&] { return room.persist(function, persist_by(&netmesh_filter_function)); });
    measure("bound function", dim, n, [&] { return room.bound_bars(function); });
    measure("persist complete", dim, n, [&] { return room.persist(&netmesh_filter_complete); });
    measure("represent", dim, n, [&] { return room.represent(); });
    measure("bound complete", dim, n, [&] { return room.bound_bars(); });
    const Arrays arrays(room);
    measure("load", dim, n, [&] { return arrays.load(room); });
}

void analyses(int dim) {
    const std::size_t n = dim == 4 ? some(200, 40) : some(100000, 300);
    Room room(dim);
    const inputs::Points points = inputs::uniform(dim, n);
    measure("mesh", dim, n, [&] { return room.mesh_in_block(points); });
    netmesh_analysis analysis;
    measure("analyse size", dim, n, [&] { return room.analyse(&analysis, NETMESH_ANALYSE_SIZE); });
    measure("analyse structure", dim, n, [&] { return room.analyse(&analysis, NETMESH_ANALYSE_STRUCTURE); });
    measure("analyse fatness", dim, n, [&] { return room.analyse(&analysis, NETMESH_ANALYSE_FATNESS); });
    measure("check mesh bounds", dim, n, [&] { return room.check(NETMESH_CHECK_BOUNDS); });
}

void goals(int dim) {
    const std::size_t n = dim == 4 ? some(300, 30) : some(100000, 500);
    const inputs::Points points = inputs::uniform(dim, n);
    Room room(dim);
    room.request.goal.ratio = 2.5;
    measure("mesh by ratio", dim, n, [&] { return room.mesh_in_block(points, &netmesh_filter_complete); });
    measure("check by ratio", dim, n, [&] { return room.check(NETMESH_CHECK_QUALITY); });
    measure("persist by ratio", dim, n, [&] { return room.persist(&netmesh_filter_complete); });
    measure("bound by ratio", dim, n, [&] { return room.bound_bars(); });
    measure("represent by ratio", dim, n, [&] { return room.represent(); });
    room.request.goal.focus_ratio = 2.2;
    room.request.goal.focus_from = 0.01;
    room.request.goal.focus_to = 0.1;
    const std::size_t fewer = n / 10;
    const inputs::Points few = inputs::uniform(dim, fewer);
    measure("mesh focused", dim, fewer, [&] { return room.mesh_in_block(few, &netmesh_filter_complete); });
}

void cages(int dim) {
    const std::size_t n = dim == 4 ? some(400, 30) : some(100000, 600);
    const inputs::Points points = inputs::close_pairs(dim, n / 2, 1e-3, 2);
    {
        Room room(dim);
        room.request.mesh.method = &netmesh_method_netmesh;
        measure("hierarchy", dim, n, [&] { return room.mesh_in_block(points); });
        measure("check hierarchy", dim, n, [&] { return room.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS); });
        netmesh_analysis analysis;
        measure("analyse hierarchy", dim, n, [&] { return room.analyse(&analysis, NETMESH_ANALYSE_SIZE); });
        const Arrays arrays(room);
        measure("load hierarchy", dim, n, [&] { return arrays.load(room); });
        measure("load_cages", dim, n, [&] { return arrays.load_cages(room); });
        room.request.mesh.finish = 1;
        measure("hierarchy finished", dim, n, [&] { return room.mesh_in_block(points); });
    }
    const std::size_t fewer = dim == 4 ? some(20, 6) : some(dim == 2 ? 20000 : 2000, dim == 2 ? 100 : 16);
    const inputs::Points far = inputs::close_pairs(dim, fewer / 2, 1e-3, 2);
    Room room(dim);
    room.request.mesh.method = &netmesh_method_thesis;
    room.request.mesh.tau = 7;
    measure("thesis cages", dim, fewer, [&] { return room.mesh_in_block(far); });
    measure("check thesis cages", dim, fewer, [&] { return room.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS); });
}

void refine(int dim) {
    const std::size_t n = dim == 4 ? some(100, 10) : some(20000, 200);
    const inputs::Points points = inputs::uniform(dim, n);
    {
        Room room(dim);
        room.request.mesh.method = &netmesh_method_refine;
        measure("voronoi refine", dim, n, [&] { return room.mesh_in_block(points); });
        measure("check refine", dim, n, [&] { return room.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS); });
    }
    const std::size_t few = n / 5;
    const inputs::Points fewer = inputs::uniform(dim, few);
    {
        Room room(dim);
        room.request.mesh.sizes.eps = 0.5;
        measure("sizes", dim, few, [&] { return room.mesh_in_block(fewer); });
        measure("check sizes", dim, few, [&] { return room.check(NETMESH_CHECK_QUALITY); });
    }
    Room room(dim);
    room.request.mesh.audit = NETMESH_AUDIT_LOCATION;
    measure("audit location", dim, few, [&] { return room.mesh_in_block(fewer); });
    room.request.mesh.audit = NETMESH_AUDIT_QUALITY;
    const std::size_t fewest = std::max<std::size_t>(few / 4, 12);
    const inputs::Points small = inputs::uniform(dim, fewest);
    measure("audit quality", dim, fewest, [&] { return room.mesh_in_block(small); });
    room.request.mesh.method = &netmesh_method_netmesh;
    room.request.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
    measure("audit hierarchy", dim, fewest, [&] { return room.mesh_in_block(small); });
}

void fit(int dim) {
    const std::size_t n = dim == 4 ? some(200, 20) : some(20000, 200);
    const inputs::Points points = inputs::uniform(dim, n);
    const std::size_t each = dim == 2 ? 4000 : dim == 3 ? 24000 : 160000;
    Room room(dim, (n * each + (std::size_t{1} << 18)) / 16 * 16);
    measure("fit", dim, n, [&] { return room.fit(points, true); });
    netmesh::Request request = room.fit_request(points);
    request.goal.longer_than = 1.5;
    request.goal.ratio = 4;
    request.bounds = &netmesh_bounds;
    measure("fit decided", dim, n, [&] { return room.persist(request); });
    const netmesh_function function = function_of_planes();
    measure("fit by error", dim, n, [&] { return room.persist(function, room.fit_request(points)); });
}

void scales(int dim) {
    const std::size_t n = dim == 4 ? some(60, 8) : some(20000, 100);
    inputs::Points points = inputs::uniform(dim, n);
    for (std::size_t i = 0; i < points.size() / 2; ++i) points[i] *= 0x1p-30;
    Room room(dim);
    netmesh::Request request = room.scales_request(points);
    request.goal = {};
    request.goal.ratio = 3;
    request.bounds = &netmesh_bounds;
    request.cycles = &netmesh_cycles;
    measure("scales", dim, n, [&] { return room.persist(request); });
}

void vineyard(int dim) {
    const std::size_t n = dim == 4 ? some(20, 4) : some(dim == 2 ? 2000 : 300, dim == 2 ? 60 : 12);
    Room room(dim);
    const inputs::Points points = inputs::uniform(dim, n);
    measure("mesh", dim, n, [&] { return room.mesh_in_block(points, &netmesh_filter_complete); });
    measure("vineyard", dim, n, [&] { return room.vineyard(&netmesh_filter_knn, 1, 2); });
}

void points(int dim) {
    const auto one = [&](const char* name, const netmesh_filter* filter, std::size_t n, std::uint32_t degree,
                         bool cycles = false) {
        const inputs::Points all = inputs::uniform(dim, n);
        Room room(dim);
        netmesh::Request request = room.points_request(all, filter, 2, degree);
        request.cycles = cycles ? &netmesh_cycles : nullptr;
        measure(name, dim, n, [&] { return room.persist(request); });
    };
    one("rips", &netmesh_filter_rips, some(4000, 200), 0);
    one("rips, degree 1", &netmesh_filter_rips, some(800, 60), 1);
    one("rips, degree 2", &netmesh_filter_rips, some(150, 24), 2);
    one("rips with cycles", &netmesh_filter_rips, some(250, 40), 1, true);
    one("cech", &netmesh_filter_cech, some(250, 40), 1);
    one("cech with cycles", &netmesh_filter_cech, some(100, 20), 2, true);
    one("barycentric cech", &netmesh_filter_barycentric_cech, some(60, 12), 1);
    one("barycentric rips", &netmesh_filter_barycentric_rips, some(60, 12), 1);
    const std::size_t n = some(40, 10);
    const inputs::Points all = inputs::uniform(dim, n);
    Room room(dim);
    const netmesh::Request request = room.nested_request(all, &netmesh_filter_barycentric_cech, 3);
    measure("vineyard of points", dim, n, [&] { return room.persist(request); });
}

// Cubes of a grid cut into simplices of a path, with all their faces, at values that have no order in space.
struct Complex {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> entries;

    Complex(int dim, std::uint32_t side) {
        std::uint32_t corners = 1;
        for (int k = 0; k < dim; ++k) corners *= side;
        // Faces of the Freudenthal triangulation at v: chains of sets of axes, none empty.
        std::vector<std::vector<std::uint32_t>> chains = {{}};
        for (std::size_t i = 0; i < chains.size(); ++i)
            for (std::uint32_t set = 1; set < 1u << dim; ++set) {
                const std::uint32_t last = chains[i].empty() ? 0 : chains[i].back();
                if ((set & last) != last || set == last) continue;
                std::vector<std::uint32_t> longer = chains[i];
                longer.push_back(set);
                chains.push_back(longer);
            }
        std::uint64_t random = 7;
        std::vector<double> height(corners);
        for (double& h : height) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            h = static_cast<double>(random >> 40);
        }
        for (std::uint32_t v = 0; v < corners; ++v)
            for (const auto& chain : chains) {
                std::vector<std::uint32_t> face = {v};
                bool inside = true;
                for (const std::uint32_t set : chain) {
                    std::uint32_t w = v, step = 1;
                    for (int k = 0; k < dim; ++k, step *= side)
                        if ((set >> k & 1) != 0) {
                            inside = inside && v / step % side + 1 < side;
                            w += step;
                        }
                    face.push_back(w);
                }
                if (!inside) continue;
                double entry = 0;
                for (const std::uint32_t w : face) entry = std::max(entry, height[w]);
                vertices.insert(vertices.end(), face.begin(), face.end());
                starts.push_back(vertices.size());
                entries.push_back(entry);
            }
    }
    netmesh_simplices simplices() const {
        auto s = netmesh::sized<netmesh_simplices>();
        s.vertices = vertices.data();
        s.starts = starts.data();
        s.entries = entries.data();
        s.simplex_count = entries.size();
        s.vertex_count = vertices.size();
        return s;
    }
};

void homology(int dim) {
    const std::uint32_t side = dim == 2 ? some(300, 30) : dim == 3 ? some(32, 8) : some(8, 3);
    const Complex complex(dim, side);
    Room room(dim);
    const netmesh_simplices all = complex.simplices();
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &all;
    measure("homology", dim, complex.entries.size(), [&] { return room.persist(request); });
    request.cycles = &netmesh_cycles;
    measure("homology with cycles", dim, complex.entries.size(), [&] { return room.persist(request); });
    const Complex few(dim, dim == 2 ? some(50, 8) : dim == 3 ? some(9, 4) : 3);
    const auto vines = [&](const char* name, bool by_vertex, std::uint64_t steps) {
        std::vector<double> values;
        for (std::uint64_t step = 0; step < steps; ++step)
            for (std::size_t i = 0; i < few.entries.size(); ++i) {
                const std::uint64_t size = few.starts[i + 1] - few.starts[i];
                const std::uint64_t moved = (few.vertices[few.starts[i]] * 7919 + 104729 * step * i) % 100003;
                if (!by_vertex || size == 1) values.push_back(static_cast<double>(moved + 100003 * size));
            }
        netmesh_simplices simplices = few.simplices();
        simplices.entries = values.data();
        simplices.step_count = steps;
        simplices.by_vertex = by_vertex ? 1 : 0;
        netmesh::Request vineyard(&netmesh_filter_simplices);
        vineyard.simplices = &simplices;
        measure(name, dim, few.entries.size(), [&] { return room.vineyard(vineyard); });
    };
    vines("vineyard of values", false, 2);
    vines("vineyard by vertex", true, 2);
}

void distances(int dim) {
    if (dim != 2) return;
    const std::size_t n = some(20000, 400);
    std::vector<netmesh_pair> diagrams[2];
    for (std::size_t k = 0; k < 2; ++k) {
        const inputs::Points places = inputs::uniform(2, n, 11 + k);
        for (std::size_t i = 0; i < n; ++i) {
            const double x = places[2 * i], y = places[2 * i + 1];
            diagrams[k].push_back(bar(1, 2 + std::min(x, y), 2 + std::max(x, y)));
        }
    }
    const auto measure_call = [n](const char* name, auto request, auto call, auto distance, std::size_t bytes) {
        request.monitor.poll = poll;
        const Scratch scratch(bytes);
        scratch.lend(&request);
        measure(name, 2, n, [&] { return call(&request, &distance, nullptr); });
    };
    for (const netmesh_scale scale : {NETMESH_SCALE_PLAIN, NETMESH_SCALE_LOG}) {
        const netmesh_bottleneck_request request = bottleneck_request(diagrams[0], diagrams[1], scale);
        measure_call(scale == NETMESH_SCALE_PLAIN ? "bottleneck" : "bottleneck, log", request, netmesh_bottleneck,
                     netmesh::sized<netmesh_distance>(), netmesh_bottleneck_bytes(&request));
    }
    const netmesh_wasserstein_request request = wasserstein_request(diagrams[0], diagrams[1], 1, 0.01);
    measure_call("wasserstein", request, netmesh_wasserstein, netmesh::sized<netmesh_wasserstein_distance>(),
                 netmesh_wasserstein_bytes(&request));
}

struct Group {
    const char* name;
    void (*run)(int dim);
};
const Group groups[] = {{"delaunay", delaunay},  {"grids", grids},       {"mesh", mesh},     {"analyses", analyses},
                        {"goals", goals},        {"cages", cages},       {"refine", refine}, {"fit", fit},
                        {"scales", scales},      {"vineyard", vineyard}, {"points", points}, {"homology", homology},
                        {"distances", distances}};

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "growth") == 0) return check_growth();
    std::vector<int> wanted;
    std::vector<std::string> names;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "short") {
            is_short = true;
        } else if (word == "where") {
            start_sampling();
        } else if (word.size() == 1 && word[0] >= '2' && word[0] <= '4') {
            wanted.push_back(word[0] - '0');
        } else {
            names.push_back(word);
        }
    }
    std::printf("%-24s %2s %7s %8s %9s %9s  %s\n", "call", "D", "points", "polls", "millions", "longest",
                "above; from .. to");
    for (const int dim : dimensions(2, 4)) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), dim) == wanted.end()) continue;
        for (const Group& group : groups)
            if (names.empty() || std::find(names.begin(), names.end(), group.name) != names.end()) group.run(dim);
    }
    std::printf("%d calls, %d above %.0f million instructions, %d failed\n", measured, above,
                static_cast<double>(limit) / 1e6, failed);
    std::printf("not measured: D = 5 and 6; measure_cells, measure_voronoi, measure_balls, weighted_cells,\n"
                "well_paced_order and pace, which have no monitor; what the caller's own functions take\n");
    std::fflush(stdout);
    std::_Exit(measured == 0 || above + failed > 0 ? 1 : 0);
}
