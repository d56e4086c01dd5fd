#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace forefront {

/// A 64-bit streaming hash for comparing meshes and states between runs; not cryptographic.
/// The mixing step is the 64-bit finaliser of MurmurHash3 (A. Appleby, public domain).
class Hash64 {
  public:
    void add(std::uint64_t word) {
        std::uint64_t h = state_ ^ (word + 0x9e3779b97f4a7c15ULL + (state_ << 6) + (state_ >> 2));
        h ^= h >> 33;
        h *= 0xff51afd7ed558ccdULL;
        h ^= h >> 33;
        h *= 0xc4ceb9fe1a85ec53ULL;
        h ^= h >> 33;
        state_ = h;
    }
    /// Adds the exact bits of a number, except that -0.0 counts as 0.0.
    void add(double number) { add(std::bit_cast<std::uint64_t>(number == 0.0 ? 0.0 : number)); }
    void add(std::string_view text) {
        add(static_cast<std::uint64_t>(text.size()));
        for (const char c : text) {
            add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
        }
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0x6a09e667f3bcc908ULL;
};

/// Returns the value as sixteen lower-case hexadecimal digits.
inline std::string toHex(std::uint64_t value) {
    std::string text(16, '0');
    for (int digit = 15; digit >= 0; --digit, value >>= 4) {
        text[static_cast<std::size_t>(digit)] = "0123456789abcdef"[value & 15U];
    }
    return text;
}

} // namespace forefront
