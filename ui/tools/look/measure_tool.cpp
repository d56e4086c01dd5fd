#include "ui/tools/look/measure_tool.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/typed_length.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

namespace {

constexpr double kSegmentReach = 6.0; ///< of a click, design pixels
constexpr std::size_t kMaxFaceLines = 20'000;
constexpr const char *kAngleSign = "\xe2\x88\xa0";

std::string degrees(double angle) {
    return ui::number(angle, 4) + "\xc2\xb0";
}

} // namespace

const char *MeasureTool::icon() const {
    return icon::kMeasure;
}

std::optional<Vec2> MeasureTool::anchor() const {
    return !points_.empty() && !complete() ? std::optional(points_.back()) : std::nullopt;
}

bool MeasureTool::complete() const {
    return points_.size() == (mode_ == MeasureMode::Angle ? 3U : 2U) || picked_.size() == 2;
}

void MeasureTool::cancel() {
    points_.clear();
    picked_.clear();
    face_.reset();
    faceLines_.clear();
    missed_ = false;
}

bool MeasureTool::removeLast() {
    picked_.empty() ? points_.pop_back() : picked_.pop_back();
    return true;
}

/// Returns the segment under the pointer, also one of a locked shape.
std::optional<MeasureTool::Picked> MeasureTool::segmentUnder(const Shell &context) const {
    const auto hit = state_->index(context)->segment(place_, EditState::reach(context, kSegmentReach));
    if (!hit) {
        return std::nullopt;
    }
    const Shape *const shape = findShape(*context.document.current(), hit->ref.shape);
    if (shape != nullptr && isRound(*shape)) {
        return Picked{outlineOf(*shape).curve(0), hit->at};
    }
    return Picked{hit->curve ? *hit->curve : Curve::line(hit->a, hit->b), hit->at};
}

void MeasureTool::place(Vec2 at, Shell &context) {
    revision_ = context.document.revision();
    if (mode_ == MeasureMode::Object) {
        placeObject(context);
    } else if (mode_ == MeasureMode::Angle) {
        placeAngle(at, context);
    } else {
        if (complete()) {
            cancel();
        }
        if (points_.empty() || at != points_.back()) {
            points_.push_back(at);
        }
    }
}

/// A click on a segment, but not on its ends, picks it; any other places one of three points.
void MeasureTool::placeAngle(Vec2 at, Shell &context) {
    if (complete()) {
        cancel();
    }
    const std::optional<Picked> segment = points_.empty() ? segmentUnder(context) : std::nullopt;
    const bool ends = pointer_.kind == SnapKind::Node || !segment;
    if (!ends || (segment && !picked_.empty())) {
        picked_.push_back(*segment);
    } else if (picked_.empty() && (points_.empty() || at != points_.back())) {
        points_.push_back(at);
    }
}

void MeasureTool::placeObject(Shell &context) {
    cancel();
    if (const std::optional<Picked> segment = segmentUnder(context)) {
        picked_.push_back(*segment);
        return;
    }
    const std::shared_ptr<const Domain> drawn = context.document.domain();
    const Domain &domain = *drawn;
    face_ = measureFace(domain, place_);
    faceAt_ = place_;
    missed_ = !face_;
    const std::size_t lines = face_ ? std::min(face_->segments.size(), kMaxFaceLines) : 0;
    for (std::size_t k = 0; k < lines; ++k) {
        const DomainSegment &segment = domain.segments[face_->segments[k]];
        faceLines_.emplace_back(domain.nodes[segment.a], domain.nodes[segment.b]);
    }
}

std::vector<Vec2> MeasureTool::points() const {
    std::vector<Vec2> all = points_;
    if (!all.empty() && !complete()) {
        all.push_back(pointer_.at);
    }
    return all;
}

MeasureTool::Values MeasureTool::values(const Shell &context) const {
    Values found;
    const std::vector<Vec2> at = points();
    const LengthUnit unit = context.document.current()->unit;
    const auto inUnit = [unit](double value) { return ui::number(value, 6) + unitSuffix(unit); };
    if (mode_ == MeasureMode::Distance && at.size() == 2) {
        const Vec2 arm = at[1] - at[0];
        const double angle = std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi;
        return {{"", inUnit(length(arm))},
                {"\xce\x94x", inUnit(arm.x)},
                {"\xce\x94y", inUnit(arm.y)},
                {kAngleSign, degrees(angle)}};
    }
    if (mode_ == MeasureMode::Angle && at.size() == 3) {
        return {{kAngleSign, degrees(angleBetween(at[0] - at[1], at[2] - at[1]))}};
    }
    if (mode_ == MeasureMode::Angle && picked_.size() == 2) {
        const auto direction = [](const Picked &picked) {
            return picked.curve.tangent(picked.curve.nearest(picked.at));
        };
        const double angle = angleBetween(direction(picked_[0]), direction(picked_[1]));
        return {{kAngleSign, degrees(std::min(angle, 180.0 - angle))},
                {"supplement", degrees(std::max(angle, 180.0 - angle))}};
    }
    if (mode_ == MeasureMode::Object && face_) {
        return {{"area", ui::number(face_->area, 6) + areaSuffix(unit)}, {"perimeter", inUnit(face_->perimeter)}};
    }
    const std::optional<Picked> hovered = picked_.empty() && over_ ? segmentUnder(context) : std::nullopt;
    if (mode_ == MeasureMode::Object && (hovered || !picked_.empty())) {
        for (const SegmentMeasure &quantity : measureCurve(hovered ? hovered->curve : picked_.front().curve)) {
            found.emplace_back(quantity.name, quantity.isAngle ? degrees(quantity.value) : inUnit(quantity.value));
        }
    }
    return found;
}

