#include "tools/sample/shapes.hpp"
#include "tools/closest.hpp"
#include "tools/io/numbers.hpp"

#include <cmath>

#include "tools/sample/random.hpp"

namespace netmesh::tool {

namespace {

constexpr double pi = 3.14159265358979323846;

struct Sampler {
    const SampleRequest& request;
    std::uint32_t dim;
    Random random;
    std::uint64_t grid_side;
};

// Each shape writes point `index` to x[0, dim), which is zero before.
using Shape = void (*)(Sampler&, std::uint64_t index, double* x);

// A uniform direction times `radius`.
void put_direction(Sampler& s, double radius, double* x) {
    for (;;) {
        double norm = 0;
        for (std::uint32_t k = 0; k < s.dim; k++) {
            x[k] = s.random.normal();
            norm += x[k] * x[k];
        }
        if (norm < 1e-6) continue;
        const double scale = radius / std::sqrt(norm);
        for (std::uint32_t k = 0; k < s.dim; k++) x[k] *= scale;
        return;
    }
}

// The angle of point `index` on a closed curve walked `turns` times, reduced before it is rounded.
double angle(const Sampler& s, std::uint64_t index, std::uint64_t turns = 1) {
    const std::uint64_t n = s.request.count;
    return 2 * pi * static_cast<double>(index * (turns % n) % n) / static_cast<double>(n);
}

void ball(Sampler& s, std::uint64_t, double* x) { put_direction(s, std::pow(s.random.uniform(), 1.0 / s.dim), x); }

void sphere(Sampler& s, std::uint64_t, double* x) { put_direction(s, 1, x); }

void annulus(Sampler& s, std::uint64_t, double* x) {
    const double inner = std::pow(0.6, s.dim);
    put_direction(s, std::pow(inner + (1 - inner) * s.random.uniform(), 1.0 / s.dim), x);
}

void cube(Sampler& s, std::uint64_t, double* x) {
    for (std::uint32_t k = 0; k < s.dim; k++) x[k] = s.random.uniform();
}

// The side of the smallest integer cube with `count` points or more.
std::uint64_t side_for(std::uint64_t count, std::uint32_t dim) {
    for (std::uint64_t side = 1;; side++) {
        if (std::pow(static_cast<double>(side), dim) >= static_cast<double>(count)) return side;
    }
}

void grid(Sampler& s, std::uint64_t index, double* x) {
    for (std::uint32_t k = s.dim; k-- > 0; index /= s.grid_side) x[k] = static_cast<double>(index % s.grid_side);
}

// Uniform on the surface: the share of a latitude grows with its distance from the axis.
void torus(Sampler& s, std::uint64_t, double* x) {
    const double tube = 0.4;
    for (;;) {
        const double u = 2 * pi * s.random.uniform(), v = 2 * pi * s.random.uniform();
        const double axis_distance = 1 + tube * std::cos(v);
        if (s.random.uniform() * (1 + tube) > axis_distance) continue;
        x[0] = axis_distance * std::cos(u);
        x[1] = axis_distance * std::sin(u);
        x[2] = tube * std::sin(v);
        return;
    }
}

void clifford(Sampler& s, std::uint64_t index, double* x) {
    const double u = angle(s, index, s.request.turns[0]), v = angle(s, index, s.request.turns[1]);
    x[0] = std::cos(u);
    x[1] = std::sin(u);
    x[2] = std::cos(v);
    x[3] = std::sin(v);
}

void circle(Sampler& s, std::uint64_t index, double* x) {
    x[0] = std::cos(angle(s, index));
    x[1] = std::sin(angle(s, index));
}

void figure_eight(Sampler& s, std::uint64_t index, double* x) {
    // Half a step off, so that the crossing is not sampled twice.
    const double t = angle(s, index) + pi / static_cast<double>(s.request.count);
    x[0] = std::sin(t);
    x[1] = std::sin(t) * std::cos(t);
}

void helix(Sampler& s, std::uint64_t index, double* x) {
    const double t = static_cast<double>(index) / static_cast<double>(s.request.count);
    x[0] = std::cos(6 * pi * t);
    x[1] = std::sin(6 * pi * t);
    x[2] = 3 * t;
}

// The trigonometric moment curve: (cos t, sin t, cos 2t, sin 2t, ..).
void curve(Sampler& s, std::uint64_t index, double* x) {
    for (std::uint32_t k = 0; k < s.dim; k++) {
        const double t = angle(s, index, k / 2 + 1);
        x[k] = k % 2 == 0 ? std::cos(t) : std::sin(t);
    }
}

void zoom(Sampler& s, std::uint64_t index, double* x) {
    put_direction(s, std::ldexp(1.0, -static_cast<int>(index)), x);
}

// About sqrt(count) clusters in the unit ball, the radius of each a millionth to a tenth, all scales alike.
void clusters(Sampler& s, std::uint64_t index, double* x) {
    const std::uint64_t number = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(s.request.count))) + 1;
    Sampler own{s.request, s.dim, Random(s.request.seed * 1000003 + 1 + index % number), 0};
    double centre[6];
    put_direction(own, std::pow(own.random.uniform(), 1.0 / s.dim), centre);
    const double radius = std::pow(10.0, -1 - 5 * own.random.uniform());
    put_direction(s, radius * std::pow(s.random.uniform(), 1.0 / s.dim), x);
    for (std::uint32_t k = 0; k < s.dim; k++) x[k] += centre[k];
}

