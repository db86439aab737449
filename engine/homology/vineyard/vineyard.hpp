// Vineyards (thesis 6.3): persistence along a sequence of filtrations of one complex, by transpositions on R = D V
// (Cohen-Steiner, Edelsbrunner, Morozov 2006). Between two filtrations every simplex's value moves on a straight line,
// which is a filtration at all times; simplices of one dimension whose values cross are transposed in the order of
// their times, exactly (crossing.hpp), crossings at one time by dimension, then position; and each transposition
// repairs R and V by at most two additions of columns. Only orders within a dimension matter, simplices of different
// dimensions are never transposed. A vine is a pair's path: where two pairs exchange their partners they do so in one
// point, and each goes on from there. Values that are equal in a filtration are in order of their numbers there, so
// simplices that begin equal cross at time 0 and simplices that end equal at time 1.
#pragma once
#include <cstdint>

#include "homology/vineyard/column_pool.hpp"
#include "homology/vineyard/crossing.hpp"
#include "memory/work.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// A complex without values: simplex i of dimension k >= 1 has the faces facets[k][(k+1) i .. (k+1) i + k] of dimension
// k-1.
struct ComplexView {
    static constexpr std::uint32_t dimension_max = 31;
    std::uint32_t dimension;
    std::uint32_t count[dimension_max + 1];
    const std::uint32_t* facets[dimension_max + 1];
};

class Vineyard {
public:
    // A pair of the present filtration. Vines are numbered from 0.
    struct VinePair {
        std::uint32_t vine, degree;
        std::uint32_t birth, death;  // simplices of dimensions degree, degree + 1; death `none`: essential
    };

    // Reduces the filtration value[k][count[k]] (finite, faces no later than cofaces), ties by number. Degrees
    // 0..max_degree. Takes 68 bytes a simplex and the columns at the arena's high end, where nothing else may be taken
    // until the vineyard is done with. The complex must stay. out_of_memory, cancelled.
    Status open(const ComplexView& complex, std::uint32_t max_degree, const double* const* value, const Work& work);
    // From the filtration `from` (the present one) to the next. O(log n) a transposition at most, and what the columns
    // take; simplices that share their values share the logarithm.
    // Without ok the vineyard is no longer of use. out_of_memory, cancelled.
    Status advance(const double* const* from, const double* const* to, Monitor& monitor);

    std::uint64_t transpositions() const { return transpositions_; }
    std::uint32_t vine_count() const { return vine_count_; }
    // Calls visit(VinePair) for every pair, zero-length ones too, by degree and number of the simplex that gives birth.
    template <class Visit> void for_each_pair(Visit&& visit) const {
        for (std::uint32_t k = 0; k <= max_degree_; ++k)
            for (std::uint32_t s = 0; s < complex_.count[k]; ++s)
                if (is_positive(k, s)) visit(VinePair{of_[k].vine[s], k, s, k < top_ ? of_[k].at[s].owner : none});
    }

private:
    // All that a transposition reads, in one place.
    struct Record {
        std::uint32_t position;
        std::uint32_t target;  // its position in the filtration to come
        std::uint32_t low;     // pivot of its reduced column, `none`: positive
        std::uint32_t owner;   // whose pivot it is, or `none`
        SparseColumn r, v;
        MovingValue value;  // in this filtration and the one to come
    };
    struct Dimension {
        std::uint32_t* order;  // [position] simplex
        std::uint32_t* vine;   // [simplex] of a positive one
        Record* at;            // [simplex]
        std::uint32_t slot;    // of positions 0 and 1
    };

    bool is_positive(std::uint32_t k, std::uint32_t s) const { return k == 0 || of_[k].at[s].low == none; }
    class Columns;

    Status reduce(std::uint32_t k, Monitor& monitor);
    std::uint32_t pivot_of(std::uint32_t k, const SparseColumn& column) const;
    Crossing crossing(std::uint32_t k, std::uint32_t i) const;
    double crossing_time(std::uint32_t k, std::uint32_t i) const;
    void find_winner(std::uint32_t node);
    void update_winners(std::uint32_t k, std::uint32_t first, std::uint32_t last);
    Status transpose_from(std::uint32_t k, std::uint32_t i, Monitor& monitor);
    std::uint32_t dimension_of(std::uint32_t slot) const;

    bool transpose(std::uint32_t k, std::uint32_t a, std::uint32_t b);
    bool transpose_positive(std::uint32_t k, std::uint32_t a, std::uint32_t b);
    bool transpose_negative(std::uint32_t k, std::uint32_t a, std::uint32_t b);
    bool exchange(std::uint32_t k, std::uint32_t a, std::uint32_t b);
#ifdef NETMESH_VALIDATE
    const char* violation_at(std::uint32_t k, std::uint32_t s) const;
    const char* violation() const;
#endif

    ComplexView complex_ = {};
    std::uint32_t max_degree_ = 0, top_ = 0;  // top_: highest dimension looked at
    Arena* arena_ = nullptr;
    Dimension of_[ComplexView::dimension_max + 1] = {};
    ColumnPool pool_;
    // A slot is two adjacent positions of a dimension, whose simplices may cross. The earliest crossing of all is kept
    // by a tournament: node i holds the slot that crosses earlier of those of nodes 2 i and 2 i + 1; node slots_ + s
    // is slot s.
    std::uint32_t slot_at(std::uint32_t node) const { return node >= slots_ ? node - slots_ : winner_[node]; }
    double* time_ = nullptr;           // [slot]
    std::uint32_t* winner_ = nullptr;  // [node], a slot
    std::uint32_t slots_ = 0;
    std::uint32_t vine_count_ = 0;
    std::uint64_t transpositions_ = 0, work_ = 0;
};

}  // namespace netmesh
