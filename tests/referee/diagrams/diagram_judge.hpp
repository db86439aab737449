// What a diagram's file promises, against the truth.
//
//   ratio     `# certified-ratio C`: bars and true bars are matched, births and deaths within the factor C of one
//             another, births and deaths at 0 and at infinity exactly; only bars with death <= C^2 birth are left over.
//             With `# certified-from F` both diagrams begin at F: bars over before are gone, births before are at F.
//   scale     `# scale A low L high H reach S ratio C`, from A on up to the next: a birth or death at a stands for a
//             true one in [min(L, a), max(H, a)] and within the factor C. With c(a) = min(max(H / a, a / L, 1), C)
//             bars with death / c(death) <= birth c(birth) may be left over, and true bars with birth >= a / c(a),
//             death <= a c(a) for some a. A bar that dies after max(S, its birth) is certified to exist.
//   bounds    `# birth A B death C D exists`: the bars that exist belong to different true bars within their bounds;
//             so do all that the scales do not allow to be left over.
//   exact     the true bars, births and deaths rounded to the nearest double, ties to even, as far as they then differ.
//   near      filters on the points themselves: exact where the ratio is 1, else the ratio but for 2^-51.
#pragma once
#include "../verdict.hpp"
#include "diagram_file.hpp"
#include "truth.hpp"

namespace referee {

void judge_ratio(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict);
void judge_scales(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict);
void judge_bounds(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict);
void judge_exact(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict);
void judge_near(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict);

// The least ratio, to 2^-12 of it, for which judge_ratio finds nothing; above `most`: most.
double true_ratio(DiagramFile diagram, const Truth& truth, int top, double most);

// The file against itself and against the report that --json printed: order, bounds around bars, steps that ascend, the
// same numbers in both.
void judge_form(const DiagramFile& diagram, const std::string& json, int top, Verdict* verdict);

}  // namespace referee
