#pragma once

#include "core/base/vec2.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

namespace forefront {

/// One touch of the brush.
struct Dab {
    Vec2 centre;
    double radius = 1.0;   ///< > 0
    double spacing = 0.1;  ///< wanted in the core, > 0
    double hardness = 0.7; ///< the core is this part of the radius, 0..1; beyond, the paint fades out to the radius
    /// Spacing that the paint fades into where nothing is painted yet, for example ρ at the centre before the stroke.
    /// 0: the paint ends in the middle of the fading rim instead, and gradation blends it outwards.
    double ambient = 0.0;
};

/// A dab wider than this many pitches is cut to it: 4 MB of tiles at the worst. Choose a coarser pitch for wider ones.
inline constexpr double kWidestDab = 512.0;

/// An empty canvas for a domain: lattice pitch a power of two between 1/1024 and 1/512 of the box's diagonal, so that
/// painting the whole domain needs at most about 4 MB.
PaintedSpacing emptyPaint(const Box2 &domain);

/// The paint after a dab; tiles it does not change are shared with `before`. The node nearest to the centre is painted
/// even where the radius is smaller than the pitch. Blending is geometric: spacings 1 and 0.01 meet in 0.1.
/// Unusable numbers (not finite, sizes <= 0) change nothing. Deterministic.
PaintedSpacing paint(const PaintedSpacing &before, const Dab &dab);

/// The paint with the nodes within `radius` of `centre` unpainted; empty tiles vanish.
PaintedSpacing erase(const PaintedSpacing &before, Vec2 centre, double radius);

/// Value at lattice node (i, j), counted from the origin; 0: unpainted.
float paintedNode(const PaintedSpacing &paint, std::int32_t i, std::int32_t j);

} // namespace forefront
