#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/sketch/sketch_system.hpp"

namespace forefront {

/// Returns the size that rounding of the coordinates of a drawing is measured by.
double drawingScale(const Document &document);

/// Returns true if the residual of an equation is at most a tolerance, relative to the scale of the drawing.
bool holdsWithin(const SketchSystem &system, const SketchEquation &equation, double tolerance, double scale);

/// Returns true if a constraint, whose parts fit, holds in a document, up to rounding of the coordinates.
bool holdsIn(const Document &document, const SketchConstraint &constraint);

/// Returns true for a distance between two lines that are not parallel: they have none. The parts of the constraint
/// must fit.
bool isSlantedDistance(const Document &document, const SketchConstraint &constraint);

/// Returns a constraint with other sides and turns if it holds with those only, as where a shape was mirrored or a path
/// reversed. Its parts must fit.
SketchConstraint reoriented(const Document &document, SketchConstraint constraint);

} // namespace forefront
