#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <set>

namespace forefront {

class JointIndex;

/// A drawing in which what is joined has followed a command.
struct FollowedMove {
    Document document;
    std::set<NodeRef> given;  ///< handles that are where the command put them, which their neighbours followed
    std::set<NodeRef> turned; ///< nodes that slid round a corner, and have left the side that they were on
};

/// Moves what is joined with handles that a command has moved, from shape to shape: those at the same places, and nodes
/// on moved segments, which keep their place along these. A moved node that lies alone on a side of a shape that the
/// command has not moved slides along its sides. Where this leaves joints open, see JointCorrection. `index`: of the
/// document before the command. Error: joined-locked if a locked shape would have to move.
Result<FollowedMove> followJoints(const JointIndex &index, Document after);

} // namespace forefront
