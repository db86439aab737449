// Second opinions on reductions of small matrices over Z/2. For builds with NETMESH_VALIDATE.
#pragma once
#ifdef NETMESH_VALIDATE
#include <cstdint>

#include "complex/filtered_complex.hpp"
#include "homology/bit_set.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// Larger matrices are not checked.
constexpr std::uint32_t validated_columns_max = 256;

// A sum of rows, searched from end to end. Sums that become too long are not known.
class SmallChain {
public:
    void toggle(std::uint64_t row) {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (row_[i] != row) continue;
            row_[i] = row_[--count_];
            return;
        }
        if (count_ < capacity)
            row_[count_++] = row;
        else
            known_ = false;
    }
    bool is_known() const { return known_; }
    std::uint32_t count() const { return count_; }
    bool has(std::uint64_t row) const {
        for (std::uint32_t i = 0; i < count_; ++i)
            if (row_[i] == row) return true;
        return false;
    }
    // All ones when the sum is empty.
    std::uint64_t least() const {
        std::uint64_t least = ~std::uint64_t{0};
        for (std::uint32_t i = 0; i < count_; ++i) least = row_[i] < least ? row_[i] : least;
        return least;
    }
    std::uint32_t largest() const {
        std::uint64_t largest = 0;
        for (std::uint32_t i = 0; i < count_; ++i) largest = row_[i] > largest ? row_[i] : largest;
        return count_ == 0 ? none : static_cast<std::uint32_t>(largest);
    }

private:
    static constexpr std::uint32_t capacity = 256;
    std::uint64_t row_[capacity];
    std::uint32_t count_ = 0;
    bool known_ = true;
};

// The textbook reduction of the boundaries of all k-simplices, as rows of bits: faces that are pivots, simplices whose
// columns have them.
struct TextbookPairs {
    static constexpr std::uint32_t words = validated_columns_max / 64;
    bool fits;
    bool is_pivot[validated_columns_max] = {}, kills[validated_columns_max] = {};

    TextbookPairs(const FilteredComplex::Simplices& simplices, std::uint32_t k, std::uint32_t faces)
        : fits(simplices.count <= validated_columns_max && faces <= validated_columns_max) {
        std::uint64_t column[validated_columns_max][words] = {};
        std::uint32_t owner[validated_columns_max];
        for (std::uint32_t& o : owner) o = none;
        for (std::uint32_t j = 0; fits && j < simplices.count; ++j) {
            for (std::uint32_t i = 0; i <= k; ++i) {
                const std::uint32_t face = simplices.faces[std::size_t{j} * (k + 1) + i];
                column[j][face / 64] ^= std::uint64_t{1} << (face % 64);
            }
            for (std::uint32_t row = faces; row-- > 0;) {
                if ((column[j][row / 64] >> (row % 64) & 1) == 0) continue;
                if (owner[row] == none) {
                    owner[row] = j;
                    is_pivot[row] = kills[j] = true;
                    break;
                }
                for (std::uint32_t w = 0; w < words; ++w) column[j][w] ^= column[owner[row]][w];
            }
        }
    }
};

// Are `pivots` the (k-1)-simplices, `faces` of them, that the boundaries of the k-simplices pair?
inline const char* pivots_violation(const FilteredComplex::Simplices& simplices, std::uint32_t k, std::uint32_t faces,
                                    const BitSet& pivots) {
    const TextbookPairs expected(simplices, k, faces);
    for (std::uint32_t f = 0; expected.fits && f < faces; ++f)
        if (pivots.has(f) != expected.is_pivot[f]) return "other simplices are pivots than by the textbook";
    return nullptr;
}

// Are `killers` the k-simplices whose boundaries are paired?
inline const char* killers_violation(const FilteredComplex::Simplices& simplices, std::uint32_t k, std::uint32_t faces,
                                     const BitSet& killers) {
    const TextbookPairs expected(simplices, k, faces);
    for (std::uint32_t j = 0; expected.fits && j < simplices.count; ++j)
        if (killers.has(j) != expected.kills[j]) return "other simplices end a class than by the textbook";
    return nullptr;
}

}  // namespace netmesh
#endif
