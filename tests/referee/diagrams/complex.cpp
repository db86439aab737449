#include "complex.hpp"

#include <algorithm>
#include <iterator>

namespace referee {

void add_chain(Complex::Chain* sum, const Complex::Chain& other) {
    Complex::Chain merged;
    std::set_symmetric_difference(sum->begin(), sum->end(), other.begin(), other.end(), std::back_inserter(merged));
    sum->swap(merged);
}

std::uint32_t Complex::position(const Simplex& simplex) const {
    const auto found = positions_.find(simplex);
    return found == positions_.end() ? never : found->second;
}

Complex::Chain Complex::boundary(std::uint32_t position) const {
    Chain faces;
    const Simplex& whole = simplex(position);
    for (std::size_t i = 0; whole.size() > 1 && i < whole.size(); i++) {
        Simplex face = whole;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
        faces.push_back(this->position(face));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

void Complex::reduce() {
    order_.clear();
    for (const auto& entry : given_) order_.push_back(&entry.first);
    std::stable_sort(order_.begin(), order_.end(), [&](const Simplex* a, const Simplex* b) {
        const std::uint32_t first = given_.at(*a), second = given_.at(*b);
        return first != second ? first < second : a->size() < b->size();
    });
    const std::uint32_t count = static_cast<std::uint32_t>(order_.size());
    std::size_t top = 0;
    for (std::uint32_t p = 0; p < count; p++) {
        positions_[*order_[p]] = p;
        ranks_.push_back(given_.at(*order_[p]));
        top = std::max(top, order_[p]->size());
    }
    owner_.assign(count, never);
    columns_.assign(count, {});
    std::vector<char> is_negative(count, 0);
    // A pivot's own column is zero: higher dimensions first, it need not be looked at.
    for (std::size_t size = top; size > 1; size--)
        for (std::uint32_t p = 0; p < count; p++) {
            if (order_[p]->size() != size || owner_[p] != never) continue;
            Chain column = boundary(p);
            while (!column.empty() && owner_[column.back()] != never)
                add_chain(&column, columns_[owner_[column.back()]]);
            if (column.empty()) continue;
            owner_[column.back()] = p;
            is_negative[p] = 1;
            columns_[p] = column;
        }
    pairs_.clear();
    for (std::uint32_t p = 0; p < count; p++)
        if (is_negative[p] == 0) pairs_.push_back({p, owner_[p]});
}

std::uint32_t Complex::death_of(Chain cycle) const {
    std::uint32_t last = 0;
    while (!cycle.empty()) {
        const std::uint32_t column = owner_[cycle.back()];
        if (column == never) return never;
        last = std::max(last, column);
        add_chain(&cycle, columns_[column]);
    }
    return last;
}

}  // namespace referee
