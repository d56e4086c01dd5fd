#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/session/snapshot.hpp"
#include "core/teaching/lesson/lesson_colours.hpp"
#include "ui/background/latest.hpp"
#include "ui/style/colour_map.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A request to evaluate a mesh.
struct JudgeRequest {
    std::shared_ptr<const MeshSnapshot> mesh;               ///< null: nothing to evaluate
    std::shared_ptr<const SpacingField> spacing;            ///< may be null
    Measure measure = Measure::ShapeFactor;                 ///< whose values are computed
    MeshPart fieldPart = MeshPart::Nodes;                   ///< that has `fieldValues`: nodes or elements
    std::string field;                                      ///< name of `fieldValues`; empty: none
    std::shared_ptr<const std::vector<double>> fieldValues; ///< values to show instead; null: none
    LessonColours formula{}; ///< whose values become `fieldValues` of the answer; empty: none
    MeshLimits limits;
    bool verify = false;  ///< also check the mesh for faults
    bool parts = false;   ///< also build the tree that finds the parts at a position
    bool quality = false; ///< also compute the quality figures
    bool outline = false; ///< also list the edges with one element; only with `parts`

    friend bool operator==(const JudgeRequest &, const JudgeRequest &) = default;
};

/// The evaluation of a mesh.
struct Judgement {
    JudgeRequest of;
    /// Edges of the mesh; null if the request does not need them.
    std::shared_ptr<const MeshEdges> edges;
    std::shared_ptr<const std::vector<MeshEdge>> outline; ///< edges with one element; null unless `outline`
    std::shared_ptr<const BoxTree> tree; ///< over the boxes of the triangles that are drawn; null unless `parts`
    std::vector<double> values;          ///< of the measure
    std::string name;                    ///< of the measure or the field
    MeasureInfo info = infoOf(Measure::ShapeFactor); ///< of the measure or the field
    MeasureSummary summary;
    MeasureHistogram histogram;       ///< over all values
    ColourRange fitted;               ///< range of the colours that shows the differences within the mesh
    std::vector<std::uint32_t> worst; ///< at most kRanked parts, the worst first
    std::vector<LimitVerdict> verdicts;
    Diagnostics faults;                 ///< of the mesh, if `verify`
    std::optional<MeshQuality> quality; ///< if `quality`

    static constexpr std::size_t kRanked = 200;
};

/// Evaluates a request, reusing unchanged results of an earlier evaluation.
std::shared_ptr<const Judgement> judgementOf(const JudgeRequest &request, const Judgement &earlier);

/// Evaluates the mesh shown on a separate thread, so that the window never waits for it.
class MeshJudge {
  public:
    using Answer = std::function<std::shared_ptr<const Judgement>(const JudgeRequest &, const Judgement &earlier)>;
    /// `answer` computes the judgement; tests pass their own.
    explicit MeshJudge(BackgroundList &list, Answer answer = judgementOf);

    /// Sets the request; cheap if it has not changed. Work on an earlier request is finished first.
    void submit(const JudgeRequest &request);
    /// Fetches the newest judgement. Called once per frame; returns true if it is new.
    bool refresh() { return worker_.refresh(); }
    /// Returns the judgement of this frame; never null.
    const std::shared_ptr<const Judgement> &now() const { return worker_.now(); }
    /// Returns true while the newest request is unanswered.
    bool busy() const { return worker_.working(); }

  private:
    JudgeRequest wanted_;
    Latest<JudgeRequest, std::shared_ptr<const Judgement>> worker_;
};

/// Returns the position of a part of the evaluated mesh. For edges, the judgement must include them.
Vec2 placeOf(const Judgement &judgement, MeshPart part, std::uint32_t index);

} // namespace forefront
