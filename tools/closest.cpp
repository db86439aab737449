#include "tools/closest.hpp"

#include <algorithm>
#include <cstdint>

namespace netmesh::tool {

std::size_t edits_between(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); j++) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); i++) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); j++) {
            const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = last;
        last = row;
    }
    return last[b.size()];
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), given) != names.end()) return {};
    const std::string* found = nullptr;
    std::size_t begun = 0, fewest = SIZE_MAX;
    for (const std::string& name : names) {
        if (given.size() < 2 || name.compare(0, given.size(), given) != 0) continue;
        if (begun++ == 0) found = &name;
    }
    if (begun != 1) {
        found = nullptr;
        for (const std::string& name : names) {
            const std::size_t edits = edits_between(given, name);
            if (3 * edits > std::max<std::size_t>(3, name.size()) || edits >= fewest || edits >= name.size()) continue;
            fewest = edits;
            found = &name;
        }
    }
    return found == nullptr ? "" : "; did you mean " + *found + "?";
}

}  // namespace netmesh::tool
