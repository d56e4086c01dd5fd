#include "core/drawing/constraints/shape_unknowns.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

const Curve *curveAt(const Shape &shape, std::uint32_t segment, CurveKind kind) {
    const bool has = isPath(shape) && segment < shape.path().curves.size();
    return has && shape.path().curves[segment].kind() == kind ? &shape.path().curves[segment] : nullptr;
}

std::optional<double> radiusAt(const Shape &shape, std::uint32_t segment) {
    return shape.visit(
        [&](const PathForm &) {
            const Curve *const arc = curveAt(shape, segment, CurveKind::Arc);
            return arc != nullptr ? radiusOf(*arc) : std::nullopt;
        },
        [](const RectangleForm &form) { return std::optional(form.radius); },
        [&](const CircleForm &) { return std::optional(circleRadius(shape)); },
        [](const PointForm &) { return std::optional<double>(); },
        [](const EllipseForm &) { return std::optional<double>(); },
        [](const SlotForm &form) { return std::optional(form.radius); });
}

Vec2 endOf(const Shape &shape, std::uint32_t segment) {
    return shape.nodes[(segment + std::size_t{1}) % shape.nodes.size()];
}

/// Returns the arc with another centre and radius from one place to another, on the same side as an arc.
Curve arcAbout(const Curve &arc, Vec2 centre, double radius, Vec2 from, Vec2 to) {
    const std::array<double, 8> n = arc.numbers();
    const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
    const double scale = radius / length(u);
    const auto angleOf = [&](Vec2 p) { return std::atan2(dot(p - centre, v), dot(p - centre, u)); };
    const auto near = [](double angle, double old) {
        return old + std::remainder(angle - old, 2.0 * std::numbers::pi);
    };
    const double start = near(angleOf(from), n[6]), sweep = near(angleOf(to) - start, n[7]);
    return Curve::arc(centre, scale * u, scale * v, start, sweep);
}

/// The new values of one shape.
class ShapeChange {
  public:
    ShapeChange(Shape &shape, const std::map<ShapeUnknown, double> &values) : shape_(shape), values_(values) {}

    void apply() {
        shape_.visit([&](PathForm &) { applyToPath(); },
                     [&](RectangleForm &form) {
                         shape_.nodes = places();
                         form.radius = value(Role::Radius, 0).value_or(form.radius);
                     },
                     [&](CircleForm &) { applyToCircle(); }, [&](PointForm &) { shape_.nodes = places(); },
                     [&](EllipseForm &) { applyToEllipse(); },
                     [&](SlotForm &form) {
                         shape_.nodes = places();
                         form.radius = value(Role::Radius, 0).value_or(form.radius);
                     });
        if (!isPath(shape_)) {
            shape_.cuts.clear();
        }
    }

  private:
    std::optional<double> value(Role role, std::uint32_t index) const {
        const auto found = values_.find({shape_.id, role, index});
        return found != values_.end() ? std::optional(found->second) : std::nullopt;
    }
    Vec2 vector(Role x, Role y, std::uint32_t index, Vec2 otherwise) const {
        return {value(x, index).value_or(otherwise.x), value(y, index).value_or(otherwise.y)};
    }
    std::vector<Vec2> places() const {
        std::vector<Vec2> places = shape_.nodes;
        for (std::uint32_t k = 0; k < places.size(); ++k) {
            places[k] = vector(Role::X, Role::Y, k, places[k]);
        }
        return places;
    }

