#include "tools/pieces/points_file.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "platform/interrupt.hpp"
#include "tools/io/fingerprint.hpp"

namespace netmesh::tool {

namespace {

constexpr std::uint64_t points_magic = 0x6E6D706F696E7401u;  // the last byte is the version
constexpr std::size_t part_bytes = std::size_t{1} << 16;

std::uint64_t checksum_of(const void* data, std::size_t bytes) {  // the last word filled up with zeros
    Fingerprint sum;
    for (std::size_t at = 0; at < bytes; at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, static_cast<const char*>(data) + at, std::min<std::size_t>(8, bytes - at));
        sum.add(word);
    }
    return sum.value();
}

std::uint64_t header_checksum(const PiecesJob& job) {
    constexpr std::size_t begin = offsetof(PiecesJob, checksum) + 8;
    return checksum_of(reinterpret_cast<const char*>(&job) + begin, sizeof job - begin);
}

struct Places {
    std::uint64_t rows, boxes, end;
};
Places places_of(const PiecesJob& job) {
    const std::uint64_t rows = sizeof(PiecesJob) + job.count * job.dim * 8;
    const std::uint64_t boxes = rows + (job.count * 4 + 7) / 8 * 8;
    return {rows, boxes, boxes + ((std::uint64_t{2} << job.levels) - 1) * 2 * job.dim * 8};
}

}  // namespace

Outcome PointsWriter::open(const std::string& path, const std::string& name, const PiecesJob& job) {
    path_ = path;
    job_ = job;
    job_.magic = points_magic;
    job_.name_bytes = static_cast<std::uint32_t>(std::min(name.size(), sizeof job_.name));
    std::memcpy(job_.name, name.data(), job_.name_bytes);
    job_.parts = places_of(job_).end;
    const std::uint64_t parts = (job_.parts - sizeof job_ + part_bytes - 1) / part_bytes;
    job_.bytes = job_.parts + 8 * parts;
    job_.checksum = header_checksum(job_);
    return file_.open(path) ? Outcome{} : file_error(path, file_.why());
}

void PointsWriter::put_points(std::uint64_t first, const double* coordinates, const std::uint32_t* rows,
                              std::size_t count) {
    const std::size_t row_bytes = std::size_t{8} * job_.dim;
    file_.write_at(sizeof job_ + first * row_bytes, coordinates, count * row_bytes);
    file_.write_at(places_of(job_).rows + first * 4, rows, count * 4);
}

void PointsWriter::put_boxes(std::uint32_t node, const double* boxes, std::size_t count) {
    const std::size_t box_bytes = std::size_t{16} * job_.dim;
    file_.write_at(places_of(job_).boxes + (node - 1) * box_bytes, boxes, count * box_bytes);
}

Outcome PointsWriter::finish() {
    const char zeros[8] = {};
    const Places places = places_of(job_);
    const std::uint64_t rows_end = places.rows + job_.count * 4;
    file_.write_at(rows_end, zeros, static_cast<std::size_t>(places.boxes - rows_end));
    std::vector<char> some(16 * part_bytes);
    std::vector<std::uint64_t> sums;
    for (std::uint64_t begin = sizeof job_, put = 0; begin < job_.parts && file_.why().empty();) {
        const auto bytes = static_cast<std::size_t>(std::min<std::uint64_t>(some.size(), job_.parts - begin));
        file_.read_at(begin, some.data(), bytes);
        for (std::size_t at = 0; at < bytes; at += part_bytes)
            sums.push_back(checksum_of(some.data() + at, std::min(part_bytes, bytes - at)));
        file_.write_at(job_.parts + put, sums.data(), 8 * sums.size());
        put += 8 * sums.size();
        sums.clear();
        begin += bytes;
    }
    file_.write_at(0, &job_, sizeof job_);
    if (file_.finish() && file_.publish()) return {};
    if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while writing " + path_};
    return file_error(path_, file_.why());
}

