#include "ui/workspace/current_faces.hpp"

#include "core/drawing/picking/selected_faces.hpp"
#include "ui/workspace/workspace.hpp"

#include <utility>

namespace forefront {

std::shared_ptr<const FaceMap> readyFaces(const Workspace &context) {
    return context.preview->revision == context.document.revision() ? context.preview->faces : nullptr;
}

std::shared_ptr<const FaceMap> currentFaces(const Workspace &context) {
    std::shared_ptr<const FaceMap> ready = readyFaces(context);
    return ready ? std::move(ready) : faceMapOf(context.document.domain());
}

FacesMeant facesMeant(const Workspace &context) {
    if (!context.selection.onlyFaces()) {
        return {};
    }
    std::shared_ptr<const FaceMap> map = currentFaces(context);
    std::set<std::uint32_t> faces = selectedFaces(*map, *context.document.current(), context.selection);
    return faces.empty() ? FacesMeant() : FacesMeant{std::move(map), std::move(faces)};
}

} // namespace forefront
