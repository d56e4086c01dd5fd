#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// Moves the shapes of a document so that its constraints hold after a command, nearest to where they were before.
///
/// Only the independent parts of the sketch that the command changed are solved; what held before, or was already
/// violated in a file, keeps its bits. Moved nodes stay where the command put them if the other parts can follow, else
/// they come as near as the constraints allow. Numbers with formulas and locked shapes stay. Error:
/// constraint-conflict names a minimal set of constraints that cannot hold together; the document is then unchanged.
///
/// Joints hold like constraints: nodes of the next document at the same place and on segments, as far as they are
/// linked with what constraints name. To detach a node, move it away from the others first. Joints are named in
/// conflicts by their places.
Result<Document> settle(const Document &before, const Document &next);

/// Does the same after formulas have moved nodes by themselves: the joints are those of the document before, also of
/// shapes that no constraint names, and take others along. A joint whose sides formulas both give may come apart.
Result<Document> settleTogether(const Document &before, const Document &next);

} // namespace forefront
