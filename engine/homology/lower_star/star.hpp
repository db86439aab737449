// One lower star in full, and a discrete gradient on it.
//
// Simplex 0 of the star is the vertex itself; the others are given by their lower vertices other than that one, which
// are labelled by descending rank. Every simplex knows its facets within the star; the facet opposite the vertex lies
// in another lower star. The lower star is emptied by removing a free simplex together with its only coface, and one
// maximal simplex of the largest dimension alone when there is none: that one is critical. Removed later is earlier in
// the filtration, so a pair is an apparent pair of it, and the order of values is respected.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/lower_star/link.hpp"
#include "memory/prefetch.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

template <int D> class Star {
public:
    static constexpr std::uint32_t upper = none;

    // Arrays for stars of at most simplices_max simplices, at the high end of the arena. False: out of memory.
    bool reserve(const TriangulatedBall<D>& ball, std::uint64_t simplices_max, Arena& arena);

    // Lists the lower star of v; ball.slot holds the labels of its lower vertices until close(), `upper` for the upper
    // ones. Of a vertex that the part cuts, only what is in the part is listed, and a neighbour by no edge of it has no
    // label. False when the cells are not those of a ball, or the part is not closed.
    bool open(const TriangulatedBall<D>& ball, VertexId v);
    void close(const TriangulatedBall<D>& ball);
    // The gradient. Returns how many simplices are critical.
    std::uint32_t match();

    std::uint32_t capacity() const { return capacity_; }
    std::uint32_t count() const { return count_; }
    std::uint32_t vertex(std::uint32_t label) const { return origin_[label]; }
    std::uint32_t dimension(std::uint32_t i) const { return form_[i] & 7; }
    std::uint32_t label(std::uint32_t i) const { return form_[i] >> 3; }                    // of its lowest vertex
    std::uint32_t parent(std::uint32_t i) const { return facets_[std::size_t{i} * dim_]; }  // without it
    const std::uint32_t* facets(std::uint32_t i) const { return facets_ + std::size_t{i} * dim_; }  // [dimension(i)]
    CellId cell(std::uint32_t i) const { return FacetId::from_word(origin_[i]).cell(); }  // with the face i, no vertex
    std::uint32_t partner(std::uint32_t i) const { return partner_[i]; }                  // none: critical
    // Whether i is the face of its pair.
    bool is_tail(std::uint32_t i) const { return partner_[i] != none && dimension(partner_[i]) > dimension(i); }
    std::uint32_t position(std::uint32_t i) const { return position_[i]; }  // in the filtration of the star
    std::uint32_t at(std::uint32_t position) const { return at_[position]; }
    // The simplex of these labels (ascending), none if the star has none such.
    std::uint32_t simplex_of(const std::uint32_t* labels, std::uint32_t n) const;
    // The same for labels in any order, which is lost.
    std::uint32_t simplex_of_any_order(std::uint32_t* labels, std::uint32_t n) const {
        insertion_sort(labels, n, Ascending{});
        return labels[0] == 0 ? none : simplex_of(labels, n);
    }
    // A word for each simplex, for the sweep to note which column has it as its pivot; free after match().
    std::uint32_t& owner(std::uint32_t i) { return sum_[i]; }

    // Representative label of the piece of the lower link that a label is in; until match().
    std::uint32_t piece(std::uint32_t label) {
        while (position_[label] != label) label = position_[label] = position_[position_[label]];
        return label;
    }

#ifdef NETMESH_VALIDATE
    // What is wrong with the gradient that match() made, with so many critical simplices. O(simplices).
    const char* gradient_violation(std::uint32_t critical) const;
#endif

private:
    // For the vertices of one more cell.
    bool has_room() const { return count_ + dim_ <= capacity_ && seen_count_ + dim_ <= seen_max_; }
    std::uint32_t label_of(const TriangulatedBall<D>& ball, std::uint32_t u);
    void clear_table(std::uint32_t cell_count, bool hull);
    template <bool only_listed>
    bool add_faces(const TriangulatedBall<D>& ball, FacetId incidence, const std::uint32_t* labels, std::uint32_t k);
    bool add_listed_faces(const TriangulatedBall<D>& ball, VertexId v);
    bool is_listed(const TriangulatedBall<D>& ball, VertexId v, const std::uint32_t* labels, std::uint32_t which) const;
    std::uint32_t add(std::uint32_t dimension, std::uint32_t label, std::uint32_t origin) {
        const std::uint32_t i = count_++;
        form_[i] = label << 3 | dimension;
        origin_[i] = origin;
        cofaces_[i] = sum_[i] = 0;
        return i;
    }
    std::uint32_t* place_of(std::uint32_t parent, std::uint32_t label) const;
    void remove(std::uint32_t i);
    void unite(std::uint32_t a, std::uint32_t b) {
        a = piece(a);
        b = piece(b);
        if (a != b) position_[a > b ? a : b] = a > b ? b : a;
    }

    DimensionOf<D> dim_;
    std::uint32_t *facets_, *form_, *origin_, *cofaces_, *sum_, *partner_, *position_, *at_, *queue_;
    std::uint32_t *seen_, *table_;
    std::uint32_t capacity_, count_, seen_max_, seen_count_, rank_;
    std::uint32_t table_mask_, table_shift_, table_bits_max_;
    std::uint32_t queue_begin_, queue_end_, next_position_;
};

