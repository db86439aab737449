#include "determinism/slice.hpp"

#include <cstdint>

#include "determinism/text.hpp"
#include "netmesh.hpp"

// valgrind takes the memory below a job's stack pointer for gone, also when the job has ended.
#if defined(__linux__) && defined(__x86_64__) && __has_include(<valgrind/memcheck.h>)
#include <valgrind/memcheck.h>
#else
#define VALGRIND_MAKE_MEM_UNDEFINED(memory, bytes) static_cast<void>(memory)
#endif

namespace slice {
namespace {

constexpr int points_max = 48;

struct Input {
    int dim, count;
    int meshed;  // the first so many points are meshed
    double x[points_max * NETMESH_DIM_MAX];
};

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u) {}
    std::uint64_t bits() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        const std::uint64_t high = state_ >> 32;
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return high << 32 | state_ >> 32;
    }
    double uniform() { return static_cast<double>(static_cast<std::int64_t>(bits() >> 11)) * 0x1p-53; }
    int below(int n) { return static_cast<int>((bits() >> 32) % static_cast<std::uint64_t>(n)); }

private:
    std::uint64_t state_;
};

// How many points an input takes; meshes of few points are already large in high dimensions.
constexpr int random_points[] = {0, 0, 30, 14, 9, 8, 9};

double power_of_half(int k) {
    double p = 1;
    for (; k > 0; --k) p *= 0.5;
    return p;
}

void add(Input* in, const double* p) {
    if (in->count == points_max) return;
    for (int k = 0; k < in->dim; ++k) in->x[in->count * in->dim + k] = p[k];
    ++in->count;
}

void uniform(Input* in, std::uint64_t seed, int count) {
    Random random(seed);
    for (int i = 0; i < count * in->dim; ++i) in->x[i] = random.uniform() - 0.25;
    in->count = count;
}

// Integer points of [0, side)^D, scaled, every coordinate moved by up to `jitter`: all of them where count allows,
// otherwise `count` at random, the unit simplex first.
void grid(Input* in, int side, int count, double scale, double jitter) {
    Random random(77);
    const auto place = [&](const int* digit) {
        double p[NETMESH_DIM_MAX];
        for (int k = 0; k < in->dim; ++k) p[k] = (digit[k] + jitter * random.uniform()) * scale;
        add(in, p);
    };
    int all = 1, digit[NETMESH_DIM_MAX] = {};
    for (int k = 0; k < in->dim; ++k) all *= side;
    if (all <= count) {
        for (int i = 0; i < all; ++i) {
            place(digit);
            for (int k = 0; k < in->dim && ++digit[k] == side; ++k) digit[k] = 0;
        }
        return;
    }
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < in->dim; ++k) digit[k] = i <= in->dim ? k + 1 == i : random.below(side);
        place(digit);
    }
}

// Plus and minus the unit vectors, times `radius`; with the centre when asked.
void cross(Input* in, double radius, bool centre) {
    double p[NETMESH_DIM_MAX] = {};
    if (centre) add(in, p);
    for (int k = 0; k < in->dim; ++k)
        for (int sign = -1; sign <= 1; sign += 2) {
            p[k] = sign * radius;
            add(in, p);
            p[k] = 0;
        }
}

// Integer points at squared distance 2 from the origin, in shuffled order, the first `count`.
void roots(Input* in, int count) {
    for (int i = 0; i < in->dim; ++i)
        for (int j = i + 1; j < in->dim; ++j)
            for (int s = 0; s < 4; ++s) {
                double p[NETMESH_DIM_MAX] = {};
                p[i] = s & 1 ? 1 : -1;
                p[j] = s & 2 ? 1 : -1;
                add(in, p);
            }
    Random random(5);
    for (int i = in->count; i > 1; --i) {
        const int j = random.below(i);
        for (int k = 0; k < in->dim; ++k) {
            const double t = in->x[(i - 1) * in->dim + k];
            in->x[(i - 1) * in->dim + k] = in->x[j * in->dim + k];
            in->x[j * in->dim + k] = t;
        }
    }
    if (in->count > count) in->count = count;
}

