#include "filtration/distance_graph.hpp"

#include "memory/arena.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/real.hpp"
#include "numerics/value_order.hpp"

namespace netmesh {
namespace {

constexpr double largest = 0x1.fffffffffffffp1023;

// Edges of entries as numbers that are doubles.
constexpr int vertex_bits = 26;
static_assert(RipsGraph::vertices_max == 1u << vertex_bits, "an edge is two vertices");
constexpr std::uint64_t number_of(std::uint32_t larger, std::uint32_t smaller) {
    return std::uint64_t{larger} << vertex_bits | smaller;
}

// What is wrong with the distance of i and j < i; of a full matrix, in both places.
DistanceFault fault_at(const DistanceSource& source, std::uint32_t i, std::uint32_t j, double half) {
    const DistanceFlaw flaw = flaw_of(half);
    if (flaw != DistanceFlaw::none) return {flaw, i, j};
    if (source.kind != DistanceSource::Kind::full) return {};
    const std::size_t n = source.count;
    const double here = source.numbers[i * n + j], there = source.numbers[j * n + i];
    if (here == there) return {};
    const DistanceFlaw other = flaw_of(there);
    if (other != DistanceFlaw::none) return {other, j, i};
    return {DistanceFlaw::asymmetric, i, j};
}

DistanceFault fault_on_diagonal(const DistanceSource& source, std::uint32_t i) {
    const double own = source.numbers[i * (std::size_t{source.count} + 1)];
    if (own == 0) return {};
    return {own != own ? DistanceFlaw::not_a_number : DistanceFlaw::own, i, i};
}

// From how far on some point is joined to all others: the least of `most`; the end of what is wanted.
double end_of(const double* most, std::uint32_t n, double threshold, const Arena& arena) {
    double limit = threshold < largest ? threshold : largest;
    arena.each(n, 1, [&](std::uint64_t i) { limit = most[i] < limit ? most[i] : limit; });
    return limit;
}

// Reads every distance once; f(half).
template <class F>
Status read_all(const DistanceSource& source, double threshold, const Work& work, DistanceLimits* out,
                DistanceFault* fault, F f) {
    const std::uint32_t n = source.count;
    const HighScope scope(work.arena);
    double* const most = work.arena.take_high<double>(n);  // of each point
    if (most == nullptr) return Status::out_of_memory;
    work.arena.each(n, 1, [most](std::uint64_t i) { most[i] = 0; });
    const bool is_full = source.kind == DistanceSource::Kind::full;
    PairPolls polls(work.monitor, source.cost() + (is_full ? 5 : 0));
    Fingerprint fingerprint;
    fingerprint.add(std::uint64_t{n});
    for (std::uint32_t i = 0; i < n; ++i) {
        if (is_full) *fault = fault_on_diagonal(source, i);
        if (fault->flaw != DistanceFlaw::none) return Status::invalid_argument;
        for (std::uint32_t j = 0; j < i; ++j) {
            if (polls.stop(i)) return Status::cancelled;
            const HalfDistance rounded = source.rounded_half(i, j);
            *fault = fault_at(source, i, j, rounded.half);
            if (fault->flaw != DistanceFlaw::none) return Status::invalid_argument;
            fingerprint.add(rounded.half);
            const double half = joins_at(rounded, threshold);
            if (half > most[i]) most[i] = half;
            if (half > most[j]) most[j] = half;
            f(half);
        }
    }
    *out = {end_of(most, n, threshold, work.arena), fingerprint.value()};
    return Status::ok;
}

}  // namespace

Status measure_distances(const DistanceSource& source, double threshold, const Work& work, DistanceLimits* out,
                         DistanceFault* fault) {
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    if (source.kind == DistanceSource::Kind::points) {
        const double cone = cone_radius<any_dimension>(static_cast<int>(source.dim), source.numbers, source.count);
        const double limit = cone < threshold ? cone : threshold;
        *out = {limit < largest ? limit : largest, 0};
        return Status::ok;
    }
    return read_all(source, threshold, work, out, fault, [](double) {});
}

// All halves are written down as they are read, then those that are wanted move together.
Status distance_graph(const DistanceSource& source, double threshold, const Work& work, RipsGraph* out,
                      DistanceLimits* limits, DistanceFault* fault) {
    *out = {};
    const std::uint32_t n = source.count;
    Arena& arena = work.arena;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    std::uint32_t* begin = nullptr;  // of lists, where few edges may be wanted
    if (threshold < largest) {
        begin = arena.take_low<std::uint32_t>(std::size_t{n} + 1);
        if (begin == nullptr) return Status::out_of_memory;
        begin[0] = begin[1] = 0;
    }
    double* const value = arena.take_low<double>(DistanceSource::triangle(n));
    if (value == nullptr) return Status::out_of_memory;
    double* next = value;
    const Status status = read_all(source, threshold, work, limits, fault, [&next](double half) { *next++ = half; });
    if (status != Status::ok) return status;
    std::uint32_t count = 0;
    arena.each(static_cast<std::uint64_t>(next - value), 1,
               [&](std::uint64_t i) { count += value[i] <= limits->limit ? 1 : 0; });
    std::uint32_t* const kept = arena.take_low<std::uint32_t>(count);
    if (kept == nullptr) return Status::out_of_memory;
    const bool is_listed = begin != nullptr && RipsGraph::takes_lists(n, count);
    const double* half = value;
    std::uint32_t at = 0;
    for (std::uint32_t i = 1; i < n; ++i) {
        if (work.monitor.advance(i, 1 + i / 30)) return Status::cancelled;
        for (std::uint32_t j = 0; j < i; ++j, ++half) {
            if (!(*half <= limits->limit)) continue;
            value[at] = *half;
            kept[at++] = is_listed ? j : RipsGraph::edge(i, j);
        }
        if (is_listed) begin[i + 1] = at;
    }
    arena.release_low(arena.offset_of(value + count));
    std::uint32_t* const ends = arena.take_low<std::uint32_t>(count);
    if (ends == nullptr) return Status::out_of_memory;
    move_bytes(ends, kept, sizeof *ends * std::size_t{count}, arena);
    *out = {n, count, value, ends, is_listed ? begin : nullptr};
    return Status::ok;
}

// Entries in order of their edges, so that those of one edge stand together. The numbers of edges stand where values
// will and entries where ends will, so that nothing is sorted beside.
Status sparse_graph(const DistanceEntries& from, double threshold, const Work& work, RipsGraph* out,
                    DistanceLimits* limits, DistanceFault* fault) {
    *out = {};
    Arena& arena = work.arena;
    const std::uint32_t n = from.count, entries = from.entry_count;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    std::uint32_t* begin = nullptr;
    if (RipsGraph::takes_lists(n, entries)) {
        begin = arena.take_low<std::uint32_t>(std::size_t{n} + 1);
        if (begin == nullptr) return Status::out_of_memory;
        arena.each(std::uint64_t{n} + 1, 1, [begin](std::uint64_t v) { begin[v] = 0; });
    }
    double* const value = arena.take_low<double>(entries);
    std::uint32_t* const ends = arena.take_low<std::uint32_t>(entries);
    const HighScope scope(arena);
    double* const most = arena.take_high<double>(n);
    std::uint32_t* const joined = arena.take_high<std::uint32_t>(n);  // to so many others
    if (value == nullptr || ends == nullptr || most == nullptr || joined == nullptr) return Status::out_of_memory;
    std::uint32_t count = 0;
    for (std::uint32_t e = 0; e < entries; ++e) {
        if (e % 64 == 0 && work.monitor.advance(e, 4)) return Status::cancelled;
        const netmesh_distance_entry& entry = from.entries[e];
        const bool is_own = entry.i == entry.j;
        DistanceFlaw flaw = flaw_of(entry.distance);
        if (entry.i >= n || entry.j >= n) flaw = DistanceFlaw::no_point;
        if (flaw == DistanceFlaw::none && is_own && entry.distance != 0) flaw = DistanceFlaw::own;
        if (flaw != DistanceFlaw::none) {
            *fault = {flaw, e, e};
            return Status::invalid_argument;
        }
        if (is_own) continue;
        value[count] =
            static_cast<double>(entry.i > entry.j ? number_of(entry.i, entry.j) : number_of(entry.j, entry.i));
        ends[count++] = e;
    }
    if (!sort_labelled(value, ends, count, arena)) return Status::out_of_memory;
    arena.each(n, 1, [most, joined](std::uint64_t i) {
        most[i] = 0;
        joined[i] = 0;
    });
    Fingerprint fingerprint;
    fingerprint.add(std::uint64_t{n});
    std::uint32_t edges = 0, entry_before = 0;
    std::uint64_t edge = 0;
    for (std::uint32_t e = 0; e < count; ++e) {
        if (e % 64 == 0 && work.monitor.advance(e, 20)) return Status::cancelled;
        const std::uint64_t edge_before = edge;
        const std::uint32_t entry = ends[e];
        edge = static_cast<std::uint64_t>(value[e]);
        const double distance = from.entries[entry].distance;
        const bool is_again = e > 0 && edge == edge_before;
        if (is_again && from.entries[entry_before].distance != distance) {
            *fault = {DistanceFlaw::asymmetric, entry, entry_before};
            return Status::invalid_argument;
        }
        entry_before = entry;
        if (is_again) continue;
        const std::uint32_t larger = static_cast<std::uint32_t>(edge >> vertex_bits),
                            smaller = static_cast<std::uint32_t>(edge) & (RipsGraph::vertices_max - 1);
        fingerprint.add(n > RipsGraph::table_max ? edge : std::uint64_t{RipsGraph::edge(larger, smaller)});
        const HalfDistance rounded = halved(distance);
        fingerprint.add(rounded.half);
        const double half = joins_at(rounded, threshold);
        if (!(half < infinity)) continue;
        value[edges] = half;
        ends[edges++] = begin != nullptr ? smaller : RipsGraph::edge(larger, smaller);
        if (begin != nullptr) ++begin[larger];
        const std::uint32_t both[] = {larger, smaller};
        for (const std::uint32_t v : both) {
            ++joined[v];
            if (half > most[v]) most[v] = half;
        }
    }
    arena.each(n, 1, [most, joined, n](std::uint64_t i) {
        if (joined[i] != n - 1) most[i] = infinity;
    });
    *limits = {end_of(most, n, threshold, arena), fingerprint.value()};
    std::uint32_t kept = 0;
    // begin: how many have each larger end, then where those of them that stay begin.
    std::uint32_t v = 0, last = begin != nullptr ? begin[0] : 0;
    if (begin != nullptr) begin[0] = 0;
    for (std::uint32_t e = 0; e < edges; ++e) {
        if (e % 64 == 0 && work.monitor.advance(e, 3)) return Status::cancelled;
        while (begin != nullptr && e >= last) {
            last += begin[++v];
            begin[v] = kept;
        }
        if (!(value[e] <= limits->limit)) continue;
        value[kept] = value[e];
        ends[kept++] = ends[e];
    }
    if (begin != nullptr) arena.each(n - v, 1, [begin, v, kept](std::uint64_t i) { begin[v + 1 + i] = kept; });
    arena.release_low(arena.offset_of(ends + kept));
    *out = {n, kept, value, ends, begin};
    return Status::ok;
}

}  // namespace netmesh
