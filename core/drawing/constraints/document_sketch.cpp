#include "core/drawing/constraints/document_sketch.hpp"

#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

constexpr double kRightAngle = 0.5 * std::numbers::pi;

std::uint32_t nodeAfter(const Shape &path, std::uint32_t k) {
    return static_cast<std::uint32_t>((k + std::size_t{1}) % path.nodes.size());
}

/// Returns true if a shape has some numbers already.
bool hasValues(const Shape &shape, const std::map<ShapeUnknown, double> &values) {
    return std::all_of(values.begin(), values.end(), [&](const auto &value) {
        return valueOf(shape, value.first.role, value.first.index) == value.second;
    });
}

/// Returns 1 or -1.
double signOf(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

} // namespace

const Shape &DocumentSketch::shapeOf(std::uint32_t id) const {
    return *findShape(document_, id);
}

std::uint32_t DocumentSketch::unknown(const Shape &shape, Role role, std::uint32_t index) {
    const auto [place, fresh] = indices_.try_emplace({shape.id, role, index}, 0);
    if (fresh) {
        place->second = system.addUnknown(*valueOf(shape, role, index), kindOf(role));
        system.held.back() = shape.locked;
        holdsNumbers_ = holdsNumbers_ || shape.locked;
        shapes_.insert(shape.id);
    }
    return place->second;
}

SketchPoint DocumentSketch::node(const Shape &shape, std::uint32_t index) {
    const std::uint32_t x = unknown(shape, Role::X, index);
    return {x, unknown(shape, Role::Y, index)};
}

SketchPoint DocumentSketch::corner(const Shape &rectangle, std::uint32_t index) {
    // Corners 0 and 2 are the nodes; corner 1 shares y with 0 and x with 2, corner 3 the reverse.
    const std::uint32_t x = unknown(rectangle, Role::X, index == 1 || index == 2 ? 1 : 0);
    return {x, unknown(rectangle, Role::Y, index >= 2 ? 1 : 0)};
}

SketchPoint DocumentSketch::constant(Vec2 at) {
    const SketchPoint point = system.addPoint(at);
    system.held[point.x] = system.held[point.y] = true;
    return point;
}

SketchPoint DocumentSketch::moved(const Shape &shape, SketchPoint from, SketchPoint offset, const SketchPart &part) {
    const auto found = derived_.find(part);
    if (found != derived_.end()) {
        return found->second;
    }
    const SketchPoint point = system.addPoint(system.place(from) + system.place(offset));
    system.held[point.x] = system.held[point.y] = shape.locked;
    system.addEquation(makeSum(point.x, from.x, offset.x), 0);
    system.addEquation(makeSum(point.y, from.y, offset.y), 0);
    derived_.emplace(part, point);
    return point;
}

SketchPoint DocumentSketch::point(const SketchPart &part) {
    if (part.kind == SketchPartKind::Origin) {
        origin_ = origin_ ? origin_ : std::optional(constant({}));
        return *origin_;
    }
    const Shape &shape = shapeOf(part.shape);
    switch (part.kind) {
    case SketchPartKind::Centre:
        return arc(shape, part.index).centre;
    case SketchPartKind::StartControl: {
        const Cubic curve = cubicOf(shape, part.index);
        return moved(shape, curve.start, curve.startOffset, part);
    }
    case SketchPartKind::EndControl: {
        const Cubic curve = cubicOf(shape, part.index);
        return moved(shape, curve.end, curve.endOffset, part);
    }
    default:
        break;
    }
    if (shape.is<RectangleForm>()) {
        return corner(shape, part.index);
    }
    if (shape.is<EllipseForm>() && part.index > 0) {
        const Axes all = axes(shape);
        return moved(shape, all.centre, part.index == 1 ? all.u : all.v, part);
    }
    return node(shape, part.index);
}

DocumentSketch::Ends DocumentSketch::pathEnds(const Shape &path, std::uint32_t segment) {
    const SketchPoint a = node(path, segment);
    return {a, node(path, nodeAfter(path, segment))};
}