// Points at distances of about 1, 2^-step, 2^-2step ... from a corner.
void zoom(Input* in, int count, int step, std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        double p[NETMESH_DIM_MAX];
        for (int k = 0; k < in->dim; ++k) p[k] = (2 * random.uniform() - 1) * power_of_half(i * step);
        add(in, p);
    }
}

// Every point `copies` times, in a mixed order.
void repeat(Input* in, int copies) {
    const int distinct = in->count;
    for (int c = 1; c < copies; ++c)
        for (int i = 0; i < distinct; ++i) add(in, in->x + (i * 7 + c) % distinct * in->dim);
}

// Points of one line, ever farther from each other.
void line(Input* in, int count) {
    for (int i = 0; i < count; ++i) {
        double p[NETMESH_DIM_MAX];
        for (int k = 0; k < in->dim; ++k) p[k] = i * i * 0.25 * (k + 1);
        add(in, p);
    }
}

const char* make(Input* in, int dim, int which) {
    in->dim = dim;
    in->count = 0;
    in->meshed = dim < 5 ? points_max : dim < 6 ? 7 : 6;
    const bool low = dim < 4;
    const int n = random_points[dim], few = dim + 2;
    switch (which) {
    case 0: return uniform(in, 1, n), "random";
    case 1: return uniform(in, 2, n), "random";
    case 2: return uniform(in, 3, dim + 1), "simplex";
    case 3: return uniform(in, 4, few), "random-few";
    case 4: return uniform(in, 5, 1), "single";
    case 5: return grid(in, 3, low ? 27 : n, 1, 0), "grid";
    case 6: return grid(in, 2, low ? 8 : n, 0.1, 0), "grid-tenths";
    case 7: return grid(in, 2, 8, 1, low ? 0x1p-44 : 0x1p-5), in->meshed = low ? 8 : 5, "grid-jittered";
    case 8: return grid(in, 2, dim, 3, 0), "flat";
    case 9: return cross(in, 1, false), "cross";
    case 10: return cross(in, 0.3, true), "cross-centre";
    case 11: return roots(in, low ? 12 : n), "roots";
    case 12: return grid(in, 2, low ? 8 : few + 1, 0x1p-30, 0), "cube";
    case 13: return zoom(in, few, dim == 2 ? 8 : dim == 3 ? 2 : 1, 6), in->meshed = low ? few : 4, "spread";
    case 14: return zoom(in, few, dim == 2 ? 24 : 40, 7), in->meshed = dim == 2 ? few : 2, "spread-far";
    case 15: return zoom(in, dim + 3, 200, 8), "spread-extreme";
    case 16: return uniform(in, 9, few), repeat(in, 3), "repeated";
    case 17: return cross(in, 1, false), repeat(in, 2), "repeated-cross";
    case 18: return uniform(in, 10, 1), repeat(in, 4), "one-place";
    default: return line(in, low ? few : 2), "line";
    }
}

void add_hash(Text* line, const char* job, netmesh_status status, std::uint64_t hash) {
    line->words(" ").words(job).words(" ");
    if (status == NETMESH_OK) {
        line->hex(hash);
    } else {
        line->words("status ").number(static_cast<unsigned>(status));
    }
}

void add_result(Text* line, const char* job, netmesh_status status, const netmesh_context* context) {
    auto report = netmesh::sized<netmesh_report>();
    if (status == NETMESH_OK) status = netmesh_get_report(context, &report);
    add_hash(line, job, status, report.fingerprint);
}

