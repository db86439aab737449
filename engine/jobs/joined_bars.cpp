#include "jobs/joined_bars.hpp"

#include "numerics/real.hpp"
#include "numerics/sort.hpp"

namespace netmesh {
namespace {

constexpr std::size_t step_bytes = 16;

// Of degree D - 1 at most; ascending, 0 where there are fewer.
struct Named {
    std::uint32_t vertex[NETMESH_DIM_MAX];

    int compare(const Named& o) const {
        for (int i = 0; i < NETMESH_DIM_MAX; ++i)
            if (vertex[i] != o.vertex[i]) return vertex[i] < o.vertex[i] ? -1 : 1;
        return 0;
    }
};

// False: two names are the same.
bool name_simplex(const std::uint32_t* vertices, std::uint32_t size, const std::uint32_t* name, Named* named) {
    *named = {};
    for (std::uint32_t i = 0; i < size; ++i) named->vertex[i] = name[vertices[i]];
    insertion_sort(named->vertex, size, Ascending{});
    for (std::uint32_t i = 1; i < size; ++i)
        if (named->vertex[i] == named->vertex[i - 1]) return false;
    return true;
}

}  // namespace

bool write_image(const Cycle& chain, std::uint32_t degree, const std::uint32_t* name, Arena& arena, CycleWriter* writer,
                 std::uint32_t* handle) {
    const HighScope scope(arena);
    const std::uint32_t size = degree + 1;
    Named* const named = arena.take_high<Named>(chain.count);
    if (named == nullptr) return false;
    std::uint32_t count = 0, kept = 0;
    for (std::uint32_t i = 0; i < chain.count;)
        for (const std::uint64_t piece = arena.piece(i, chain.count, 60); i < piece; ++i) {
            count += name_simplex(chain.simplices + std::size_t{i} * size, size, name, &named[count]);
        }
    sort(
        named, count, [](const Named& a, const Named& b) { return a.compare(b) < 0; }, arena);
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 40); i < piece; ++i) {  // over Z/2
            if (kept > 0 && named[kept - 1].compare(named[i]) == 0) {
                --kept;
            } else {
                named[kept++] = named[i];
            }
        }
    std::uint32_t* to = writer->append(kept, degree, handle);
    if (to == nullptr) return false;
    for (std::uint32_t i = 0; i < kept;)
        for (const std::uint64_t piece = arena.piece(i, kept, 12); i < piece; ++i) {
            for (std::uint32_t k = 0; k < size; ++k) *to++ = named[i].vertex[k];
        }
    return true;
}

namespace {

bool is_long(const Pair& pair) { return pair.death > pair.birth; }

}  // namespace

std::uint64_t count_long(const PairList& list) {
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; i < list.count; ++i) count += is_long(list.pairs[i]);
    return count;
}

Status write_images(const Representatives& found, const std::uint32_t* name, Arena& arena, MeshBars* bars) {
    const PairList& list = bars->list;
    if (found.pairs.count != count_long(list)) return Status::internal;
    CycleWriter writer(arena);
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena.piece(i, list.count, 60); i < piece; ++i) {
            if (!is_long(list.pairs[i])) continue;
            const Pair& pair = found.pairs.pairs[next++];
            if (!write_image(lower_star_cycle(found.store, arena, pair), pair.degree, name, arena, &writer,
                             &bars->bounds[i].unused))
                return Status::out_of_memory;
        }
    bars->chains = writer.begin();
    bars->steps = next == 0 ? 0 : (arena.low_mark() - writer.begin()) / step_bytes;
    return Status::ok;
}

void move_lows(const JoinShift& join, const MeshBars& bars) {
    for (std::uint64_t i = 0; i < bars.list.count; ++i) {
        BarBounds& b = bars.bounds[i];
        b.birth_low = join.before(b.birth_low);
        b.death_low = join.before(b.death_low);
    }
}

void JoinedBars::open(const Arena& arena) {
    top_ = arena.high_mark();
    begin_ = (arena.low_mark() + step_bytes - 1) & ~(step_bytes - 1);
}

bool JoinedBars::add(const MeshBars& mesh, bool with_essential, Arena& arena) {
    const auto is_kept = [&](const Pair& pair) { return with_essential || pair.death < infinity; };
    std::uint64_t kept = 0;
    for (std::uint64_t i = 0; i < mesh.list.count;)
        for (const std::uint64_t piece = arena.piece(i, mesh.list.count, 30); i < piece; ++i) {
            kept += is_kept(mesh.list.pairs[i]);
        }
    if (kept >= none - count_ || mesh.steps >= none - steps_) return false;
    if (!arena.extend_high(static_cast<std::size_t>(kept) * sizeof(Bar))) return false;
    for (std::uint64_t i = 0; i < mesh.list.count;)
        for (const std::uint64_t piece = arena.piece(i, mesh.list.count, 30); i < piece; ++i) {
            if (!is_kept(mesh.list.pairs[i])) continue;
            Bar* const bar = at(count_++, arena);
            *bar = {mesh.list.pairs[i], mesh.bounds[i]};
            if (bar->bounds.unused != 0) bar->bounds.unused += steps_;
        }
    const std::size_t to = begin_ + std::size_t{steps_} * step_bytes;
    move_bytes(arena.at(to), arena.at(mesh.chains), mesh.steps * step_bytes, arena);
    steps_ += static_cast<std::uint32_t>(mesh.steps);
    arena.release_low(begin_ + std::size_t{steps_} * step_bytes);
    return true;
}

bool JoinedBars::finish(Arena& arena, CycleStore* chains, PairList* list, BarBounds** bounds) const {
    const std::size_t bytes = std::size_t{steps_} * step_bytes;
    unsigned char* const moved = arena.take_low<unsigned char>(bytes);
    if (moved == nullptr) return false;
    move_bytes(moved, arena.at(begin_), bytes, arena);
    *chains = {arena.offset_of(moved), 0};
    *list = {arena.take_low<Pair>(count_), count_};
    if (bounds != nullptr) *bounds = arena.take_low<BarBounds>(count_);
    if (list->pairs == nullptr || (bounds != nullptr && *bounds == nullptr)) return false;
    for (std::uint32_t i = 0; i < count_;)
        for (const std::uint64_t piece = arena.piece(i, count_, 30); i < piece; ++i) {
            list->pairs[i] = at(i, arena)->pair;
            list->pairs[i].cycle = i;  // for what is known of it
        }
    const CanonicalOrder before;
    sort(
        list->pairs, count_,
        [&](const Pair& a, const Pair& b) { return before(a, b) || (!before(b, a) && a.cycle < b.cycle); }, arena);
    for (std::uint32_t i = 0; i < count_;)
        for (const std::uint64_t piece = arena.piece(i, count_, 30); i < piece; ++i) {
            const BarBounds& known = at(list->pairs[i].cycle, arena)->bounds;
            list->pairs[i].cycle = known.unused;
            if (bounds == nullptr) continue;
            (*bounds)[i] = known;
            (*bounds)[i].unused = 0;
        }
    return true;
}

}  // namespace netmesh
