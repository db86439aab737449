// Faces of a triangulation, star by star: the records that faces.cpp unfolds into tables.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/triangulation.hpp"
#include "memory/arena.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

constexpr std::uint32_t last_sibling = 0x80000000u;  // cells are below 2^29, so vertices are far below 2^31

// A stream of words that grows at the low end of the arena while nothing else does. Its blocks are multiples of the
// arena's alignment, so they lie end to end.
class WordStream {
public:
    explicit WordStream(Arena& arena) : arena_(arena), words_(nullptr), count_(0), capacity_(0) {}
    bool reserve(std::size_t more) {
        while (capacity_ - count_ < more) {
            std::uint32_t* block = arena_.take_low<std::uint32_t>(block_words);
            if (block == nullptr) return false;
            if (words_ == nullptr) words_ = block;
            capacity_ += block_words;
        }
        return true;
    }
    void push(std::uint32_t word) { words_[count_++] = word; }
    const std::uint32_t* words() const { return words_; }

private:
    static constexpr std::size_t block_words = 4096;
    static_assert(block_words * sizeof(std::uint32_t) % Arena::alignment == 0, "");
    Arena& arena_;
    std::uint32_t* words_;
    std::size_t count_, capacity_;
};

// Walks the star of one vertex at a time. Inside a star vertices go by their rank in its link and cells by their number
// in the star.
template <int D> class StarWalk {
public:
    bool reserve(const TriangulationView<D>& complex, std::uint32_t degree_max, int dimension_max, Arena& arena) {
        dim_ = complex.dim;
        const std::size_t degree = degree_max, n = complex.vertex_count;
        const std::size_t link_max = degree * dim_ < n ? degree * dim_ : n;
        dimension_max_ = dimension_max;
        rank_ = arena.take_high<std::uint32_t>(n);
        upper_ = arena.take_high<std::uint32_t>(degree * dim_);
        size_ = arena.take_high<std::uint8_t>(degree);
        link_ = arena.take_high<std::uint32_t>(link_max);
        seen_ = arena.take_high<std::uint32_t>(link_max);
        tally_ = arena.take_high<std::uint32_t>(link_max);
        bool enough = rank_ && upper_ && size_ && link_ && seen_ && tally_;
        for (int level = 0; level < dimension_max; ++level) {
            entries_[level] = arena.take_high<Entry>(degree * entries_a_cell(level));
            enough = enough && entries_[level] != nullptr;
        }
        if (!enough) return false;
        for (std::size_t v = 0; v < n;)
            for (const std::uint64_t piece = arena.piece(v, n, 3); v < piece; ++v) {
                rank_[v] = none;
            }
        for (std::size_t i = 0; i < link_max; ++i) tally_[i] = 0;
        return true;
    }

    // Appends the records of the star of v to the stream: for every face but those of the greatest dimension, in the
    // order of the walk, its children, the last one marked, or `none`. False when the stream cannot grow.
    bool walk(const TriangulationView<D>& complex, std::uint32_t v, const CellId* cells, std::uint32_t degree,
              WordStream& stream) {
        load(complex, v, cells, degree);
        std::uint32_t at[DimensionOf<D>::most + 1], end[DimensionOf<D>::most + 1];
        end[1] = 0;
        if (!expand(entries_[0], star_size_, 0, stream, &end[1])) return false;
        at[1] = 0;
        for (int level = 1; level >= 1 && level < dimension_max_;) {
            if (at[level] == end[level]) {
                --level;
                continue;
            }
            const Entry* e = entries_[level];
            const std::uint32_t begin = at[level], head = rank_of(e[begin]);
            std::uint32_t stop = begin + 1;
            while (stop < end[level] && rank_of(e[stop]) == head) ++stop;
            at[level] = stop;
            if (!expand(e + begin, stop - begin, level, stream, &end[level + 1])) return false;
            if (level + 1 < dimension_max_) at[++level] = 0;
        }
        return true;
    }

private:
    // A cell of the star that contains the current face and goes on with upper_[cell][next ..].
    class Entry {
    public:
        Entry() = default;
        Entry(std::uint32_t cell, std::uint32_t next) : word_(cell << 3 | next) {}
        std::uint32_t cell() const { return word_ >> 3; }
        std::uint32_t next() const { return word_ & 7u; }

    private:
        std::uint32_t word_;
    };

    // Most faces have few children, for which starting sort() takes longer than sorting.
    void sort_children(std::uint32_t children) {
#ifndef __OPTIMIZE_SIZE__
        if (children <= 24) return insertion_sort(seen_, children, Ascending{});
#endif
        sort_alike(seen_, children, Ascending{});
    }
    std::size_t entries_a_cell(int level) const { return level == 0 ? 1 : dim_ + 1 - static_cast<std::size_t>(level); }
    std::uint32_t rank_of(Entry entry) const { return upper_[entry.cell() * dim_ + entry.next() - 1]; }

    // Sorts what is above v in each cell of its star and replaces it by ranks in the link.
    void load(const TriangulationView<D>& complex, std::uint32_t v, const CellId* cells, std::uint32_t degree) {
        std::uint32_t link_size = 0;
        star_size_ = 0;
        for (std::uint32_t i = 0; i < degree; ++i) {
            const VertexId* w = complex.vertices(cells[i]);
            std::uint32_t* u = upper_ + static_cast<std::size_t>(star_size_) * dim_;
            int n = 0;
            for (std::uint32_t j = 0; j <= dim_; ++j) {
                if (w[j] <= v) continue;
                int at = n++;
                for (; at > 0 && u[at - 1] > w[j]; --at) u[at] = u[at - 1];
                u[at] = w[j];
                if (rank_[w[j]] == none) {
                    rank_[w[j]] = 0;
                    link_[link_size++] = w[j];
                }
            }
            if (n == 0) continue;
            entries_[0][star_size_] = Entry(star_size_, 0);
            size_[star_size_++] = static_cast<std::uint8_t>(n);
        }
        sort_alike(link_, link_size, Ascending{});
        for (std::uint32_t r = 0; r < link_size; ++r) rank_[link_[r]] = r;
        for (std::uint32_t c = 0; c < star_size_; ++c)
            for (std::uint32_t j = 0; j < size_[c]; ++j) upper_[c * dim_ + j] = rank_[upper_[c * dim_ + j]];
        for (std::uint32_t r = 0; r < link_size; ++r) rank_[link_[r]] = none;
    }

    // Writes the record of the face that `face[0..n)` contain; below the greatest dimension also lists their entries
    // for its children in entries_[level + 1], ascending by child.
    bool expand(const Entry* face, std::uint32_t n, int level, WordStream& stream, std::uint32_t* listed) {
        std::uint32_t children = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t c = face[i].cell();
            for (std::uint32_t j = face[i].next(); j < size_[c]; ++j) {
                const std::uint32_t w = upper_[c * dim_ + j];
                if (tally_[w]++ == 0) seen_[children++] = w;
            }
        }
        if (!stream.reserve(children + 1)) return false;
        if (children == 0) stream.push(none);
        sort_children(children);
        std::uint32_t start = 0;
        for (std::uint32_t i = 0; i < children; ++i) {
            stream.push(link_[seen_[i]] | (i + 1 == children ? last_sibling : 0u));
            const std::uint32_t here = tally_[seen_[i]];
            tally_[seen_[i]] = start;
            start += here;
        }
        *listed = start;
        if (level + 1 < dimension_max_) {
            Entry* to = entries_[level + 1];
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t c = face[i].cell();
                for (std::uint32_t j = face[i].next(); j < size_[c]; ++j)
                    to[tally_[upper_[c * dim_ + j]]++] = Entry(c, j + 1);
            }
        }
        for (std::uint32_t i = 0; i < children; ++i) tally_[seen_[i]] = 0;
        return true;
    }

    DimensionOf<D> dim_;
    int dimension_max_;
    std::uint32_t star_size_;
    std::uint32_t* rank_;                   // [vertex_count], `none` between calls
    std::uint32_t* upper_;                  // [degree][dim_], ascending ranks
    std::uint8_t* size_;                    // [degree], how many there are
    std::uint32_t* link_;                   // [link], vertex of each rank
    std::uint32_t* seen_;                   // [link], scratch of expand
    std::uint32_t* tally_;                  // [link], 0 between calls
    Entry* entries_[DimensionOf<D>::most];  // [level][degree * entries_a_cell(level)]
};

}  // namespace netmesh
