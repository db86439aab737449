// Alpha diagrams of points with weights against rationals (truth.hpp), births and deaths bit for bit, on clouds of 1 to
// 9 points of all families of tests/exact/families.hpp, D = 2 to 5, as radii and as weights: values as signed roots and
// as powers; which points are hidden, and which are merged; the triangulation, cell by cell; rows in another order.
//
//   weights [--clouds N] [--seed S]    N clouds, or a slice
//   weights --plant                    errors planted in what came, which have to be seen
//
// Ends with 1 on a difference, after the cloud in hexadecimal.
#include <netmesh.h>

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include "exact/families.hpp"
#include "truth.hpp"

namespace {

using namespace weights;

struct Cloud {
    int dim = 2;
    Numbers x, numbers;
    bool are_radii = false;
    std::size_t count() const { return numbers.size(); }
};

// Largest difference of coordinates.
double extent_of(const Cloud& cloud) {
    double extent = 0;
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    for (std::size_t i = d; i < cloud.x.size(); ++i) extent = std::max(extent, std::fabs(cloud.x[i] - cloud.x[i % d]));
    return extent > 0 && extent < 1e150 ? extent : 1;
}

constexpr int kinds = 11;

// A weight for each point. All operations are those of doubles alone, so a seed gives the same everywhere.
void weigh(families::Random& random, int kind, Cloud* cloud) {
    const std::size_t d = static_cast<std::size_t>(cloud->dim);
    const double extent = extent_of(*cloud), equal = random.uniform(0, 2);
    cloud->numbers.clear();
    for (std::size_t i = 0; i < cloud->x.size() / d; ++i) {
        double square = 0;
        for (std::size_t c = 0; c < d; ++c) square += cloud->x[i * d + c] * cloud->x[i * d + c];
        double w = 0;
        const double area = extent * extent;
        switch (kind) {
        case 0: break;                                     // none
        case 1: w = equal * area; break;                   // all equal
        case 2: w = 0.1 * area * random.uniform(); break;  // a few hidden
        case 3: w = area * random.uniform(); break;        // many hidden
        case 4: w = area * random.uniform(-1, 1); break;   // of both signs
        case 5: w = random.one_in(5) ? 1e6 * area : area * random.uniform(); break;
        case 6: w = square; break;  // all lifts are near 0
        case 7: w = square + random.whole(-1, 1); break;
        case 8: w = families::moved(area, random.whole(-3, 3)); break;  // nearly equal
        case 9: w = area * random.whole(0, 3); break;                   // ties
        default: w = 1e-20 * area * random.uniform(); break;
        }
        if (!(std::fabs(w) < 1e300)) w = 1;
        if (kind != 4 && kind != 7) w = std::fabs(w);
        cloud->numbers.push_back(cloud->are_radii ? std::sqrt(std::fabs(w)) : w);
    }
    if (kind == 6 && random.one_in(2))
        for (double& number : cloud->numbers) number = number != 0 ? families::moved(number, random.whole(-2, 2)) : 0;
}

class Block {
public:
    Block() : memory_(std::aligned_alloc(16, bytes)) {}
    ~Block() { std::free(memory_); }
    netmesh_context* fresh() const {
        netmesh_context* context = nullptr;
        if (netmesh_init(memory_, bytes, &context) != NETMESH_OK) std::abort();
        return context;
    }

private:
    static constexpr std::size_t bytes = std::size_t(64) << 20;
    void* memory_;
};

netmesh_request request_of(const Cloud& cloud, bool squares) {
    netmesh_request request = netmesh_default_request();
    request.points.coordinates = cloud.x.data();
    request.points.count = cloud.count();
    request.points.dim = static_cast<std::uint32_t>(cloud.dim);
    request.points.weights = cloud.numbers.data();
    request.weighting = cloud.are_radii ? &netmesh_radii : &netmesh_weights;
    request.filter = &netmesh_filter_alpha;
    request.squares = squares;
    return request;
}

struct Answer {
    netmesh_status status;
    Bars bars;
    std::vector<std::size_t> hidden;
    std::size_t duplicates = 0, distinct = 0;
};

Answer read(netmesh_context* context, netmesh_status status) {
    Answer answer;
    answer.status = status;
    if (status != NETMESH_OK) return answer;
    netmesh_pair pair;
    pair.struct_bytes = sizeof pair;
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i)
        answer.bars.push_back({pair.degree, pair.birth, pair.death});
    std::uint64_t row;
    for (std::uint64_t i = 0; netmesh_get_hidden(context, i, &row) == NETMESH_OK; ++i)
        answer.hidden.push_back(static_cast<std::size_t>(row));
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    answer.duplicates = static_cast<std::size_t>(report.input.duplicates);
    answer.distinct = static_cast<std::size_t>(report.input.distinct);
    if (report.input.hidden != answer.hidden.size()) answer.hidden.push_back(SIZE_MAX);
    return answer;
}

