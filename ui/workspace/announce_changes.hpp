#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

struct Workspace;

/// Names the expressions and constraints that the document has lost since `before`. Expressions that were just typed
/// over are left out.
void announceLosses(Workspace &context, const Document &before);

/// Names the dimensions of the sketch that have other values than in `before`, with these.
void announceChangedDimensions(Workspace &context, const Document &before);

} // namespace forefront
