#include "core/drawing/constraints/constraint_figures.hpp"

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

namespace forefront {
namespace {

Vec2 directionFrom(Vec2 a, Vec2 b) {
    const Vec2 way = b - a;
    const double size = length(way);
    return size > 0.0 ? (1.0 / size) * way : Vec2{1.0, 0.0};
}

/// Returns the middle of a line or curve with its direction there.
GlyphAnchor middleOf(const Document &document, const SketchPart &part) {
    if (part.kind >= SketchPartKind::Origin) {
        return {part, {}, part.kind == SketchPartKind::YAxis ? Vec2{0.0, 1.0} : Vec2{1.0, 0.0}};
    }
    const Outline outline = outlineOf(*findShape(document, part.shape));
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) == part.index) {
            const Curve curve = outline.curve(k);
            // A whole circle begins at a handle; its glyph lies a quarter turn further.
            const double t = taggedSegments(*findShape(document, part.shape)) == 1 && outline.closed ? 0.125 : 0.5;
            return {part, curve.point(t), directionFrom({}, curve.derivative(t))};
        }
    }
    return {part, {}, {1.0, 0.0}};
}

/// The ends of a line of a drawing.
std::pair<Vec2, Vec2> lineOf(const Document &document, const SketchPart &part) {
    DocumentSketch sketch(document);
    const DocumentSketch::Ends ends = sketch.line(part);
    return {sketch.system.place(ends.a), sketch.system.place(ends.b)};
}

Vec2 footOn(std::pair<Vec2, Vec2> line, Vec2 p) {
    const Vec2 along = directionFrom(line.first, line.second);
    return line.first + dot(p - line.first, along) * along;
}

/// Returns the two places whose distance a linear dimension measures.
std::pair<Vec2, Vec2> measuredPlaces(const Document &document, const SketchConstraint &constraint) {
    const SketchPart &first = constraint.parts[0], &second = constraint.parts[1];
    const auto p = placeOfPart(document, first), q = placeOfPart(document, second);
    if (p && q) {
        return {*p, *q};
    }
    const std::pair<Vec2, Vec2> line = lineOf(document, second); // points come before lines
    const Vec2 from = p ? *p : middleOf(document, first).at;
    return {from, footOn(line, from)};
}

/// Returns true if a direction from a place leads into the shapes that a constraint names: inside a single closed one,
/// else towards the middle of their box.
bool leadsInside(const Document &document, const SketchConstraint &constraint, Vec2 place, Vec2 way) {
    constexpr double kStep = 1e-3; // of the box
    Box2 box;
    std::set<std::uint32_t> shapes;
    for (const SketchPart &part : constraint.parts) {
        if (const Shape *const shape = findShape(document, part.shape)) {
            box.add(boundsOf(*shape));
            shapes.insert(part.shape);
        }
    }
    if (box.empty()) {
        return false;
    }
    const Shape &first = *findShape(document, *shapes.begin());
    if (shapes.size() == 1 && isClosed(first)) {
        const double step = kStep * box.diagonal();
        const bool ahead = contains(first, place + step * way), behind = contains(first, place - step * way);
        if (ahead != behind) {
            return ahead;
        }
    }
    return dot(way, place - box.centre()) < 0.0;
}

/// Finds how far the shapes of a linear dimension reach on both sides of it.
void setClear(DimensionFigure &figure, const Document &document, const SketchConstraint &constraint) {
    const Vec2 middle = midpoint(figure.from, figure.to);
    std::set<std::uint32_t> shapes;
    for (const SketchPart &part : constraint.parts) {
        const Shape *const shape = shapes.insert(part.shape).second ? findShape(document, part.shape) : nullptr;
        const Outline outline = shape != nullptr ? outlineOf(*shape) : Outline();
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            const Curve curve = outline.curve(k);
            for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) { // near enough to place a text
                const double away = dot(curve.point(t) - middle, figure.outward);
                figure.clear = std::max(figure.clear, away);
                figure.clearBehind = std::max(figure.clearBehind, -away);
            }
        }
    }
}

