// Numbers in text, both ways, without a locale.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace netmesh::tool {

enum class NumberKind { finite, not_finite, not_a_number };

// One decimal number at the start of [at, end): on success at moves behind it. A leading + is allowed; hexadecimal is
// not. 1e400 is not_finite; 1e-400 and -1e-400 are 0, the nearest double; -0 is read as +0. nan, inf and infinity in
// any case are not_finite.
NumberKind parse_double(const char*& at, const char* end, double* value);

// The whole of `text` as an unsigned decimal number; false otherwise, also when it does not fit.
bool parse_unsigned(const std::string& text, std::uint64_t* value);
// The whole of `text` as a finite double.
bool parse_finite(const std::string& text, double* value);

// True for a whole number from 0 to 2^53 - 1: what a count or an index in a file has to be.
bool is_count(double value);

// Writes a number at `to`, where there is room for number_bytes, and returns the end. Of doubles the shortest digits
// that read back to the same; "inf" for infinity. -0.0 is written as 0.
constexpr std::size_t number_bytes = 32;
char* write_number(char* to, double value);
char* write_number(char* to, std::uint64_t value);
// The same behind a text.
void append_number(std::string& text, double value);
void append_number(std::string& text, std::uint64_t value);
std::string number_text(double value);
// `digits` significant digits, for people.
std::string rounded_text(double value, int digits);
// The same, never below the value: of a bound from above.
std::string bound_text(double value, int digits);
// 12345 -> 12,345
std::string grouped_text(std::uint64_t value);
// 1 point, 1,200 points
std::string counted(std::uint64_t count, const char* one, const char* many);
// 16 digits
std::string hexadecimal(std::uint64_t value);
// 1536 -> 1.5 KiB
std::string bytes_text(std::uint64_t bytes);
// Never less than the bytes: 1500 -> 1.5 KiB.
std::string bytes_text_up(std::uint64_t bytes);
// The same as --memory takes it, in whole units: 1500 -> 2K.
std::string memory_option_text(std::uint64_t bytes);

}  // namespace netmesh::tool
