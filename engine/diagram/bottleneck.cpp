#include "diagram/bottleneck.hpp"

#include "diagram/matching.hpp"

namespace netmesh {
namespace {

struct Side {
    PairView pairs;
    DiagramPoint* points;
    double* line;
    std::uint64_t *mark, *below;
    std::uint32_t *mate, *mate_back;
    PointTree tree;
};

struct Workspace {
    Side side[2];
    MatchingScratch scratch;

    void lay_out(Scratch& memory, std::size_t count_a, std::size_t count_b) {
        const std::size_t count[2] = {count_a, count_b}, larger = count_a > count_b ? count_a : count_b;
        for (int s = 0; s < 2; ++s) {
            side[s].points = memory.take<DiagramPoint>(count[s]);
            side[s].line = memory.take<double>(count[s]);
            side[s].mark = memory.take<std::uint64_t>(count[s]);
            side[s].below = memory.take<std::uint64_t>(count[s]);
            side[s].mate = memory.take<std::uint32_t>(count[s]);
            side[s].mate_back = memory.take<std::uint32_t>(count[1 - s]);
        }
        scratch.queue = memory.take<std::uint32_t>(larger);
        scratch.level = memory.take<std::uint32_t>(larger);
        scratch.path = memory.take<std::uint32_t>(2 * larger);
        scratch.start = memory.take<std::uint32_t>(larger + 1);
        scratch.cursor = memory.take<std::uint32_t>(larger);
        scratch.edge_max = static_cast<std::uint32_t>(edges_per_point * larger);
        scratch.edge = memory.take<std::uint32_t>(scratch.edge_max);
    }
};

// Pairs that can only be matched with their own kind, so that one number of each is left and the order decides.
enum class LineKind { essential, essential_from_zero, from_zero };
constexpr LineKind kinds[] = {LineKind::essential, LineKind::essential_from_zero, LineKind::from_zero};

// Collects and sorts the numbers of one kind in line; how many there are.
std::size_t collect(const Side& side, std::uint32_t degree, bool log_scale, LineKind kind) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < side.pairs.count; ++i) {
        const netmesh_pair pair = side.pairs[i];
        if (pair.degree != degree || is_essential(pair) == (kind == LineKind::from_zero)) continue;
        if ((log_scale && pair.birth == 0) == (kind == LineKind::essential)) continue;
        if (kind == LineKind::from_zero && pair.death == 0) continue;  // on the diagonal
        side.line[count++] = kind == LineKind::from_zero ? pair.death : kind == LineKind::essential ? pair.birth : 1.0;
    }
    std::uint64_t compared = 0;
    sort(side.line, count, [&side, &compared](double a, double b) {
        side.pairs.report(++compared);
        return a < b;
    });
    return count;
}

// Keeps the pairs that may go to the diagonal and are not on it.
std::uint32_t collect_points(const Side& side, std::uint32_t degree, bool log_scale) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < side.pairs.count; ++i) {
        const netmesh_pair pair = side.pairs[i];
        if (pair.degree != degree || is_essential(pair) || pair.birth == pair.death) continue;
        if (log_scale && pair.birth == 0) continue;
        const std::uint64_t diagonal =
            log_scale ? LogScale::to_diagonal(pair.birth, pair.death) : PlainScale::to_diagonal(pair.birth, pair.death);
        side.points[count++] = {{pair.birth, pair.death}, diagonal};
    }
    return count;
}

// Bounds by what each point alone needs: *least is reached by no smaller limit, *most suffices.
template <class Scale> void bound(const PointTree& from, PointTree& to, std::uint64_t* least, std::uint64_t* most) {
    to.mark_all(1);
    for (std::uint32_t i = 0; i < from.count();)
        for (const std::uint64_t piece = from.piece(i, from.count(), 4000); i < piece; ++i) {
            const std::uint64_t diagonal = from[i].diagonal;
            if (diagonal > *most) *most = diagonal;
            if (diagonal <= *least) continue;
            const std::uint64_t needs = to.nearest<Scale>(from[i], diagonal, 1);
            if (needs > *least) *least = needs;
        }
}

