// A whole file as memory that is only read: pages come when they are looked at.
#pragma once
#include <cstddef>
#include <string>

namespace netmesh::platform {

class MappedFile {
public:
    MappedFile() = default;
    ~MappedFile() { close(); }
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    MappedFile(MappedFile&& other) noexcept : data_(other.data_), bytes_(other.bytes_) {
        other.data_ = nullptr;
        other.bytes_ = 0;
    }

    // False with a phrase in *why.
    bool open(const std::string& path, std::string* why);
    void close();
    const unsigned char* data() const { return static_cast<const unsigned char*>(data_); }
    std::size_t bytes() const { return bytes_; }

private:
    void* data_ = nullptr;
    std::size_t bytes_ = 0;
};

}  // namespace netmesh::platform
