#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/draw/pen_tool.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace forefront {

std::optional<Vec2> PenTool::heading() const {
    if (path_.empty()) {
        return std::nullopt;
    }
    const Node &last = path_.back();
    if (last.arm != Vec2{}) {
        return last.arm;
    }
    return path_.size() < 2 ? std::nullopt : std::optional(segment(path_[path_.size() - 2], last).tangent(1.0));
}

bool PenTool::wantsMiddle() const {
    return drawsArc() && !isTangent() && !middle_;
}

Curve PenTool::arcTo(Vec2 at) const {
    const Vec2 from = path_.back().at;
    if (at == from) {
        return Curve::line(from, at);
    }
    return isTangent() ? tangentArc(from, *heading(), at)
           : middle_   ? arcThrough(from, *middle_, at)
                       : Curve::line(from, at);
}

Vec2 PenTool::fitted(Vec2 at) {
    const std::optional<double> radius = entry_.value(EntryField::Radius), angle = entry_.value(EntryField::Angle);
    if (!isTangent() || (!radius && !angle)) {
        return at;
    }
    const Vec2 from = path_.back().at, way = (1.0 / length(*heading())) * *heading();
    const double side = cross(way, place_ - from) < 0.0 ? -1.0 : 1.0;
    const Vec2 across = side * leftNormal(way);
    const double turn = std::fabs(angle.value_or(0.0)) * std::numbers::pi / 180.0;
    if (!radius) { // the chord turns by half of the arc; its length follows the pointer
        const Vec2 chord = std::cos(0.5 * turn) * way + std::sin(0.5 * turn) * across;
        return from + std::fabs(dot(place_ - from, chord)) * chord;
    }
    const Vec2 centre = from + *radius * across, arm = place_ - centre;
    if (angle) {
        return centre - *radius * (std::cos(turn) * across - std::sin(turn) * way);
    }
    return length(arm) > 0.0 ? centre + (*radius / length(arm)) * arm : centre + *radius * across;
}

std::string_view PenTool::ownLetters() const {
    return mode_ == PenMode::Corners ? "AL" : "";
}

bool PenTool::ownKey(int key, Shell &context) {
    if (mode_ != PenMode::Corners || (key != 'A' && key != 'L')) {
        return false;
    }
    segment_ = key == 'L' ? PenSegment::Line : isTangent() ? PenSegment::Through : PenSegment::Tangent;
    middle_.reset();
    context.animate();
    return true;
}

std::span<const EntryField> PenTool::entryFields() const {
    static constexpr std::array kTangent{EntryField::Radius, EntryField::Angle};
    return isTangent() ? std::span<const EntryField>(kTangent) : DrawingTool::entryFields();
}

PlaceFormula PenTool::typedFormula(Vec2 at) const {
    const std::string radius = entry_.expression(EntryField::Radius);
    if (!isTangent() || entry_.pair() || radius.empty()) {
        return isTangent() && !entry_.pair() ? PlaceFormula{} : DrawingTool::typedFormula(at);
    }
    // The arc grows about the last node, so that it stays tangent.
    const PlaceFormula from = formulaOf(path_.back().at);
    const Vec2 chord = at - path_.back().at;
    const double factor = length(chord) / entry_.value(EntryField::Radius).value_or(1.0);
    const std::string size = std::fabs(factor - 1.0) < 1e-12 ? radius : exactText(factor) + "*(" + radius + ")";
    const PlaceFormula end = polarFormula(from, size, degreesText(chord));
    return {usesNames(end.x) ? end.x : "", usesNames(end.y) ? end.y : ""};
}

bool PenTool::followsEntry() const {
    return isTangent() ? !usesNames(entry_.expression(EntryField::Angle)) : DrawingTool::followsEntry();
}

void PenTool::keepFormulas(const Shape &drawn, const Keep &keep) const {
    DrawingTool::keepFormulas(drawn, keep);
    if (drawn.nodes.size() != path_.size()) {
        return; // nodes were inserted where the path meets itself
    }
    for (std::uint32_t k = 0; k < path_.size(); ++k) {
        const Node &end = path_[(k + 1) % path_.size()];
        if (k < drawn.path().curves.size() && usesNames(end.radius)) {
            keep(Quantity::ArcRadius, k, end.radius);
        }
    }
}

} // namespace forefront
