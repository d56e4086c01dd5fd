#pragma once

#include "core/drawing/picking/face_map.hpp"

#include <cstdint>
#include <memory>
#include <set>

namespace forefront {

struct Workspace;

/// Returns the faces of the document: the preview's, unless it is out of date. Never null.
std::shared_ptr<const FaceMap> currentFaces(const Workspace &context);

/// Returns the faces of the document if the preview has them by now, else null; never waits.
std::shared_ptr<const FaceMap> readyFaces(const Workspace &context);

/// Faces of the document that are selected.
struct FacesMeant {
    std::shared_ptr<const FaceMap> map; ///< null: no face is selected
    std::set<std::uint32_t> faces;
};

/// Returns the faces of a selection of regions and other faces alone; with shapes beside them, these are meant.
FacesMeant facesMeant(const Workspace &context);

} // namespace forefront
