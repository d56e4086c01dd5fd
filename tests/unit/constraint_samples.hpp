#pragma once

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// Drawings with constraints for tests.
namespace forefront::constraint_test {

SketchPart node(std::uint32_t shape, std::uint32_t k);
SketchPart segment(std::uint32_t shape, std::uint32_t k = 0);

/// Returns the message of a refusal; empty if there is none.
std::string messageOf(const Result<Document> &result);

/// Adds a constraint, which must be possible.
void constrain(Document &document, ConstraintKind kind, std::vector<SketchPart> parts);

void checkAllHold(const Document &document);

/// A path that is a rectangle with its sides free: width and height driven, one corner fixed.
Document drivenPlate();
inline constexpr std::uint32_t kWidth = 7, kHeight = 8; ///< ids of its lengths

/// Shapes of all kinds, numbered: 1 polygon with curves, 2 polyline, 3 rectangle, 4 circle, 5 point, 6 ellipse, 7 slot,
/// 8 circle, 9 rectangle with rounded corners.
Document everyShape();

/// Returns all parts of a document that can be constrained.
std::vector<SketchPart> partsOf(const Document &document);

} // namespace forefront::constraint_test
