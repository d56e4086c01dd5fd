#pragma once

#include "core/drawing/document/document.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Returns the commands, as lines of a script, that may lead from one document to the next: first those that say what a
/// user may have done, last those that write down the difference. Which of them do is found by playing them.
std::vector<std::string> linesBetween(const Document &before, const Document &after);

/// Returns the line that begins with a document.
std::string newLine(const Document &document);

} // namespace forefront
