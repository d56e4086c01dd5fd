#pragma once

#include "core/engine/mesher/mesher.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// A run with a journal of its advances. Its position moves forward and back, in constant time for each advance, or
/// jumps to checkpoints kept on the way. They number at most kMaxCheckpoints, take at most kMaxCheckpointBytes of
/// memory (but for the first), and lie about equally far apart. Work counters depend on the position alone, not on the
/// way there.
class Timeline {
  public:
    /// `stride`: distance of the first checkpoints, in advances; to repeat that many takes a few milliseconds.
    explicit Timeline(std::unique_ptr<Mesher> mesher, std::uint64_t stride = 4096);

    /// Returns the number of advances at this position; known() is that at the furthest position reached so far.
    std::uint64_t position() const { return position_; }
    std::uint64_t known() const { return deltas_.size(); }
    /// Returns the number of segments of Γ at the start.
    std::uint64_t segmentsAtStart() const { return segmentsAtStart_; }
    /// Returns true once the end of the run has been reached; known() is the end.
    bool complete() const { return complete_; }

    static constexpr std::size_t kMaxCheckpoints = 96;
    static constexpr std::size_t kMaxCheckpointBytes = std::size_t{128} << 20U;

    /// Jumps to the checkpoint from which `target` is reached soonest, unless the current position is
    /// closer.
    void approach(std::uint64_t target);
    std::size_t checkpoints() const { return checkpoints_.size(); }
    std::size_t checkpointBytes() const { return checkpointBytes_; }

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
    struct Kept {
        std::uint64_t position;
        Checkpoint state;
    };
    std::uint64_t repeat(std::uint64_t count);
    std::uint64_t continueRun(std::uint64_t count);
    void followLayers(std::uint64_t from);
    void keepCheckpoint();
    void thinCheckpoints();
    std::uint64_t nextCheckpoint() const;
    /// Returns the last checkpoint at or before a position; never null, since the first one is at the start.
    const Kept &checkpointBefore(std::uint64_t position) const;
    void restore(const Kept &checkpoint);

    std::unique_ptr<Mesher> mesher_;
    std::vector<AdvanceDelta> deltas_;
    std::vector<AdvanceDelta> again_; ///< deltas of repeated advances
    std::uint64_t position_ = 0;
    std::uint64_t floor_ = 0; ///< the run cannot retreat beyond this position
    std::vector<Kept> checkpoints_;
    std::size_t checkpointBytes_ = 0;
    std::uint64_t stride_;
    MadeSoFar made_; ///< up to known()
    bool complete_ = false;
    std::vector<std::uint64_t> layerEnds_;
    std::uint64_t layerLeft_ = 0; ///< advances to the end of the current layer
    std::uint64_t segmentsAtStart_ = 0;
    std::uint64_t segments_ = 0; ///< of Γ at the position known()
};

} // namespace forefront
