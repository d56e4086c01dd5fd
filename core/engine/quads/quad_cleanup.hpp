#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/quads/quad_changes.hpp"
#include "core/engine/quads/quad_watch.hpp"
#include "core/engine/quads/quad_workspace.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// The effort of a clean-up of quadrilaterals.
struct QuadEffort {
    unsigned passes = 2;      ///< over the irregular nodes, at most
    unsigned firstSweeps = 3; ///< smoothing before the first pass
    unsigned sweeps = 3;      ///< smoothing between passes
    unsigned lastSweeps = 2;  ///< guarded smoothing at the end
    unsigned trialSweeps = 2; ///< smoothing of the surroundings in each trial
    bool generous = false;    ///< try changes that make more nodes irregular at first
};

/// Removes irregular nodes from a mesh by trials: a change is made, its surroundings are smoothed, and it is undone
/// unless the loss of the elements there falls.
class QuadCleanup {
  public:
    /// `watch`: learns of each change; null: none. Refers to its arguments but the effort.
    QuadCleanup(QuadWorkspace &mesh, const SpacingField &spacing, const QuadEffort &effort, QuadWatch *watch = nullptr)
        : mesh_(mesh), spacing_(spacing), effort_(effort), watch_(watch) {}

    /// Runs the clean-up: passes, smoothing, and a search for better places where shapes are poor. Returns false when
    /// cancelled; the mesh is then valid but not as good.
    bool run(const Progress &progress);
    std::size_t changes() const { return changes_; }

  private:
    bool pass(const Progress &progress, double from, double to);
    bool treat(std::uint32_t node);
    bool attempt(const QuadChange &change, std::size_t refused);
    void gatherRegion(const QuadChange &change);
    void make(const QuadChange &change);
    void unmake(const QuadChange &change);
    void growRecords();
    void settle(const QuadChange &change, std::size_t refused);
    void tell(const QuadChange &change, std::size_t refused);
    void tell(ImproveChange change);
    void smooth(unsigned sweeps, void (*smoothing)(QuadWorkspace &, unsigned));
    double regionLoss() const;
    double elementLoss(const QuadCell &cell) const;
    double nodeLoss(std::uint32_t node) const;
    void removeDoublets();
    void cureFlatElements(const Progress &progress);
    bool cure(std::uint32_t cell);

    QuadWorkspace &mesh_;
    const SpacingField &spacing_;
    QuadEffort effort_;
    QuadWatch *watch_;
    std::size_t changes_ = 0;
    /// Flat and inverted elements count far more, and trials look longer for good places. At the end, for few elements.
    bool curing_ = false;

    // Scratch memory of a trial.
    std::vector<QuadChange> found_;
    std::vector<std::uint32_t> nodeStamps_, cellStamps_;
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> regionNodes_, regionCells_;
    std::vector<Vec2> oldPlaces_; ///< of regionNodes_
    std::array<QuadCell, QuadChange::kMost> oldCells_{};
    std::array<std::uint32_t, QuadChange::kMost> newCells_{};
    std::array<std::uint32_t, QuadChange::kMaxNodes> newNodes_{};
    std::vector<std::uint32_t> toldCells_; ///< removed and made by the change told last

    // Nodes tried in vain are skipped until something near them changes.
    std::uint32_t clock_ = 1;
    std::vector<std::uint32_t> triedAt_, changedAt_; ///< per node
    std::vector<std::uint32_t> pending_;             ///< nodes to treat in this pass
};

} // namespace forefront
