// check: the proof beside a diagram, verified by netmesh-verify or netmesh-verify-rips, programs of their own. See
// decisions/proofs.md.
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "platform/folders.hpp"
#include "platform/interrupt.hpp"
#include "platform/program.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/rips_input.hpp"
#include "tools/io/npy_writer.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr int not_started = 127;  // of a program whose libraries are missing

// The input as this tool reads it, in a folder that goes away: for files that the verifier does not read.
class HandedOver {
public:
    ~HandedOver() {
        if (!folder_.empty()) platform::remove_folder(folder_);
        platform::forget(removal_);
    }
    Outcome write(const std::string& name, const std::function<void(TextWriter&)>& write) {
        std::string why;
        folder_ = platform::temporary_folder(&why);
        if (folder_.empty()) return data_error("netmesh: " + why);
        path_ = folder_ + "/" + name;
        removal_ = platform::remove_when_killed(path_.c_str());
        return write_files({{path_, write}});
    }
    const std::string& path() const { return path_; }

private:
    std::string folder_, path_;
    int removal_ = -1;
};

// As .npy, for netmesh-verify. weights: the column that has them, if it is a number of one of these.
void write_points(const PointCloud& points, const std::string& weights, TextWriter& out) {
    const std::uint32_t width = points.dim + (points.weights.empty() ? 0 : 1);
    std::uint64_t column = 0;
    if (!parse_unsigned(weights, &column) || column == 0 || column > width) column = width;
    write_npy_head(points.rows(), width, out);
    for (std::size_t row = 0; row < points.rows(); row++) {
        const double* x = &points.coordinates[row * points.dim];
        for (std::uint32_t c = 1; c <= width; c++)
            write_npy_double(!points.weights.empty() && c == column ? points.weights[row] : *x++, out);
    }
}

// As text, for netmesh-verify-rips. Points of which equal ones were merged are as many again.
void write_rips_points(const PointCloud& points, std::uint64_t rows, TextWriter& out) {
    for (std::uint64_t row = 0; row < rows; row++) {
        const double* const x = &points.coordinates[row < points.rows() ? row * points.dim : 0];
        for (std::uint32_t c = 0; c < points.dim; c++) out << x[c] << (c + 1 < points.dim ? ' ' : '\n');
    }
}

// As text. A triangle has its diagonal, so that it cannot be taken for one that has.
void write_distances(const DistanceFile& file, TextWriter& out) {
    for (const netmesh_distance_entry& e : file.entries) out << e.i << ' ' << e.j << ' ' << e.distance << '\n';
    const bool is_full = file.layout == NETMESH_DISTANCES_FULL;
    for (std::uint64_t i = 0; file.entries.empty() && i < file.points; i++) {
        for (std::uint64_t j = 0; j < (is_full ? file.points : i); j++)
            out << file.numbers[is_full ? i * file.points + j : i * (i - 1) / 2 + j] << ' ';
        out << (is_full ? "\n" : "0\n");
    }
}

// What a verifier came to.
struct Verdict {
    enum { verified, refused, cannot_run } is = cannot_run;
    std::string why;
};

std::string first_line(const std::string& text, const std::string& verifier) {
    const std::string line = text.substr(0, text.find('\n'));
    const std::string own = verifier + ": ";
    return line.compare(0, own.size(), own) == 0 ? line.substr(own.size()) : line;
}

// Of input, diagram and proof.
Outcome run_verifier(const std::string& verifier, const std::string& program, const std::vector<std::string>& files,
                     Verdict* verdict) {
    platform::ProgramEnd end;
    std::vector<std::string> words = {program};
    words.insert(words.end(), files.begin(), files.end());
    if (!platform::run_program(words, &end, &verdict->why))
        return platform::interrupted() ? Outcome{Exit::cancelled, "netmesh: cancelled"} : Outcome{};
    verdict->why = first_line(end.err, verifier);
    if (end.code == not_started) return {};
    const bool says_so = end.out.compare(0, 8, "verified") == 0;
    verdict->is = end.code == 0 && says_so ? Verdict::verified : Verdict::refused;
    if (verdict->is == Verdict::refused && verdict->why.empty()) verdict->why = verifier + " did not end as it should";
    return {};
}

// What of the table are points, which verifiers take whole.
bool chooses(const TableOptions& table) {
    return !table.columns.empty() || table.delimiter != 0 || table.skip > 0 || table.drop_missing;
}

