#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace forefront {

class JointCorrection;
class JointIndex;

/// Carries joints through a command. Handles of paths, rectangles and points at the same place are joined, as are nodes
/// that lie on a straight segment of a path with that segment; within the tolerance at which an import joins lines.
///
/// Where the command has moved a handle, those joined with it move too, and nodes on a moved segment keep their place
/// along it if they can. A node that is moved and lies alone on a side of another shape slides along its sides, also
/// round corners, to the place nearest to where the command put it; a side on which several moved nodes of a shape lie
/// goes with them. Other neighbours move as little as their joints allow. Where two paths share a segment, a node
/// inserted into one is inserted into the other, and a node removed from both sides of it is removed from both; a
/// Bézier segment that they share keeps one form. Corners given for mapped regions go with their nodes. Errors:
/// joined-node if a removed node joins other shapes that need it; joined-locked if a locked shape would have to change;
/// joint-conflict if a neighbour cannot follow. To detach a node, apply the command without this.
Result<Document> carryJoints(const Document &before, const Document &after);

/// The joints of a document, found once so that each step of a drag is cheap. Keeps the document alive. For one thread.
class Joints {
  public:
    explicit Joints(std::shared_ptr<const Document> document);

    const std::shared_ptr<const Document> &document() const { return document_; }
    /// Carries the joints of the document through a command: see carryJoints().
    Result<Document> carry(const Document &after) const;
    /// Returns for each handle of a shape whether it is joined with another one, or lies on a segment; empty if the
    /// handles of the shape cannot be joined.
    std::vector<bool> joinedHandles(std::uint32_t shape) const;
    /// Returns a selection with the handles of other shapes that are at the same places as what moves with it.
    Selection withJoined(const Selection &selection) const;

  private:
    std::shared_ptr<const Document> document_;
    std::shared_ptr<const JointIndex> index_;
    std::shared_ptr<JointCorrection> correction_; ///< keeps the joints of what a drag moves
};

} // namespace forefront
