// Runs a fuzz target without a fuzzer: on the files named, or on COUNT random inputs from SEED (replay --random COUNT SEED).
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
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
            std::vector<std::uint8_t> input(3 + next() % 96u);
            const std::uint8_t mask = next();  // few different bytes make degenerate sets
            for (std::uint8_t& byte : input) byte = next() & mask;
            input[0] = next();
            LLVMFuzzerTestOneInput(input.data(), input.size());
        }
        std::printf("%ld random inputs\n", count);
        return 0;
    }
    for (int i = 1; i < argc; ++i) {
        std::ifstream file(argv[i], std::ios::binary);
        if (!file) {
            std::fprintf(stderr, "%s cannot be read\n", argv[i]);
            return 1;
        }
        const std::vector<char> input((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    }
    std::printf("%d files\n", argc - 1);
    return 0;
}