template <int D> bool Star<D>::reserve(const TriangulatedBall<D>& ball, std::uint64_t simplices_max, Arena& arena) {
    if (simplices_max >= 0x10000000u) return false;
    dim_ = ball.dim();
    capacity_ = static_cast<std::uint32_t>(simplices_max) + dim_;
    table_bits_max_ = 6;
    while ((std::uint64_t{1} << table_bits_max_) < 2 * simplices_max) ++table_bits_max_;
    facets_ = arena.take_high<std::uint32_t>(std::size_t{capacity_} * dim_);
    seen_max_ = static_cast<std::uint32_t>(Link<D>::labels_max(ball));
    seen_ = arena.take_high<std::uint32_t>(seen_max_);
    table_ = arena.take_high<std::uint32_t>(std::size_t{1} << table_bits_max_);
    if (facets_ == nullptr || seen_ == nullptr || table_ == nullptr) return false;
    std::uint32_t** const arrays[] = {&form_, &origin_, &cofaces_, &sum_, &partner_, &position_, &at_, &queue_};
    for (std::uint32_t** array : arrays) {
        *array = arena.take_high<std::uint32_t>(capacity_);
        if (*array == nullptr) return false;
    }
    return true;
}

// First sight of a link vertex.
template <int D> std::uint32_t Star<D>::label_of(const TriangulatedBall<D>& ball, std::uint32_t u) {
    seen_[seen_count_++] = u;
    if (ball.rank[u] > rank_) return ball.slot[u] = upper;
    const std::uint32_t i = add(1, count_, u);
    position_[i] = i;
    facets_[std::size_t{i} * dim_] = 0;
    ++cofaces_[0];
    sum_[0] ^= i;
    return ball.slot[u] = i;
}

// An empty table for the faces of so many cells: a face of n vertices of the link sphere is in at least D+1-n cells.
template <int D> void Star<D>::clear_table(std::uint32_t cell_count, bool hull) {
    std::uint32_t per_cell_12 = 0;  // in twelfths, rounded up
    for (std::uint32_t n = 1, choose = dim_; n <= dim_; choose = choose * (dim_ - n) / (n + 1), ++n) {
        per_cell_12 += hull ? 12 * choose : (12 * choose + dim_ - n) / (dim_ + 1 - n);
    }
    const std::uint64_t bound = (std::uint64_t{cell_count} * per_cell_12 + 11) / 12;
    std::uint32_t bits = 6;
    while (bits < table_bits_max_ && (std::uint64_t{1} << bits) < bound + bound / 4) ++bits;
    table_shift_ = 32 - bits;
    table_mask_ = (1u << bits) - 1;
    std::uint32_t* const table = table_;
    for (std::uint32_t i = 0; i < 1u << bits; ++i) table[i] = 0;
}

template <int D> bool Star<D>::open(const TriangulatedBall<D>& ball, VertexId v) {
    const bool hull = (ball.flags[v] & TriangulatedBall<D>::on_hull) != 0;
    const bool cut = (ball.flags[v] & TriangulatedBall<D>::cut) != 0;
    rank_ = ball.rank[v];
    count_ = seen_count_ = 0;
    clear_table(ball.begin[v + 1] - ball.begin[v], hull);
    add(0, 0, ball.incidence[ball.begin[v]].word());
    for (std::uint32_t t = ball.begin[v]; jumps_matter && t < ball.begin[v] + 16; ++t) ball.prefetch(t);
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        ball.prefetch(t + 16);
        const VertexId* p = ball.complex.vertices(ball.incidence[t].cell());
        const std::uint32_t at = ball.incidence[t].position();
        if (cut && !ball.has(ball.incidence[t].cell())) continue;
        if (!has_room()) return false;
        std::uint32_t labels[DimensionOf<D>::most], k = 0;
        for (std::uint32_t j = 0; j < dim_; ++j) {
            const std::uint32_t u = p[j + (j >= at ? 1 : 0)];
            const std::uint32_t slot = ball.slot[u];
            labels[k] = slot != 0 ? slot : label_of(ball, u);
            k += labels[k] != upper ? 1 : 0;
        }
        if (k < 2) continue;
        for (std::uint32_t j = k; j < dim_; ++j) labels[j] = upper;
        if constexpr (D == any_dimension)
            insertion_sort(labels, dim_, Ascending{});
        else
            sort_small<D>(labels);
        if (!add_faces<false>(ball, ball.incidence[t], labels, k)) return false;
    }
    return !cut || add_listed_faces(ball, v);
}