DocumentSketch::Ends DocumentSketch::slotSide(const Shape &slot, std::uint32_t segment) {
    const SketchPart part{slot.id, SketchPartKind::Segment, segment};
    const auto found = sides_.find(part);
    if (found != sides_.end()) {
        return found->second;
    }
    const SketchPoint from = node(slot, 0), to = node(slot, 1);
    const std::uint32_t radius = unknown(slot, Role::Radius, 0);
    const Outline outline = outlineOf(slot);
    const double side = segment == 0 ? -1.0 : 1.0; // the first side lies to the right of the line between the centres
    Ends ends;
    for (SketchPoint *const end : {&ends.a, &ends.b}) {
        const bool first = end == &ends.a;
        *end = system.addPoint(first ? outline.from(segment) : outline.to(segment));
        system.held[end->x] = system.held[end->y] = slot.locked;
        const SketchPoint centre = first == (segment == 0) ? from : to;
        system.addEquation(makeTangentLine(*end, radius, from, to, side), 0);
        system.addEquation(makeAngle(from, to, centre, *end, side * kRightAngle), 0);
    }
    sides_.emplace(part, ends);
    return ends;
}

DocumentSketch::Ends DocumentSketch::line(const SketchPart &part) {
    if (part.kind >= SketchPartKind::Origin) {
        const bool along = part.kind == SketchPartKind::XAxis;
        std::optional<SketchPoint> &end = along ? alongX_ : alongY_;
        end = end ? end : std::optional(constant(along ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0}));
        return {point({0, SketchPartKind::Origin, 0}), *end};
    }
    const Shape &shape = shapeOf(part.shape);
    if (shape.is<RectangleForm>()) {
        const SketchPoint a = corner(shape, part.index);
        return {a, corner(shape, (part.index + 1) % 4)};
    }
    return shape.is<SlotForm>() ? slotSide(shape, part.index) : pathEnds(shape, part.index);
}

DocumentSketch::Ends DocumentSketch::direction(const SketchPart &part) {
    const Shape *const shape = findShape(document_, part.shape);
    if (part.kind == SketchPartKind::Segment && shape != nullptr && shape->is<SlotForm>()) {
        const SketchPoint a = node(*shape, 0), b = node(*shape, 1);
        return part.index == 0 ? Ends{a, b} : Ends{b, a};
    }
    return line(part);
}

DocumentSketch::Round DocumentSketch::arc(const Shape &path, std::uint32_t segment) {
    const std::uint32_t x = unknown(path, Role::CentreX, segment);
    const Round round{{x, unknown(path, Role::CentreY, segment)}, unknown(path, Role::Radius, segment)};
    if (arcs_.insert({path.id, segment}).second) {
        const Ends ends = pathEnds(path, segment);
        system.addEquation(makeOnCircle(ends.a, round.centre, round.radius), 0);
        system.addEquation(makeOnCircle(ends.b, round.centre, round.radius), 0);
    }
    return round;
}

DocumentSketch::Round DocumentSketch::round(const SketchPart &part) {
    const Shape &shape = shapeOf(part.shape);
    if (isPath(shape)) {
        return arc(shape, part.index);
    }
    const std::uint32_t radius = unknown(shape, Role::Radius, 0);
    if (shape.is<RectangleForm>()) {
        return {{}, radius};
    }
    return {node(shape, shape.is<SlotForm>() && part.index == 1 ? 1 : 0), radius};
}

DocumentSketch::Axes DocumentSketch::axes(const Shape &ellipse) {
    const SketchPoint centre = node(ellipse, 0);
    const auto axis = [&](std::uint32_t k) {
        const std::uint32_t x = unknown(ellipse, Role::AxisX, k);
        return SketchPoint{x, unknown(ellipse, Role::AxisY, k)};
    };
    const SketchPoint u = axis(1), v = axis(2);
    if (ellipses_.insert(ellipse.id).second) {
        constexpr double kPerpendicular = 1e-9;
        const Vec2 a = system.place(u), b = system.place(v);
        if (std::fabs(dot(a, b)) <= kPerpendicular * length(a) * length(b)) {
            if (!zero_) {
                zero_ = system.addOffset({});
                system.held[zero_->x] = system.held[zero_->y] = true;
            }
            system.addEquation(makeAngle(*zero_, u, *zero_, v, signOf(cross(a, b)) * kRightAngle), 0);
        }
    }
    return {centre, u, v};
}

