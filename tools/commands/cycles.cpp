#include "tools/commands/cycles.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

using Vertices = std::vector<std::uint32_t>;

void toggle(std::set<Vertices>& chain, const Vertices& simplex) {
    const auto [place, added] = chain.insert(simplex);
    if (!added) chain.erase(place);
}

std::string cycle_complaint(const netmesh_context* context, std::uint64_t index, const netmesh_pair& pair) {
    std::uint64_t count = 0;
    if (netmesh_get_cycle(context, index, &count) != NETMESH_OK || count == 0) return "has no cycle";
    if (pair.degree == 0 && count != (std::isfinite(pair.death) ? 2 : 1)) return "has a chain of too many vertices";
    std::set<Vertices> boundary, simplices;
    double latest = -HUGE_VAL;
    for (std::uint64_t i = 0; i < count; i++) {
        netmesh_simplex simplex;
        netmesh_get_cycle_simplex(context, index, i, &simplex);
        latest = std::fmax(latest, simplex.value);
        const Vertices vertices(simplex.vertices, simplex.vertices + pair.degree + 1);
        if (!simplices.insert(vertices).second) return "has a simplex twice in its cycle";
        for (std::size_t v = 0; v < vertices.size() && pair.degree > 0; v++) {
            Vertices face = vertices;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(v));
            toggle(boundary, face);
        }
    }
    if (!boundary.empty()) return "has a chain with a boundary";
    return latest == pair.birth ? "" : "has a cycle that is not born with it";
}

}  // namespace

void write_cycles(const netmesh_context* context, TextWriter& out) {
    netmesh_pair pair;
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; i++) {
        std::uint64_t count = 0;
        netmesh_get_cycle(context, i, &count);
        out << "bar " << pair.degree << ' ' << pair.birth << ' ' << pair.death << ' ' << count << '\n';
        netmesh_simplex simplex;
        for (std::uint64_t n = 0; netmesh_get_cycle_simplex(context, i, n, &simplex) == NETMESH_OK; n++) {
            for (std::uint32_t v = 0; v <= pair.degree; v++)
                out << simplex.vertices[v] << (v < pair.degree ? ' ' : '\n');
        }
    }
}

std::string cycles_complaint(const netmesh_context* context) {
    netmesh_pair pair;
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; i++) {
        const std::string complaint = cycle_complaint(context, i, pair);
        if (complaint.empty()) continue;
        return "bar " + std::to_string(pair.degree) + " " + number_text(pair.birth) + " " + number_text(pair.death) +
               " " + complaint;
    }
    return {};
}

}  // namespace netmesh::tool
