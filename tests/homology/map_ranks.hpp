// Ranks of the maps that an inclusion of filtered complexes induces in homology, by linear algebra on whole chain
// spaces: dim (Z(part at a) + B(whole at b)) - dim B(whole at b). Shares nothing with the engine.
#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

namespace oracle {

struct PartSimplex {
    std::vector<std::uint32_t> vertices;  // sorted
    double value;
    bool in_part;
};

// Vectors over Z/2, one after the other: which of them do not depend on those before.
class Span {
public:
    using Vector = std::vector<std::uint64_t>;
    explicit Span(std::size_t size) : by_leader_(size) {}
    bool add(Vector v) {
        for (std::size_t i = 0; i < by_leader_.size(); ++i) {
            if ((v[i / 64] >> (i % 64) & 1) == 0) continue;
            if (by_leader_[i].empty()) {
                by_leader_[i] = v;
                ++rank_;
                return true;
            }
            for (std::size_t w = 0; w < v.size(); ++w) v[w] ^= by_leader_[i][w];
        }
        return false;
    }
    int rank() const { return rank_; }

private:
    std::vector<Vector> by_leader_;
    int rank_ = 0;
};

// [a][b], a <= b: rank of H_p(part at scales[a]) -> H_p(whole at scales[b]). Scales ascend.
inline std::vector<std::vector<int>> map_ranks(const std::vector<PartSimplex>& all, std::uint32_t p,
                                               const std::vector<double>& scales) {
    std::vector<const PartSimplex*> of[3];  // of dimensions p - 1, p, p + 1
    for (const PartSimplex& s : all) {
        const std::size_t at = s.vertices.size() - p;  // p vertices: dimension p - 1
        if (s.vertices.size() >= std::max(p, 1u) && at <= 2) of[at].push_back(&s);
    }
    for (auto& list : of)
        std::sort(list.begin(), list.end(),
                  [](const PartSimplex* x, const PartSimplex* y) { return x->value < y->value; });
    std::map<std::vector<std::uint32_t>, std::size_t> place[2];
    for (const int i : {0, 1})
        for (std::size_t s = 0; s < of[i].size(); ++s) place[i][of[i][s]->vertices] = s;
    const auto boundary = [&](const PartSimplex& s, int faces, std::size_t words) {
        Span::Vector v(words);
        for (std::size_t i = 0; i < s.vertices.size() && s.vertices.size() > 1; ++i) {
            std::vector<std::uint32_t> face = s.vertices;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
            const std::size_t at = place[faces].at(face);
            v[at / 64] ^= std::uint64_t{1} << (at % 64);
        }
        return v;
    };
    // Cycles of the part: boundaries with the chains that they are of behind them; what becomes zero in front is one.
    const std::size_t chains = of[1].size(), words = chains / 64 + 1, faces = of[0].size(), front = faces / 64 + 1;
    std::vector<std::pair<double, Span::Vector>> cycles;
    std::vector<Span::Vector> leader(faces);
    for (std::size_t s = 0; s < chains; ++s) {
        if (!of[1][s]->in_part) continue;
        Span::Vector v = p == 0 ? Span::Vector(front) : boundary(*of[1][s], 0, front);
        v.resize(front + words);
        v[front + s / 64] |= std::uint64_t{1} << (s % 64);
        bool zero = true;
        for (std::size_t i = 0; i < faces && zero; ++i) {
            if ((v[i / 64] >> (i % 64) & 1) == 0) continue;
            if (leader[i].empty()) {
                leader[i] = v;
                zero = false;
            } else {
                for (std::size_t w = 0; w < v.size(); ++w) v[w] ^= leader[i][w];
            }
        }
        if (zero)
            cycles.push_back({of[1][s]->value, Span::Vector(v.begin() + static_cast<std::ptrdiff_t>(front), v.end())});
    }
    std::vector<std::vector<int>> ranks(scales.size(), std::vector<int>(scales.size()));
    Span boundaries(chains);
    std::size_t next = 0;
    for (std::size_t b = 0; b < scales.size(); ++b) {
        for (; next < of[2].size() && of[2][next]->value <= scales[b]; ++next)
            boundaries.add(boundary(*of[2][next], 1, words));
        Span both = boundaries;
        std::size_t cycle = 0;
        for (std::size_t a = 0; a <= b; ++a) {
            for (; cycle < cycles.size() && cycles[cycle].first <= scales[a]; ++cycle) both.add(cycles[cycle].second);
            ranks[a][b] = both.rank() - boundaries.rank();
        }
    }
    return ranks;
}

}  // namespace oracle
