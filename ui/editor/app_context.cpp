#include "ui/editor/app_context.hpp"

namespace forefront {

void View::fit(const Box2 &box) {
    camera.fit(box, room);
    fitted = box;
}

void View::pan(Vec2 pixels) {
    camera.pan(pixels);
    fitted.reset();
}

void View::zoomAt(Vec2 pixel, double factor) {
    camera.zoomAt(pixel, factor);
    fitted.reset();
}

bool View::resize(const PixelRect &viewport, const PixelRect &roomInIt) {
    if (camera.viewport == viewport && room == roomInIt) {
        return false;
    }
    camera.viewport = viewport;
    room = roomInIt;
    if (fitted) {
        fit(*fitted);
    }
    return true;
}

void View::goTo(Vec2 place, double now) {
    fitted.reset();
    camera.centre = place;
    flag = place;
    flagTime = now;
}

void ToolBox::choose(std::string_view id, AppContext &context) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (tools[i]->id() == id && i != active) {
            current().deactivate(context);
            active = i;
            current().activate(context);
            context.animate();
            return;
        }
    }
}

LayerSlot *AppContext::layer(std::string_view id) {
    for (LayerSlot &slot : layers) {
        if (slot.layer->id() == id) {
            return &slot;
        }
    }
    return nullptr;
}

} // namespace forefront
