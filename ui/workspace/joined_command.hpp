#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <string>

namespace forefront {

struct Workspace;

/// Applies the result of a command on the current document, with the document's joints carried along: see
/// carryJoints() and Workspace::applyCommand(). Returns true if it was applied.
bool applyJoined(Workspace &context, const Result<Document> &next, const std::string &label,
                 const std::string &merge = {});

} // namespace forefront
