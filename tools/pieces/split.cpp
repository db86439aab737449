// The first task: the points of a file, put in the order of the tree.
#include <algorithm>

#include "platform/clock.hpp"
#include "platform/folders.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/point_stream.hpp"
#include "tools/pieces/scratch_points.hpp"
#include "tools/pieces/tasks.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

constexpr std::size_t default_memory = std::size_t{256} << 20;

// A record, what the engine takes to cut it, and its share of boxes.
std::uint64_t points_in(std::size_t bytes, std::uint32_t dim) { return bytes / (20 * std::uint64_t{dim} + 32); }

// All rows of the file. *gave_up: it has to be read whole.
Outcome read_stream(PointStream& stream, const PiecesFolder& folder, std::uint64_t points_most, ScratchPoints* points,
                    bool* gave_up) {
    Outcome outcome = points->open(folder.path(), stream.dim(), points_most);
    std::vector<double> rows;
    do {
        rows.clear();
        if (outcome.good()) outcome = stream.read(&rows);
        *gave_up = stream.gave_up();
        if (!outcome.good() || *gave_up) return outcome;
        outcome = points->add(rows);
    } while (outcome.good() && !rows.empty());
    return outcome.good() ? points->end() : outcome;
}

struct SplitInput {
    std::string name;
    std::uint32_t dim = 0;
    std::unique_ptr<ScratchPoints> points;
};

Outcome read_input(const Options& options, const PiecesFolder& folder, const std::string& path, SplitInput* input) {
    const std::size_t bytes = options.memory_bytes != 0 ? options.memory_bytes : default_memory;
    std::unique_ptr<PointStream> stream;
    input->name = shown_name(path);
    input->points = std::make_unique<ScratchPoints>();
    Outcome outcome = open_stream(path, options.table, &stream);
    if (!outcome.good()) return outcome;
    if (stream != nullptr) {
        bool gave_up = false;
        input->dim = stream->dim();
        outcome = read_stream(*stream, folder, points_in(bytes, input->dim), input->points.get(), &gave_up);
        if (outcome.good() && !gave_up) tell_note(options, input->name, stream->note());
        if (!outcome.good() || !gave_up) return outcome;
        input->points = std::make_unique<ScratchPoints>();
    }
    PointCloud cloud;
    outcome = read_cloud(options, path, &cloud);
    input->dim = cloud.dim;
    if (outcome.good()) outcome = input->points->open(folder.path(), cloud.dim, points_in(bytes, cloud.dim));
    if (outcome.good()) outcome = input->points->add(cloud.coordinates);
    return outcome.good() ? input->points->end() : outcome;
}

}  // namespace

Outcome split_task(const Options& options, const PiecesFolder& folder, const std::string& input, double* read_seconds,
                   PointsFile* points) {
    std::string why;
    if (!platform::make_folder(folder.path(), &why)) return file_error(folder.path(), why);
    const double start = platform::seconds_now();
    SplitInput read;
    const Outcome outcome = read_input(options, folder, input, &read);
    *read_seconds = platform::seconds_now() - start;
    if (!outcome.good()) return outcome;
    PiecesJob job = {};
    const bool is_advised = options.pieces == 0;
    job.pieces = is_advised ? advised_pieces(read.dim, read.points->rows(), options.memory_bytes) : options.pieces;
    job.dim = read.dim;
    job.max_degree = std::min(options.request.max_degree, read.dim - 1);
    job.keep_zero = options.request.keep_zero_pairs;
    job.rows = read.points->rows();
    job.fingerprint = read.points->fingerprint();
    if (platform::MappedFile file; file.open(folder.points(), &why)) {
        const Outcome outcome = points->open(folder.points());
        if (!outcome.good()) return outcome;
        if (is_advised) job.pieces = points->job().pieces;
        return points->open(folder.points(), job);
    }
    Options persist = persist_options(options, job);
    persist.memory_bytes = 0;
    Session session(persist, read.dim);
    PointCloud cloud = nothing_of(job);
    cloud.name = read.name;
    const SplitNode split = [&](const Records& records, std::uint32_t pieces, netmesh_split_result* made) {
        const std::size_t words = std::size_t{read.dim} + 1;
        const auto work = [&](Session& s) {
            return s.call(NETMESH_STAGE_SORT, [&] {
                netmesh_split_request r = s.watched(sized<netmesh_split_request>());
                r.pieces = pieces;
                r.points = {records.data(),
                            records.size() / words,
                            read.dim,
                            NETMESH_POINTS_FLOAT64,
                            8 * words,
                            nullptr,
                            0,
                            nullptr,
                            0};
                *made = sized<netmesh_split_result>();
                const netmesh_status status = netmesh_split(s.engine().context(), &r);
                return status == NETMESH_OK ? netmesh_get_split(s.engine().context(), made) : status;
            });
        };
        const Outcome ended = session.run(records.size() / words * (8 * read.dim + 64), cloud, work);
        *made = ended.good() ? *made : netmesh_split_result{};
        // Points that are equal leave fewer of them than there are nodes below: none are made.
        return session.engine().detail().field == NETMESH_FIELD_PIECES ? Outcome{} : ended;
    };
    if (is_advised) read.points->lower_pieces();
    const Outcome written = read.points->write(folder.points(), read.name, split, &job);
    return written.good() ? points->open(folder.points(), job) : written;
}

}  // namespace netmesh::tool
