#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

/// Tells what has become of the parts of shapes after a command: nodes are found again by their places and those of
/// their neighbours, and segments by their ends. Keeps references to both documents.
class CarriedParts {
  public:
    /// Follows the parts of the constraints of `next`.
    CarriedParts(const Document &before, const Document &next);
    /// Follows these parts of `before`.
    CarriedParts(const Document &before, const Document &next, std::span<const SketchPart> parts);

    /// Returns true if a shape was removed, or its parts have other indices now.
    bool changed(std::uint32_t shape) const { return changed_.contains(shape); }
    /// Returns the parts that a part has become: several for a divided segment, from its start on; none if it is gone.
    std::vector<SketchPart> images(const SketchPart &part) const;
    /// Returns the first of these; the part itself if it is gone.
    SketchPart image(const SketchPart &part) const;
    /// Returns true if a straight segment has become a shorter one of the same line, as beside a fillet.
    bool isShortened(const SketchPart &part) const;
    /// Returns the node at the end of a segment of a path, or of the side of a rectangle.
    SketchPart endOf(const SketchPart &segment) const;

  private:
    void follow(std::span<const SketchPart> parts);
    void findAdded();
    std::optional<SketchPart> node(const SketchPart &part) const;
    std::vector<SketchPart> segment(const SketchPart &part) const;
    /// Returns the longest straight segment that a straight one of a path was shortened to.
    std::optional<SketchPart> shortened(const SketchPart &part) const;
    std::optional<SketchPart> nodeIn(const Shape &shape, const std::vector<Vec2> &old, bool loop,
                                     std::uint32_t index) const;

    const Document &before_, &next_;
    std::set<std::uint32_t> changed_;
    std::vector<std::uint32_t> added_; ///< shapes that only `next` has
};

} // namespace forefront
