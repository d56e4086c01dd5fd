#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

namespace forefront {

/// Abaqus and CalculiX read at most this many characters of a number.
inline constexpr std::size_t kAbaqusCharacters = 20;

/// The text of a coordinate: the shortest that reads back to the same bits or, if that is too long, that of the number
/// rounded to as many digits as fit.
class AbaqusCoordinate {
  public:
    explicit AbaqusCoordinate(double value) {
        char *const end = text_.data() + text_.size();
        length_ = lengthTo(std::to_chars(text_.data(), end, value).ptr);
        for (int digits = 16; length_ > kAbaqusCharacters; --digits) {
            length_ = lengthTo(std::to_chars(text_.data(), end, value, std::chars_format::general, digits).ptr);
            rounded_ = true;
        }
    }
    std::string_view text() const { return {text_.data(), length_}; }
    bool rounded() const { return rounded_; }

  private:
    std::size_t lengthTo(const char *end) const { return static_cast<std::size_t>(end - text_.data()); }

    std::array<char, 64> text_;
    std::size_t length_ = 0;
    bool rounded_ = false;
};

} // namespace forefront
