#pragma once

#include "core/drawing/picking/pick_index.hpp"

#include <set>
#include <vector>

namespace forefront {

/// Returns the parts that a dragged selection can snap to: other shapes, and from its own paths the segments that do
/// not change and the nodes that are neither dragged nor next to a dragged node. Shapes dragged as a whole, and shapes
/// whose handles depend on each other, are left out.
PickIndex::Filter targetsOfDrag(const Document &document, const Selection &dragged);

/// Returns the other ends of the straight segments that follow a dragged node.
std::vector<Vec2> linesToNode(const Document &document, const Selection &dragged, NodeRef node);

/// Returns the nodes that move when a selection is moved, those of whole shapes and the neighbours of a corner of a
/// rectangle included.
std::set<NodeRef> nodesMovedWith(const Document &document, const Selection &selection);

} // namespace forefront
