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

/// Repairs the drawing of a document: see repair(). Shapes that it does not change stay as they are; the others are
/// replaced by paths, circles, ellipses and points with new ids, and the names of the shapes and the element sizes of
/// the nodes that they come from.
Result<RepairedDrawing> repairDrawing(const Document &document, double tolerance = 0.0);

} // namespace forefront
