#pragma once

#include "core/mesh/shape_tally.hpp"
#include "core/mesher/timeline.hpp"
#include "core/session/snapshot.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace forefront {

/// Copies out of a run what the drawing thread wants, and no more often than it changes. Belongs to one run.
class SnapshotBuilder {
  public:
    /// Versions of the mesh views are counted on from `version`, so that those of two runs differ.
    explicit SnapshotBuilder(std::uint64_t version) : version_(version) {}

    /// Mesh, front, cells and marks of the timeline's position into `snapshot`. `resting`: the run stands still, so
    /// what takes longer may be measured too (all of the quality, the state hash, marks).
    void fill(SessionSnapshot &snapshot, const Timeline &timeline, SnapshotLayers layers, bool resting);

    static std::shared_ptr<const std::vector<TimelineMark>> marksOf(const Timeline &timeline);

  private:
    void fillMesh(SessionSnapshot &snapshot, const Timeline &timeline, bool wanted, bool resting);
    void growShapes(const FrontState &state);
    MeshQuality quickQuality(const FrontState &state) const;

    /// α of every element made so far; element i is the same whenever it exists.
    std::vector<float> alpha_;
    /// tallies_[i]: of the first i · kTallyStride elements; growing_: of all in alpha_.
    std::vector<ShapeTally> tallies_;
    ShapeTally growing_;
    std::shared_ptr<const MeshView> mesh_;
    std::optional<std::uint64_t> meshPosition_;
    std::optional<std::uint64_t> qualityPosition_;
    MeshQuality quality_;
    std::shared_ptr<const std::vector<TimelineMark>> marks_;
    std::uint64_t marksKnown_ = 0;
    std::uint64_t version_;
};

} // namespace forefront
