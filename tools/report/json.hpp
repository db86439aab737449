// JSON text, written in order.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace netmesh::tool {

// Objects and arrays are opened and closed by the caller; commas and indentation come by themselves. Arrays of numbers
// stand on one line.
class Json {
public:
    void open(char bracket);   // { or [, as a value
    void close(char bracket);  // } or ]
    void key(std::string_view name);

    void value(std::string_view text);  // bytes that are no UTF-8 become U+FFFD
    void value(const char* text) { value(std::string_view(text)); }
    void value(std::uint64_t number);
    void value(std::uint32_t number) { value(static_cast<std::uint64_t>(number)); }
    void value(double number);  // null when it is not finite
    void value(bool yes);
    void null();
    // 16 hexadecimal digits.
    void fingerprint(std::uint64_t bits);

    template <class T> void entry(std::string_view name, const T& item) {
        key(name);
        value(item);
    }
    void null_entry(std::string_view name) {
        key(name);
        null();
    }
    // The text, with a line end behind it.
    std::string text() const { return text_ + "\n"; }
    // What there is of the text so far, which text() then leaves out.
    std::string take() { return std::exchange(text_, {}); }

private:
    void separate();
    void new_line();
    std::string text_;
    std::string open_;  // brackets that are open now
    bool first_ = true, after_key_ = false;
};

}  // namespace netmesh::tool
