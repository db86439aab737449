#include "judge.hpp"

#include <algorithm>
#include <cstring>
#include <set>

namespace referee {
namespace {

void judge_inputs(const Mesh& mesh, const Case& wanted, Verdict* verdict) {
    const std::vector<Point> due = distinct(wanted.points, wanted.dim);
    std::size_t inputs = 0;
    for (const int marker : mesh.markers) inputs += marker == input_marker;
    if (inputs != due.size())
        verdict->add("inputs", count_text(inputs) + " vertices are inputs, " + count_text(due.size()) + " are due");
    for (std::size_t p = 0; p < due.size(); p++)
        if (p >= mesh.count() || mesh.markers[p] != input_marker ||
            std::memcmp(mesh.vertices[p].data(), due[p].data(), sizeof(double) * wanted.dim) != 0)
            verdict->add("inputs", "vertex " + count_text(p) + " is not the input of that place");
}

void judge_remarks(const Mesh& mesh, const Case& wanted, Verdict* verdict) {
    if (mesh.dim != wanted.dim) verdict->add("remarks", "another dimension");
    if (mesh.has_domain != wanted.is_mesh) verdict->add("remarks", "a mesh has a domain, a triangulation none");
    if (wanted.tau > 0 && promised_tau(mesh) != wanted.tau) verdict->add("remarks", "another tau was asked for");
    if (wanted.eps > 0 && mesh.eps != wanted.eps) verdict->add("remarks", "another eps was asked for");
    if (wanted.least_size > 0 && (wanted.least_size != mesh.least_size || wanted.growth != mesh.growth))
        verdict->add("remarks", "another cell-size was asked for");
    if (wanted.net > 0 && wanted.net != mesh.net) verdict->add("remarks", "another boundary net was asked for");
    if (!wanted.has_cages && !mesh.cages.empty()) verdict->add("remarks", "cages that were not asked for");
}

}  // namespace

std::vector<Point> distinct(const std::vector<Point>& points, int dim) {
    std::vector<Point> kept;
    std::set<Point> seen;
    for (Point p : points) {
        for (int k = 0; k < dim_max; k++) p[k] = k < dim ? p[k] + 0.0 : 0.0;
        if (seen.insert(p).second) kept.push_back(p);
    }
    return kept;
}

Verdict judge(const Mesh& mesh, const Case& wanted, Random& random) {
    Verdict verdict;
    judge_remarks(mesh, wanted, &verdict);
    if (mesh.dim != wanted.dim) return verdict;
    judge_inputs(mesh, wanted, &verdict);
    const Hull hull = judge_triangulation(mesh, wanted.sphere_tests, random, &verdict);
    if (!mesh.has_domain || verdict.blames("cells") || verdict.blames("orientation") || verdict.blames("hull") ||
        verdict.blames("delaunay"))
        return verdict;
    const auto is_over = [&] { return wanted.first_fault && !verdict.good(); };
    if (is_over()) return verdict;
    judge_domain(mesh, hull, &verdict);
    const Hierarchy hierarchy = judge_cages(mesh, &verdict);
    judge_markers(mesh, hull, hierarchy, &verdict);
    if (is_over()) return verdict;
    const Diagram diagram(mesh);
    if (mesh.ratio > 0) {
        judge_certificate(mesh, diagram, hull, &verdict);
        if (!mesh.values.empty()) sample_values(mesh, diagram, wanted.samples, random, &verdict);
    } else {
        judge_quality(mesh, diagram, hierarchy, {wanted.cells_max, wanted.first_fault, random}, &verdict);
        sample_quality(mesh, hierarchy, wanted.samples, random, &verdict);
    }
    return verdict;
}

}  // namespace referee
