#include "tools/report/json.hpp"

#include <cmath>
#include <cstdio>

#include "tools/io/numbers.hpp"

namespace netmesh::tool {

void Json::new_line() { text_ += "\n" + std::string(2 * open_.size(), ' '); }

void Json::separate() {
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (!first_) text_ += ',';
    if (!open_.empty() && open_.back() == '{') {
        new_line();
    } else if (!first_) {
        text_ += ' ';
    }
    first_ = false;
}

void Json::open(char bracket) {
    separate();
    text_ += bracket;
    open_ += bracket;
    first_ = true;
}

void Json::close(char bracket) {
    open_.pop_back();
    if (bracket == '}' && !first_) new_line();
    text_ += bracket;
    first_ = false;
}

void Json::key(std::string_view name) {
    separate();
    text_ += '"';
    text_ += name;
    text_ += "\": ";
    after_key_ = true;
}

namespace {

// Bytes of the UTF-8 character that begins at text[at]; 0 where none does.
std::size_t character_bytes(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    if (first < 0x80) return 1;
    const std::size_t count = first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : 4;
    if (first < 0xC2 || first > 0xF4 || at + count > text.size()) return 0;
    for (std::size_t i = at + 1; i < at + count; i++)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    const unsigned char second = byte(at + 1);
    const bool good = (first != 0xE0 || second >= 0xA0) && (first != 0xED || second < 0xA0) &&
                      (first != 0xF0 || second >= 0x90) && (first != 0xF4 || second < 0x90);
    return good ? count : 0;
}

}  // namespace

void Json::value(std::string_view text) {
    separate();
    text_ += '"';
    for (std::size_t at = 0; at < text.size(); at++) {
        const char c = text[at];
        const std::size_t bytes = character_bytes(text, at);
        char escape[8];
        if (bytes != 1) {
            text_ += bytes == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(at, bytes);
            at += bytes == 0 ? 0 : bytes - 1;
        } else if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned char>(c));
            text_ += escape;
        } else {
            text_ += c;
        }
    }
    text_ += '"';
}

void Json::value(std::uint64_t number) {
    separate();
    append_number(text_, number);
}

void Json::value(double number) {
    if (!std::isfinite(number)) return null();
    separate();
    append_number(text_, number);
}

void Json::value(bool yes) {
    separate();
    text_ += yes ? "true" : "false";
}

void Json::null() {
    separate();
    text_ += "null";
}

void Json::fingerprint(std::uint64_t bits) {
    char digits[20];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(bits));
    value(std::string_view(digits));
}

}  // namespace netmesh::tool
