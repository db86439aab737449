// Compressed content, by zlib where the tool was built with it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace netmesh::tool {

// What to do about it without zlib, or what is wrong: a complaint, or empty. All members of a .gz one after the other.
std::string gunzip(std::string_view packed, std::string* content);

// A file inside a .zip, as numpy's .npz is one.
struct ZipEntry {
    std::string name;
    std::string_view packed;
    std::size_t bytes;     // unpacked
    unsigned crc, method;  // 0: stored, 8: deflated
};
// The entries in the order of the archive's directory; the archive must outlive them. A complaint, or empty.
std::string list_zip(std::string_view archive, std::vector<ZipEntry>* entries);
std::string unzip(const ZipEntry& entry, std::string* content);

}  // namespace netmesh::tool
