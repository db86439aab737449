#include "tools/commands/cycles.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "tools/io/numbers.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

void toggle(std::set<Vertices>& chain, const Vertices& simplex) {
    const auto [place, added] = chain.insert(simplex);
    if (!added) chain.erase(place);
}

// Adds the faces of a simplex to a chain over Z/2.
void add_boundary(const Vertices& simplex, std::set<Vertices>& chain) {
    for (std::size_t v = 0; v < simplex.size() && simplex.size() > 1; v++) {
        Vertices face = simplex;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(v));
        toggle(chain, face);
    }
}

std::string cycle_complaint(const Engine& engine, std::uint64_t index, const netmesh_pair& pair,
                            const FilteredComplex* complex) {
    std::set<Vertices> boundary, simplices;
    double latest = -HUGE_VAL;
    bool twice = false;
    const netmesh_status status = engine.for_each_in_cycle(index, [&](std::uint64_t, const netmesh_simplex& simplex) {
        latest = std::fmax(latest, simplex.value);
        const Vertices vertices(simplex.vertices, simplex.vertices + pair.degree + 1);
        twice = !simplices.insert(vertices).second || twice;
        add_boundary(vertices, boundary);
    });
    if (status != NETMESH_OK || simplices.empty()) return "has no cycle";
    if (twice) return "has a simplex twice in its cycle";
    if (pair.degree == 0 && simplices.size() != (std::isfinite(pair.death) ? 2 : 1))
        return "has a chain of too many vertices";
    if (!boundary.empty()) return "has a chain with a boundary";
    if (latest != pair.birth) return "has a cycle that is not born with it";
    if (complex == nullptr) return "";
    return complex->cycle_complaint({simplices.begin(), simplices.end()}, {pair.degree, pair.birth, pair.death});
}

}  // namespace

namespace {

template <class Visit> void for_each_chosen(const Engine& engine, const std::vector<bool>& chosen, Visit visit) {
    engine.for_each_pair([&](std::uint64_t i, const netmesh_pair& pair) {
        if (chosen.empty() || chosen[i]) visit(i, pair);
    });
}

void write_cycles_text(const Engine& engine, const std::vector<bool>& chosen, TextWriter& out) {
    for_each_chosen(engine, chosen, [&](std::uint64_t i, const netmesh_pair& pair) {
        std::uint64_t count = 0;
        netmesh_get_cycle(engine.context(), i, &count);
        out << "bar " << pair.degree << ' ' << pair.birth << ' ' << pair.death << ' ' << count << '\n';
        engine.for_each_in_cycle(i, [&](std::uint64_t, const netmesh_simplex& simplex) {
            for (std::uint32_t v = 0; v <= pair.degree; v++)
                out << simplex.vertices[v] << (v < pair.degree ? ' ' : '\n');
        });
    });
}

}  // namespace

void write_cycles(const Engine& engine, TextWriter& out) { write_cycles_text(engine, {}, out); }

void write_cycles(const Engine& engine, const std::string& path, const std::vector<bool>& chosen,
                  const CyclePlaces& places, TextWriter& out) {
    const std::string ending = ending_of(path);
    if (!needs_places(ending)) return write_cycles_text(engine, chosen, out);
    std::vector<CycleEntry> cycles;
    for_each_chosen(engine, chosen, [&](std::uint64_t i, const netmesh_pair& pair) {
        CycleEntry entry{{pair.degree, pair.birth, pair.death}, {}, 0};
        engine.for_each_in_cycle(i, [&](std::uint64_t, const netmesh_simplex& simplex) {
            entry.simplices.emplace_back(simplex.vertices, simplex.vertices + pair.degree + 1);
        });
        cycles.push_back(std::move(entry));
    });
    if (ending == ".vtu") return write_cycles_vtu(cycles, places, out);
    if (ending == ".obj") return write_cycles_obj(cycles, places, out);
    write_cycle_picture(cycles, places, out);
}

CyclePlaces places_of(const PointCloud& cloud) {
    CyclePlaces places;
    places.dim = cloud.dim;
    std::set<std::vector<double>> seen;
    for (std::size_t i = 0; i < cloud.rows(); i++) {
        const double* const point = &cloud.coordinates[i * cloud.dim];
        if (!seen.emplace(point, point + cloud.dim).second) continue;
        places.coordinates.insert(places.coordinates.end(), point, point + cloud.dim);
    }
    places.inputs = seen.size();
    return places;
}

std::string cycles_complaint(const Engine& engine, const SimplexList& complex, double slack) {
    std::optional<FilteredComplex> reduced;
    if (complex) reduced.emplace(*complex, slack);
    std::string found;
    engine.for_each_pair([&](std::uint64_t i, const netmesh_pair& pair) {
        if (!found.empty()) return;
        const std::string complaint = cycle_complaint(engine, i, pair, reduced ? &*reduced : nullptr);
        if (complaint.empty()) return;
        found = "bar " + std::to_string(pair.degree) + " " + number_text(pair.birth) + " " + number_text(pair.death) +
                " " + complaint;
    });
    return found;
}

std::string cycles_checked(const SimplexList& complex) {
    if (complex) return "every bar has a cycle that is born with it and dies with it";
    return "every bar has a cycle that is born with it; more than " +
           counted(opinion_simplices_max, "simplex", "simplices") + ", so nobody looked when it dies";
}

}  // namespace netmesh::tool
