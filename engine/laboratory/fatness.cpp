#include "laboratory/fatness.hpp"

#include "certificate/rounding.hpp"
#include "laboratory/fat_cell.hpp"
#include "laboratory/in_ball.hpp"
#include "numerics/elementary.hpp"
#include "numerics/vector.hpp"

namespace netmesh {
namespace {

constexpr int clipped_rounds = 12;  // cutting planes for an in-ball at the sphere

enum Part : std::uint8_t { part_inside = 0, part_bounded = 1, part_all = 2, part_none = 3 };
constexpr int parts = 3;

// What is measured of one vertex. Lengths are relative to nothing, points to the vertex.
struct CellMeasure {
    std::uint32_t corners;
    std::uint32_t degree[parts];   // neighbours in the part
    double faces[parts];           // simplices with them, each as often as it is in a cell
    double in_radius, out_radius;  // of in-ball and out-ball
    double nearest, farthest;      // distance to the nearest neighbour and to the farthest corner
    double doubt;                  // of a corner
    bool whole;                    // the cell is not clipped
    bool among[parts];             // all neighbours are in the part
};

// Points about one vertex, in scratch memory.
struct Points {
    std::size_t dim;
    double* x;
    std::uint32_t count;

    bool take(int d, Arena& arena, std::size_t capacity) {
        dim = static_cast<std::size_t>(d);
        count = 0;
        x = arena.take_low<double>(capacity * dim);
        return x != nullptr;
    }
    void add(const double* p, const double* origin) {
        for (std::size_t k = 0; k < dim; ++k) x[count * dim + k] = p[k] - origin[k];
        ++count;
    }
};

class Fatness {
public:
    Fatness(const AnyStore& store, const AnyDomain& domain, Arena& arena, FatnessAnalysis* analysis)
        : dim(store.dim), store_(store), domain_(domain), arena_(arena), analysis_(*analysis) {}

    Status open();
    // Two passes: fatness first, then what depends on its maximum.
    Status run(Monitor& monitor);

private:
    bool holds(int part, std::uint32_t v) const { return part_[v] <= part; }
    FatPart& of(int part) {
        return part == part_inside ? analysis_.inside : part == part_bounded ? analysis_.bounded : analysis_.all;
    }
    Status run_over_all(Monitor& monitor);
    Status measure_all(FattestCells& cells, VertexId v, CellMeasure* m);
    Status measure(VertexId v, bool balls, CellMeasure* m, double* clipped);
    void collect(VertexId v, CellId c, CellMeasure* m, Points* neighbours);
    void add_clipped(VertexId v, CellId c, Points* corners);
    double clipped_fatness(VertexId v, const CellMeasure& m, Points corners, Points neighbours);
    void add(const CellMeasure& m, int which);
    void compare(const CellMeasure& m, int which);

    const int dim;
    const AnyStore& store_;
    const AnyDomain& domain_;
    Arena& arena_;
    FatnessAnalysis& analysis_;
    std::uint8_t* part_;  // [vertices]: the smallest part that the vertex belongs to
};

[[gnu::cold]] Status Fatness::open() {
    analysis_ = {};
    const std::uint32_t count = store_.state.vertex_count;
    part_ = arena_.take_low<std::uint8_t>(count);
    if (part_ == nullptr) return Status::out_of_memory;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store_.arena.piece(v, count, 8); v < piece; ++v) {
            part_[v] = store_.vertex(v).cell == none               ? part_none
                       : store_.vertex(v).marker == Marker::exempt ? part_all
                                                                   : part_inside;
            store_.vertex(v).next = none;
        }
    for (std::uint32_t c = 0; c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 60 * dim); c < piece; ++c) {
            const AnyCell cell = store_.cell(c);
            const bool known = FatCells::knows(store_, CellId(c));
            const std::uint8_t least = !known ? part_none : domain_.contains(cell.centre) ? part_inside : part_bounded;
            for (int i = 0; i <= dim; ++i) {
                if (part_[cell.vertex[i]] < least) part_[cell.vertex[i]] = least;
                if (cell.neighbour[i] != none) continue;
                for (int j = 0; j <= dim; ++j)
                    if (j != i && part_[cell.vertex[j]] < part_all) part_[cell.vertex[j]] = part_all;
            }
        }
    return Status::ok;
}

