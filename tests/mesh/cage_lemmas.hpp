// Definitions and lemmas of 4.5 to 4.11 on a mesh with cages as the thesis has them, by plain loops over all vertices,
// cells and cages. Nothing is clipped, and nothing of the mesher's is used but the store and the list of cages.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "delaunay/store.hpp"

namespace lemmas {

constexpr double endless = std::numeric_limits<double>::infinity();

// Worst value over bound of what a lemma says; it holds where that is at most 1.
struct Row {
    double worst = 0;
    std::uint64_t checked = 0, violations = 0;
};

// By name. A row that has no bound is offered with bound infinity and keeps its largest value in `largest`.
struct Table {
    std::map<std::string, Row> rows;
    std::map<std::string, double> largest;

    void offer(const std::string& lemma, double value, double bound) {
        Row& row = rows[lemma];
        const double ratio = value / bound;
        ++row.checked;
        row.worst = std::max(row.worst, ratio);
        row.violations += !(ratio <= 1 + 1e-9);
    }
    void note(const std::string& what, double value) {
        double& most = largest[what];
        most = std::max(most, value);
    }
    std::uint64_t violations() const {
        std::uint64_t sum = 0;
        for (const auto& [name, row] : rows) sum += row.violations;
        return sum;
    }
    std::string violated() const {
        std::string names;
        for (const auto& [name, row] : rows)
            if (row.violations > 0) names += (names.empty() ? "" : ", ") + name;
        return names;
    }
    void join(const Table& other) {
        for (const auto& [name, row] : other.rows) {
            Row& own = rows[name];
            own.worst = std::max(own.worst, row.worst);
            own.checked += row.checked;
            own.violations += row.violations;
        }
        for (const auto& [name, value] : other.largest) note(name, value);
    }
};

// Constants of the cages, in the words of engine/decisions/cages-of-the-thesis.md; written down a second time.
template <int D> struct Constants {
    double epsilon = 0.3;     // inputs within epsilon r, vertices beyond 2 r / epsilon
    double sphere = 0.64;     // the shell's sphere, in r
    double gamma = 1.0 / 16;  // how far a shell vertex is from its place, in radii of that sphere
    double yields = 0.9;      // a Steiner point yields within this of its empty ball
    double slack = 1.125;     // a new cage over what the thesis asks for
    double annulus = 1.125;   // 4.11.8 from this times epsilon r on, where the thesis has 2
    double covering = D == 2 ? 0.19604 : D == 3 ? 0.36284 : 0.38574;  // chords, of the template alone
    double packing = D == 2 ? 0.39018 : D == 3 ? 0.54653 : 0.61803;
    double inner = D == 2 ? 0.50 : D == 3 ? 0.40 : 0.38;  // B' of 4.11.1, in r

    // K'_C, K'_S, K'_I and K, see engine/decisions/cages-of-the-thesis.md.
    double k_cage, k_steiner, k_input, k;
    explicit Constants(double tau) {
        const double half = 1 - epsilon / 2, packed = (packing - 2 * gamma) * sphere;
        k_cage = (sphere * (1 + gamma) + epsilon) / std::min(packed, sphere * (1 - gamma) - epsilon);
        const double yielded = (sphere * (1 + gamma) + epsilon) / (gamma * sphere * 0.9) + 1;
        k_steiner = k_input = k = 0;
        for (int i = 0; i < 2000; ++i) {
            k_input = std::max({k_steiner / yields + 1, yielded, k_cage});
            k = std::max(k_input, k_steiner) / half + 1;
            k_steiner = (2 * k / (tau * half) + 1) / (1 - epsilon / tau);
        }
    }
};

struct Ball {
    std::uint32_t centre;
    double radius;
};

// What an audit of quality says, of one mesh.
struct Figures {
    double worst = 0, feature = 0, cage = 0, steiner = 0, input = 0;
    std::uint32_t degree = 0;
    bool encroached = false;

