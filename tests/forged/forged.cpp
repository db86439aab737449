// Forged meshes: Delaunay triangulations of vertices that do not keep the aspect ratio that they promise. netmesh_check
// refuses them all. Honest meshes by every method are accepted, where they were made and loaded.
//
//   forged [full] [D]...
//
// An oracle of its own says that a mesh is forged, by a point that is farther from the vertex that it is nearest to
// than tau allows: points of the ball at random, and circumcentres of cells inside of it, in long doubles. Where it
// finds none nothing is expected. The full form has more than a thousand forged meshes, the slice some of each kind.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

long faults = 0;
std::map<std::string, long> refused, accepted, skipped;

struct Dice {
    explicit Dice(std::uint64_t seed) : random(seed) {}
    double uniform(double low, double high) { return low + (high - low) * random.uniform(); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random.uniform() * static_cast<double>(n)) % n; }
    inputs::Random random;
};

double distance(const double* a, const double* b, std::size_t dim) {
    long double sum = 0;
    for (std::size_t k = 0; k < dim; ++k) sum += (static_cast<long double>(a[k]) - b[k]) * (a[k] - b[k]);
    return static_cast<double>(std::sqrt(sum));
}

// Vertices with the inputs first; cells are made by triangulating them.
struct Forged {
    std::size_t dim;
    std::vector<double> x;
    std::vector<std::uint8_t> markers;
    std::vector<double> domain;
    double tau = 2.5;

    std::size_t count() const { return markers.size(); }
    const double* at(std::size_t v) const { return &x[v * dim]; }
    void add(const std::vector<double>& place, std::uint8_t marker) {
        x.insert(x.end(), place.begin(), place.end());
        markers.push_back(marker);
    }
    void drop(std::size_t v) {
        const auto row = static_cast<std::ptrdiff_t>(v * dim), width = static_cast<std::ptrdiff_t>(dim);
        x.erase(x.begin() + row, x.begin() + row + width);
        markers.erase(markers.begin() + static_cast<std::ptrdiff_t>(v));
    }
    double from_centre(std::size_t v) const { return distance(at(v), domain.data(), dim); }
};

