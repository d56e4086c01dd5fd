#include "core/drawing/shapes/slot.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

/// Returns the direction from the first centre to the second; along x if they coincide, as while formulas are applied.
Vec2 directionOf(const Shape &slot) {
    const Vec2 arm = slot.nodes[1] - slot.nodes[0];
    const double part = 1.0 / length(arm);
    return std::isfinite(part) ? part * arm : Vec2{1.0, 0.0};
}

} // namespace

Shape slotAround(Vec2 a, Vec2 b, double radius) {
    Shape shape;
    if (a == b) {
        shape.form = CircleForm{};
        shape.nodes = {a, a + Vec2{radius, 0.0}};
        return shape;
    }
    shape.form = SlotForm{radius};
    shape.nodes = {a, b};
    return shape;
}

bool isSoundSlot(const Shape &slot) {
    const double radius = slot.as<SlotForm>().radius;
    return slot.nodes.size() == 2 && radius > 0.0 && std::isfinite(radius / distance(slot.nodes[0], slot.nodes[1]));
}

Outline slotOutline(const Shape &slot) {
    const Vec2 a = slot.nodes[0], b = slot.nodes[1];
    const Vec2 along = (slot.as<SlotForm>().radius / distance(a, b)) * (b - a), left = leftNormal(along);
    return {{a - left, b - left, b + left, a + left},
            true,
            {Curve(), Curve::arc(b, -1.0 * left, along, 0.0, std::numbers::pi), Curve(),
             Curve::arc(a, left, -1.0 * along, 0.0, std::numbers::pi)},
            {}};
}

Vec2 slotSide(const Shape &slot) {
    return midpoint(slot.nodes[0], slot.nodes[1]) + slot.as<SlotForm>().radius * leftNormal(directionOf(slot));
}

void placeSlotHandle(Shape &slot, std::uint32_t handle, Vec2 to) {
    if (handle < 2) {
        slot.nodes[handle] = to;
    } else {
        slot.as<SlotForm>().radius = std::fabs(dot(to - slot.nodes[0], leftNormal(directionOf(slot))));
    }
}

void setSlotLength(Shape &slot, double length) {
    slot.nodes[1] = slot.nodes[0] + length * directionOf(slot);
}

void mapSlot(Shape &slot, const PlaneMap &map) {
    slot.nodes = {map(slot.nodes[0]), map(slot.nodes[1])};
    slot.as<SlotForm>().radius *= std::sqrt(std::fabs(map.determinant()));
    if (map.determinant() < 0.0 && slot.segmentTags.size() == 4) {
        std::swap(slot.segmentTags[0], slot.segmentTags[2]); // left and right have changed places
    }
    if (map.determinant() < 0.0) {
        auto left = slot.segmentSizes.extract(0), right = slot.segmentSizes.extract(2);
        for (auto *const side : {&left, &right}) {
            if (!side->empty()) {
                side->key() = 2 - side->key();
                slot.segmentSizes.insert(std::move(*side));
            }
        }
    }
    slot.cuts.clear();
}

bool isSlot(const Shape &shape) {
    if (shape.is<SlotForm>()) {
        return true;
    }
    if (!shape.isPolygon() || shape.nodes.size() != 4 || shape.path().curves.size() != 4) {
        return false;
    }
    const std::vector<Curve> &curves = shape.path().curves;
    constexpr double kSame = 1e-6; // relative: transformed slots keep their form only nearly
    const auto isArc = [&](std::size_t k) { return curves[k].kind() == CurveKind::Arc; };
    const std::size_t first = isArc(0) ? 0 : 1;
    for (const std::size_t k : {first, first + 2}) {
        const Vec2 from = shape.nodes[k], to = shape.nodes[(k + 1) % 4];
        const Vec2 centre = midpoint(from, to), across = to - from;
        const Vec2 opposite = midpoint(shape.nodes[(k + 2) % 4], shape.nodes[(k + 3) % 4]);
        const double radius = 0.5 * length(across), limit = kSame * radius;
        const Vec2 along = (1.0 / distance(centre, opposite)) * (centre - opposite);
        if (!isArc(k) || curves[(k + 1) % 4].kind() != CurveKind::Line || !(std::fabs(dot(along, across)) <= limit) ||
            !(distance(curves[k].point(0.5), centre + radius * along) <= limit) ||
            !(std::fabs(distance(curves[k].point(0.25), centre) - radius) <= limit)) {
            return false;
        }
    }
    return std::fabs(distance(shape.nodes[0], shape.nodes[1]) - distance(shape.nodes[2], shape.nodes[3])) <=
           kSame * distance(shape.nodes[0], shape.nodes[2]);
}

Shape slotLike(const Shape &path) {
    const auto centreOf = [&](std::size_t k) {
        const auto numbers = path.path().curves[k].numbers();
        return Vec2{numbers[0], numbers[1]};
    };
    const std::size_t first = path.path().curves[0].kind() == CurveKind::Arc ? 0 : 1;
    Shape slot = path;
    slot.form = SlotForm{0.5 * distance(path.nodes[first], path.nodes[(first + 1) % 4])};
    slot.nodes = {centreOf(first + 2), centreOf(first)};
    slot.cuts.clear();
    slot.nodeSizes.clear();
    slot.segmentSizes.clear(); // its segments take those at their places
    const Outline outline = slotOutline(slot), before = outlineOf(path);
    for (std::size_t k = 0; k < slot.segmentTags.size(); ++k) {
        const Vec2 middle = outline.curve(k).point(0.5);
        std::size_t nearest = 0;
        for (std::size_t s = 1; s < 4; ++s) {
            const auto gap = [&](std::size_t segment) { return distance(before.curve(segment).point(0.5), middle); };
            nearest = gap(s) < gap(nearest) ? s : nearest;
        }
        slot.segmentTags[k] = segmentTag(path, static_cast<std::uint32_t>(nearest));
    }
    return slot;
}

Result<Document> convertToSlot(const Document &document, std::uint32_t id) {
    const Shape *const shape = findShape(document, id);
    if (shape == nullptr || !isPath(*shape) || !isSlot(*shape)) {
        return error("not-possible", "the shape is not slot-shaped",
                     "select a path of two parallel sides and two half circles");
    }
    if (!shape->nodeSizes.empty()) {
        return error("not-possible", displayName(*shape) + " has element sizes at nodes, which a slot cannot have",
                     "remove them, or give its boundary part a size");
    }
    return replaceShape(document, slotLike(*shape));
}

} // namespace forefront
