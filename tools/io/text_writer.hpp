// Text on its way to a file, in large pieces.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "platform/files.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

// Without a file the text stays in memory, for tests and for what has to be assembled.
class TextWriter {
public:
    explicit TextWriter(platform::OutputFile* file = nullptr) : file_(file) {}
    ~TextWriter() { flush(); }
    TextWriter(const TextWriter&) = delete;
    TextWriter& operator=(const TextWriter&) = delete;

    TextWriter& operator<<(std::string_view text) {
        std::memcpy(room(text.size()), text.data(), text.size());
        used_ += text.size();
        return *this;
    }
    TextWriter& operator<<(char c) {
        *room(1) = c;
        ++used_;
        return *this;
    }
    // Shortest digits that read back to the same double.
    TextWriter& operator<<(double value) { return write(value); }
    TextWriter& operator<<(std::uint64_t value) { return write(value); }
    TextWriter& operator<<(std::uint32_t value) { return write(std::uint64_t{value}); }

    void flush() {
        if (file_ == nullptr || used_ == 0) return;
        file_->write(text_.data(), used_);
        used_ = 0;
    }
    std::string text() const { return text_.substr(0, used_); }

private:
    template <class Number> TextWriter& write(Number value) {
        char* const to = room(number_bytes);
        used_ += static_cast<std::size_t>(write_number(to, value) - to);
        return *this;
    }
    // Where the next so many bytes go.
    char* room(std::size_t bytes) {
        if (used_ + bytes > text_.size()) make_room(bytes);
        return text_.data() + used_;
    }
    void make_room(std::size_t bytes) {
        if (text_.size() >= piece_bytes) flush();
        if (used_ + bytes > text_.size()) text_.resize(2 * text_.size() + bytes + 1024);
    }

    static constexpr std::size_t piece_bytes = std::size_t{1} << 20;
    platform::OutputFile* file_;
    std::string text_;  // of which the first used_ bytes are text
    std::size_t used_ = 0;
};

}  // namespace netmesh::tool
