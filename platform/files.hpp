// Whole files in, whole files out.
#pragma once
#include <cstddef>
#include <cstdint>
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

// An ordinary file that is read in parts, from wherever one likes.
class InputFile {
public:
    InputFile() = default;
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    // False with a phrase in *why, also for what is no ordinary file.
    bool open(const std::string& path, std::string* why);
    std::uint64_t bytes() const { return bytes_; }
    // False with a phrase in *why, also where the file ends before.
    bool read(std::uint64_t offset, char* data, std::size_t bytes, std::string* why) const;

private:
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
};

// A file without a name, which is gone with the process whatever ends it.
class ScratchFile {
public:
    ScratchFile() = default;
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    bool open(const std::string& folder);
    // Errors are remembered, and nothing is done after the first; a signal is one.
    bool write(std::uint64_t offset, const void* data, std::size_t bytes);
    bool read(std::uint64_t offset, void* data, std::size_t bytes);
    const std::string& why() const { return why_; }

private:
    int descriptor_ = -1;
    std::string why_;
};

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
    // At an offset, and what was written there; of an ordinary file alone.
    void write_at(std::uint64_t offset, const void* data, std::size_t bytes);
    void read_at(std::uint64_t offset, void* data, std::size_t bytes);
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
