#include "core/drawing/constraints/fit_roundings.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace forefront {

namespace {

constexpr double kRadiusRounding = 1e-9; ///< of a radius, relative

bool isTooRound(const Shape &shape) {
    return shape.is<RectangleForm>() && shape.as<RectangleForm>().radius > (1.0 + kRadiusRounding) * largestRounding(shape);
}

/// Returns true if a formula or a constraint sets the radius of the corners of a rectangle.
bool isRadiusHeld(const Document &document, std::uint32_t rectangle) {
    constexpr std::uint32_t kSides = 4; // the arcs come after them
    return document.formulas.contains({NumberOwner::ofShape(rectangle), Quantity::Radius}) ||
           std::any_of(document.constraints.begin(), document.constraints.end(), [rectangle](const auto &constraint) {
               return std::any_of(constraint->parts.begin(), constraint->parts.end(), [&](const SketchPart &part) {
                   return part.kind == SketchPartKind::Segment && part.shape == rectangle && part.index >= kSides;
               });
           });
}

} // namespace

Result<Document> fitRoundings(const Document &before, Document next) {
    for (std::shared_ptr<const Shape> &shape : next.shapes) {
        if (!isTooRound(*shape)) {
            continue;
        }
        const Shape *const old = findShape(before, shape->id);
        if (old != nullptr && (old == shape.get() || *old == *shape)) {
            continue;
        }
        const double radius = shape->as<RectangleForm>().radius, largest = largestRounding(*shape);
        const bool given = old != nullptr && !(old->is<RectangleForm>() && old->as<RectangleForm>().radius == radius);
        if (given || isRadiusHeld(next, shape->id)) {
            return error("bad-radius",
                         "the corners of " + displayName(*shape) + " cannot have the radius " + numberText(radius, 6) +
                             ": half of its shorter side is " + numberText(largest, 6),
                         "make the rectangle larger, or the radius smaller");
        }
        Shape fitted = *shape;
        std::get<RectangleForm>(fitted.form).radius = largest;
        fitted.cuts.clear();
        shape = std::make_shared<const Shape>(std::move(fitted));
    }
    return next;
}

} // namespace forefront
