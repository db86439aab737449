// check: the proof beside a diagram, verified by netmesh-verify, a program of its own. See decisions/proofs.md.
#include <unistd.h>

#include <string>
#include <vector>

#include "platform/folders.hpp"
#include "platform/interrupt.hpp"
#include "platform/program.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/npy_writer.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr const char* verifier_name = "netmesh-verify";
constexpr int not_started = 127;  // of a program whose libraries are missing

// The points as this tool reads them, as .npy in a folder that goes away: for tables that netmesh-verify does not read.
class HandedOver {
public:
    ~HandedOver() {
        if (!folder_.empty()) platform::remove_folder(folder_);
        platform::forget(removal_);
    }
    // weights: the column that has them, if it is a number of one of these.
    Outcome write(const PointCloud& points, const std::string& weights) {
        std::string why;
        folder_ = platform::temporary_folder(&why);
        if (folder_.empty()) return data_error("netmesh: " + why);
        path_ = folder_ + "/points.npy";
        removal_ = platform::remove_when_killed(path_.c_str());
        const std::uint32_t width = points.dim + (points.weights.empty() ? 0 : 1);
        std::uint64_t column = 0;
        if (!parse_unsigned(weights, &column) || column == 0 || column > width) column = width;
        const auto write_row = [&](std::size_t row, TextWriter& out) {
            const double* x = &points.coordinates[row * points.dim];
            for (std::uint32_t c = 1; c <= width; c++)
                write_npy_double(!points.weights.empty() && c == column ? points.weights[row] : *x++, out);
        };
        return write_files({{path_, [&](TextWriter& out) {
                                 write_npy_head(points.rows(), width, out);
                                 for (std::size_t row = 0; row < points.rows(); row++) write_row(row, out);
                             }}});
    }
    const std::string& path() const { return path_; }

private:
    std::string folder_, path_;
    int removal_ = -1;
};

// What netmesh-verify came to.
struct Verdict {
    enum { verified, refused, cannot_run } is = cannot_run;
    std::string why;
};

std::string first_line(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    const std::string own = std::string(verifier_name) + ": ";
    return line.compare(0, own.size(), own) == 0 ? line.substr(own.size()) : line;
}

// Of points, diagram and proof.
Outcome run_verifier(const std::string& program, const std::vector<std::string>& files, Verdict* verdict) {
    platform::ProgramEnd end;
    std::vector<std::string> words = {program};
    words.insert(words.end(), files.begin(), files.end());
    if (!platform::run_program(words, &end, &verdict->why))
        return platform::interrupted() ? Outcome{Exit::cancelled, "netmesh: cancelled"} : Outcome{};
    verdict->why = first_line(end.err);
    if (end.code == not_started) return {};
    const bool says_so = end.out.compare(0, 8, "verified") == 0;
    verdict->is = end.code == 0 && says_so ? Verdict::verified : Verdict::refused;
    if (verdict->is == Verdict::refused && verdict->why.empty())
        verdict->why = std::string(verifier_name) + " did not end as it should";
    return {};
}

// What of the table are points, which netmesh-verify takes whole.
bool chooses(const TableOptions& table) {
    return !table.columns.empty() || table.delimiter != 0 || table.skip > 0 || table.drop_missing;
}

bool is_there(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

}  // namespace

Outcome verify_proof(const PointCloud& points, DiagramClaim* claim, RunReport* run) {
    const Options& made = claim->made;
    const std::string& diagram = made.positionals[0];
    const bool is_given = !made.proof_path.empty();
    const std::string proof = is_given ? made.proof_path : diagram.substr(0, diagram.rfind('.')) + ".proof";
    const netmesh_filter_id filter = filter_of(made);
    if (filter != NETMESH_FILTER_ALPHA)
        return is_given ? usage_error("--proof is of filter alpha alone, not of " + std::string(filter_name(filter)))
                        : Outcome{};
    const std::string name = shown_name(proof);
    if (!is_there(proof)) {
        if (is_given) return file_error(name, "no such file, which --proof names");
        run->checked->push_back("no proof beside it: there is no " + name + "; persist --proof writes one");
        return {};
    }
    Verdict verdict;
    std::string whose = "points in " + points.name;
    const std::string program = platform::find_program(verifier_name);
    if (program.empty()) {
        verdict.why = std::string("there is no ") + verifier_name +
                      " beside netmesh, nor in a folder of PATH; it is built where there is GMP";
    } else {
        // First the file itself, with no part of this tool in between. Other tables are read here.
        const bool is_plain = made.points_path != "-" && !chooses(made.table);
        Outcome outcome;
        if (is_plain) outcome = run_verifier(program, {made.points_path, diagram, proof}, &verdict);
        if (outcome.good() && (!is_plain || verdict.is == Verdict::refused)) {
            HandedOver handed;
            whose = "points that netmesh reads in " + points.name;
            outcome = handed.write(points, made.table.weights);
            if (outcome.good()) outcome = run_verifier(program, {handed.path(), diagram, proof}, &verdict);
            const std::size_t at = verdict.why.find(handed.path());
            if (at != std::string::npos) verdict.why.replace(at, handed.path().size(), points.name);
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
    const std::string said = std::string("not verified, as ") + verifier_name + " cannot be run: " + verdict.why;
    if (is_given) return file_error(name, said);
    tell_warning(name, said);
    run->checked->push_back("no proof verified: " + name + " is " + said);
    return {};
}

}  // namespace netmesh::tool
