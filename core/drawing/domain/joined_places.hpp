#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <utility>
#include <vector>

namespace forefront {

/// The places at which nodes of different shapes are one node of the domain although they were not drawn at exactly the
/// same place: see samePlaceDistance(). The shape that was drawn first keeps its nodes; those of circles, ellipses,
/// slots and rounded rectangles stay. A shape with two nodes that near to a place joins it with neither but the
/// nearest.
class JoinedPlaces {
  public:
    /// `tolerance`: how near places are to be one; the distance of samePlaceDistance(), or less.
    JoinedPlaces(const Document &document, double tolerance);

    /// Returns the place of the node that a node at `place` becomes.
    Vec2 of(Vec2 place) const;
    /// Moves the nodes of an outline to the places where they are joined; curves move with their ends.
    void apply(Outline &outline) const;
    /// Returns the greatest distance that a node moves.
    double farthest() const;

  private:
    std::vector<std::pair<Vec2, Vec2>> moves_; ///< from, to; in the order of comesBefore()
};

} // namespace forefront
