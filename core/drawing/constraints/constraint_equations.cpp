#include "core/drawing/constraints/constraint_equations.hpp"

#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

using Ends = DocumentSketch::Ends;
using Role = ShapeUnknown::Role;

constexpr double kDegree = std::numbers::pi / 180.0;

/// A direction, from a to b.
Vec2 along(const DocumentSketch &sketch, const Ends &ends) {
    return sketch.system.place(ends.b) - sketch.system.place(ends.a);
}

/// Returns the angle from one direction to another in degrees, from -180 to 180.
double degreesBetween(const DocumentSketch &sketch, const Ends &first, const Ends &second) {
    const Vec2 d = along(sketch, first), e = along(sketch, second);
    return std::atan2(cross(d, e), dot(d, e)) / kDegree;
}

/// Returns the distance of a point to the left of a line; for a line without length, 0.
double leftOfLine(const DocumentSketch &sketch, SketchPoint p, const Ends &line) {
    const Vec2 d = along(sketch, line);
    const double size = length(d);
    return size > 0.0 ? cross(d, sketch.system.place(p) - sketch.system.place(line.a)) / size : 0.0;
}

int signOfSide(double value) {
    return value < 0.0 ? -1 : 1;
}

/// Returns two directions that a tangent constraint of curves that meet at ends keeps at a turn: that of a line or of
/// the handle of a Bézier curve, or the radius of a circle.
std::array<Ends, 2> directionsAtJoint(DocumentSketch &sketch, const SketchConstraint &constraint) {
    std::array<Ends, 2> pair;
    for (std::size_t k = 0; k < 2; ++k) {
        const SketchPart &part = constraint.parts[k], &end = constraint.parts[k + 2];
        switch (formOfPart(sketch.document(), part)) {
        case PartForm::Line:
            pair[k] = sketch.direction(part);
            break;
        case PartForm::Circle: {
            const SketchPoint centre = sketch.round(part).centre;
            pair[k] = {centre, sketch.point(end)};
            break;
        }
        default: {
            const bool start = end.index == part.index;
            const SketchPoint node = sketch.point(end);
            pair[k] = {node,
                       sketch.point({part.shape, start ? SketchPartKind::StartControl : SketchPartKind::EndControl,
                                     part.index})};
        }
        }
    }
    return pair;
}

/// Returns the lines of a constraint that keeps a turn, and whether the turn is right rather than straight.
std::pair<std::array<Ends, 2>, bool> turningLines(DocumentSketch &sketch, const SketchConstraint &constraint) {
    if (constraint.kind != ConstraintKind::Tangent) {
        const Ends first = sketch.direction(constraint.parts[0]);
        return {{first, sketch.direction(constraint.parts[1])}, constraint.kind == ConstraintKind::Perpendicular};
    }
    const bool circles[] = {formOfPart(sketch.document(), constraint.parts[0]) == PartForm::Circle,
                            formOfPart(sketch.document(), constraint.parts[1]) == PartForm::Circle};
    return {directionsAtJoint(sketch, constraint), circles[0] != circles[1]};
}

bool keepsTurn(const SketchConstraint &constraint) {
    return constraint.kind == ConstraintKind::Parallel || constraint.kind == ConstraintKind::Perpendicular ||
           (constraint.kind == ConstraintKind::Tangent && constraint.parts.size() == 4);
}

/// The point and the line of a distance between a point and a line, or between two lines.
std::pair<SketchPoint, Ends> pointAndLine(DocumentSketch &sketch, const SketchConstraint &constraint) {
    const bool lines = formOfPart(sketch.document(), constraint.parts[0]) == PartForm::Line;
    const Ends line = sketch.line(constraint.parts[lines ? 0 : 1]);
    return {lines ? sketch.line(constraint.parts[1]).a : sketch.point(constraint.parts[0]), line};
}

bool hasLine(const DocumentSketch &sketch, const SketchConstraint &constraint) {
    return formOfPart(sketch.document(), constraint.parts.back()) == PartForm::Line;
}

/// Adds the equations of one constraint.
class EquationWriter {
  public:
    EquationWriter(DocumentSketch &sketch, const SketchConstraint &constraint, const Document &start)
        : sketch_(sketch), constraint_(constraint), parts_(constraint.parts), start_(start) {}

