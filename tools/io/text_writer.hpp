// Text on its way to a file, in large pieces.
#pragma once
#include <cstdint>
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
        text_ += text;
        return spill();
    }
    TextWriter& operator<<(char c) {
        text_ += c;
        return *this;
    }
    // Shortest digits that read back to the same double.
    TextWriter& operator<<(double value) {
        append_number(text_, value);
        return spill();
    }
    TextWriter& operator<<(std::uint64_t value) {
        append_number(text_, value);
        return spill();
    }
    TextWriter& operator<<(std::uint32_t value) { return *this << static_cast<std::uint64_t>(value); }

    void flush() {
        if (file_ == nullptr) return;
        file_->write(text_.data(), text_.size());
        text_.clear();
    }
    const std::string& text() const { return text_; }

private:
    TextWriter& spill() {
        if (file_ != nullptr && text_.size() > piece_bytes) flush();
        return *this;
    }
    static constexpr std::size_t piece_bytes = std::size_t{1} << 20;
    platform::OutputFile* file_;
    std::string text_;
};

}  // namespace netmesh::tool
