// The bytes of a proof and the fingerprints in it. See docs/proofs.md.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "tools/io/diagram_file.hpp"
#include "tools/io/fingerprint.hpp"

namespace netmesh::tool {

// The bits of a double, -0 as 0.
inline std::uint64_t bits_of(double x) {
    std::uint64_t bits = 0;
    if (x != 0) std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

inline std::uint64_t bars_fingerprint(const BarSource& bars) {
    Fingerprint f;
    bars.for_each([&](const Bar& bar) {
        f.add(bar.degree);
        f.add(bits_of(bar.birth));
        f.add(bits_of(bar.death));
    });
    return f.value();
}

// They are held until all are there, as their number is the first that their fingerprint is of.
class ProofBytes {
public:
    void text(std::string_view text) { bytes_ += text; }
    void number(std::uint64_t value, std::uint32_t bytes) {
        for (std::uint32_t i = 0; i < bytes; i++) bytes_ += static_cast<char>(value >> 8 * i);
    }
    // 7 bits a byte, the least first.
    void number(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
        bytes_ += static_cast<char>(value);
    }
    std::uint64_t fingerprint() const {
        Fingerprint f;
        f.add(bytes_.size());
        for (std::size_t i = 0; i < bytes_.size(); i += 8) {
            std::uint64_t word = 0;
            for (std::size_t j = std::min(bytes_.size(), i + 8); j-- > i;)
                word = word << 8 | static_cast<unsigned char>(bytes_[j]);
            f.add(word);
        }
        return f.value();
    }
    const std::string& all() const { return bytes_; }

private:
    std::string bytes_;
};

}  // namespace netmesh::tool
