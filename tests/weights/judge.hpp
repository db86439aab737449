// What the engine says of a cloud with weights, beside the truth.
#pragma once
#include <netmesh.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "exact/families.hpp"
#include "weights/truth.hpp"

namespace weights {

struct Cloud {
    int dim = 2;
    Numbers x, numbers;
    bool are_radii = false;
    std::size_t count() const { return numbers.size(); }
};

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
    static constexpr std::size_t bytes = std::size_t(256) << 20;
    void* memory_;
};

inline netmesh_request request_of(const Cloud& cloud, bool squares) {
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

inline Answer read(netmesh_context* context, netmesh_status status) {
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

inline Answer ask(const Block& block, const Cloud& cloud, bool squares) {
    netmesh_context* const context = block.fresh();
    const netmesh_request request = request_of(cloud, squares);
    return read(context, netmesh_persist(context, &request));
}

// Another diagram of the triangulation that is kept, and what is wrong with that.
inline std::string judge_cells(const Block& block, const Cloud& cloud, const Truth& truth, Answer* answer) {
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

inline std::string text_of(const Bars& bars) {
    std::string text;
    char line[200];
    for (const Bar& bar : bars) {
        std::snprintf(line, sizeof line, "    %u %.17g %.17g\n", bar.degree, bar.birth, bar.death);
        text += line;
    }
    return text;
}

inline std::string compare(const char* what, const Answer& answer, const Truth& truth, const Bars& bars) {
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

inline void print_cloud(const Cloud& cloud) {
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    std::printf("  %dD, %s\n", cloud.dim, cloud.are_radii ? "radii" : "weights");
    for (std::size_t i = 0; i < cloud.count(); ++i) {
        for (int c = 0; c < cloud.dim; ++c) std::printf("%a ", cloud.x[i * d + static_cast<std::size_t>(c)]);
        std::printf(" %a\n", cloud.numbers[i]);
    }
}

inline std::string judge(const Block& block, families::Random& random, const Cloud& cloud, Seen* seen) {
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

}  // namespace weights
