#include "periods/orbits.hpp"

#include "numerics/bits.hpp"
#include "numerics/random.hpp"

namespace netmesh {
namespace {

constexpr int vertices_most = dimension_most() + 1;

// A simplex as points with translations, and a hash of it that no translation and no order of its vertices changes.
struct Translated {
    std::uint32_t point[vertices_most];
    std::int64_t shift[vertices_most];
    int count;

    // Of shifts what each is beside their mean, times their number.
    std::uint64_t hash() const {
        std::uint64_t sum = 0, h = 0;
        for (int i = 0; i < count; ++i) sum += static_cast<std::uint64_t>(shift[i]);
        for (int i = 0; i < count; ++i) {
            const std::uint64_t beside = static_cast<std::uint64_t>(shift[i]) * static_cast<unsigned>(count) - sum;
            h += mix64(beside * 0x9E3779B97F4A7C15u + point[i]);
        }
        return h;
    }
    // Whether the vertex of the least point, and of these the copy that is first, is the point itself. Translations
    // keep which vertex that is, so it is true of one translate.
    bool stands_for_all() const {
        int least = 0;
        for (int i = 1; i < count; ++i)
            if (point[i] < point[least] || (point[i] == point[least] && shift[i] < shift[least])) least = i;
        return shift[least] == 0;
    }
    // Whether a translation takes the other one to this: one of its vertices to the first of this one's, and each to
    // one. None is taken to two, as vertices are different.
    bool is_translate_of(const Translated& other) const {
        for (int first = 0; first < count; ++first) {
            if (other.point[first] != point[0]) continue;
            const std::int64_t by = shift[0] - other.shift[first];
            bool is_one = true;
            for (int i = 1; i < count && is_one; ++i) {
                is_one = false;
                for (int j = 0; j < count; ++j) is_one |= other.point[j] == point[i] && other.shift[j] + by == shift[i];
            }
            if (is_one) return true;
        }
        return false;
    }
};

class Orbits {
public:
    Orbits(const PeriodicPoints& points, const Copies& copies, int dimension, const Work& work, AnyFaces* faces,
           double* const* value, std::uint32_t** vertices, bool* repeats)
        : points_(points), copies_(copies), dimension_(dimension), arena_(work.arena), faces_(*faces), value_(value),
          vertices_(vertices), repeats_(*repeats) {}

    Status run() {
        repeats_ = false;
        Status status = mark();
        if (status != Status::ok) return status;
        for (int k = dimension_; k >= 0; --k) {
            status = find_orbits(k);
            if (status != Status::ok) return status;
            if (arena_.has_stopped()) return Status::cancelled;
        }
        for (int k = 0; k <= dimension_ && vertices_ != nullptr; ++k)
            if (!list_vertices(k)) return Status::out_of_memory;
        for (int k = 0; k <= dimension_; ++k) write(k);
        return Status::ok;
    }

private:
    // Of a face: has it a vertex among the points, are all of them, and have all of them copies that are vertices?
    enum Mark : std::uint8_t { has_point = 1, all_points = 2, all_shared = 4 };
    bool is_across(int k, std::uint64_t f) const { return (mark_[k][f] & (has_point | all_points)) == has_point; }
    // Can a translate of the face be a facet of something that goes across?
    bool is_listed(int k, std::uint64_t f) const { return is_across(k, f) || (mark_[k][f] & all_shared) != 0; }

