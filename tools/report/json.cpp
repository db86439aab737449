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

void Json::value(std::string_view text) {
    separate();
    text_ += '"';
    for (const char c : text) {
        char escape[8];
        if (c == '"' || c == '\\') {
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
