#include "tools/opinion/bar_matching.hpp"

#include <cmath>

namespace netmesh::tool {

bool BarBox::holds(const Bar& bar) const {
    return bar.degree == degree && birth_low <= bar.birth && bar.birth <= birth_high && death_low <= bar.death &&
           bar.death <= death_high;
}

BarBox box_of(const Bar& bar, double ratio) {
    return {bar.degree, bar.birth / ratio, bar.birth * ratio, bar.death / ratio, bar.death * ratio};
}

bool can_place(const std::vector<BarBox>& boxes, const std::vector<Bar>& truth, std::size_t* at) {
    const std::size_t nobody = boxes.size();
    std::vector<std::size_t> owner(truth.size(), nobody), has(boxes.size(), truth.size());
    for (std::size_t start = 0; start < boxes.size(); start++) {
        // Who would give up which bar to whom, breadth first.
        std::vector<std::size_t> waiting = {start}, asked_by(truth.size(), nobody);
        std::size_t end = truth.size();
        for (std::size_t q = 0; q < waiting.size() && end == truth.size(); q++) {
            for (std::size_t j = 0; j < truth.size(); j++) {
                if (asked_by[j] != nobody || !boxes[waiting[q]].holds(truth[j])) continue;
                asked_by[j] = waiting[q];
                if (owner[j] == nobody) {
                    end = j;
                    break;
                }
                waiting.push_back(owner[j]);
            }
        }
        if (end == truth.size()) {
            *at = start;
            return false;
        }
        while (true) {
            const std::size_t box = asked_by[end], before = has[box];
            owner[end] = box;
            has[box] = end;
            if (box == start) break;
            end = before;
        }
    }
    return true;
}

}  // namespace netmesh::tool
