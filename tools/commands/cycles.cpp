#include "tools/commands/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

// Where a vertex is beside its own place; nothing where it is there.
void write_translation(const std::int32_t* times, std::uint32_t axes, TextWriter& out) {
    bool is_moved = false;
    for (std::uint32_t j = 0; j < axes; j++) is_moved = is_moved || times[j] != 0;
    for (std::uint32_t j = 0; j < axes && is_moved; j++) out << (j == 0 ? ':' : ',') << std::to_string(times[j]);
}

void write_cycles_text(const Engine& engine, const std::vector<bool>& chosen, TextWriter& out) {
    const std::uint32_t axes = engine.report().input.periods;
    for_each_chosen(engine, chosen, [&](std::uint64_t i, const netmesh_pair& pair) {
        std::uint64_t count = 0;
        netmesh_get_cycle(engine.context(), i, &count);
        out << "bar " << pair.degree << ' ' << pair.birth << ' ' << pair.death << ' ' << count << '\n';
        engine.for_each_in_cycle(i, [&](std::uint64_t, const netmesh_simplex& simplex) {
            for (std::uint32_t v = 0; v <= pair.degree; v++) {
                out << simplex.vertices[v];
                write_translation(simplex.translations[v], axes, out);
                out << (v < pair.degree ? ' ' : '\n');
            }
        });
    });
}

// A cycle of points that repeat, laid out in space: from simplex to simplex over a vertex that both have, each goes
// where that vertex is. Vertices beside their own places become places of their own.
class LaidOut {
public:
    explicit LaidOut(const CyclePlaces& places) : places_(places) {}

    void add(const netmesh_simplex& simplex) {
        const std::size_t axes = places_.lattice.size() / places_.dim;
        std::vector<Corner> corners;
        for (std::uint32_t v = 0; v <= simplex.degree; v++)
            corners.push_back({simplex.vertices[v], {simplex.translations[v], simplex.translations[v] + axes}});
        for (const Corner& corner : corners) at_vertex_[corner.vertex].push_back(simplices_.size());
        simplices_.push_back(std::move(corners));
    }
    // All that was added, by places; and begins anew.
    std::vector<Vertices> take() {
        std::vector<Vertices> out(simplices_.size());
        std::vector<bool> is_placed(simplices_.size(), false);
        for (std::size_t first = 0; first < simplices_.size(); first++) {
            std::vector<std::size_t> waiting;
            if (!is_placed[first]) waiting.push_back(first);
            is_placed[first] = true;
            for (std::size_t next = 0; next < waiting.size(); next++)
                for (const Corner& corner : simplices_[waiting[next]]) follow(corner, &is_placed, &waiting);
        }
        for (std::size_t s = 0; s < simplices_.size(); s++)
            for (const Corner& corner : simplices_[s]) out[s].push_back(place_of(corner));
        simplices_.clear();
        at_vertex_.clear();
        return out;
    }
    const CyclePlaces& places() const { return places_; }

private:
    struct Corner {
        std::uint32_t vertex;
        std::vector<std::int32_t> times;
    };

    // Moves the other simplices at a corner to where it is.
    void follow(const Corner& corner, std::vector<bool>* is_placed, std::vector<std::size_t>* waiting) {
        for (const std::size_t other : at_vertex_[corner.vertex]) {
            if ((*is_placed)[other]) continue;
            (*is_placed)[other] = true;
            waiting->push_back(other);
            std::vector<std::int32_t> by = corner.times;
            for (const Corner& own : simplices_[other]) {
                if (own.vertex != corner.vertex) continue;
                for (std::size_t j = 0; j < by.size(); j++) by[j] -= own.times[j];
                break;
            }
            for (Corner& own : simplices_[other])
                for (std::size_t j = 0; j < by.size(); j++) own.times[j] += by[j];
        }
    }
    std::uint32_t place_of(const Corner& corner) {
        if (std::count(corner.times.begin(), corner.times.end(), 0) == static_cast<std::ptrdiff_t>(corner.times.size()))
            return corner.vertex;
        const std::size_t dim = places_.dim;
        const auto next = static_cast<std::uint32_t>(places_.coordinates.size() / dim);
        const auto [at, is_new] = moved_.emplace(std::make_pair(corner.vertex, corner.times), next);
        for (std::size_t k = 0; k < dim && is_new; k++) {
            double x = places_.coordinates[corner.vertex * dim + k];
            for (std::size_t j = 0; j < corner.times.size(); j++) x += corner.times[j] * places_.lattice[j * dim + k];
            places_.coordinates.push_back(x);
        }
        return at->second;
    }

    CyclePlaces places_;
    std::vector<std::vector<Corner>> simplices_;
    std::map<std::uint32_t, std::vector<std::size_t>> at_vertex_;
    std::map<std::pair<std::uint32_t, std::vector<std::int32_t>>, std::uint32_t> moved_;
};

}  // namespace

void write_cycles(const Engine& engine, TextWriter& out) { write_cycles_text(engine, {}, out); }

void write_cycles(const Engine& engine, const std::string& path, const std::vector<bool>& chosen,
                  const CyclePlaces& places, TextWriter& out) {
    const std::string ending = ending_of(path);
    if (!needs_places(ending)) return write_cycles_text(engine, chosen, out);
    std::vector<CycleEntry> cycles;
    const bool repeats = !places.lattice.empty();
    LaidOut laid_out(places);
    for_each_chosen(engine, chosen, [&](std::uint64_t i, const netmesh_pair& pair) {
        CycleEntry entry{{pair.degree, pair.birth, pair.death}, {}, 0};
        engine.for_each_in_cycle(i, [&](std::uint64_t, const netmesh_simplex& simplex) {
            if (repeats) return laid_out.add(simplex);
            entry.simplices.emplace_back(simplex.vertices, simplex.vertices + pair.degree + 1);
        });
        if (repeats) entry.simplices = laid_out.take();
        cycles.push_back(std::move(entry));
    });
    const CyclePlaces& all = laid_out.places();
    if (ending == ".vtu") return write_cycles_vtu(cycles, all, out);
    if (ending == ".obj") return write_cycles_obj(cycles, all, out);
    write_cycle_picture(cycles, all, out);
}

CyclePlaces places_of(const PointCloud& cloud) {
    CyclePlaces places;
    places.dim = cloud.dim;
    if (cloud.lattice.kind != Lattice::none) {
        places.coordinates = cloud.coordinates;
        places.inputs = cloud.rows();
        places.lattice = cloud.lattice.vectors;
        return places;
    }
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
