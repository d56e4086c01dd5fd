#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the members "curves" and "cuts" of a shape of a project, if it has any.
void writeCurves(const Shape &shape, JsonText &out);
/// Reads these members into a shape that has its kind and nodes. A curve is null for a straight segment, or
/// {"cubic": [[x, y], [x, y]]} with its two control points, or {"arc": {"centre": [x, y], "u": [x, y], "v": [x, y],
/// "start": θ, "sweep": θ}} as in Curve::arc(); it must run from node to node. Faults are added to `check`.
void readCurves(const JsonValue &item, Shape &shape, JsonCheck &check);

} // namespace forefront
