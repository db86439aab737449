#include "delaunay/kernel.hpp"

#include "delaunay/check.hpp"
#include "delaunay/pencils.hpp"
#include "delaunay/planar.hpp"
#include "delaunay/ridges.hpp"
#include "delaunay/spatial.hpp"
#include "predicates/weighted.hpp"
#include "vocabulary/dimension.hpp"

#ifdef __OPTIMIZE_SIZE__
#define NETMESH_APART
#else
#define NETMESH_APART [[gnu::noinline]]  // inlined it would spill registers of its caller and deepen its stack
#endif

namespace netmesh {
namespace {

// Position of a vertex that the cell has. A sum instead of a search, as the exit of a search is hard to predict.
template <int D> std::uint32_t position_in(const Cell<D>& cell, VertexId v) {
    std::uint32_t position = 0;
    for (std::uint32_t j = 1; j <= D; ++j) position += cell.vertex[j] == v ? j : 0;
    return position;
}

// Links new cell `made` to its neighbours at the new vertex. `origin`: the facet of the old cell that it was made for.
// Turns around each ridge of the facet through old cells until the next facet of the cavity's boundary.
template <int D> [[gnu::noinline]] void link(Cell<D>* cells, std::uint32_t stamp, CellId made, FacetId origin) {
    Cell<D>& fresh = cells[made];
    const Cell<D>* const start = &cells[origin.cell()];
    const std::uint32_t i = origin.position();
    for (std::uint32_t j = 0; j <= D; ++j) {
        if (j == i || fresh.neighbour[j] != none) continue;
        const Cell<D>* current = start;
        std::uint32_t enter = i;
        FacetId leave = current->neighbour[j];
        const Cell<D>* next = &cells[leave.cell()];
        while (next->mark == stamp) {
            const VertexId pivot = current->vertex[enter];
            current = next;
            enter = leave.position();
            leave = current->neighbour[position_in<D>(*current, pivot)];
            next = &cells[leave.cell()];
        }
        const CellId other = leave.cell();
        fresh.neighbour[j] = FacetId(other, enter);
        cells[other].neighbour[enter] = FacetId(made, j);
    }
}

template <int D> void link_all(const Store<D>& store, const Cavity& cavity, const CavityLine* end) {
    for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(cavity.facets); ++k) {
        if (k % 256 == 255) store.arena.pass(256 * (D - 1));
        link<D>(&store.cell(0), cavity.stamp, end[-k].made, end[-k].facet);
    }
}

template <int D, class W>
NETMESH_APART void make_sphere(const Store<D>& store, const Cell<D>& inside, const Cell<D>& outside, const double* q,
                               W weights, double error_max, Cell<D>& cell) {
    if constexpr (W::has) {
        if (pencil_sphere<D, true>(inside, outside, q, error_max, cell, weights.height(q[D]))) return;
    } else {
        if (pencil_sphere<D>(inside, outside, q, error_max, cell)) return;
    }
    solve_cell<D>(store, weights, error_max, cell);
}

// Makes the new cells of a cavity one by one, each a copy of the cell in conflict behind its facet with one vertex
// replaced, which keeps the orientation. That cell's neighbour across the facet becomes the new cell. end: line 0 of
// the cavity's list.
template <int D, class W>
NETMESH_APART void make_one_by_one(Store<D>& store, const Cavity& cavity, VertexId id, W weights, double error_max,
                                   CavityLine* end, CellSupply<D>& supply) {
    Cell<D>* const cells = &store.cell(0);
    const double* const q = store.point(id);
    const std::ptrdiff_t facets = cavity.facets;
    for (std::ptrdiff_t k = 0; k < facets; ++k) {
        if (k % 256 == 255) store.arena.pass(256 * (D - 1));  // of thousands of facets, about a hull or a shell
        const CellId n = end[-k].made = supply.take();
        const std::uint32_t i = end[-k].facet.position();
        Cell<D>& old = cells[end[-k].facet.cell()];
        Cell<D>& fresh = cells[n];
        bool ghost = false;
        for (std::uint32_t j = 0; j <= D; ++j) {
            const VertexId v = j == i ? id : old.vertex[j];
            ghost |= v == none;
            fresh.vertex[j] = v;
            fresh.neighbour[j] = none;
        }
        const FacetId outer = old.neighbour[i];
        Cell<D>& beyond = cells[outer.cell()];
        fresh.neighbour[i] = outer;
        fresh.mark = 0;
        if (ghost)
            make_ghost<D>(fresh);
        else
            make_sphere<D>(store, old, beyond, q, weights, error_max, fresh);
        old.neighbour[i] = FacetId(n, i);
        beyond.neighbour[outer.position()] = FacetId(n, i);
    }
    link_all<D>(store, cavity, end);
}

#ifndef __OPTIMIZE_SIZE__
// Asks for the two balls of facets that stand some lines after line k of the cavity's list. The one beyond a facet is
// found by way of the one inside, which is asked for earlier.
template <int D>
void ask_for_balls(const Cell<D>* cells, const CavityLine* end, std::ptrdiff_t k, std::ptrdiff_t facets) {
    constexpr std::ptrdiff_t beyond_ahead = 6, inside_ahead = 14;
    if (k + beyond_ahead >= facets) return;
    const FacetId facet = end[-(k + beyond_ahead)].facet;
    const Cell<D>& beyond = cells[cells[facet.cell()].neighbour[facet.position()].cell()];
    __builtin_prefetch(&beyond.centre);
    __builtin_prefetch(&beyond.mark);
    if (k + inside_ahead >= facets) return;
    const Cell<D>& inside = cells[end[-(k + inside_ahead)].facet.cell()];
    __builtin_prefetch(&inside);
    __builtin_prefetch(&inside.mark);
}

// make_one_by_one for `count` cells behind facets from line 0 of `lines` on, of which `left` are there, but for their
// balls: what these are made of goes into columns. Links them. A function of its own for its registers and stack.
template <int D, std::uint32_t most>
[[gnu::noinline]] void gather_batch(Store<D>& store, CavityLine* lines, std::uint32_t count, std::ptrdiff_t left,
                                    VertexId id, Pencils<D, most>& pencils, RidgeTable<D>& ridges,
                                    CellSupply<D>& supply) {
    Cell<D>* const cells = &store.cell(0);
    for (std::uint32_t b = 0; b < count; ++b) {
        ask_for_balls<D>(cells, lines, b, left);
        CavityLine& line = lines[-static_cast<std::ptrdiff_t>(b)];
        const CellId n = line.made = supply.take();
        const std::uint32_t i = line.facet.position();
        Cell<D>& old = cells[line.facet.cell()];
        Cell<D>& fresh = cells[n];
        const FacetId outer = old.neighbour[i];
        Cell<D>& beyond = cells[outer.cell()];
        __builtin_memcpy(fresh.vertex, old.vertex, sizeof fresh.vertex);
        fresh.vertex[i] = id;
        fresh.neighbour[i] = outer;
        fresh.mark = 0;
        pencils.in.put(old, b);
        pencils.out.put(beyond, b);
        old.neighbour[i] = FacetId(n, i);
        beyond.neighbour[outer.position()] = FacetId(n, i);
        ridges.join(cells, n, i);
    }
}

// make_one_by_one in batches, whose columns stand in the gap below the cavity's list, above a table of ridges. False:
// the gap is too small for them, and nothing is made.
template <int D, class W>
[[gnu::noinline]] bool make_in_batches(Store<D>& store, const Cavity& cavity, VertexId id, W weights, double error_max,
                                       CavityLine* end, CellSupply<D>& supply) {
    constexpr std::uint32_t batch = 16;
    using Columns = Pencils<D, batch>;
    const std::size_t lines = cavity.cells > cavity.facets ? cavity.cells : cavity.facets;
    const std::size_t below = (lines * sizeof(CavityLine) + 7) / 8 * 8 + sizeof(Columns);
    RidgeTable<D> ridges(store, cavity.facets, below);
    if (!ridges.is_there()) return false;
    Columns* const pencils = reinterpret_cast<Columns*>(store.arena.at(store.arena.high_mark() - below));
    CavityLine* line = end;
    for (std::uint32_t left = cavity.facets; left > 0;) {
        const std::uint32_t count = left < batch ? left : batch;
        gather_batch<D>(store, line, count, left, id, *pencils, ridges, supply);
        if constexpr (W::has) {
            const double height = weights.height(store.point(id)[D]);
            pencils->template measure<true>(store.point(id), count, height);
            pencils->template mix<true>(store.point(id), count, height);
        } else {
            pencils->measure(store.point(id), count);
            pencils->mix(store.point(id), count);
        }
        for (std::uint32_t b = 0; b < count; ++b, --line) {
            Cell<D>& fresh = store.cell(line->made);
            if (pencils->get(b, error_max * error_max, fresh)) continue;
            if (store.is_ghost(line->made))
                make_ghost<D>(fresh);
            else
                solve_cell<D>(store, weights, error_max, fresh);
        }
        left -= count;
        if ((cavity.facets - left) % 256 == 0) store.arena.pass(256 * (D - 1));  // see make_one_by_one
    }
    if (ridges.is_sound()) return true;
    for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(cavity.facets); ++k)
        for (std::uint32_t j = 0; j <= D; ++j)
            if (j != end[-k].facet.position()) store.cell(end[-k].made).neighbour[j] = none;
    link_all<D>(store, cavity, end);
    return true;
}
#endif

