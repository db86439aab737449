// Representatives on their way out, and the check on them.
#pragma once
#include <string>

#include "netmesh.hpp"
#include "tools/io/cycle_file.hpp"
#include "tools/io/points.hpp"
#include "tools/io/text_writer.hpp"
#include "tools/opinion/complexes.hpp"

namespace netmesh::tool {

// `bar DEGREE BIRTH DEATH N` and N lines of vertices for each pair that the engine holds.
void write_cycles(const Engine& engine, TextWriter& out);

// Endings of cycles that say where vertices are.
inline bool needs_places(const std::string& ending) { return ending == ".vtu" || ending == ".obj" || ending == ".svg"; }

// The same by the ending of `path`, of the bars that are chosen: `chosen` may be empty, for all. Places are for .vtu,
// .obj and .svg alone.
void write_cycles(const Engine& engine, const std::string& path, const std::vector<bool>& chosen,
                  const CyclePlaces& places, TextWriter& out);
// The different points in their order, by which cycles of scales and of filters on points go. With periods all rows.
CyclePlaces places_of(const PointCloud& cloud);

// Empty when every cycle has boundary zero (in degree 0: is one vertex, or two of a pair that dies) and enters with its
// pair; and, by a reduction of the complex if there is one, is no boundary before the pair dies and one from then on.
// Otherwise what is wrong. `slack` as of FilteredComplex.
std::string cycles_complaint(const Engine& engine, const SimplexList& complex, double slack);
// What a check of all cycles has found to hold.
std::string cycles_checked(const SimplexList& complex);

// Cycles of points that are certified within a ratio c: each is a cycle of the Cech complex at c times its bar's birth,
// no boundary before death / c and one from c death on; it may be empty where death <= c^2 birth. Without the complex
// nobody looks when they die. Empty, or what is wrong with cycle *at.
std::string point_cycles_complaint(const std::vector<CycleEntry>& cycles, double ratio, const PointCloud& points,
                                   const FilteredComplex* complex, std::size_t* at);

}  // namespace netmesh::tool
