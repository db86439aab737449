// Us and the peers on the same inputs in the same run, pair by pair.
//
//   bench_peers [delaunay | refine | persist | alpha | weights | periods]... [--reps N] [--scale S]
//
// --reps: repetitions of every pair, alternating (3). --scale: factor on the numbers of points (1).
// CPU seconds on one core; ratio = the peer's median over ours. Exits 1 when results that must be equal are not.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "contestants.hpp"

namespace {

using bench::Outcome;
using bench::Trial;

int reps = 3;
double scale = 1.0;
bool all_equal = true;

std::size_t scaled(double n) { return static_cast<std::size_t>(std::max(50.0, n * scale)); }

struct Summary {
    std::vector<Outcome> runs;
    bool finished() const {
        return !runs.empty() && std::all_of(runs.begin(), runs.end(), [](const Outcome& o) { return o.finished; });
    }
    double seconds_min() const { return sorted().front(); }
    double seconds_median() const { return sorted()[runs.size() / 2]; }
    double bytes() const {
        double most = 0.0;
        for (const Outcome& o : runs) most = std::max(most, o.bytes);
        return most;
    }
    double figure(bench::Figure f) const { return runs.front().figures[f]; }

private:
    std::vector<double> sorted() const {
        std::vector<double> s;
        for (const Outcome& o : runs) s.push_back(o.seconds);
        std::sort(s.begin(), s.end());
        return s;
    }
};

// Contestants one after another, `reps` rounds of that.
std::vector<Summary> play(const std::vector<bench::Contestant>& contestants) {
    std::vector<Summary> summaries(contestants.size());
    for (int r = 0; r < reps; ++r)
        for (std::size_t i = 0; i < contestants.size(); ++i) summaries[i].runs.push_back(bench::run(contestants[i]));
    return summaries;
}

void print_times(const char* who, const Summary& s) {
    if (s.finished())
        std::printf("%s %.3f / %.3f s", who, s.seconds_min(), s.seconds_median());
    else
        std::printf("%s did not finish", who);
}

[[maybe_unused]] double ratio(const Summary& ours, const Summary& peer) {
    return peer.seconds_median() / ours.seconds_median();
}

// Every bar of one diagram next to one of the other, within rounding; bars shorter than rounding do not count.
// slack: added to what roundings of a number may be. from: the least degree that is compared.
[[maybe_unused]] bool equal_diagrams(std::vector<netmesh_pair> a, std::vector<netmesh_pair> b, double slack = 0,
                                     std::uint32_t from = 0) {
    const double tolerance = 1e-7;
    const auto close = [&](double x, double y) {
        return x == y || std::fabs(x - y) <= tolerance * std::max(std::fabs(x), std::fabs(y)) + slack;
    };
    const auto clean = [&](std::vector<netmesh_pair>& d) {
        d.erase(std::remove_if(d.begin(), d.end(),
                               [&](const netmesh_pair& p) { return p.degree < from || close(p.birth, p.death); }),
                d.end());
        std::sort(d.begin(), d.end(), [](const netmesh_pair& p, const netmesh_pair& q) {
            return p.degree != q.degree ? p.degree < q.degree
                   : p.birth != q.birth ? p.birth < q.birth
                                        : p.death < q.death;
        });
    };
    clean(a);
    clean(b);
    if (a.size() != b.size() || a.empty()) return false;
    std::vector<bool> taken(b.size(), false);
    std::size_t low = 0;
    for (const netmesh_pair& p : a) {
        while (low < b.size() && (b[low].degree < p.degree || (b[low].degree == p.degree && b[low].birth < p.birth &&
                                                               !close(b[low].birth, p.birth))))
            ++low;
        std::size_t j = low;
        for (; j < b.size() && b[j].degree == p.degree && (b[j].birth <= p.birth || close(b[j].birth, p.birth)); ++j)
            if (!taken[j] && close(b[j].birth, p.birth) && close(b[j].death, p.death)) break;
        if (j == b.size() || b[j].degree != p.degree || !close(b[j].birth, p.birth) || taken[j]) return false;
        taken[j] = true;
    }
    return true;
}

void expect(bool equal, const char* what) {
    std::printf("  %s: %s\n", what, equal ? "equal" : "DIFFERENT");
    all_equal = all_equal && equal;
}

void delaunay() {
    struct Case {
        int dim;
        const char* name;
        inputs::Points points;
        bool unique;  // in general position, so both triangulations are the same
    };
    const auto side = [](int dim, double n) {
        return static_cast<int>(std::lround(std::pow(static_cast<double>(scaled(n)), 1.0 / dim)));
    };
    const Case cases[] = {
        {2, "uniform", inputs::uniform(2, scaled(1e6)), true},  {2, "grid", inputs::grid(2, side(2, 1e6)), true},
        {2, "circle", inputs::circle(scaled(2e5)), false},      {3, "uniform", inputs::uniform(3, scaled(2e5)), true},
        {3, "uniform", inputs::uniform(3, scaled(1e6)), true},  {3, "grid", inputs::grid(3, side(3, 125000)), false},
        {4, "uniform", inputs::uniform(4, scaled(1e4)), true},  {4, "uniform", inputs::uniform(4, scaled(1e5)), true},
        {4, "grid", inputs::grid(4, side(4, 10000)), false},    {5, "uniform", inputs::uniform(5, scaled(3e3)), true},
        {5, "uniform", inputs::uniform(5, scaled(1e4)), true},  {6, "uniform", inputs::uniform(6, scaled(500)), true},
        {6, "uniform", inputs::uniform(6, scaled(2000)), true},
    };
    std::printf("\nDelaunay triangulation, one core; CGAL sorts points in space itself, HXT is called through gmsh; "
                "min / median\n");
    for (const Case& c : cases) {
        const std::size_t n = c.points.size() / static_cast<std::size_t>(c.dim);
        std::vector<const char*> names = {"netmesh"};
        std::vector<bench::Contestant> contestants = {[&](Trial& t) { bench::ours_delaunay(t, c.dim, c.points); }};
#ifdef NETMESH_BENCH_CGAL
        names.push_back("CGAL");
        contestants.push_back([&](Trial& t) {
            if (c.dim == 2) bench::cgal_delaunay_2(t, c.points);
            if (c.dim == 3) bench::cgal_delaunay_3(t, c.points);
            if (c.dim >= 4) bench::cgal_delaunay_d(t, c.dim, c.points);
        });
#endif
#ifdef NETMESH_BENCH_HXT
        if (c.dim == 3) {
            names.push_back("HXT");
            contestants.push_back([&](Trial& t) { bench::hxt_delaunay_3(t, c.points); });
        }
#endif
#ifdef NETMESH_BENCH_QHULL
        // From so many points on, by dimension from 2 on, it takes minutes; on a circle its time grows with n^2.
        constexpr std::size_t minutes_from[] = {300000, 300000, 20000, 5000, 1000};
        if (n < minutes_from[c.dim - 2] && std::strcmp(c.name, "circle") != 0) {
            names.push_back("Qhull");
            contestants.push_back([&](Trial& t) { bench::qhull_delaunay(t, c.dim, c.points); });
        }
#endif
        const std::vector<Summary> s = play(contestants);
        std::printf("%dD %-8s %8zu  ", c.dim, c.name, n);
        print_times("netmesh", s[0]);
        all_equal = all_equal && s[0].finished();
        if (s[0].finished())
            std::printf(" (%.0f points/s, %.0f B a cell, %.0f cells)", static_cast<double>(n) / s[0].seconds_median(),
                        s[0].figure(bench::arena_bytes) / s[0].figure(bench::cells), s[0].figure(bench::cells));
        for (std::size_t i = 1; i < s.size(); ++i) {
            std::printf("; ");
            print_times(names[i], s[i]);
            if (s[0].finished() && s[i].finished())
                std::printf(" (%.0f B a cell) ratio %.2f", s[i].bytes() / s[i].figure(bench::cells), ratio(s[0], s[i]));
        }
        std::printf("\n");
        for (std::size_t i = 1; i < s.size(); ++i)
            if (c.unique && std::strcmp(names[i], "CGAL") == 0 && s[0].finished() && s[i].finished())
                expect(s[0].figure(bench::cells) == s[i].figure(bench::cells), "number of cells");
    }
}

void refine() {
    const inputs::Points points = inputs::uniform(3, scaled(1e4));
    std::vector<bench::Contestant> contestants = {[&](Trial& t) { bench::ours_mesh(t, points, 3.0); }};
#ifdef NETMESH_BENCH_TETGEN
    contestants.push_back([&](Trial& t) { bench::tetgen_mesh(t, points, 1.2); });
#endif
    const std::vector<Summary> s = play(contestants);
    std::printf("\nQuality mesh of %zu uniform points in 3D; aspect ratio R/r of whole Voronoi cells in the domain\n",
                points.size() / 3);
    const char* names[] = {"netmesh tau 3.0", "TetGen -q1.2"};
    for (std::size_t i = 0; i < s.size(); ++i) {
        print_times(names[i], s[i]);
        if (s[i].finished())
            std::printf(", %.0f vertices, %.0f cells, aspect ratio worst %.3f, mean %.3f, %.0f MB",
                        s[i].figure(bench::vertices), s[i].figure(bench::cells), s[i].figure(bench::aspect_worst),
                        s[i].figure(bench::aspect_mean), s[i].bytes() / 1e6);
        if (s[i].finished() && i == 0)
            std::printf("; clipped to the domain, worst %.3f", s[i].figure(bench::aspect_clipped));
        std::printf("\n");
    }
    all_equal = all_equal && s[0].finished();
    if (s.size() > 1 && s[0].finished() && s[1].finished())
        std::printf("ratio: time %.2f, vertices %.2f (TetGen over netmesh)\n", ratio(s[0], s[1]),
                    s[1].figure(bench::vertices) / s[0].figure(bench::vertices));
}

void persist() {
    struct Case {
        int dim;
        const char* name;
        inputs::Points points;
        double tau;
    };
    const Case cases[] = {{2, "uniform", inputs::uniform(2, scaled(50000)), 2.5},
                          {3, "uniform", inputs::uniform(3, scaled(5000)), 3.0},
                          {4, "clifford", inputs::clifford(scaled(2000)), 3.08}};
    std::printf("\nPersistence of the complete filter on the mesh against PHAT (bit tree) on its boundary matrix; "
                "the mesh is not timed\n");
    for (const Case& c : cases) {
        std::vector<bench::Contestant> contestants = {
            [&](Trial& t) { bench::ours_persist(t, c.dim, c.points, c.tau); }};
#ifdef NETMESH_BENCH_PHAT
        contestants.push_back([&](Trial& t) { bench::phat_persist(t, c.dim, c.points, c.tau, true); });
        contestants.push_back([&](Trial& t) { bench::phat_persist(t, c.dim, c.points, c.tau, false); });
#endif
        const std::vector<Summary> s = play(contestants);
        const double n = s[0].figure(bench::simplices);
        std::printf("%dD %-8s tau %.2f  ", c.dim, c.name, c.tau);
        print_times("netmesh", s[0]);
        std::printf(", %.0f simplices of %.0f cells, %.0f ns and %.1f B above the mesh a simplex\n", n,
                    s[0].figure(bench::cells), 1e9 * s[0].seconds_median() / n, s[0].figure(bench::arena_bytes) / n);
        all_equal = all_equal && s[0].finished();
        const char* names[] = {"", "  PHAT chunk", "  PHAT twist"};
        for (std::size_t i = 1; i < s.size(); ++i) {
            print_times(names[i], s[i]);
            if (s[i].finished() && s[0].finished()) {
                std::printf(
                    " + %.3f s for the matrix, %.0f ns and %.1f B a simplex; ratio %.2f, with the matrix %.2f\n",
                    s[i].figure(bench::build_seconds), 1e9 * s[i].seconds_median() / n, s[i].bytes() / n,
                    ratio(s[0], s[i]),
                    (s[i].seconds_median() + s[i].figure(bench::build_seconds)) / s[0].seconds_median());
                expect(s[i].figure(bench::simplices) == n, "number of simplices");
                expect(equal_diagrams(s[0].runs[0].diagram, s[i].runs[0].diagram), "diagrams");
            } else {
                std::printf("\n");
            }
        }
    }
}

void alpha() {
    struct Case {
        int dim;
        inputs::Points points;
    };
    const Case cases[] = {{2, inputs::uniform(2, scaled(1e5))},
                          {3, inputs::uniform(3, scaled(2e4))},
                          {4, inputs::uniform(4, scaled(2000))},
                          {4, inputs::uniform(4, scaled(2e4))}};
    std::printf("\nAlpha complex of uniform points, from points to diagram, against GUDHI\n");
    for (const Case& c : cases) {
        std::vector<bench::Contestant> contestants = {[&](Trial& t) { bench::ours_alpha(t, c.dim, c.points); }};
#ifdef NETMESH_BENCH_GUDHI
        contestants.push_back([&](Trial& t) { bench::gudhi_alpha(t, c.dim, c.points); });
#endif
        const std::vector<Summary> s = play(contestants);
        const double n = s[0].figure(bench::simplices);
        std::printf("%dD %7zu  ", c.dim, c.points.size() / static_cast<std::size_t>(c.dim));
        print_times("netmesh", s[0]);
        std::printf(" (%.0f simplices, %.0f ns and %.0f B each)", n, 1e9 * s[0].seconds_median() / n,
                    s[0].figure(bench::arena_bytes) / n);
        all_equal = all_equal && s[0].finished();
        if (s.size() > 1) {
            print_times("; GUDHI", s[1]);
            if (s[0].finished() && s[1].finished()) {
                std::printf(" (%.0f B); ratio %.2f\n", s[1].bytes() / n, ratio(s[0], s[1]));
                expect(equal_diagrams(s[0].runs[0].diagram, s[1].runs[0].diagram), "diagrams");
                continue;
            }
        }
        std::printf("\n");
    }
}

// Uniform points; weights are squares of radii from 0 to so many mean distances of neighbours, about.
void weights() {
    std::printf("\nPoints with weights, uniform: regular triangulation against CGAL, diagram against GUDHI (3D: "
                "Alpha_complex_3d, whose components are born otherwise; degrees from 1 are compared)\n");
    for (const int dim : {2, 3})
        for (const double spacings : {0.5, 1.5}) {
            const std::size_t n = scaled(1e5);
            const inputs::Points points = inputs::uniform(dim, n);
            inputs::Points numbers = inputs::uniform(1, n, 2);
            const double most = spacings * std::pow(static_cast<double>(n), -1.0 / dim);
            for (double& w : numbers) w *= w * most * most;
            std::printf("%dD %7zu, radii to %.1f spacings\n", dim, n, spacings);
            std::vector<bench::Contestant> contestants = {
                [&](Trial& t) { bench::ours_regular(t, dim, points, numbers); }};
#ifdef NETMESH_BENCH_CGAL
            contestants.push_back([&](Trial& t) {
                dim == 2 ? bench::cgal_regular_2(t, points, numbers) : bench::cgal_regular_3(t, points, numbers);
            });
#endif
            std::vector<Summary> s = play(contestants);
            print_times("  triangulation: netmesh", s[0]);
            std::printf(" (%.0f cells, %.0f hidden)", s[0].figure(bench::cells), s[0].figure(bench::hidden));
            all_equal = all_equal && s[0].finished();
            if (s.size() > 1) {
                print_times("; CGAL", s[1]);
                std::printf("; ratio %.2f\n", ratio(s[0], s[1]));
                expect(s[0].figure(bench::cells) == s[1].figure(bench::cells), "number of cells");
                expect(s[0].figure(bench::hidden) == s[1].figure(bench::hidden), "number of hidden points");
            } else {
                std::printf("\n");
            }
            contestants = {[&](Trial& t) { bench::ours_weighted_alpha(t, dim, points, numbers); }};
#ifdef NETMESH_BENCH_GUDHI
            contestants.push_back([&](Trial& t) { bench::gudhi_weighted_alpha(t, dim, points, numbers); });
#endif
            s = play(contestants);
            print_times("  diagram: netmesh", s[0]);
            std::printf(" (%.0f simplices)", s[0].figure(bench::simplices));
            all_equal = all_equal && s[0].finished();
            if (s.size() > 1) {
                print_times("; GUDHI", s[1]);
                std::printf("; ratio %.2f\n", ratio(s[0], s[1]));
                expect(equal_diagrams(s[0].runs[0].diagram, s[1].runs[0].diagram, 1e-7 * most * most, dim == 3 ? 1 : 0),
                       "diagrams");
            } else {
                std::printf("\n");
            }
        }
}

// Uniform points in a cube.
void periods() {
    std::printf("\nPoints with all periods, uniform in a cube: our diagram against GUDHI's (3D), and against CGAL's "
                "Delaunay triangulation alone\n");
    for (const int dim : {2, 3}) {
        const std::size_t n = scaled(1e5);
        const inputs::Points points = inputs::uniform(dim, n);
        std::vector<const char*> names = {"netmesh"};
        std::vector<bench::Contestant> contestants = {[&](Trial& t) { bench::ours_periodic_alpha(t, dim, points); }};
#ifdef NETMESH_BENCH_CGAL
        names.push_back("CGAL, triangulation");
        contestants.push_back(
            [&](Trial& t) { dim == 2 ? bench::cgal_periodic_2(t, points) : bench::cgal_periodic_3(t, points); });
#endif
#ifdef NETMESH_BENCH_GUDHI
        if (dim == 3) {
            names.push_back("GUDHI, diagram");
            contestants.push_back([&](Trial& t) { bench::gudhi_periodic_alpha_3(t, points); });
        }
#endif
        const std::vector<Summary> s = play(contestants);
        std::printf("%dD %7zu  ", dim, n);
        print_times("netmesh", s[0]);
        std::printf(" (%.0f simplices)", s[0].figure(bench::simplices));
        all_equal = all_equal && s[0].finished();
        for (std::size_t i = 1; i < s.size(); ++i) {
            std::printf("; ");
            print_times(names[i], s[i]);
            if (s[0].finished() && s[i].finished()) std::printf("; ratio %.2f", ratio(s[0], s[i]));
        }
        std::printf("\n");
        // On a torus n - edges + triangles = 0 and 2 edges = 3 triangles; in space n - edges + triangles - cells = 0
        // and triangles = 2 cells.
        const double points_twice = 2 * static_cast<double>(n), all = s[0].figure(bench::simplices);
        const double cells = dim == 2 ? all / 3 : (all - points_twice) / 4;
        for (std::size_t i = 1; i < s.size() && s[0].finished() && s[i].finished(); ++i) {
            if (names[i][0] == 'C') expect(s[i].figure(bench::cells) == cells, "number of cells");
            if (names[i][0] == 'G') expect(equal_diagrams(s[0].runs[0].diagram, s[i].runs[0].diagram), "diagrams");
        }
    }
}

void print_machine() {
    std::printf("netmesh %d.%d.%d, built with %s\n", NETMESH_VERSION_MAJOR, NETMESH_VERSION_MINOR,
                NETMESH_VERSION_PATCH, __VERSION__);
    if (FILE* f = std::fopen("/proc/cpuinfo", "r")) {
        char line[256];
        while (std::fgets(line, sizeof line, f))
            if (std::strncmp(line, "model name", 10) == 0) {
                std::printf("%s", std::strchr(line, ':') + 2);
                break;
            }
        std::fclose(f);
    }
#ifdef NETMESH_BENCH_CGAL
    std::printf("CGAL %s\n", bench::cgal_version());
#else
    std::printf("CGAL is not installed\n");
#endif
#ifndef NETMESH_BENCH_TETGEN
    std::printf("TetGen's library is not installed\n");
#endif
#ifndef NETMESH_BENCH_PHAT
    std::printf("PHAT is not installed\n");
#endif
#ifndef NETMESH_BENCH_GUDHI
    std::printf("GUDHI is not installed\n");
#endif
}

}  // namespace

int main(int argc, char** argv) {
    const std::pair<const char*, void (*)()> groups[] = {{"delaunay", delaunay}, {"refine", refine},
                                                         {"persist", persist},   {"alpha", alpha},
                                                         {"weights", weights},   {"periods", periods}};
    std::vector<void (*)()> chosen;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--reps" && i + 1 < argc) {
            reps = std::max(1, std::atoi(argv[++i]));
            continue;
        }
        if (word == "--scale" && i + 1 < argc) {
            scale = std::atof(argv[++i]);
            continue;
        }
        bool known = false;
        for (const auto& [name, group] : groups)
            if (word == name) {
                chosen.push_back(group);
                known = true;
            }
        if (!known) {
            std::fprintf(
                stderr,
                "usage: %s [delaunay | refine | persist | alpha | weights | periods]... [--reps N] [--scale S]\n",
                argv[0]);
            return 2;
        }
    }
    if (chosen.empty())
        for (const auto& group : groups) chosen.push_back(group.second);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    print_machine();
    for (const auto& group : chosen) group();
    if (!all_equal) std::printf("\nSOME RESULTS DIFFER OR ARE MISSING\n");
    return all_equal ? 0 : 1;
}