class Hash {
public:
    void add(std::uint64_t x) { value_ = (value_ ^ x) * 0x100000001B3u + 1; }
    void add(double x) {
        std::uint64_t bits;
        __builtin_memcpy(&bits, &x, sizeof bits);
        add(bits);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 1;
};

// Simplices of the cycles and bounds of the bars, as far as there are any.
std::uint64_t hash_of_bars(const netmesh_context* context) {
    Hash hash;
    std::uint64_t count;
    auto simplex = netmesh::sized<netmesh_simplex>();
    auto bounds = netmesh::sized<netmesh_bar_bounds>();
    auto pair = netmesh::sized<netmesh_pair>();
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i) {
        if (netmesh_get_bar_bounds(context, i, &bounds) == NETMESH_OK) {
            hash.add(bounds.birth_low);
            hash.add(bounds.death_high);
            hash.add(bounds.certain_after);
        }
        if (netmesh_get_cycle(context, i, &count) != NETMESH_OK) continue;
        for (std::uint64_t n = 0; n < count; ++n)
            if (netmesh_get_cycle_simplex(context, i, n, &simplex) == NETMESH_OK)
                for (std::uint32_t k = 0; k <= pair.degree; ++k) hash.add(std::uint64_t{simplex.vertices[k]});
    }
    return hash.value();
}

// Pauses the job that it is given, if any.
double slope(void* job, const double* x) {
    netmesh_pause(static_cast<netmesh_job*>(job));
    return (x[0] < 0 ? -x[0] : x[0]) * 0.5 + (x[1] < 0 ? -x[1] : x[1]) * 0.25;
}

// The jobs in one block. Each that takes points begins with a fresh context.
class Context {
public:
    Context(void* block, std::size_t bytes, const Input& in) : in_(in), block_(block), bytes_(bytes) {
        rules.method = &netmesh_method_svr;
    }

    // Of the first `count` points of the input.
    netmesh::Request request(const netmesh_filter* filter, int count) const {
        netmesh::Request request(filter);
        request.set_points(static_cast<std::uint32_t>(in_.dim),
                           netmesh::Span<const double>(in_.x, static_cast<std::size_t>(count * in_.dim)));
        return request;
    }
    netmesh::Request request(const netmesh_filter* filter) const { return request(filter, in_.count); }
    // Of a mesh by the rules. filter: what it is for, null: itself.
    netmesh::Request mesh_request(const netmesh_filter* filter, int count) const {
        netmesh::Request mesh = request(filter, count);
        mesh.mesh = rules;
        return mesh;
    }

    netmesh_status persist_anew(const netmesh::Request& request) {
        const netmesh_status status = start();
        return status == NETMESH_OK ? netmesh_persist(handle, &request) : status;
    }
    netmesh_status mesh_anew(const netmesh::Request& request) {
        const netmesh_status status = start();
        return status == NETMESH_OK ? netmesh_mesh(handle, &request) : status;
    }
    // On what is there.
    netmesh_status persist(const netmesh_filter* filter, bool keep_zero_pairs, std::uint32_t k = 0) {
        netmesh::Request request(filter);
        request.k = k;
        request.keep_zero_pairs = keep_zero_pairs ? 1 : 0;
        return netmesh_persist(handle, &request);
    }
    void* block() const { return block_; }
    std::size_t block_bytes() const { return bytes_; }

    netmesh_context* handle = nullptr;
    netmesh_mesh_rules rules = {};

private:
    netmesh_status start() { return netmesh_init(block_, bytes_, &handle); }

    const Input& in_;
    void* block_;
    std::size_t bytes_;
};

// The other calls, on few points in each dimension: a line a kind of result.
class Calls {
public:
    Calls(Input* in, void* block, std::size_t bytes, void (*print)(const char*))
        : in_(*in), context_(block, bytes, *in), print_(print) {}
    int run() {
        in_.count = 0;
        uniform(&in_, 11, in_.dim < 5 ? in_.dim + 2 : 3);
        on_mesh();
        of_mesh();
        uniform(&in_, 12, 8);
        on_points();
        in_.count = 6;
        over_k();
        if (in_.dim > 2) return 4;
        without_points();
        return 5;
    }

private:
    Text begin() const { return Text().words("D").number(static_cast<unsigned>(in_.dim)).words(" calls"); }
    netmesh::Request mesh_request(const netmesh_filter* filter = nullptr) const {
        return context_.mesh_request(filter, in_.count);
    }

