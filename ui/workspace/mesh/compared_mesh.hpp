#pragma once

#include "ui/workspace/mesh/file_fields.hpp"
#include "ui/workspace/mesh/mesh_judge.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The mesh of a file, prepared for being compared.
struct ComparedFile {
    std::shared_ptr<const FileFields> fields; ///< null: none
    std::shared_ptr<MeshSnapshot> view;       ///< its version is set when it is shown
};

/// Computes what is shown of a mesh; takes a while for a large one.
ComparedFile comparedFile(MeshFields read);

/// The mesh of a file, shown for comparison with the mesh on the canvas. It is evaluated on a separate thread.
class ComparedMesh {
  public:
    /// `name`: of the file. `version`: of the mesh view.
    ComparedMesh(BackgroundList &list, std::string name, ComparedFile file, std::uint64_t version);

    const std::string &name() const { return name_; }
    /// Returns the triangles by which the mesh is drawn.
    const TriMesh &mesh() const { return view_->mesh; }
    const std::shared_ptr<const MeshSnapshot> &view() const { return view_; }
    /// Returns the evaluation of this frame; never null.
    const std::shared_ptr<const Judgement> &judgement() const { return judge_.now(); }
    /// Returns the edges with one element; empty until the mesh has been evaluated.
    const std::vector<MeshEdge> &outline() const;

    /// Evaluates the mesh with the measure or field and the spacing of the canvas, and fetches the latest evaluation.
    /// Call it once per frame. Returns true if the evaluation is new.
    bool follow(JudgeRequest request);

  private:
    std::string name_;
    std::shared_ptr<const FileFields> fields_; ///< null: none
    std::shared_ptr<const MeshSnapshot> view_;
    MeshJudge judge_;
};

/// The figures of a mesh that a comparison shows.
struct MeshFigures {
    MeshQuality quality;
    bool spacing = false;          ///< δ is known
    std::optional<double> seconds; ///< CPU time taken by the meshing, if known
};

/// Returns the figures of a judgement that was requested with `quality`; none until they are computed.
std::optional<MeshFigures> figuresOf(const Judgement &judgement);

} // namespace forefront
