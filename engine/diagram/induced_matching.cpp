#include "diagram/induced_matching.hpp"

#include "numerics/sort.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {
namespace {

// By degree, death, birth, then place.
void order_by_death(const PairList& list, std::uint32_t* order, const Arena& arena) {
    const Pair* const pairs = list.pairs;
    for (std::uint32_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena.piece(i, list.count, 3); i < piece; ++i) {
            order[i] = i;
        }
    sort(
        order, list.count,
        [pairs](std::uint32_t a, std::uint32_t b) {
            if (pairs[a].degree != pairs[b].degree) return pairs[a].degree < pairs[b].degree;
            if (pairs[a].death != pairs[b].death) return pairs[a].death < pairs[b].death;
            return pairs[a].birth != pairs[b].birth ? pairs[a].birth < pairs[b].birth : a < b;
        },
        arena);
}

bool same_birth(const Pair& a, const Pair& b) { return a.degree == b.degree && a.birth == b.birth; }
bool same_death(const Pair& a, const Pair& b) { return a.degree == b.degree && a.death == b.death; }

}  // namespace

Status match_induced(const MappedDiagrams& diagrams, Arena& arena, std::uint32_t* to) {
    const HighScope scope(arena);
    const PairList &source = diagrams.source, &image = diagrams.image, &target = diagrams.target;
    if (source.count >= none || image.count >= none || target.count >= none) return Status::out_of_memory;
    const std::uint32_t images = static_cast<std::uint32_t>(image.count);
    std::uint32_t* const image_order = arena.take_high<std::uint32_t>(images);
    std::uint32_t* const target_order = arena.take_high<std::uint32_t>(static_cast<std::size_t>(target.count));
    std::uint32_t* const end = arena.take_high<std::uint32_t>(images);  // the target's pair of each of the image
    if (image_order == nullptr || target_order == nullptr || end == nullptr) return Status::out_of_memory;
    order_by_death(image, image_order, arena);
    order_by_death(target, target_order, arena);
    // Of one death the first to be born is the longest.
    std::uint64_t t = 0;
    for (std::uint32_t i = 0; i < images;)
        for (const std::uint64_t piece = arena.piece(i, images, 40); i < piece; ++i) {
            const Pair& pair = image.pairs[image_order[i]];
            while (t < target.count && !same_death(target.pairs[target_order[t]], pair)) ++t;
            if (t == target.count || target.pairs[target_order[t]].birth > pair.birth) return Status::internal;
            end[image_order[i]] = target_order[t++];
        }
    // Of one birth the last to die is.
    for (std::uint64_t s = 0; s < source.count;)
        for (const std::uint64_t piece = arena.piece(s, source.count, 3); s < piece; ++s) {
            to[s] = none;
        }
    std::uint64_t left = source.count;
    for (std::uint32_t i = images; i-- > 0;) {
        arena.step(i, 40);
        const Pair& pair = image.pairs[i];
        while (left > 0 && !same_birth(source.pairs[left - 1], pair)) --left;
        if (left == 0 || source.pairs[left - 1].death < pair.death) return Status::internal;
        to[--left] = end[i];
    }
    return Status::ok;
}

}  // namespace netmesh