/// Returns the ends of a part that is a line; twice a place if it is a point.
std::array<Vec2, 2> endsOfMeasured(const Document &document, const SketchPart &part, Vec2 place) {
    if (placeOfPart(document, part) || part.kind > SketchPartKind::Origin) { // axes have no ends
        return {place, place};
    }
    const auto [a, b] = lineOf(document, part);
    return {a, b};
}

DimensionFigure linearFigure(const Document &document, const SketchConstraint &constraint) {
    DimensionFigure figure;
    std::tie(figure.from, figure.to) = measuredPlaces(document, constraint);
    const Vec2 way = figure.to - figure.from;
    figure.along = constraint.kind == ConstraintKind::HorizontalDistance ? Vec2{way.x < 0.0 ? -1.0 : 1.0, 0.0}
                   : constraint.kind == ConstraintKind::VerticalDistance ? Vec2{0.0, way.y < 0.0 ? -1.0 : 1.0}
                                                                         : directionFrom(figure.from, figure.to);
    figure.outward = leftNormal(figure.along);
    if (leadsInside(document, constraint, midpoint(figure.from, figure.to), figure.outward)) {
        figure.outward = -1.0 * figure.outward;
    }
    figure.fromLine = endsOfMeasured(document, constraint.parts[0], figure.from);
    figure.toLine = endsOfMeasured(document, constraint.parts[1], figure.to);
    setClear(figure, document, constraint);
    return figure;
}

/// Sets the arc that a radius or diameter belongs to, of which its middle is known.
void setArc(DimensionFigure &figure, const Document &document, const SketchPart &part) {
    const Outline outline = outlineOf(*findShape(document, part.shape));
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) == part.index) {
            const Vec2 start = outline.from(k) - figure.from, middle = outline.curve(k).point(0.5) - figure.from;
            figure.begin = std::atan2(start.y, start.x);
            figure.sweep = 2.0 * std::atan2(cross(start, middle), dot(start, middle));
            return;
        }
    }
}

DimensionFigure radialFigure(const Document &document, const SketchConstraint &constraint) {
    DimensionFigure figure;
    figure.form = DimensionFigure::Form::Radial;
    figure.diameter = constraint.kind == ConstraintKind::Diameter;
    const SketchPart &part = constraint.parts[0];
    const Shape &shape = *findShape(document, part.shape);
    figure.to = middleOf(document, part).at;
    if (formOfPart(document, part) == PartForm::Rounding) { // the centre is inside, as far as the radius
        const GlyphAnchor middle = middleOf(document, part);
        const Vec2 inward = leftNormal(middle.along); // rectangles run counter-clockwise
        figure.from = middle.at + shape.as<RectangleForm>().radius * inward;
    } else {
        DocumentSketch sketch(document);
        figure.from = sketch.system.place(sketch.round(part).centre);
    }
    figure.along = figure.outward = directionFrom(figure.from, figure.to);
    if (shape.is<CircleForm>()) {
        figure.begin = std::atan2(figure.along.y, figure.along.x);
        figure.sweep = 2.0 * std::numbers::pi;
    } else {
        setArc(figure, document, part);
    }
    return figure;
}

std::optional<DimensionFigure> angularFigure(const Document &document, const SketchConstraint &constraint) {
    const auto [a, b] = lineOf(document, constraint.parts[0]);
    const auto [p, q] = lineOf(document, constraint.parts[1]);
    const Vec2 u = directionFrom(a, b), v = directionFrom(p, q);
    constexpr double kParallel = 1e-6;
    const double sine = cross(u, v);
    if (std::fabs(sine) < kParallel) {
        return std::nullopt;
    }
    DimensionFigure figure;
    figure.form = DimensionFigure::Form::Angular;
    figure.from = a + (cross(p - a, v) / sine) * u;
    constexpr double kRadians = std::numbers::pi / 180.0; // of a degree
    figure.begin = std::atan2(u.y, u.x) + constraint.turn * kRadians;
    figure.sweep = constraint.side * constraint.value * kRadians;
    const Vec2 first = midpoint(a, b), second = midpoint(p, q);
    const auto ray = [](double angle) { return Vec2{std::cos(angle), std::sin(angle)}; };
    // Of the two angles at the apex, the one between the lines themselves, not between their extensions.
    if (dot(first - figure.from, ray(figure.begin)) + dot(second - figure.from, ray(figure.begin + figure.sweep)) <
        0.0) {
        figure.begin += std::numbers::pi;
    }
    figure.to = distance(a, b) < distance(p, q) ? first : second;
    figure.along = figure.outward = ray(figure.begin + 0.5 * figure.sweep);
    return figure;
}

} // namespace

