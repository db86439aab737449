// A line of text put together without a library.
#pragma once
#include <cstdint>

class Text {
public:
    Text& words(const char* s) {
        while (*s != 0 && length_ < sizeof text_ - 1) text_[length_++] = *s++;
        text_[length_] = 0;
        return *this;
    }
    Text& number(std::uint64_t n) {
        char digits[21];
        int at = 20;
        digits[at] = 0;
        do digits[--at] = static_cast<char>('0' + n % 10);
        while ((n /= 10) != 0);
        return words(digits + at);
    }
    Text& hex(std::uint64_t word) {
        char digits[17];
        for (int i = 15; i >= 0; --i, word >>= 4) digits[i] = "0123456789abcdef"[word & 15];
        digits[16] = 0;
        return words(digits);
    }
    const char* words() const { return text_; }

private:
    char text_[240] = {};
    unsigned length_ = 0;
};
