#include "platform/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "platform/folders.hpp"
#include "platform/interrupt.hpp"

namespace netmesh::platform {

namespace {

std::string reason() {
    if (errno == ENOENT) return "no such file or folder";
    if (errno == EISDIR) return "is a directory";
    return std::strerror(errno);
}

bool read_descriptor(int descriptor, std::size_t expected, std::string* content, std::string* why) {
    content->resize(expected + 1);  // one more than expected, so that the end is seen without growing
    std::size_t filled = 0;
    for (;;) {
        if (filled == content->size()) content->resize(2 * filled + 65536);
        const ssize_t got = ::read(descriptor, &(*content)[filled], content->size() - filled);
        if (got == 0) break;
        if (got > 0) {
            filled += static_cast<std::size_t>(got);
        } else if (errno != EINTR) {
            *why = reason();
            return false;
        }
        if (interrupted()) {
            *why = "interrupted";
            return false;
        }
    }
    content->resize(filled);
    return true;
}

// All of the bytes at an offset, out or in. False with a phrase in *why, for a signal too.
template <class Call> bool move_all(Call call, std::uint64_t offset, std::size_t bytes, std::string* why) {
    for (std::size_t done = 0; done < bytes;) {
        if (interrupted()) {
            *why = "interrupted";
            return false;
        }
        const ssize_t moved = call(done, bytes - done, static_cast<off_t>(offset + done));
        if (moved > 0) {
            done += static_cast<std::size_t>(moved);
        } else if (moved == 0) {
            *why = "it ends at byte " + std::to_string(offset + done) + ", before it should";
            return false;
        } else if (errno != EINTR) {
            *why = reason();
            return false;
        }
    }
    return true;
}

bool read_all(int descriptor, std::uint64_t offset, void* data, std::size_t bytes, std::string* why) {
    const auto call = [&](std::size_t done, std::size_t left, off_t at) {
        return pread(descriptor, static_cast<char*>(data) + done, left, at);
    };
    return move_all(call, offset, bytes, why);
}

bool write_all(int descriptor, std::uint64_t offset, const void* data, std::size_t bytes, std::string* why) {
    const auto call = [&](std::size_t done, std::size_t left, off_t at) {
        return pwrite(descriptor, static_cast<const char*>(data) + done, left, at);
    };
    return move_all(call, offset, bytes, why);
}

std::string resolved(const std::string& path) {
    char* target = realpath(path.c_str(), nullptr);
    if (target == nullptr) return path;
    const std::string result = target;
    std::free(target);
    return result;
}

}  // namespace

bool read_file(const std::string& path, std::string* content, std::string* why) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        *why = reason();
        return false;
    }
    struct stat about = {};
    const bool known = fstat(descriptor, &about) == 0;
    bool good = false;
    if (known && S_ISDIR(about.st_mode)) {
        *why = "is a directory";
    } else {
        const std::size_t expected = known && S_ISREG(about.st_mode) ? static_cast<std::size_t>(about.st_size) : 0;
        good = read_descriptor(descriptor, expected, content, why);
    }
    ::close(descriptor);
    return good;
}

bool read_stdin(std::string* content, std::string* why) { return read_descriptor(0, 0, content, why); }

bool can_write(const std::string& path, std::string* why) {
    struct stat about = {};
    std::string tested = path;
    int wish = W_OK;
    if (stat(path.c_str(), &about) != 0) {
        const std::size_t slash = path.rfind('/');
        tested = slash == std::string::npos ? "." : path.substr(0, slash + 1);
        wish = W_OK | X_OK;
    } else if (S_ISDIR(about.st_mode)) {
        *why = "is a directory";
        return false;
    }
    if (access(tested.c_str(), wish) == 0) return true;
    *why = reason();
    return false;
}

bool is_one_file(const std::string& a, const std::string& b) {
    struct stat about_a = {}, about_b = {};
    const bool has_a = stat(a.c_str(), &about_a) == 0, has_b = stat(b.c_str(), &about_b) == 0;
    if (has_a != has_b) return false;
    if (has_a) return S_ISREG(about_a.st_mode) && about_a.st_dev == about_b.st_dev && about_a.st_ino == about_b.st_ino;
    const auto folder_of = [](const std::string& path) {
        const std::size_t slash = path.rfind('/');
        return slash == std::string::npos ? std::string("./") : path.substr(0, slash + 1);
    };
    const auto name_of = [](const std::string& path) { return path.substr(path.rfind('/') + 1); };
    return name_of(a) == name_of(b) && resolved(folder_of(a)) == resolved(folder_of(b));
}