// Seen from outside a facet turns the other way, so the ghost behind facet i of the first cell has two of the facet's
// vertices exchanged, those at the first two positions other than i.
struct Exchanged {
    std::uint32_t a, b;
    explicit Exchanged(std::uint32_t i) : a(i == 0 ? 1 : 0), b(i <= 1 ? 2 : 1) {}
    std::uint32_t position_of(std::uint32_t i) const { return i == a ? b : i == b ? a : i; }
};

// Ghost i of the first cell made[0], whose vertices are v: the one behind its facet i, made[1 + i].
template <int D> void make_first_ghost(const CellId* made, const VertexId* v, std::uint32_t i, Cell<D>& ghost) {
    const Exchanged here(i);
    for (std::uint32_t j = 0; j <= D; ++j) ghost.vertex[j] = v[j];
    ghost.vertex[i] = none;
    ghost.vertex[here.a] = v[here.b];
    ghost.vertex[here.b] = v[here.a];
    ghost.neighbour[i] = FacetId(made[0], i);
    // Without vertex k it borders ghost k without vertex i.
    for (std::uint32_t j = 0; j <= D; ++j) {
        if (j == i) continue;
        const std::uint32_t k = here.position_of(j);
        ghost.neighbour[j] = FacetId(made[1 + k], Exchanged(k).position_of(i));
    }
    make_ghost<D>(ghost);
    ghost.mark = 0;
}

}  // namespace

