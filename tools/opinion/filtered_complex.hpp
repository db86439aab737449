// A filtered simplicial complex, simplex by simplex, reduced as the textbook says. Everything in this folder is a
// second opinion on what the engine computes: it is written for being plainly right, shares no code with the engine,
// and takes small inputs.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/io/diagram_file.hpp"

namespace netmesh::tool {

using Vertices = std::vector<std::uint32_t>;  // of a simplex, ascending

struct FilteredSimplex {
    Vertices vertices;
    double value;  // at which it enters
};

// What is said of a chain: where its last simplex enters at the latest, until when it is no boundary and from when on
// it is one, infinite for never.
struct ChainClaim {
    std::uint32_t degree;
    double born_by, alive_until, dead_from;
};

class FilteredComplex {
public:
    // All faces must be there and enter no later than `slack` allows; any order. Where the values are the engine's own
    // numbers slack is 0; where they were computed anew, values that differ by a share of `slack` count as equal.
    explicit FilteredComplex(std::vector<FilteredSimplex> simplices, double slack = 0);

    std::size_t count() const { return simplices_.size(); }
    // The pairs of degrees up to max_degree, in the order of .pers files; those of length zero when asked for. The
    // complex must have all simplices of dimension max_degree + 1.
    std::vector<Bar> bars(std::uint32_t max_degree, bool zero_bars) const;
    // Empty when `have` are those bars, otherwise what is wrong; *at is the bar of `have` at fault.
    std::string bars_complaint(const std::vector<Bar>& have, std::uint32_t max_degree, bool zero_bars,
                               std::size_t* at) const;
    // Empty when the chain of simplices of one dimension is a cycle (in degree 0: one vertex, or two where the bar
    // dies) that is born with the bar, is no boundary before its death and is one from then on; otherwise what is
    // wrong.
    std::string cycle_complaint(const std::vector<Vertices>& chain, const Bar& bar) const;
    // Empty when the chain is a cycle as it is said to be. alive_until below born_by says nothing.
    std::string chain_complaint(const std::vector<Vertices>& chain, const ChainClaim& claim) const;

private:
    using Column = std::vector<std::uint32_t>;  // positions in the filtration, ascending

    // Simplices of a chain, which must be different ones of the degree with no boundary together; a complaint, or
    // empty.
    std::string read_cycle(const std::vector<Vertices>& chain, std::uint32_t degree, Column* column,
                           double* latest) const;
    Column boundary(std::uint32_t simplex) const;
    void reduce();
    bool is_boundary(Column chain, double until, bool included) const;
    bool is_same(double a, double b) const;
    std::uint32_t dimension(std::uint32_t i) const {
        return static_cast<std::uint32_t>(simplices_[i].vertices.size() - 1);
    }

    std::vector<FilteredSimplex> simplices_;   // in the order in which they enter
    std::map<Vertices, std::uint32_t> place_;  // of each
    std::vector<Column> reduced_;              // R of R = D V
    std::vector<std::uint32_t> killed_by_;     // the column with this pivot, or `nobody`
    double slack_;
    static constexpr std::uint32_t nobody = UINT32_MAX;
};

}  // namespace netmesh::tool