std::vector<GlyphAnchor> glyphAnchors(const Document &document, const SketchConstraint &constraint) {
    if (!partsFault(document, constraint.kind, constraint.parts).empty()) {
        return {};
    }
    const auto at = [&](const SketchPart &part) {
        const std::optional<Vec2> place = placeOfPart(document, part);
        return place ? GlyphAnchor{part, *place, {1.0, 0.0}} : middleOf(document, part);
    };
    std::vector<GlyphAnchor> anchors;
    switch (constraint.kind) {
    case ConstraintKind::Coincident:
    case ConstraintKind::OnCurve:
    case ConstraintKind::Midpoint:
        anchors.push_back(at(constraint.parts[0]));
        break;
    case ConstraintKind::Horizontal:
    case ConstraintKind::Vertical:
        if (constraint.parts.size() == 2) {
            const GlyphAnchor a = at(constraint.parts[0]), b = at(constraint.parts[1]);
            anchors.push_back({constraint.parts[0], midpoint(a.at, b.at), directionFrom(a.at, b.at)});
        } else {
            anchors.push_back(at(constraint.parts[0]));
        }
        break;
    case ConstraintKind::Tangent:
        if (constraint.parts.size() == 4) { // at the node where they meet
            anchors.push_back(at(constraint.parts[2]));
            break;
        }
        [[fallthrough]];
    default:
        for (const SketchPart &part : constraint.parts) {
            anchors.push_back(at(part));
        }
    }
    // Axes reach through the whole view, so that no place on them is that of the constraint.
    std::erase_if(anchors, [](const GlyphAnchor &anchor) { return anchor.part.kind > SketchPartKind::Origin; });
    return anchors;
}

std::optional<DimensionFigure> dimensionFigure(const Document &document, const SketchConstraint &constraint) {
    if (!isDimension(constraint.kind) || !partsFault(document, constraint.kind, constraint.parts).empty()) {
        return std::nullopt;
    }
    switch (constraint.kind) {
    case ConstraintKind::Radius:
    case ConstraintKind::Diameter:
        return radialFigure(document, constraint);
    case ConstraintKind::Angle:
        return angularFigure(document, constraint);
    default:
        return linearFigure(document, constraint);
    }
}

Vec2 DimensionFigure::placeOf(Vec2 offset) const {
    return form == Form::Linear ? midpoint(from, to) + offset.x * along + offset.y * leftNormal(along) : from + offset;
}

Vec2 DimensionFigure::wayAt(double share) const {
    const double angle = begin + share * sweep;
    return {std::cos(angle), std::sin(angle)};
}

Vec2 DimensionFigure::wayOnArc(Vec2 way) const {
    const Vec2 middle = wayAt(0.5);
    const double aside = std::atan2(cross(middle, way), dot(middle, way));
    constexpr double kRounding = 1e-9;
    if (std::fabs(aside) <= (0.5 + kRounding) * std::fabs(sweep)) {
        return directionFrom({}, way);
    }
    return wayAt((aside < 0.0) == (sweep < 0.0) ? 1.0 : 0.0);
}

Vec2 DimensionFigure::offsetOf(Vec2 place) const {
    if (form != Form::Linear) {
        return place - from;
    }
    const Vec2 way = place - midpoint(from, to);
    return {dot(way, along), dot(way, leftNormal(along))};
}

} // namespace forefront
