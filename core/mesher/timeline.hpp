#pragma once

#include "core/mesher/mesher.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// A run with a journal of its advances. Its position moves forward and back, in constant time for each advance.
class Timeline {
  public:
    explicit Timeline(std::unique_ptr<Mesher> mesher);

    /// The number of advances at this position, and at the furthest position reached so far.
    std::uint64_t position() const { return position_; }
    std::uint64_t known() const { return deltas_.size(); }
    /// The number of segments of Γ at the start.
    std::uint64_t segmentsAtStart() const { return segmentsAtStart_; }
    /// True once the end of the run has been reached; known() is the end.
    bool complete() const { return complete_; }

    /// Moves `count` advances forward, or fewer at the end, and returns their number.
    std::uint64_t forward(std::uint64_t count);
    /// Moves `count` advances back, or fewer at the start, and returns their number.
    std::uint64_t back(std::uint64_t count);

    /// Positions at which a layer of the front was completed, ascending. A layer is as many advances as Γ had segments
    /// when the layer began: about once around the front, since shortest-first leaves no rings to count.
    const std::vector<std::uint64_t> &layerEnds() const { return layerEnds_; }
    /// The delta of the advance from position p to p + 1; p < known().
    const AdvanceDelta &delta(std::uint64_t p) const { return deltas_[p]; }

    Mesher &mesher() { return *mesher_; }
    const Mesher &mesher() const { return *mesher_; }

  private:
    void followLayers(std::uint64_t from);

    std::unique_ptr<Mesher> mesher_;
    std::vector<AdvanceDelta> deltas_;
    std::vector<AdvanceDelta> again_; ///< deltas of repeated advances
    std::uint64_t position_ = 0;
    bool complete_ = false;
    std::vector<std::uint64_t> layerEnds_;
    std::uint64_t layerLeft_ = 0; ///< advances to the end of the current layer
    std::uint64_t segmentsAtStart_ = 0;
    std::uint64_t segments_ = 0; ///< of Γ at the position known()
};

} // namespace forefront
