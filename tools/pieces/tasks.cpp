#include "tools/pieces/tasks.hpp"

#include <algorithm>

#include "platform/files.hpp"
#include "tools/filters.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

netmesh_piece piece_of(const platform::MappedFile& file) { return {file.data(), file.bytes()}; }

Outcome write_whole(const std::string& path, const netmesh_piece& piece) {
    platform::OutputFile file;
    if (!file.open(path)) return file_error(path, file.why());
    file.write(static_cast<const char*>(piece.bytes), piece.count);
    return file.finish() && file.publish() ? Outcome{} : file_error(path, file.why());
}

constexpr char rerun[] = "; remove the file and run its task again";

// Is it the piece of this node of the job, by its head or, with `whole`, by all bytes? Else why not, as a phrase.
bool is_of(const netmesh_piece& piece, const PiecesJob& job, std::uint32_t node, bool whole, netmesh_piece_info* info,
           std::string* why) {
    *info = sized<netmesh_piece_info>();
    info->look_at_all = whole ? 1 : 0;
    const bool good = netmesh_read_piece(&piece, info) == NETMESH_OK;
    if (!good)
        *why = info->fault != nullptr ? info->fault : "no piece";
    else if (info->node != node)
        *why = "the piece of node " + std::to_string(info->node);
    else if (info->pieces != job.pieces || info->dim != job.dim || info->max_degree != job.max_degree ||
             info->keep_zero_pairs != job.keep_zero || info->points != job.count || info->rows != job.rows ||
             info->fingerprint != job.fingerprint)
        *why = "a piece of another job than the points of this folder";
    else
        return true;
    return false;
}

Outcome make_piece(const Options& options, const PiecesFolder& folder, PointsFile& points, std::uint32_t node,
                   platform::Reservation* block) {
    const PiecesJob& job = points.job();
    Options persist = persist_options(options, job);
    persist.pieces = job.pieces;
    Session session(persist, job.dim, block);
    platform::MappedFile parts[2];
    std::string why;
    const bool is_leaf = node >= job.pieces;
    std::size_t plan = is_leaf ? netmesh_plan_leaf(job.dim, job.count, job.pieces) : 0;
    for (std::uint32_t i = 0; i < 2 && !is_leaf; i++) {
        const std::string name = folder.piece(2 * node + i);
        netmesh_piece_info info;
        if (!parts[i].open(name, &why)) return file_error(name, why);
        if (!is_of(piece_of(parts[i]), job, 2 * node + i, false, &info, &why)) return file_error(name, why + rerun);
        plan += static_cast<std::size_t>(info.join_bytes);
    }
    netmesh_source source = points.source();
    const auto work = [&](Session& s) {
        return s.call(NETMESH_STAGE_REDUCE, [&] {
            if (!is_leaf) {
                netmesh_join_request r = s.watched(sized<netmesh_join_request>());
                r.one = piece_of(parts[0]);
                r.other = piece_of(parts[1]);
                return netmesh_join(s.engine().context(), &r);
            }
            netmesh_leaf_request r = s.watched(sized<netmesh_leaf_request>());
            r.pieces = job.pieces;
            r.source = &source;
            r.node = node;
            r.max_degree = job.max_degree;
            r.keep_zero_pairs = job.keep_zero;
            return netmesh_leaf(s.engine().context(), &r);
        });
    };
    const Outcome outcome = session.run(plan, nothing_of(job), work);
    if (!points.fault().empty()) return file_error(folder.points(), points.fault());
    const netmesh_detail detail = session.engine().detail();
    if (detail.status == NETMESH_INVALID_ARGUMENT &&
        (detail.field == NETMESH_FIELD_ONE || detail.field == NETMESH_FIELD_OTHER))
        return file_error(folder.piece(2 * node + (detail.field == NETMESH_FIELD_OTHER ? 1 : 0)),
                          std::string(detail.message) + rerun);
    if (!outcome.good()) return outcome;
    netmesh_piece made = {};
    if (netmesh_get_piece(session.engine().context(), &made) != NETMESH_OK)
        return {Exit::internal, "netmesh: internal error: no piece"};
    return write_whole(folder.piece(node), made);
}

}  // namespace

