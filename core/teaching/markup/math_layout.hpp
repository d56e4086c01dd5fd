#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/teaching/markup/math.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The room that ink takes around a point of the baseline, in pixels, all sides positive.
struct MathExtent {
    double width = 0.0;   ///< up to the next character
    double ascent = 0.0;  ///< above the baseline
    double descent = 0.0; ///< below it; negative if the ink ends above
};

/// The fonts that formulas are set in, each in two sizes: level 0 is that of the text, level 1 that of indices.
class MathFont {
  public:
    virtual ~MathFont() = default;
    /// Returns the extent of characters, which are not empty.
    virtual MathExtent extentOf(std::string_view text, bool italic, int level) const = 0;
    /// Returns the size of the em.
    virtual double em(int level) const = 0;
};

/// Characters of a formula, and where they are: y points down, from the baseline of the formula.
struct MathText {
    Vec2 at; ///< the left end of their baseline
    std::string text{};
    bool italic = false;
    int level = 0;
    double scale = 1.0;  ///< of the font
    MathExtent extent{}; ///< with that scale
};

/// A line of a formula, such as the bar of a fraction.
struct MathStroke {
    std::vector<Vec2> points;
};

/// A formula that has been set.
struct MathLayout {
    MathExtent extent{};
    double thickness = 1.0; ///< of its strokes
    std::vector<MathText> texts{};
    std::vector<MathStroke> strokes{};
};

/// Sets a formula. `display`: on a line of its own, with fractions in the size of the text.
MathLayout layoutMath(const MathNode &formula, const MathFont &font, bool display = false);

} // namespace forefront
