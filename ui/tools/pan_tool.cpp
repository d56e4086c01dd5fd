#include "ui/tools/pan_tool.hpp"

#include "ui/app/app_context.hpp"

namespace forefront {

const char *PanTool::icon() const {
    return icon::kFit;
}

bool PanTool::handle(const CanvasEvent &event, AppContext &context) {
    if (event.kind == CanvasEvent::Kind::Press) {
        grabbed_ = event.pixel;
        return true;
    }
    if (event.kind == CanvasEvent::Kind::Drag) {
        context.view.camera.pan(event.pixel - grabbed_);
        grabbed_ = event.pixel;
        return true;
    }
    return false;
}

std::string PanTool::statusText(const AppContext &) const {
    return "Drag to move the view; the wheel zooms at the pointer";
}

} // namespace forefront
