#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/picking/face_map.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

/// Faces of a drawing that are moved as one: what moves with them, and the region markers beside them, each of which
/// must stay in its face. Prepared once, so that each step of a drag is cheap.
class FaceMove {
  public:
    /// `index`: of the document before the move; `map`: of its domain. Errors: no-face if there are no faces;
    /// border-locked, border-hidden if a locked or hidden shape bounds one of them.
    static Result<FaceMove> of(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces);

    /// Returns what moves: the lines around the faces, and the shapes, sources and markers inside of them.
    const Selection &parts() const { return parts_; }
    /// Puts the markers of neighbouring regions that the move has left outside of their faces back into these.
    /// `after`: the document in which parts() have moved, with what is joined with them.
    Document keepMarkers(Document after) const;

  private:
    /// A place on an outline that the move may change.
    struct Anchor {
        Vec2 at; ///< before the move
        std::uint32_t shape = 0;
        std::uint32_t part = 0; ///< handle, or segment if `onSegment`
        double t = 0.0;         ///< along the segment
        bool onSegment = false;
    };
    /// A face that changes with the move and does not move itself.
    struct ChangedFace {
        std::vector<std::uint32_t> markers;                         ///< in the face
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; ///< from anchor to anchor
    };

    void takeParts(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces);
    void takeNeighbours(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces);
    std::vector<Vec2> placesIn(const Document &after) const;

    Selection parts_;
    std::vector<Anchor> anchors_;
    std::vector<ChangedFace> neighbours_;
};

/// Moves faces with what lies in them and what is joined with their borders. Errors: those of FaceMove::of(),
/// moveSelection() and carryJoints().
Result<Document> moveFaces(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces, Vec2 by);

} // namespace forefront
