#include <cstdio>
#include <cstdlib>

#include "common/session.hpp"
#include "contestants.hpp"

namespace bench {
namespace {

void demand(netmesh_status status, const Session& session) {
    if (status == NETMESH_OK) return;
    std::fprintf(stderr, "netmesh: %s; %s\n", netmesh_status_text(status), session.detail().message);
    std::exit(1);
}

// More than any case here needs; pages that are not touched cost nothing.
constexpr std::size_t block_bytes = std::size_t(12) << 30;

}  // namespace

void ours_delaunay(Trial& trial, int dim, const inputs::Points& points) {
    Session session(dim);
    trial.start();
    session.reserve(block_bytes);
    demand(session.delaunay_in_block(points), session);
    trial.stop();
    trial.figure(cells, static_cast<double>(session.report().mesh.cells));
    trial.figure(arena_bytes, static_cast<double>(session.report().memory.peak_bytes));
}

void ours_mesh(Trial& trial, const inputs::Points& points, double tau) {
    Session session(3);
    session.request.mesh.tau = tau;
    trial.start();
    session.reserve(block_bytes);
    demand(session.mesh_in_block(points), session);
    trial.stop();
    const netmesh_report report = session.report();
    trial.figure(vertices, static_cast<double>(report.mesh.vertices));
    trial.figure(cells, static_cast<double>(report.mesh.cells));
    std::vector<double> coordinates;
    for (const netmesh_vertex& vertex : session.vertices())
        coordinates.insert(coordinates.end(), vertex.coordinates, vertex.coordinates + 3);
    measure_aspect(trial, coordinates, session.cells<4>(), report.mesh.domain);
    trial.figure(aspect_clipped, report.mesh.aspect_ratio_max);
}

void ours_persist(Trial& trial, int dim, const inputs::Points& points, double tau) {
    Session session(dim);
    session.request.mesh.tau = tau;
    session.reserve(block_bytes);
    demand(session.mesh_in_block(points, &netmesh_filter_complete), session);
    const double mesh_bytes = static_cast<double>(session.report().memory.used_bytes);
    trial.start();
    demand(session.persist(), session);
    trial.stop();
    const netmesh_report report = session.report();
    trial.figure(simplices, static_cast<double>(report.diagram.simplices));
    trial.figure(vertices, static_cast<double>(report.mesh.vertices));
    trial.figure(cells, static_cast<double>(report.mesh.cells));
    trial.figure(arena_bytes, static_cast<double>(report.memory.peak_bytes) - mesh_bytes);
    trial.outcome.diagram = session.pairs();
}

void ours_alpha(Trial& trial, int dim, const inputs::Points& points) {
    Session session(dim);
    trial.start();
    session.reserve(block_bytes);
    demand(session.persist(session.alpha_request(points)), session);
    trial.stop();
    trial.figure(simplices, static_cast<double>(session.report().diagram.simplices));
    trial.figure(arena_bytes, static_cast<double>(session.report().memory.peak_bytes));
    trial.outcome.diagram = session.pairs();
}

namespace {

netmesh::Request weighted(const Session& session, const inputs::Points& points, const inputs::Points& weights) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(session.dim(), points).set_weights(&netmesh_weights, weights);
    request.squares = 1;
    return request;
}
void persist_in_block(Trial& trial, const netmesh::Request& request, Session& session) {
    trial.start();
    session.reserve(block_bytes);
    demand(session.persist(request), session);
    trial.stop();
    const netmesh_report report = session.report();
    trial.figure(simplices, static_cast<double>(report.diagram.simplices));
    trial.figure(hidden, static_cast<double>(report.input.hidden));
    trial.figure(arena_bytes, static_cast<double>(report.memory.peak_bytes));
    trial.outcome.diagram = session.pairs();
}

}  // namespace

void ours_regular(Trial& trial, int dim, const inputs::Points& points, const inputs::Points& weights) {
    Session session(dim);
    netmesh::Request request = weighted(session, points, weights);
    request.filter = nullptr;
    request.mesh.method = &netmesh_method_delaunay;
    request.squares = 0;
    trial.start();
    session.reserve(block_bytes);
    demand(netmesh_mesh(session.context, &request), session);
    trial.stop();
    const netmesh_report report = session.report();
    trial.figure(cells, static_cast<double>(report.mesh.cells));
    trial.figure(hidden, static_cast<double>(report.input.hidden));
    trial.figure(arena_bytes, static_cast<double>(report.memory.peak_bytes));
}

void ours_weighted_alpha(Trial& trial, int dim, const inputs::Points& points, const inputs::Points& weights) {
    Session session(dim);
    persist_in_block(trial, weighted(session, points, weights), session);
}

void ours_periodic_alpha(Trial& trial, int dim, const inputs::Points& points) {
    Session session(dim);
    inputs::Points cube(static_cast<std::size_t>(dim * dim), 0.0);
    for (int k = 0; k < dim; ++k) cube[static_cast<std::size_t>(k * dim + k)] = 1;
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(session.dim(), points).set_lattice(cube);
    persist_in_block(trial, request, session);
}

}  // namespace bench
