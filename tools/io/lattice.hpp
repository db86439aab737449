// Vectors by which points repeat: as options say them, as files of atoms do, and which points are inside of one period.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace netmesh::tool {

struct Lattice {
    // As the options have it: nothing; --box; --cell; --cell file, which is none of these before points are read.
    enum Kind { none, box, cell, file };
    Kind kind = none;
    std::uint32_t dim = 0;          // of the vectors; 0: not known
    std::vector<double> vectors;    // [count][dim], finite
    std::vector<double> low, high;  // of a box [dim]; without a period infinite
    std::string text;               // the option's value, numbers as they are read, angles as vectors

    std::uint32_t count() const { return dim == 0 ? 0 : static_cast<std::uint32_t>(vectors.size() / dim); }
    // "--box" or "--cell"
    const char* option() const { return kind == box ? "--box" : "--cell"; }
};

// What a file of atoms says of its period: Lattice="..." of extended .xyz, in a line of other words; CRYST1 of .pdb.
struct FileCell {
    std::string text;  // the line; empty: there is none
    std::uint64_t line = 0;
};

// Each leaves *lattice as the text says, or says what is wrong with it: a complaint, or empty.
//   box   0:10,5,-         for each axis from where to where, or from 0 to a length; a dash: no period
//   cell  4,0/1,4          D vectors of D numbers; a dash: no period in that direction
//         4,4,5,90,90,120  in space: the sides a, b, c and the angles between b and c, a and c, a and b in degrees; a
//         is
//                          along x, b in the plane of x and y
//         file             what the file of points says
std::string parse_box(const std::string& text, Lattice* lattice);
std::string parse_cell(const std::string& text, Lattice* lattice);
std::string parse_file_cell(std::string_view text, Lattice* lattice);

// How many of the points [rows][lattice.dim] are none of the period from the box's least coordinates on, or from the
// origin: those that stand for their copies there. Within 2^-40 of a period a point of a cell may count either way.
std::uint64_t points_outside(const Lattice& lattice, const std::vector<double>& coordinates);

}  // namespace netmesh::tool
