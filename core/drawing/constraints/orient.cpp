#include "core/drawing/constraints/orient.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace forefront {

double drawingScale(const Document &document) {
    constexpr double kFar = 1e-6; // coordinates far from the origin are rounded
    const Box2 box = boundsOf(document);
    return box.empty() ? 0.0 : box.diagonal() + kFar * std::max(length(box.min), length(box.max));
}

bool holdsWithin(const SketchSystem &system, const SketchEquation &equation, double tolerance, double scale) {
    const bool unitless = equation.kind == EquationKind::Angle || equation.kind == EquationKind::OnEllipse;
    constexpr double kAngles = 10.0; // lines are shorter than the drawing
    return std::fabs(system.residual(equation)) <= tolerance * (unitless ? kAngles : scale);
}

bool holdsIn(const Document &document, const SketchConstraint &constraint) {
    constexpr double kTolerance = 2e-9; // the solver's is half of that
    DocumentSketch sketch(document);
    addEquations(sketch, constraint, document);
    const double scale = drawingScale(document);
    return std::all_of(sketch.system.equations.begin(), sketch.system.equations.end(), [&](const auto &equation) {
        return equation.constraint == 0 || holdsWithin(sketch.system, equation, kTolerance, scale);
    });
}

bool isSlantedDistance(const Document &document, const SketchConstraint &constraint) {
    const std::vector<SketchPart> &parts = constraint.parts;
    if (constraint.kind != ConstraintKind::Distance || formOfPart(document, parts[0]) != PartForm::Line) {
        return false;
    }
    constexpr double kParallel = 1e-6; // sine of the angle; sides of a solved sketch differ by less
    DocumentSketch sketch(document);
    const auto way = [&](const SketchPart &part) {
        const DocumentSketch::Ends ends = sketch.direction(part);
        return sketch.system.place(ends.b) - sketch.system.place(ends.a);
    };
    const Vec2 first = way(parts[0]), second = way(parts[1]);
    return std::fabs(cross(first, second)) > kParallel * length(first) * length(second);
}

SketchConstraint reoriented(const Document &document, SketchConstraint constraint) {
    if (holdsIn(document, constraint)) {
        return constraint;
    }
    DocumentSketch sketch(document);
    SketchConstraint turned = oriented(sketch, constraint);
    return turned != constraint && holdsIn(document, turned) ? turned : constraint;
}

} // namespace forefront
