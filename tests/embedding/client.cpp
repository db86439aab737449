// A C++ client: two contexts, one of them moved to another address by copying its bytes, give the same diagram.
#include <netmesh.hpp>

#include <cstdio>
#include <cstring>
#include <initializer_list>

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 20;
alignas(16) unsigned char first[block_bytes], second[block_bytes], moved[block_bytes];

}  // namespace

int main() {
    const double points[] = {0, 0, 2, 0, 2, 2, 0, 2, 1, -0.5, 2.5, 1, 1, 2.5, -0.5, 1};
    netmesh::Request mesh(&netmesh_filter_complete);
    mesh.set_points(2, netmesh::Span<const double>(points, 16));
    mesh.mesh.method = &netmesh_method_svr;
    const netmesh::Request persist(&netmesh_filter_complete);  // of the mesh that the context holds
    std::memset(second, 0xAA, sizeof second);
    netmesh::Engine a(first, sizeof first), b(second, sizeof second);
    for (netmesh::Engine* engine : {&a, &b}) {
        if (engine->mesh(mesh) != NETMESH_OK) return 1;
        if (engine->check() != NETMESH_OK) return 2;
        netmesh_analysis analysis;
        if (engine->analyse(&analysis) != NETMESH_OK) return 2;
        if (analysis.fatness.bounded.degree_share > 1) return 2;
    }
    std::memcpy(moved, second, sizeof second);
    std::memset(second, 0, sizeof second);
    netmesh::Engine c = netmesh::Engine::adopt(moved);
    if (c.status() != NETMESH_OK) return 3;
    if (c.persist(persist) != NETMESH_OK) return 4;
    if (a.persist(persist) != NETMESH_OK) return 5;
    if (c.report().fingerprint != a.report().fingerprint) return 7;
    int loops = 0;
    a.for_each_pair(
        [&](std::uint64_t, const netmesh_pair& pair) { loops += pair.degree == 1 && pair.death > 1.2 * pair.birth; });
    std::printf("%d loop\n", loops);
    return loops == 1 ? 0 : 8;
}