// One cell of v's star: its corner's distance, and the neighbours not met before.
[[gnu::cold]] void Fatness::collect(VertexId v, CellId c, CellMeasure* m, Points* neighbours) {
    const AnyCell cell = store_.cell(c);
    const double* const x = store_.point(v);
    const double error = static_cast<double>(cell.error), radius = square_root(cell.radius2);
    if (error * radius > m->doubt) m->doubt = error * radius;
    if (radius * (1 + error) * up > m->farthest) m->farthest = radius * (1 + error) * up;
    unsigned subsets[2] = {1, 1};  // of the cell's other vertices, as far as they are in the part
    for (const VertexId w : cell.vertex) {
        for (int part = part_inside; part <= part_bounded && w != v; ++part)
            if (holds(part, w)) subsets[part] *= 2;
        if (w == v || store_.vertex(w).next == v) continue;
        store_.vertex(w).next = v;
        neighbours->add(store_.point(w), x);
        const double length = square_root(distance2(dim, store_.point(w), x));
        if (length < m->nearest) m->nearest = length;
        for (int part = part_inside; part <= part_bounded; ++part) {
            m->degree[part] += holds(part, w);
            m->among[part] = m->among[part] && holds(part, w);
        }
    }
    for (int part = part_inside; part <= part_bounded; ++part) m->faces[part] += subsets[part] - 1;
}

// Corners of v's clipped cell at corner c: itself inside, crossings of its edges outside.
[[gnu::cold]] void Fatness::add_clipped(VertexId v, CellId c, Points* corners) {
    const AnyCell cell = store_.cell(c);
    if (domain_.contains(cell.centre)) {
        corners->add(cell.centre, store_.point(v));
        return;
    }
    for (int i = 0; i <= dim; ++i) {
        if (cell.vertex[i] == v) continue;
        const CellId n = cell.neighbour[i].cell();
        if (n < c && !domain_.contains(store_.cell(n).centre)) continue;  // seen from the other end
        double z[2][dimension_max];
        const int crossings = sphere_crossings(domain_, cell.centre, store_.cell(n).centre, z);
        for (int j = 0; j < crossings; ++j) corners->add(z[j], store_.point(v));
    }
}

// Out-radius over in-radius of the clipped cell; 0 when no corner of it is known. In-balls are kept in the domain by
// cutting planes: a tangent plane of the sphere is a bisector with the vertex's mirror image.
[[gnu::cold]] double Fatness::clipped_fatness(VertexId v, const CellMeasure& m, Points corners, Points neighbours) {
    double out_radius, centre[dimension_max] = {};
    if (corners.count < 2 || !domain_.contains(store_.point(v))) return 0;
    smallest_enclosing_ball(dim, corners.x, corners.count, centre, &out_radius);
    double best = 0;
    for (int round = 0; round < clipped_rounds; ++round) {
        arena_.pass(2 * neighbours.count);
        const double radius = largest_inscribed_ball(dim, neighbours.x, neighbours.count, m.nearest, centre);
        double away2 = 0, toward = 0;
        for (int k = 0; k < dim; ++k) {
            const double d = store_.point(v)[k] + centre[k] - domain_.centre[k];
            away2 += d * d;
            toward += d * (store_.point(v)[k] - domain_.centre[k]);
        }
        const double away = square_root(away2), room = domain_.radius - away;
        const double inside = radius < room ? radius : room;
        if (inside > best) best = inside;
        if (radius <= room * up || !(away > 0)) break;
        // u = d / away, b = R - u . (v - c); the mirror image is 2 b u away.
        const double b = domain_.radius - toward / away;
        double mirror[dimension_max];
        const double zero[dimension_max] = {};
        for (int k = 0; k < dim; ++k) mirror[k] = 2 * b * (store_.point(v)[k] + centre[k] - domain_.centre[k]) / away;
        neighbours.add(mirror, zero);
    }
    return best > 0 ? out_radius / best : 0;
}

