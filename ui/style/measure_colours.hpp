#pragma once

#include "core/engine/mesh/measures.hpp"
#include "ui/style/colour_map.hpp"

#include <cstdint>
#include <span>

namespace forefront {

/// Returns the colour map of a measure: cividis, bright where the mesh is good; the diverging map where both ends are
/// bad; viridis where no value is better than another; categories for regions. All of them are safe for the
/// colour-blind.
ColourMap mapOf(Measure measure);

/// Returns the range of colours that shows the differences within a mesh: a few extreme values, up to a hundredth of
/// them, do not widen it.
ColourRange fittedRange(Measure measure, const MeasureSummary &summary);

/// Returns the histogram of a measure: over the full range for α, δ and angles, over the range of the values for other
/// measures.
MeasureHistogram shownHistogram(Measure measure, std::span<const double> values, const MeasureSummary &summary);

/// Returns the position of a value on the colour map of a measure; may lie outside [0, 1].
double mapPosition(Measure measure, const ColourRange &range, double value);

/// Returns the colour of a region, also that of its elements.
Colour regionColour(std::int32_t tag);

} // namespace forefront
