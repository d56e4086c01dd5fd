#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

namespace forefront::fuzz {

/// Reads numbers from bytes, 0 at the end of them.
class ByteNumbers {
  public:
    explicit ByteNumbers(std::string_view bytes) : bytes_(bytes) {}

    bool atEnd() const { return at_ >= bytes_.size(); }
    unsigned byte() { return atEnd() ? 0U : static_cast<unsigned char>(bytes_[at_++]); }
    /// Returns a multiple of 1/8 in [0, 32), sometimes off by the last digit.
    double coordinate() {
        const double value = 0.125 * byte();
        return byte() % 16 == 0 ? value * (1.0 + std::numeric_limits<double>::epsilon()) : value;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

} // namespace forefront::fuzz