Outcome PointsFile::open(const std::string& path) {
    path_ = path;
    std::string why;
    if (!file_.open(path, &why)) return file_error(path, why);
    if (file_.bytes() < sizeof job_) return file_error(path, "not the points of a job in pieces");
    std::memcpy(&job_, file_.data(), sizeof job_);
    if (job_.magic != points_magic)
        return file_error(path, job_.magic >> 8 == points_magic >> 8
                                    ? "the points of a job in pieces of another version of netmesh"
                                    : "not the points of a job in pieces");
    if (job_.checksum != header_checksum(job_) || job_.dim < 2 || job_.dim > NETMESH_DIM_MAX || job_.levels > 30)
        return file_error(path, "damaged: its header is not as it was written");
    const Places places = places_of(job_);
    if (job_.bytes != file_.bytes() || job_.parts != places.end)
        return file_error(path, "damaged: " + std::to_string(file_.bytes()) + " bytes where " +
                                    std::to_string(job_.bytes) + " were written");
    rows_at_ = places.rows;
    boxes_at_ = places.boxes;
    checked_.assign((places.end - sizeof job_ + part_bytes - 1) / part_bytes, false);
    return {};
}

std::string difference_of(const PiecesJob& there, const PiecesJob& wanted) {
    const auto differ = [](const std::string& what, std::uint64_t is, std::uint64_t asked) {
        return what + " " + std::to_string(is) + " in place of " + std::to_string(asked);
    };
    if (there.dim != wanted.dim || there.rows != wanted.rows || there.fingerprint != wanted.fingerprint)
        return "other points, of " +
               std::string(there.name, std::min<std::size_t>(there.name_bytes, sizeof there.name));
    if (there.pieces != wanted.pieces) return differ("--pieces", there.pieces, wanted.pieces);
    if (there.max_degree != wanted.max_degree) return differ("--max-degree", there.max_degree, wanted.max_degree);
    if (there.keep_zero != wanted.keep_zero) return there.keep_zero != 0 ? "with --all" : "without --all";
    return {};
}

Outcome PointsFile::open(const std::string& path, const PiecesJob& wanted) {
    const Outcome outcome = open(path);
    const std::string difference = outcome.good() ? difference_of(job_, wanted) : "";
    if (difference.empty()) return outcome;
    return file_error(path, "of another job: " + difference + "; name another folder, or remove this one");
}

netmesh_source PointsFile::source() {
    netmesh_source source = {};
    source.struct_bytes = sizeof source;
    source.dim = job_.dim;
    source.levels = job_.levels;
    source.count = job_.count;
    source.rows = job_.rows;
    source.fingerprint = job_.fingerprint;
    source.read = read;
    source.box = box;
    source.user = this;
    return source;
}

bool PointsFile::copy(std::uint64_t offset, std::size_t bytes, void* to) {
    const std::uint64_t body = sizeof(PiecesJob);
    for (std::uint64_t part = (offset - body) / part_bytes; part <= (offset + bytes - 1 - body) / part_bytes; part++) {
        if (checked_[part]) continue;
        const std::uint64_t begin = body + part * part_bytes, end = std::min(begin + part_bytes, job_.parts);
        std::uint64_t wanted;
        std::memcpy(&wanted, file_.data() + job_.parts + 8 * part, 8);
        if (checksum_of(file_.data() + begin, end - begin) != wanted) {
            fault_ = "damaged, or changed since it was written: bytes " + std::to_string(begin) + " to " +
                     std::to_string(end);
            return false;
        }
        checked_[part] = true;
    }
    std::memcpy(to, file_.data() + offset, bytes);
    return true;
}

netmesh_status PointsFile::read(void* self, std::uint64_t first, std::uint32_t count, double* points,
                                std::uint32_t* rows) {
    PointsFile& file = *static_cast<PointsFile*>(self);
    const std::size_t row_bytes = std::size_t{8} * file.job_.dim;
    const bool good = file.copy(sizeof(PiecesJob) + first * row_bytes, count * row_bytes, points) &&
                      file.copy(file.rows_at_ + first * 4, std::size_t{4} * count, rows);
    return good ? NETMESH_OK : NETMESH_CHECK_FAILED;
}

netmesh_status PointsFile::box(void* self, std::uint32_t node, double* box) {
    PointsFile& file = *static_cast<PointsFile*>(self);
    const std::size_t bytes = std::size_t{16} * file.job_.dim;
    return file.copy(file.boxes_at_ + (node - 1) * bytes, bytes, box) ? NETMESH_OK : NETMESH_CHECK_FAILED;
}

}  // namespace netmesh::tool
