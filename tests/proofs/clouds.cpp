// Small clouds in files, of the families of tests/exact: what is nearly degenerate, and what is wholly so.
//
//     proofs_clouds SEED COUNT FOLDER     FOLDER/0.txt .. of 2 to 5 dimensions
#include <cstdio>
#include <cstdlib>
#include <string>

#include "exact/families.hpp"

namespace {

void write(const std::string& path, const families::Points& x, int dim) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (file == nullptr) std::exit(2);
    for (std::size_t i = 0; i < x.size(); ++i)
        std::fprintf(file, "%.17g%c", x[i], (i + 1) % static_cast<std::size_t>(dim) == 0 ? '\n' : ' ');
    std::fclose(file);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const auto families = families::all();
    families::Random random(std::strtoull(argv[1], nullptr, 10));
    const int count = std::atoi(argv[2]);
    for (int i = 0; i < count; ++i) {
        const int dim = random.whole(2, 5), most = random.one_in(8) ? 60 : 16;
        const auto& family = families[static_cast<std::size_t>(i) % families.size()];
        families::Points x = family.make(random, dim, static_cast<std::size_t>(random.whole(dim + 1, most)));
        if (random.one_in(2)) families::move_units(random, random.one_in(2) ? 1 : 3, &x);
        if (random.one_in(6)) {
            const double scale = std::ldexp(1.0, random.whole(-900, 900));
            for (double& c : x) c *= scale;
        }
        write(std::string(argv[3]) + "/" + std::to_string(i) + ".txt", x, dim);
    }
    return 0;
}
