#pragma once

#include "core/drawing/picking/face_map.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/shapes/references.hpp"

#include <cstddef>
#include <cstdint>
#include <set>

namespace forefront {

/// Returns the faces of a selection: those of its region markers, and those around its places. `map`: of the document.
std::set<std::uint32_t> selectedFaces(const FaceMap &map, const Document &document, const Selection &selection);

/// Returns true if a face of `map` is selected.
bool isFaceSelected(const FaceMap &map, const Document &document, const Selection &selection, std::uint32_t face);

/// Selects a face: by its region marker, or by `place` in it if it has none.
void selectFace(const FaceMap &map, std::uint32_t face, Vec2 place, Selection &selection);
/// Removes all markers and places in a face from a selection.
void deselectFace(const FaceMap &map, const Document &document, std::uint32_t face, Selection &selection);

/// The lines around faces.
struct FaceBorder {
    Selection lines;                  ///< shapes whose every part lies on the border, and parts of others
    std::size_t hiddenEdges = 0;      ///< edges of the faces on which hidden shapes lie
    std::set<std::uint32_t> locked{}; ///< shapes on the border that are locked; `lines` has them, too
};

/// Returns the parts of a drawing that bound faces, also from within; where shapes run along each other, all of them.
/// `index`: of the document; `map`: of its domain.
FaceBorder borderOf(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces);

} // namespace forefront
