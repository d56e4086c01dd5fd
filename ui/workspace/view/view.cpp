#include "ui/workspace/view/view.hpp"

namespace forefront {

void View::fit(const Box2 &box) {
    camera.fit(box, room);
    fitted = box;
    following = false;
    ++jumps;
}

void View::pan(Pixel pixels) {
    camera.pan(pixels);
    fitted.reset();
    following = false;
}

void View::zoomAt(Pixel pixel, double factor) {
    camera.zoomAt(pixel, factor);
    fitted.reset();
    following = false;
}

void View::reveal(const Box2 &box) {
    const Box2 visible = camera.visible();
    if (box.empty() || (visible.contains(box.min) && visible.contains(box.max))) {
        return;
    }
    Box2 whole = boxOf(camera.toPlane({room.x, room.y}), camera.toPlane({room.x + room.width, room.y + room.height}));
    whole.add(box);
    fit(whole);
    fitted.reset(); // or the next change of the canvas would undo what the user zooms and pans from here on
}

void View::rescale(const Box2 &before, const Box2 &after) {
    const double factor = after.size().x / before.size().x;
    camera.centre = after.min + factor * (camera.centre - before.min);
    camera.zoom /= factor;
    camera.minZoom /= factor;
    camera.maxZoom /= factor;
    fitted.reset();
}

bool View::resize(const PixelRect &viewport, const PixelRect &roomInIt) {
    if (camera.viewport == viewport && room == roomInIt) {
        return false;
    }
    camera.viewport = viewport;
    room = roomInIt;
    if (fitted) {
        camera.fit(*fitted, room);
    }
    return true;
}

void View::goTo(Vec2 place, double now) {
    fitted.reset();
    following = false;
    camera.centre = place;
    ++jumps;
    flag = place;
    flagTime = now;
}

} // namespace forefront
