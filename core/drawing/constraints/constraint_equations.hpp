#pragma once

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/document/document.hpp"

namespace forefront {

/// Adds the equations of a constraint to a sketch. Its parts must fit: see partsFault(). Fixed parts are fixed where
/// they are in `start`, as far as they exist there.
void addEquations(DocumentSketch &sketch, const SketchConstraint &constraint, const Document &start);

/// Returns a constraint with the sides and turns that its parts have in the document of a sketch.
SketchConstraint oriented(DocumentSketch &sketch, SketchConstraint constraint);

/// Returns the value that a dimension has in the document of a sketch: a length, or an angle in degrees between 0 and
/// 180. The dimension must be oriented.
double measured(DocumentSketch &sketch, const SketchConstraint &constraint);

/// Returns the sketch of all constraints of a document whose parts fit, with joints.
DocumentSketch sketchOf(const Document &document, const Document &start, const JointSource &joints);

} // namespace forefront
