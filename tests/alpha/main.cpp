// Diagrams of alpha complexes against the truth in rational arithmetic, pair by pair, on point sets that are nearly
// degenerate in some way.
//
//   alpha_truth [SETS]      60 sets; 1,000 take some minutes
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "exact/families.hpp"
#include "truth.hpp"

namespace {

using Engine = std::mt19937_64;

double unit(Engine& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }
int whole(Engine& engine, int from, int to) {
    return from + static_cast<int>(engine() % static_cast<std::uint64_t>(to - from + 1));
}
// Some units in the last place away.
double nudged(double x, int units) {
    for (; units > 0; --units) x = std::nextafter(x, HUGE_VAL);
    for (; units < 0; ++units) x = std::nextafter(x, -HUGE_VAL);
    return x;
}

struct Kind {
    const char* name;
    void (*make)(Engine&, std::size_t dim, std::vector<double>& point);
};

// Coordinates of one point; sets are made of points drawn by one kind, different ones.
const Kind kinds[] = {
    {"small integers",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         for (double& x : p) x = whole(e, 0, 2);
     }},
    {"right angles nudged",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         for (double& x : p) x = nudged(whole(e, 1, 3), whole(e, -1, 1));
     }},
    {"nearly cospherical",
     [](Engine& e, std::size_t dim, std::vector<double>& p) {
         const double circle[][2] = {{3, 4}, {4, 3}, {5, 0}, {0, 5}, {-3, 4}, {-4, -3}, {3, -4}, {-5, 0}};
         const auto& at = circle[whole(e, 0, 7)];
         const std::size_t first = static_cast<std::size_t>(whole(e, 0, static_cast<int>(dim) - 2));
         for (double& x : p) x = 0;
         p[first] = nudged(7 + at[0], whole(e, -2, 2)) - 7;
         p[first + 1] = nudged(7 + at[1], whole(e, -2, 2)) - 7;
     }},
    {"grid of tenths",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         for (double& x : p) x = 0.1 * whole(e, 0, 3);
     }},
    {"bent grid",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         double bend = 0;
         for (double& x : p) x = whole(e, 0, 2), bend += x * x;
         p[0] += 0x1p-45 * bend;
     }},
    {"flat",
     [](Engine& e, std::size_t dim, std::vector<double>& p) {
         for (double& x : p) x = unit(e);
         p[dim - 1] *= std::ldexp(1, -whole(e, 5, 40));
     }},
    {"clusters",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         for (double& x : p) x = 0.25 + 0.5 * whole(e, 0, 1) + 0x1p-40 * unit(e);
     }},
    {"far away",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         for (double& x : p) x = 0x1p48 + std::ldexp(std::floor(unit(e) * 64), -4);
     }},
    {"near the diameter",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         static const double h[] = {.500001, .5, .50000000001};
         for (double& x : p) x = whole(e, 0, 1);
         if (whole(e, 0, 1) != 0) {
             for (double& x : p) x = .5;
             p[0] = h[whole(e, 0, 2)];
         }
         if (whole(e, 0, 2) == 0) p[1] += std::ldexp(1, -whole(e, 20, 50));
     }},
    {"many in one double",  // pairs across a gap, whose distances differ by far less than a double tells
     [](Engine& e, std::size_t dim, std::vector<double>& p) {
         for (double& x : p) x = std::ldexp(whole(e, 0, dim > 2 ? 3 : 60), -46);
         p[0] = whole(e, 0, 1);
     }},
    {"flat triangles",  // three of them, alike but for an ulp
     [](Engine& e, std::size_t dim, std::vector<double>& p) {
         static const double corner[][2] = {{0, 0}, {.3, nudged(0x1.5p-9, 1)}, {1, 0}};
         const auto& at = corner[whole(e, 0, 2)];
         const double turn = .1 * whole(e, 0, 2);
         p[0] = 64 * turn + at[0] - turn * at[1];
         p[1] = nudged(1 + turn * at[0] + at[1], whole(e, -1, 1));
         if (dim > 2) p[dim - 1] = 0x1.7p-8 * whole(e, 0, 1);
     }},
    {"anywhere",
     [](Engine& e, std::size_t, std::vector<double>& p) {
         for (double& x : p) x = unit(e);
     }},
};