DocumentSketch::Axes DocumentSketch::ellipse(const SketchPart &part) {
    return axes(shapeOf(part.shape));
}

DocumentSketch::Cubic DocumentSketch::cubicOf(const Shape &path, std::uint32_t segment) {
    const Ends ends = pathEnds(path, segment);
    const std::uint32_t startX = unknown(path, Role::StartX, segment), startY = unknown(path, Role::StartY, segment);
    const std::uint32_t endX = unknown(path, Role::EndX, segment), endY = unknown(path, Role::EndY, segment);
    return {ends.a, ends.b, {startX, startY}, {endX, endY}};
}

DocumentSketch::Cubic DocumentSketch::cubic(const SketchPart &part) {
    return cubicOf(shapeOf(part.shape), part.index);
}

SketchPoint DocumentSketch::centre(const SketchPart &part) {
    return formOfPart(document_, part) == PartForm::Ellipse ? ellipse(part).centre : round(part).centre;
}

std::optional<std::uint32_t> DocumentSketch::find(const ShapeUnknown &unknown) const {
    const auto found = indices_.find(unknown);
    return found != indices_.end() ? std::optional(found->second) : std::nullopt;
}

std::vector<std::uint32_t> DocumentSketch::unknownsOf(const SketchPart &part) {
    std::vector<std::uint32_t> list;
    const auto add = [&](SketchPoint p) { list.insert(list.end(), {p.x, p.y}); };
    const auto addEnds = [&](SketchPoint a, SketchPoint b) {
        add(a);
        add(b);
    };
    switch (formOfPart(document_, part)) {
    case PartForm::None:
        break;
    case PartForm::Point:
        add(point(part));
        break;
    case PartForm::Line: {
        const Ends ends = line(part);
        addEnds(ends.a, ends.b);
        break;
    }
    case PartForm::Circle: {
        const Round all = round(part);
        add(all.centre);
        list.push_back(all.radius);
        if (const Shape &shape = shapeOf(part.shape); isPath(shape)) {
            const Ends ends = pathEnds(shape, part.index);
            addEnds(ends.a, ends.b);
        }
        break;
    }
    case PartForm::Rounding:
        list.push_back(round(part).radius);
        break;
    case PartForm::Ellipse: {
        const Axes all = ellipse(part);
        add(all.centre);
        addEnds(all.u, all.v);
        break;
    }
    case PartForm::Cubic: {
        const Cubic all = cubic(part);
        addEnds(all.start, all.end);
        addEnds(all.startOffset, all.endOffset);
        break;
    }
    }
    return list;
}

Document DocumentSketch::withValues(const std::vector<double> &values) const {
    std::map<std::uint32_t, std::map<ShapeUnknown, double>> changes; // by shape
    std::set<std::uint32_t> changed;
    for (const auto &[unknown, index] : indices_) {
        changes[unknown.shape].emplace(unknown, values[index]);
        if (values[index] != system.values[index]) {
            changed.insert(unknown.shape);
        }
    }
    Document next = document_;
    for (const std::uint32_t id : changed) {
        std::shared_ptr<const Shape> &place = next.shapes[positionOf(next, id)];
        Shape shape = *place;
        setUnknowns(shape, changes[id]);
        place = std::make_shared<const Shape>(std::move(shape));
    }
    return next;
}

Document DocumentSketch::withValues(const std::vector<double> &values, Document of) const {
    std::map<std::uint32_t, std::map<ShapeUnknown, double>> changes;
    for (const auto &[unknown, index] : indices_) {
        changes[unknown.shape].emplace(unknown, values[index]);
    }
    for (const auto &[id, numbers] : changes) {
        const std::size_t at = positionOf(of, id);
        if (at < of.shapes.size() && !hasValues(*of.shapes[at], numbers)) {
            Shape shape = *of.shapes[at];
            setUnknowns(shape, numbers);
            of.shapes[at] = std::make_shared<const Shape>(std::move(shape));
        }
    }
    return of;
}

std::vector<bool> DocumentSketch::isStanding() const {
    std::vector<bool> is(system.values.size(), false);
    for (const std::uint32_t unknown : standing) {
        is[unknown] = true;
    }
    return is;
}

bool DocumentSketch::holdsNumbers() const {
    return holdsNumbers_;
}

} // namespace forefront