// The circumcentre of a cell, as far as long doubles tell: rows are scaled.
bool circumcentre(const Forged& f, const std::uint32_t* cell, std::vector<long double>* centre) {
    const std::size_t d = f.dim;
    std::vector<std::vector<long double>> a(d, std::vector<long double>(d + 1));
    const double* const p = f.at(cell[0]);
    for (std::size_t i = 0; i < d; ++i) {
        long double square = 0;
        for (std::size_t k = 0; k < d; ++k) {
            a[i][k] = static_cast<long double>(f.at(cell[i + 1])[k]) - p[k];
            square += a[i][k] * a[i][k];
        }
        const long double length = std::sqrt(square);
        for (std::size_t k = 0; k < d; ++k) a[i][k] /= length;
        a[i][d] = length / 2;
    }
    for (std::size_t k = 0; k < d; ++k) {
        std::size_t row = k;
        for (std::size_t i = k; i < d; ++i)
            if (std::fabs(a[i][k]) > std::fabs(a[row][k])) row = i;
        if (!(std::fabs(a[row][k]) > 1e-4L)) return false;
        std::swap(a[k], a[row]);
        for (std::size_t i = 0; i < d; ++i) {
            if (i == k) continue;
            const long double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j <= d; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    centre->resize(d);
    for (std::size_t k = 0; k < d; ++k) (*centre)[k] = p[k] + a[k][d] / a[k][k];
    return true;
}

// A ratio that some vertex surely has: twice the distance of a point of its clipped cell over that of its neighbour.
double least_ratio(const Forged& f, const std::vector<std::uint32_t>& cells, Dice& dice, int samples) {
    const std::size_t d = f.dim, n = f.count();
    std::vector<double> nearest(n, INFINITY);
    for (std::size_t v = 0; v < n; ++v)
        for (std::size_t w = 0; w < v; ++w) {
            const double apart = distance(f.at(v), f.at(w), d);
            nearest[v] = std::min(nearest[v], apart);
            nearest[w] = std::min(nearest[w], apart);
        }
    double worst = 0;
    const auto look = [&](const double* x) {
        std::size_t own = 0;
        double least = INFINITY;
        for (std::size_t v = 0; v < n; ++v) {
            const double away = distance(f.at(v), x, d);
            if (!(away < least)) continue;
            least = away;
            own = v;
        }
        if (f.markers[own] != 2) worst = std::max(worst, 2 * least * (1 - 1e-12) / nearest[own]);
    };
    std::vector<double> x(d);
    for (int s = 0; s < samples; ++s) {
        double square = 0;
        for (std::size_t k = 0; k < d; ++k) {
            x[k] = dice.uniform(-1, 1);
            square += x[k] * x[k];
        }
        const double scale = f.domain[d] * (1 - 1e-9) * (s % 2 != 0 || square > 1 ? 1 / std::sqrt(square) : 1);
        for (std::size_t k = 0; k < d; ++k) x[k] = f.domain[k] + scale * x[k];
        look(x.data());
    }
    std::vector<long double> centre;
    for (std::size_t c = 0; c < cells.size() / (d + 1); ++c) {
        const std::uint32_t* const cell = &cells[c * (d + 1)];
        if (!circumcentre(f, cell, &centre)) continue;
        for (std::size_t k = 0; k < d; ++k) x[k] = static_cast<double>(centre[k]);
        if (!(distance(x.data(), f.domain.data(), d) < f.domain[d] * (1 - 1e-9))) continue;
        const double radius = distance(x.data(), f.at(cell[0]), d) * (1 - 1e-9);
        for (std::size_t i = 0; i <= d; ++i)
            if (f.markers[cell[i]] != 2) worst = std::max(worst, 2 * radius / nearest[cell[i]]);
    }
    return worst;
}

enum class Said { nothing, refused, accepted, failed };

// Triangulates, loads and checks.
Said judge(const Forged& f, Dice& dice, int samples, double* ratio, std::string* why) {
    Session made(static_cast<int>(f.dim)), loaded(static_cast<int>(f.dim));
    if (made.delaunay(f.x) != NETMESH_OK || made.report().input.duplicates != 0) return Said::nothing;
    Arrays arrays(made);
    arrays.markers = f.markers;
    arrays.domain = f.domain;
    for (const netmesh_cell& cell : read_all(made.context, netmesh_get_cell))
        for (std::size_t i = 0; i <= f.dim; ++i)
            for (std::size_t j = 0; j <= f.dim; ++j)
                if (cell.neighbours[i] == UINT32_MAX && j != i && f.markers[cell.vertices[j]] != 2)
                    return Said::nothing;
    *ratio = least_ratio(f, arrays.cells, dice, samples);
    loaded.request.mesh.tau = f.tau;
    loaded.reserve(std::size_t{1} << 26);
    netmesh_status status = arrays.load(loaded);
    if (status == NETMESH_OK) status = loaded.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS);
    *why = loaded.detail().message;
    return status == NETMESH_OK ? Said::accepted : status == NETMESH_CHECK_FAILED ? Said::refused : Said::failed;
}

// A few inputs in a frame of exempt vertices on the axes, each axis as far away as it likes; `flat`: in a plane, but
// for what is left of the last coordinate.
Forged in_far_frame(std::size_t dim, Dice& dice, bool flat) {
    Forged f = {dim, {}, {}, std::vector<double>(dim + 1, 0.0)};
    f.domain[dim] = 10;
    const std::size_t inputs = 2 + dice.below(6);
    const double thin = flat ? std::pow(10, dice.uniform(-40, -3)) : 1;
    for (std::size_t i = 0; i < inputs; ++i) {
        std::vector<double> x(dim);
        for (std::size_t k = 0; k < dim; ++k) x[k] = dice.uniform(-5, 5) * (k + 1 == dim ? thin : 1);
        f.add(x, 0);
    }
    const bool jitters = dice.below(2) == 0, unlike = dice.below(3) != 0;
    const double far = dice.uniform(2, 60);
    for (std::size_t i = 0; i < 2 * dim; ++i) {
        const double away = std::pow(10, unlike ? dice.uniform(2, 60) : far);
        std::vector<double> x(dim, 0.0);
        for (std::size_t k = 0; k < dim && jitters; ++k) x[k] = away * dice.uniform(-1e-3, 1e-3);
        x[i / 2] = i % 2 == 0 ? away : -away;
        f.add(x, 2);
    }
    return f;
}

Forged of_mesh(const Arrays& mesh, double tau) { return {mesh.dim, mesh.vertices, mesh.markers, mesh.domain, tau}; }

Arrays honest_mesh(std::size_t dim, Dice& dice, double tau) {
    Session s(static_cast<int>(dim));
    s.request.mesh.tau = tau;
    const inputs::Points points = inputs::uniform(static_cast<int>(dim), 3 + dice.below(10), dice.below(1000));
    if (s.mesh(points) != NETMESH_OK) std::abort();
    return Arrays(s);
}

using Make = Forged (*)(std::size_t dim, Dice& dice);
constexpr double tau_of(std::size_t dim) { return dim < 4 ? 2.5 : 4; }

Forged thinned(std::size_t dim, Dice& dice) {
    Forged f = of_mesh(honest_mesh(dim, dice, tau_of(dim)), tau_of(dim));
    const double share = dice.below(3) == 0 ? 0.5 : 0.03;
    for (std::size_t v = f.count(); v-- > 0;)
        if (f.markers[v] == 1 && dice.uniform(0, 1) < share) f.drop(v);
    return f;
}
Forged nearly_kept(std::size_t dim, Dice& dice) {
    Forged f = of_mesh(honest_mesh(dim, dice, tau_of(dim) + dice.uniform(0, 1)), 0);
    Session s(static_cast<int>(dim));
    if (s.delaunay(f.x) != NETMESH_OK) std::abort();
    const double least = least_ratio(f, Arrays(s).cells, dice, 0);
    f.tau = std::max(2.0001, least * (1 - std::pow(10, dice.uniform(-7, -2))));
    return f;
}
Forged frame_moved_out(std::size_t dim, Dice& dice) {
    Forged f = of_mesh(honest_mesh(dim, dice, tau_of(dim)), tau_of(dim));
    double factor[4];
    for (std::size_t k = 0; k < dim; ++k) factor[k] = std::pow(10, dice.uniform(0.3, 80));
    for (std::size_t v = f.count(); v-- > 0;) {
        for (std::size_t k = 0; k < dim && f.markers[v] == 2; ++k) f.x[v * dim + k] *= factor[k];
        if (f.markers[v] == 1 && dice.uniform(0, 1) < 0.2) f.drop(v);
    }
    return f;
}
Forged steiner_outside(std::size_t dim, Dice& dice) {
    Forged f = dice.below(2) == 0 ? in_far_frame(dim, dice, false) : thinned(dim, dice);
    const std::size_t more = 1 + dice.below(4);
    for (std::size_t i = 0; i < more; ++i) {
        std::vector<double> x(dim);
        const double away = f.domain[dim] * std::pow(10, dice.uniform(0, 1.2));
        double square = 0;
        for (double& y : x) {
            y = dice.uniform(-1, 1);
            square += y * y;
        }
        for (std::size_t k = 0; k < dim; ++k) x[k] = f.domain[k] + x[k] / std::sqrt(square) * away;
        f.add(x, 1);
    }
    return f;
}
Forged domain_blown_up(std::size_t dim, Dice& dice) {
    Forged f = of_mesh(honest_mesh(dim, dice, tau_of(dim)), tau_of(dim));
    f.domain[dim] *= dice.uniform(1.05, 1.9);
    return f;
}
Forged far_frame(std::size_t dim, Dice& dice) { return in_far_frame(dim, dice, false); }
Forged flat(std::size_t dim, Dice& dice) { return in_far_frame(dim, dice, true); }

const struct {
    const char* name;
    Make make;
} kinds[] = {{"inputs in a far frame", far_frame},
             {"flat inputs in a far frame", flat},
             {"Steiner vertices left out", thinned},
             {"tau a hair below the ratio", nearly_kept},
             {"the frame of a mesh moved out", frame_moved_out},
             {"Steiner vertices outside of the ball", steiner_outside},
             {"the domain of a mesh made larger", domain_blown_up}};

void forge(std::size_t dim, int runs) {
    for (const auto& kind : kinds)
        for (int i = 0; i < runs; ++i) {
            Dice dice(1000 * dim + 17 * static_cast<std::uint64_t>(i) + 1);
            const Forged f = kind.make(dim, dice);
            double ratio = 0;
            std::string why;
            const Said said = judge(f, dice, dim < 4 ? 4000 : 2000, &ratio, &why);
            if (said == Said::nothing || !(ratio > f.tau)) {
                ++skipped[kind.name];
                continue;
            }
            if (said == Said::refused) ++refused[kind.name];
            if (said == Said::refused || ++faults > 50) continue;
            std::printf("FAULT D%zu %s, %d: ratio of %g at tau %g %s %s\n", dim, kind.name, i, ratio, f.tau,
                        said == Said::accepted ? "is accepted" : "ends in another way:", why.c_str());
        }
}

// Of the slice one method in three, another one for each set.
void honest(std::size_t dim, int runs, bool every) {
    const int d = static_cast<int>(dim);
    for (int i = 0; i < runs; ++i)
        for (int method = 0; method < 9; ++method) {
            if (!every && dim < 4 && (i + method) % 3 != 0) continue;
            if ((dim == 4 && (method == 2 || method == 4) && i > 0) || (dim == 4 && method == 5)) continue;
            const std::uint64_t seed = static_cast<std::uint64_t>(i);
            const std::size_t n = dim == 4 ? 6 : 5 + seed % 20;
            inputs::Points points = inputs::uniform(d, n, seed);
            if (i % 7 == 1) points = inputs::clusters(d, dim == 4 ? 6 : 20, seed);
            if (i % 7 == 2) points = inputs::grid(d, dim == 4 ? 2 : 3);
            if (i % 7 == 3) points = inputs::geometric(d, dim == 4 ? 10 : 1e3, dim == 4 ? 3 : 6, seed);
            if (i % 7 == 4) points = inputs::close_pairs(d, dim == 4 ? 2 : 4, 1e-3, seed);
            if (i % 7 == 5)  // in a line
                for (std::size_t k = 0; k < points.size(); ++k)
                    if (k % dim != 0) points[k] = 0.25;
            if (i % 7 == 6)  // hardly resolved
                for (double& x : points) x = 1 + std::floor(x * 4000) * 0x1p-52;
            Session made(d), loaded(d);
            made.reserve(std::size_t{1} << 28);
            netmesh_request& r = made.request;
            if (method == 1) r.mesh.method = &netmesh_method_netmesh;
            if (method == 2) r.mesh.method = &netmesh_method_refine;
            if (method == 3) r.mesh.method = &netmesh_method_netmesh, r.mesh.finish = 1;
            if (method == 4) r.mesh.method = &netmesh_method_thesis, r.mesh.tau = 7;
            if (method == 5) r.mesh.sizes.eps = 0.8;
            if (method == 6) r.goal.ratio = 2.5;
            if (method == 7) r.goal.ratio = 2.5, r.mesh.whole_cells = 1;
            if (method == 8 && dim < 4) r.mesh.tau = 2.2;
            const bool persists = method == 0 || method == 6 || method == 7;
            const char* const name = "honest";
            netmesh_status status = made.mesh(points, persists ? &netmesh_filter_complete : nullptr);
            if (status == NETMESH_TOO_CLOSE || status == NETMESH_INVALID_ARGUMENT) {
                ++skipped[name];
                continue;
            }
            const char* step = "mesh";
            if (status == NETMESH_OK) status = made.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS), step = "check";
            std::string why = made.detail().message;
            if (status == NETMESH_OK) {
                const Arrays arrays(made);
                static_cast<netmesh_request&>(loaded.request) = r;
                loaded.reserve(std::size_t{1} << 28);
                step = "load and check";
                status = arrays.load(loaded);
                if (status == NETMESH_OK && !arrays.cages.empty()) status = arrays.load_cages(loaded);
                if (status == NETMESH_OK) status = loaded.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS);
                why = loaded.detail().message;
            }
            if (status == NETMESH_OK) ++accepted[name];
            if (status == NETMESH_OK || ++faults > 50) continue;
            std::printf("FAULT D%zu honest, %d, method %d: %s: %s\n", dim, i, method, step, why.c_str());
        }
}

}  // namespace

int main(int argc, char** argv) {
    const bool full = argc > 1 && std::strcmp(argv[1], "full") == 0;
    std::vector<int> dims;
    for (int i = full ? 2 : 1; i < argc; ++i) dims.push_back(std::atoi(argv[i]));
    setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    for (const int dim : dims.empty() ? dimensions(2, 4) : dims) {
        forge(static_cast<std::size_t>(dim), full ? (dim < 4 ? 120 : 80) : dim < 4 ? 6 : 3);
        honest(static_cast<std::size_t>(dim), full ? (dim < 4 ? 21 : 7) : dim < 4 ? 7 : 1, full);
    }
    long all = 0;
    for (const auto& kind : kinds) {
        std::printf("%-40s %5ld refused, %4ld of which the oracle does not say that they are forged\n", kind.name,
                    refused[kind.name], skipped[kind.name]);
        all += refused[kind.name];
        if (dims.empty() && refused[kind.name] == 0) ++faults;
    }
    std::printf("%ld forged meshes refused, %ld honest ones accepted, %ld faults\n", all, accepted["honest"], faults);
    return faults == 0 && (!full || !dims.empty() || all >= 1000) ? 0 : 1;
}
