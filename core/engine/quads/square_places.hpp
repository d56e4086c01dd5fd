#pragma once

#include "core/engine/front/generation_front.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesher/fan.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <numbers>

namespace forefront {

/// Wider corners of Γ, in radians, do not continue a row of squares.
inline constexpr double kRowCorner = 125.0 * std::numbers::pi / 180.0;

/// Returns true if the triangle abc is counter-clockwise (exact).
inline bool turnsLeft(Vec2 a, Vec2 b, Vec2 c) {
    return orientation(a, b, c) > 0;
}

/// Places the fourth node of the square over the corner P X N of a fan: at the mean of the places that the free angles
/// at P and N and the node spacing lead to. Returns false if the square would be badly shaped. `size`: mean of the new
/// sides, in domain units; unchanged where the corners beside leave no room.
bool placeInRow(const GenerationFront &front, const SpacingField &spacing, Fan &fan, double &size);

/// Places the two new nodes of a square over a leg, in fans with one new node each. Returns false if it would be badly
/// shaped or too small. `size`: mean of the sides beside the leg, in domain units.
bool placeOpening(const GenerationFront &front, const SpacingField &spacing, SlotId id, Fan &overB, Fan &overA,
                  double &size);

} // namespace forefront