template <int D, class W>
[[gnu::noinline]] bool Kernel<D, W>::undecided_conflict(CellId c, const double* q, VertexId id) {
    const int infinite = store_.ghost_position(c);
    store_.arena.pass(infinite < 0 ? undecided_units : 2 * D);  // there are thousands of ghosts about a hull
    return infinite < 0 ? exact_conflict(c, q, id) : ghost_in_conflict(c, infinite, q, id);
}

template <int D, class W> bool Kernel<D, W>::exact_conflict(CellId c, const double* q, VertexId id) {
    const Cell<D>& cell = store_.cell(c);
    const double* p[D + 1];
    VertexId name[D + 1];
    for (int i = 0; i <= D; ++i) {
        p[i] = store_.point(cell.vertex[i]);
        name[i] = tie_order_ == TieOrder::of_rows ? VertexId(store_.vertex(cell.vertex[i]).origin) : cell.vertex[i];
        if constexpr (W::has) name[i] = this->weights.index_of(name[i]);
    }
    if (tie_order_ == TieOrder::of_rows) id = VertexId(store_.vertex(id).origin);
    PredicateCounts& counts = store_.state.in_ball_counts;
    if constexpr (W::has)
        return in_power_perturbed<D>(p, name, q, this->weights.index_of(id), this->weights.are_radii, counts) ==
               Sign::positive;
    else
        return in_ball_perturbed<D>(p, name, q, id, counts) == Sign::positive;
}

