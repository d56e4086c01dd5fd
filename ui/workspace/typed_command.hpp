#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <string>

namespace forefront {

struct Workspace;

/// Applies the result of a command that a user typed numbers for. Refuses it, with the names of the constraints, where
/// these would not let the numbers be as typed. `joins`: joints are carried along, see applyJoined(). Returns true if
/// it was applied.
bool applyTyped(Workspace &context, const Result<Document> &next, const std::string &label, bool joins = true);

} // namespace forefront
