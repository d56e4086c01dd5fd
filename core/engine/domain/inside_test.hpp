#pragma once

#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/geometry/box_tree.hpp"

namespace forefront {

/// Tells which places lie inside a domain, by its chords. O(log n) for each place.
class InsideTest {
  public:
    explicit InsideTest(const DomainFaces &found);

    /// Returns true if nothing is inside.
    bool empty() const { return walls_.empty(); }
    /// Returns true if p is inside or on the boundary.
    bool contains(Vec2 p) const;
    /// Returns true if a part of the boundary between inside and outside meets the box.
    bool boundaryMeets(const Box2 &box) const;
    /// Returns true if any part of the box may be inside.
    bool meets(const Box2 &box) const { return boundaryMeets(box) || contains(box.centre()); }
    /// Returns true if a part of the boundary crosses or touches the segment from a to b.
    bool boundaryCrosses(Vec2 a, Vec2 b) const;

  private:
    struct Wall {
        Vec2 a, b; ///< a.x <= b.x
    };
    std::vector<Wall> walls_;
    BoxTree tree_; ///< of the walls
};

} // namespace forefront