    void write() {
        switch (constraint_.kind) {
        case ConstraintKind::Coincident:
            return addSame(sketch_.point(parts_[0]), sketch_.point(parts_[1]));
        case ConstraintKind::OnCurve:
            return addOnCurve();
        case ConstraintKind::Midpoint:
            return addMidpoint();
        case ConstraintKind::Horizontal:
        case ConstraintKind::Vertical:
            return addLevel();
        case ConstraintKind::Parallel:
        case ConstraintKind::Perpendicular:
            return addTurn();
        case ConstraintKind::Collinear:
            return addCollinear();
        case ConstraintKind::Tangent:
            return addTangent();
        case ConstraintKind::Equal:
            return addEqual();
        case ConstraintKind::Concentric:
            return addSame(sketch_.centre(parts_[0]), sketch_.centre(parts_[1]));
        case ConstraintKind::Symmetric:
            return addSymmetric();
        case ConstraintKind::Fixed:
            return addFixed();
        default:
            return addDimension();
        }
    }

  private:
    void add(const SketchEquation &equation) { sketch_.system.addEquation(equation, constraint_.id); }
    PartForm form(std::size_t k) const { return formOfPart(sketch_.document(), parts_[k]); }
    double side() const { return constraint_.side; }

    void addSame(SketchPoint p, SketchPoint q) {
        add(makeEqual(p.x, q.x));
        add(makeEqual(p.y, q.y));
    }

    void addOnCurve() {
        const SketchPoint p = sketch_.point(parts_[0]);
        switch (form(1)) {
        case PartForm::Line: {
            const Ends line = sketch_.line(parts_[1]);
            return add(makePointLine(p, line.a, line.b, 0.0, 1.0));
        }
        case PartForm::Circle: {
            const DocumentSketch::Round round = sketch_.round(parts_[1]);
            return add(makeOnCircle(p, round.centre, round.radius));
        }
        case PartForm::Ellipse: {
            const DocumentSketch::Axes axes = sketch_.ellipse(parts_[1]);
            return add(makeOnEllipse(p, axes.centre, axes.u, axes.v));
        }
        default:
            return addOnCubic(p);
        }
    }

    void addOnCubic(SketchPoint p) {
        const DocumentSketch::Cubic cubic = sketch_.cubic(parts_[1]);
        const Curve &curve = findShape(sketch_.document(), parts_[1].shape)->path().curves[parts_[1].index];
        const std::uint32_t t =
            sketch_.system.addUnknown(curve.nearest(sketch_.system.place(p)), UnknownKind::Parameter);
        for (const bool across : {true, false}) {
            const auto part = [across](SketchPoint q) { return across ? q.x : q.y; };
            SketchEquation equation;
            equation.kind = EquationKind::OnCubic;
            equation.unknowns = {part(p),        t, part(cubic.start), part(cubic.startOffset), part(cubic.endOffset),
                                 part(cubic.end)};
            add(equation);
        }
    }

    void addMidpoint() {
        const SketchPoint m = sketch_.point(parts_[0]);
        const Ends ends =
            parts_.size() == 2 ? sketch_.line(parts_[1]) : Ends{sketch_.point(parts_[1]), sketch_.point(parts_[2])};
        add(makeMean(m.x, ends.a.x, ends.b.x));
        add(makeMean(m.y, ends.a.y, ends.b.y));
    }

    void addLevel() {
        const Ends ends = parts_.size() == 1 ? sketch_.direction(parts_[0])
                                             : Ends{sketch_.point(parts_[0]), sketch_.point(parts_[1])};
        const bool level = constraint_.kind == ConstraintKind::Horizontal;
        add(level ? makeEqual(ends.a.y, ends.b.y) : makeEqual(ends.a.x, ends.b.x));
    }

    void addTurn() {
        const auto [lines, right] = turningLines(sketch_, constraint_);
        add(makeAngle(lines[0].a, lines[0].b, lines[1].a, lines[1].b, kDegree * constraint_.turn));
    }

    void addCollinear() {
        Ends base = sketch_.line(parts_[0]), other = sketch_.line(parts_[1]);
        if (lengthSquared(along(sketch_, base)) < lengthSquared(along(sketch_, other))) {
            std::swap(base, other); // the longer line gives the better direction
        }
        for (const SketchPoint p : {other.a, other.b}) {
            if (p != base.a && p != base.b) {
                add(makePointLine(p, base.a, base.b, 0.0, 1.0));
            }
        }
    }

    void addTangent() {
        if (keepsTurn(constraint_)) {
            return addTurn();
        }
        if (form(0) != PartForm::Line) {
            const DocumentSketch::Round first = sketch_.round(parts_[0]), second = sketch_.round(parts_[1]);
            return add(makeTangentCircles(first.centre, first.radius, side(), second.centre, second.radius,
                                          constraint_.otherSide));
        }
        const Ends line = sketch_.line(parts_[0]);
        if (form(1) == PartForm::Ellipse) {
            const DocumentSketch::Axes axes = sketch_.ellipse(parts_[1]);
            return add(makeTangentEllipse(line.a, line.b, axes.centre, axes.u, axes.v, side()));
        }
        const DocumentSketch::Round round = sketch_.round(parts_[1]);
        add(makeTangentLine(round.centre, round.radius, line.a, line.b, side()));
    }

