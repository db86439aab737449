// One diagram of one set of points with all that it is judged by.
#pragma once
#include <memory>

#include "../tool.hpp"
#include "cycles.hpp"
#include "diagram_judge.hpp"
#include "ways.hpp"

namespace referee {

// Points with their truths, made when they are first asked for.
class PointSet {
public:
    PointSet(const Points& points, int dim, std::size_t k, std::size_t sets_max);

    int dim() const { return dim_; }
    std::size_t k() const { return k_; }
    const Points& all() const { return all_; }  // as they are handed to the tool
    const Points& different() const { return different_; }
    double width() const { return width_; }
    const Truth& truth(const Way& way) const;

private:
    int dim_;
    std::size_t k_;
    Points all_, different_;
    double width_ = 0;
    mutable std::map<std::pair<Reference, int>, Truth> truths_;
};

// What a run of one way left behind.
struct Made {
    DiagramFile diagram;
    std::string json;  // empty: nothing is known of it
    Mesh mesh;         // where the way has one
    std::vector<Cycle> cycles;
    bool has_cycles = false;
};

// The words of a run that writes trial.pers and what the way has beside it.
std::vector<std::string> words_of(const Way& way, const Tool& tool, const std::string& points, bool small);
// An empty text, or what cannot be read.
std::string read_made(const Way& way, const Tool& tool, const std::string& json, bool small, Made* made);

// All promises of what was made. `fingerprint` is the line `# input` of another run on these points, or empty;
// `simplices` the size of a mesh above which its pairs and cycles are not looked at.
Verdict judge_made(const PointSet& set, const Way& way, const Made& made, const std::string& fingerprint,
                   std::size_t simplices);

}  // namespace referee
