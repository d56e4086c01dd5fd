#pragma once

#include "core/engine/base/vec2.hpp"
#include "ui/style/colour.hpp"

#include <string>

namespace forefront {

class CanvasPainter;
struct LayerFrame;
struct Moment;

/// Length in design pixels above which a base has labels; a little less than that to which the camera zooms.
constexpr double kLabelledBase = 56.0;

/// A label beside a point of the advance.
struct AdvanceLabel {
    Vec2 at;
    Vec2 away; ///< the direction from the point that is best
    std::string text;
    Colour colour;
    bool optional = false; ///< it is left out where it would cover another label
};

/// Draws a label beside its point: at the place near it that covers the fewest lines of the front and of the advance,
/// and no candidate and no other label, as near to the best direction as possible. A label that is not next to its
/// point has a leader.
void labelOfAdvance(CanvasPainter &painter, const LayerFrame &frame, const Moment &moment, const AdvanceLabel &label);

} // namespace forefront
