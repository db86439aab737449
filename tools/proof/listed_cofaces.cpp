#include "tools/proof/listed_cofaces.hpp"

#include <numeric>

namespace netmesh::tool {

namespace {

using Row = std::vector<std::uint32_t>;  // vertices, ascending

Row row_of(const SimplexFile& file, std::size_t i) {
    Row row(file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i]),
            file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i + 1]));
    std::sort(row.begin(), row.end());
    return row;
}

}  // namespace

ListedCofaces::ListedCofaces(const SimplexFile& file) {
    std::vector<std::vector<std::size_t>> lines;  // of each dimension, in the order of keys
    for (std::size_t i = 0; i < file.count(); i++) {
        const std::size_t p = file.starts[i + 1] - file.starts[i] - 1;
        if (p >= lines.size()) lines.resize(p + 1);
        lines[p].push_back(i);
    }
    levels_.resize(lines.size());
    std::vector<std::pair<Row, std::uint32_t>> below;  // those of one dimension less, by vertices, with their keys
    for (std::uint32_t p = 0; p < lines.size(); p++) {
        std::stable_sort(lines[p].begin(), lines[p].end(),
                         [&](std::size_t a, std::size_t b) { return file.values[a] < file.values[b]; });
        Level& level = levels_[p];
        level.count = static_cast<std::uint32_t>(lines[p].size());
        std::vector<std::pair<Row, std::uint32_t>> rows;
        for (std::uint32_t key = 0; key < level.count; key++) {
            rows.emplace_back(row_of(file, lines[p][key]), key);
            for (std::uint32_t left_out = 0; left_out <= p && p > 0; left_out++) {
                Row facet = rows.back().first;
                facet.erase(facet.begin() + left_out);
                const auto at = std::lower_bound(below.begin(), below.end(), std::make_pair(facet, std::uint32_t{0}));
                level.facets.push_back(at->second);
            }
        }
        std::sort(rows.begin(), rows.end());
        below = std::move(rows);
    }
    for (std::size_t p = 0; p < levels_.size(); p++) {
        Level& level = levels_[p];
        level.begin.assign(level.count + std::size_t{1}, 0);
        if (p + 1 == levels_.size()) break;
        const std::vector<std::uint32_t>& facets = levels_[p + 1].facets;
        for (const std::uint32_t facet : facets) level.begin[facet]++;
        std::partial_sum(level.begin.begin(), level.begin.end(), level.begin.begin());
        level.cofaces.resize(facets.size());
        for (std::size_t i = facets.size(); i-- > 0;)
            level.cofaces[--level.begin[facets[i]]] = static_cast<std::uint32_t>(i / (p + 2));
    }
}

}  // namespace netmesh::tool