    void addEqual() {
        if (form(0) != PartForm::Line) {
            const std::uint32_t first = sketch_.round(parts_[0]).radius;
            return add(makeEqual(first, sketch_.round(parts_[1]).radius));
        }
        const Ends first = sketch_.direction(parts_[0]), second = sketch_.direction(parts_[1]);
        add(makeEqualLength(first.a, first.b, second.a, second.b));
    }

    void addSymmetric() {
        const SketchPoint p = sketch_.point(parts_[0]), q = sketch_.point(parts_[1]);
        if (form(2) == PartForm::Point) {
            const SketchPoint m = sketch_.point(parts_[2]);
            add(makeMean(m.x, p.x, q.x));
            return add(makeMean(m.y, p.y, q.y));
        }
        const Ends line = sketch_.line(parts_[2]);
        add(makeMirrorAcross(p, q, line.a, line.b));
        add(makeMirrorAlong(p, q, line.a, line.b));
    }

    void fix(SketchPoint p, const std::optional<Vec2> &at) {
        const Vec2 to = at.value_or(sketch_.system.place(p));
        add(makeValue(p.x, to.x));
        add(makeValue(p.y, to.y));
    }

    void addFixed() {
        const SketchPart &part = parts_[0];
        const Shape *const shape = findShape(start_, part.shape);
        if (form(0) == PartForm::Point) {
            return fix(sketch_.point(part), placeOfPart(start_, part));
        }
        const bool known = formOfPart(start_, part) == form(0) && shape != nullptr;
        DocumentSketch before(start_);
        if (form(0) == PartForm::Line) {
            const Ends now = sketch_.direction(part), then = known ? before.direction(part) : Ends{};
            fix(now.a, known ? std::optional(before.system.place(then.a)) : std::nullopt);
            return fix(now.b, known ? std::optional(before.system.place(then.b)) : std::nullopt);
        }
        const DocumentSketch::Round now = sketch_.round(part);
        const DocumentSketch::Round then = known ? before.round(part) : DocumentSketch::Round{};
        fix(now.centre, known ? std::optional(before.system.place(then.centre)) : std::nullopt);
        add(makeValue(now.radius, known ? before.system.values[then.radius] : sketch_.system.values[now.radius]));
    }

    void addDimension() {
        const double value = constraint_.value;
        switch (constraint_.kind) {
        case ConstraintKind::Length:
        case ConstraintKind::Distance: {
            if (hasLine(sketch_, constraint_)) {
                const auto [point, line] = pointAndLine(sketch_, constraint_);
                return add(makePointLine(point, line.a, line.b, value, side()));
            }
            const SketchPoint p = sketch_.point(parts_[0]);
            return add(makeDistance(p, sketch_.point(parts_[1]), value));
        }
        case ConstraintKind::HorizontalDistance:
        case ConstraintKind::VerticalDistance: {
            const SketchPoint p = sketch_.point(parts_[0]), q = sketch_.point(parts_[1]);
            const bool level = constraint_.kind == ConstraintKind::HorizontalDistance;
            return add(makeDifference(level ? p.x : p.y, level ? q.x : q.y, value, side()));
        }
        case ConstraintKind::Angle: {
            const Ends first = sketch_.direction(parts_[0]), second = sketch_.direction(parts_[1]);
            return add(makeAngle(first.a, first.b, second.a, second.b, kDegree * (constraint_.turn + side() * value)));
        }
        default:
            return add(makeValue(sketch_.round(parts_[0]).radius,
                                 constraint_.kind == ConstraintKind::Diameter ? 0.5 * value : value));
        }
    }

    DocumentSketch &sketch_;
    const SketchConstraint &constraint_;
    const std::vector<SketchPart> &parts_;
    const Document &start_;
};

/// Returns whether the lines of an angle are measured from their second ends: an angle is that at the ends that are
/// nearest to each other.
std::array<bool, 2> fromSecondEnds(const DocumentSketch &sketch, const Ends &first, const Ends &second) {
    std::array<bool, 2> best{};
    double nearest = std::numeric_limits<double>::infinity();
    for (const bool a : {true, false}) { // the end of one line, and the start of the next, come first
        for (const bool b : {false, true}) {
            const double gap = distanceSquared(sketch.system.place(a ? first.b : first.a),
                                               sketch.system.place(b ? second.b : second.a));
            if (gap < nearest) {
                nearest = gap;
                best = {a, b};
            }
        }
    }
    return best;
}

