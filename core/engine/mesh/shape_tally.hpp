#pragma once

#include "core/engine/mesh/log_product.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <functional>
#include <limits>
#include <span>

namespace forefront {

/// Accumulates shape figures element by element: α, extreme angles, area.
class ShapeTally {
  public:
    /// Adds a triangle of 3 nodes; its number is count().
    void add(Vec2 a, Vec2 b, Vec2 c);
    /// Adds an element of any kind.
    void add(const PlacedCell &cell);
    std::size_t count() const { return count_; }
    /// Sets the shape figures of `quality`; leaves them unchanged if no element was added.
    void into(MeshQuality &quality) const;

  private:
    /// The extreme angles, kept as cotangents, which fall as the angle grows.
    class CotangentRange {
      public:
        void add(Vec2 a, Vec2 b, Vec2 c);
        /// Adds the angle at the tip, from the edge to `after` to the one to `before`.
        void addAt(Vec2 before, Vec2 tip, Vec2 after);
        double min() const; ///< degrees
        double max() const; ///< degrees
        /// Returns the sine of the minimum angle; infinity if none was added, 0 if one is not positive.
        double sineOfMin() const;

      private:
        double maxCot_ = -std::numeric_limits<double>::infinity();
        double minCot_ = std::numeric_limits<double>::infinity();
        bool flat_ = false;
    };

    /// Counts an element with this α.
    void addAlpha(double alpha);

    std::size_t count_ = 0, flat_ = 0;
    std::array<std::size_t, wordsOf<CellKind>().size()> others_{}; ///< elements by kind, without triangles of 3 nodes
    LogProduct product_;
    CotangentRange angles_;       ///< of triangles of 3 nodes
    CotangentRange cornerAngles_; ///< of the others
    double sum_ = 0.0;
    double twiceArea_ = 0.0;
    double minScaledJacobian_ = std::numeric_limits<double>::infinity(); ///< without triangles of positive area
    double minAlpha_ = std::numeric_limits<double>::infinity();
    ElementId worst_ = kNoElement;
    bool allPositive_ = true;
    std::array<std::uint64_t, kHistogramBins> histogram_{};
};

/// Returns the number of triangles of 3 nodes and their shape figures. `nodesOf`: returns the nodes of one of
/// `elements`, kNoNode for one that is left out.
template <class Elements, class NodesOf>
MeshQuality shapesOf(std::span<const Vec2> nodes, const Elements &elements, const NodesOf &nodesOf) {
    ShapeTally tally;
    for (const auto &element : elements) {
        if (const Element &n = std::invoke(nodesOf, element); n[0] != kNoNode) {
            tally.add(nodes[index(n[0])], nodes[index(n[1])], nodes[index(n[2])]);
        }
    }
    MeshQuality quality;
    tally.into(quality);
    return quality;
}

} // namespace forefront
