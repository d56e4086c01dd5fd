#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

class JointIndex;

/// Inserts nodes that a command inserted into a segment of a path also into the other paths that share the segment, and
/// removes nodes likewise. `index`: of the document before the command. Error: joined-node, if a removed node joins
/// other shapes that need it.
Result<Document> editSharedSegments(const JointIndex &index, Document after);

/// Deletes what is selected. Error: joined-node, if with a selected node a shape would go that is joined with others
/// there: a line of two nodes or a triangle, which a node alone was not meant to remove.
Result<Document> deleteUnlessJoined(const JointIndex &index, const Selection &selection);

} // namespace forefront
