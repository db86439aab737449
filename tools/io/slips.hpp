// What people take for coordinates by mistake: columns that their names or their numbers give away.
#pragma once
#include <string>
#include <vector>

namespace netmesh::tool {

struct TakenColumns {
    std::vector<std::size_t> columns;  // of the file, from 0, behind each other in `values`
    std::vector<std::string> names;    // of these; empty: there is no header
    std::size_t width = 0;             // columns of the file
    bool chosen = false;               // by --columns: what they mean is known
};

// Sentences for the note: latitude and longitude, numbers that stand for "missing", times, rows that are counted,
// names that are those of no coordinates. None of it is certain, so all of it is read. `stride` numbers a row, at least
// as many as columns.
std::vector<std::string> slips_of(const TakenColumns& taken, const std::vector<double>& values, std::size_t stride);

// 1,2,4-9
std::string ranges_text(const std::vector<std::size_t>& numbers);

}  // namespace netmesh::tool
