#include "ui/tools/select/transform_handles.hpp"

#include "core/drawing/commands/transform.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/announce_changes.hpp"
#include "ui/workspace/snap_mark.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace forefront {
namespace {

// Distances in design pixels.
constexpr double kHandleGap = 12.0;   ///< between the box and its handles, so that nodes on it can be picked
constexpr double kRotationGap = 26.0; ///< of the handle that rotates
constexpr double kPointerReach = 7.0; ///< of the pointer
constexpr double kShortSide = 36.0;   ///< shorter sides have no handle in their middle
constexpr double kMinFactor = 1e-3;   ///< nothing is scaled to nothing

constexpr std::array<TransformHandles::Handle, 9> kHandles{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 1, true}}};

Vec2 cornerOf(const Box2 &box, int x, int y) {
    const Vec2 half = 0.5 * box.size();
    return box.centre() + Vec2{x * half.x, y * half.y};
}

double degrees(Vec2 arm) {
    return std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi;
}

double atLeast(double factor) {
    return std::copysign(std::max(std::abs(factor), kMinFactor), factor);
}

std::string percent(double factor) {
    return ui::number(100.0 * factor, 4) + " %";
}

/// Returns true if a selection is more than one point.
bool canTransform(const Selection &selection) {
    if (selection.onlyFaces()) {
        return false; // their markers alone would move
    }
    return !selection.shapes.empty() || !selection.segments.empty() ||
           selection.nodes.size() + selection.sources.size() + selection.markers.size() > 1;
}

} // namespace

const Box2 &TransformHandles::box(const Shell &context) const {
    // Stepping and judging look at the mesh, of which a frame around the selection seems a part.
    static constexpr Box2 kNone;
    const WorkspaceKind workspace = context.settings.workspace;
    if (workspace == WorkspaceKind::Step || workspace == WorkspaceKind::Judge) {
        return kNone;
    }
    const std::uint64_t revision = context.document.revision();
    if (boxRevision_ != revision || boxSelection_ != context.selection) {
        boxRevision_ = revision;
        boxSelection_ = context.selection;
        box_ = canTransform(boxSelection_) ? boundsOf(*context.document.current(), boxSelection_) : Box2();
        if (!box_.empty() && box_.size() == Vec2{}) {
            box_ = {};
        }
    }
    return box_;
}

std::optional<Vec2> TransformHandles::placeOf(const Handle &handle, const Box2 &around, const Shell &context) {
    const double shortSide = EditState::reach(context, kShortSide);
    const bool sideFits =
        (handle.x != 0 || around.size().x >= shortSide) && (handle.y != 0 || around.size().y >= shortSide);
    if (around.empty() || !sideFits) {
        return std::nullopt;
    }
    const double gap = EditState::reach(context, handle.rotates ? kRotationGap : kHandleGap);
    return cornerOf(around, handle.x, handle.y) + Vec2{handle.x * gap, handle.y * gap};
}

std::optional<TransformHandles::Handle> TransformHandles::at(Vec2 place, Shell &context) const {
    const Box2 &around = box(context);
    std::optional<Handle> best;
    double limit = EditState::reach(context, kPointerReach);
    for (const Handle &handle : kHandles) {
        const std::optional<Vec2> there = placeOf(handle, around, context);
        if (there && distance(*there, place) <= limit) {
            limit = distance(*there, place);
            best = handle;
        }
    }
    return best;
}

void TransformHandles::begin(const Handle &handle, const CanvasEvent &event, Shell &context,
                             std::shared_ptr<const Joints> joints) {
    handle_ = handle;
    start_ = context.document.current();
    startIndex_ = state_->index(context);
    startJoints_ = std::move(joints);
    moving_ = context.selection;
    following_ = startJoints_->withJoined(moving_);
    startBox_ = box(context);
    stroke_ = state_->newStroke();
    fault_.clear();
    entry_.clear();
    last_ = event;
    pressPixel_ = event.pixel;
    pressPlace_ = event.place;
    target_ = {cornerOf(startBox_, handle.x, handle.y), SnapKind::None};
    away_ = false;
}

void TransformHandles::end() {
    start_.reset();
    startIndex_.reset();
    startJoints_.reset();
    entry_.clear();
}

void TransformHandles::finish(Shell &context) {
    if (active()) {
        announceChangedDimensions(context, *start_);
    }
    end();
}

void TransformHandles::drag(const CanvasEvent &event, Shell &context) {
    if (!active()) {
        return; // cancelled while the button is still down
    }
    last_ = event;
    away_ = away_ || glm::distance(event.pixel, pressPixel_) > static_cast<double>(context.px(3));
    if (away_) {
        update(context);
    }
}

void TransformHandles::update(Shell &context) {
    const Vec2 corner = cornerOf(startBox_, handle_.x, handle_.y) + (last_.place - pressPlace_);
    angleStep_ = context.snapping.angleStep;
    SnapQuery query = state_->query(context, corner, false, handle_.rotates || last_.modifiers.alt());
    query.guides = query.guides && showsLayer(context.layers, "guides");
    if (context.snapping.toDrawing) {
        query.filter = [this](const Shape &shape) { return !following_.touches(shape.id); };
    }
    target_ = snap(*startIndex_, query);
    Result<Document> next = transformSelection(*start_, moving_, map());
    if (next) {
        next = startJoints_->carry(*next);
    }
    fault_ = next ? std::string() : next.faults().front().message;
    if (next) {
        context.applyCommand(std::move(next), handle_.rotates ? "Rotate" : "Scale", stroke_);
    }
}

