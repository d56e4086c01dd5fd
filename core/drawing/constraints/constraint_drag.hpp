#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"

#include <memory>
#include <set>

namespace forefront {

/// A drag of shapes that constraints bind, from the document where it began. Each step gives the solution nearest to
/// that document, with what is dragged near the pointer, so that the way back leads to the same drawing. Joints hold,
/// see settle().
class ConstraintDrag {
  public:
    /// `apart`: nodes that leave the joints with others. `grabbed`: the nodes that the pointer moves, so that what
    /// follows them may stay behind; empty: whatever moves.
    explicit ConstraintDrag(std::shared_ptr<const Document> start, const std::set<NodeRef> &apart = {},
                            std::set<NodeRef> grabbed = {});
    ~ConstraintDrag();
    ConstraintDrag(ConstraintDrag &&) noexcept;
    ConstraintDrag &operator=(ConstraintDrag &&) noexcept;

    /// Returns a step of the drag: `moved` is the start with nodes or shapes moved by the pointer, and the same parts.
    /// What is grabbed gets its place there exactly if there is a solution near by; else it comes as near as the
    /// constraints let it, and where no solution is found, it stays as in the step before. Parts that no constraint
    /// names are as in `moved`.
    Document carry(const Document &moved);

  private:
    class State;
    std::unique_ptr<State> state_;
};

} // namespace forefront
