#include "tools/io/numbers.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace netmesh::tool {

NumberKind parse_double(const char*& at, const char* end, double* value) {
    const char* start = at;
    if (start != end && *start == '+' && start + 1 != end && start[1] != '-' && start[1] != '+') ++start;
    double number = 0;
    const std::from_chars_result result = std::from_chars(start, end, number);
    if (result.ec == std::errc::invalid_argument) return NumberKind::not_a_number;
    at = result.ptr;
    if (result.ec == std::errc::result_out_of_range) {
        // Too large or too small: from_chars does not say which. The program never leaves the C locale.
        number = std::strtod(std::string(start, result.ptr).c_str(), nullptr);
    }
    if (!std::isfinite(number)) return NumberKind::not_finite;
    *value = number + 0.0;  // -0.0 becomes 0.0
    return NumberKind::finite;
}

bool parse_unsigned(const std::string& text, std::uint64_t* value) {
    const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), *value);
    return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

bool parse_finite(const std::string& text, double* value) {
    const char* at = text.data();
    const char* end = at + text.size();
    return parse_double(at, end, value) == NumberKind::finite && at == end;
}

bool is_count(double value) {
    return value >= 0 && value < 9007199254740992.0 && value == static_cast<double>(static_cast<std::uint64_t>(value));
}

char* write_number(char* to, double value) { return std::to_chars(to, to + number_bytes, value + 0.0).ptr; }

char* write_number(char* to, std::uint64_t value) {
    const auto small = static_cast<std::uint32_t>(value);
    return small == value ? std::to_chars(to, to + number_bytes, small).ptr
                          : std::to_chars(to, to + number_bytes, value).ptr;
}

void append_number(std::string& text, double value) {
    char digits[number_bytes];
    text.append(digits, write_number(digits, value));
}

void append_number(std::string& text, std::uint64_t value) {
    char digits[number_bytes];
    text.append(digits, write_number(digits, value));
}

std::string number_text(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string rounded_text(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string bound_text(double value, int digits) {
    const auto is_below = [value](const std::string& text) { return std::strtod(text.c_str(), nullptr) < value; };
    std::string text = rounded_text(value, digits);
    if (!is_below(text)) return text;
    const double unit = std::pow(10.0, std::floor(std::log10(std::fabs(value))) + 1 - digits);
    text = rounded_text(value + 0.5 * unit, digits);
    return is_below(text) ? rounded_text(value, 17) : text;  // of the smallest numbers, whose unit is 0
}

std::string grouped_text(std::uint64_t value) {
    std::string text = std::to_string(value);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string counted(std::uint64_t count, const char* one, const char* many) {
    return grouped_text(count) + " " + (count == 1 ? one : many);
}

std::string hexadecimal(std::uint64_t value) {
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; value /= 16) text[i] = "0123456789abcdef"[value % 16];
    return text;
}

namespace {

std::string in_units(std::uint64_t bytes, bool up) {
    const char* const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    double amount = static_cast<double>(bytes);
    int unit = 0;
    while (amount >= 1024 && unit < 6) {
        amount /= 1024;
        unit++;
    }
    if (up && unit > 0) amount = std::ceil(amount * 10) / 10;
    char text[40];
    std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.1f %s", amount, bytes == 1 ? "byte" : units[unit]);
    return text;
}

}  // namespace

std::string bytes_text(std::uint64_t bytes) { return in_units(bytes, false); }
std::string bytes_text_up(std::uint64_t bytes) { return in_units(bytes, true); }

std::string memory_option_text(std::uint64_t bytes) {
    std::size_t unit = 0;
    while (bytes >= 8192 && unit < 4) {
        bytes = bytes / 1024 + (bytes % 1024 != 0 ? 1 : 0);
        unit++;
    }
    return std::to_string(bytes) + (unit == 0 ? "" : std::string("KMGT").substr(unit - 1, 1));
}

}  // namespace netmesh::tool