    void on_mesh() {
        Text line = begin();
        netmesh_status status = context_.mesh_anew(mesh_request(&netmesh_filter_complete));
        const auto persist = [&](const char* job, const netmesh_filter* filter, std::uint32_t k) {
            if (status == NETMESH_OK) status = context_.persist(filter, false, k);
            add_result(&line, job, status, context_.handle);
        };
        persist("tight", &netmesh_filter_tight, 0);
        persist("kdistance", &netmesh_filter_kdistance, 2);
        persist("knn", &netmesh_filter_knn, 2);
        netmesh::Request more(&netmesh_filter_knn);  // of the diagram that is there
        more.k = 2;
        more.bounds = &netmesh_bounds;
        more.cycles = &netmesh_cycles;
        if (status == NETMESH_OK) status = netmesh_persist(context_.handle, &more);
        add_hash(&line, "bars", status, hash_of_bars(context_.handle));
        if (status == NETMESH_OK) status = function();
        add_result(&line, "function", status, context_.handle);
        netmesh::Request vineyard(&netmesh_filter_knn);
        vineyard.k_last = 2;
        vineyard.vines = &netmesh_vines;
        if (status == NETMESH_OK) status = netmesh_persist(context_.handle, &vineyard);
        add_result(&line, "vineyard", status, context_.handle);
        print_(line.words());
    }
    netmesh_status function() {
        auto of = netmesh::sized<netmesh_function>();
        of.evaluate = slope;
        of.lipschitz = 0.75;
        of.cut = 2;
        netmesh::Request request(&netmesh_filter_function);
        request.function = &of;
        return in_slices(&of.user, &request);
    }
    // Paused at every value of the function, where there are jobs on stacks of their own.
    netmesh_status in_slices(void** user, const netmesh_request* request) {
        alignas(16) static unsigned char stack[NETMESH_STACK_BYTES(NETMESH_DIM_MAX) + 4096];
        struct Work {
            netmesh_context* context;
            const netmesh_request* request;
        } work = {context_.handle, request};
        const auto task = [](void* of) {
            const Work& w = *static_cast<const Work*>(of);
            return netmesh_persist(w.context, w.request);
        };
        VALGRIND_MAKE_MEM_UNDEFINED(stack, sizeof stack);
        netmesh_job* job = nullptr;
        const netmesh_status made = netmesh_job_init(stack, sizeof stack, task, &work, &job);
        if (made == NETMESH_NOT_BUILT) return task(&work);
        *user = job;
        int pauses = 0;
        netmesh_status status;
        while ((status = netmesh_resume(job)) == NETMESH_PAUSED) ++pauses;
        return status == NETMESH_OK && pauses < in_.count ? NETMESH_INTERNAL : status;
    }

    // With cages and without; what is measured of them.
    void of_mesh() {
        Text line = begin();
        const netmesh::Request promised = mesh_request();
        netmesh_status status = context_.mesh_anew(promised);
        auto request = netmesh::sized<netmesh_analyse_request>();
        request.tolerance = 30;
        request.promised = &promised;
        auto analysis = netmesh::sized<netmesh_analysis>();
        if (status == NETMESH_OK) status = netmesh_analyse(context_.handle, &request, &analysis);
        add_hash(&line, "analysis", status, analysis.fingerprint);
        std::uint32_t order[points_max] = {};
        double theta[points_max] = {};
        if (status == NETMESH_OK) status = netmesh_well_paced_order(context_.handle, order, theta);
        Hash hash;
        for (int i = 0; i < in_.count; ++i) {
            hash.add(std::uint64_t{order[i]});
            hash.add(theta[i]);
        }
        add_hash(&line, "order", status, hash.value());
        in_.count = 0;
        zoom(&in_, in_.dim < 5 ? 5 : 3, 6, 13);
        context_.rules.method = &netmesh_method_netmesh;
        add_result(&line, "cages", context_.mesh_anew(mesh_request()), context_.handle);
        context_.rules.finish = 1;
        if (in_.dim < 4) add_result(&line, "finished", context_.mesh_anew(mesh_request()), context_.handle);
        print_(line.words());
    }

