#include "mesh/clip/clipped_nerve.hpp"

#include "certificate/rounding.hpp"
#include "mesh/clip/equal_foot.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr std::uint32_t chunk = 256;

// The subsets of the positions 0, 1, ... of a cell, as sets of bits, by size: those of n are set[first[n]..first[n +
// 1]), the ones of a smaller dimension's positions first.
struct Subsets {
    static constexpr int count = 2 << dimension_max;
    std::uint8_t set[count] = {};
    int first[dimension_max + 3] = {};

    constexpr Subsets() {
        int end = 0;
        for (int n = 0; n <= dimension_max + 1; ++n) {
            first[n] = end;
            for (int s = 0; s < count; ++s) {
                int size = 0;
                for (int i = 0; i <= dimension_max; ++i) size += s >> i & 1;
                if (size == n) set[end++] = static_cast<std::uint8_t>(s);
            }
        }
        first[dimension_max + 2] = end;
    }
};
constexpr Subsets subsets{};

// A face of a cell.
struct Face {
    unsigned set;  // positions of its vertices in the cell
    int size = 0;
    const double* point[dimension_max];
    std::uint32_t vertex[dimension_max];  // ascending
};

// source: out, and some of its faces may be in.
enum class CellPart : std::uint8_t { out = 0, in = 1, open = 2, source = 3 };

class NerveFinder {
public:
    NerveFinder(const AnyStore& store, const AnyDomain& ball, const Work& work)
        : dim_(store.dim), store_(store), ball_(ball), work_(work),
          faces_(DimensionOf<any_dimension>(static_cast<std::uint32_t>(store.dim))) {}

    Status run(AnyPart* part, bool* certain) {
        ArenaScope scope(work_.arena);
        cells_ = store_.state.cell_slots;
        cell_ = work_.arena.take_low<std::uint8_t>(cells_);
        vertex_ = work_.arena.take_low<std::uint8_t>(store_.state.vertex_count);
        if (cell_ == nullptr || vertex_ == nullptr) return Status::out_of_memory;
        for (CellId c(0); c < cells_;)
            for (const std::uint64_t piece = work_.arena.piece(c, cells_, 15 * dim_); c < piece; ++c) {
                cell_[c] = static_cast<std::uint8_t>(by_record(c));
            }
        find_absent();
        Status status = settle_open_cells();
        if (status == Status::ok && certain_) status = find_sources();
        for (int n = dim_; n >= 1 && status == Status::ok && certain_; --n) status = find_faces(n);
        *certain = certain_;
        if (status != Status::ok || !certain_) return status;
        finish();
        *part = {cell_, faces_, vertex_};
        scope.keep_low_from_now();
        return Status::ok;
    }

private:
    static constexpr std::uint8_t sees_in = 1, sees_out = 2;
    // Positions of a cell: neighbours there that are not nearer to o, and those to which the edge may not lead up.
    struct Edges {
        unsigned farther, down;
    };

    CellPart by_record(CellId c) const;
    void find_absent();
    Status settle_open_cells();
    Edges edges_of(CellId c) const;
    Status find_sources();
    Status find_faces(int n);
    void finish();

    Status examine(CellId c, const Face& face);
    Status insert(const Face& face);
    template <class Number> int judge(const EqualFoot<Number>& foot, const Face& face, const AnyCellList& star) const;
    [[gnu::noinline, gnu::cold]] int judge_precisely(const Face& face, const AnyCellList& star) const {
        return judge(EqualFoot<WideFloat>(dim_, ball_.centre, ball_.radius, face.point, face.size), face, star);
    }
    [[gnu::noinline, gnu::cold]] int beyond_precisely(const double* const* point) const {
        return EqualFoot<WideFloat>(dim_, ball_.centre, ball_.radius, point, dim_ + 1).beyond();
    }
    bool is_open(CellId c) const { return cell_[c] == static_cast<std::uint8_t>(CellPart::open); }
    bool is_in(CellId c) const { return cell_[c] == static_cast<std::uint8_t>(CellPart::in); }
    // Positions of c whose vertices may be in.
    unsigned present_in(CellId c) const {
        unsigned set = 0;
        for (int i = 0; i <= dim_; ++i)
            if (vertex_[store_.cell(c).vertex[i]] != VertexPart::absent) set |= 1u << i;
        return set;
    }

