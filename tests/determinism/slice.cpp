#include "determinism/slice.hpp"

#include <cstdint>

#include "determinism/text.hpp"
#include "netmesh.h"

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

void add_result(Text* line, const char* job, netmesh_status status, const netmesh_context* context) {
    line->words(" ").words(job).words(" ");
    netmesh_report report;
    report.struct_bytes = sizeof report;
    if (status == NETMESH_OK) status = netmesh_get_report(context, &report);
    if (status == NETMESH_OK) {
        line->hex(report.fingerprint);
    } else {
        line->words("status ").number(static_cast<unsigned>(status));
    }
}

}  // namespace

int run(void* block, std::size_t bytes, int first, int last, void (*print)(const char* line)) {
    static Input in;
    int lines = 0;
    for (int dim = first; dim <= last; ++dim)
        for (int which = 0; which < inputs_per_dimension; ++which, ++lines) {
            Text out;
            out.words("D")
                .number(static_cast<unsigned>(dim))
                .words(" ")
                .number(static_cast<unsigned>(which))
                .words(" ");
            out.words(make(&in, dim, which));
            const std::size_t n = static_cast<std::size_t>(in.count);
            const std::size_t meshed = static_cast<std::size_t>(in.meshed < in.count ? in.meshed : in.count);
            netmesh_options options;
            netmesh_options_init(&options, static_cast<std::uint32_t>(dim));
            netmesh_context* context;
            netmesh_status status = netmesh_init(block, bytes, &context);
            if (status == NETMESH_OK) status = netmesh_delaunay(context, in.x, n, &options);
            add_result(&out, "delaunay", status, context);
            if (status == NETMESH_OK)
                status = netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 1,
                                         &options);
            add_result(&out, "alpha", status, context);
            status = netmesh_init(block, bytes, &context);
            if (status == NETMESH_OK) status = netmesh_mesh(context, in.x, meshed, NETMESH_JOB_PERSIST, &options);
            add_result(&out, "mesh", status, context);
            if (status == NETMESH_OK)
                status = netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 1,
                                         &options);
            add_result(&out, "persist", status, context);
            print(out.words());
        }
    return lines;
}

netmesh_status demo(int dim, void* block, std::size_t bytes, netmesh_report* report, void (*print)(const char* line)) {
    static double x[1000];
    const std::size_t n = dim == 2 ? 500 : 200;
    Random random(static_cast<std::uint64_t>(dim));
    for (std::size_t i = 0; i < n * static_cast<std::size_t>(dim); ++i) x[i] = random.uniform();
    netmesh_options options;
    netmesh_options_init(&options, static_cast<std::uint32_t>(dim));
    options.tau = dim == 2 ? 2.5 : 3;
    netmesh_context* context;
    netmesh_status status = netmesh_init(block, bytes, &context);
    Text out;
    out.words("demo D").number(static_cast<unsigned>(dim));
    if (status == NETMESH_OK) status = netmesh_mesh(context, x, n, NETMESH_JOB_PERSIST, &options);
    add_result(&out, "mesh", status, context);
    if (status == NETMESH_OK)
        status =
            netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 0, &options);
    add_result(&out, "persist", status, context);
    print(out.words());
    report->struct_bytes = sizeof *report;
    return status != NETMESH_OK ? status : netmesh_get_report(context, report);
}

}  // namespace slice
