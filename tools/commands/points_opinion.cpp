// check: exact diagrams of points a second time, in exact arithmetic and from definitions. The engine has no part in it
// but for the triangulation of many points, which is checked.
#include <algorithm>
#include <cmath>
#include <set>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/numbers.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/opinion/delaunay_check.hpp"
#include "tools/opinion/spanning_tree.hpp"

namespace netmesh::tool {

namespace {

constexpr std::size_t brute_sets_max = 20000;         // under a second; in place of a triangulation
constexpr std::size_t nerve_simplices_max = 200000;   // of barycentric filters
constexpr std::size_t spanning_points_max = 20000;    // all pairs: some seconds
constexpr std::size_t sampled_pairs_max = 500000000;  // of points with a sampled one
constexpr std::size_t sample_max = 1000;
// Rounded up. Certified values of barycentric-rips are the filter's own times that.
constexpr double fourth_root_of_two = 0x1.306fe0a31b716p0;

// Bars of a file, with --all those that have a length, and their places in it.
struct ComparedBars {
    std::vector<Bar> bars;
    std::vector<std::size_t> places;

    ComparedBars(const DiagramFile& file, bool all) {
        for (std::size_t i = 0; i < file.bars.size(); i++) {
            if (all && file.bars[i].birth == file.bars[i].death) continue;
            bars.push_back(file.bars[i]);
            places.push_back(i);
        }
    }
    // The bar at `at` of these is at fault.
    Outcome wrong(const DiagramFile& file, std::size_t at, const std::string& why) const {
        const std::size_t place = at < places.size() ? places[at] : file.bars.size();
        return file.wrong(file.line_of(place), bar_text(file.bars, place) + ": " + why);
    }
};

// Every bar, and cycles if there are some. `how` the complex was made.
Outcome judge_exact(const DiagramClaim& claim, const FilteredComplex& complex, const std::string& how,
                    std::vector<std::string>* checked) {
    const ComparedBars have(claim.file, (claim.made.request.keep_zero_pairs != 0));
    std::size_t at = 0;
    const std::string complaint = complex.bars_complaint(have.bars, claim.made.request.max_degree, false, &at);
    if (!complaint.empty()) return have.wrong(claim.file, at, complaint + " in exact arithmetic");
    checked->push_back("second opinion: " + counted(complex.count(), "simplex", "simplices") + " " + how +
                       ", in exact arithmetic: the same bars, to the last bit" +
                       (claim.made.request.keep_zero_pairs != 0 ? "; bars of length zero were not looked at" : ""));
    return judge_cycles(claim, complex, checked);
}

// Where the complex is too large. All points are there from 0 on.
Outcome judge_degree_zero(const DiagramClaim& claim, const PointCloud& points, const std::string& why,
                          std::vector<std::string>* checked) {
    const PointCloud different = different_points(points);
    const std::size_t n = different.rows();
    const ComparedBars have(claim.file, (claim.made.request.keep_zero_pairs != 0));
    std::vector<double> deaths;
    for (std::size_t i = 0; i < have.bars.size() && have.bars[i].degree == 0; i++) {
        if (have.bars[i].birth != 0) return have.wrong(claim.file, i, "points are born at 0");
        deaths.push_back(have.bars[i].death);
    }
    std::string text = "second opinion on degree 0 alone, ";
    if (n <= spanning_points_max) {
        std::vector<double> due = spanning_tree_halves(different);
        due.erase(due.begin(), std::upper_bound(due.begin(), due.end(), 0.0));
        due.push_back(HUGE_VAL);
        const std::size_t shared = std::min(due.size(), deaths.size());
        const std::size_t at = static_cast<std::size_t>(
            std::mismatch(due.begin(), due.begin() + static_cast<std::ptrdiff_t>(shared), deaths.begin()).first -
            due.begin());
        if (due.size() != deaths.size() || at < shared)
            return have.wrong(claim.file, at,
                              "in exact arithmetic a minimum spanning tree has " +
                                  (at < due.size() ? "the death " + number_text(due[at]) : std::string("no more")));
        text += "a minimum spanning tree of " + grouped_text(n) +
                " points in exact arithmetic: the same bars, to the last bit";
    } else {
        const std::size_t sample = std::min(sample_max, sampled_pairs_max / n);
        // A fixed sequence: rows spread by the golden ratio.
        for (std::size_t i = 1; i <= sample; i++) {
            const double place = static_cast<double>(i) * 0.6180339887498949;
            const std::size_t row =
                std::min(n - 1, static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(n)));
            const double half = nearest_half(different, row);
            if (half > 0 && !std::binary_search(deaths.begin(), deaths.end(), half))
                return have.wrong(claim.file, deaths.size(),
                                  "no bar of degree 0 dies at " + number_text(half) +
                                      ", half of the way from a point to its nearest neighbour");
        }
        text += "and of it a sample: " + grouped_text(sample) + " of " + grouped_text(n) +
                " points have bars that die half-way to their nearest neighbours, to the last bit";
    }
    checked->push_back(text +
                       (claim.made.request.max_degree > 0 ? "; degrees above were not looked at, as " : "; as ") + why);
    return {};
}

Outcome judge_sets(const DiagramClaim& claim, const PointCloud& points, std::vector<std::string>* checked) {
    const netmesh_filter_id filter = filter_of(claim.made);
    const bool rips = filter == NETMESH_FILTER_RIPS || filter == NETMESH_FILTER_BARYCENTRIC_RIPS;
    const std::uint32_t top = claim.made.request.max_degree + 1;
    if (!is_barycentric(filter)) {
        const SimplexList sets = complex_of_points(points, rips, top);
        if (sets)
            return judge_exact(claim, FilteredComplex(*sets),
                               rips ? "by their longest edges" : "by their smallest enclosing balls", checked);
        const std::string many = "there are more than " + counted(opinion_simplices_max, "simplex", "simplices");
        if (claim.cycles_path.empty())
            return claim.is_proven ? Outcome{} : judge_degree_zero(claim, points, many, checked);
        return usage_error("--representatives: " + many + ", which are too many to check cycles");
    }
    const std::uint32_t k = claim.made.request.k;
    const bool scaled = rips && choice_of(claim.made).values == NETMESH_VALUES_CERTIFIED;
    const SimplexList sets = nerve_of_sets(points, k, rips, scaled ? fourth_root_of_two : 1, top, nerve_simplices_max);
    if (sets)
        return judge_exact(claim, FilteredComplex(*sets),
                           "of sets of " + counted(k, "point", "points") +
                               (rips ? " by the longest edges" : " by the smallest enclosing balls") +
                               " of their unions",
                           checked);
    checked->push_back("no second opinion: the nerve of all sets of " + counted(k, "point", "points") +
                       " has more than " + counted(nerve_simplices_max, "simplex", "simplices") +
                       " or there are more than 16 points; the engine alone made the bars, twice");
    return {};
}

// Nothing where the engine has no memory for the triangulation.
std::optional<MeshFiles> triangulation_of(const Options& made, const PointCloud& points) {
    Session session(made, points.dim);
    const Outcome outcome =
        session.run(plan_of(made, points.dim, points.rows()), points, [&](Session& s) { return make_mesh(s, points); });
    if (!outcome.good()) return {};
    return files_of(EngineMesh(session.engine()));
}

std::set<Place> set_of(const PointCloud& cloud) {
    const std::vector<Place> places = different_places(cloud);
    return {places.begin(), places.end()};
}

Outcome judge_alpha_of_points(const DiagramClaim& claim, const PointCloud& points, std::vector<std::string>* checked) {
    const std::uint32_t top = claim.made.request.max_degree + 1;
    if (claim.cycles_path.empty()) {  // cycles are of the triangulation
        const SimplexList sets = complex_of_points(points, false, top, brute_sets_max);
        if (sets)
            return judge_exact(claim, FilteredComplex(*sets), "of the nerve of all balls, by smallest enclosing balls",
                               checked);
    }
    // No point has fewer than six simplices, but for some at the boundary.
    const std::string many = "the complex has more than " + counted(alpha_simplices_max, "simplex", "simplices");
    std::string why = many;
    if (points.rows() <= alpha_simplices_max / 5) {
        const std::optional<MeshFiles> files = triangulation_of(claim.made, points);
        if (!files) {
            why = "there is no memory for the triangulation";
        } else {
            if (set_of(files->node.cloud) != set_of(points))
                return mismatch("the triangulation that the engine makes of " + points.name + " has other vertices");
            bool is_too_large = false;
            const Outcome outcome =
                judge_alpha(claim, *files, "that the engine makes of " + points.name, &is_too_large, checked);
            if (!is_too_large) return outcome;
        }
    }
    if (!claim.cycles_path.empty()) return usage_error("--representatives: " + why + ", so cycles cannot be checked");
    if (claim.is_proven) return {};  // in all degrees
    return judge_degree_zero(claim, points, why + "; netmesh-verify looks at them, by a proof (persist --proof)",
                             checked);
}

Outcome judge_balls(const DiagramClaim& claim, const PointCloud& points, std::vector<std::string>* checked) {
    const SimplexList sets = nerve_of_balls(points, claim.made.table.are_radii, claim.made.request.squares != 0,
                                            claim.made.request.max_degree + 1, brute_sets_max);
    if (sets) return judge_exact(claim, FilteredComplex(*sets), "of the nerve of all balls, by their powers", checked);
    if (claim.is_proven) return {};
    checked->push_back("no second opinion: there are more than " + counted(brute_sets_max, "set", "sets") +
                       " of balls; the engine alone made the bars, twice");
    return {};
}

// Of all dimensions. By Euler's formula, with a facet of two cells at most: in the plane as many edges as vertices and
// cells, but for one; in space two facets for each cell, and as many edges as vertices and cells.
std::size_t least_faces(const MeshFiles& files) {
    const std::size_t vertices = files.node.cloud.rows(), cells = files.cells.lines.size(), dim = files.node.cloud.dim;
    if (dim == 2) return 2 * (vertices + cells) - 1;
    if (dim == 3) return 2 * vertices + 4 * cells;
    return vertices + cells + (dim + 1) * cells / 2;
}

}  // namespace

