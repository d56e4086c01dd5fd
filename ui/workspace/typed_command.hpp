#pragma once

#include "core/drawing/commands/typed_size.hpp"
#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <span>
#include <string>

namespace forefront {

struct Workspace;

/// Applies the result of a command that a user typed numbers for. Refuses it, with the names of the constraints, where
/// these would not let the numbers be as typed. `joins`: joints are carried along, see applyJoined(). Returns true if
/// it was applied.
bool applyTyped(Workspace &context, const Result<Document> &next, const std::string &label, bool joins = true);

/// Does the same where a user typed sizes of shapes, which the constraints may let be as typed in another way: see
/// withTypedSizes(). If they do not, the field offers to change the dimension that holds the size, if there is one.
bool applyTypedSizes(Workspace &context, const Result<Document> &next, std::span<const TypedSize> sizes,
                     const std::string &label, bool joins = true);
/// Does the same for one size.
bool applyTypedSize(Workspace &context, const Result<Document> &next, const TypedSize &size, const std::string &label,
                    bool joins = true);

} // namespace forefront