bool is_there(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

// An input that a verifier takes as it stands, or as `write` writes it.
struct ProofInput {
    const char *verifier, *what;  // the program's name; points or distances
    std::string name;
    bool is_plain;
    const char* file;  // that it is written to
    std::function<void(TextWriter&)> write;
};

Outcome verify(const ProofInput& input, DiagramClaim* claim, RunReport* run) {
    const Options& made = claim->made;
    const std::string& diagram = made.positionals[0];
    const std::string verifier = input.verifier;
    const bool is_given = !made.proof_path.empty();
    const std::string proof = is_given ? made.proof_path : diagram.substr(0, diagram.rfind('.')) + ".proof";
    const std::string name = shown_name(proof);
    if (!is_there(proof)) {
        if (is_given) return file_error(name, "no such file, which --proof names");
        run->checked->push_back("no proof beside it: there is no " + name + "; persist --proof writes one");
        return {};
    }
    Verdict verdict;
    std::string whose = input.what + (" in " + input.name);
    const std::string program = platform::find_program(verifier);
    if (program.empty()) {
        verdict.why = "there is no " + verifier +
                      " beside netmesh, nor in a folder of PATH; it is built with GMP: cmake --build build";
    } else {
        // First the file itself, with no part of this tool in between. Other tables are read here.
        Outcome outcome;
        if (input.is_plain) outcome = run_verifier(verifier, program, {made.points_path, diagram, proof}, &verdict);
        if (outcome.good() && (!input.is_plain || verdict.is == Verdict::refused)) {
            HandedOver handed;
            whose = input.what + (" that netmesh reads in " + input.name);
            outcome = handed.write(input.file, input.write);
            if (outcome.good()) outcome = run_verifier(verifier, program, {handed.path(), diagram, proof}, &verdict);
            const std::size_t at = verdict.why.find(handed.path());
            if (at != std::string::npos) verdict.why.replace(at, handed.path().size(), input.name);
        }
        if (!outcome.good()) return outcome;
    }
    if (verdict.is == Verdict::refused) return file_error(name, "check failed: " + verdict.why, Exit::check);
    claim->is_proven = verdict.is == Verdict::verified;
    if (claim->is_proven) {
        run->checked->push_back("proof: by " + name + " every bar is true and there is no other, for the " + whose +
                                "; verified by " + program + ", which shares no code with netmesh");
        return {};
    }
    const std::string said = "not verified, as " + verifier + " cannot be run: " + verdict.why;
    if (is_given) return file_error(name, said);
    tell_warning(name, said);
    run->checked->push_back("no proof verified: " + name + " is " + said);
    return {};
}

constexpr const char* verifier_of_rips = "netmesh-verify-rips";

}  // namespace

Outcome verify_proof(const PointCloud& points, DiagramClaim* claim, RunReport* run) {
    const Options& made = claim->made;
    const netmesh_filter_id filter = filter_of(made);
    const bool is_listed = filter == NETMESH_FILTER_RIPS || filter == NETMESH_FILTER_CECH;
    if (!is_listed && filter != NETMESH_FILTER_ALPHA)
        return made.proof_path.empty() ? Outcome{}
                                       : usage_error("--proof is of filters alpha, rips and cech, not of " +
                                                     std::string(filter_name(filter)));
    const bool is_plain = made.points_path != "-" && !chooses(made.table);
    const auto write = [&](TextWriter& out) {
        is_listed ? write_rips_points(points, points.rows(), out) : write_points(points, made.table.weights, out);
    };
    return verify({is_listed ? verifier_of_rips : "netmesh-verify", "points", points.name, is_plain,
                   is_listed ? "points.txt" : "points.npy", write},
                  claim, run);
}

Outcome verify_proof(const RipsInput& input, DiagramClaim* claim, RunReport* run) {
    const Options& made = claim->made;
    const bool is_plain = made.points_path != "-" && (!input.of_points() || !chooses(made.table));
    const auto write = [&](TextWriter& out) {
        input.of_points() ? write_rips_points(input.cloud, input.rows, out) : write_distances(input.file, out);
    };
    return verify(
        {verifier_of_rips, input.of_points() ? "points" : "distances", input.name(), is_plain, "input.txt", write},
        claim, run);
}

}  // namespace netmesh::tool