void orientTangent(DocumentSketch &sketch, SketchConstraint &constraint) {
    const SketchPart first = constraint.parts[0], second = constraint.parts[1];
    if (formOfPart(sketch.document(), first) == PartForm::Line) {
        constraint.side = signOfSide(leftOfLine(sketch, sketch.centre(second), sketch.line(first)));
        return;
    }
    const DocumentSketch::Round a = sketch.round(first), b = sketch.round(second);
    const double r = sketch.system.values[a.radius], s = sketch.system.values[b.radius];
    const double gap = distance(sketch.system.place(a.centre), sketch.system.place(b.centre));
    const bool outside = std::fabs(gap - (r + s)) <= std::fabs(gap - std::fabs(r - s));
    constraint.side = outside || r >= s ? 1 : -1;
    constraint.otherSide = outside || r < s ? 1 : -1;
}

void orientAngle(DocumentSketch &sketch, SketchConstraint &constraint) {
    const Ends first = sketch.direction(constraint.parts[0]), second = sketch.direction(constraint.parts[1]);
    const std::array<bool, 2> reversed = fromSecondEnds(sketch, first, second);
    constraint.turn = reversed[0] != reversed[1] ? 180 : 0;
    constraint.side = signOfSide(std::remainder(degreesBetween(sketch, first, second) - constraint.turn, 360.0));
}

} // namespace

void addEquations(DocumentSketch &sketch, const SketchConstraint &constraint, const Document &start) {
    EquationWriter(sketch, constraint, start).write();
}

SketchConstraint oriented(DocumentSketch &sketch, SketchConstraint constraint) {
    const auto gap = [&](bool level) {
        const SketchPoint p = sketch.point(constraint.parts[0]), q = sketch.point(constraint.parts[1]);
        const Vec2 by = sketch.system.place(q) - sketch.system.place(p);
        return level ? by.x : by.y;
    };
    if (keepsTurn(constraint)) {
        const auto [lines, right] = turningLines(sketch, constraint);
        const double degrees = degreesBetween(sketch, lines[0], lines[1]);
        constraint.turn = right ? 90 * signOfSide(degrees) : std::fabs(degrees) <= 90.0 ? 0 : 180;
        return constraint;
    }
    switch (constraint.kind) {
    case ConstraintKind::Tangent:
        orientTangent(sketch, constraint);
        break;
    case ConstraintKind::Distance:
        if (hasLine(sketch, constraint)) {
            const auto [point, line] = pointAndLine(sketch, constraint);
            constraint.side = signOfSide(leftOfLine(sketch, point, line));
        }
        break;
    case ConstraintKind::HorizontalDistance:
        constraint.side = signOfSide(gap(true));
        break;
    case ConstraintKind::VerticalDistance:
        constraint.side = signOfSide(gap(false));
        break;
    case ConstraintKind::Angle:
        orientAngle(sketch, constraint);
        break;
    default:
        break;
    }
    return constraint;
}

double measured(DocumentSketch &sketch, const SketchConstraint &constraint) {
    const std::vector<SketchPart> &parts = constraint.parts;
    const auto between = [&] {
        const SketchPoint p = sketch.point(parts[0]), q = sketch.point(parts[1]);
        return sketch.system.place(q) - sketch.system.place(p);
    };
    switch (constraint.kind) {
    case ConstraintKind::Length:
    case ConstraintKind::Distance: {
        if (hasLine(sketch, constraint)) {
            const auto [point, line] = pointAndLine(sketch, constraint);
            return std::fabs(leftOfLine(sketch, point, line));
        }
        return length(between());
    }
    case ConstraintKind::HorizontalDistance:
        return std::fabs(between().x);
    case ConstraintKind::VerticalDistance:
        return std::fabs(between().y);
    case ConstraintKind::Angle: {
        const Ends first = sketch.direction(parts[0]), second = sketch.direction(parts[1]);
        return constraint.side * std::remainder(degreesBetween(sketch, first, second) - constraint.turn, 360.0);
    }
    case ConstraintKind::Radius:
    case ConstraintKind::Diameter: {
        const double radius = sketch.system.values[sketch.round(parts[0]).radius];
        return constraint.kind == ConstraintKind::Radius ? radius : 2.0 * radius;
    }
    default:
        return 0.0;
    }
}

DocumentSketch sketchOf(const Document &document, const Document &start, const JointSource &joints) {
    DocumentSketch sketch(document);
    for (const auto &constraint : document.constraints) {
        if (partsFault(document, constraint->kind, constraint->parts).empty()) {
            addEquations(sketch, *constraint, start);
        }
    }
    sketch.finish(joints);
    return sketch;
}

} // namespace forefront