// A point in the plane of the facet is compared with the ball of the finite cell behind it: both lifted simplices have
// the same trace in that plane, perturbation included.
template <int D, class W> bool Kernel<D, W>::ghost_in_conflict(CellId c, int infinite, const double* q, VertexId id) {
    const Cell<D>& cell = store_.cell(c);
    const double* p[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = i == infinite ? q : store_.point(cell.vertex[i]);
    const Sign side = orient<D>(p, store_.state.orient_counts);
    if (side != Sign::zero) return side == Sign::positive;
    const CellId behind = cell.neighbour[infinite].cell();
    double bound;
    const double value = power_of(behind, q, &bound);
    if (value > bound) return false;
    if (value < -bound) return true;
    return exact_conflict(behind, q, id);
}

template <int D, class W> [[gnu::cold]] Status Kernel<D, W>::start(const VertexId* ids) {
    if (!store_.has_room(D + 2, 0, 0)) return Status::out_of_memory;
    const double* p[D + 1];
    VertexId v[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = store_.point(v[i] = ids[i]);
    if (orient<D>(p, store_.state.orient_counts) == Sign::negative) {
        v[0] = ids[1];
        v[1] = ids[0];
        p[0] = store_.point(v[0]);
        p[1] = store_.point(v[1]);
    }
    // Cell 0 is finite; ghost 1 + i lies behind its facet i.
    CellId made[D + 2];
    for (CellId& c : made) c = store_.new_cell();
    Cell<D>& first = store_.cell(made[0]);
    for (std::uint32_t i = 0; i <= D; ++i) {
        first.vertex[i] = v[i];
        first.neighbour[i] = FacetId(made[1 + i], i);
        store_.vertex(v[i]).cell = made[0];
    }
    first.mark = 0;
    if constexpr (W::has)
        solve_power_sphere<D>(p, this->weights, error_max_, first);
    else
        solve_sphere<D>(p, error_max_, first);
    for (std::uint32_t i = 0; i <= D; ++i) make_first_ghost<D>(made, v, i, store_.cell(made[1 + i]));
    store_.state.last_cell = made[0];
    return Status::ok;
}

template <int D, class W> CellId Kernel<D, W>::locate(const double* q, VertexId id, CellId from) {
    this->look_at(q, D);
    CellId c = from;
    int infinite = store_.ghost_position(c);
    if (infinite >= 0) {
        if (in_conflict(c, q, id)) return c;
        c = store_.cell(c).neighbour[infinite].cell();
    }
    double bound;
    double value = power_of(c, q, &bound);
    for (;;) {
        if (value < -bound) return c;
        const Cell<D>& cell = store_.cell(c);
        CellId next = none;
        for (int i = 0; i <= D; ++i) {
            const CellId n = cell.neighbour[i].cell();
            double n_bound;
            const double n_value = power_of(n, q, &n_bound);
            if (n_value < value && n_value > -infinity) {
                next = n;
                value = n_value;
                bound = n_bound;
                break;
            }
        }
        if (next == none) break;
        c = next;
        if (++steps_ % 32 == 0) store_.arena.pass(5 * D);  // points on a curve take as many as there are
    }
    if (in_conflict(c, q, id)) return c;
    const CellId end = walk(q, c);
    // The cell that q lies in; what is beyond the hull is in conflict.
    if constexpr (W::has)
        if (!in_conflict(end, q, id)) return CellId(none);
    return end;
}

// The visibility walk with exact signs: from a cell through any facet that separates it from q. It ends on a Delaunay
// triangulation, as the exact powers decrease.
template <int D, class W> CellId Kernel<D, W>::walk(const double* q, CellId from) {
    CellId c = from;
    for (;;) {
        store_.arena.pass(exact_step_units);
        const Cell<D>& cell = store_.cell(c);
        if (store_.is_ghost(c)) return c;
        const double* p[D + 1];
        for (int i = 0; i <= D; ++i) p[i] = store_.point(cell.vertex[i]);
        CellId next = none;
        for (int i = 0; i <= D && next == none; ++i) {
            const double* const kept = p[i];
            p[i] = q;
            if (orient<D>(p, store_.state.orient_counts) == Sign::negative) next = cell.neighbour[i].cell();
            p[i] = kept;
        }
        if (next == none) return c;
        c = next;
        ++steps_;
    }
}

#ifdef __OPTIMIZE_SIZE__
constexpr bool asks_ahead = false;
#else
constexpr bool asks_ahead = true;
#endif
template <int D, class W> bool Kernel<D, W>::find_cavity(const double* q, VertexId id, CellId first, Cavity* cavity) {
    if constexpr (is_planar) {
        return PlanarCavity<D>::find(*this, q, id, first, cavity);
    } else {
        const std::uint32_t stamp = store_.new_stamp();
        const std::size_t capacity = list_capacity();
        Line* const end = list_end();
        if (capacity < 1) return refuse_list(1);
        Cell<D>* const cells = &store_.cell(0);
        end[0].entry = FacetId(first, 0);
        cells[first].mark = stamp;
        CavitySearch progress = {stamp, 1, 0, 0};
        bool has_tables = false;
#ifndef __OPTIMIZE_SIZE__
        if constexpr (D == 3) {
            SpatialCavity<D, W>::search(*this, q, id, &progress);
            has_tables = progress.searched == progress.cells;
        }
#endif
        std::ptrdiff_t count = progress.cells, facets = progress.facets;
        for (std::ptrdiff_t k = progress.searched; k < count; ++k) {
            // Each facet of this cell leads to one more cell or bounds the cavity.
            const std::size_t lines = static_cast<std::size_t>(count > facets ? count : facets) + D + 1;
            if (lines > capacity) return refuse_list(lines);
            const CellId c = end[-k].entry.cell();
            if constexpr (asks_ahead) {
                if (k + 2 < count) ask_for_neighbours(cells, cells[end[-(k + 2)].entry.cell()]);
                // What cannot be predicted is no branch: first who is met for the first time, then who of them is in
                // conflict, then which facets bound the cavity.
                std::uint32_t outside[D + 1], fresh[D + 1], asked = 0;
                for (std::uint32_t i = 0; i <= D; ++i) {
                    outside[i] = cells[cells[c].neighbour[i].cell()].mark - stamp;  // 0: no, 1: yes, else fresh
                    fresh[asked] = i;
                    asked += outside[i] > 1;
                }
                for (std::uint32_t u = 0; u < asked; ++u) {
                    const FacetId facet = cells[c].neighbour[fresh[u]];
                    Cell<D>& other = cells[facet.cell()];
                    const std::uint32_t inside = in_conflict(facet.cell(), q, id);
                    __builtin_prefetch(&other.neighbour);
                    other.mark = stamp + 1 - inside;
                    end[-count].entry = facet;
                    count += inside;
                    outside[fresh[u]] = 1 - inside;
                }
                for (std::uint32_t i = 0; i <= D; ++i) {
                    end[-facets].facet = FacetId(c, i);
                    facets += outside[i];
                }
            } else {
                for (std::uint32_t i = 0; i <= D; ++i) {
                    const FacetId facet = cells[c].neighbour[i];
                    Cell<D>& other = cells[facet.cell()];
                    const std::uint32_t known = other.mark - stamp;  // 0: in conflict, 1: not, else not met yet
                    if (known == 0) continue;
                    if (known > 1) {
                        if (in_conflict(facet.cell(), q, id)) {
                            other.mark = stamp;
                            end[-count++].entry = facet;
                            continue;
                        }
                        other.mark = stamp + 1;
                    }
                    end[-facets++].facet = FacetId(c, i);
                }
            }
        }
        // As if the search had asked for its last lines, also where it had tables instead.
        store_.arena.use_gap(static_cast<std::size_t>((count > facets ? count : facets) + D + 1) * sizeof(Line));
        *cavity = {static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(facets), stamp, has_tables};
        return true;
    }
}

template <int D, class W> void Kernel<D, W>::fill(const Cavity& cavity, VertexId id) {
    NETMESH_ASSERT(cavity.cells > 0 && cavity.facets > D);
    if constexpr (is_planar) {
        PlanarCavity<D>::fill(*this, cavity, id);
    } else {
        Cell<D>* const cells = &store_.cell(0);
        Line* const end = list_end();
        const std::ptrdiff_t facets = cavity.facets, old_cells = cavity.cells;
        CellSupply<D> supply(store_);
        bool made = false;
#ifndef __OPTIMIZE_SIZE__
        if constexpr (D == 3)
            made = SpatialCavity<D, W>::make_cells(*this, cavity, id, supply);
        else
            made = make_in_batches<D>(store_, cavity, id, weights_used(), error_max_, end, supply);
#endif
        if (!made) make_one_by_one<D>(store_, cavity, id, weights_used(), error_max_, end, supply);
        for (std::ptrdiff_t k = 0; k < old_cells; ++k) supply.give_back(end[-k].entry.cell());
        if (vertex_cells_ == VertexCells::kept)
            for (std::ptrdiff_t k = 0; k < facets; ++k)
                for (const VertexId v : cells[end[-k].made].vertex)
                    if (v != none) store_.vertex(v).cell = end[-k].made;
        store_.state.last_cell = end[1 - facets].made;
    }
    if constexpr (!W::has) NETMESH_VALIDATE_WHOLE(violation_in_use(store_));
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template class Kernel<D>;                                                                                          \
    template class Kernel<D, Weights>;
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE
#undef NETMESH_APART

}  // namespace netmesh
