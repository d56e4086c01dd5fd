#include "ui/workspace/view/follow_camera.hpp"

#include "core/teaching/moment/moment.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// Side of the advance as a fraction of the room, for a new target, as far as the length of the base allows.
constexpr double kTarget = 0.42;
/// The length of the base in design pixels.
constexpr double kShortest = 60.0, kLongest = 120.0;
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

double FollowCamera::zoomOf(const View &view, double scale) const {
    const double zoom = kTarget / part(target_.box, view.room, 1.0);
    return target_.base > 0.0 ? std::clamp(zoom, kShortest * scale / target_.base, kLongest * scale / target_.base)
                              : zoom;
}

bool FollowCamera::serves(const Subject &subject, const View &view, double scale) const {
    if (target_.box.empty()) {
        return false;
    }
    const double zoom = zoomOf(view, scale), base = zoom * subject.base / scale;
    constexpr double kRounding = 1e-6;
    const Vec2 half{0.5 * kMiddle * view.room.width / zoom, 0.5 * kMiddle * view.room.height / zoom};
    const Box2 middle{target_.box.centre() - half, target_.box.centre() + half};
    return base <= kLongest + kRounding && base >= kShortest - kRounding && middle.contains(subject.box.min) &&
           middle.contains(subject.box.max);
}

bool FollowCamera::follow(View &view, const Subject &subject, double seconds, double scale) {
    if (subject.box.empty() || view.room.width <= 0.0 || view.room.height <= 0.0) {
        return false;
    }
    if (!serves(subject, view, scale)) {
        target_ = subject;
    }
    view.fitted.reset();
    Camera &camera = view.camera;
    const double wanted = std::clamp(zoomOf(view, scale), camera.minZoom, camera.maxZoom);
    // The free room may lie off the middle of the viewport.
    const auto centreAt = [&](double zoom) {
        const Pixel off = view.room.centre() - camera.viewport.centre();
        return Vec2{target_.box.centre().x - off.x / zoom, target_.box.centre().y + off.y / zoom};
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

std::optional<FollowCamera::Subject> subjectOf(const SessionSnapshot &run) {
    if (const Moment moment = momentOf(run)) {
        return FollowCamera::Subject{boxOf(*moment.advance), distance(moment.advance->a, moment.advance->b)};
    }
    if (!run.improvement || run.improvement->elements.empty()) {
        return std::nullopt;
    }
    FollowCamera::Subject subject;
    for (const auto &corners : run.improvement->elements) {
        for (const Vec2 corner : corners) {
            subject.box.add(corner);
        }
        subject.base = std::max(subject.base, distance(corners.at[0], corners.at[1]));
    }
    return subject;
}

} // namespace forefront
