#pragma once

#include "core/drawing/arrangement/cover/united.hpp"
#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/svg/drawing/svg_drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace forefront {

/// Adds the areas that strokes paint to a drawing. Where strokes overlap, or a path bends within its width, nearly all
/// of their parts cross each other. If there are more than a few, their union is added instead: of all strokes, or of
/// each stroke by itself if shapes are regions.
class StrokeAreas {
  public:
    /// `size`: diagonal of the drawing; `tolerance` of polylines along curves.
    StrokeAreas(DrawingBuilder &builder, double size, double tolerance, bool shapeRegions)
        : builder_(builder), size_(size), tolerance_(tolerance), shapeRegions_(shapeRegions) {}

    /// Sets a box that a filled rectangle covers. Strokes in it are dropped before they cross anything.
    void setBackground(const Box2 &box) { background_ = box; }

    /// Adds the stroke of a path to a shape, or keeps it until finish(). Returns false if there are too many nodes.
    bool add(const SvgPath &path, std::uint32_t shape, std::int32_t tag);
    /// Adds the collected strokes, and prefers a tolerance that suits all of them. The union of several strokes becomes
    /// a shape of its own.
    void finish(std::uint32_t feature);

  private:
    OutlinedArea areaOf(const BandPart &part, std::uint32_t stroke) const;
    bool inBackground(const std::vector<OutlinedArea> &areas) const;
    std::vector<OutlinedArea> united(std::vector<OutlinedArea> areas) const;

    DrawingBuilder &builder_;
    double size_;
    double tolerance_;
    bool shapeRegions_;
    Box2 background_;
    std::vector<DrawingBuilder::MadeFrom> strokes_;           ///< those whose parts are added or kept
    std::map<std::uint32_t, std::vector<OutlinedArea>> kept_; ///< by clip
    std::size_t nodes_ = 0;                                   ///< of the outlines of all parts
    double thinnest_ = std::numeric_limits<double>::infinity();
};

} // namespace forefront
