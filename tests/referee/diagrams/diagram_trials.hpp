// Runs of the tool whose diagrams are judged, and violations planted in good ones.
#pragma once
#include "cases.hpp"

namespace referee {

struct DiagramSettings {
    std::size_t most[dim_max + 1] = {0, 0, 12, 8, 7, 0, 0};  // points of a family
    std::size_t sets_max = 2500;                             // of a truth
    std::size_t simplices = 20000;                           // of a mesh whose pairs are computed anew
    std::size_t over_refined = 6;                            // points in space that tight and scales are tried on
    const char* memory = "48M";
    unsigned seconds = 10;
    double ways = 1;  // how many of all ways are tried on a set
    bool named_with_all_k = true;
    std::string keep;  // folder for the files of what fails
};

struct DiagramAccount {
    int sets = 0, runs = 0, refused = 0, too_large = 0, failures = 0;
    int judged = 0, by_scale = 0, cycles = 0, pairs = 0, checked = 0, fits = 0, vineyards = 0, distances = 0;
    std::map<std::string, int> ways;           // how often each was judged and accepted by `check`
    std::map<std::string, int> planted, seen;  // by the plant's name
    double tightest = 0;                       // largest ln(true ratio) / ln(certified ratio)
    std::string tightest_title;
};

void try_set(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const std::string& title,
             std::uint64_t seed, DiagramAccount* account);
void try_diagram_family(const Tool& tool, const DiagramSettings& settings, int dim, std::size_t family,
                        std::uint64_t seed, DiagramAccount* account);
void try_named_diagrams(const Tool& tool, const DiagramSettings& settings, DiagramAccount* account);

// The same points in blocks that grow; vineyards in k; distances of two diagrams.
void try_fits(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const std::string& title,
              Random& random, DiagramAccount* account);
void try_vineyard(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const std::string& title,
                  Random& random, DiagramAccount* account);
void try_distance(const Tool& tool, const DiagramSettings& settings, const DiagramFile& a, const DiagramFile& b,
                  const std::string& title, DiagramAccount* account);

void try_diagram_plants(const Tool& tool, const DiagramSettings& settings, int dim, std::uint64_t seed,
                        DiagramAccount* account);

void fail(const Tool& tool, const DiagramSettings& settings, const std::string& title, const std::string& what,
          DiagramAccount* account);

}  // namespace referee