// The faces of v that no cell of the part has: among those of the cells that are not in, what the part lists. When a
// face is looked at, its own faces have been, since the cells of the part came before.
template <int D> bool Star<D>::add_listed_faces(const TriangulatedBall<D>& ball, VertexId v) {
    const std::uint32_t before = seen_count_;
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        const CellId cell = ball.incidence[t].cell();
        if (ball.has(cell)) continue;
        if (!has_room()) return false;
        const VertexId* p = ball.complex.vertices(cell);
        std::uint32_t labels[DimensionOf<D>::most], k = 0;
        for (std::uint32_t j = 0; j <= dim_; ++j) {
            std::uint32_t& slot = ball.slot[p[j]];
            if (p[j] == v || ball.rank[p[j]] > rank_) continue;
            if (slot == 0) {
                const std::uint32_t edge[] = {p[j] < v ? p[j] : v, p[j] < v ? v : p[j]};
                if (ball.part->faces.contains(edge, 2))
                    label_of(ball, p[j]);
                else
                    slot = upper, seen_[seen_count_++] = p[j];  // for as long as cells are looked at
            }
            if (slot != upper) labels[k++] = slot;
        }
        insertion_sort(labels, k, Ascending{});
        if (k > 1 && !add_faces<true>(ball, ball.incidence[t], labels, k)) return false;
    }
    for (std::uint32_t l = before; l < seen_count_; ++l)
        if (ball.slot[seen_[l]] == upper) ball.slot[seen_[l]] = 0;
    return true;
}

// Whether the part lists the simplex of v and those labels that `which` has bits of.
template <int D>
bool Star<D>::is_listed(const TriangulatedBall<D>& ball, VertexId v, const std::uint32_t* labels,
                        std::uint32_t which) const {
    std::uint32_t vertices[DimensionOf<D>::most + 1] = {v}, n = 1;
    for (std::uint32_t j = 0; j < dim_; ++j) {
        if ((which >> j & 1) != 0) vertices[n++] = vertex(labels[j]);
    }
    insertion_sort(vertices, n, Ascending{});
    return n <= dim_ && ball.part->faces.contains(vertices, n);
}

template <int D> void Star<D>::close(const TriangulatedBall<D>& ball) {
    for (std::uint32_t l = 0; l < seen_count_; ++l) ball.slot[seen_[l]] = 0;
}

// Where the child of `parent` by `label` is or would be noted.
template <int D> std::uint32_t* Star<D>::place_of(std::uint32_t parent, std::uint32_t label) const {
    std::uint32_t h = (parent * 0x9E3779B1u ^ label * 0x85EBCA77u) * 0xC2B2AE3Du >> table_shift_;
    for (;; h = (h + 1) & table_mask_) {
        const std::uint32_t i = table_[h];
        if (i == 0 || (form_[i] >> 3 == label && this->parent(i) == parent)) return &table_[h];
    }
}

template <int D> std::uint32_t Star<D>::simplex_of(const std::uint32_t* labels, std::uint32_t n) const {
    std::uint32_t i = labels[0];
    for (std::uint32_t j = 1; j < n; ++j) {
        i = *place_of(i, labels[j]);
        if (i == 0) return none;
    }
    return i;
}

