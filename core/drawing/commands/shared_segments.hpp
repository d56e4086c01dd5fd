#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

class JointIndex;

/// Inserts nodes that a command inserted into a segment of a path also into the other paths that share the segment, and
/// removes nodes likewise. `index`: of the document before the command. Error: joined-node, if a removed node joins
/// other shapes that need it.
Result<Document> editSharedSegments(const JointIndex &index, Document after);

} // namespace forefront