[[gnu::cold]] Status Fatness::measure(VertexId v, bool balls, CellMeasure* m, double* clipped) {
    *m = {0, {}, {}, 0, 0, infinity, 0, 0, true, {true, true, true}};
    *clipped = 0;
    if (!visit_any_star(store_, v, [&](CellId) { ++m->corners; })) return Status::out_of_memory;
    ArenaScope scope(arena_);
    const bool clips = part_[v] == part_bounded && domain_.radius > 0;
    const std::size_t d = static_cast<std::size_t>(dim);
    Points corners, neighbours, cut;
    if (!corners.take(dim, arena_, m->corners) || !neighbours.take(dim, arena_, m->corners * d + clipped_rounds) ||
        !cut.take(dim, arena_, clips ? m->corners * 2 * d : 0))
        return Status::out_of_memory;
    const bool room = visit_any_star(store_, v, [&](CellId c) {
        collect(v, c, m, &neighbours);
        corners.add(store_.cell(c).centre, store_.point(v));
        if (clips && balls) add_clipped(v, c, &cut);
    });
    if (!room) return Status::out_of_memory;
    if (!balls) return Status::ok;
    double centre[dimension_max];
    arena_.pass(2 * corners.count);
    smallest_enclosing_ball(dim, corners.x, corners.count, centre, &m->out_radius);
    m->out_radius = (m->out_radius + m->doubt) * up;
    // The ball about the vertex encloses the cell too.
    if (m->farthest < m->out_radius) m->out_radius = m->farthest;
    m->in_radius = largest_inscribed_ball(dim, neighbours.x, neighbours.count, m->nearest, centre) / up;
    const double least = 0.5 * m->nearest / up;
    if (!(m->in_radius > least)) m->in_radius = least;
    if (clips) *clipped = clipped_fatness(v, *m, cut, neighbours);
    if (part_[v] == part_inside) *clipped = m->out_radius / m->in_radius;
    return Status::ok;
}

// S of fatness.hpp: the volume of the regular d-simplex in the unit ball.
double regular_simplex_volume(int d) {
    double volume = square_root(static_cast<double>(d + 1));
    for (int k = 1; k <= d; ++k) volume *= square_root((d + 1.0) / d) / k;
    return volume;
}

[[gnu::cold]] void Fatness::add(const CellMeasure& m, int which) {
    FatPart* const part = &of(which);
    const std::uint32_t degree = m.degree[which];
    const double faces = m.faces[which];
    const double beta = m.out_radius / m.in_radius * up, aspect = 2 * m.farthest / m.nearest * up;
    if (beta > part->beta_max) part->beta_max = beta;
    if (aspect > part->aspect_max) part->aspect_max = aspect;
    part->beta_mean += beta;
    ++part->cells;
    part->edges += degree;
    if (degree > part->degree_max) part->degree_max = degree;
    // Simplices at the vertex: each is one of some cell, and of some of the neighbours.
    double choices = 1, sum = 0;
    for (int j = 1; j <= dim; ++j) {
        choices *= (static_cast<double>(degree) - j + 1) / j;
        sum += choices > 0 ? choices : 0;
    }
    part->faces += sum < faces ? sum : faces;
    const double least = 2 * unit_ball_volume(dim - 1) / (regular_simplex_volume(dim - 1) * power(2 * beta, dim));
    const double share = least / static_cast<double>(m.corners);
    if (m.whole && share > part->corners_share) part->corners_share = share;
}

// The bounds that hold vertex by vertex.
[[gnu::cold]] void Fatness::compare(const CellMeasure& m, int which) {
    FatPart& part = of(which);
    const double beta = part.beta_max, degree = static_cast<double>(m.degree[which]);
    int layers = 1;
    for (double ratio = 2 * m.farthest / m.nearest; ratio >= 2 && layers < 2048; ratio *= 0.5) ++layers;
    const double share = degree / (power(8 * beta, dim) * layers);
    if (share > part.degree_share) part.degree_share = share;
    if (dim == 2) {
        const double planar = degree * arcsine(1 / (4 * beta)) / 18.849555921538759;
        if (m.among[which] && planar > part.planar_share) part.planar_share = planar;
    }
}

[[gnu::cold]] void finish_part(int dim, FatPart* part) {
    const double cells = static_cast<double>(part->cells);
    if (part->cells > 0) part->beta_mean /= cells;
    part->edges /= 2;
    part->edges_bound = power(4 * part->beta_max, dim) * cells;
    part->faces_bound = power(4 * part->beta_max, dim * dim) * cells;
}