Answer ask(const Block& block, const Cloud& cloud, bool squares) {
    netmesh_context* const context = block.fresh();
    const netmesh_request request = request_of(cloud, squares);
    return read(context, netmesh_persist(context, &request));
}

// Another diagram of the triangulation that is kept, and what is wrong with that.
std::string judge_cells(const Block& block, const Cloud& cloud, const Truth& truth, Answer* answer) {
    netmesh_context* const context = block.fresh();
    netmesh_request request = request_of(cloud, false);
    request.keep_mesh = 1;
    *answer = read(context, netmesh_persist(context, &request));
    if (answer->status != NETMESH_OK) return "";
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    netmesh_vertex vertex;
    vertex.struct_bytes = sizeof vertex;
    std::size_t vertices = 0;
    for (; netmesh_get_vertex(context, vertices, &vertex) == NETMESH_OK; ++vertices) {
        if (vertices >= truth.visible.size()) return "more vertices than points that are not hidden";
        const double* const x = cloud.x.data() + truth.visible[vertices] * d;
        for (std::size_t c = 0; c < d; ++c)
            if (vertex.coordinates[c] != x[c]) return "a vertex is not the point that it should be";
    }
    if (vertices != truth.visible.size()) return "a point that is not hidden has no vertex";
    netmesh_cell cell;
    cell.struct_bytes = sizeof cell;
    std::vector<bool> met(vertices, false);
    for (std::uint64_t i = 0; netmesh_get_cell(context, i, &cell) == NETMESH_OK; ++i) {
        std::vector<std::size_t> rows;
        for (std::size_t k = 0; k <= d; ++k) {
            if (cell.vertices[k] >= vertices) return "a cell has a vertex that is not there";
            rows.push_back(truth.visible[cell.vertices[k]]);
            met[cell.vertices[k]] = true;
        }
        if (!truth.is_regular(rows)) return "a cell is not regular";
    }
    for (const bool m : met)
        if (!m) return "a vertex is in no cell";
    netmesh_check_request check = {};
    check.struct_bytes = sizeof check;
    check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC;
    return netmesh_check(context, &check) == NETMESH_OK ? "" : "netmesh_check refuses the triangulation";
}

std::string text_of(const Bars& bars) {
    std::string text;
    char line[200];
    for (const Bar& bar : bars) {
        std::snprintf(line, sizeof line, "    %u %.17g %.17g\n", bar.degree, bar.birth, bar.death);
        text += line;
    }
    return text;
}

std::string compare(const char* what, const Answer& answer, const Truth& truth, const Bars& bars) {
    const std::string of = std::string(what) + ": ";
    if (answer.status != NETMESH_OK) return of + "status " + std::to_string(answer.status);
    if (answer.duplicates != truth.duplicates) return of + "another number of duplicates";
    if (answer.hidden != truth.hidden) return of + "other points are hidden";
    if (answer.distinct != truth.visible.size()) return of + "another number of points that are not hidden";
    if (!(answer.bars == bars)) return of + "other bars\n  came\n" + text_of(answer.bars) + "  truth\n" + text_of(bars);
    return "";
}

struct Seen {
    std::size_t clouds = 0, flat = 0, bars = 0, hidden = 0, with_hidden = 0, duplicates = 0, range = 0, faults = 0;
};

void print_cloud(const Cloud& cloud) {
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    std::printf("  %dD, %s\n", cloud.dim, cloud.are_radii ? "radii" : "weights");
    for (std::size_t i = 0; i < cloud.count(); ++i) {
        for (int c = 0; c < cloud.dim; ++c) std::printf("%a ", cloud.x[i * d + static_cast<std::size_t>(c)]);
        std::printf(" %a\n", cloud.numbers[i]);
    }
}

std::string judge(const Block& block, families::Random& random, const Cloud& cloud, Seen* seen) {
    const Truth truth(cloud.dim, cloud.x, cloud.numbers, cloud.are_radii);
    const Answer roots = ask(block, cloud, false);
    if (roots.status == NETMESH_NOT_BUILT) return "";  // a build of other dimensions
    ++seen->clouds;
    if (truth.is_flat) {
        ++seen->flat;
        return roots.status == NETMESH_FLAT ? "" : "flat points: status " + std::to_string(roots.status);
    }
    if (roots.status == NETMESH_OUT_OF_RANGE) {
        ++seen->range;
        return "";
    }
    const Bars bars = truth.bars(false);
    seen->bars += bars.size();
    seen->hidden += truth.hidden.size();
    seen->with_hidden += !truth.hidden.empty();
    seen->duplicates += truth.duplicates;
    std::string fault = compare("signed roots", roots, truth, bars);
    if (fault.empty()) fault = compare("powers", ask(block, cloud, true), truth, truth.bars(true));
    Answer kept;
    if (fault.empty()) fault = judge_cells(block, cloud, truth, &kept);
    if (fault.empty()) fault = compare("triangulation kept", kept, truth, bars);
    if (!fault.empty()) return fault;
    // Rows in another order: the same bars.
    Cloud other = cloud;
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    for (std::size_t i = cloud.count(); i > 1; --i) {
        const std::size_t j = static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1));
        std::swap(other.numbers[i - 1], other.numbers[j]);
        for (std::size_t c = 0; c < d; ++c) std::swap(other.x[(i - 1) * d + c], other.x[j * d + c]);
    }
    const Truth moved(other.dim, other.x, other.numbers, other.are_radii);
    return compare("rows in another order", ask(block, other, false), moved, bars);
}

