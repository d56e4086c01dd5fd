#pragma once

#include "core/engine/improve/improve_workspace.hpp"
#include "core/engine/improve/shape_measure.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// Searches the place of a free node at which the worst element around it is best, by a pattern search in eight
/// directions (R. Hooke, T. A. Jeeves, 1961). The mesh stays as it is.
class PatternSearch {
  public:
    /// The end of a search.
    struct Limits {
        int patterns;   ///< maximum number of patterns tried
        double minStep; ///< the steps are halved down to this, in units of the distance of the farthest node
    };

    explicit PatternSearch(const ShapeMeasure &measure) : measure_(measure) {}

    /// Returns the best way to move a node; zero if nothing is better than its place, or if all elements around it meet
    /// the goal.
    Vec2 bestMove(const ImproveWorkspace &work, NodeId node, const Limits &limits);

    /// Returns the elements around the node of the last search.
    std::span<const std::uint32_t> elements() const { return {elements_.data(), count_}; }

  private:
    static constexpr std::size_t kDirections = 8;
    using Lanes = std::array<double, kDirections>;

    void take(const ImproveWorkspace &work, NodeId node);
    double measureHere() const;
    bool tryPattern(double step);

    const ShapeMeasure &measure_;
    // The surroundings of the node: element i has the node, nodes_[i] and nodes_[i+1].
    std::array<Vec2, ImproveWorkspace::kMaxValence + 1>
        nodes_;                                               ///< relative to where the node was; the first again last
    std::array<double, ImproveWorkspace::kMaxValence> sides_; ///< squared length of the side opposite the node
    std::array<std::uint32_t, ImproveWorkspace::kMaxValence> elements_;
    std::size_t count_ = 0;
    double reach_ = 0.0; ///< distance of the farthest node

    Vec2 best_;
    double bestMeasure_ = 0.0;
    std::size_t first_ = 0; ///< the element that ended the last pattern, which likely ends the next one
};

} // namespace forefront
