#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <memory>
#include <set>

namespace forefront {

/// Makes joints exact where what follows a moved shape, found one step after another, has left them open: nodes on
/// sides that cannot keep their places along them, rectangles that several neighbours pull.
///
/// Finds the joints once for a drag, as long as the same nodes move.
class JointCorrection {
  public:
    /// `start`: the drawing that has the joints.
    explicit JointCorrection(std::shared_ptr<const Document> start);
    ~JointCorrection();
    JointCorrection(JointCorrection &&) noexcept;
    JointCorrection &operator=(JointCorrection &&) noexcept;

    /// Returns a drawing in which nodes have moved, with no joint wider open than at the start. What is `given` stays
    /// where it is there, and the rest of its shapes too if possible; neighbours move as little as possible. Unchanged
    /// if all joints hold. `apart`: nodes of paths and points that have left their joints at the start for those where
    /// they are now. Error: joint-conflict, if what is given cannot have its place.
    Result<Document> correct(Document moved, const std::set<NodeRef> &given, const std::set<NodeRef> &apart);

  private:
    class State;
    std::unique_ptr<State> state_;
};

} // namespace forefront
