// A filtered simplicial complex and its persistent homology over Z/2, by the textbook's matrix.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

namespace referee {

using Simplex = std::vector<std::uint32_t>;  // vertices, ascending

constexpr std::uint32_t never = UINT32_MAX;

// A pair of positions in a complex, birth and death; `never` for an essential class.
struct PositionPair {
    std::uint32_t birth, death;
};

class Complex {
public:
    // Ranks say the order in which simplices enter; every face must be there and enter no later. Only dimensions up to
    // top + 1 count, for homology in degrees up to top.
    void add(const Simplex& simplex, std::uint32_t rank) { given_[simplex] = rank; }
    void reduce();

    std::size_t size() const { return order_.size(); }
    const Simplex& simplex(std::uint32_t position) const { return *order_[position]; }
    std::uint32_t rank(std::uint32_t position) const { return ranks_[position]; }
    std::uint32_t position(const Simplex& simplex) const;  // `never`: it is not there
    const std::vector<PositionPair>& pairs() const { return pairs_; }

    using Chain = std::vector<std::uint32_t>;  // positions, ascending
    Chain boundary(std::uint32_t position) const;
    // The position with which a cycle becomes a boundary, `never` if it stays one; 0 for the empty chain.
    std::uint32_t death_of(Chain cycle) const;

private:
    std::map<Simplex, std::uint32_t> given_;
    std::map<Simplex, std::uint32_t> positions_;
    std::vector<const Simplex*> order_;
    std::vector<std::uint32_t> ranks_;
    std::vector<std::uint32_t> owner_;  // of a pivot: the column that has it
    std::vector<Chain> columns_;
    std::vector<PositionPair> pairs_;
};

void add_chain(Complex::Chain* sum, const Complex::Chain& other);  // modulo 2

// Calls visit(simplex) for each set of 1 .. size numbers below count.
template <class Visit> void for_each_set(std::uint32_t count, std::size_t size, const Visit& visit) {
    Simplex set;
    std::uint32_t next = 0;
    while (true) {
        if (next < count && set.size() < size) {
            set.push_back(next++);
            visit(static_cast<const Simplex&>(set));
            continue;
        }
        if (set.empty()) return;
        next = set.back() + 1;
        set.pop_back();
    }
}

}  // namespace referee
