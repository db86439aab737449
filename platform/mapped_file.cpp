#include "platform/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace netmesh::platform {

bool MappedFile::open(const std::string& path, std::string* why) {
    close();
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        *why = errno == ENOENT ? "no such file or folder" : std::strerror(errno);
        return false;
    }
    struct stat about = {};
    bool good = fstat(descriptor, &about) == 0;
    if (good && about.st_size > 0) {
        bytes_ = static_cast<std::size_t>(about.st_size);
        data_ = mmap(nullptr, bytes_, PROT_READ, MAP_PRIVATE, descriptor, 0);
        good = data_ != MAP_FAILED;
    }
    if (!good) {
        *why = std::strerror(errno);
        data_ = nullptr;
        bytes_ = 0;
    }
    ::close(descriptor);
    return good;
}

void MappedFile::close() {
    if (data_ != nullptr) munmap(data_, bytes_);
    data_ = nullptr;
    bytes_ = 0;
}

}  // namespace netmesh::platform