PointCloud nothing_of(const PiecesJob& job) {
    PointCloud cloud;
    cloud.dim = job.dim;
    cloud.name.assign(job.name, std::min<std::size_t>(job.name_bytes, sizeof job.name));
    return cloud;
}

Options persist_options(const Options& options, const PiecesJob& job) {
    Options made = options;
    made.command = Command::persist;
    made.request = netmesh_default_request();
    made.request.filter = &netmesh_filter_alpha;
    made.request.max_degree = job.max_degree;
    made.request.keep_zero_pairs = job.keep_zero;
    return made;
}

std::uint32_t advised_pieces(std::uint32_t dim, std::uint64_t points, std::size_t memory_bytes) {
    constexpr std::uint64_t each[] = {0, 0, 65536, 65536, 8192, 1024, 256};
    std::uint32_t pieces = 1;
    const auto fits = [&] { return memory_bytes == 0 || netmesh_plan_leaf(dim, points, pieces) <= memory_bytes; };
    while ((points / pieces > each[dim] || !fits()) && pieces < 1u << 20 && 2 * pieces <= points) pieces *= 2;
    return pieces;
}

bool has_piece(const PiecesFolder& folder, const PiecesJob& job, std::uint32_t node) {
    platform::MappedFile file;
    std::string why;
    if (!file.open(folder.piece(node), &why)) return false;
    netmesh_piece_info info;
    return is_of(piece_of(file), job, node, true, &info, &why);
}

Outcome piece_task(const Options& options, const PiecesFolder& folder, const PiecesJob& job, std::uint32_t node,
                   platform::Reservation* block) {
    PointsFile points;
    const Outcome outcome = points.open(folder.points(), job);
    if (!outcome.good()) return outcome;
    return has_piece(folder, job, node) ? Outcome{} : make_piece(options, folder, points, node, block);
}

Outcome Collection::open(const PiecesFolder& folder, const PiecesJob& job) {
    std::string why;
    job_ = job;
    for (std::uint32_t node = 1; node < 2 * job.pieces; node++) {
        names_.push_back(folder.piece(node));
        if (!file_.open(names_.back(), &why))
            return file_error(names_.back(), why + "; it is not done, or not to be found");
        plan_ += file_.bytes();
    }
    file_.close();
    return {};
}

netmesh_status Collection::open_piece(void* self, std::size_t i, netmesh_piece* piece) {
    Collection& c = *static_cast<Collection*>(self);
    c.at_ = i;
    if (!c.file_.open(c.names_[i], &c.fault_)) return NETMESH_NO_RESULT;
    *piece = piece_of(c.file_);
    netmesh_piece_info info;
    std::string why;
    if (is_of(*piece, c.job_, static_cast<std::uint32_t>(i + 1), false, &info, &why)) return NETMESH_OK;
    c.fault_ = why + rerun;
    return NETMESH_CHECK_FAILED;
}

netmesh_status Collection::collect(Session& session) {
    return session.call(NETMESH_STAGE_REDUCE, [&] {
        netmesh_collect_request r = session.watched(sized<netmesh_collect_request>());
        r.open = open_piece;
        r.user = this;
        r.count = names_.size();
        const netmesh_status status = netmesh_collect(session.engine().context(), &r);
        file_.close();
        return status;
    });
}

Outcome Collection::explain(const netmesh_detail& detail) const {
    if (!fault_.empty()) return file_error(names_[at_], fault_);
    if (detail.status != NETMESH_INVALID_ARGUMENT || detail.field != NETMESH_FIELD_PIECES) return {};
    return file_error(names_[static_cast<std::size_t>(detail.index_a)], detail.message + std::string(rerun));
}

}  // namespace netmesh::tool
