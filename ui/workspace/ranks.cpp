#include "ui/workspace/ranks.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>
#include <string>

namespace forefront {

void drawRanks(CanvasPainter &painter, const Workspace &context) {
    constexpr std::size_t kNumbered = 9;
    constexpr double kRing = 9.0;
    const Judgement &judgement = *context.judgement;
    if (!judgement.of.mesh || (judgement.info.part == MeshPart::Edges && !judgement.edges)) {
        return;
    }
    const Box2 visible = context.view.camera.visible();
    for (std::size_t rank = 0; rank < std::min(kNumbered, judgement.worst.size()); ++rank) {
        const Vec2 at = placeOf(judgement, judgement.info.part, judgement.worst[rank]);
        const bool chosen = context.probe.chosen && context.probe.rank == rank;
        if (!chosen && visible.contains(at)) {
            painter.ring(at, kRing, context.theme.text, 1.25);
            painter.freeLabel(at, {kRing, -kRing - 12.0}, std::to_string(rank + 1), context.theme.text,
                              fade(context.theme.popup, 0.9), context.fonts.small);
        }
    }
}

} // namespace forefront
