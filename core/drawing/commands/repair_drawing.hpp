#pragma once

#include "core/drawing/arrangement/change.hpp"
#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <vector>

namespace forefront {

/// A repaired drawing.
struct RepairedDrawing {
    Document document;
    std::vector<ArrangementChange> changes; ///< one entry per kind; empty: nothing to repair
    Diagnostics left;                       ///< faults that cannot be repaired
    Diagnostics lostSizes;                  ///< warnings about element sizes of nodes that are gone
};

/// Repairs the drawing of a document: see repair(). Unaffected shapes do not change; the others are replaced by paths,
/// circles, ellipses and points with new ids, which inherit the names of the original shapes and the element sizes of
/// their nodes.
Result<RepairedDrawing> repairDrawing(const Document &document, double tolerance = 0.0);

} // namespace forefront
