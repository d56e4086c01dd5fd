#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/files/source/source.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// The role of an SVG path in the domain.
enum class PathRole : std::uint8_t { Painted, Stroke, Outline, Line, LeftOut, Nothing };

/// Decides the roles of the paths of a drawing. Filled shapes, if any, are the domain, and strokes are lines in it;
/// otherwise closed strokes are outlines. Closed paths with neither, such as the frames of icons, count only if there
/// are no such shapes or strokes.
class SvgRoles {
  public:
    /// `cropsFill`: a filled shape was cropped away. The source outlives the roles.
    SvgRoles(const SourceText &source, std::span<const SvgPath> paths, bool cropsFill);

    /// Returns true if something is filled.
    bool anyPainted() const { return anyPainted_; }
    PathRole of(const SvgPath &path) const;

    /// Reports, once per element, how it is read if that differs from how it looks.
    void noteReading(const SvgPath &path, PathRole role);
    /// Reports that filled shapes with names of their own are merged.
    void noteMerged(std::span<const SvgPath> paths) const;

  private:
    const SourceText &source_;
    bool anyPainted_;
    bool anyStroked_ = false;
    std::size_t noted_ = static_cast<std::size_t>(-1); ///< the element of the last path
};

} // namespace forefront
