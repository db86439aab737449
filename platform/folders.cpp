#include "platform/folders.hpp"

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace netmesh::platform {

std::string system_folder() {
    const char* const named = std::getenv("TMPDIR");
    return named != nullptr && *named != '\0' ? named : "/tmp";
}

int open_unnamed(const std::string& folder, std::string* why) {
    std::string name = folder + "/netmesh-XXXXXX";
    const int descriptor = mkstemp(&name[0]);
    if (descriptor >= 0 && unlink(name.c_str()) == 0) return descriptor;
    *why = "cannot write in " + folder + ": " + std::strerror(errno);
    if (descriptor >= 0) close(descriptor);
    return -1;
}

bool make_folder(const std::string& path, std::string* why) {
    if (mkdir(path.c_str(), 0777) == 0) return true;
    struct stat about = {};
    if (errno == EEXIST && stat(path.c_str(), &about) == 0 && S_ISDIR(about.st_mode)) return true;
    *why = errno == EEXIST ? "there is a file of that name" : std::strerror(errno);
    return false;
}

std::string temporary_folder(std::string* why) {
    const std::string name = system_folder() + "/netmesh-XXXXXX";
    std::vector<char> text(name.begin(), name.end());
    text.push_back('\0');
    if (mkdtemp(text.data()) == nullptr) {
        *why = name + ": " + std::strerror(errno);
        return {};
    }
    return text.data();
}

void remove_folder(const std::string& path) {
    DIR* const folder = opendir(path.c_str());
    if (folder != nullptr) {
        for (const dirent* entry = readdir(folder); entry != nullptr; entry = readdir(folder))
            if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
                unlink((path + "/" + entry->d_name).c_str());
        closedir(folder);
    }
    rmdir(path.c_str());
}

}  // namespace netmesh::platform
