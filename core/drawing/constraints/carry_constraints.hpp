#pragma once

#include "core/drawing/document/document.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Carries the constraints of a document through a command that has changed its shapes.
///
/// References follow nodes and segments whose indices have changed, also into new shapes, where a path was divided. The
/// parts of a divided segment stay in line, or on one circle. A rectangle, circle or slot that became a path keeps its
/// form by constraints if it had any. A length to a corner that was cut off is measured to the side across it. Sides
/// and turns follow shapes that were reversed. Constraints whose parts no longer exist are removed: see
/// lostConstraints(). To be applied once to a command: indices are carried from `before`.
void carryConstraints(const Document &before, Document &next);

/// Returns the names of the constraints of `before` that `after` does not have.
std::vector<std::string> lostConstraints(const Document &before, const Document &after);

} // namespace forefront
