#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "tests/support/random_curves.hpp"

#include <cstdint>
#include <vector>

namespace forefront::testing {

/// Adds closed loops and lines of curves to the input of an arrangement, as chords.
class CurveDrawing {
  public:
    /// `deviation`: maximum distance of chords from their curves.
    explicit CurveDrawing(double deviation) : deviation_(deviation) {}

    /// Adds a closed loop as a separate feature, or to a contour. Returns the tag of the feature.
    std::int32_t feature(const CurveLoop &curves);
    void loop(const CurveLoop &curves, std::uint32_t contour, std::int32_t tag);
    void line(const CurveLoop &curves, std::int32_t tag);
    void point(Vec2 at) { input.addPoint(at, 3); }

    ArrangementInput input;

  private:
    void flatten(const CurveLoop &curves);

    double deviation_;
    std::vector<Vec2> nodes_;
    std::vector<CurveStretch> stretches_;
};

} // namespace forefront::testing