struct Entry {
    const char* name;
    Shape shape;
    std::uint32_t dim, dim_least;
    std::uint64_t count_most;  // 0: no limit
    bool is_random;
    const char* help;
};

constexpr Entry entries[] = {
    {"annulus", annulus, 2, 2, 0, true, "uniform between the spheres of radius 0.6 and 1"},
    {"ball", ball, 3, 2, 0, true, "uniform in the unit ball"},
    {"circle", circle, 2, 2, 0, false, "evenly on the unit circle"},
    {"clifford", clifford, 4, 4, 0, false, "evenly on a closed winding of the Clifford torus (--turns)"},
    {"clusters", clusters, 2, 2, 0, true, "clusters of radius 1e-6 to 0.1 in the unit ball"},
    {"cube", cube, 3, 2, 0, true, "uniform in the unit cube"},
    {"curve", curve, 4, 2, 0, false, "evenly on (cos t, sin t, cos 2t, sin 2t, ..)"},
    {"figure-eight", figure_eight, 2, 2, 0, false, "on (sin t, sin t cos t)"},
    {"grid", grid, 3, 2, 0, false, "integer grid, lexicographic order"},
    {"helix", helix, 3, 3, 0, false, "three turns of a helix"},
    {"sphere", sphere, 3, 2, 0, true, "uniform on the unit sphere"},
    {"torus", torus, 3, 3, 0, true, "uniform on the torus with radii 1 and 0.4"},
    {"zoom", zoom, 2, 2, 1000, true, "point i at distance 2^-i from the origin"},
};

const Entry* find_entry(const std::string& name) {
    for (const Entry& entry : entries) {
        if (name == entry.name) return &entry;
    }
    return nullptr;
}

}  // namespace

Outcome sample_points(const SampleRequest& request, std::vector<double>* coordinates, std::uint32_t* dim) {
    const Entry* const entry = find_entry(request.shape);
    if (entry == nullptr) {
        std::string names;
        std::vector<std::string> list;
        for (const Entry& known : entries) names += std::string(" ") + known.name, list.emplace_back(known.name);
        return usage_error("no shape '" + request.shape + "'; there are:" + names + did_you_mean(request.shape, list));
    }
    *dim = request.dim == 0 ? entry->dim : request.dim;
    if (*dim < entry->dim_least) {
        return usage_error("--dim: " + request.shape + " needs " +
                           counted(entry->dim_least, "dimension", "dimensions") + " or more");
    }
    if (entry->count_most != 0 && request.count > entry->count_most) {
        return usage_error("-n: " + request.shape + " has " + counted(entry->count_most, "point", "points") +
                           " at most");
    }
    Sampler sampler{request, *dim, Random(request.seed), side_for(request.count, *dim)};
    coordinates->assign(request.count * *dim, 0.0);
    for (std::uint64_t i = 0; i < request.count; i++) {
        double* const x = coordinates->data() + i * *dim;
        entry->shape(sampler, i, x);
        if (request.noise > 0) {
            for (std::uint32_t k = 0; k < *dim; k++) x[k] += request.noise * sampler.random.normal();
        }
    }
    return {};
}

bool is_random_shape(const std::string& name) {
    const Entry* const entry = find_entry(name);
    return entry == nullptr || entry->is_random;
}

std::string shapes_help() {
    std::string text;
    for (const Entry& entry : entries) {
        std::string line = std::string("  ") + entry.name;
        line.resize(line.size() < 17 ? 17 : line.size() + 1, ' ');
        text += line + entry.help + " (D = " + std::to_string(entry.dim) + ")\n";
    }
    return text;
}

}  // namespace netmesh::tool
