// The other definition of truth.hpp: the nerve of the balls of all copies, up to a value where no ball's cell counts.
// What it shares with the first one is the reduction and the reading of doubles.
#pragma once
#include <cmath>
#include <optional>

#include "truth.hpp"

namespace periods {

class Balls {
public:
    // Sets that are there at `most`; not more than count_max of them.
    Balls(const Cloud& cloud, const mpq_class& most, std::size_t count_max)
        : scene_(cloud), most_(most), count_max_(count_max) {}

    // False: there are more.
    bool find() {
        for (std::size_t i = 0; i < scene_.point.size(); ++i) {
            const Simplex one{Copy{static_cast<int>(i)}};
            const mpq_class value = scene_.value(-scene_.weight[i]);
            if (value > most_) continue;
            values_[one] = value;
            later_[one.front()] = later_copies(i);
        }
        for (std::size_t size = 1; size < scene_.dim + 2; ++size)
            if (!enlarge(size)) return false;
        return true;
    }
    const Values& values() const { return values_; }

private:
    // Copies after point i itself whose balls meet its own at the last value.
    std::vector<Copy> later_copies(std::size_t i) const {
        const std::size_t m = scene_.basis.size();
        double radius = 0;  // the largest, in units
        for (const mpz_class& w : scene_.weight) {
            const mpq_class unit = scene_.value(1);
            const mpq_class square = most_ / unit + w;
            if (square > 0) radius = std::max(radius, std::sqrt(square.get_d()));
        }
        std::vector<Copy> list;
        for (std::size_t other = i; other < scene_.point.size(); ++other) {
            const Vector from = sum_of(scene_.point[other], scene_.point[i], -1);
            Row reach;  // |k_j + t_j| <= |v| |dual vector j|
            for (std::size_t j = 0; j < m; ++j)
                reach.emplace_back(2 * radius * std::sqrt(scene_.inverse[j][j].get_d()) * 1.001 + 0.001);
            Vector least, last;
            scene_.range(from, reach, &least, &last);
            for_each_between(least, last, [&](const Vector& k) {
                Copy copy{static_cast<int>(other)};
                for (std::size_t j = 0; j < m; ++j) copy[j + 1] = static_cast<int>(k[j].get_si());
                const Copy own{static_cast<int>(i)};
                if (!(own < copy)) return;
                const std::optional<mpq_class> value = own_value({own, copy});
                if (!value || *value <= most_) list.push_back(copy);
            });
        }
        return list;
    }
    bool enlarge(std::size_t size) {
        std::vector<const Simplex*> before;
        for (const auto& entry : values_)
            if (entry.first.size() == size) before.push_back(&entry.first);
        for (const Simplex* const simplex : before)
            for (const Copy& copy : later_[simplex->front()]) {
                if (!(simplex->back() < copy)) continue;
                Simplex more = *simplex;
                more.push_back(copy);
                mpq_class value;
                if (!largest_of_facets(more, &value)) continue;
                if (more.size() <= scene_.dim + 1) {
                    const std::optional<mpq_class> own = own_value(more);
                    if (own && *own > value) value = *own;
                }
                if (value > most_) continue;
                values_[more] = value;
                if (values_.size() > count_max_) return false;
            }
        return true;
    }
    bool largest_of_facets(const Simplex& simplex, mpq_class* value) const {
        for (std::size_t i = 0; i < simplex.size(); ++i) {
            Simplex facet = simplex;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            settle(&facet);
            const Values::const_iterator found = values_.find(facet);
            if (found == values_.end()) return false;
            if (i == 0 || found->second > *value) *value = found->second;
        }
        return true;
    }
    // The power at the orthogonal centre, if the copies are independent and the centre is in their convex hull.
    std::optional<mpq_class> own_value(const Simplex& simplex) const {
        const Vector origin = scene_.place(simplex.front());
        const auto weight = [&](std::size_t i) { return scene_.weight[static_cast<std::size_t>(simplex[i][0])]; };
        const std::size_t k = simplex.size() - 1;
        std::vector<Vector> edge;
        for (std::size_t i = 0; i < k; ++i) edge.push_back(sum_of(scene_.place(simplex[i + 1]), origin, -1));
        std::vector<Row> a(k, Row(k + 1));
        for (std::size_t i = 0; i < k; ++i) {
            for (std::size_t j = 0; j < k; ++j) a[i][j] = dot(edge[i], edge[j]);
            a[i][k] = (a[i][i] + weight(0) - weight(i + 1)) / 2;
        }
        if (!eliminate(&a)) return std::nullopt;
        mpq_class rest = 1, power = -weight(0);
        Row centre(scene_.dim);
        for (std::size_t i = 0; i < k; ++i) {
            if (a[i][k] < 0) return std::nullopt;
            rest -= a[i][k];
            for (std::size_t c = 0; c < scene_.dim; ++c) centre[c] += a[i][k] * edge[i][c];
        }
        if (rest < 0) return std::nullopt;
        for (const mpq_class& c : centre) power += c * c;
        return scene_.value(power);
    }

    const Scene scene_;
    const mpq_class most_;
    const std::size_t count_max_;
    Values values_;
    std::map<Copy, std::vector<Copy>> later_;
};

}  // namespace periods
