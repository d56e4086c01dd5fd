#pragma once

#include "core/engine/mesh/measures.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/theme.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace forefront {

/// The colours of measures of which one end is bad.
enum class QualityScale : std::uint8_t {
    Alarm,  ///< quiet where the mesh is good, loud where it is bad
    Cividis ///< bright where the mesh is good, dark where it is bad
};

/// Returns the colour map of a measure on the ground of a theme: that of the scale where one end is bad, a diverging
/// one where both are, viridis where no value is better than another, categories for regions. In all of them, lightness
/// tells bad from good without red and green.
ColourMap mapOf(Measure measure, QualityScale scale, ThemeKind theme);

/// Returns the range of the colours of a measure that does not depend on the mesh, so that meshes can be compared. None
/// for measures without a scale of good and bad.
std::optional<ColourRange> fixedRange(Measure measure);

/// Returns the range of colours that shows the differences within a mesh: a few extreme values, up to a hundredth of
/// them, do not widen it.
ColourRange fittedRange(Measure measure, const MeasureSummary &summary);

/// Returns the histogram of a measure: over the full range for α, δ and angles, over the range of the values for other
/// measures.
MeasureHistogram shownHistogram(Measure measure, std::span<const double> values, const MeasureSummary &summary);

/// Returns the position of a value on the colour map of a measure; may lie outside [0, 1].
double mapPosition(Measure measure, const ColourRange &range, double value);
/// Returns the value at a position on the colour map of a measure, except that of regions.
double mapValue(Measure measure, const ColourRange &range, double at);

/// Returns the colour of a region, also that of its elements.
Colour regionColour(std::int32_t tag);

} // namespace forefront
