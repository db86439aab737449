#include "tools/io/vdw_radii.hpp"

#include <cstdint>
#include <string>

#include "tools/io/characters.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

struct Radius {
    std::uint64_t number;
    std::string_view symbol;
    double radius;
};

constexpr Radius radii[] = {
    {1, "h", 1.10},   {2, "he", 1.40},  {3, "li", 1.81},  {4, "be", 1.53},  {5, "b", 1.92},   {6, "c", 1.70},
    {7, "n", 1.55},   {8, "o", 1.52},   {9, "f", 1.47},   {10, "ne", 1.54}, {11, "na", 2.27}, {12, "mg", 1.73},
    {13, "al", 1.84}, {14, "si", 2.10}, {15, "p", 1.80},  {16, "s", 1.80},  {17, "cl", 1.75}, {18, "ar", 1.88},
    {19, "k", 2.75},  {20, "ca", 2.31}, {31, "ga", 1.87}, {32, "ge", 2.11}, {33, "as", 1.85}, {34, "se", 1.90},
    {35, "br", 1.83}, {36, "kr", 2.02}, {37, "rb", 3.03}, {38, "sr", 2.49}, {49, "in", 1.93}, {50, "sn", 2.17},
    {51, "sb", 2.06}, {52, "te", 2.06}, {53, "i", 1.98},  {54, "xe", 2.16}, {55, "cs", 3.43}, {56, "ba", 2.68},
    {81, "tl", 1.96}, {82, "pb", 2.02}, {83, "bi", 2.07}, {84, "po", 1.97}, {85, "at", 2.02}, {86, "rn", 2.20},
    {87, "fr", 3.48}, {88, "ra", 2.83},
};

}  // namespace

double van_der_waals_radius(std::string_view element) {
    std::string symbol = lower_case(element.substr(0, element.find_first_of("0123456789")));
    if (symbol == "d") symbol = "h";  // deuterium
    std::uint64_t number = 0;
    if (symbol.empty() && !parse_unsigned(std::string(element), &number)) return 0;
    for (const Radius& known : radii)
        if (symbol.empty() ? known.number == number : known.symbol == symbol) return known.radius;
    return 0;
}

}  // namespace netmesh::tool
