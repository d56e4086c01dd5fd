#pragma once

#include "core/engine/base/vec2.hpp"

#include <string>

namespace forefront {

class CanvasPainter;
struct LayerFrame;
struct Moment;

/// Draws the label of A, B or C beside its point `at`: at the place near it that covers the fewest lines of the front
/// and of the advance, and no candidate and no other label, as near to the direction `away` as possible. A label that
/// is not next to its point has a leader.
void labelOfAdvance(CanvasPainter &painter, const LayerFrame &frame, const Moment &moment, Vec2 at, Vec2 away,
                    const std::string &text);

} // namespace forefront