// |x - sqrt(square)| <= error sqrt(square), exactly.
bool is_within(double x, double error, const mpq_class& square) {
    const mpq_class reported(x), e(error), low = 1 - e, high = 1 + e;
    return reported * reported >= low * low * square && reported * reported <= high * high * square;
}

struct Outcome {
    std::size_t bars = 0, shortest = 0;  // of less than 2^-36 of their death
    std::string fault;
};

Outcome compare(std::size_t dim, const std::vector<double>& x) {
    Outcome out;
    const std::size_t n = x.size() / dim;
    Session session(static_cast<int>(dim));
    const netmesh_status status = session.alpha(x);
    if (status == NETMESH_FLAT) return out;
    if (status != NETMESH_OK) {
        out.fault = "status " + std::to_string(status);
        return out;
    }
    std::vector<truth::Point> points(n, truth::Point(dim));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < dim; ++c) points[i][c] = x[i * dim + c];
    const truth::Diagram theirs = truth::diagram(points);
    std::vector<std::vector<netmesh_pair>> ours(dim);
    for (const netmesh_pair& pair : session.pairs()) ours.at(pair.degree).push_back(pair);
    const double error = session.report().diagram.value_error;
    if (!(error > 0 && error < 0x1p-28)) out.fault = "an error that says nothing";
    for (std::size_t k = 0; k < dim && out.fault.empty(); ++k) {
        const std::string degree = "degree " + std::to_string(k) + ": ";
        if (ours[k].size() != theirs[k].size())
            out.fault = degree + std::to_string(ours[k].size()) + " bars for " + std::to_string(theirs[k].size());
        for (std::size_t i = 0; i < ours[k].size() && out.fault.empty(); ++i) {
            const netmesh_pair& a = ours[k][i];
            const truth::Bar& b = theirs[k][i];
            ++out.bars;
            const bool essential = !(a.death < HUGE_VAL);
            if (essential != b.essential || !(a.birth < a.death) || !is_within(a.birth, error, b.birth) ||
                (!essential && !is_within(a.death, error, b.death)))
                out.fault = degree + "bar " + std::to_string(i) + " is another";
            out.shortest += a.death - a.birth <= 0x1p-36 * a.death;
        }
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t sets = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 60;
    const std::size_t count = sizeof kinds / sizeof kinds[0];
    std::size_t bars = 0, shortest = 0, faults = 0;
    for (std::size_t set = 0; set < sets; ++set) {
        const Kind& kind = kinds[set % count];
        const std::size_t round = set / count, dim = netmesh::serves_dimension(4) && round % 5 == 4 ? 4 : 2 + round % 2;
        const std::size_t n = dim == 2 ? 10 : dim == 3 ? 9 : 8;
        Engine engine(set + 1);
        std::set<std::vector<double>> distinct;
        std::vector<double> point(dim), x;
        for (int tries = 0; tries < 1000 && distinct.size() < n; ++tries) {
            kind.make(engine, dim, point);
            if (distinct.insert(point).second) x.insert(x.end(), point.begin(), point.end());
        }
        if (round % 4 == 3) x = families::moved(x, 3, set);
        const Outcome outcome = compare(dim, x);
        bars += outcome.bars;
        shortest += outcome.shortest;
        if (outcome.fault.empty()) continue;
        ++faults;
        std::printf("set %zu, %s, %zuD: %s\n", set, kind.name, dim, outcome.fault.c_str());
        if (faults == 1)
            for (std::size_t i = 0; i < x.size(); ++i) std::printf("%.17g%c", x[i], (i + 1) % dim == 0 ? '\n' : ' ');
    }
    std::printf("%zu sets, %zu bars, %zu of them below 2^-36 of their death; %zu faults\n", sets, bars, shortest,
                faults);
    return faults == 0 && shortest > 0 && bars > sets ? 0 : 1;
}
