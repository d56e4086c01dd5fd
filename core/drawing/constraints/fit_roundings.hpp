#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// Lets the radius of rounded corners follow a rectangle that a command has made too small for it, so that the number
/// is the one that is drawn. Error: bad-radius, if the command has set the radius itself, or a formula or a constraint
/// holds it. Rectangles that the command has not changed stay as they are.
Result<Document> fitRoundings(const Document &before, Document next);

} // namespace forefront
