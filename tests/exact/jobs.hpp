// The calls whose values are exact, on one cloud, and what they should return. Of the engine nothing but its C
// interface is used.
#pragma once
#include <netmesh.h>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "truth.hpp"

namespace exact {

// A block that all calls use one after the other.
class Block {
public:
    Block() : memory_(std::aligned_alloc(16, bytes)) {
        if (memory_ == nullptr) throw std::bad_alloc();
    }
    ~Block() { std::free(memory_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

    // A context without anything.
    netmesh_context* fresh() const {
        netmesh_context* context = nullptr;
        if (netmesh_init(memory_, bytes, &context) != NETMESH_OK) throw std::bad_alloc();
        return context;
    }

private:
    static constexpr std::size_t bytes = std::size_t(256) << 20;  // pages that are not touched cost nothing
    void* memory_;
};

struct Answer {
    netmesh_status status = NETMESH_OK;
    Bars bars;          // as the call sorts them
    std::string fault;  // of what else was read
};

inline Bars read_bars(const netmesh_context* context) {
    Bars bars;
    netmesh_pair pair;
    pair.struct_bytes = sizeof pair;
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i)
        bars.push_back({pair.degree, pair.birth, pair.death});
    return bars;
}

// The value of each simplex of each representative, by `value_of(set, &value)`: false where there is no such simplex.
template <class ValueOf>
std::string fault_of_cycles(const netmesh_context* context, std::size_t pairs, ValueOf value_of) {
    netmesh_simplex simplex;
    simplex.struct_bytes = sizeof simplex;
    for (std::uint64_t pair = 0; pair < pairs; ++pair) {
        std::uint64_t count = 0;
        if (netmesh_get_cycle(context, pair, &count) != NETMESH_OK) return "a pair has no representative";
        for (std::uint64_t i = 0; i < count; ++i) {
            if (netmesh_get_cycle_simplex(context, pair, i, &simplex) != NETMESH_OK) return "a simplex is missing";
            Set set = 0;
            std::string name;
            for (std::uint32_t v = 0; v <= simplex.degree; ++v) {
                set |= Set(1) << simplex.vertices[v];
                name += " " + std::to_string(simplex.vertices[v]);
            }
            double value = 0;
            if (!value_of(set, &value)) return "the complex has no simplex" + name;
            char text[100];
            std::snprintf(text, sizeof text, " enters at %a, not at %a", value, simplex.value);
            if (bits_of(value) != bits_of(simplex.value)) return "simplex" + name + text;
        }
    }
    return "";
}

inline netmesh_request request_of(int dim, const std::vector<double>& x, const netmesh_filter* filter) {
    netmesh_request request = netmesh_default_request();
    request.points.coordinates = x.data();
    request.points.count = x.size() / static_cast<std::size_t>(dim);
    request.points.dim = static_cast<std::uint32_t>(dim);
    request.filter = filter;
    return request;
}

inline Answer ask_alpha(const Block& block, int dim, const std::vector<double>& x) {
    netmesh_context* const context = block.fresh();
    const netmesh_request request = request_of(dim, x, &netmesh_filter_alpha);
    Answer answer;
    answer.status = netmesh_persist(context, &request);
    if (answer.status == NETMESH_OK) answer.bars = read_bars(context);
    return answer;
}

// By way of a triangulation, and with representatives.
inline Answer ask_delaunay(const Block& block, int dim, const std::vector<double>& x, const Balls& balls) {
    netmesh_context* const context = block.fresh();
    netmesh_request request = request_of(dim, x, &netmesh_filter_alpha);
    Answer answer;
    answer.status = netmesh_mesh(context, &request);
    if (answer.status != NETMESH_OK) return answer;
    request.points = {};  // what the context holds
    answer.status = netmesh_persist(context, &request);
    if (answer.status != NETMESH_OK) return answer;
    answer.bars = read_bars(context);
    request.cycles = &netmesh_cycles;
    const netmesh_status status = netmesh_persist(context, &request);
    answer.fault = status != NETMESH_OK ? "representatives: status " + std::to_string(status)
                                        : fault_of_cycles(context, answer.bars.size(), [&](Set set, double* value) {
                                              return balls.alpha(set, value);
                                          });
    return answer;
}

// `cycles`: with representatives, whose simplices have these values; of RIPS and CECH.
inline Answer ask_points(const Block& block, int dim, const std::vector<double>& x, const netmesh_filter* filter, int k,
                         std::uint32_t max_degree, const Levels* cycles = nullptr) {
    netmesh_context* const context = block.fresh();
    netmesh_request request = request_of(dim, x, filter);
    request.k = static_cast<std::uint32_t>(k);
    request.max_degree = max_degree;
    // Of BARYCENTRIC_RIPS: not times 2^(1/4).
    if (filter == &netmesh_filter_barycentric_rips) request.values = NETMESH_VALUES_THESIS;
    if (cycles != nullptr) request.cycles = &netmesh_cycles;
    Answer answer;
    answer.status = netmesh_persist(context, &request);
    if (answer.status != NETMESH_OK) return answer;
    answer.bars = read_bars(context);
    if (cycles != nullptr)
        answer.fault = fault_of_cycles(context, answer.bars.size(), [&](Set set, double* value) {
            *value = cycles->value(set);
            return true;
        });
    return answer;
}

// Distances as numbers[n (n - 1) / 2], a row of the lower triangle after the other.
inline Answer ask_distances(const Block& block, std::size_t n, const std::vector<double>& numbers,
                            std::uint32_t max_degree) {
    netmesh_context* const context = block.fresh();
    netmesh_distances distances = {};
    distances.struct_bytes = sizeof distances;
    distances.layout = NETMESH_DISTANCES_LOWER;
    distances.numbers = numbers.data();
    distances.count = n;
    netmesh_request request = netmesh_default_request();
    request.distances = &distances;
    request.filter = &netmesh_filter_rips;
    request.max_degree = max_degree;
    Answer answer;
    answer.status = netmesh_persist(context, &request);
    if (answer.status == NETMESH_OK) answer.bars = read_bars(context);
    return answer;
}

// The diagrams of k = 1..k_last from one vineyard: [k - 1].
inline std::vector<Answer> ask_vineyard(const Block& block, int dim, const std::vector<double>& x,
                                        const netmesh_filter* filter, int k_last, std::uint32_t max_degree) {
    netmesh_context* const context = block.fresh();
    netmesh_request request = request_of(dim, x, filter);
    request.k = 1;
    request.k_last = static_cast<std::uint32_t>(k_last);
    request.max_degree = max_degree;
    request.vines = &netmesh_vines;
    std::vector<Answer> answers(static_cast<std::size_t>(k_last));
    const netmesh_status status = netmesh_persist(context, &request);
    for (Answer& answer : answers) answer.status = status;
    if (status != NETMESH_OK) return answers;
    netmesh_vine_point point;
    point.struct_bytes = sizeof point;
    for (std::uint64_t i = 0; netmesh_get_vine_point(context, i, &point) == NETMESH_OK; ++i)
        answers.at(point.k - 1).bars.push_back({point.degree, point.birth, point.death});
    return answers;
}

// The first thing that is wrong with a diagram; empty: none. Both are sorted before, bars being alike in any order.
inline std::string difference(Bars expected, Bars got) {
    std::sort(expected.begin(), expected.end());
    std::sort(got.begin(), got.end());
    for (std::size_t i = 0; i < expected.size() || i < got.size(); ++i) {
        if (i < expected.size() && i < got.size() && expected[i] == got[i]) continue;
        std::string text;
        const auto tell = [&](const char* what, const Bars& bars) {
            char line[120];
            if (i >= bars.size()) {
                std::snprintf(line, sizeof line, "%s no bar %zu", what, i);
            } else {
                std::snprintf(line, sizeof line, "%s bar %zu: degree %u, %a %a (%.17g %.17g)", what, i, bars[i].degree,
                              bars[i].birth, bars[i].death, bars[i].birth, bars[i].death);
            }
            text += line;
        };
        tell("expected", expected);
        tell("; got", got);
        return text;
    }
    return "";
}

// Above this many bits in differences of coordinates netmesh_persist may say that an alpha complex is out of range: the
// figures of its header, where it has none for a dimension that of the next one.
inline std::size_t alpha_bits(int dim) { return dim == 2 ? 2766 : dim == 3 ? 2075 : 1185; }

// What is wrong with an answer; empty: nothing. Of an alpha complex it may be that there is none.
inline std::string fault_of(const Answer& answer, const Bars& expected) {
    if (answer.status != NETMESH_OK) return std::string("status: ") + netmesh_status_text(answer.status);
    const std::string found = difference(expected, answer.bars);
    return found.empty() ? answer.fault : found;
}
// Of balls it may be that their radii are out of range where those of an alpha complex may be.
inline std::string fault_of_balls(const Answer& answer, const Bars& expected, const Cloud& cloud) {
    if (answer.status == NETMESH_OUT_OF_RANGE && cloud.spread_bits() > alpha_bits(cloud.dim)) return "";
    return fault_of(answer, expected);
}
inline std::string fault_of_alpha(const Answer& answer, const Bars& expected, const Cloud& cloud, const Balls& balls) {
    const bool is_flat = balls.rank < cloud.dim;
    if (is_flat != (answer.status == NETMESH_FLAT)) return is_flat ? "flat points are not refused" : "refused as flat";
    if (is_flat) return "";
    if (answer.status == NETMESH_OUT_OF_RANGE && cloud.spread_bits() > alpha_bits(cloud.dim)) return "";
    return fault_of(answer, expected);
}

// Rows of a cloud in another order, by a number.
inline std::vector<double> permuted(int dim, const std::vector<double>& x, std::uint64_t number) {
    const std::size_t d = static_cast<std::size_t>(dim), n = x.size() / d;
    std::vector<std::size_t> at(n);
    for (std::size_t i = 0; i < n; ++i) at[i] = i;
    for (std::size_t i = n; i > 1; --i) {
        std::swap(at[i - 1], at[number % i]);
        number /= i;
    }
    std::vector<double> y;
    for (const std::size_t i : at)
        y.insert(y.end(), x.begin() + static_cast<std::ptrdiff_t>(i * d),
                 x.begin() + static_cast<std::ptrdiff_t>((i + 1) * d));
    return y;
}

// What one cloud is asked for.
struct Plan {
    std::uint32_t rips_degree = 1;    // highest degree of Rips diagrams
    int k = 2;                        // of nested sets; 1 and this one
    std::uint32_t nested_degree = 1;  // highest degree of nested sets
    std::uint64_t permutation = 0;
};

inline bool is_served(int dim) {
    netmesh_request request = netmesh_default_request();
    request.points.dim = static_cast<std::uint32_t>(dim);
    request.points.count = 1;
    request.filter = &netmesh_filter_alpha;
    return netmesh_plan(&request) != 0;
}

// Nested sets of k_first to k_last + max_degree + 1 of n points, as many as a simplex of dimension max_degree + 1 has
// vertices at most: simplices of the engine's complex.
inline std::size_t nested_sets(std::size_t n, std::size_t k_first, std::size_t k_last, std::size_t max_degree) {
    const auto choose = [](std::size_t m, std::size_t k) {
        std::size_t c = 1;
        for (std::size_t i = 1; i <= k; ++i) c = c * (m - i + 1) / i;
        return c;
    };
    const std::size_t top = std::min(n, k_last + max_degree + 1);
    std::vector<std::size_t> ending(top + 1, 0);  // in a set of so many points
    std::size_t sum = 0;
    for (std::size_t s = k_first; s <= top; ++s) sum += ending[s] = choose(n, s);
    for (std::size_t length = 2; length <= max_degree + 2; ++length) {
        std::vector<std::size_t> longer(top + 1, 0);
        for (std::size_t s = k_first; s <= top; ++s)
            for (std::size_t t = k_first; t < s; ++t)
                if (s - t <= max_degree + 1) longer[s] += ending[t] * choose(n - t, s - t);
        ending.swap(longer);
        for (const std::size_t count : ending) sum += count;
    }
    return sum;
}

// The highest degree up to D - 1 for which the nerves have at most 1000 `more` simplices and the nested sets 3000.
inline void set_nested_degree(int dim, std::size_t n, std::size_t more, Plan* plan) {
    const auto fits = [&](std::uint32_t degree) {
        for (int k = 1; k <= plan->k && static_cast<std::size_t>(k) <= n; ++k)
            if (nerve_size(n, k, degree) > 1000 * more) return false;
        return nested_sets(n, 1, std::min(n, static_cast<std::size_t>(plan->k)), degree) <= 3000 * more;
    };
    plan->nested_degree = static_cast<std::uint32_t>(dim - 1);
    while (plan->nested_degree > 0 && !fits(plan->nested_degree)) --plan->nested_degree;
}

enum Job { alpha, delaunay, cech, rips, distances, nested_cech, nested_rips, vineyard, jobs };
inline const char* name_of(int job) {
    static const char* const names[] = {"alpha",     "delaunay",     "Cech",        "Rips",
                                        "distances", "k-th nearest", "nested Rips", "vineyard"};
    return names[job];
}

struct Finding {
    Job job;
    std::string what;
};
struct Count {
    std::size_t begun = 0, asked = 0;  // one more has begun when a call does not return
    std::size_t bars = 0, hidden = 0, close = 0, refused = 0;
};

// All jobs on one cloud, as it is and permuted; above R^6 there are Rips complexes alone.
inline std::vector<Finding> judge(const Block& block, int dim, const std::vector<double>& x, const Plan& plan,
                                  Count (&counts)[jobs]) {
    std::vector<Finding> found;
    const Cloud cloud(dim, x);
    const Balls balls(cloud);
    const std::size_t n = cloud.count();
    const std::uint32_t top = static_cast<std::uint32_t>(dim) - 1;
    const std::vector<Set> points = members(n, 1);
    const std::vector<double> y = permuted(dim, x, plan.permutation);
    const auto begin = [&](Job job) { counts[job].begun = counts[job].asked + 1; };
    const auto note = [&](Job job, const Answer& answer, const Truth& truth, const std::string& fault,
                          const std::string& how = "") {
        Count& count = counts[job];
        count.begun = ++count.asked;
        if (answer.status == NETMESH_OK) {
            count.bars += truth.bars.size();
            count.hidden += truth.hidden;
            count.close += truth.close;
        } else {
            ++count.refused;
        }
        if (!fault.empty()) found.push_back({job, how + fault});
    };

    const Truth rips_truth = nerve_diagram(points, balls.rips, plan.rips_degree);
    begin(rips);
    Answer answer = ask_points(block, dim, x, &netmesh_filter_rips, 0, plan.rips_degree, &balls.rips);
    note(rips, answer, rips_truth, fault_of(answer, rips_truth.bars), "with representatives: ");
    begin(rips);
    answer = ask_points(block, dim, y, &netmesh_filter_rips, 0, plan.rips_degree);
    note(rips, answer, rips_truth, fault_of(answer, rips_truth.bars), "permuted: ");

    // Lengths rounded to doubles are distances of their own, of which halves are exact but for subnormal numbers.
    std::vector<double> numbers;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b) numbers.push_back(nearest_root({balls.square(a, b), 1}, cloud.unit));
    const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double d) { return std::isfinite(d); });
    if (finite) {  // an infinite one means something else
        const long unit = common_unit(numbers);
        std::vector<mpz_class> squares(n * n);
        for (std::size_t a = 0, i = 0; a < n; ++a)
            for (std::size_t b = 0; b < a; ++b, ++i)
                squares[a * n + b] = whole(numbers[i], unit) * whole(numbers[i], unit);
        const Truth truth = nerve_diagram(points, edge_levels(n, squares, unit), plan.rips_degree);
        begin(distances);
        answer = ask_distances(block, n, numbers, plan.rips_degree);
        note(distances, answer, truth, fault_of(answer, truth.bars));
    }
    if (dim > Balls::dim_max) return found;

    const Truth balls_truth = nerve_diagram(points, balls.cech, top);
    begin(alpha);
    answer = ask_alpha(block, dim, x);
    note(alpha, answer, balls_truth, fault_of_alpha(answer, balls_truth.bars, cloud, balls));
    begin(alpha);
    answer = ask_alpha(block, dim, y);
    note(alpha, answer, balls_truth, fault_of_alpha(answer, balls_truth.bars, cloud, balls), "permuted: ");
    begin(delaunay);
    answer = ask_delaunay(block, dim, x, balls);
    note(delaunay, answer, balls_truth, fault_of_alpha(answer, balls_truth.bars, cloud, balls));

    begin(cech);
    answer = ask_points(block, dim, x, &netmesh_filter_cech, 0, top, &balls.cech);
    note(cech, answer, balls_truth, fault_of_balls(answer, balls_truth.bars, cloud));
    begin(cech);
    answer = ask_points(block, dim, y, &netmesh_filter_cech, 0, top);
    note(cech, answer, balls_truth, fault_of_balls(answer, balls_truth.bars, cloud), "permuted: ");

    const int k_last = std::min<int>(plan.k, static_cast<int>(n));
    const std::uint32_t degree = plan.nested_degree;
    begin(vineyard);
    const std::vector<Answer> vines = ask_vineyard(block, dim, y, &netmesh_filter_barycentric_cech, k_last, degree);
    for (int k = 1; k <= k_last; ++k) {
        const std::vector<Set> sets = members(n, k);
        const std::string how = "k = " + std::to_string(k) + ": ";
        const Truth nested = nerve_diagram(sets, balls.cech, degree);
        begin(nested_cech);
        answer = ask_points(block, dim, x, &netmesh_filter_barycentric_cech, k, degree);
        note(nested_cech, answer, nested, fault_of_balls(answer, nested.bars, cloud), how);
        const Answer& vine = vines[static_cast<std::size_t>(k) - 1];
        note(vineyard, vine, nested, fault_of_balls(vine, nested.bars, cloud), how);
        const Truth edges = nerve_diagram(sets, balls.rips, degree);
        begin(nested_rips);
        answer = ask_points(block, dim, x, &netmesh_filter_barycentric_rips, k, degree);
        note(nested_rips, answer, edges, fault_of(answer, edges.bars), how);
    }
    return found;
}

inline void print_cloud(int dim, const std::vector<double>& x) {
    for (std::size_t i = 0; i < x.size(); ++i)
        std::printf("%a%c", x[i], (i + 1) % static_cast<std::size_t>(dim) == 0 ? '\n' : ' ');
}

}  // namespace exact
