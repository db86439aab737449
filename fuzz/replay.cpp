// Runs a fuzz target without a fuzzer: on the files named and those in the folders named, or on COUNT random inputs
// from SEED (replay --random COUNT SEED).
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
    if (argc == 4 && std::strcmp(argv[1], "--random") == 0) {
        std::uint64_t state = std::strtoull(argv[3], nullptr, 10);
        const long count = std::strtol(argv[2], nullptr, 10);
        const auto next = [&state] {
            state = state * 6364136223846793005u + 1442695040888963407u;
            return static_cast<std::uint8_t>(state >> 56);
        };
        for (long i = 0; i < count; ++i) {
            const std::size_t pieces = 1 + next() % 4u;
            std::vector<std::uint8_t> input(3 + next() % 96u * pieces);
            const std::uint8_t mask = next();  // few different bytes make degenerate sets
            for (std::uint8_t& byte : input) byte = next() & mask;
            input[0] = next();
            LLVMFuzzerTestOneInput(input.data(), input.size());
        }
        std::printf("%ld random inputs\n", count);
        return 0;
    }
    std::vector<std::string> names;
    for (int i = 1; i < argc; ++i) {
        if (std::filesystem::is_directory(argv[i])) {
            for (const auto& entry : std::filesystem::directory_iterator(argv[i])) names.push_back(entry.path());
        } else {
            names.push_back(argv[i]);
        }
    }
    for (const std::string& name : names) {
        std::ifstream file(name, std::ios::binary);
        if (!file) {
            std::fprintf(stderr, "%s cannot be read\n", name.c_str());
            return 1;
        }
        const std::vector<char> content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        const std::vector<std::uint8_t> input(content.begin(), content.end());
        LLVMFuzzerTestOneInput(input.data(), input.size());
    }
    if (names.empty()) {
        std::fprintf(stderr, "no input\n");
        return 1;
    }
    std::printf("%zu files\n", names.size());
    return 0;
}
