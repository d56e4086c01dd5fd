#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <optional>
#include <set>

namespace forefront {

/// Returns true if a handle of a shape exists and can have a size: it is not the centre of a circle or an ellipse.
bool canHaveSize(const Shape &shape, std::uint32_t handle);

/// Sets the size and growth of nodes; nullopt removes them. Errors: bad-size, no-such-node, no-such-shape.
Result<Document> setNodeSize(const Document &document, const std::set<NodeRef> &nodes, std::optional<PartSize> size);

/// A change of the sizes of nodes; unset members leave their values unchanged.
struct NodeSizeChange {
    std::optional<double> size;
    std::optional<double> growth; ///< for nodes that have a size
};
/// Changes the size or the growth of nodes that may differ in the other. Errors as for setNodeSize().
Result<Document> changeNodeSizes(const Document &document, const std::set<NodeRef> &nodes,
                                 const NodeSizeChange &change);

/// Gives the nodes of a shape within `reach` of a place a size. Of two sizes at a node, the smaller one stays. Returns
/// false if there is no such node.
bool giveSize(Shape &shape, Vec2 at, const PartSize &size, double reach);

/// Gives the nodes of a shape the sizes of the nodes of another shape at the same coordinates, up to rounding.
void takeNodeSizes(Shape &shape, const Shape &from);

/// Replaces the sizes of a shape whose list of nodes has changed by those that it had at the same places before.
void keepNodeSizes(Shape &shape, const Shape &before);

/// Replaces the sizes of a shape by those that it had before: each goes to the nearest node, or to several that are
/// equally near.
void moveNodeSizes(Shape &shape, const Shape &before);

/// Makes the first node of a rectangle its lower left corner and the second its upper right one, at new places. Sizes
/// stay at their corners.
void placeBox(Shape &rectangle, Vec2 low, Vec2 high);

/// Returns the faults of the sizes of a shape's nodes. Code: bad-size.
Diagnostics checkNodeSizes(const Shape &shape);

/// Returns the name of a node: "node 3 of quay".
std::string nodeName(const Shape &shape, std::uint32_t handle);

} // namespace forefront
