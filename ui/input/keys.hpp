#pragma once

#include <cstdint>

namespace forefront {

/// Key codes, numbered as in GLFW; letters and digits are ASCII capitals.
namespace key {
inline constexpr int kSpace = 32, kApostrophe = 39, kComma = 44, kMinus = 45, kPeriod = 46, kSlash = 47;
inline constexpr int k0 = 48, k2 = 50, k9 = 57, kEqual = 61;
inline constexpr int kLeftBracket = 91, kRightBracket = 93;
inline constexpr int kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259, kInsert = 260, kDelete = 261;
inline constexpr int kRight = 262, kLeft = 263, kDown = 264, kUp = 265, kPageUp = 266, kPageDown = 267;
inline constexpr int kHome = 268, kEnd = 269;
inline constexpr int kF1 = 290, kF5 = 294, kF11 = 300;
inline constexpr int kKeypad0 = 320, kKeypad9 = 329, kKeypadDecimal = 330, kKeypadEnter = 335;
inline constexpr int kLeftShift = 340, kLeftControl = 341, kLeftAlt = 342, kLeftSuper = 343;
inline constexpr int kRightShift = 344, kRightControl = 345, kRightAlt = 346, kRightSuper = 347;
} // namespace key

/// Modifier bits, as in GLFW.
struct Modifiers {
    static constexpr std::uint8_t kShift = 1, kControl = 2, kAlt = 4;
    std::uint8_t bits = 0;

    bool shift() const { return (bits & kShift) != 0; }
    bool control() const { return (bits & kControl) != 0; }
    bool alt() const { return (bits & kAlt) != 0; }
    bool none() const { return bits == 0; }
    friend bool operator==(Modifiers, Modifiers) = default;
};

inline constexpr Modifiers kNoModifiers{};
inline constexpr Modifiers kShift{Modifiers::kShift}, kControl{Modifiers::kControl}, kAlt{Modifiers::kAlt};
inline constexpr Modifiers kControlShift{Modifiers::kControl | Modifiers::kShift};

enum class MouseButton : std::uint8_t { Left = 0, Right = 1, Middle = 2 };

} // namespace forefront
