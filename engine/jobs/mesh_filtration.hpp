// A mesh that is filtered, as homology takes it.
#pragma once
#include "filtration/any_mesh.hpp"
#include "homology/lower_star/lower_star.hpp"

namespace netmesh {

// By these values of the vertices, of what is there of the mesh.
inline LowerStarFiltration<any_dimension> mesh_filtration(const AnyMesh& mesh, const double* value,
                                                          std::uint32_t zero_born) {
    return {mesh.store.view(), value, zero_born, mesh.filtered_part()};
}

}  // namespace netmesh
