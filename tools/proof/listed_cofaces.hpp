// A complex that is listed, for proofs. A simplex's key is its place among those of its dimension, by value and then by
// line.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "tools/io/complex_file.hpp"

namespace netmesh::tool {

class ListedCofaces {
public:
    using Key = std::uint64_t;
    static constexpr Key no_key = ~Key{0};
    // There are sums of simplices of any dimension, as heaps.
    struct Matrix {
        explicit Matrix(const ListedCofaces&) {}
        std::size_t many() const { return SIZE_MAX; }
        void open() {}
        void toggle(Key) {}
        Key first(Key) const { return no_key; }
        void list(std::vector<Key>*) const {}
    };

    // Of a file that lists a complex.
    explicit ListedCofaces(const SimplexFile& file);

    std::uint32_t dimension() const { return static_cast<std::uint32_t>(levels_.size() - 1); }
    std::uint32_t count(std::uint32_t p) const { return p < levels_.size() ? levels_[p].count : 0; }
    // The facets of a p-simplex, p + 1 keys.
    const std::uint32_t* facets(Key key, std::uint32_t p) const { return &levels_[p].facets[key * (p + 1)]; }
    template <class F> void each_column(std::uint32_t p, F f) const {
        for (std::uint32_t key = count(p); key-- > 0;) {
            const Key first = first_coface(key, p);
            if (p > 1 && shortcut_facet(key, p) != no_key) continue;
            if (first == no_key || last_facet(first, p + 1) != key) f(Key{key});
        }
    }
    template <class F> void each_coface(Key key, std::uint32_t p, F f) const {
        const Level& level = levels_[p];
        for (std::size_t i = level.begin[key]; i < level.begin[key + 1]; i++) f(Key{level.cofaces[i]});
    }
    Key shortcut_facet(Key key, std::uint32_t q) const {
        const Key facet = last_facet(key, q);
        return first_coface(facet, q - 1) == key ? facet : no_key;
    }

private:
    struct Level {
        std::uint32_t count = 0;
        std::vector<std::uint32_t> facets, cofaces;  // cofaces ascending
        std::vector<std::size_t> begin;              // [count + 1], of cofaces
    };
    Key first_coface(Key key, std::uint32_t p) const {
        const Level& level = levels_[p];
        return level.begin[key] < level.begin[key + 1] ? level.cofaces[level.begin[key]] : no_key;
    }
    Key last_facet(Key key, std::uint32_t p) const { return *std::max_element(facets(key, p), facets(key, p) + p + 1); }

    std::vector<Level> levels_;
};

}  // namespace netmesh::tool