std::string MeasureTool::reading(const Shell &context) const {
    std::string text;
    for (const auto &[name, value] : values(context)) {
        text.append(text.empty() ? "" : "   ").append(name).append(name.empty() ? "" : " ").append(value);
    }
    return text;
}

void MeasureTool::drawSketch(CanvasPainter &painter, Shell &context) {
    if (revision_ != context.document.revision() && (!picked_.empty() || face_)) {
        cancel(); // what was measured may be gone
    }
    switch (mode_) {
    case MeasureMode::Distance:
        drawDistance(painter, context);
        break;
    case MeasureMode::Angle:
        drawAngle(painter, context);
        break;
    case MeasureMode::Object:
        drawObject(painter, context);
        break;
    }
}

/// Writes the values: beside `at` once everything is placed, otherwise at the pointer.
void MeasureTool::label(CanvasPainter &painter, Shell &context, Vec2 at) const {
    const std::string text = reading(context);
    if (text.empty() || inProgress()) {
        drawMeasure(painter, context, text);
    } else {
        painter.label(at, {16.0, 14.0}, text, context.theme.text, fade(context.theme.popup, 0.9), context.fonts.small);
    }
}

void MeasureTool::drawDistance(CanvasPainter &painter, Shell &context) const {
    const Colour colour = context.theme.selection;
    const std::vector<Vec2> at = points();
    if (at.size() == 2) {
        painter.line(at[0], at[1], colour, 1.5);
        painter.dashed(at[0], {at[1].x, at[0].y}, fade(colour, 0.5), 1.0);
        painter.dashed({at[1].x, at[0].y}, at[1], fade(colour, 0.5), 1.0);
    }
    for (const Vec2 end : at) {
        painter.cross(end, 4.0, colour, 1.5);
    }
    label(painter, context, at.empty() ? Vec2{} : at.back());
}

void MeasureTool::drawAngle(CanvasPainter &painter, Shell &context) const {
    const Colour colour = context.theme.selection;
    const std::vector<Vec2> at = points();
    for (std::size_t k = 0; k < at.size(); ++k) {
        if (k > 0) {
            painter.line(at[k - 1], at[k], colour, 1.5);
        }
        painter.cross(at[k], 4.0, colour, 1.5);
    }
    for (const Picked &picked : picked_) {
        painter.curve(picked.curve, colour, 3.0);
    }
    const bool hovers = points_.empty() && !complete() && over_ && pointer_.kind != SnapKind::Node;
    if (const std::optional<Picked> hovered = hovers ? segmentUnder(context) : std::nullopt) {
        painter.curve(hovered->curve, fade(colour, 0.6), 3.0);
    }
    label(painter, context, at.size() == 3 ? at[1] : picked_.size() == 2 ? picked_[1].at : Vec2{});
}

void MeasureTool::drawObject(CanvasPainter &painter, Shell &context) const {
    const Colour colour = context.theme.selection;
    for (const auto &[from, to] : faceLines_) {
        painter.line(from, to, colour, 3.0);
    }
    for (const Picked &picked : picked_) {
        painter.curve(picked.curve, colour, 3.0);
    }
    if (face_ || !picked_.empty()) {
        label(painter, context, face_ ? faceAt_ : picked_.front().at);
    } else if (const std::optional<Picked> hovered = over_ ? segmentUnder(context) : std::nullopt) {
        painter.curve(hovered->curve, fade(colour, 0.6), 3.0);
        label(painter, context, place_);
    }
}

void MeasureTool::drawOptions(Shell &context, ui::Flow &flow) {
    flow.item("mode");
    int mode = static_cast<int>(mode_);
    const char *const names[] = {"Distance", "Angle", "Object"};
    const char *const tips[] = {"Distance between two points",
                                "Angle between two segments, or at a corner of three points",
                                "Length or radius of a segment or curve; area and perimeter of a face"};
    if (ui::segmented(context, "options/measure/mode", names, mode, 216.0F, tips)) {
        cancel();
        mode_ = static_cast<MeasureMode>(mode);
    }
    if (mode_ != MeasureMode::Object) {
        state_->drawSnapOptions(context, flow);
    }
}

std::vector<ContextGroup> MeasureTool::menu(Shell &context, Vec2) {
    ContextGroup group;
    const Values all = values(context);
    for (const auto &[name, value] : all) {
        group.push_back(copyCommand("copy/" + name, "Copy " + (name.empty() ? "distance" : name) + ' ' + value, value));
    }
    if (!all.empty()) {
        group.push_back(commandOf("clear", "Measure again", [this](Shell &) { cancel(); }));
    }
    return {group};
}

std::string MeasureTool::statusText(const Shell &context) const {
    if (mode_ == MeasureMode::Object) {
        return missed_                    ? "No face there: outside all loops, or segments cross"
               : reading(context).empty() ? "Click a segment or curve for its size, or inside a face for its area"
                                          : "Ctrl+C copies the values";
    }
    if (complete()) {
        return "Ctrl+C copies the values; click to measure again";
    }
    if (mode_ == MeasureMode::Angle) {
        return picked_.size() == 1   ? "Click the second segment"
               : points_.empty()     ? "Click the first of two segments, or of three points"
               : points_.size() == 1 ? "Click the corner of the angle"
                                     : "Click a point on the other leg";
    }
    return points_.size() == 1 ? "Click the second point. Shift: angle steps"
                               : "Click or drag from point to point to measure";
}

} // namespace forefront
