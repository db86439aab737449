#include "laboratory/fat_cell.hpp"

#include "certificate/rounding.hpp"
#include "laboratory/in_ball.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "numerics/vector.hpp"

namespace netmesh {
namespace {

constexpr double least_square = 0x1p-960;  // shorter edges have squares that doubles do not hold
constexpr int clipping_rounds = 12;        // cutting planes for an in-ball at the sphere

}  // namespace

[[gnu::cold]] bool FatCells::knows(const AnyStore& store, CellId c) {
    const AnyCell cell = store.cell(c);
    const int dim = store.dim;
    bool known = cell.radius2 < infinity && static_cast<double>(cell.error) < 0x1p-10;
    for (int i = 0; i <= dim; ++i)
        for (int j = 0; j < i; ++j)
            known &= distance2(dim, store.point(cell.vertex[i]), store.point(cell.vertex[j])) > least_square;
    return known;
}

[[gnu::cold]] AnyDomain FatCells::surrounding_ball(const AnyStore& store) {
    AnyDomain ball;
    ball.dim = store.dim;
    ball.enclosing_radius = enclosing_radius_of_inputs(
        {store.dim, store.first_point(), store.point_stride(), store.state.vertex_count}, store.arena, ball.centre);
    double reach2 = ball.enclosing_radius * ball.enclosing_radius;
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece =
                 store.arena.piece(c, store.state.cell_slots, 60 * static_cast<std::uint32_t>(store.dim));
             c < piece; ++c) {
            const double d2 = ball.distance2(store.cell(c).centre);
            if (knows(store, c) && d2 > reach2) reach2 = d2;
        }
    ball.radius = 2 * square_root(reach2);
    return ball;
}

void FatCells::add_point(const double* x) {
    copy(dim, x, point_ + std::size_t{points_++} * static_cast<std::size_t>(dim));
}

// Vertex::next is the place of a neighbour in the list, where the list agrees.
[[gnu::cold]] void FatCells::add_neighbour(VertexId v, VertexId w, FatCell* cell) {
    const std::uint32_t place = store_.vertex(w).next;
    if (w == v || (place < cell->degree && neighbour_[place] == w)) return;
    store_.vertex(w).next = VertexId(cell->degree);
    neighbour_[cell->degree] = w;
    meets_[cell->degree++] = false;
    const double length = distance(dim, store_.point(v), store_.point(w));
    if (length < cell->nearest) cell->nearest = length;
}

// A corner, or a point of the edge that all vertices of the cell but this one share.
[[gnu::cold]] void FatCells::note_facets(const AnyCell& cell, int left_out) {
    for (int k = 0; k <= dim; ++k) {
        const std::uint32_t place = k == left_out ? none : store_.vertex(cell.vertex[k]).next;
        if (place != none) meets_[place] = true;  // v itself has none
    }
}

[[gnu::cold]] void FatCells::add_corners(VertexId v, CellId c, FatCell* cell) {
    const AnyCell here = store_.cell(c);
    const double doubt = static_cast<double>(here.error) * square_root(here.radius2);
    for (const VertexId w : here.vertex) add_neighbour(v, w, cell);
    if (ball_.contains(here.centre)) {
        if (doubt > doubt_) doubt_ = doubt;
        const double d = distance(dim, here.centre, store_.point(v));
        if (d > cell->reach) cell->reach = d;
        add_point(here.centre);
        note_facets(here, -1);
    } else {
        cell->whole = false;
    }
    for (int i = 0; i <= dim; ++i) {
        if (here.vertex[i] == v) continue;
        if (here.neighbour[i] == none) {
            cell->bounded = cell->whole = false;
            continue;
        }
        const CellId n = here.neighbour[i].cell();
        if (n < c) continue;  // seen from the other end
        double z[2][dimension_max];
        const int crossings = sphere_crossings(ball_, here.centre, store_.cell(n).centre, z);
        if (crossings > 0) note_facets(here, i);
        for (int j = 0; j < crossings; ++j) {
            const double d = distance(dim, z[j], store_.point(v));
            if (d > cell->reach) cell->reach = d;
            add_point(z[j]);
        }
    }
}

// A half-space is told by the mirror image of the origin: half of the way from v to the mean of all points that span
// the clipped cell, far from all of its sides, so that the search for the in-ball has a short way. In-balls are kept in
// the ball by tangent planes, one after the other.
[[gnu::cold]] void FatCells::measure_in_ball(VertexId v, FatCell* cell) {
    const double* const p = store_.point(v);
    const std::size_t d = static_cast<std::size_t>(dim);
    double origin[dimension_max] = {}, centre[dimension_max];
    for (std::uint32_t i = 0; i < points_; ++i)
        for (int k = 0; k < dim; ++k) origin[k] += point_[std::size_t{i} * d + k] / points_;
    for (int k = 0; k < dim && ball_.contains(p); ++k) origin[k] = 0.5 * (origin[k] + p[k]);
    double lowest = infinity;
    std::uint32_t planes = 0;
    const auto add_plane = [&](const double* normal, double height) {
        if (height < lowest) lowest = height;
        for (int k = 0; k < dim; ++k) plane_[std::size_t{planes} * d + k] = 2 * height * normal[k];
        ++planes;
    };
    for (std::uint32_t i = 0; i < cell->degree; ++i) {
        const double* const w = store_.point(neighbour_[i]);
        const double length = distance(dim, p, w);
        double normal[dimension_max], height = 0.5 * length;
        for (int k = 0; k < dim; ++k) {
            normal[k] = (w[k] - p[k]) / length;
            height -= normal[k] * (origin[k] - p[k]);
        }
        add_plane(normal, height);
    }
    for (int round = 0; round < clipping_rounds && lowest > 0; ++round) {
        arena_.pass(2 * planes);
        const double radius = largest_inscribed_ball(dim, plane_, planes, ball_.radius, centre);
        for (int k = 0; k < dim; ++k) centre[k] += origin[k];
        const double away = distance(dim, centre, ball_.centre), room = ball_.radius - away;
        const double inside = radius < room ? radius : room;
        if (inside > cell->in_radius) {
            cell->in_radius = inside;
            copy(dim, centre, cell->in_centre);
        }
        if (radius <= room * up || !(away > 0)) break;
        double normal[dimension_max], height = ball_.radius;
        for (int k = 0; k < dim; ++k) {
            normal[k] = (centre[k] - ball_.centre[k]) / away;
            height -= normal[k] * (origin[k] - ball_.centre[k]);
        }
        add_plane(normal, height);
    }
    cell->in_radius /= up;
    // The ball about the vertex is in the whole cell.
    const double least = 0.5 * cell->nearest / up;
    if (!cell->whole || cell->in_radius > least) return;
    cell->in_radius = least;
    copy(dim, p, cell->in_centre);
}