Vec2 TransformHandles::fixedPoint() const {
    return last_.modifiers.control() || handle_.rotates ? startBox_.centre()
                                                        : cornerOf(startBox_, -handle_.x, -handle_.y);
}

Vec2 TransformHandles::factors() const {
    const Vec2 fixed = fixedPoint(), arm = cornerOf(startBox_, handle_.x, handle_.y) - fixed;
    const Vec2 now = target_.at - fixed;
    const bool isCorner = arm.x != 0.0 && arm.y != 0.0;
    const std::optional<double> given = entry_.value(EntryField::Factor);
    Vec2 factors{arm.x != 0.0 ? now.x / arm.x : 1.0, arm.y != 0.0 ? now.y / arm.y : 1.0};
    if (given) {
        factors = {arm.x != 0.0 ? *given : 1.0, arm.y != 0.0 ? *given : 1.0};
    }
    if (last_.modifiers.shift()) {
        const double along = isCorner ? dot(now, arm) / dot(arm, arm) : arm.x != 0.0 ? factors.x : factors.y;
        factors = Vec2{1.0, 1.0} * given.value_or(along);
    }
    return {atLeast(factors.x), atLeast(factors.y)};
}

double TransformHandles::angle() const {
    if (const std::optional<double> given = entry_.value(EntryField::Angle)) {
        return *given;
    }
    const Vec2 centre = fixedPoint();
    const double turn = std::remainder(degrees(last_.place - centre) - degrees(pressPlace_ - centre), 360.0);
    return last_.modifiers.shift() ? std::round(turn / angleStep_) * angleStep_ : turn;
}

PlaneMap TransformHandles::map() const {
    return handle_.rotates ? PlaneMap::rotation(angle(), fixedPoint()) : PlaneMap::scaling(factors(), fixedPoint());
}

bool TransformHandles::typed(const CanvasEvent &event, Shell &context) {
    const bool isKey = event.kind == CanvasEvent::Kind::Key;
    if (!active()) {
        return false;
    }
    const std::array fields{handle_.rotates ? EntryField::Angle : EntryField::Factor};
    const NumericEntry::Answer answer = entry_.handle(event, fields, start_->spacing.names, {}, start_->unit);
    if (answer == NumericEntry::Answer::Unused && isKey && event.key == key::kEscape) {
        context.document.abandonStroke(stroke_);
        end();
        return true;
    }
    if (answer != NumericEntry::Answer::Unused) {
        away_ = true;
        update(context);
    }
    if (answer == NumericEntry::Answer::Place) {
        finish(context);
    }
    return true; // no shortcut runs during a drag
}

std::string TransformHandles::measure() const {
    if (handle_.rotates) {
        return "\xe2\x88\xa0 " + ui::number(angle(), 4) + "\xc2\xb0";
    }
    const Vec2 by = factors(), size = startBox_.size();
    const std::string factor = by.x == by.y ? percent(by.x) : percent(by.x) + " \xc3\x97 " + percent(by.y);
    return factor + "   " + ui::number(std::abs(by.x) * size.x) + " \xc3\x97 " + ui::number(std::abs(by.y) * size.y);
}

std::vector<Vec2> TransformHandles::places(const Shell &context) const {
    std::vector<Vec2> shown;
    const Box2 &around = box(context);
    for (const Handle &handle : kHandles) {
        const std::optional<Vec2> there = around.empty() ? std::nullopt : placeOf(handle, around, context);
        if (there) {
            shown.push_back(*there);
        }
    }
    return shown;
}

void TransformHandles::draw(CanvasPainter &painter, Shell &context, const std::optional<Handle> &hovered) const {
    const Theme &theme = context.theme;
    if (active() && away_) {
        const Vec2 fixed = fixedPoint();
        painter.cross(fixed, 5.0, theme.selection, 1.5);
        if (handle_.rotates) {
            painter.dashed(fixed, last_.place, fade(theme.selection, 0.6), 1.0);
        } else {
            drawSnapMark(painter, context, target_);
        }
        painter.label(last_.place, {16.0, 14.0}, measure(), theme.text, fade(theme.popup, 0.9), context.fonts.small);
        const std::string entered = entry_.label();
        const std::string &second = fault_.empty() ? entered : fault_;
        if (!second.empty()) {
            painter.label(last_.place, {16.0, 36.0}, second,
                          entry_.isWrong() || !fault_.empty() ? theme.bad : theme.accent, theme.popup,
                          context.fonts.strong);
        }
        drawUsedOnce(painter, context, entry_, last_.place, 60.0);
        return;
    }
    const Box2 &around = box(context);
    if (around.empty()) {
        return;
    }
    const double gap = EditState::reach(context, kHandleGap);
    painter.rectangle({around.min - Vec2{gap, gap}, around.max + Vec2{gap, gap}}, fade(theme.selection, 0.35), 1.0);
    for (const Handle &handle : kHandles) {
        const std::optional<Vec2> there = placeOf(handle, around, context);
        if (!there) {
            continue;
        }
        const Colour fill = hovered == handle ? theme.selection : theme.canvas;
        if (handle.rotates) {
            painter.dot(*there, 5.5, theme.selection);
            painter.dot(*there, 4.0, fill);
        } else {
            painter.handle(*there, 3.5, fill, theme.selection);
        }
    }
}

std::string TransformHandles::statusText(const Handle &handle) {
    return handle.rotates
               ? "Drag to rotate, or type the angle. Shift: angle steps, Esc: cancel"
               : "Drag to scale, or type the factor. Shift: keep proportions, Ctrl: about the centre, Alt: no snapping";
}

} // namespace forefront
