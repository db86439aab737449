#include "matching.hpp"

#include <algorithm>

namespace referee {
namespace {

constexpr std::uint32_t nobody = UINT32_MAX;

// Shortest augmenting paths in layers, after Hopcroft and Karp.
class Matching {
public:
    Matching(const Choices& choices, std::size_t right_count)
        : choices_(choices), partner_(choices.size(), nobody), owner_(right_count, nobody) {}

    // Paths from free ones of `sources`; a path that ends at a free one on the right keeps all that were matched.
    void grow(const std::vector<char>& sources) {
        while (lay(sources)) {
            next_.assign(choices_.size(), 0);
            for (std::uint32_t a = 0; a < choices_.size(); a++)
                if (sources[a] != 0 && partner_[a] == nobody) follow(a);
        }
    }
    bool has(std::size_t a) const { return partner_[a] != nobody; }

private:
    bool lay(const std::vector<char>& sources) {
        layer_.assign(choices_.size(), nobody);
        std::vector<std::uint32_t> queue;
        for (std::uint32_t a = 0; a < choices_.size(); a++)
            if (sources[a] != 0 && partner_[a] == nobody) {
                layer_[a] = 0;
                queue.push_back(a);
            }
        bool reaches_free = false;
        for (std::size_t i = 0; i < queue.size(); i++)
            for (const std::uint32_t b : choices_[queue[i]]) {
                if (owner_[b] == nobody) {
                    reaches_free = true;
                } else if (layer_[owner_[b]] == nobody) {
                    layer_[owner_[b]] = layer_[queue[i]] + 1;
                    queue.push_back(owner_[b]);
                }
            }
        return reaches_free;
    }

    bool follow(std::uint32_t a) {
        while (next_[a] < choices_[a].size()) {
            const std::uint32_t b = choices_[a][next_[a]++];
            if (owner_[b] == nobody || (layer_[owner_[b]] == layer_[a] + 1 && follow(owner_[b]))) {
                partner_[a] = b;
                owner_[b] = a;
                return true;
            }
        }
        return false;
    }

    const Choices& choices_;
    std::vector<std::uint32_t> partner_, owner_, layer_;
    std::vector<std::size_t> next_;
};

}  // namespace

bool can_match(const Choices& choices, std::size_t right_count, const std::vector<char>& must, std::size_t* missing) {
    Matching matching(choices, right_count);
    matching.grow(must);
    for (std::size_t a = 0; a < choices.size(); a++)
        if (must[a] != 0 && !matching.has(a)) {
            *missing = a;
            return false;
        }
    return true;
}

bool can_match_both(const Choices& choices, const std::vector<char>& left, const std::vector<char>& right,
                    std::size_t* missing, bool* is_left) {
    *is_left = true;
    if (!can_match(choices, right.size(), left, missing)) return false;
    Choices reversed(right.size());
    for (std::uint32_t a = 0; a < choices.size(); a++)
        for (const std::uint32_t b : choices[a]) reversed[b].push_back(a);
    *is_left = false;
    return can_match(reversed, left.size(), right, missing);
}

}  // namespace referee
