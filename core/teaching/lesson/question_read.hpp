#pragma once

#include "core/files/json/json_check.hpp"
#include "core/teaching/lesson/lesson.hpp"

#include <span>
#include <string>
#include <string_view>

namespace forefront {

// Parts of the reader of lessons. Faults are added to `check`.

/// Reports members of an object that are not in the list.
void expectMembers(JsonCheck &check, const JsonValue &object, std::span<const std::string_view> members,
                   std::string_view what);
/// Reads a text that is not empty. With `values`, it may contain lesson values in braces, which are checked.
std::string shownText(JsonCheck &check, const JsonValue &value, std::string_view what, bool values);
/// Reads the number of an advance, "end", or {"advance": n, "events": m}.
LessonPosition readPosition(const JsonValue &value, JsonCheck &check);
/// Reads a question; `object` is an object.
LessonQuestion readQuestion(const JsonValue &object, JsonCheck &check);

} // namespace forefront
