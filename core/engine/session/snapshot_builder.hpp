#pragma once

#include "core/engine/mesh/shape_tally.hpp"
#include "core/engine/mesher/timeline.hpp"
#include "core/engine/session/snapshot.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace forefront {

/// Copies the layers of a run that the UI thread requests, and only when they change. Belongs to one run.
class SnapshotBuilder {
  public:
    /// Numbers the mesh views from `version` on, so that the versions of two runs differ.
    explicit SnapshotBuilder(std::uint64_t version) : version_(version) {}

    /// Fills in mesh, front, cells and marks at the position of the timeline. `resting`: the run does not move, so that
    /// slower figures are computed as well: the full quality, the state hash, marks.
    void fill(SessionSnapshot &snapshot, const Timeline &timeline, SnapshotLayers layers, bool resting);

    /// Returns the marks of a timeline.
    static std::shared_ptr<const std::vector<TimelineMark>> marksOf(const Timeline &timeline);

  private:
    void fillMesh(SessionSnapshot &snapshot, const Timeline &timeline, bool include, bool resting);
    void growShapes(const FrontState &state);
    std::shared_ptr<const RunCurves> curvesOf(const Timeline &timeline) const;
    MeshQuality quickQuality(const FrontState &state) const;

    /// α of every element made so far. Element i is always the same.
    std::vector<float> alpha_;
    /// tallies_[i] counts the first i · kTallyStride elements, growing_ all of alpha_.
    std::vector<ShapeTally> tallies_;
    ShapeTally growing_;
    std::shared_ptr<const MeshSnapshot> mesh_;
    std::optional<std::uint64_t> meshPosition_;
    std::optional<std::uint64_t> qualityPosition_;
    MeshQuality quality_;
    std::shared_ptr<const std::vector<TimelineMark>> marks_;
    std::shared_ptr<const RunCurves> curves_; ///< both cover the first marksKnown_ advances
    std::uint64_t marksKnown_ = 0;
    std::uint64_t version_;
};

} // namespace forefront
