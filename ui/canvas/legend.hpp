#pragma once

#include "ui/canvas/canvas_painter.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Size of a legend, margin to the edges of the canvas and gap to the next legend; design pixels.
inline constexpr double kLegendWidth = 216.0, kLegendHeight = 58.0, kLegendMargin = 14.0, kLegendGap = 10.0;

/// Returns how many legends fit side by side on a canvas of this width in design pixels; the rest go above.
inline int legendsAbreast(double canvasWidth) {
    return std::max(1,
                    static_cast<int>((canvasWidth - 2.0 * kLegendMargin + kLegendGap) / (kLegendWidth + kLegendGap)));
}

struct LegendTick {
    double at = 0.0; ///< in [0, 1] along the bar
    std::string text;
};

/// The text of a tick and its position in pixels from the left end of the bar.
struct LegendLabel {
    double left = 0.0, width = 0.0;
    std::string text;
    double at = 0.0; ///< of the tick
};

/// Lays out the labels of ticks along a bar of `bar` pixels, each below its tick but within the bar and at least `gap`
/// pixels apart. The two ends are always labelled; the others, from the left, if they fit.
std::vector<LegendLabel> legendLabels(ImFont *font, const std::vector<LegendTick> &ticks, double bar, double gap);

/// A limit on a colour bar, which is hatched on its bad side.
struct LegendLimit {
    double at = 0.0;   ///< in [0, 1] along the bar
    bool below = true; ///< values below it are bad
};

/// What a colour bar shows.
struct ColourBar {
    std::string title;
    ColourMap map = nullptr;
    std::vector<LegendTick> ticks;
    std::optional<LegendLimit> limit;
    double opacity = 1.0; ///< of the colours over the domain
};

/// Returns the bar of a legend without its title and numbers, in pixels; `corner`: of the legend, lower right.
PixelRect colourBarRect(Pixel corner, double scale);

/// Draws a colour bar with a title and ticks, its lower right corner at `corner` (pixels).
void drawColourBar(CanvasPainter &painter, const Theme &theme, const Fonts &fonts, Pixel corner, const ColourBar &bar);

/// Returns the ticks of a linear scale: the ends, and between them the multiples of a round step. The lower end reads
/// "≤", since smaller values share its colour.
std::vector<LegendTick> linearTicks(const ColourRange &range);

/// Returns the round numbers 1, 2, 5 · 10ⁿ in a range, or fewer (1 and 3 · 10ⁿ, 10ⁿ alone, or every second power and so
/// on) if there are more than `limit`.
std::vector<double> roundValues(double minimum, double maximum, std::size_t limit);
/// Returns the values of contour lines of a field that ranges from `minimum` to `maximum` > 0: round ones, at most
/// `limit`. A field that is limited to its range has areas at the ends of it, along whose rims a contour line would be
/// a staircase, so values at the ends have none.
std::vector<double> contourValues(double minimum, double maximum, std::size_t limit);

/// Returns the ticks of a logarithmic scale: the ends, and at most `limit` round numbers (1, 2, 5 · 10ⁿ) in between.
std::vector<LegendTick> logarithmicTicks(double minimum, double maximum, std::size_t limit);

} // namespace forefront