Outcome judge_alpha(const DiagramClaim& claim, const MeshFiles& files, const std::string& whose, bool* is_too_large,
                    std::vector<std::string>* checked) {
    *is_too_large = least_faces(files) > alpha_simplices_max;
    if (*is_too_large) return {};
    const std::string complaint = delaunay_complaint(exact_places(files.node.cloud), files.cells);
    if (!complaint.empty())
        return mismatch("no Delaunay triangulation in exact arithmetic is the one " + whose + ": " + complaint);
    const SimplexList simplices = alpha_complex(files, claim.made.request.max_degree + 1, alpha_simplices_max);
    *is_too_large = !simplices;
    if (*is_too_large) return {};
    return judge_exact(claim, FilteredComplex(*simplices),
                       "of the triangulation " + whose + ", which is Delaunay, by their spheres", checked);
}

Outcome second_opinion_on_points(const DiagramClaim& claim, const PointCloud& points, RunReport* run) {
    const netmesh_filter_id filter = filter_of(claim.made);
    if (about(filter).is_by_scales != 0) return second_opinion_on_scales(claim, points, run);
    if (about(filter).is_on_mesh != 0) {
        if (!claim.cycles_path.empty())
            return usage_error("--representatives needs --mesh, or filter alpha, scales, rips or cech");
        run->checked->push_back("no second opinion: the same code ran twice; for filters on a mesh --mesh gives one");
        return {};
    }
    if (!points.weights.empty()) return judge_balls(claim, points, &*run->checked);
    return filter == NETMESH_FILTER_ALPHA ? judge_alpha_of_points(claim, points, &*run->checked)
                                          : judge_sets(claim, points, &*run->checked);
}

}  // namespace netmesh::tool