    bool step(CellId c) {
        if (c % chunk != 0) return false;
        done_ += chunk;
        return work_.monitor.advance(done_, chunk);
    }

    const int dim_;
    const AnyStore& store_;
    const AnyDomain& ball_;
    const Work& work_;
    std::uint32_t cells_ = 0;
    std::uint8_t* cell_ = nullptr;
    std::uint8_t* vertex_ = nullptr;
    FaceSet<any_dimension> faces_;
    std::uint64_t done_ = 0;
    bool certain_ = true;
};

// The centre is within error * radius of the computed one. Distances by `up` and `down` (rounding.hpp).
CellPart NerveFinder::by_record(CellId c) const {
    const AnyCell cell = store_.cell(c);
    const double away = square_root(ball_.distance2(cell.centre));
    const double doubt = static_cast<double>(cell.error) * square_root(cell.radius2) * up;
    if ((away + doubt) * up < ball_.radius) return CellPart::in;
    return away * down - doubt > ball_.radius * up ? CellPart::out : CellPart::open;
}

// Marks vertices that are surely not in K: o is on the other side of a bisector that is beyond the sphere, at
// (|v - o|^2 - |w - o|^2) / (2 |v - w|) from it. Any other vertex w will do, those of one cell are at hand. The
// difference is off by less than sum_slack of its terms' sum.
void NerveFinder::find_absent() {
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = work_.arena.piece(v, store_.state.vertex_count, 8); v < piece; ++v) {
            vertex_[v] = VertexPart::cut;
        }
    for (CellId c(0); c < cells_;)
        for (const std::uint64_t piece = work_.arena.piece(c, cells_, 12 * dim_ * dim_); c < piece; ++c) {
            if (is_in(c)) continue;
            const AnyCell cell = store_.cell(c);
            const double* point[dimension_max + 1];
            double away2[dimension_max + 1];
            for (int i = 0; i <= dim_; ++i) {
                point[i] = store_.point(cell.vertex[i]);
                away2[i] = ball_.distance2(point[i]);
                for (int j = 0; j < i; ++j) {
                    const int far = away2[i] > away2[j] ? i : j, near = i + j - far;
                    const double gap = away2[far] - away2[near] - sum_slack * (away2[far] + away2[near]);
                    const double least = 2 * ball_.radius * distance(dim_, point[i], point[j]) * up;
                    if (gap > least) vertex_[cell.vertex[far]] = VertexPart::absent;
                }
            }
        }
}

Status NerveFinder::settle_open_cells() {
    for (CellId c(0); c < cells_ && certain_;)
        for (const std::uint64_t piece = work_.arena.piece(c, cells_, 6); c < piece && certain_; ++c) {
            if (!is_open(c)) continue;
            int beyond = 1;
            if (present_in(c) == (2u << dim_) - 1) {
                const double* point[dimension_max + 1];
                for (int i = 0; i <= dim_; ++i) point[i] = store_.point(store_.cell(c).vertex[i]);
                beyond = EqualFoot<double>(dim_, ball_.centre, ball_.radius, point, dim_ + 1).beyond();
                if (beyond == 0) beyond = beyond_precisely(point);
                if (beyond == 0) certain_ = false;
            }
            cell_[c] = static_cast<std::uint8_t>(beyond < 0 ? CellPart::in : CellPart::out);
            if (work_.monitor.advance(done_, 10)) return Status::cancelled;
        }
    return Status::ok;
}