    void on_points() {
        Text line = begin();
        // Cycles where there is no k.
        const auto persist = [&](const char* job, const netmesh_filter* filter, std::uint32_t k) {
            netmesh::Request request = context_.request(filter);
            request.k = k;
            if (k == 0) request.cycles = &netmesh_cycles;
            const netmesh_status status = context_.persist_anew(request);
            add_result(&line, job, status, context_.handle);
            if (k == 0) add_hash(&line, "cycles", status, hash_of_bars(context_.handle));
        };
        persist("rips", &netmesh_filter_rips, 0);
        persist("cech", &netmesh_filter_cech, 0);
        persist("barycentric-cech", &netmesh_filter_barycentric_cech, 2);
        persist("barycentric-rips", &netmesh_filter_barycentric_rips, 2);
        print_(line.words());
    }

    void over_k() {
        Text line = begin();
        const auto vineyard = [&](const char* job, const netmesh_filter* filter) {
            netmesh::Request request = context_.request(filter);
            request.k_last = 3;
            request.vines = &netmesh_vines;
            const netmesh_status status = context_.persist_anew(request);
            add_result(&line, job, status, context_.handle);
        };
        vineyard("nested-cech", &netmesh_filter_barycentric_cech);
        vineyard("nested-rips", &netmesh_filter_barycentric_rips);
        print_(line.words());
    }

    void without_points() {
        Text line = begin();
        scales(&line);
        homology(&line);
        distance(&line);
        print_(line.words());
    }
    void scales(Text* line) {
        in_.count = 0;
        zoom(&in_, 2, 30, 14);
        const netmesh_status status = context_.persist_anew(context_.request(&netmesh_filter_scales));
        add_result(line, "scales", status, context_.handle);
    }
    // A complex given by its simplices: two triangles with a common edge, one of them filled.
    void homology(Text* line) {
        static const std::uint32_t vertices[] = {0, 1, 2, 3, 0, 1, 1, 2, 2, 0, 3, 1, 2, 3, 0, 1, 2};
        static const std::uint64_t starts[] = {0, 1, 2, 3, 4, 6, 8, 10, 12, 14, 17};
        static const double entries[] = {0, 0.5, 0.25, 0, 1, 2, 1.5, 2, 3, 2.5};
        auto simplices = netmesh::sized<netmesh_simplices>();
        simplices.vertices = vertices;
        simplices.starts = starts;
        simplices.entries = entries;
        simplices.simplex_count = 10;
        netmesh::Request request(&netmesh_filter_simplices);
        request.simplices = &simplices;
        request.max_degree = 2;
        request.cycles = &netmesh_cycles;
        const netmesh_status status = context_.persist_anew(request);
        add_result(line, "homology", status, context_.handle);
        add_hash(line, "cycles", status, hash_of_bars(context_.handle));
    }
    // Of two diagrams.
    void distance(Text* line) {
        constexpr std::uint32_t bytes = sizeof(netmesh_pair);
        static const netmesh_pair a[] = {{bytes, 0, 0.25, 1}, {bytes, 0, 0.5, 2.25}, {bytes, 1, 0.125, 0.75}};
        static const netmesh_pair b[] = {{bytes, 0, 0.3, 1.1}, {bytes, 1, 0.1, 0.7}, {bytes, 1, 0.6, 0.65}};
        netmesh::Bottleneck request;
        request.pairs_a = a;
        request.pairs_b = b;
        request.count_a = request.count_b = 3;
        request.scale = NETMESH_SCALE_LOG;
        request.scratch = context_.block();
        request.scratch_bytes = context_.block_bytes();
        auto distance = netmesh::sized<netmesh_distance>();
        const netmesh_status status = netmesh_bottleneck(&request, &distance, nullptr);
        Hash hash;
        hash.add(distance.value);
        add_hash(line, "distance", status, hash.value());
        netmesh::Wasserstein transport;
        transport.pairs_a = a;
        transport.pairs_b = b;
        transport.count_a = transport.count_b = 3;
        transport.order = 2;
        transport.scratch = context_.block();
        transport.scratch_bytes = context_.block_bytes();
        auto bounds = netmesh::sized<netmesh_wasserstein_distance>();
        const netmesh_status moved = netmesh_wasserstein(&transport, &bounds, nullptr);
        Hash hash_of_bounds;
        hash_of_bounds.add(bounds.lower);
        hash_of_bounds.add(bounds.value);
        add_hash(line, "transport", moved, hash_of_bounds.value());
    }

