#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The elements of a mesh of first order with the middle nodes that make them second order. Refers to its parts.
struct RaisedElements {
    Mesh &mesh; ///< its corners
    const EdgeTable &table;
    std::span<const std::uint32_t> ofSide; ///< per side of an element, the number of its middle
    std::vector<Vec2> &middles;
    const std::vector<bool> &curved; ///< per middle; the others are the middles of their edges
};

/// A corner that was moved, and its place before.
struct MovedCorner {
    NodeId node = kNoNode;
    Vec2 from;
};

/// Elements whose minimum Jacobian determinant is below this share of their maximum are improved; see evenJacobians().
inline constexpr double kSoughtUniformity = 0.25;

/// Moves corners of the elements whose Jacobian determinant varies most, until its minimum is kSoughtUniformity of its
/// maximum in each of them, or no move helps. No move lowers the scaled Jacobian of the corners around a node below
/// 0.3, or further where it is lower; where an element would still be reported (kReportedUniformity), below 0.1. The
/// ends of tagged edges, tagged nodes and the nodes of boundaries stay.
/// `movable`: per node, whether it may move; empty: none. Returns each corner moved, once. Ends early when cancelled.
std::vector<MovedCorner> evenJacobians(const RaisedElements &elements, const std::vector<bool> &movable,
                                       const Progress &progress);

} // namespace forefront
