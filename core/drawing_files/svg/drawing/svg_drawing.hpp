#pragma once

#include "core/drawing_files/svg/style/svg_paint.hpp"
#include "core/drawing_files/svg/values/svg_transform.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/curve.hpp"
#include "core/files/source/source.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A polyline of a drawing in the coordinates of the domain, with the curves that it follows.
struct SvgPath {
    std::vector<Vec2> nodes;
    std::vector<Curve> curves;
    std::vector<CurveStretch> stretches; ///< per segment between consecutive nodes
    bool closed = false;
    bool joined = false;      ///< closed only because it ends where it begins
    double rounding = 0.0;    ///< how far apart the rounded digits of its data may leave its ends
    bool isLine = false;      ///< of a <line> or <polyline>
    SvgPaint paint;           ///< transparent paint counts as none
    double strokeWidth = 0.0; ///< in domain units; 0 without a stroke, or if it does not scale with the drawing
    bool strokeArea = false;  ///< the painted area of the stroke counts as area
    AffineMap frame;          ///< maps the user space, in which the stroke is drawn, to the domain
    std::size_t element = 0;  ///< number of the element that it is a subpath of
    std::string name;
    std::size_t offset = 0;        ///< of its element in the text
    std::uint32_t limit = kNoClip; ///< the clip that limits it, in SvgPaths::clips
    bool removes = false;          ///< as a part of a mask: hides the area that it covers

    /// Returns the box of the nodes.
    Box2 box() const;
    /// Returns the box of the nodes and curves.
    Box2 bounds() const;
    /// Returns half of the width of the stroke, in domain units; 0 if it does not count as area.
    double reach() const;
    /// Returns how far from the path the corners and ends of its stroke may reach.
    double farthestReach() const;
    /// Returns true for an open polyline with a stroke and the default fill. Many are drawn so, without fill="none".
    bool drawnAsLine() const;
    /// Returns true if the path is filled, and not drawn as a line.
    bool painted() const;
    /// Returns true if the path is painted, or its stroke counts as area.
    bool covers() const;
};

enum class SvgClipKind : std::uint8_t {
    ClipPath,
    LuminanceMask,
    AlphaMask,
    Viewport ///< the rectangle of the page, a nested <svg>, a <symbol> or a mask
};

/// The area that a clip path or mask leaves visible, as an ArrangementClip: of its parts, the last one that covers a
/// place decides.
struct SvgClip {
    std::uint32_t within = kNoClip; ///< the clip around it; has a smaller index
    SvgClipKind kind = SvgClipKind::ClipPath;
    std::vector<SvgPath> parts = {};
    AffineMap frame = {};  ///< of a Viewport: maps the unit square to it
    std::string name = {}; ///< of parts without a name
};

struct SvgPaths {
    std::vector<SvgPath> paths;
    std::vector<SvgClip> clips;
    double size = 0.0;      ///< diagonal of the visible box
    double tolerance = 0.0; ///< of the polylines
    bool cropsFill = false; ///< a filled shape was cropped to the surroundings of the page, perhaps to nothing
};

/// Returns the visible shapes of an SVG drawing as polylines, those drawn by <use> included, in the order of painting.
/// Notes name everything left out.
Result<SvgPaths> drawnPaths(const SourceText &source);

} // namespace forefront
