#include "core/drawing/document/document.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/icons.hpp"

#include <string>

namespace forefront {

namespace {

/// Maximum number of faults marked in view; more would hide the drawing.
constexpr std::size_t kMaxFaultMarks = 200;
/// Distance from the pointer within which a fault is explained, design pixels.
constexpr double kReach = 14.0;

/// Marks the faults of the drawing a moment after every edit, and explains the one under the pointer.
class FaultsLayer final : public Layer {
  public:
    const char *id() const override { return "faults"; }
    const char *name() const override { return "Faults"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (frame.document.shapes.empty()) {
            return; // the preview may still hold the faults of the old drawing
        }
        const Box2 visible = frame.camera.visible();
        const Diagnostic *pointed = nullptr;
        double nearest = frame.camera.length(kReach * frame.scale);
        std::size_t drawn = 0;
        for (const Diagnostic &fault : frame.preview.faults) {
            if (!fault.at || !visible.contains(*fault.at) || ++drawn > kMaxFaultMarks) {
                continue;
            }
            const Colour colour = fault.severity == Severity::Error ? frame.theme.bad : frame.theme.warn;
            painter.dot(*fault.at, 9.0, fade(colour, 0.25));
            painter.ring(*fault.at, 9.0, colour, 2.0);
            if (frame.pointer && distance(*frame.pointer, *fault.at) < nearest) {
                nearest = distance(*frame.pointer, *fault.at);
                pointed = &fault;
            }
        }
        if (pointed != nullptr) {
            painter.label(*pointed->at, {16.0, -22.0}, std::string(icon::kWarning) + "  " + pointed->message,
                          pointed->severity == Severity::Error ? frame.theme.bad : frame.theme.warn,
                          labelPlate(frame.theme), frame.fonts.small);
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeFaultsLayer() {
    return std::make_unique<FaultsLayer>();
}

} // namespace forefront
