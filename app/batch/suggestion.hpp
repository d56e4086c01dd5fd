#pragma once

#include <span>
#include <string>
#include <string_view>

namespace forefront {

/// Returns the candidate that a mistyped word probably means: the one that fewest insertions, deletions, replacements
/// and swaps of neighbours turn it into, at most one for every three letters; the first of several. Empty if there is
/// none.
std::string_view nearestWord(std::string_view word, std::span<const std::string_view> candidates);

/// Returns "; did you mean WORD?" for the nearest word; empty if there is none.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

} // namespace forefront
