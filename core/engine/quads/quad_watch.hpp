#pragma once

#include "core/engine/improve/improve_watch.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

class QuadWorkspace;

/// The parts of a mesh of quadrilaterals that a change may have affected.
struct ChangedCells {
    bool all = true; ///< any; the lists are empty
    std::span<const std::uint32_t> nodes{}, cells{};
    std::size_t refused = 0; ///< changes tried at the same node before, which did not pay
};

/// Receives each change that joining and cleaning up make to a mesh of quadrilaterals, in order, on the thread that
/// makes them. The mesh does not depend on it.
class QuadWatch {
  public:
    virtual ~QuadWatch() = default;
    /// Returns true if it wants each sweep of smoothing, rather than a few of them at once.
    virtual bool wantsSweeps() const = 0;
    /// Called after a change.
    virtual void changed(ImproveChange change, const QuadWorkspace &mesh, const ChangedCells &parts) = 0;
};

} // namespace forefront
