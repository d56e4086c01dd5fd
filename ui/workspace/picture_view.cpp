#include "ui/workspace/picture_view.hpp"

#include "ui/workspace/workspace.hpp"

namespace forefront {

void keepPictureInView(Workspace &context, const Document &before) {
    const std::shared_ptr<const Document> now = context.document.current();
    const bool scaled = before.picture && now->picture && before.picture->size.x != now->picture->size.x;
    if (scaled && now->shapes.empty()) {
        context.view.rescale(boundsOf(*before.picture), boundsOf(*now->picture));
        context.animate();
    }
}

} // namespace forefront
