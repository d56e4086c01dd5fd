#pragma once

#include "core/engine/session/lockstep.hpp"
#include "ui/workspace/mesh/compared_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

struct Document;
class RunControl;

/// The views beside the canvas: runs with other grids or the other method at the same advance as the run of the
/// document, or the mesh of a file.
class SideBySide final : public BackgroundActivity {
  public:
    explicit SideBySide(BackgroundList &list) : BackgroundActivity(list) {}

    bool visible = false;
    Comparison comparison = Comparison::Grids;
    bool overlaid = false; ///< the mesh of a file is drawn over that of the canvas rather than beside it

    /// Starts the runs of a new mesh, moves them to the position of the run on the canvas and fetches their snapshots.
    /// Call it once per frame. Returns true if there is a new snapshot.
    bool follow(const RunControl &run, const Document &document);
    /// Shows the mesh of a file instead of runs.
    void compareWith(std::string name, ComparedFile file);
    /// Evaluates the mesh of the file with the measure and the spacing of the canvas. Call it once per frame. Returns
    /// true if there is a new evaluation.
    bool judge(const JudgeRequest &canvas) { return mesh_ && mesh_->follow(canvas); }
    /// Returns the mesh of the file; null if runs are compared.
    const ComparedMesh *mesh() const { return mesh_.get(); }
    void close();
    /// Returns true while a run is still moving to the position of the canvas, or one that was dropped is ending.
    bool working() const override;
    bool hasNews() const override;
    /// Returns the number of runs or meshes compared with that of the canvas.
    std::size_t size() const { return mesh_ ? 1 : shown_.size(); }
    /// Returns the number of views beside the canvas.
    std::size_t views() const { return !visible || (mesh_ && overlaid) ? 0 : size(); }
    /// Returns the mesh of the file if it is drawn over that of the canvas; else null.
    std::shared_ptr<const MeshSnapshot> overlay() const {
        return visible && overlaid && mesh_ ? mesh_->view() : std::shared_ptr<const MeshSnapshot>();
    }
    const RunVariant &variant(std::size_t run) const { return lockstep_->variant(run); }
    const SessionSnapshot &now(std::size_t run) const { return *shown_[run]; }

  private:
    /// Ends the runs, if there are any; their workers stop by themselves. Returns true if there were any.
    bool drop();

    std::optional<Lockstep> lockstep_; ///< not set: nothing to compare
    std::vector<Lockstep> ending_;     ///< runs that were dropped, until their workers have stopped
    std::vector<std::shared_ptr<const SessionSnapshot>> shown_;
    std::uint64_t run_ = 0; ///< number of the run that the lockstep was started for
    Comparison started_ = Comparison::Grids;
    std::unique_ptr<ComparedMesh> mesh_; ///< null: runs are compared
    std::uint64_t meshes_ = 0;           ///< number of meshes of files so far
};

} // namespace forefront
