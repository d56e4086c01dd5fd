#include "core/drawing/formulas/shape_numbers.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace forefront {
namespace {

std::optional<double> boxNumber(const Shape &rectangle, Quantity what) {
    const Box2 box = boundsOf(rectangle);
    switch (what) {
    case Quantity::Left:
        return box.min.x;
    case Quantity::Bottom:
        return box.min.y;
    case Quantity::Width:
        return box.size().x;
    case Quantity::Height:
        return box.size().y;
    case Quantity::Radius:
        return rectangle.as<RectangleForm>().radius;
    default:
        return std::nullopt;
    }
}

/// Returns a number that only shapes of this form have.
std::optional<double> numberOfForm(const Shape &shape, Quantity what) {
    using Number = std::optional<double>;
    const auto extent = [&](std::size_t end) { return Number(distance(shape.nodes[0], shape.nodes[end])); };
    return shape.visit(
        [](const PathForm &) { return Number(); }, [&](const RectangleForm &) { return boxNumber(shape, what); },
        [&](const CircleForm &) { return what == Quantity::Radius ? circleRadius(shape) : Number(); },
        [](const PointForm &) { return Number(); },
        [&](const EllipseForm &) {
            return what == Quantity::Rx ? extent(1) : what == Quantity::Ry ? extent(2) : Number();
        },
        [&](const SlotForm &slot) {
            return what == Quantity::Width ? 2.0 * slot.radius : what == Quantity::Length ? extent(1) : Number();
        });
}

/// Returns a number of the size of a segment; none if it has no such number.
std::optional<double> numberOfSegment(const Shape &shape, const NumberAddress &address) {
    const auto found = shape.segmentSizes.find(address.handle);
    if (found == shape.segmentSizes.end()) {
        return std::nullopt;
    }
    const SegmentSize &size = found->second;
    const bool counted = size.elements > 0;
    return address.quantity == Quantity::SegmentGrowth ? std::optional(size.growth)
           : (address.quantity == Quantity::SegmentElements) != counted
               ? std::nullopt
               : std::optional(counted ? static_cast<double>(size.elements) : size.size);
}

/// Changes one of the four numbers of a rectangle.
void changeBox(Shape &shape, Quantity what, double value) {
    const Box2 box = boundsOf(shape);
    Vec2 low = box.min, size = box.size();
    (what == Quantity::Left     ? low.x
     : what == Quantity::Bottom ? low.y
     : what == Quantity::Width  ? size.x
                                : size.y) = value;
    placeBox(shape, low, low + size);
}

/// Moves a node to a distance from the centre of a circle or an ellipse; in a direction if another formula has made it
/// a point.
void setArm(Shape &shape, std::size_t node, double length, Vec2 along) {
    Vec2 &end = shape.nodes[node];
    const Vec2 arm = end - shape.nodes[0];
    const double now = forefront::length(arm);
    end = shape.nodes[0] + (now > 0.0 ? (length / now) * arm : length * along);
}

/// Sets a number that only shapes of this form have.
void setNumberOfForm(Shape &shape, Quantity what, double value) {
    shape.visit([](const PathForm &) {},
                [&](RectangleForm &rectangle) {
                    what == Quantity::Radius ? void(rectangle.radius = value) : changeBox(shape, what, value);
                },
                [&](const CircleForm &) {
                    setArm(shape, 1, value, {1.0, 0.0});
                },
                [](const PointForm &) {},
                [&](const EllipseForm &) {
                    what == Quantity::Ry ? setArm(shape, 2, value, {0.0, 1.0}) : setArm(shape, 1, value, {1.0, 0.0});
                },
                [&](SlotForm &slot) {
                    what == Quantity::Width ? void(slot.radius = 0.5 * value) : setSlotLength(shape, value);
                });
    shape.cuts.clear();
}

Status setNumberOfSegment(SegmentSize &size, Quantity what, double value) {
    if (what == Quantity::SegmentGrowth) {
        size.growth = value;
    } else if (what == Quantity::SegmentElements) {
        const Result<std::uint32_t> count = elementsFrom(value);
        if (!count) {
            return count.faults();
        }
        size.elements = *count;
    } else {
        size.size = value;
    }
    return {};
}

} // namespace

Result<std::uint32_t> elementsFrom(double value) {
    const double count = std::round(value);
    if (!(count >= 1.0 && count <= kMaxElementCount) || std::fabs(value - count) > 1e-9 * count) {
        return error("bad-number", "invalid number of elements " + numberText(value, 6) +
                                       "; expected a whole number from 1 to " + std::to_string(kMaxElementCount));
    }
    return static_cast<std::uint32_t>(count);
}

std::optional<double> shapeNumber(const Shape &shape, const NumberAddress &address) {
    const Quantity what = address.quantity;
    if (what == Quantity::X || what == Quantity::Y) {
        const std::vector<Vec2> handles = handlesOf(shape);
        if (address.handle >= handles.size()) {
            return std::nullopt;
        }
        return what == Quantity::X ? handles[address.handle].x : handles[address.handle].y;
    }
    if (what == Quantity::Size || what == Quantity::Growth) {
        const auto part = shape.nodeSizes.find(address.handle);
        const bool size = what == Quantity::Size;
        return part != shape.nodeSizes.end() ? std::optional(size ? part->second.size : part->second.growth)
                                             : std::nullopt;
    }
    if (address.ofSegment()) {
        return numberOfSegment(shape, address);
    }
    if (what == Quantity::ArcRadius) {
        const bool arc = isPath(shape) && address.handle < shape.path().curves.size();
        return arc ? radiusOf(shape.path().curves[address.handle]) : std::nullopt;
    }
    return numberOfForm(shape, what);
}

Status setShapeNumber(Shape &shape, const NumberAddress &address, double value) {
    const Quantity what = address.quantity;
    if (what == Quantity::X || what == Quantity::Y) {
        const Vec2 at = handlesOf(shape)[address.handle];
        placeHandle(shape, address.handle, what == Quantity::X ? Vec2{value, at.y} : Vec2{at.x, value});
        return {};
    }
    if (what == Quantity::Size || what == Quantity::Growth) {
        auto &part = shape.nodeSizes.at(address.handle);
        (what == Quantity::Size ? part.size : part.growth) = value;
        return {};
    }
    if (address.ofSegment()) {
        return setNumberOfSegment(shape.segmentSizes.at(address.handle), what, value);
    }
    const bool corner = what == Quantity::Radius && shape.is<RectangleForm>();
    const bool extent = !corner && what != Quantity::Left && what != Quantity::Bottom;
    if (extent && !(value > 0.0)) {
        return error("bad-number", "invalid " + std::string(wordOf(what)) + " of " + displayName(shape) +
                                       "; expected a number above 0");
    }
    if (what == Quantity::ArcRadius) {
        Curve &arc = shape.path().curves[address.handle];
        arc = withRadius(arc, value);
        shape.cuts.clear();
    } else {
        setNumberOfForm(shape, what, value);
    }
    return {};
}

} // namespace forefront