    Input& in_;
    Context context_;
    void (*print_)(const char*);
};

// One input: its Delaunay triangulation and alpha diagram, a mesh of it and the mesh's diagram.
Text jobs_on(Input* in, int which, Context* context) {
    Text out;
    out.words("D").number(static_cast<unsigned>(in->dim)).words(" ").number(static_cast<unsigned>(which)).words(" ");
    out.words(make(in, in->dim, which));
    netmesh::Request delaunay = context->request(nullptr);
    delaunay.mesh.method = &netmesh_method_delaunay;
    netmesh_status status = context->mesh_anew(delaunay);
    add_result(&out, "delaunay", status, context->handle);
    if (status == NETMESH_OK) status = context->persist(&netmesh_filter_alpha, true);
    add_result(&out, "alpha", status, context->handle);
    const int meshed = in->meshed < in->count ? in->meshed : in->count;
    status = context->mesh_anew(context->mesh_request(&netmesh_filter_complete, meshed));
    add_result(&out, "mesh", status, context->handle);
    if (status == NETMESH_OK) status = context->persist(&netmesh_filter_complete, true);
    add_result(&out, "persist", status, context->handle);
    return out;
}

}  // namespace

int run(void* block, std::size_t bytes, int first, int last, void (*print)(const char* line)) {
    static Input in;
    int lines = 0;
    for (int dim = first; dim <= last; ++dim) {
        in.dim = dim;
        Context context(block, bytes, in);
        for (int which = 0; which < inputs_per_dimension; ++which, ++lines)
            print(jobs_on(&in, which, &context).words());
        lines += Calls(&in, block, bytes, print).run();
    }
    return lines;
}

netmesh_status demo(int dim, void* block, std::size_t bytes, netmesh_report* report, void (*print)(const char* line)) {
    static double x[1000];
    const int n = dim == 2 ? 500 : 200;
    Random random(static_cast<std::uint64_t>(dim));
    for (int i = 0; i < n * dim; ++i) x[i] = random.uniform();
    netmesh::Request request(&netmesh_filter_complete);
    request.set_points(static_cast<std::uint32_t>(dim),
                       netmesh::Span<const double>(x, static_cast<std::size_t>(n * dim)));
    request.mesh.method = &netmesh_method_svr;
    request.mesh.tau = dim == 2 ? 2.5 : 3;
    netmesh_context* context = nullptr;
    Text out;
    out.words("demo D").number(static_cast<unsigned>(dim));
    netmesh_status status = netmesh_init(block, bytes, &context);
    if (status == NETMESH_OK) status = netmesh_mesh(context, &request);
    add_result(&out, "mesh", status, context);
    const netmesh::Request diagram(&netmesh_filter_complete);
    if (status == NETMESH_OK) status = netmesh_persist(context, &diagram);
    add_result(&out, "persist", status, context);
    print(out.words());
    report->struct_bytes = sizeof *report;
    return status != NETMESH_OK ? status : netmesh_get_report(context, report);
}

}  // namespace slice
