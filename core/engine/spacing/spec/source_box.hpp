#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstddef>

namespace forefront {

/// The rectangle of a box source. A turn by 90 degrees about its centre exchanges its sides, so its angle counts modulo
/// 90 degrees.
class SourceBox {
  public:
    /// Takes the corners and the angle of a source of any shape.
    explicit SourceBox(const SizeSource &source);

    /// Returns the corners in order around the box: SizeSource::a first, SizeSource::b third.
    std::array<Vec2, 4> corners() const { return corners_; }
    Vec2 centre() const { return midpoint(corners_[0], corners_[2]); }
    /// Returns the distance from the box, 0 inside it.
    double distanceTo(Vec2 p) const;

  private:
    std::array<Vec2, 4> corners_;
    Vec2 along_; ///< unit vector of the first side
    Vec2 half_;  ///< half the lengths of the sides
};

/// Moves a corner of a box source, by its place in SourceBox::corners(); the opposite corner and the angle stay.
void moveCorner(SizeSource &source, std::size_t corner, Vec2 to);

/// Returns the lengths of the sides of a box source: along its angle, and across it.
Vec2 boxExtent(const SizeSource &source);

/// Gives a box source other lengths of its sides; SizeSource::a and the angle stay.
void resizeBox(SizeSource &source, Vec2 extent);

/// Turns a box source about its centre to an angle in degrees; the lengths of its sides stay.
void turnBox(SizeSource &source, double degrees);

/// Returns an angle that gives the same box, in (-45, 45] degrees.
double boxAngle(double degrees);

} // namespace forefront
