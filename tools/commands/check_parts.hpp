// The parts of `check`: a mesh from its files, a diagram from points or mesh.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tools/io/cycle_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/provenance.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/report/report.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

// The filters on meshes, with their values, that vertex values may be of, as far as --filter, --values and --k leave
// them open.
std::vector<FilterChoice> candidates(const Options& options);

Outcome mismatch(const std::string& what);  // Exit::check

// The mesh of the files, with its cages, taken over by the engine.
netmesh_status load_mesh(Session& session, const MeshFiles& files);

// Before a mesh of files is loaded: markers, inputs first, and as the promise of the session what it promises, by the
// options and, where they say nothing, the file.
Outcome settle_mesh(const Options& options, MeshFiles* files, Session* session);

// The values of --values-at, of the vertices of this mesh, into options->vertex_function; nothing without the option.
Outcome read_values_at(const NodeFile& node, Options* options);

// Everything that can be said about a mesh: all checkers of the engine, the .neigh file, the inputs (--points). What
// holds goes to run->checked, what the engine measured to run->engine; the mesh stays in the session.
Outcome check_mesh(const Options& options, MeshFiles& files, RunReport* run, Session& session);
// Whether the vertices' values, where the file has some, are those of a filter on the mesh that the session holds.
// Replaces the diagram.
Outcome check_vertex_values(const Options& options, const MeshFiles& files, RunReport* run, Session& session);

// A diagram's file as it was read.
struct DiagramFile {
    std::string name;
    std::vector<Bar> bars;
    std::vector<std::uint64_t> lines;  // of the bars
    std::vector<BoundLine> bounds;
    std::optional<Provenance> head;

    std::uint64_t line_of(std::size_t bar) const {
        return bar < lines.size() ? lines[bar] : lines.empty() ? 1 : lines.back();
    }
    Outcome wrong(std::uint64_t line, const std::string& why) const {  // Exit::check
        return line_error(name, line, "check failed: " + why, 0, Exit::check);
    }
};

struct RipsInput;

struct DiagramClaim {
    const DiagramFile& file;
    const Options& made;             // settled
    const std::string& cycles_path;  // empty: no cycles
    bool is_proven = false;          // by the proof beside it
};

// The cycles that a claim comes with, which there are: one for each of its bars, or what is wrong.
Outcome read_cycles(const DiagramClaim& claim, std::vector<CycleEntry>* cycles);
// Cycle `at` of these is refused: its bar and why.
Outcome cycle_refused(const DiagramClaim& claim, const std::vector<CycleEntry>& cycles, std::size_t at,
                      const std::string& why);

// The cycles of the claim, if it comes with some, are born with their bars and die with them in this complex.
Outcome judge_cycles(const DiagramClaim& claim, const FilteredComplex& complex, std::vector<std::string>* checked);
// The bars of an alpha diagram are those of the alpha complex of these vertices, to the last bit, and the cells are
// their Delaunay triangulation; `whose` it is, for messages. *is_too_large: nothing was looked at.
Outcome judge_alpha(const DiagramClaim& claim, const MeshFiles& files, const std::string& whose, bool* is_too_large,
                    std::vector<std::string>* checked);

// The same computed by other code than the engine's (tools/opinion): on a mesh the filter's values, its certified ratio
// and the ratios by scale from the Voronoi cells, the pairs by a plain reduction, and each cycle's birth and death. Of
// exact diagrams (alpha, rips, cech, barycentric) every bar, to the last bit, in exact arithmetic: of few points by
// brute force, of alpha of more points by the triangulation that the engine makes, which is checked; of yet more points
// degree 0 alone, or a sample of it. What was found to hold, and what was not looked at, goes to run->checked.
Outcome second_opinion_on_mesh(const DiagramClaim& claim, const MeshFiles& files, RunReport* run);
Outcome second_opinion_on_points(const DiagramClaim& claim, const PointCloud& points, RunReport* run);

// The proof of an alpha, Rips or Cech diagram of this input, where there is one beside it or --proof names one: what
// its verifier, netmesh-verify or netmesh-verify-rips, says of it goes to run->checked and claim->is_proven; what it
// refuses is Exit::check. That there is none, or that the program cannot be run, is said, too; the latter on stderr as
// well, and where --proof was given it is Exit::data.
Outcome verify_proof(const PointCloud& points, DiagramClaim* claim, RunReport* run);
Outcome verify_proof(const RipsInput& input, DiagramClaim* claim, RunReport* run);

// The same for a complex that was listed, or is too large for that.
Outcome second_opinion_on_complex(const DiagramClaim& claim, const SimplexList& simplices, RunReport* run);

// Of a diagram that is joined of scales: bars, what is certified, and cycles of points against the exact diagram.
Outcome second_opinion_on_scales(const DiagramClaim& claim, const PointCloud& points, RunReport* run);

// The diagram of the positional argument: its form; and, where its head or the options say how it was made, the same
// run of the engine again from --points, or from --mesh with a second opinion by other code.
Outcome check_diagram(const Options& options, RunReport* run);

// The vineyard of the positional argument, likewise.
Outcome check_vines(const Options& options, RunReport* run);

}  // namespace netmesh::tool
