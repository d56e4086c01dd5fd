#pragma once

#include "core/files/json/json_check.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/lesson/random_numbers.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

// Parts of the reader of lessons. Faults are added to `check`.

/// Reports members of an object that are not in the list.
void expectMembers(JsonCheck &check, const JsonValue &object, std::span<const std::string_view> members,
                   std::string_view what);
/// Reads a text that is not empty. With `numbers`, it may contain random numbers, which are replaced, and lesson values
/// in braces, which are checked.
std::string shownText(JsonCheck &check, const JsonValue &value, std::string_view what, const RandomNumbers *numbers);
/// Reads the number of an advance or the name of a random number, "end", or {"advance": n, "events": m}.
LessonPosition readPosition(const JsonValue &value, JsonCheck &check, const RandomNumbers &numbers);
/// Reads a question; `object` is an object.
LessonQuestion readQuestion(const JsonValue &object, JsonCheck &check, const RandomNumbers &numbers);
/// Reads {"name": [from, to], ...} and adds a number for each name, those of page `page` with this seed. Returns the
/// ranges.
std::vector<RandomRange> readNumbers(const JsonValue &object, JsonCheck &check, std::uint64_t seed, std::size_t page,
                                     RandomNumbers &numbers);

} // namespace forefront
