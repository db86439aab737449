// The reduction of a matrix over Z/2, whatever its columns are.
//
// As long as the pivot of a column, its last row, is the pivot of a column before it, that column, the pivot's owner,
// is added. What is left in the end is zero, or it has a pivot of its own and the two simplices are a pair. Listed
// matrices (listed_columns.hpp: boundaries for homology and cycles, coboundaries), implicit ones (rips/) and those of
// vineyards differ in how columns are held, which a class Columns says, and in what is made of the outcome, which a
// recorder says. The table from pivots to their owners is the columns', as an implicit matrix owns pivots without one;
// pair(j) is where the recorder has column j entered.
#pragma once
#include <cstdint>

#include "vocabulary/status.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {

// Columns:
//   Status open(j)       column j becomes the one at work
//   bool has_owner()     whether the column at work has a pivot that is owned
//   Status add_owner()   adds that owner to it
//   bool is_zero()
//   const char* violation(j)   only with NETMESH_VALIDATE: what is wrong with what is kept, after column j was reduced
// Recorder:
//   bool next(&j)        the next column to reduce, false: no more. Columns known to be zero are left out (clearing)
//   Status pair(j)       column j is reduced and has a pivot that nobody owns, which it becomes the owner of
//   Status zero(j)       column j has become zero
template <class Columns, class Recorder> Status reduce_columns(Columns& columns, Recorder& recorder) {
    for (std::uint32_t j; recorder.next(&j);) {
        Status status = columns.open(j);
        while (status == Status::ok && columns.has_owner()) status = columns.add_owner();
        if (status == Status::ok) status = columns.is_zero() ? recorder.zero(j) : recorder.pair(j);
        if (status != Status::ok) return status;
        NETMESH_VALIDATE_WHOLE(columns.violation(j));
    }
    return Status::ok;
}

}  // namespace netmesh
