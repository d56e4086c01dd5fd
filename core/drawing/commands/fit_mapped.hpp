#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>

namespace forefront {

/// Checks that shapes that a command has turned, mirrored or scaled can have the form that it gave them, where
/// constraints bind them to others, which have to follow. Returns the document with all shapes where they settle, so
/// that completing the command has nothing left to solve; these shapes may be moved as a whole to where a constraint
/// has a node of theirs. Error: constraint-conflict names what holds them; without this check, the solver would turn
/// them back and take others far away.
Result<Document> fitMapped(const Document &before, Document mapped, const std::set<std::uint32_t> &shapes);

} // namespace forefront
