#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// Completes a command on a document: its constraints and formulas follow changed shapes, numbers that were edited
/// directly lose their formulas, and the constraints move what they must. Errors: constraint-conflict, see settle();
/// bad-radius, see fitRoundings(). For constraints that could not follow, see lostConstraints().
Result<Document> settleCommand(const Document &before, Document next);

/// Completes a command as settleCommand() does, after the sizes of segments have stayed at their places and divided
/// segments have shared their number of elements.
Result<Document> completeCommand(const Document &before, Document next);

} // namespace forefront
