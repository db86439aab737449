// Whole files in, whole files out.
#pragma once
#include <cstddef>
#include <string>

namespace netmesh::platform {

// The content of the file `path` into *content. False with a phrase in *why ("no such file", "is a directory") on
// failure, also when a signal came while it waited.
bool read_file(const std::string& path, std::string* content, std::string* why);
bool read_stdin(std::string* content, std::string* why);

// Whether OutputFile::open(path) can be expected to work, found out without leaving anything behind: for saying no
// before a long computation and not after it.
bool can_write(const std::string& path, std::string* why);

// Do both names stand for the same ordinary file, be it there already or not?
bool is_one_file(const std::string& a, const std::string& b);

// A file that is either there as a whole or not at all: written under a temporary name in the same folder and renamed
// by publish(). Without publish() the destructor removes it. A device or a pipe that already has the name is written
// directly; of a symbolic link the target is replaced.
class OutputFile {
public:
    OutputFile() = default;
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    bool open(const std::string& path);
    void open_stdout();
    // Errors are remembered until finish().
    void write(const char* data, std::size_t bytes);
    // All bytes are with the system and the file is closed, under its temporary name still. publish() then renames.
    bool finish();
    bool publish();
    const std::string& why() const { return why_; }

private:
    bool fail(const char* doing);
    int descriptor_ = -1;
    int removal_ = -1;  // handle of remove_when_killed()
    bool is_stdout_ = false;
    std::string path_, temporary_, why_;
};

}  // namespace netmesh::platform
