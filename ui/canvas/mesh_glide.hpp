#pragma once

#include "core/engine/session/snapshot.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace forefront {

/// Moves the nodes of the mesh smoothly along a step of the improvement, forward or back, when the run takes one.
class MeshGlide {
  public:
    /// Maximum number of elements of a mesh that glides; a larger one is shown at its target at once.
    static constexpr std::size_t kMaxElements = 20'000;

    /// Notes what the run shows. Returns true if it has taken one step, or moved to the improvement in another way.
    bool follow(const SessionSnapshot &run);
    /// Returns the mesh on its way: where it comes from with `left` 1, at its target with 0. Null: nothing glides.
    std::shared_ptr<const MeshSnapshot> at(double left);

  private:
    std::uint64_t run_ = 0;
    std::size_t position_ = 0; ///< steps of the improvement
    bool improving_ = false;   ///< the front is done at this position
    std::shared_ptr<const ImproveStep> step_;
    std::shared_ptr<const MeshSnapshot> mesh_;
    std::vector<ImproveStep::Move> moves_; ///< in the mesh, from where they begin to where they end
    std::uint64_t pictures_ = 0;
};

} // namespace forefront
