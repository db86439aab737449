// Ways to call `persist`, with what their files have to say and what they are compared with.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "../families.hpp"

namespace referee {

enum class Reference { offsets, kth, k_distance, rips };

enum class Promise {
    by_ratio,  // the certified ratio, and with --bounds scales and bounds
    exact,     // alpha
    near       // filters on the points themselves: exact, or with a ratio above 1 that but for a unit in the last place
};

struct Way {
    std::string name;
    std::vector<std::string> arguments;                     // behind `persist POINTS`
    std::vector<std::pair<std::string, std::string>> says;  // lines of the head
    Reference reference = Reference::offsets;
    Promise promise = Promise::by_ratio;
    std::size_t k = 1;
    double ratio_most = 0;      // the documented bound of the certified ratio; 0: none
    int top = 0;                // highest degree
    bool has_mesh = false;      // --mesh writes the complex that was filtered
    bool inputs_first = false;  // inputs enter it at 0
    bool has_cycles = false;
    bool over_refines = false;  // tight, scales: many vertices, and coordinates that resolve them are asked for
};

// The ways for points of that width; k neighbours where k are counted.
std::vector<Way> ways_to_persist(int dim, std::size_t k, double width, Random& random);

}  // namespace referee
