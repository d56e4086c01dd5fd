#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <cmath>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

/// Returns the node of a rectangle that a coordinate of a corner belongs to.
std::uint32_t nodeOfCorner(std::uint32_t corner, bool across) {
    return across ? (corner == 1 || corner == 2 ? 1 : 0) : (corner >= 2 ? 1 : 0);
}

} // namespace

void DocumentSketch::finish(const JointSource &source) {
    JointFinder finder(*this, source);
    std::size_t known = 0;
    do { // formulas may bring in further nodes
        known = system.values.size();
        finder.find();
        holdFormulas();
    } while (known != system.values.size());
    finder.write();
    for (const std::uint32_t id : std::set<std::uint32_t>(shapes_)) {
        addGuards(shapeOf(id));
    }
}

void DocumentSketch::hold(const ShapeUnknown &unknown) {
    if (const std::optional<std::uint32_t> index = find(unknown)) {
        system.held[*index] = true;
        holdsNumbers_ = true;
    }
}

void DocumentSketch::holdFormulas() {
    for (const auto &[address, text] : document_.formulas) {
        if (address.owner.kind == NumberOwner::Kind::Shape && shapes_.contains(address.owner.id)) {
            holdFormula(address);
        }
    }
}

void DocumentSketch::holdFormula(const NumberAddress &address) {
    const Shape &shape = shapeOf(address.owner.id);
    const std::uint32_t id = shape.id;
    const auto length = [&](double value) { // of the difference of the nodes of a rectangle along one axis
        const bool across = address.quantity == Quantity::Width;
        const auto a = find({id, across ? Role::X : Role::Y, 0}), b = find({id, across ? Role::X : Role::Y, 1});
        if (a && b && lengths_.insert(address).second) {
            system.addEquation(makeDifference(*a, *b, std::fabs(value), value < 0.0 ? -1.0 : 1.0), 0);
            holdsNumbers_ = true;
        }
    };
    switch (address.quantity) {
    case Quantity::X:
    case Quantity::Y: {
        const bool across = address.quantity == Quantity::X;
        const std::uint32_t node = shape.is<RectangleForm>() ? nodeOfCorner(address.handle, across) : address.handle;
        hold({id, across ? Role::X : Role::Y, node});
        break;
    }
    case Quantity::Left:
    case Quantity::Bottom: {
        const bool across = address.quantity == Quantity::Left;
        const Vec2 by = shape.nodes[1] - shape.nodes[0];
        hold({id, across ? Role::X : Role::Y, (across ? by.x : by.y) < 0.0 ? 1U : 0U});
        break;
    }
    case Quantity::Radius:
        hold({id, Role::Radius, 0});
        break;
    case Quantity::Width:
        if (shape.is<SlotForm>()) {
            hold({id, Role::Radius, 0});
        } else {
            length(shape.nodes[1].x - shape.nodes[0].x);
        }
        break;
    case Quantity::Height:
        length(shape.nodes[1].y - shape.nodes[0].y);
        break;
    case Quantity::Length: {
        if (!lengths_.insert(address).second) {
            break;
        }
        const SketchPoint a = node(shape, 0), b = node(shape, 1);
        system.addEquation(makeDistance(a, b, distance(shape.nodes[0], shape.nodes[1])), 0);
        holdsNumbers_ = true;
        break;
    }
    case Quantity::Rx:
    case Quantity::Ry: {
        if (!lengths_.insert(address).second) {
            break;
        }
        const std::uint32_t k = address.quantity == Quantity::Rx ? 1 : 2;
        const Axes all = axes(shape);
        if (!zero_) {
            zero_ = system.addOffset({});
            system.held[zero_->x] = system.held[zero_->y] = true;
        }
        system.addEquation(makeDistance(*zero_, k == 1 ? all.u : all.v, distance(shape.nodes[0], shape.nodes[k])), 0);
        holdsNumbers_ = true;
        break;
    }
    case Quantity::ArcRadius:
        arc(shape, address.handle);
        hold({id, Role::Radius, address.handle});
        break;
    default:
        break;
    }
}

void DocumentSketch::addGuards(const Shape &shape) {
    const auto placed = [&](std::uint32_t k) -> std::optional<SketchPoint> {
        const auto x = find({shape.id, Role::X, k}), y = find({shape.id, Role::Y, k});
        return x && y ? std::optional(SketchPoint{*x, *y}) : std::nullopt;
    };
    const auto n = static_cast<std::uint32_t>(shape.nodes.size());
    if (isPath(shape) || shape.is<SlotForm>()) {
        const bool loop = isPath(shape) && isClosed(shape) && n > 2;
        for (std::uint32_t k = 0; k + (loop ? 0 : 1) < n; ++k) {
            const auto a = placed(k), b = placed((k + 1) % n);
            if (a && b) {
                system.edges.emplace_back(*a, *b);
                const auto c = loop || k + 2 < n ? placed((k + 2) % n) : std::nullopt;
                if (c) {
                    system.corners.push_back({*a, *b, *c});
                }
            }
        }
    }
    for (const auto &[unknown, index] : indices_) {
        if (unknown.shape == shape.id && unknown.role == Role::Radius) {
            const auto x = find({shape.id, Role::CentreX, unknown.index});
            const auto y = find({shape.id, Role::CentreY, unknown.index});
            if (x && y) {
                system.circles.emplace_back(SketchPoint{*x, *y}, index);
            } else if (const auto centre = placed(0); centre && !isPath(shape)) {
                system.circles.emplace_back(*centre, index);
            }
        }
    }
}

} // namespace forefront
