#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Returns true if a constraint, whose parts fit, holds in a document, up to rounding of the coordinates.
bool holdsIn(const Document &document, const SketchConstraint &constraint);

/// Returns a constraint with other sides and turns if it holds with those only, as where a shape was mirrored or a path
/// reversed. Its parts must fit.
SketchConstraint reoriented(const Document &document, SketchConstraint constraint);

} // namespace forefront
