// What is left of the simplices of a piece once it has paired what it decides by itself, and the bytes of it.
//
// Simplices of one dimension are in order: by value, equal ones by their vertices, which are rows of the input. So the
// order is that of all pieces, whoever lists a simplex. Each has a home, the only piece that has it as a column of its
// own, and a scope: the lowest node below which are the homes of all columns that have it as a row.
//
// Columns are boundaries, of edges and of what is between; at the top, where every facet has two sides, they are
// coboundaries of facets, and cells are the rows. A piece lists as rows also simplices that are at home elsewhere.
#pragma once
#include <cstddef>
#include <cstdint>

#include "diagram/pair.hpp"
#include "include/netmesh/pieces.h"
#include "memory/work.hpp"
#include "pieces/node.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

constexpr int simplex_most = dimension_most() + 1;  // vertices

namespace piece_state {
constexpr std::uint8_t original = 1,  // listed by the piece that its column will be from, now or at a join above
    column = 2,                       // it may be the end of a class
    row = 4;                          // it may be the beginning of one
}  // namespace piece_state

struct PieceColumn {
    const std::uint32_t* rows;  // distinct, in any order
    std::uint32_t count;
};

struct PieceSides {
    std::uint32_t of[2];  // rows; none: there is no other
};

struct PieceSimplices {
    std::uint32_t count;
    double* value;
    std::uint32_t* vertices;  // [count][k + 1], ascending
    PieceNode* home;
    PieceNode* scope;
    std::uint8_t* state;
    PieceSides* ends;      // of edges: their vertices, or what has taken their place
    PieceSides* sides;     // of facets, where cells are listed: cells, or what has taken their place
    PieceColumn* columns;  // of what is between
    // In a leaf, of what is between: rows that are paired already, row i with column count + i, which is not listed.
    std::uint32_t* matched;
    std::uint32_t matched_count;

    const std::uint32_t* vertices_of(std::uint32_t k, std::uint32_t i) const {
        return vertices + std::size_t{i} * (k + 1);
    }
};

// By value, then by vertices.
inline int compare_vertices(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return 0;
}

// What all pieces of a job have in common.
struct PieceJob {
    std::uint32_t dim, pieces;
    std::uint64_t points, rows, fingerprint;
    std::uint32_t max_degree;
    std::uint32_t keep_zero;

    // Dimensions of simplices that are listed, from 0 on.
    std::uint32_t top() const { return max_degree + 1 < dim ? max_degree + 1 : dim; }
    bool has_cells() const { return top() == dim; }
    // Dimensions whose columns are boundaries of more than two.
    std::uint32_t middle_last() const { return has_cells() ? dim - 1 : top(); }
    bool is_middle(std::uint32_t k) const { return k >= 2 && k <= middle_last(); }
    bool has_ends(std::uint32_t k) const { return k == 1; }
    bool has_sides(std::uint32_t k) const { return has_cells() && k + 1 == dim; }
    std::uint32_t depth() const { return depth_of(pieces); }
};
bool operator==(const PieceJob& a, const PieceJob& b);

struct Piece {
    PieceJob job;
    PieceNode node;
    std::uint64_t simplices;  // that have been at home below, or are listed below for a join above
    const Pair* bars;         // of this node alone
    std::uint64_t bar_count;
    PieceSimplices of[simplex_most];
};

// Bytes of a piece: what write_piece makes of it at the arena's low end. out_of_memory.
struct PieceBytes {
    unsigned char* first;
    std::size_t count;
};
Status write_piece(const Piece& piece, const Work& work, PieceBytes* out);
// Moves them down to the arena's low mark, when nothing below them is needed any more. out_of_memory: hardly ever.
Status move_piece_down(Arena& arena, PieceBytes* bytes);

constexpr char piece_not_aligned[] = "a piece is null or not 8-byte aligned";
inline bool is_piece_aligned(const netmesh_piece& piece) {
    return (piece.bytes != nullptr || piece.count == 0) && reinterpret_cast<std::uintptr_t>(piece.bytes) % 8 == 0;
}

// Why bytes are not a piece: a static text, null if they are. Everything that indices refer to is within the bytes.
// columns of *out are taken at the arena's low end; the rest is read where it stands, 8-byte aligned.
const char* read_piece(const void* first, std::size_t count, Arena& arena, Piece* out, Status* status);
struct PieceSize {
    std::uint64_t whole, head;
};
// The same of its job, node and bars, which the bytes of its head are enough for; nothing behind them is looked at.
const char* read_piece_head(const void* first, std::size_t count, Piece* out, PieceSize* bytes);
// Of a piece whose head is good: why what follows is not.
const char* check_piece_body(const void* first, std::size_t count);

}  // namespace netmesh