    Status mark_vertices() {
        const HighScope scope(arena_);
        std::uint8_t* const shared = arena_.take_high<std::uint8_t>(points_.count);
        if (shared == nullptr) return Status::out_of_memory;
        arena_.each(points_.count, 1, [shared](std::uint64_t i) { shared[i] = 0; });
        const std::uint32_t* const vertex = faces_.last_vertex[0];
        listed_[0] = 0;
        arena_.each(faces_.count[0], 4, [&](std::uint64_t f) {
            if (vertex[f] >= points_.count) shared[copies_.own[vertex[f] - points_.count]] = all_shared;
        });
        arena_.each(faces_.count[0], 4, [&](std::uint64_t f) {
            const bool is_point = vertex[f] < points_.count;
            mark_[0][f] = is_point ? static_cast<std::uint8_t>(has_point | all_points | shared[vertex[f]]) : 0;
            listed_[0] += is_listed(0, f);
        });
        return Status::ok;
    }
    // The vertices of the first and of the last facet are all.
    void mark_faces(int k) {
        const std::uint8_t* const below = mark_[k - 1];
        listed_[k] = 0;
        arena_.each(faces_.count[k], 5, [&](std::uint64_t f) {
            const std::uint32_t* const facet = faces_.facets_of(k, static_cast<std::uint32_t>(f));
            const unsigned a = below[facet[0]], b = below[facet[k]];
            mark_[k][f] = static_cast<std::uint8_t>(((a | b) & has_point) | (a & b & (all_points | all_shared)));
            listed_[k] += is_listed(k, f);
        });
    }
    Status mark() {
        for (int k = 0; k <= dimension_; ++k) {
            mark_[k] = arena_.take_high<std::uint8_t>(faces_.count[k]);
            if (mark_[k] == nullptr) return Status::out_of_memory;
            if (k > 0) {
                mark_faces(k);
                continue;
            }
            const Status status = mark_vertices();
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }
    [[gnu::noinline]] void read(int k, std::uint32_t f, Translated* out) const {
        std::uint32_t vertex[vertices_most];
        faces_.vertices(k, f, vertex);
        out->count = k + 1;
        for (int i = 0; i <= k; ++i) {
            out->point[i] = copies_.point_of(vertex[i], points_.count);
            out->shift[i] = copies_.shift_of(vertex[i], points_.count);
        }
    }

    // By open addressing: faces that stand for others and can be asked for.
    struct Table {
        std::uint32_t* slot;
        std::uint64_t mask;

        std::uint32_t* free_slot(std::uint64_t hash) const {
            for (std::uint64_t at = hash;; ++at)
                if (slot[at & mask] == none) return slot + (at & mask);
        }
    };
    // The face of the table that is a translate of face f, or none.
    std::uint32_t look_up(const Table& table, int k, std::uint32_t f) const {
        Translated face, other;
        read(k, f, &face);
        for (std::uint64_t at = face.hash();; ++at) {
            const std::uint32_t found = table.slot[at & table.mask];
            if (found == none) return none;
            read(k, found, &other);
            if (face.is_translate_of(other)) return found;
        }
    }

    // first_[k][f]: the face that stands for the orbit, or none where it is not asked for. What faces of one dimension
    // more stand for others is known.
    Status find_orbits(int k) {
        const std::uint32_t count = faces_.count[k], width = static_cast<std::uint32_t>(k) + 1;
        std::uint32_t* const first = first_[k] = arena_.take_high<std::uint32_t>(count);
        if (first == nullptr) return Status::out_of_memory;
        const bool are_facets = k < dimension_;
        const HighScope scope(arena_);
        Table table = {nullptr, 1};
        while (table.mask < 2 * listed_[k] && are_facets) table.mask *= 2;
        table.slot = arena_.take_high<std::uint32_t>(static_cast<std::size_t>(table.mask));
        if (table.slot == nullptr) return Status::out_of_memory;
        arena_.each(table.mask, 2, [&](std::uint64_t i) { table.slot[i] = none; });
        --table.mask;
        arena_.each(count, 5, [&](std::uint64_t f) {
            first[f] = (mark_[k][f] & all_points) != 0 ? static_cast<std::uint32_t>(f) : none;
            if (!is_across(k, f) && !(are_facets && is_listed(k, f))) return;
            arena_.pass(width);
            Translated face;
            read(k, static_cast<std::uint32_t>(f), &face);
            if (!face.stands_for_all()) return;
            first[f] = static_cast<std::uint32_t>(f);
            if (are_facets) *table.free_slot(face.hash()) = first[f];
        });
        return are_facets ? find_facets(k, table) : Status::ok;
    }
    // What facets of those that stand for others are translates of.
    Status find_facets(int k, const Table& table) {
        std::uint32_t* const first = first_[k];
        bool is_whole = true;
        arena_.each(faces_.count[k + 1], 10 * (static_cast<std::uint32_t>(k) + 1), [&](std::uint64_t c) {
            if (!is_across(k + 1, c) || first_[k + 1][c] != c) return;
            const std::uint32_t* const facet = faces_.facets_of(k + 1, static_cast<std::uint32_t>(c));
            for (int i = 0; i <= k + 1; ++i) {
                if (first[facet[i]] != none) continue;
                first[facet[i]] = look_up(table, k, facet[i]);
                is_whole &= first[facet[i]] != none;
            }
        });
        return is_whole ? Status::ok : Status::internal;
    }

    bool list_vertices(int k) {
        std::uint64_t words = 0;
        arena_.each(faces_.count[k], 2, [&](std::uint64_t f) { words += first_[k][f] == f; });
        words *= static_cast<unsigned>(k) + 1;
        std::uint32_t* to = vertices_[k] = arena_.take_low<std::uint32_t>(static_cast<std::size_t>(words));
        if (to == nullptr) return false;
        arena_.each(faces_.count[k], 4 * (static_cast<std::uint32_t>(k) + 1), [&](std::uint64_t f) {
            if (first_[k][f] != f) return;
            faces_.vertices(k, static_cast<std::uint32_t>(f), to);
            to += k + 1;
        });
        return true;
    }

    // Puts those that stand for others where the first faces were. Of each of them first_ becomes its number there,
    // with a bit that no face has.
    void write(int k) {
        const std::uint32_t count = faces_.count[k], width = static_cast<std::uint32_t>(k) + 1;
        std::uint32_t kept = 0;
        arena_.each(count, 4 * width, [&](std::uint64_t at) {
            const auto f = static_cast<std::uint32_t>(at);
            if (first_[k][f] != f) return;
            if (k > 0) {
                const std::uint32_t* const from = faces_.facets_of(k, f);
                std::uint32_t* const to = faces_.facets[k] + std::size_t{kept} * width;
                for (std::uint32_t i = 0; i < width; ++i) to[i] = number_of(k - 1, from[i]);
                // Facets of points alone are translates of no others.
                for (std::uint32_t i = 1; i < width && is_across(k, at); ++i)
                    for (std::uint32_t other = 0; other < i; ++other) repeats_ |= to[other] == to[i];
            }
            value_[k][kept] = value_[k][f];
            first_[k][f] = kept++ | is_number;
        });
        faces_.count[k] = kept;
    }
    std::uint32_t number_of(int k, std::uint32_t f) const {
        const std::uint32_t first = first_[k][f];
        return ((first & is_number) != 0 ? first : first_[k][first]) & ~is_number;
    }
    static constexpr std::uint32_t is_number = 0x80000000u;

    const PeriodicPoints& points_;
    const Copies& copies_;
    const int dimension_;
    Arena& arena_;
    AnyFaces& faces_;
    double* const* const value_;
    std::uint32_t** const vertices_;
    bool& repeats_;
    std::uint8_t* mark_[vertices_most];
    std::uint32_t* first_[vertices_most];
    std::uint64_t listed_[vertices_most];  // faces
};

}  // namespace

Status take_orbits(const PeriodicPoints& points, const Copies& copies, int dimension, const Work& work, AnyFaces* faces,
                   double* const* value, std::uint32_t** vertices, bool* repeats) {
    const HighScope scope(work.arena);
    return Orbits(points, copies, dimension, work, faces, value, vertices, repeats).run();
}

}  // namespace netmesh
