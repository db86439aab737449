// Matchings of bars, decided exactly.
#pragma once
#include <cstdint>
#include <vector>

namespace referee {

// Who may be matched to whom: of each one on the left those on the right.
using Choices = std::vector<std::vector<std::uint32_t>>;

// Is there a matching that holds all on the left that `must` be in it? `missing` gets one that cannot be.
bool can_match(const Choices& choices, std::size_t right_count, const std::vector<char>& must, std::size_t* missing);

// The same of both sides. A matching that holds one side's and another that holds the other side's are as good as one
// that holds both (Mendelsohn and Dulmage). `is_left` says on which side `missing` is.
bool can_match_both(const Choices& choices, const std::vector<char>& left, const std::vector<char>& right,
                    std::size_t* missing, bool* is_left);

}  // namespace referee
