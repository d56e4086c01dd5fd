#include "ui/workspace/view/follow_camera.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

// Sides of the advance as fractions of the room: for a new target, and the limits within which the camera keeps still.
constexpr double kTarget = 0.42;
constexpr double kLargest = 0.8;
constexpr double kSmallest = 0.16;
/// The camera keeps still while the advance lies within this fraction of the room.
constexpr double kMiddle = 0.9;
/// Seconds in which the distance from the target falls to 1/e.
constexpr double kTimeConstant = 0.16;
/// Distance from the target that is not worth another frame, in pixels.
constexpr double kArrived = 0.25;

/// Returns the fraction of a room that a box takes up at this zoom.
double part(const Box2 &box, const PixelRect &room, double zoom) {
    return zoom * std::max(box.size().x / room.width, box.size().y / room.height);
}

} // namespace

Box2 boxOf(const AdvanceExplanation &advance) {
    Box2 box = boxOf(advance.a, advance.b);
    box.add(boxAround(advance.ideal, advance.searchRadius));
    for (const CandidateTrace &candidate : advance.candidates) {
        box.add(candidate.position);
        for (const Vec2 node : candidate.over) {
            box.add(node);
        }
    }
    for (const auto &corners : advance.made) {
        for (const Vec2 corner : corners) {
            box.add(corner);
        }
    }
    return box;
}

bool FollowCamera::serves(const Box2 &box, const View &view) const {
    if (target_.empty()) {
        return false;
    }
    const double zoom = kTarget / part(target_, view.room, 1.0);
    const double size = part(box, view.room, zoom);
    const Vec2 half{0.5 * kMiddle * view.room.width / zoom, 0.5 * kMiddle * view.room.height / zoom};
    const Box2 middle{target_.centre() - half, target_.centre() + half};
    return size <= kLargest && size >= kSmallest && middle.contains(box.min) && middle.contains(box.max);
}

bool FollowCamera::follow(View &view, const Box2 &box, double seconds) {
    if (box.empty() || view.room.width <= 0.0 || view.room.height <= 0.0) {
        return false;
    }
    if (!serves(box, view)) {
        target_ = box;
    }
    view.fitted.reset();
    Camera &camera = view.camera;
    const double wanted = std::clamp(kTarget / part(target_, view.room, 1.0), camera.minZoom, camera.maxZoom);
    // The free room may lie off the middle of the viewport.
    const auto centreAt = [&](double zoom) {
        const Pixel off = view.room.centre() - camera.viewport.centre();
        return Vec2{target_.centre().x - off.x / zoom, target_.centre().y + off.y / zoom};
    };
    const double step = 1.0 - std::exp(-seconds / kTimeConstant);
    const double ratio = wanted / camera.zoom;
    const double away = camera.zoom * distance(camera.centre, centreAt(camera.zoom));
    const double growth = std::abs(std::log(ratio)) * 0.5 * std::max(camera.viewport.width, camera.viewport.height);
    if (away < kArrived && growth < kArrived) {
        return false;
    }
    camera.zoom *= std::pow(ratio, step);
    camera.centre = lerp(camera.centre, centreAt(camera.zoom), step);
    return true;
}

} // namespace forefront