InputFile::~InputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

bool InputFile::open(const std::string& path, std::string* why) {
    struct stat about = {};
    if (stat(path.c_str(), &about) != 0) {
        *why = reason();
        return false;
    }
    if (!S_ISREG(about.st_mode)) {  // a pipe must not be opened twice
        *why = S_ISDIR(about.st_mode) ? "is a directory" : "not an ordinary file";
        return false;
    }
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ >= 0 && fstat(descriptor_, &about) == 0) {
        bytes_ = static_cast<std::uint64_t>(about.st_size);
        return true;
    }
    *why = reason();
    return false;
}

bool InputFile::read(std::uint64_t offset, char* data, std::size_t bytes, std::string* why) const {
    return read_all(descriptor_, offset, data, bytes, why);
}

ScratchFile::~ScratchFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

bool ScratchFile::open(const std::string& folder) {
    descriptor_ = open_unnamed(folder, &why_);
    return descriptor_ >= 0;
}

bool ScratchFile::write(std::uint64_t offset, const void* data, std::size_t bytes) {
    return why_.empty() && write_all(descriptor_, offset, data, bytes, &why_);
}

bool ScratchFile::read(std::uint64_t offset, void* data, std::size_t bytes) {
    return why_.empty() && read_all(descriptor_, offset, data, bytes, &why_);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0 && !is_stdout_) ::close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
    forget(removal_);
}

bool OutputFile::fail(const char* doing) {
    if (why_.empty()) why_ = std::string(doing) + ": " + reason();
    return false;
}

void OutputFile::open_stdout() {
    descriptor_ = 1;
    is_stdout_ = true;
}

bool OutputFile::open(const std::string& path) {
    struct stat about = {};
    mode_t mode = 0;
    if (stat(path.c_str(), &about) == 0) {
        if (S_ISDIR(about.st_mode)) {
            errno = EISDIR;
            return fail("cannot write");
        }
        if (!S_ISREG(about.st_mode)) {
            descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
            return descriptor_ >= 0 || fail("cannot open for writing");
        }
        if (access(path.c_str(), W_OK) != 0) return fail("cannot write");
        mode = about.st_mode & 07777;
    } else {
        const mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    path_ = resolved(path);
    std::string name = path_ + ".XXXXXX";
    descriptor_ = mkstemp(&name[0]);
    if (descriptor_ < 0) return fail("cannot write");
    temporary_ = name;
    removal_ = remove_when_killed(temporary_.c_str());
    fchmod(descriptor_, mode);
    return true;
}

void OutputFile::write(const char* data, std::size_t bytes) {
    while (bytes > 0 && why_.empty()) {
        if (interrupted()) {
            why_ = "interrupted";
            return;
        }
        const ssize_t put = ::write(descriptor_, data, bytes);
        if (put >= 0) {
            data += put;
            bytes -= static_cast<std::size_t>(put);
        } else if (errno != EINTR) {
            fail("cannot write");
        }
    }
}

void OutputFile::write_at(std::uint64_t offset, const void* data, std::size_t bytes) {
    std::string why;
    if (why_.empty() && !write_all(descriptor_, offset, data, bytes, &why)) why_ = "cannot write: " + why;
}

void OutputFile::read_at(std::uint64_t offset, void* data, std::size_t bytes) {
    std::string why;
    if (why_.empty() && !read_all(descriptor_, offset, data, bytes, &why)) why_ = "cannot read: " + why;
}

bool OutputFile::finish() {
    if (descriptor_ >= 0 && !is_stdout_ && ::close(descriptor_) != 0) fail("cannot write");
    descriptor_ = -1;
    return why_.empty();
}

bool OutputFile::publish() {
    if (temporary_.empty()) return true;
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return fail("cannot rename");
    temporary_.clear();
    forget(removal_);
    removal_ = -1;
    return true;
}

}  // namespace netmesh::platform