// False when it is cancelled. Not inlined: what its caller keeps in registers would cost its searches a fortieth.
template <class Scale>
[[gnu::noinline]] bool distance_of_points(Workspace& work, Monitor& monitor, std::uint64_t* key) {
    Side &a = work.side[0], &b = work.side[1];
    std::uint64_t least = 0, most = 0;
    bound<Scale>(a.tree, b.tree, &least, &most);
    bound<Scale>(b.tree, a.tree, &least, &most);
    Matching matching[2];
    matching[0].begin(a.tree, b.tree, a.mate, a.mate_back, work.scratch, monitor);
    matching[1].begin(b.tree, a.tree, b.mate, b.mate_back, work.scratch, monitor);
    // The lower bound is tried in turns with the middle: it often is the answer.
    for (bool try_least = true; least < most; try_least = !try_least) {
        const std::uint64_t limit = try_least ? least : least + (most - least) / 2;
        std::uint64_t next[2] = {0, 0};
        int covered = 0;
        while (covered < 2 && matching[covered].cover<Scale>(limit, &next[covered])) ++covered;
        if (matching[0].cancelled() || matching[1].cancelled()) return false;
        if (covered == 2) {
            most = next[0] > next[1] ? next[0] : next[1];
            if (most < least) most = least;
        } else {
            least = next[covered];
        }
    }
    *key = most;
    return true;
}

std::uint64_t between(double x, double y, bool log_scale) {
    return log_scale ? LogScale::between(x, y) : PlainScale::between(x, y);
}

// Makes *largest the distance in one degree when that is larger. False when it is cancelled.
bool distance_in(Workspace& work, std::uint32_t degree, bool log_scale, Monitor& monitor, std::uint64_t* largest) {
    for (const LineKind kind : kinds) {
        const std::size_t count = collect(work.side[0], degree, log_scale, kind);
        if (collect(work.side[1], degree, log_scale, kind) != count) {
            *largest = key_of_infinity;
            return true;
        }
        for (std::size_t i = 0; i < count; ++i) {
            work.side[0].pairs.report(i);
            const std::uint64_t key = between(work.side[0].line[i], work.side[1].line[i], log_scale);
            if (key > *largest) *largest = key;
        }
    }
    for (Side& side : work.side) {
        side.tree.build(side.points, side.mark, side.below, collect_points(side, degree, log_scale), &monitor);
    }
    std::uint64_t key = 0;
    if (log_scale ? !distance_of_points<LogScale>(work, monitor, &key)
                  : !distance_of_points<PlainScale>(work, monitor, &key)) {
        return false;
    }
    if (key > *largest) *largest = key;
    return true;
}

netmesh_distance distance_of_key(std::uint64_t key, bool log_scale) {
    constexpr std::uint32_t bytes = sizeof(netmesh_distance);
    if (key == key_of_infinity) return {bytes, 0, infinity};
    if (!log_scale) return {bytes, 0, double_of_bits(key)};
    const std::uint64_t fraction = key & ((std::uint64_t{1} << 52) - 1);
    return {bytes, static_cast<std::int32_t>(key >> 52), double_of_bits(bits_of(1.0) | fraction)};
}

}  // namespace

std::size_t bottleneck_bytes(std::uint64_t count_a, std::uint64_t count_b) {
    if (count_a >= compared_pairs_max || count_b >= compared_pairs_max || (count_a + count_b) > SIZE_MAX / 1024)
        return SIZE_MAX;
    Scratch memory = {nullptr, 0};
    Workspace work = {};
    work.lay_out(memory, static_cast<std::size_t>(count_a), static_cast<std::size_t>(count_b));
    return memory.used;
}

Status bottleneck(const DistanceRequest& request, Monitor& monitor, netmesh_distance* distance) {
    PairView a = request.a, b = request.b;
    a.monitor = b.monitor = &monitor;
    const bool log_scale = request.log_scale;
    if (!are_diagram(a, log_scale) || !are_diagram(b, log_scale)) return Status::invalid_argument;
    if (bottleneck_bytes(a.count, b.count) > request.scratch_bytes) return Status::out_of_memory;
    Scratch memory = {static_cast<unsigned char*>(request.scratch), 0};
    Workspace work = {};
    work.lay_out(memory, static_cast<std::size_t>(a.count), static_cast<std::size_t>(b.count));
    work.side[0].pairs = a;
    work.side[1].pairs = b;
    std::uint64_t key = 0;
    std::uint64_t from = 0;
    std::uint32_t degree = request.degree;
    const bool all = degree == NETMESH_ALL_DEGREES;
    for (bool more = !all || next_degree(a, b, from, &degree); more; more = all && next_degree(a, b, from, &degree)) {
        if (!distance_in(work, degree, log_scale, monitor, &key)) return Status::cancelled;
        from = std::uint64_t{degree} + 1;
    }
    if (monitor.has_stopped()) return Status::cancelled;
    *distance = distance_of_key(key, log_scale);
    return Status::ok;
}

}  // namespace netmesh
