#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spec/spacing_sample.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// Returns true for a line source with different sizes at its ends and for gradients. Other sources are sites, boxes
/// excepted.
bool isGraded(const SizeSource &source);

/// The line sources with different sizes at their ends.
///
/// At a point, the spacing is the size at the nearest point of the line plus the growth times the distance. It changes
/// along the line and away from it, so beside the line it may be steeper than the gradation. There, the largest
/// function with that gradation below it takes over. It is exact unless a minimum spacing is above the sizes: the
/// minimum then cuts off the limited function, which may be smaller beside the line than necessary.
///
/// A gradient over the plane depends on the position along its line alone. Where it is steeper than the gradation, it
/// is limited exactly, too: it is convex from its finer end on, so beyond the place where it gets too steep it grows by
/// the gradation.
class GradedSources {
  public:
    /// Takes the graded sources; std::nullopt if there are none. `gradation` may be infinite; the bounds are over
    /// `box`.
    static std::optional<GradedSources> build(std::span<const SizeSource> sources, double gradation, const Box2 &box);

    double at(Vec2 p) const;
    SpacingSample sample(Vec2 p, const SiteWords &words) const;
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

  private:
    /// A line from its finer end.
    struct Line {
        Vec2 from;
        Vec2 along; ///< of length 1
        double length = 0.0;
        double radius = 0.0;
        double size = 0.0;   ///< at `from`
        double slope = 0.0;  ///< change of the size per unit of length, > 0
        double growth = 0.0; ///< at most the gradation
        double gradation = 0.0;
        bool steep = false; ///< slope and growth together exceed the gradation
        bool plane = false;
        double octaves = 0.0;   ///< of a geometric gradient: its logarithm at the other end over that at `from`
        double steepFrom = 0.0; ///< of a gradient: where along the line it gets as steep as the gradation
        std::uint32_t source = 0;

        double at(Vec2 p) const;
        double limitedAt(double x, double side) const;
        double alongPlane(double x) const;
        double lowerBound(const Box2 &box) const;
        double upperBound(const Box2 &box) const;
    };

    std::vector<Line> lines_;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront
