#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

/// Moves the shapes of a document so that its constraints hold after a command, nearest to where they were before.
///
/// Only the independent parts of the sketch that the command changed are solved; what held before, or was already
/// violated in a file, keeps its bits. Moved nodes stay where the command put them if the other parts can follow, else
/// they come as near as the constraints allow. Numbers with formulas and locked shapes stay. Error:
/// constraint-conflict names a minimal set of constraints that cannot hold together; the document is then unchanged.
Result<Document> settle(const Document &before, const Document &next);

/// Returns names as "Length 1, Horizontal 2 and Fixed 1", by the order of the document.
std::string constraintNames(const Document &document, const std::set<std::uint32_t> &ids);

} // namespace forefront