// From which cells a face s is looked at. Let z(c) be the centre of cell c, a corner of F_s when s is a face of c.
//   - Of the cells around s the one whose computed centre is nearest to o will do: none of its neighbours around s may
//     have a nearer one. That is a rule on numbers, whatever their errors.
//   - When x_s is in F_s then x_s - z(c) is a sum of multiples, >= 0, of the edges of F_s at z(c), those to the
//     neighbours z(c') around s; and (o - z(c)).(x_s - z(c)) = |x_s - z(c)|^2 > 0 unless z(c) itself is in the ball. So
//     (o - z(c)).(z(c') - z(c)) > 0 for some of them. Weights that vanish leave >= 0. An edge for which it is surely
//     negative leads up.
// Few cells have a neighbour farther from o to which the edge does not lead up.
NerveFinder::Edges NerveFinder::edges_of(CellId c) const {
    const AnyCell cell = store_.cell(c);
    const double away2 = ball_.distance2(cell.centre), away = square_root(away2);
    const double doubt = static_cast<double>(cell.error) * square_root(cell.radius2);
    Edges edges = {0, 0};
    for (int i = 0; i <= dim_; ++i) {
        if (cell.neighbour[i] == none) {
            edges.farther |= 1u << i;
            edges.down |= 1u << i;
            continue;
        }
        const AnyCell other = store_.cell(cell.neighbour[i].cell());
        if (ball_.distance2(other.centre) < away2) continue;
        edges.farther |= 1u << i;
        double along = 0, length2 = 0;
        for (int k = 0; k < dim_; ++k) {
            const double step = other.centre[k] - cell.centre[k];
            along += (ball_.centre[k] - cell.centre[k]) * step;
            length2 += step * step;
        }
        const double length = square_root(length2);
        const double doubts = doubt + static_cast<double>(other.error) * square_root(other.radius2);
        const double slack = (away + length + doubts) * doubts * up + sum_slack * away * length;
        if (!(along < -slack)) edges.down |= 1u << i;
    }
    return edges;
}

Status NerveFinder::find_sources() {
    for (CellId c(0); c < cells_; ++c) {
        if (step(c)) return Status::cancelled;
        if (is_in(c) || present_in(c) == 0) continue;
        const Edges edges = edges_of(c);
        if ((edges.farther & edges.down) != 0) cell_[c] = static_cast<std::uint8_t>(CellPart::source);
    }
    return Status::ok;
}

// Puts the faces of n vertices into the set whose m is that of their own flat.
Status NerveFinder::find_faces(int n) {
    for (CellId c(0); c < cells_; ++c) {
        if (step(c)) return Status::cancelled;
        if (cell_[c] != static_cast<std::uint8_t>(CellPart::source)) continue;
        const AnyCell cell = store_.cell(c);
        const Edges edges = edges_of(c);
        const unsigned present = present_in(c);
        for (int s = subsets.first[n]; s < subsets.first[n + 1] && subsets.set[s] < 2u << dim_; ++s) {
            const unsigned set = subsets.set[s], left = (2u << dim_) - 1 - set;
            if ((set & ~present) != 0 || (left & ~edges.farther) != 0 || (left & edges.down) == 0) continue;
            Face face;
            face.set = set;
            for (int i = 0; i <= dim_; ++i) {
                if ((set >> i & 1u) == 0) continue;
                int at = face.size++;
                for (; at > 0 && face.vertex[at - 1] > cell.vertex[i]; --at) {
                    face.vertex[at] = face.vertex[at - 1];
                    face.point[at] = face.point[at - 1];
                }
                face.vertex[at] = cell.vertex[i];
                face.point[at] = store_.point(cell.vertex[i]);
            }
            const Status status = examine(c, face);
            if (status != Status::ok || !certain_) return status;
        }
    }
    return Status::ok;
}