[[gnu::cold]] Status FatCells::measure(VertexId v, FatCell* cell) {
    const ArenaScope scope(arena_);
    *cell = {};
    cell->nearest = infinity;
    cell->known = cell->bounded = cell->whole = true;
    const auto count = [&](CellId c) {
        ++cell->corners;
        cell->known &= knows(store_, c);
    };
    if (!visit_any_star(store_, v, count)) return Status::out_of_memory;
    if (!cell->known) return Status::ok;
    const std::size_t corners = cell->corners, d = static_cast<std::size_t>(dim);
    neighbour_ = arena_.take_low<VertexId>(corners * d);
    meets_ = arena_.take_low<bool>(corners * d);
    plane_ = arena_.take_low<double>((corners * d + clipping_rounds) * d);
    point_ = arena_.take_low<double>(corners * (2 * d + 1) * d);
    if (neighbour_ == nullptr || meets_ == nullptr || plane_ == nullptr || point_ == nullptr)
        return Status::out_of_memory;
    points_ = 0;
    doubt_ = 0;
    store_.vertex(v).next = none;
    if (!visit_any_star(store_, v, [&](CellId c) { add_corners(v, c, cell); })) return Status::out_of_memory;
    for (std::uint32_t k = 0; k < cell->degree; ++k)
        cell->met += meets_[k] && (part_ == nullptr || part_[neighbour_[k]] <= most_);
    const double* const p = store_.point(v);
    if (points_ == 0) return Status::ok;  // it does not meet the ball, or with a face alone
    measure_in_ball(v, cell);
    copy(dim, p, cell->out_centre);
    if (cell->whole) {
        // As seen from the vertex, where the coordinates of a small cell have more digits.
        double rounding = 0;
        for (std::uint32_t i = 0; i < points_ * static_cast<std::uint32_t>(dim); ++i)
            point_[i] -= p[i % static_cast<std::uint32_t>(dim)];
        arena_.pass(2 * points_);
        smallest_enclosing_ball(dim, point_, points_, cell->out_centre, &cell->out_radius);
        for (int k = 0; k < dim; ++k) {
            cell->out_centre[k] += p[k];
            rounding += 2 * unit_roundoff * absolute(cell->out_centre[k]);
        }
        cell->out_radius = (cell->out_radius + doubt_ + rounding) * up;
        cell->reach = (cell->reach + doubt_) * up;
    } else if (cell->bounded) {
        double reach2 = cell->reach * cell->reach;
        if (!raise_to_poles(store_, ball_, v, &reach2)) return Status::out_of_memory;
        cell->out_radius = cell->reach = (square_root(reach2) + doubt_) * up;
    } else {
        cell->out_radius = cell->reach = (distance(dim, p, ball_.centre) + ball_.radius) * up;
    }
    // So do the ball about the vertex and the one that clips.
    if (cell->reach < cell->out_radius) {
        cell->out_radius = cell->reach;
        copy(dim, p, cell->out_centre);
    }
    if (ball_.radius < cell->out_radius) {
        cell->out_radius = ball_.radius > 0.5 * cell->reach ? ball_.radius : 0.5 * cell->reach;
        copy(dim, ball_.centre, cell->out_centre);
    }
    return Status::ok;
}

[[gnu::cold]] FattestCells::FattestCells(const AnyStore& store, const AnyDomain& domain, Arena& arena,
                                         const std::uint8_t* part, std::uint8_t most)
    : around_(FatCells::surrounding_ball(store)), first_(domain.radius > 0 ? domain : around_),
      has_domain_(domain.radius > 0), in_first_(store, first_, arena, part, most),
      in_ball_(store, around_, arena, part, most) {}

[[gnu::cold]] Status FattestCells::measure(VertexId v, FatCell* cell, Piece* piece) {
    const Status status = in_first_.measure(v, cell);
    *piece = cell->whole || !cell->known ? Piece::whole : has_domain_ ? Piece::in_domain : Piece::in_ball;
    if (status != Status::ok || *piece != Piece::in_domain) return status;
    FatCell other;
    const Status again = in_ball_.measure(v, &other);
    if (cell->in_radius > 0 && !(other.out_radius * cell->in_radius < cell->out_radius * other.in_radius)) return again;
    other.met = cell->met;
    *cell = other;
    *piece = Piece::in_ball;
    return again;
}

}  // namespace netmesh
