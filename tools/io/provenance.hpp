// How a diagram was made and what is certified of it: the comments at the head of a .pers file. Behind the first one,
// `# netmesh diagram 1: degree birth death`, each is `# NAME VALUE`, and up to the first bar no others but `# scale`
// are allowed. They come in this order; what does not apply is left out.
//
//   of the file         version
//   options of persist  filter distances sparse threshold radii weights squares box cell k values function values-at
//                       lipschitz cut error method finish tau fit memory ratio whole-cells focus from to eps theta
//                       max-degree all bounds seed
//   of the input        dim points duplicates, input or mesh, copies moved; of distances points and input
//   of the result       domain certified-ratio certified-from certified-error fitted-error reference
//
// Options are what decides the bars, each with the value that was used, given or not: `netmesh persist POINTS` with all
// of them, but tau where there is a ratio, makes the same file. `input` is the fingerprint of the coordinates, or of
// the distances, as in JSON; `values-at`, in place of the file's name, and `mesh`, in place of `input`, those of the
// values at the vertices of a mesh and of the vertices' coordinates; `domain` centre and radius of the ball that was
// meshed; `reference` the function that the ratio is about, from the scale `certified-from` on; `certified-error`, of
// the filter function, how far births and deaths are off at most, with --fit `fitted-error` the error that sizes of the
// mesh were asked for, 0 for none. Of points that repeat `cell` has the vectors, as `--cell file` and angles stand for,
// `copies` how many points were triangulated beside those given, `moved` by how much numbers were moved at most, where
// they were.
//
// Up to version 0.2.0 births and deaths of alpha and of filters on points were not rounded to nearest, and said in
// `value-error` by how much they were off. Such files are not read as diagrams of this program.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.h"
#include "tools/io/text_writer.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// `# name value`, on physical line `number` where it was read; `# name` for a switch.
struct HeadLine {
    std::string name, value;
    std::uint64_t number = 0;
};
using Head = std::vector<HeadLine>;

// "tau 3"
std::string head_text(const HeadLine& line);

// The settled options of persist as a head says them: beside a ratio from which it does not follow tau is what it is by
// default.
Options said_by_head(const Options& options, std::uint32_t dim);

// The whole head of the diagram that `report` is about, made with `options`.
Head head_of(const Options& options, const netmesh_report& report);
void write_head(const Head& head, TextWriter& out);

// The line of that name, or null.
const HeadLine* find_line(const Head& head, std::string_view name);
// The lines of a file's head as they stand, judged by nobody; none where there is no head.
Head head_lines(std::string_view content);

// A head that was read.
struct Provenance {
    Options options;  // of persist; where a ratio does not follow from tau, that is left out
    double tau = 0;   // of its line; 0: there is none
    Head lines;       // all of them
    const HeadLine* find(std::string_view name) const;
};

// Leaves *provenance empty where the file has no head. Exit::data with file and line for a line that is unknown,
// unreadable, missing, there twice, or contradicted by another one; for a version that is none, or later than this
// program; and for `value-error`.
Outcome parse_head(std::string_view content, const std::string& file, std::optional<Provenance>* provenance);

// Exit::usage when an option of a command line says something else than the file does.
Outcome check_contradiction(const Provenance& provenance, const std::string& file, const Options& command_line);
// Whether the command line says how a diagram is made.
bool says_how(const Options& command_line);

}  // namespace netmesh::tool