    void join(const Figures& other) {
        for (double Figures::*const f :
             {&Figures::worst, &Figures::feature, &Figures::cage, &Figures::steiner, &Figures::input})
            this->*f = std::max(this->*f, other.*f);
        degree = std::max(degree, other.degree);
    }
};

template <int D> class Judge {
public:
    // `clean`: the quality of all cells has been restored.
    Judge(const netmesh::Store<D>& store, std::vector<Ball> cages, double tau, bool clean, Table* table)
        : store_(store), cages_(std::move(cages)), tau_(tau), clean_(clean), is_(tau), table_(*table) {
        const std::uint32_t n = store.state.vertex_count;
        in_mesh_.assign(n, false);
        near_.assign(n, endless);
        far_.assign(n, 0);
        degree_.assign(n, {});
        for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
            if (!is_finite(c)) continue;
            const auto& cell = store.cell(c);
            const Sphere sphere = sphere_of(c, cell.vertex[0]);
            for (int i = 0; i <= D; ++i) {
                const std::uint32_t v = cell.vertex[i];
                in_mesh_[v] = true;
                if (sphere.known) far_[v] = std::max(far_[v], sphere.radius);
                for (int j = 0; j <= D; ++j) {
                    if (j == i) continue;
                    near_[v] = std::min(near_[v], away(v, point(cell.vertex[j])));
                    degree_[v].push_back(cell.vertex[j]);
                }
            }
        }
        for (std::uint32_t v = 0; v < n; ++v) {
            domain_.push_back(innermost(point(v), 0));
            std::sort(degree_[v].begin(), degree_[v].end());
            degree_[v].erase(std::unique(degree_[v].begin(), degree_[v].end()), degree_[v].end());
        }
        for (const Ball& cage : cages_) parent_.push_back(innermost(point(cage.centre), cage.radius));
        members_.resize(cages_.size() + 1);
        for (std::uint32_t v = 0; v < n; ++v)
            if (in_mesh_[v] && domain_[v] >= 0) members_[domain_[v]].push_back(v);
        for (std::size_t d = 0; d < cages_.size(); ++d) {
            const std::uint32_t c = cages_[d].centre;
            if (parent_[d] >= 0 && domain_[c] != parent_[d]) members_[parent_[d]].push_back(c);
        }
    }

    // All of it, for a mesh at rest.
    void judge() {
        for (std::size_t d = 0; d < cages_.size(); ++d) {
            judge_shell(d);
            judge_cage(d);
            judge_domain(d);
        }
        judge_vertices();
        judge_balls();
    }

