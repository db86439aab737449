// The binary as a shell sees it, in a folder of its own that goes away afterwards.
#pragma once
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

struct Result {
    int exit = -1;  // -1: killed by a signal
    std::string out, err;
    bool says(const std::string& text) const { return err.find(text) != std::string::npos; }
};

class Folder {
public:
    Folder() {
        char name[] = "/tmp/netmesh-test-XXXXXX";
        path_ = mkdtemp(name);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::string& path() const { return path_; }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ + "/" + name, std::ios::binary) << content;
    }
    std::string read(const std::string& name) const {
        std::ifstream file(path_ + "/" + name, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    bool has(const std::string& name) const { return std::filesystem::exists(path_ + "/" + name); }
    // Names of all files, sorted.
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }
    // Runs `netmesh ARGUMENTS` by the shell in this folder; `before` may set limits, `after` redirect once more.
    Result run(const std::string& arguments, const std::string& input = "", const std::string& before = "",
               const std::string& after = "") const {
        Folder streams;
        streams.write("in", input);
        const std::string command = "cd '" + path_ + "' && " + before + " '" + NETMESH_BINARY + "' " + arguments +
                                    " <'" + streams.path() + "/in' >'" + streams.path() + "/out' 2>'" + streams.path() +
                                    "/err' " + after;
        const int status = std::system(command.c_str());
        Result result;
        if (WIFEXITED(status)) result.exit = WEXITSTATUS(status);
        result.out = streams.read("out");
        result.err = streams.read("err");
        return result;
    }

private:
    std::string path_;
};

// A .pers file without its comments.
inline std::string bars_of(const std::string& diagram) {
    std::istringstream lines(diagram);
    std::string bars;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("#", 0) != 0) bars += line + "\n";
    }
    return bars;
}

// Value of a number behind "key": in JSON text; -1 when it is not there.
inline double number_in(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\": ");
    return at == std::string::npos ? -1 : std::strtod(json.c_str() + at + key.size() + 4, nullptr);
}

inline std::string text_in(const std::string& json, const std::string& key) {
    const std::size_t at = json.rfind("\"" + key + "\": \"");
    if (at == std::string::npos) return "";
    const std::size_t start = at + key.size() + 5;
    return json.substr(start, json.find('"', start) - start);
}
