#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace forefront {

inline constexpr Box2 kEverything{{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()},
                                  {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};

/// Returns the intersection of two boxes; an empty box if they are disjoint.
Box2 commonBox(const Box2 &s, const Box2 &t);

/// The boxes outside of which the clips of a drawing show nothing.
class SvgClipBoxes {
  public:
    /// `viewports`: the page and other viewports limit, too; which of them are needed is only known once all paths are.
    SvgClipBoxes(const std::vector<SvgClip> &clips, bool viewports);

    /// Returns the part of a box that a clip leaves, up to its shape.
    Box2 visible(const Box2 &box, std::uint32_t clip) const;

  private:
    std::vector<Box2> boxes_;
};

} // namespace forefront