Cloud make_cloud(families::Random& random, std::size_t number) {
    const std::vector<families::Family>& all = families::all();
    Cloud cloud;
    cloud.dim = 2 + static_cast<int>(number % 4);
    const std::size_t n = static_cast<std::size_t>(random.whole(random.one_in(10) ? 1 : cloud.dim + 1, 9));
    cloud.x = all[number / 4 % all.size()].make(random, cloud.dim, n);
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    if (cloud.x.size() > 9 * d) cloud.x.resize(9 * d);
    if (random.one_in(6) && cloud.x.size() > d)  // a point twice
        for (std::size_t c = 0; c < d; ++c) cloud.x[c] = cloud.x[cloud.x.size() - d + c];
    // Points between others, which these can hide.
    const std::size_t rows = cloud.x.size() / d, between = random.one_in(2) && rows > d + 1 ? rows - d - 1 : 0;
    for (std::size_t i = rows - between; i < rows; ++i) {
        const std::size_t one = random.bits() % (d + 1), two = random.bits() % (d + 1), three = random.bits() % (d + 1);
        for (std::size_t c = 0; c < d; ++c)
            cloud.x[i * d + c] = cloud.x[one * d + c] / 4 + cloud.x[two * d + c] / 4 + cloud.x[three * d + c] / 2;
    }
    cloud.are_radii = random.one_in(2);
    weigh(random, static_cast<int>(random.bits() % kinds), &cloud);
    return cloud;
}

// What came is changed in one place each time; compare has to say so.
int plant(const Block& block) {
    families::Random random(5);
    int planted = 0, missed = 0;
    for (std::size_t i = 0; planted < 300 && i < 3000; ++i) {
        const Cloud cloud = make_cloud(random, i);
        const Truth truth(cloud.dim, cloud.x, cloud.numbers, cloud.are_radii);
        const Answer answer = ask(block, cloud, false);
        if (answer.status != NETMESH_OK) continue;
        const Bars bars = truth.bars(false);
        for (int kind = 0; kind < 6; ++kind) {
            Answer wrong = answer;
            const std::size_t at = random.bits() % wrong.bars.size();
            if (kind == 0) wrong.bars[at].birth = families::moved(wrong.bars[at].birth, 1);
            if (kind == 1) wrong.bars.erase(wrong.bars.begin() + static_cast<std::ptrdiff_t>(at));
            if (kind == 2) wrong.bars.push_back(wrong.bars[at]);
            if (kind == 3) wrong.hidden.push_back(0);
            if (kind == 4) ++wrong.duplicates;
            if (kind == 5) --wrong.distinct;
            ++planted;
            missed += compare("planted", wrong, truth, bars).empty();
        }
    }
    std::printf("%d errors planted, %d missed\n", planted, missed);
    return planted < 300 || missed > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t clouds = 440;
    std::uint64_t seed = 1;
    const Block block;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--plant") return plant(block);
        if (word == "--clouds" && i + 1 < argc) {
            clouds = std::strtoull(argv[++i], nullptr, 10);
        } else if (word == "--seed" && i + 1 < argc) {
            seed = std::strtoull(argv[++i], nullptr, 10);
        } else {
            std::fprintf(stderr, "weights [--clouds N] [--seed S] | --plant\n");
            return 2;
        }
    }
    Seen seen;
    for (std::size_t i = 0; i < clouds && seen.faults < 5; ++i) {
        families::Random random(seed * 0x9E3779B97F4A7C15u + i);
        const Cloud cloud = make_cloud(random, i);
        const std::string fault = judge(block, random, cloud, &seen);
        if (fault.empty()) continue;
        ++seen.faults;
        std::printf("cloud %zu, family %s: %s\n", i, families::all()[i / 4 % families::all().size()].name,
                    fault.c_str());
        print_cloud(cloud);
    }
    std::printf(
        "%zu clouds: %zu bars equal to the last bit; %zu hidden points in %zu clouds, %zu merged; %zu flat, %zu out "
        "of range; %zu faults\n",
        seen.clouds, seen.bars, seen.hidden, seen.with_hidden, seen.duplicates, seen.flat, seen.range, seen.faults);
    return seen.faults > 0 || seen.clouds == 0 ? 1 : 0;
}
