// Which chains of a filtration are boundaries, by the textbook reduction.
#pragma once
#include "oracle.hpp"

namespace oracle {

using Column = std::vector<std::uint32_t>;
inline Column sum(const Column& a, const Column& b) {
    Column c;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(c));
    return c;
}

// Boundaries of a filtration, reduced; asks of any chain whether it is a boundary of simplices up to a value.
class Boundaries {
public:
    explicit Boundaries(const Filtered& f) : f_(f), by_pivot_(f.simplices.size()), made_by_(f.simplices.size()) {
        for (std::uint32_t i = 0; i < f.simplices.size(); ++i) index_[f.simplices[i]] = i;
        for (std::uint32_t j = 0; j < f.simplices.size(); ++j) {
            Column column = boundary({j});
            while (!column.empty() && !by_pivot_[column.back()].empty()) column = sum(column, by_pivot_[column.back()]);
            if (column.empty()) continue;
            made_by_[column.back()] = j;
            by_pivot_[column.back()] = column;
        }
    }
    std::uint32_t index(const Simplex& s) const { return index_.at(s); }
    Column boundary(const Column& chain) const {
        Column total;
        for (const std::uint32_t j : chain) {
            const Simplex& s = f_.simplices[j];
            Column faces;
            for (std::size_t i = 0; i < s.size() && s.size() > 1; ++i) {
                Simplex face = s;
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
                faces.push_back(index_.at(face));
            }
            std::sort(faces.begin(), faces.end());
            total = sum(total, faces);
        }
        return total;
    }
    // The value from which on the chain is a boundary; infinity if never.
    double death(Column chain) const {
        double latest = -std::numeric_limits<double>::infinity();
        while (!chain.empty()) {
            const Column& column = by_pivot_[chain.back()];
            if (column.empty()) return std::numeric_limits<double>::infinity();
            latest = std::max(latest, f_.values[made_by_[chain.back()]]);
            chain = sum(chain, column);
        }
        return latest;
    }

private:
    const Filtered& f_;
    std::map<Simplex, std::uint32_t> index_;
    std::vector<Column> by_pivot_;
    std::vector<std::uint32_t> made_by_;
};

}  // namespace oracle