    // Figures of which the thesis says no more than that they are bounded: of all vertices but those of the frame the
    // degree (4.11.7) and the cells that they are in (4.11.6), of D-balls within the outermost cage how many contain
    // the centre of one (4.11.5) and how many meet one (4.11.9). Of large meshes a sample of the balls is looked at.
    void count() {
        std::vector<Sphere> spheres;
        std::vector<std::uint32_t> cells(store_.state.vertex_count, 0);
        for (std::uint32_t c = 0; c < store_.state.cell_slots; ++c) {
            if (!is_finite(c)) continue;
            for (const std::uint32_t v : store_.cell(c).vertex) ++cells[v];
            const Sphere sphere = sphere_of(c, store_.cell(c).vertex[0]);
            double centre[D];
            for (int k = 0; k < D; ++k) centre[k] = double(sphere.centre[k] + point(sphere.base)[k]);
            if (sphere.known && innermost(centre, 0) >= 0) spheres.push_back(sphere);
        }
        for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) {
            if (!in_mesh_[v] || domain_[v] < 0) continue;
            table_.note("4.11.6 cells at a vertex", cells[v]);
            table_.note("4.11.7 degree", double(degree_[v].size()));
        }
        for (std::size_t a = 0; a < spheres.size(); a += 1 + spheres.size() / 300) {
            std::uint32_t containing = 0, meeting = 0;
            for (const Sphere& other : spheres) {
                long double apart2 = 0;
                for (int k = 0; k < D; ++k) {
                    const long double d = ((long double)(point(spheres[a].base)[k]) - point(other.base)[k]) +
                                          (spheres[a].centre[k] - other.centre[k]);
                    apart2 += d * d;
                }
                const double apart = double(std::sqrt(apart2));
                containing += apart < other.radius;
                meeting += apart < other.radius + spheres[a].radius;
            }
            table_.note("4.11.5 balls at a point", containing);
            table_.note("4.11.9 balls that meet one", meeting);
        }
    }

    // Of the whole mesh. fresh: what has been inserted, `own` of it in its turn or, `cleaning`, in place of a bad
    // corner. f_M is taken over Delaunay neighbours. To be called on a judge with a table of its own.
    Figures figures(const std::vector<std::uint32_t>& fresh, std::uint32_t own, bool cleaning) {
        Figures of;
        for (std::size_t d = 0; d < cages_.size(); ++d) {
            judge_cage(d);
            if (is_root(d)) continue;
            std::vector<std::uint32_t> around;
            for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v)
                if (in_mesh_[v] && away(v, point(cages_[d].centre)) < cages_[d].radius)
                    around.insert(around.end(), degree_[v].begin(), degree_[v].end());
            of.feature = std::max(of.feature, feature_of(cages_[d].centre, parent_[d], around));
        }
        of.worst = table_.largest["aspect ratio of a cage"];
        for (const char* const rule :
             {"4.5 domains are nested", "4.5 not encroached from inside", "4.5 not encroached from outside"})
            of.encroached |= table_.rows[rule].violations > 0;
        for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) {
            if (!in_mesh_[v] || domain_[v] < 0) continue;
            of.degree = std::max(of.degree, std::uint32_t(degree_[v].size()));
            of.feature = std::max(of.feature, feature_of(v, domain_[v], degree_[v]));
            if (!is_of_shell(v)) of.worst = std::max(of.worst, 2 * far_[v] / near_[v]);
        }
        for (const std::uint32_t v : fresh) {
            if (domain_[v] < 0) continue;
            double& kind = v != own ? of.cage : cleaning ? of.steiner : of.input;
            kind = std::max(kind, feature_of(v, domain_[v], degree_[v]));
        }
        return of;
    }

    // K' of 4.9: v has just been inserted.
    void judge_insertion(std::uint32_t v) {
        if (!in_mesh_[v] || domain_[v] < 0) return;
        // The centre of a child is in its parent's domain too; it was inserted into the innermost there was.
        const double lambda = two_nearest(domain_[v], point(v)).second;
        const double input = two_nearest(domain_[v], point(v), true).second;
        if (!(input < endless)) return;
        const bool shell = is_of_shell(v);
        const char* const what = shell         ? "4.9 K' of shells"
                                 : is_input(v) ? "4.9 K' of inputs"
                                               : "4.9 K' of Steiner points";
        table_.offer(what, input, (shell ? is_.k_cage : is_input(v) ? is_.k_input : is_.k_steiner) * lambda);
    }

    // 4.9.3, for all pairs of inputs, when all are in.
    void judge_gaps(std::uint32_t inputs) {
        const double outer = 8 * is_.k / std::pow(is_.epsilon, 3) + 2;
        for (std::uint32_t q = 0; q < inputs; ++q)
            for (std::uint32_t p = 0; p < inputs; ++p) {
                if (p == q) continue;
                const double r = away(q, point(p));
                bool empty = true, far = false;
                for (std::uint32_t x = 0; x < inputs && empty; ++x) {
                    const double d = away(q, point(x));
                    empty = !(d > 2 * r && d < outer * r);
                    far |= d >= outer * r;
                }
                if (!empty || !far) continue;
                double least = endless;
                for (const Ball& cage : cages_)
                    if (away(cage.centre, point(q)) < cage.radius && away(cage.centre, point(p)) < cage.radius)
                        least = std::min(least, away(cage.centre, point(q)) + cage.radius);
                table_.offer("4.9.3 inputs with a gap are in a cage", least, outer * r);
            }
    }