Status NerveFinder::examine(CellId c, const Face& face) {
    work_.arena.pass(static_cast<std::uint64_t>(4 * dim_));
    const EqualFoot<double> foot(dim_, ball_.centre, ball_.radius, face.point, face.size);
    if (foot.beyond() > 0) return Status::ok;
    for (int i = 0; i <= dim_; ++i)
        if ((face.set >> i & 1u) == 0 && foot.nearer(store_.point(store_.cell(c).vertex[i])) > 0) return Status::ok;
    if (faces_.contains(face.vertex, static_cast<std::uint32_t>(face.size))) return Status::ok;
    AnyCellList star(store_);
    if (!star.add(c)) return Status::out_of_memory;
    for (std::uint32_t k = 0; k < star.size(); ++k) {
        const AnyCell cell = store_.cell(star[k]);
        for (int i = 0; i <= dim_; ++i) {
            bool shared = false;
            for (int j = 0; j < face.size; ++j) shared |= cell.vertex[i] == face.vertex[j];
            if (shared || cell.neighbour[i] == none) continue;
            if (is_in(cell.neighbour[i].cell())) return Status::ok;
            if (!star.add(cell.neighbour[i].cell())) return Status::out_of_memory;
        }
    }
    work_.arena.pass(std::uint64_t{4} * static_cast<unsigned>(dim_) * star.size());
    int part = judge(foot, face, star);
    if (part == 0) work_.arena.pass(std::uint64_t{100} * static_cast<unsigned>(dim_) * star.size());
    if (part == 0) part = judge_precisely(face, star);
    if (part == 0) certain_ = false;
    return part < 0 ? insert(face) : Status::ok;
}

// Of a face none of whose cofacets is in. -1: it is in, 1: it is not, 0: not certain.
template <class Number>
int NerveFinder::judge(const EqualFoot<Number>& foot, const Face& face, const AnyCellList& star) const {
    int part = foot.beyond();
    if (part > 0) return 1;
    for (std::uint32_t k = 0; k < star.size(); ++k)
        for (const VertexId w : store_.cell(star[k]).vertex) {
            bool own = false;
            for (int j = 0; j < face.size; ++j) own |= w == face.vertex[j];
            if (own) continue;
            const int nearer = foot.nearer(store_.point(w));
            if (nearer > 0) return 1;
            if (nearer == 0) part = 0;
        }
    return part;
}

// With all its faces.
Status NerveFinder::insert(const Face& face) {
    for (unsigned set = 1; set < 1u << face.size; ++set) {
        std::uint32_t vertex[dimension_max], n = 0;
        for (int j = 0; j < face.size; ++j)
            if ((set >> j & 1u) != 0) vertex[n++] = face.vertex[j];
        if (!faces_.insert(vertex, n, work_.arena)) return Status::out_of_memory;
    }
    return Status::ok;
}

void NerveFinder::finish() {
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = work_.arena.piece(v, store_.state.vertex_count, 8); v < piece; ++v) {
            vertex_[v] = 0;
        }
    for (CellId c(0); c < cells_;)
        for (const std::uint64_t piece = work_.arena.piece(c, cells_, 15 * dim_); c < piece; ++c) {
            if (!is_in(c)) cell_[c] = static_cast<std::uint8_t>(CellPart::out);
            for (const VertexId v : store_.cell(c).vertex) vertex_[v] |= is_in(c) ? sees_in : sees_out;
        }
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = work_.arena.piece(v, store_.state.vertex_count, 8); v < piece; ++v) {
            const std::uint8_t sees = vertex_[v];
            vertex_[v] = sees == sees_in                                   ? VertexPart::whole
                         : (sees & sees_in) != 0 || faces_.contains(&v, 1) ? VertexPart::cut
                                                                           : VertexPart::absent;
        }
}

}  // namespace

Status find_clipped_nerve(const AnyStore& store, const AnyDomain& ball, const Work& work, AnyPart* part,
                          bool* certain) {
    return NerveFinder(store, ball, work).run(part, certain);
}

Status choose_clipped_nerve(const AnyStore& store, AnyDomain* domain, const Work& work, AnyPart* part, bool* found) {
    *found = false;
    AnyDomain ball = *domain;
    work.monitor.begin(NETMESH_STAGE_CERTIFY,
                       static_cast<unsigned>(store.dim + 1) * std::uint64_t{store.state.cell_slots});
    for (int k = 0; k < clip_radii; ++k) {
        ball.radius = domain->radius * (1 - k * 0x1p-16);
        if (!(ball.radius > ball.enclosing_radius)) return Status::ok;
        const Status status = find_clipped_nerve(store, ball, work, part, found);
        if (status != Status::ok) return status;
        if (!*found) continue;
        domain->radius = ball.radius;
        return Status::ok;
    }
    return Status::ok;
}

}  // namespace netmesh