    void applyToPath() {
        const Shape before = shape_;
        moveNodes(shape_, places());
        for (std::uint32_t k = 0; k < shape_.path().curves.size(); ++k) {
            Curve &curve = shape_.path().curves[k];
            const Curve &old = before.path().curves[k];
            if (value(Role::CentreX, k) && curve.kind() == CurveKind::Arc) {
                const std::array<double, 8> n = old.numbers();
                const Vec2 centre = vector(Role::CentreX, Role::CentreY, k, {n[0], n[1]});
                const double radius = value(Role::Radius, k).value_or(length({n[2], n[3]}));
                const bool same = centre == Vec2{n[0], n[1]} && radius == valueOf(before, Role::Radius, k) &&
                                  shape_.nodes[k] == before.nodes[k] && endOf(shape_, k) == endOf(before, k);
                curve = same ? old : arcAbout(old, centre, radius, shape_.nodes[k], endOf(shape_, k));
            } else if (value(Role::StartX, k) && curve.kind() == CurveKind::Cubic) {
                const std::array<double, 8> n = curve.numbers();
                const Vec2 start = shape_.nodes[k], end = endOf(shape_, k);
                const Vec2 first = vector(Role::StartX, Role::StartY, k, Vec2{n[2], n[3]} - start);
                const Vec2 second = vector(Role::EndX, Role::EndY, k, Vec2{n[4], n[5]} - end);
                curve = Curve::cubic(start, start + first, end + second, end);
            }
            if (curve != old && k < shape_.cuts.size()) {
                shape_.cuts[k].clear();
            }
        }
    }

    void applyToCircle() {
        const Vec2 arm = shape_.nodes[1] - shape_.nodes[0];
        const Vec2 centre = vector(Role::X, Role::Y, 0, shape_.nodes[0]);
        const double before = circleRadius(shape_), radius = value(Role::Radius, 0).value_or(before);
        // A circle that only moves keeps the bits of its radius where the coordinates allow it.
        shape_.nodes[1] =
            radius == before ? shape_.nodes[1] + (centre - shape_.nodes[0]) : centre + (radius / before) * arm;
        shape_.nodes[0] = centre;
    }

    void applyToEllipse() {
        const Vec2 before = shape_.nodes[0], centre = vector(Role::X, Role::Y, 0, before);
        for (const std::uint32_t k : {1U, 2U}) {
            const Vec2 arm = shape_.nodes[k] - before, now = vector(Role::AxisX, Role::AxisY, k, arm);
            shape_.nodes[k] = now == arm ? shape_.nodes[k] + (centre - before) : centre + now;
        }
        shape_.nodes[0] = centre;
    }

    Shape &shape_;
    const std::map<ShapeUnknown, double> &values_;
};

} // namespace

UnknownKind kindOf(Role role) {
    switch (role) {
    case Role::X:
    case Role::CentreX:
        return UnknownKind::X;
    case Role::Y:
    case Role::CentreY:
        return UnknownKind::Y;
    case Role::Radius:
        return UnknownKind::Length;
    default:
        return UnknownKind::Offset;
    }
}

std::optional<double> valueOf(const Shape &shape, Role role, std::uint32_t index) {
    const auto part = [](const std::optional<Vec2> &v, bool across) {
        return v ? std::optional(across ? v->x : v->y) : std::nullopt;
    };
    switch (role) {
    case Role::X:
    case Role::Y:
        return index < shape.nodes.size() ? part(shape.nodes[index], role == Role::X) : std::nullopt;
    case Role::AxisX:
    case Role::AxisY:
        return shape.is<EllipseForm>() && index < shape.nodes.size()
                   ? part(shape.nodes[index] - shape.nodes[0], role == Role::AxisX)
                   : std::nullopt;
    case Role::Radius:
        return radiusAt(shape, index);
    case Role::CentreX:
    case Role::CentreY: {
        const Curve *const arc = curveAt(shape, index, CurveKind::Arc);
        return arc != nullptr ? std::optional(arc->numbers()[role == Role::CentreX ? 0 : 1]) : std::nullopt;
    }
    default: {
        const Curve *const cubic = curveAt(shape, index, CurveKind::Cubic);
        if (cubic == nullptr) {
            return std::nullopt;
        }
        const std::array<double, 8> n = cubic->numbers();
        const bool start = role == Role::StartX || role == Role::StartY;
        const Vec2 offset = start ? Vec2{n[2], n[3]} - shape.nodes[index] : Vec2{n[4], n[5]} - endOf(shape, index);
        return part(offset, role == Role::StartX || role == Role::EndX);
    }
    }
}

void setUnknowns(Shape &shape, const std::map<ShapeUnknown, double> &values) {
    ShapeChange(shape, values).apply();
}

} // namespace forefront