private:
    // The D-ball of cell c, its centre relative to one of its vertices, by elimination. The engine's own balls are good
    // to a part of their radius, which may be many times a cage.
    struct Sphere {
        std::uint32_t base;
        long double centre[D];
        double radius;
        bool known;

        // How far from point x it begins, negative when x is inside; `x`: relative to base.
        double gap(const long double* x) const {
            long double norm2 = 0, along = 0, to2 = 0, own2 = 0;
            for (int k = 0; k < D; ++k) {
                norm2 += x[k] * x[k];
                along += x[k] * centre[k];
                to2 += (x[k] - centre[k]) * (x[k] - centre[k]);
                own2 += centre[k] * centre[k];
            }
            return double((norm2 - 2 * along) / (std::sqrt(to2) + std::sqrt(own2)));
        }
        // How far from x it ends.
        double end(const long double* x) const {
            long double to2 = 0;
            for (int k = 0; k < D; ++k) to2 += (x[k] - centre[k]) * (x[k] - centre[k]);
            return double(std::sqrt(to2)) + radius;
        }
    };
    Sphere sphere_of(std::uint32_t c, std::uint32_t base) const {
        Sphere sphere = {base, {}, 0, true};
        long double row[D][D + 1];
        int rows = 0;
        for (const std::uint32_t v : store_.cell(c).vertex) {
            if (v == base) continue;
            long double norm = 0;
            for (int k = 0; k < D; ++k) {
                row[rows][k] = (long double)(point(v)[k]) - point(base)[k];
                norm += row[rows][k] * row[rows][k];
            }
            norm = std::sqrt(norm);
            for (int k = 0; k < D; ++k) row[rows][k] /= norm;
            row[rows++][D] = norm / 2;
        }
        for (int i = 0; i < D; ++i) {
            int best = i;
            for (int j = i + 1; j < D; ++j)
                if (std::abs(row[j][i]) > std::abs(row[best][i])) best = j;
            std::swap_ranges(row[i], row[i] + D + 1, row[best]);
            if (!(std::abs(row[i][i]) > 1e-13L)) sphere.known = false;
            if (!sphere.known) return sphere;
            for (int j = 0; j < D; ++j) {
                if (j == i) continue;
                const long double f = row[j][i] / row[i][i];
                for (int k = i; k <= D; ++k) row[j][k] -= f * row[i][k];
            }
        }
        long double norm = 0;
        for (int k = 0; k < D; ++k) {
            sphere.centre[k] = row[k][D] / row[k][k];
            norm += sphere.centre[k] * sphere.centre[k];
        }
        sphere.radius = double(std::sqrt(norm));
        return sphere;
    }
    // The same about the vertex of the cell nearest to vertex u, which is then at `to` from it.
    Sphere sphere_near(std::uint32_t c, std::uint32_t u, long double* to) const {
        std::uint32_t base = store_.cell(c).vertex[0];
        for (const std::uint32_t v : store_.cell(c).vertex)
            if (away(v, point(u)) < away(base, point(u))) base = v;
        for (int k = 0; k < D; ++k) to[k] = (long double)(point(u)[k]) - point(base)[k];
        return sphere_of(c, base);
    }

    const double* point(std::uint32_t v) const { return store_.point(v); }
    double away(std::uint32_t v, const double* x) const {
        double sum = 0;
        for (int k = 0; k < D; ++k) sum += (point(v)[k] - x[k]) * (point(v)[k] - x[k]);
        return std::sqrt(sum);
    }
    bool is_finite(std::uint32_t c) const { return store_.is_live(c) && !store_.is_ghost(c); }
    int innermost(const double* x, double above) const {
        int found = -1;
        for (std::size_t d = 0; d < cages_.size(); ++d)
            if (cages_[d].radius > above && away(cages_[d].centre, x) < cages_[d].radius &&
                (found < 0 || cages_[d].radius < cages_[found].radius))
                found = int(d);
        return found;
    }
    bool is_input(std::uint32_t v) const { return store_.vertex(v).marker == netmesh::Marker::input; }
    bool is_root(std::size_t d) const { return parent_[d] < 0; }
    // Of the shell of its own domain: all exempt vertices, and inputs beyond epsilon r, which it has yielded to.
    bool is_of_shell(std::uint32_t v) const {
        if (domain_[v] < 0 || !is_input(v)) return store_.vertex(v).marker == netmesh::Marker::exempt;
        const Ball& cage = cages_[domain_[v]];
        return away(v, point(cage.centre)) > is_.epsilon * cage.radius * (1 + 1e-9);
    }

    void judge_shell(std::size_t d) {
        const Ball& cage = cages_[d];
        const double radius = is_.sphere * cage.radius;
        std::vector<std::uint32_t> shell;
        for (const std::uint32_t v : members_[d])
            if (domain_[v] == int(d) && is_of_shell(v)) shell.push_back(v);
        table_.offer("4.5 a cage has a shell", D + 1, double(shell.size()));
        for (const std::uint32_t v : shell) {
            table_.offer("4.5 nearness", std::abs(away(v, point(cage.centre)) - radius), is_.gamma * radius);
            if (is_root(d)) continue;
            for (const std::uint32_t w : shell)
                if (w < v) table_.offer("4.5 packing", (is_.packing - 2 * is_.gamma) * radius, away(v, point(w)));
        }
        std::uint64_t random = d + 1;
        for (int turn = 0; turn < 200; ++turn) {
            double x[D], norm = 0;
            for (double& y : x) {
                random = random * 6364136223846793005u + 1442695040888963407u;
                y = double(random >> 11) / double(std::uint64_t{1} << 52) - 1;
                norm += y * y;
            }
            if (!(norm > 0.01 && norm < 1)) continue;
            double nearest = endless;
            for (int k = 0; k < D; ++k) x[k] = point(cage.centre)[k] + x[k] / std::sqrt(norm) * radius;
            for (const std::uint32_t v : shell) nearest = std::min(nearest, away(v, x));
            table_.offer("4.5 covering", nearest, (is_.covering + is_.gamma) * radius);
        }
    }

    void judge_cage(std::size_t d) {
        const Ball& cage = cages_[d];
        if (!is_root(d)) {
            const Ball& around = cages_[parent_[d]];
            table_.offer("4.5 domains are nested", away(cage.centre, point(around.centre)) + cage.radius,
                         around.radius);
        }
        for (std::size_t e = 0; e < d; ++e)
            if (parent_[e] == parent_[d])
                table_.offer("4.5 domains are disjoint", cage.radius + cages_[e].radius,
                             away(cage.centre, point(cages_[e].centre)));
        table_.offer("4.5 the centre is an input", is_input(cage.centre) && in_mesh_[cage.centre] ? 0 : 2, 1);
        double feature = endless;
        for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) {
            if (!in_mesh_[v]) continue;
            const double away_v = away(v, point(cage.centre));
            if (away_v < cage.radius) {
                if (is_input(v) && !(domain_[v] == int(d) && is_of_shell(v)))
                    table_.offer("4.5 not encroached from inside", away_v, is_.epsilon * cage.radius);
                continue;
            }
            feature = std::min(feature, away_v);
            table_.offer("4.5 not encroached from outside", 2 * cage.radius / is_.epsilon, away_v);
        }
        if (is_root(d)) return;
        double reach = 0, inside = endless;
        std::vector<std::pair<std::uint32_t, double>> outer;  // what the cell of the cage has for neighbours
        for (std::uint32_t c = 0; c < store_.state.cell_slots; ++c) {
            if (!is_finite(c)) continue;
            const auto& cell = store_.cell(c);
            for (const std::uint32_t u : cell.vertex) {
                if (away(u, point(cage.centre)) < cage.radius) continue;
                double most = 0;
                for (const std::uint32_t s : cell.vertex)
                    if (away(s, point(cage.centre)) < cage.radius) {
                        // Of the plane between s and u from the centre.
                        double at = 0, norm = 0;
                        for (int k = 0; k < D; ++k) {
                            const double e = point(u)[k] - point(s)[k];
                            at += e * ((point(u)[k] + point(s)[k]) / 2 - point(cage.centre)[k]);
                            norm += e * e;
                        }
                        most = std::max(most, at / std::sqrt(norm));
                    }
                if (most > 0) outer.push_back({u, most});
                long double to[D];
                const Sphere sphere = sphere_near(c, cage.centre, to);
                if (most > 0 && sphere.known) reach = std::max(reach, sphere.end(to) - sphere.radius);
            }
        }
        // A point in the cell of u is beyond all planes between u and what is in the cage.
        std::map<std::uint32_t, double> planes;
        for (const auto& [u, most] : outer) planes[u] = std::max(planes[u], most);
        for (const auto& [u, most] : planes) inside = std::min(inside, most);
        const std::string quality = "4.5 quality of cages";
        table_.note("aspect ratio of a cage", 2 * reach / feature);
        if (clean_) table_.offer(quality, 2 * reach / feature, tau_);
        table_.offer("4.6.2 cages: f_M <= 3 r", feature, 3 * inside);
        table_.offer("4.6.2 cages: r <= f_M", (feature + is_.sphere * (1 + is_.gamma) * cage.radius) / 2, feature);
    }

    // Distances to the two nearest points of M_Omega, or of P_Omega.
    std::pair<double, double> two_nearest(int d, const double* x, bool inputs = false) const {
        double first = endless, second = endless;
        for (const std::uint32_t v : members_[d]) {
            if (inputs && !is_input(v)) continue;
            const double a = away(v, x);
            second = std::min(second, std::max(first, a));
            first = std::min(first, a);
        }
        return {first, second};
    }
    // f_P over f_M, of which those among these neighbours count; 0 where one of them is not there.
    double feature_of(std::uint32_t v, int d, const std::vector<std::uint32_t>& neighbours) const {
        double nearest = endless;
        for (const std::uint32_t w : neighbours) {
            int within = domain_[w], below = -1;
            for (; within >= 0 && within != d; within = parent_[within]) below = within;
            if (within < 0) continue;
            const std::uint32_t member = below < 0 ? w : cages_[below].centre;
            if (member != v) nearest = std::min(nearest, away(member, point(v)));
        }
        const double input = two_nearest(d, point(v), true).second;
        return input < endless && nearest < endless ? input / nearest : 0;
    }
    // The child of d that has vertex v for its centre.
    int child_about(int d, std::uint32_t v) const {
        for (std::size_t e = 0; e < cages_.size(); ++e)
            if (parent_[e] == d && cages_[e].centre == v) return int(e);
        return -1;
    }

    void judge_domain(std::size_t d) {
        const Ball& cage = cages_[d];
        std::uint32_t between = 0;
        std::vector<double> weight;
        for (const std::uint32_t v : members_[d]) {
            const int e = child_about(int(d), v);
            weight.push_back(e < 0 ? 0 : cages_[e].radius);
        }
        // 4.6.1 with this domain's children as weighted points; its premise is non-encroachment.
        double premise = 0;
        for (std::size_t a = 0; a < weight.size(); ++a)
            for (std::size_t b = 0; b < weight.size() && weight[a] > 0; ++b)
                if (a != b)
                    premise = std::max(premise, weight[a] / (away(members_[d][a], point(members_[d][b])) - weight[b]));
        table_.offer("4.6.1 premise: weights at most epsilon", premise, is_.epsilon);
        // Of large domains a sample.
        for (std::size_t a = 0; a < weight.size(); a += 1 + weight.size() / 200) {
            const std::uint32_t v = members_[d][a];
            double twice = endless, nearest = endless;
            for (std::size_t b = 0; b < weight.size(); ++b) {
                if (a == b) continue;
                const double far = away(v, point(members_[d][b]));
                twice = std::min(twice, far - weight[b]);
                nearest = std::min(nearest, far);
            }
            twice += weight[a];
            if (!(nearest < endless)) continue;
            table_.offer("4.6.1 lower", twice * (1 - is_.epsilon) / (1 + is_.epsilon), nearest);
            table_.offer("4.6.1 upper", nearest, twice / (1 - is_.epsilon));
            // Vertices that are no centres of children, whose cells are plain.
            if (weight[a] == 0 && !is_of_shell(v)) {
                table_.offer("4.6.2 vertices: f_M <= 3 r", nearest, 1.5 * near_[v]);
                table_.offer("4.6.2 vertices: r <= f_M", near_[v] / 2, nearest);
            }
            const double input = two_nearest(int(d), point(v), true).second;
            if (input < endless) {
                table_.offer("4.8 feature size invariant", input, is_.k * nearest);
                table_.note("K", input / nearest);
            }
        }
        for (const std::uint32_t v : members_[d]) {
            const double from = away(v, point(cage.centre));
            between += from > is_.annulus * is_.epsilon * cage.radius && from < cage.radius;
        }
        table_.note("vertices between e r and r of a cage", is_root(d) ? 0 : between);
        const double share = (is_.annulus - 1) * is_.epsilon / (2 * is_.k);
        if (!is_root(d)) table_.offer("4.11.8 few vertices in the annulus", between, std::pow(1 + 1 / share, D));
    }

    void judge_vertices() {
        for (std::uint32_t v = 0; v < store_.state.vertex_count; ++v) {
            if (!in_mesh_[v] || is_of_shell(v)) continue;
            table_.note("degree", double(degree_[v].size()));
            const double ratio = 2 * far_[v] / near_[v];
            table_.note("aspect ratio of a vertex", ratio);
            if (clean_) table_.offer("4.5 quality of vertices", ratio, tau_);
        }
    }

    void judge_balls() {
        const std::uint32_t stride = 1 + store_.state.cell_slots / 100;
        for (std::uint32_t c = 0; c < store_.state.cell_slots; ++c) {
            if (!is_finite(c)) continue;
            for (std::size_t d = 0; d < cages_.size(); ++d) {
                long double to[D];
                const Sphere sphere = sphere_near(c, cages_[d].centre, to);
                if (!sphere.known) continue;
                const double gap = sphere.gap(to), end = sphere.end(to);
                if (gap < is_.inner * cages_[d].radius)
                    table_.offer("4.11.1 D-balls of inner balls stay in", end, cages_[d].radius);
                if (gap < cages_[d].radius && !is_root(d)) {
                    const Sphere same = sphere_near(c, cages_[parent_[d]].centre, to);
                    table_.offer("4.11.2 no D-ball meets a domain and its grandparent", same.end(to),
                                 cages_[parent_[d]].radius);
                }
            }
            if (c % stride == 0) judge_ball(c);
        }
    }

    // 4.11.3 and 4.11.4 at the centre of a D-ball and at points between it and its vertices.
    void judge_ball(std::uint32_t c) {
        const auto& cell = store_.cell(c);
        const Sphere sphere = sphere_of(c, cell.vertex[0]);
        if (!sphere.known) return;
        double centre[D];
        for (int k = 0; k < D; ++k) centre[k] = double(sphere.centre[k] + point(cell.vertex[0])[k]);
        for (int turn = 0; turn <= D + 1; ++turn) {
            double x[D];
            for (int k = 0; k < D; ++k)
                x[k] = turn == 0 ? centre[k] : (centre[k] + 3 * point(cell.vertex[turn - 1])[k]) / 4;
            for (int d = innermost(centre, 0); clean_ && d >= 0; d = parent_[d]) {
                const double f = two_nearest(d, x).second;
                if (f < endless) table_.offer("4.11.3 f_M in empty balls", sphere.radius / (24 * tau_ * tau_), f);
            }
            std::map<int, std::pair<double, double>> of;
            for (const std::uint32_t u : cell.vertex)
                for (int d = domain_[u], below = -1; d >= 0; below = d, d = parent_[d]) {
                    if (of.count(d) == 0) of[d] = two_nearest(d, x);
                    const std::uint32_t ancestor = below < 0 ? u : cages_[below].centre;
                    if (!(of[d].second < endless) || away(ancestor, x) <= of[d].first) continue;
                    table_.offer("4.11.4 f_M in D-balls between domains", of[d].second, 3 * sphere.radius);
                }
        }
    }

    const netmesh::Store<D>& store_;
    std::vector<Ball> cages_;
    double tau_;
    bool clean_;
    Constants<D> is_;
    Table& table_;
    std::vector<bool> in_mesh_;
    std::vector<double> near_, far_;  // nearest distance, out-radius
    std::vector<int> domain_, parent_;
    std::vector<std::vector<std::uint32_t>> degree_, members_;
};

}  // namespace lemmas
