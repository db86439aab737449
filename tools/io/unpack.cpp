#include "tools/io/unpack.hpp"

#include <algorithm>
#include <cstdint>

#include "tools/io/lines.hpp"

#ifdef NETMESH_TOOL_ZLIB
#include <zlib.h>
#endif

namespace netmesh::tool {

#ifdef NETMESH_TOOL_ZLIB

namespace {

constexpr int gzip_bits = 15 + 16, raw_bits = -15;

// Everything of one stream, or of several, to the end of *content.
std::string inflate_all(std::string_view packed, int window_bits, std::string* content) {
    std::size_t done = 0;
    std::vector<char> piece(std::size_t{1} << 18);
    while (done < packed.size()) {
        z_stream stream = {};
        if (inflateInit2(&stream, window_bits) != Z_OK) return "no memory left to unpack it";
        int status = Z_OK;
        while (status == Z_OK) {
            if (stream.avail_in == 0) {
                const std::size_t left = std::min(packed.size() - done, std::size_t{1} << 30);
                stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + done));
                stream.avail_in = static_cast<uInt>(left);
                done += left;
                if (left == 0) break;
            }
            stream.next_out = reinterpret_cast<Bytef*>(piece.data());
            stream.avail_out = static_cast<uInt>(piece.size());
            status = inflate(&stream, Z_NO_FLUSH);
            content->append(piece.data(), piece.size() - stream.avail_out);
        }
        done -= stream.avail_in;
        inflateEnd(&stream);
        if (status == Z_OK || status == Z_BUF_ERROR)
            return "its compressed data ends too early; the file is cut off: copy it again";
        if (status != Z_STREAM_END)
            return "its compressed data is broken near byte " + std::to_string(done) + "; copy the file again";
        const auto is_zero = [](char c) { return c == 0; };  // padding of tapes
        const std::string_view rest = packed.substr(done);
        if (std::all_of(rest.begin(), rest.end(), is_zero)) break;
        if (rest.substr(0, 2) != "\x1F\x8B")
            return "bytes that are not gzip behind its compressed data (byte " + std::to_string(done) + ")";
    }
    return {};
}

}  // namespace

std::string gunzip(std::string_view packed, std::string* content) {
    content->clear();
    return inflate_all(packed, gzip_bits, content);
}

#else

std::string gunzip(std::string_view, std::string*) {
    return "compressed by gzip, and this netmesh was built without zlib: gunzip it first";
}

#endif

namespace {

std::uint64_t number_at(std::string_view bytes, std::size_t at, unsigned count) {
    std::uint64_t number = 0;
    for (unsigned i = count; i-- > 0;)
        number = number << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    return number;
}

constexpr const char* broken_zip = "a broken archive; write it again";

}  // namespace

std::string list_zip(std::string_view archive, std::vector<ZipEntry>* entries) {
    const std::size_t end = archive.rfind("PK\x05\x06");
    if (end == std::string_view::npos || archive.size() - end < 22)
        return "its archive has no directory; the file is cut off: copy it again";
    const std::uint64_t count = number_at(archive, end + 10, 2);
    std::size_t at = number_at(archive, end + 16, 4);
    for (std::uint64_t i = 0; i < count; i++) {
        if (at > archive.size() || archive.size() - at < 46 || archive.substr(at, 4) != "PK\x01\x02") return broken_zip;
        const std::size_t name_bytes = number_at(archive, at + 28, 2), extra_bytes = number_at(archive, at + 30, 2);
        ZipEntry entry{};
        entry.method = static_cast<unsigned>(number_at(archive, at + 10, 2));
        entry.crc = static_cast<unsigned>(number_at(archive, at + 16, 4));
        std::uint64_t sizes[3] = {number_at(archive, at + 24, 4), number_at(archive, at + 20, 4),
                                  number_at(archive, at + 42, 4)};  // whole, packed, place
        if (archive.size() - at < 46 + name_bytes + extra_bytes) return broken_zip;
        entry.name = archive.substr(at + 46, name_bytes);
        const std::string_view extra = archive.substr(at + 46 + name_bytes, extra_bytes);
        for (std::size_t x = 0; x + 4 <= extra.size(); x += 4 + number_at(extra, x + 2, 2)) {
            std::size_t place = x + 4;  // zip64: those of the three that did not fit
            for (std::uint64_t& size : sizes) {
                if (number_at(extra, x, 2) != 1 || size != 0xFFFFFFFF) continue;
                size = number_at(extra, place, 8);
                place += 8;
            }
        }
        if ((number_at(archive, at + 8, 2) & 1) != 0) return "its archive is encrypted; write it without a password";
        const std::size_t local = sizes[2];
        if (local > archive.size() || archive.size() - local < 30) return broken_zip;
        const std::size_t data = local + 30 + number_at(archive, local + 26, 2) + number_at(archive, local + 28, 2);
        if (data > archive.size() || sizes[1] > archive.size() - data) return broken_zip;
        entry.packed = archive.substr(data, sizes[1]);
        entry.bytes = sizes[0];
        entries->push_back(std::move(entry));
        at += 46 + name_bytes + extra_bytes + number_at(archive, at + 32, 2);
    }
    return {};
}

std::string unzip(const ZipEntry& entry, std::string* content) {
    content->clear();
    if (entry.method == 0) *content = entry.packed;
    if (entry.method != 0 && entry.method != 8)
        return quoted(entry.name) + " is packed by method " + std::to_string(entry.method) +
               "; use numpy.savez_compressed";
#ifdef NETMESH_TOOL_ZLIB
    if (entry.method == 8) {
        const std::string complaint = inflate_all(entry.packed, raw_bits, content);
        if (!complaint.empty()) return complaint;
    }
    uLong crc = crc32(0, nullptr, 0);
    for (std::size_t at = 0; at < content->size(); at += std::size_t{1} << 30)
        crc = crc32(crc, reinterpret_cast<const Bytef*>(content->data()) + at,
                    static_cast<uInt>(std::min(content->size() - at, std::size_t{1} << 30)));
    if (crc != entry.crc) return quoted(entry.name) + " does not have its checksum; copy the file again";
#else
    if (entry.method == 8)
        return quoted(entry.name) + " is compressed, and this netmesh was built without zlib: write it by numpy.savez";
#endif
    return content->size() == entry.bytes ? std::string()
                                          : quoted(entry.name) + " does not have its size; copy the file again";
}

}  // namespace netmesh::tool
