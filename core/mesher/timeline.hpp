#pragma once

#include "core/mesher/mesher.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// A run with its journal: a position that goes forward and back, one advance at a time in constant time.
class Timeline {
  public:
    explicit Timeline(std::unique_ptr<Mesher> mesher);

    /// Advances done at this position, and the furthest position reached so far.
    std::uint64_t position() const { return position_; }
    std::uint64_t known() const { return deltas_.size(); }
    /// The end of the run has been reached once: known() is the end.
    bool complete() const { return complete_; }

    /// Up to `count` advances forward; returns how many (fewer only at the end).
    std::uint64_t forward(std::uint64_t count);
    /// Up to `count` advances back; returns how many.
    std::uint64_t back(std::uint64_t count);

    /// Positions at which a layer of the front was completed, rising. A layer is as many advances as Γ had segments
    /// when it began: the front once around, since shortest-first leaves no rings to count.
    const std::vector<std::uint64_t> &layerEnds() const { return layerEnds_; }
    /// What the advance from position p to p + 1 did; p < known().
    const AdvanceDelta &delta(std::uint64_t p) const { return deltas_[p]; }

    Mesher &mesher() { return *mesher_; }
    const Mesher &mesher() const { return *mesher_; }

  private:
    void followLayers(std::uint64_t from);

    std::unique_ptr<Mesher> mesher_;
    std::vector<AdvanceDelta> deltas_;
    std::vector<AdvanceDelta> again_; ///< of advances done once more
    std::uint64_t position_ = 0;
    bool complete_ = false;
    std::vector<std::uint64_t> layerEnds_;
    std::uint64_t layerLeft_ = 0; ///< advances to the end of the present layer
    std::uint64_t segments_ = 0;  ///< of Γ at the furthest position known
};

} // namespace forefront