[[gnu::cold]] Status Fatness::run(Monitor& monitor) {
    const std::uint32_t count = store_.state.vertex_count;
    CellMeasure m;
    double clipped;
    for (VertexId v(0); v < count; ++v) {
        if (!holds(part_bounded, v)) continue;
        const Status status = measure(v, true, &m, &clipped);
        if (status != Status::ok) return status;
        for (int part = part_[v]; part <= part_bounded; ++part) add(m, part);
        if (clipped > 0) ++analysis_.clipped;
        analysis_.clipped_mean += clipped;
        if (clipped > analysis_.clipped_max) analysis_.clipped_max = clipped;
        if (monitor.advance(v, 1 + 12 * m.corners)) return Status::cancelled;
    }
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store_.arena.piece(v, count, 8); v < piece; ++v) {
            store_.vertex(v).next = none;
        }
    for (VertexId v(0); v < count; ++v) {
        if (!holds(part_bounded, v)) continue;
        const Status status = measure(v, false, &m, &clipped);
        if (status != Status::ok) return status;
        for (int part = part_[v]; part <= part_bounded; ++part) compare(m, part);
        if (monitor.advance(v, 1 + 2 * m.corners)) return Status::cancelled;
    }
    finish_part(dim, &analysis_.bounded);
    finish_part(dim, &analysis_.inside);
    if (analysis_.clipped > 0) analysis_.clipped_mean /= static_cast<double>(analysis_.clipped);
    return run_over_all(monitor);
}

// in_radius 0: the cell is not of the part.
[[gnu::cold]] Status Fatness::measure_all(FattestCells& cells, VertexId v, CellMeasure* m) {
    FatCell cell;
    FattestCells::Piece piece;
    *m = {};
    const Status status = cells.measure(v, &cell, &piece);
    m->degree[part_all] = cell.met;
    m->whole = m->among[part_all] = piece == FattestCells::Piece::whole;
    m->corners = cell.corners;
    m->faces[part_all] = static_cast<double>(cell.corners) * ((1 << dim) - 1);
    m->in_radius = cell.in_radius;
    m->out_radius = cell.out_radius;
    m->nearest = cell.nearest;
    m->farthest = cell.reach;
    if (status == Status::ok && !(cell.in_radius > 0)) {
        part_[v] = part_none;
        ++analysis_.left_out;
    }
    return status;
}

// Which cells there are, then what they are like, then what depends on the largest beta.
[[gnu::cold]] Status Fatness::run_over_all(Monitor& monitor) {
    FattestCells cells(store_, domain_, arena_, part_, part_all);
    analysis_.all_radius = cells.radius();
    const std::uint32_t count = store_.state.vertex_count;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store_.arena.piece(v, count, 8); v < piece; ++v) {
            analysis_.left_out += part_[v] == part_none && store_.vertex(v).cell != none;
            store_.vertex(v).next = none;
        }
    CellMeasure m;
    for (int pass = 0; pass < 3; ++pass) {
        for (VertexId v(0); v < count; ++v) {
            if (!holds(part_all, v)) continue;
            const Status status = measure_all(cells, v, &m);
            if (status != Status::ok) return status;
            if (pass == 1) add(m, part_all);
            if (pass == 2) compare(m, part_all);
            if (monitor.advance(v, 1 + 12 * m.corners)) return Status::cancelled;
        }
    }
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store_.arena.piece(v, count, 8); v < piece; ++v) {
            store_.vertex(v).next = none;
        }
    finish_part(dim, &analysis_.all);
    return Status::ok;
}

}  // namespace

Status analyse_fatness(const AnyStore& store, const AnyDomain& domain, const Work& work, FatnessAnalysis* analysis) {
    ArenaScope scope(work.arena);
    Fatness fatness(store, domain, work.arena, analysis);
    const Status status = fatness.open();
    return status == Status::ok ? fatness.run(work.monitor) : status;
}

const char* violated_fatness_bound(const FatPart& part) {
    if (!(static_cast<double>(part.edges) <= part.edges_bound)) return "more edges than fat cells have (5.3.1)";
    if (!(part.faces <= part.faces_bound)) return "more faces than fat cells have (5.3.2)";
    if (!(part.degree_share <= 1)) return "more neighbours than a fat cell has (5.3.3)";
    if (!(part.planar_share <= 1)) return "more neighbours than a fat cell in the plane has (5.4.5)";
    if (!(part.corners_share <= 1)) return "fewer corners than a fat cell has (5.5.1)";
    return nullptr;
}

}  // namespace netmesh
