// Runs of the tool that are judged: meshes of families of points, and violations planted in good meshes.
#pragma once
#include <map>
#include <string>

#include "families.hpp"
#include "plants.hpp"

namespace referee {

struct Settings {
    std::size_t size[dim_max + 1] = {0, 0, 30, 12, 6, 6, 6};  // points of a family, about
    std::size_t refined = 6;                                  // points in space that --method refine is tried on
    double cells_max = 500;                                   // of the largest dimension; ten times as many below
    std::size_t samples = 20000;
    unsigned seconds = 10;      // for each run of the tool
    bool every_ground = false;  // plants in every kind of mesh, not in one of them
    std::string keep;           // folder for the files of failed trials
};

// What a whole run has seen.
struct Account {
    int trials = 0, meshes = 0, refused = 0, too_large = 0, failures = 0;
    std::map<std::string, int> planted, seen;  // by the plant's name: how often, and how often `check` refused it
    double worst_sampled = 0;                  // largest sampled ratio over tau
};

void try_family(const Tool& tool, const Settings& settings, int dim, std::size_t family, std::uint64_t seed,
                Account* account);
void try_named(const Tool& tool, const Settings& settings, std::size_t share, int dim_most, Account* account);
void try_plants(const Tool& tool, const Settings& settings, int dim, std::uint64_t seed, Account* account);

}  // namespace referee