// All faces at the star's vertex of a cell, given by its k labels there; of a cell that is not in, those that the part
// lists. False: no room, or a face that is listed without its own faces.
template <int D>
template <bool only_listed>
bool Star<D>::add_faces(const TriangulatedBall<D>& ball, FacetId incidence, const std::uint32_t* labels,
                        std::uint32_t k) {
    std::uint32_t ids[1u << DimensionOf<D>::most];  // `none`: not in
    ids[0] = 0;
    for (std::uint32_t j = 0; j < k; ++j) {
        const std::uint32_t bit = 1u << j;
        ids[bit] = labels[j];
        for (std::uint32_t rest = 1; rest < bit; ++rest) {
            const std::uint32_t parent = ids[rest];
            if constexpr (only_listed) {
                ids[rest | bit] = none;
                if (parent == none) continue;
            }
            std::uint32_t* place = place_of(parent, labels[j]);
            if (*place == 0) {
                if constexpr (only_listed) {
                    const VertexId v = ball.complex.vertices(incidence.cell())[incidence.position()];
                    if (!is_listed(ball, v, labels, rest | bit)) continue;
                }
                if (count_ == capacity_ || count_ > table_mask_ - (table_mask_ >> 3)) return false;
                const std::uint32_t i = add(dimension(parent) + 1, labels[j], incidence.word());
                *place = i;
                std::uint32_t* facet = facets_ + std::size_t{i} * dim_;
                *facet++ = parent;
                for (std::uint32_t b = 0; b < j; ++b) {
                    if ((rest >> b & 1) == 0) continue;
                    const std::uint32_t id = ids[(rest ^ 1u << b) | bit];
                    if (only_listed && id == none) return false;
                    *facet++ = id;
                }
                for (std::uint32_t f = 0; f < dimension(i); ++f) {
                    ++cofaces_[facets(i)[f]];
                    sum_[facets(i)[f]] ^= i;
                }
                if (dimension(i) == 2) unite(label(parent), labels[j]);
            }
            ids[rest | bit] = *place;
        }
    }
    return true;
}

// Takes i out: its facets lose a coface, and become free if one is left.
template <int D> void Star<D>::remove(std::uint32_t i) {
    position_[i] = --next_position_;
    at_[next_position_] = i;
    const std::uint32_t n = dimension(i);
    for (std::uint32_t f = 0; f < n; ++f) {
        const std::uint32_t face = facets(i)[f];
        sum_[face] ^= i;
        if (--cofaces_[face] == 1) queue_[queue_end_++] = face;
    }
}

template <int D> std::uint32_t Star<D>::match() {
    constexpr std::uint32_t present = none - 1;
    std::uint32_t critical = 0, scan[DimensionOf<D>::most + 1];
    queue_begin_ = queue_end_ = 0;
    next_position_ = count_;
    for (std::uint32_t i = 0; i < count_; ++i) {
        partner_[i] = present;
        if (cofaces_[i] == 1) queue_[queue_end_++] = i;
    }
    for (std::uint32_t k = 0; k <= dim_; ++k) scan[k] = 0;
    while (next_position_ > 0) {
        while (queue_begin_ < queue_end_) {
            const std::uint32_t i = queue_[queue_begin_++];
            if (cofaces_[i] != 1) continue;  // also when it is gone: what goes has no cofaces left
            const std::uint32_t coface = sum_[i];
            partner_[i] = coface;
            partner_[coface] = i;
            remove(coface);
            remove(i);
        }
        if (next_position_ == 0) break;
        std::uint32_t k = dim_;  // some are left, so the search ends
        for (;; --k) {
            while (scan[k] < count_ && (dimension(scan[k]) != k || partner_[scan[k]] != present)) ++scan[k];
            if (scan[k] < count_) break;
        }
        const std::uint32_t i = scan[k];
        partner_[i] = none;
        ++critical;
        remove(i);
    }
    return critical;
}

#ifdef NETMESH_VALIDATE
// Simplices come after their facets; pairs are facet and simplex, mutual and next to each other in the filtration, so
// each is an apparent pair and the gradient has no cycles.
template <int D> const char* Star<D>::gradient_violation(std::uint32_t critical) const {
    for (std::uint32_t i = 0; i < count_; ++i) {
        if (position_[i] >= count_ || at_[position_[i]] != i) return "positions of a star are not a permutation";
        bool has_partner = false;
        for (std::uint32_t f = 0; f < dimension(i); ++f) {
            const std::uint32_t facet = facets(i)[f];
            if (facet >= count_ || dimension(facet) + 1 != dimension(i)) return "a facet has another dimension";
            if (position_[facet] >= position_[i]) return "a simplex of a star comes before its facet";
            has_partner |= facet == partner_[i];
        }
        critical -= partner_[i] == none;
        if (partner_[i] == none) continue;
        if (partner_[i] >= count_ || partner_[partner_[i]] != i) return "a pair of the gradient is not mutual";
        if (!is_tail(i) && (!has_partner || position_[partner_[i]] + 1 != position_[i]))
            return "a pair of the gradient is not a simplex and its last facet";
    }
    return critical == 0 ? nullptr : "the count of critical simplices is wrong";
}
#endif

}  // namespace netmesh
