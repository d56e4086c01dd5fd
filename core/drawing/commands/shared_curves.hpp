#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

class JointIndex;

/// Gives Bézier segments that lay on ones whose control points a command has moved the same form, where their ends have
/// stayed. `index`: of the document before the command. Error: joined-locked if a locked shape would have to change.
Result<Document> bendSharedCurves(const JointIndex &index, Document after);

} // namespace forefront
