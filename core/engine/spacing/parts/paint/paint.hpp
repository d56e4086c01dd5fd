#pragma once

#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

namespace forefront {

/// The effect of a dab on the spacing.
enum class DabMode : std::uint8_t {
    Set,     ///< towards a target
    Finer,   ///< smaller than it is
    Coarser, ///< larger than it is
    Smooth,  ///< towards the mean of the surroundings
    Erase    ///< removes the paint
};

template <>
struct EnumWords<DabMode> {
    static constexpr auto kLast = DabMode::Erase;
    static constexpr std::array<std::string_view, 5> kList = {"set", "finer", "coarser", "smooth", "erase"};
};

/// One dab of the brush.
struct Dab {
    Vec2 centre;
    double radius = 1.0;  ///< > 0
    double spacing = 0.1; ///< target in the core, > 0
    double hardness =
        0.7; ///< size of the core as a fraction of the radius, 0..1; between core and radius the paint fades out
    /// Spacing that the paint fades into where nothing is painted yet, such as ρ at the centre before the stroke. With
    /// 0 the paint ends in the middle of the fading rim, and gradation blends it outwards.
    double ambient = 0.0;
    DabMode mode = DabMode::Set;
    /// Effect of a dab, 0..1: the fraction of the way to the target or the mean; for Finer and Coarser, 1 halves or
    /// doubles the spacing in eight dabs, about as many as overlap within a stroke. It starts from the paint, or from
    /// `ambient` where nothing is painted; without either, Set paints its target, and Coarser and Smooth leave the node
    /// unpainted. 0 changes nothing.
    double strength = 1.0;
    /// Spacing at unpainted nodes before the stroke, in place of `ambient`. With it, every mode starts from the spacing
    /// at the node itself and fades into it, so the paint can replace it without a step.
    std::function<double(Vec2)> around{};
};

/// Maximum diameter of a dab in pitches, which limits its tiles to 4 MB; wider dabs are reduced to it.
inline constexpr double kWidestDab = 512.0;

/// Returns an empty canvas for a domain. Its pitch is a power of two between 1/1024 and 1/512 of the box's diagonal, so
/// painting the whole domain needs at most about 4 MB.
PaintedSpacing emptyPaint(const Box2 &domain);

/// Returns the paint after a dab; unchanged tiles are shared with `before`. The node nearest to the centre is painted
/// even if the radius is smaller than the pitch. Blending is geometric: spacings 1 and 0.01 meet at 0.1. A dab with
/// invalid numbers (not finite, sizes <= 0) changes nothing. Deterministic.
PaintedSpacing paint(const PaintedSpacing &before, const Dab &dab);

/// Returns paint that replaces the other rules without changing the spacing: values above `spacing`, which had no
/// effect, are reduced to it. Paint that already replaces them is returned unchanged.
PaintedSpacing replacing(const PaintedSpacing &paint, const std::function<double(Vec2)> &spacing);

/// Returns the paint with the nodes in a box painted; those for which `size` returns 0 keep their value. At most 4
/// million nodes of the box are visited.
PaintedSpacing fill(const PaintedSpacing &before, const Box2 &box, const std::function<double(Vec2)> &size);

/// Returns the paint without the nodes within `radius` of `centre`; empty tiles are removed.
PaintedSpacing erase(const PaintedSpacing &before, Vec2 centre, double radius);

/// Returns the value at node (i, j), counted from the origin; 0 if unpainted.
float paintedNode(const PaintedSpacing &paint, std::int32_t i, std::int32_t j);

} // namespace forefront
