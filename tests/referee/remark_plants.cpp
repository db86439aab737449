// Violations of tau, eps, ratio, domain and boundary net: the mesh is good, what is said of it is not.
#include "plants.hpp"

namespace referee {
namespace {

bool less_tau(Mesh* mesh, const Planter& p) {
    mesh->tau = p.worst * 0.98;
    return mesh->tau > 2;
}

bool no_tau(Mesh* mesh, const Planter& p) {
    mesh->tau = 0;
    return p.worst > promised_tau(*mesh);
}

bool less_eps(Mesh* mesh, const Planter&) {
    mesh->eps *= 0.7;
    return mesh->eps > 0;
}

bool less_size(Mesh* mesh, const Planter&) {
    mesh->least_size *= 0.7;
    mesh->growth *= 0.7;
    return mesh->least_size > 0;
}

bool size_of_none(Mesh* mesh, const Planter&) {
    mesh->least_size = 0.1 * mesh->radius;
    mesh->growth = 0;
    return true;
}

bool eps_of_none(Mesh* mesh, const Planter&) {
    mesh->eps = 0.2;
    return true;
}

bool less_net(Mesh* mesh, const Planter&) {
    mesh->net = (mesh->net > 0 ? mesh->net : 1) / 2;
    return true;
}

bool more_net(Mesh* mesh, const Planter&) {
    mesh->net = (mesh->net > 0 ? mesh->net : 1) * 2;
    return true;
}

bool net_of_none(Mesh* mesh, const Planter&) {
    mesh->net = 1;
    return true;
}

bool less_ratio(Mesh* mesh, const Planter& p) {
    mesh->ratio = p.worst * 0.98;
    return mesh->ratio > 1.4143;
}

bool ratio_becomes_tau(Mesh* mesh, const Planter& p) {
    mesh->tau = 2 + 1e-3 * p.random.unit();
    mesh->ratio = 0;
    mesh->clipped = false;
    mesh->values.clear();
    return true;
}

// Whole cells near the sphere reach farther than their clipped parts.
bool clipped_becomes_whole(Mesh* mesh, const Planter&) {
    mesh->clipped = false;
    return true;
}

// More of the cells counts, where nothing was refined.
bool larger_ball(Mesh* mesh, const Planter& p) {
    mesh->radius *= p.random.between(1.2, 2);
    return true;
}

bool ball_leaves_out_an_input(Mesh* mesh, const Planter&) {
    double reach = 0;
    for (std::uint32_t v = 0; v < mesh->count(); v++)
        if (mesh->markers[v] == input_marker)
            reach = std::fmax(reach, distance(mesh->vertices[v], mesh->centre, mesh->dim));
    mesh->radius = reach * (1 - 1e-9);
    return true;
}

bool larger_domain(Mesh* mesh, const Planter&) {
    mesh->radius *= 2;
    return true;
}

bool domain_beyond_hull(Mesh* mesh, const Planter&) {
    mesh->radius *= 1000;
    return true;
}

bool smaller_domain(Mesh* mesh, const Planter&) {
    mesh->radius /= 3;
    return true;
}

// Smaller by so little that one input or two are outside.
bool domain_a_little_smaller(Mesh* mesh, const Planter&) {
    double reach = 0;
    for (std::uint32_t v = 0; v < mesh->count(); v++)
        if (mesh->markers[v] == input_marker)
            reach = std::fmax(reach, distance(mesh->vertices[v], mesh->centre, mesh->dim));
    mesh->radius = reach * (1 - 1e-6);
    return true;
}

bool domain_is_a_dot(Mesh* mesh, const Planter&) {
    mesh->radius *= 1e-9;
    return true;
}

bool domain_beside(Mesh* mesh, const Planter&) {
    mesh->centre[0] += 1.5 * mesh->radius;
    return true;
}

bool no_domain(Mesh* mesh, const Planter&) {
    mesh->has_domain = false;
    return true;
}

bool domain_of_triangulation(Mesh* mesh, const Planter&) {
    mesh->has_domain = true;
    mesh->tau = 1e6;
    for (std::size_t v = 0; v < mesh->count(); v++)
        mesh->radius = std::fmax(mesh->radius, distance(mesh->vertices[v], mesh->centre, mesh->dim));
    return true;
}

}  // namespace

const std::vector<Plant>& remark_plants() {
    static const std::vector<Plant> all = {
        {"tau is less than a cell's ratio", plain | caged | netted | sized | thesis, false, false, less_tau},
        {"tau is gone, and a cell's ratio above the default", plain | caged | netted | sized | thesis, false, false,
         no_tau},
        {"eps is less than a cell's", sized, false, false, less_eps},
        {"eps in a mesh that was not refined to it", plain | netted, false, false, eps_of_none},
        {"cell-size is less than a cell's", sized, false, false, less_size},
        {"a cell-size in a mesh that was not refined to it", plain | netted, false, false, size_of_none},
        {"the boundary net is said to be finer", netted, false, false, less_net},
        {"the boundary net is said to be coarser", netted, false, false, more_net},
        {"a boundary net that is not there", plain | caged | sized | certified | clipped, false, false, net_of_none},
        {"the ratio is less than a cell's", certified | clipped, false, false, less_ratio},
        {"the ratio of clipped cells is said of whole ones", clipped, false, false, clipped_becomes_whole},
        {"the ball that cells are clipped to is larger", clipped, false, false, larger_ball},
        {"the ball that cells are clipped to leaves out an input", clipped, true, false, ball_leaves_out_an_input},
        {"tau in place of the ratio", certified | clipped, false, false, ratio_becomes_tau},
        {"the domain is larger", plain | caged | sized, false, false, larger_domain},
        {"the domain reaches beyond the hull", meshes, true, false, domain_beyond_hull},
        {"the domain is a third", plain | caged | sized | certified | clipped | thesis, true, false, smaller_domain},
        {"the domain leaves out an input", plain | caged | sized | certified | clipped | thesis, true, false,
         domain_a_little_smaller},
        {"the domain is a dot", meshes, true, false, domain_is_a_dot},
        {"the domain is beside the inputs", meshes, true, false, domain_beside},
        {"the domain is gone", meshes, true, false, no_domain},
        {"a domain about a triangulation", triangulation, true, false, domain_of_triangulation},
    };
    return all;
}

}  // namespace referee
