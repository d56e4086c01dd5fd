#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "nodeSizes" of a shape, if there are any.
void writeNodeSizes(const Shape &shape, JsonText &out);
/// Reads the member "nodeSizes" of a shape, which must have its nodes.
void readNodeSizes(const JsonValue &item, Shape &shape, JsonCheck &check);

/// Writes the member "segmentSizes" of a shape, if there are any.
void writeSegmentSizes(const Shape &shape, JsonText &out);
/// Reads the member "segmentSizes" of a shape, which must have its nodes and its radius.
void readSegmentSizes(const JsonValue &item, Shape &shape, JsonCheck &check);

} // namespace forefront
